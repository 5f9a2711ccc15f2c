// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/image/compose.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <rigor/view/image/font.h>

namespace rigor::view {
namespace {

constexpr std::uint32_t kGap = 8;
/// Pixels to a unit of letters: capitals are 12 pixels high.
constexpr double kLetterScale = 1.2;
constexpr std::uint32_t kCaptionHeight = 22;
constexpr double kCaptionBaseline = 16;
constexpr Pixel kPaper{255, 255, 255, 255};
constexpr Pixel kInk{60, 60, 64, 255};
constexpr Pixel kOtherShape{224, 24, 24, 255};
constexpr Pixel kOtherColor{70, 120, 235, 255};
/// Of 255: what the eye does not see does not differ.
constexpr int kSameColor = 4;

void paste(const Picture& from, Picture& into, std::uint32_t left, std::uint32_t top) {
  for (std::uint32_t y = 0; y < from.height; ++y) {
    for (std::uint32_t x = 0; x < from.width; ++x) into.at(left + x, top + y) = from.at(x, y);
  }
}

/// From the middle of a pixel to a stroke, in units of letters.
double distance_to(const LetterSegment& s, double x, double y) {
  const double dx = s.x1 - s.x0;
  const double dy = s.y1 - s.y0;
  const double square = dx * dx + dy * dy;
  const double along =
      square > 0 ? std::clamp(((x - s.x0) * dx + (y - s.y0) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(x - s.x0 - along * dx, y - s.y0 - along * dy);
}

/// `left` (pixels) is where the letter begins. A pixel is as dark as the pen covers it.
void put_letter(const Letter& letter, Picture& into, double left, std::uint32_t top) {
  const auto first = static_cast<std::uint32_t>(std::max(0.0, std::floor(left) - 1));
  const double end = left + letter.advance * kLetterScale;
  for (std::uint32_t y = top; y < std::min(top + kCaptionHeight, into.height); ++y) {
    for (std::uint32_t x = first; x < into.width && x < end; ++x) {
      double distance = HUGE_VAL;
      for (const LetterSegment& segment : letter.segments) {
        distance =
            std::min(distance, distance_to(segment, (x + 0.5 - left) / kLetterScale,
                                           (kCaptionBaseline + top - y - 0.5) / kLetterScale));
      }
      const double covered = 0.5 + (kPenWidth / 2 - distance) * kLetterScale;
      if (covered <= 0) continue;
      const double share = std::min(covered, 1.0);
      Pixel& pixel = into.at(x, y);
      for (std::size_t i = 0; i < 3; ++i) {
        pixel[i] = static_cast<std::uint8_t>(std::lround(pixel[i] + share * (kInk[i] - pixel[i])));
      }
    }
  }
}

/// In the middle of `width`; of one that is too long, its end, which tells
/// files of a folder apart.
void put_caption(std::string text, Picture& into, std::uint32_t left, std::uint32_t top,
                 std::uint32_t width) {
  // A letter of several bytes is one '?'.
  std::erase_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; });
  const double room = width / kLetterScale;
  std::string shown = text;
  while (!text.empty() && text_width(shown) > room) {
    text.erase(0, 1);
    shown = ".." + text;
  }
  if (text.empty()) return;
  double x = left + (width - text_width(shown) * kLetterScale) / 2;
  for (const char c : shown) {
    const Letter drawn = letter(c);
    put_letter(drawn, into, x, top);
    x += drawn.advance * kLetterScale;
  }
}

bool differs(const Pixel& a, const Pixel& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(int{a[i]} - int{b[i]}) > kSameColor) return true;
  }
  return false;
}

/// Gray, and mostly white.
Pixel paled(const Pixel& pixel) {
  const int gray = (3 * pixel[0] + 6 * pixel[1] + pixel[2]) / 10;
  const auto pale = static_cast<std::uint8_t>(255 - (255 - gray) / 4);
  return {pale, pale, pale, pixel[3]};
}

const Pixel* pixel_at(const Picture& picture, std::uint32_t x, std::uint32_t y) {
  return x < picture.width && y < picture.height ? &picture.at(x, y) : nullptr;
}

bool pixel_differs(const Picture& before, const Picture& after, std::uint32_t x, std::uint32_t y) {
  const Pixel* old = pixel_at(before, x, y);
  const Pixel* now = pixel_at(after, x, y);
  return !old || !now || differs(*old, *now);
}

}  // namespace

Picture sheet(const std::vector<Tile>& tiles, std::size_t columns) {
  columns = std::clamp<std::size_t>(columns, 1, std::max<std::size_t>(tiles.size(), 1));
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  for (const Tile& tile : tiles) {
    width = std::max(width, tile.picture.width);
    height = std::max(height, tile.picture.height);
  }
  const bool captions = std::any_of(tiles.begin(), tiles.end(),
                                    [](const Tile& tile) { return !tile.caption.empty(); });
  const std::size_t rows = (tiles.size() + columns - 1) / columns;
  const std::uint64_t row_height = std::uint64_t{height} + (captions ? kCaptionHeight : 0);
  const std::uint64_t whole_width = columns * (std::uint64_t{width} + kGap) - kGap;
  const std::uint64_t whole_height = rows * (row_height + kGap) - (rows > 0 ? kGap : 0);
  if (whole_height == 0 || whole_width > kMaxPixels / whole_height) return {};

  Picture whole{
      static_cast<std::uint32_t>(whole_width), static_cast<std::uint32_t>(whole_height), {}};
  whole.pixels.assign(whole_width * whole_height, kPaper);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const auto left = static_cast<std::uint32_t>(i % columns * (std::uint64_t{width} + kGap));
    const auto top = static_cast<std::uint32_t>(i / columns * (row_height + kGap));
    const Picture& picture = tiles[i].picture;
    paste(picture, whole, left + (width - picture.width) / 2, top);
    if (captions) put_caption(tiles[i].caption, whole, left, top + height, width);
  }
  return whole;
}

std::size_t columns_for(std::size_t count, std::uint32_t width, std::uint32_t height) {
  if (count == 0 || width == 0) return 1;
  const double ideal = std::sqrt(static_cast<double>(count) * height / width);
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(ideal)), 1, count);
}

Picture difference(const Compared& pictures) {
  const Picture& before = pictures.before;
  const Picture& after = pictures.after;
  Picture result{std::max(before.width, after.width), std::max(before.height, after.height), {}};
  result.pixels.resize(std::size_t{result.width} * result.height);
  for (std::uint32_t y = 0; y < result.height; ++y) {
    for (std::uint32_t x = 0; x < result.width; ++x) {
      const Pixel* now = pixel_at(after, x, y);
      if (pixel_differs(pictures.gray_before, pictures.gray_after, x, y)) {
        result.at(x, y) = kOtherShape;
      } else {
        result.at(x, y) = pixel_differs(before, after, x, y) ? kOtherColor : paled(*now);
      }
    }
  }
  return result;
}

std::size_t count_differences(const Picture& before, const Picture& after) {
  std::size_t count = 0;
  for (std::uint32_t y = 0; y < std::max(before.height, after.height); ++y) {
    for (std::uint32_t x = 0; x < std::max(before.width, after.width); ++x) {
      count += pixel_differs(before, after, x, y) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace rigor::view
