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
/// Points of a letter are so many pixels.
constexpr std::uint32_t kPoint = 2;
constexpr std::uint32_t kLetterWidth = (kGlyphWidth + 1) * kPoint;
constexpr std::uint32_t kCaptionHeight = (kGlyphHeight + 4) * kPoint;
constexpr Pixel kPaper{255, 255, 255, 255};
constexpr Pixel kInk{60, 60, 64, 255};
constexpr Pixel kDiffering{224, 24, 24, 255};
/// Of 255: what the eye does not see does not differ.
constexpr int kSameColour = 4;

void paste(const Picture& from, Picture& into, std::uint32_t left, std::uint32_t top) {
  for (std::uint32_t y = 0; y < from.height; ++y) {
    for (std::uint32_t x = 0; x < from.width; ++x) into.at(left + x, top + y) = from.at(x, y);
  }
}

void put_letter(char letter, Picture& into, std::uint32_t left, std::uint32_t top) {
  const auto columns = glyph(letter);
  for (std::uint32_t y = 0; y < kGlyphHeight * kPoint; ++y) {
    for (std::uint32_t x = 0; x < kGlyphWidth * kPoint; ++x) {
      if ((columns[x / kPoint] >> (y / kPoint) & 1U) != 0) into.at(left + x, top + y) = kInk;
    }
  }
}

/// In the middle of `width`; of one that is too long, its end, which tells
/// files of a folder apart.
void put_caption(std::string text, Picture& into, std::uint32_t left, std::uint32_t top,
                 std::uint32_t width) {
  // A letter of several bytes is one '?'.
  std::erase_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; });
  const std::size_t room = width / kLetterWidth;
  if (text.size() > room) text = text.substr(text.size() - room);
  if (room > 4 && text.size() == room) text.replace(0, 2, "..");
  const auto taken = static_cast<std::uint32_t>(text.size()) * kLetterWidth;
  std::uint32_t x = left + (width - taken) / 2;
  for (const char letter : text) {
    put_letter(letter, into, x, top);
    x += kLetterWidth;
  }
}

bool differs(const Pixel& a, const Pixel& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(int{a[i]} - int{b[i]}) > kSameColour) return true;
  }
  return false;
}

/// Grey, and mostly white.
Pixel paled(const Pixel& pixel) {
  const int grey = (3 * pixel[0] + 6 * pixel[1] + pixel[2]) / 10;
  const auto pale = static_cast<std::uint8_t>(255 - (255 - grey) / 4);
  return {pale, pale, pale, pixel[3]};
}

const Pixel* pixel_at(const Picture& picture, std::uint32_t x, std::uint32_t y) {
  return x < picture.width && y < picture.height ? &picture.at(x, y) : nullptr;
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
    if (captions) put_caption(tiles[i].caption, whole, left, top + height + 2 * kPoint, width);
  }
  return whole;
}

std::size_t columns_for(std::size_t count, std::uint32_t width, std::uint32_t height) {
  if (count == 0 || width == 0) return 1;
  const double ideal = std::sqrt(static_cast<double>(count) * height / width);
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(ideal)), 1, count);
}

Picture difference(const Picture& before, const Picture& after) {
  Picture result{std::max(before.width, after.width), std::max(before.height, after.height), {}};
  result.pixels.resize(std::size_t{result.width} * result.height);
  for (std::uint32_t y = 0; y < result.height; ++y) {
    for (std::uint32_t x = 0; x < result.width; ++x) {
      const Pixel* old = pixel_at(before, x, y);
      const Pixel* now = pixel_at(after, x, y);
      const bool same = old && now && !differs(*old, *now);
      result.at(x, y) = same ? paled(*now) : kDiffering;
    }
  }
  return result;
}

std::size_t count_differences(const Picture& before, const Picture& after) {
  std::size_t count = 0;
  for (std::uint32_t y = 0; y < std::max(before.height, after.height); ++y) {
    for (std::uint32_t x = 0; x < std::max(before.width, after.width); ++x) {
      const Pixel* old = pixel_at(before, x, y);
      const Pixel* now = pixel_at(after, x, y);
      count += !old || !now || differs(*old, *now) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace rigor::view
