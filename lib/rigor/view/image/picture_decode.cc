// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <png.h>
#include <turbojpeg.h>

#include <algorithm>
#include <memory>

#include <rigor/view/image/picture.h>

namespace rigor::view {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kPngMagic = "\x89PNG\r\n\x1a\n"sv;
constexpr std::string_view kJpegMagic = "\xff\xd8\xff"sv;

/// Deflate makes at most 1032 bytes of one, and the plainest JPEG some 400
/// pixels: fewer bytes than this are a claim that would only take memory.
constexpr std::uint64_t kMaxOfOneByte = 1032;

/// A progressive JPEG goes over all its pixels in each scan, which may be a few
/// bytes: real ones have ten.
constexpr std::uint64_t kMaxScannedPixels = std::uint64_t{1} << 30U;

/// The picture without its pixels; nothing when it would be too large.
std::optional<Picture> blank_picture(std::uint64_t width, std::uint64_t height) {
  if (width == 0 || height == 0 || width > kMaxPixels || height > kMaxPixels / width) {
    return std::nullopt;
  }
  return Picture{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}};
}

std::uint64_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (const char byte : bytes.substr(at, 4)) value = value << 8U | static_cast<std::uint8_t>(byte);
  return value;
}

/// Whether the file is long enough for what its header claims.
bool png_may_hold(std::string_view bytes, const Picture& picture) {
  constexpr std::size_t kDepthAt = 24;  // after magic, length, "IHDR", width and height
  const std::uint64_t depth = static_cast<std::uint8_t>(bytes[kDepthAt]);
  const std::uint64_t bits = picture.width * std::max<std::uint64_t>(depth, 1);
  return picture.height * (1 + bits / 8) <= kMaxOfOneByte * bytes.size();
}

std::optional<Picture> decode_png(std::string_view bytes) {
  constexpr std::size_t kWidthAt = 16;
  constexpr std::size_t kHeightAt = 20;
  constexpr std::size_t kAfterHeader = 33;
  if (bytes.size() < kAfterHeader) return std::nullopt;
  std::optional<Picture> picture =
      blank_picture(big_endian(bytes, kWidthAt), big_endian(bytes, kHeightAt));
  if (!picture || !png_may_hold(bytes, *picture)) return std::nullopt;

  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) {
    return std::nullopt;
  }
  image.format = PNG_FORMAT_RGBA;
  if (image.width != picture->width || image.height != picture->height) {
    png_image_free(&image);
    return std::nullopt;
  }
  picture->pixels.resize(std::size_t{picture->width} * picture->height);
  constexpr png_int_32 kTightRows = 0;
  // Frees what `image` holds, whatever happens. A warning is a chunk that does
  // not matter.
  if (png_image_finish_read(&image, nullptr, picture->pixels.data(), kTightRows, nullptr) == 0) {
    return std::nullopt;
  }
  return picture;
}

std::uint64_t jpeg_scans(std::string_view bytes) {
  std::uint64_t scans = 0;
  // Within a scan 0xff is always followed by 0 or by the number of a restart.
  for (std::size_t at = bytes.find("\xff\xda"sv); at != std::string_view::npos;
       at = bytes.find("\xff\xda"sv, at + 2)) {
    ++scans;
  }
  return scans;
}

std::optional<Picture> decode_jpeg(std::string_view bytes) {
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto destroy = [](void* decoder) { tjDestroy(decoder); };
  const std::unique_ptr<void, decltype(destroy)> decoder(tjInitDecompress(), destroy);
  if (!decoder) return std::nullopt;
  int width = 0;
  int height = 0;
  int subsampling = 0;
  int colors = 0;
  if (tjDecompressHeader3(decoder.get(), data, bytes.size(), &width, &height, &subsampling,
                          &colors) != 0 ||
      width <= 0 || height <= 0 || colors == TJCS_CMYK || colors == TJCS_YCCK) {
    return std::nullopt;
  }
  std::optional<Picture> picture =
      blank_picture(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height));
  if (!picture) return std::nullopt;
  const std::uint64_t pixels = std::uint64_t{picture->width} * picture->height;
  if (pixels > kMaxOfOneByte * bytes.size() || pixels * jpeg_scans(bytes) > kMaxScannedPixels) {
    return std::nullopt;
  }
  picture->pixels.resize(pixels);
  if (tjDecompress2(decoder.get(), data, bytes.size(),
                    reinterpret_cast<unsigned char*>(picture->pixels.data()), width, 0, height,
                    TJPF_RGBA, TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING) != 0) {
    return std::nullopt;
  }
  return picture;
}

}  // namespace

std::optional<Picture> decode(std::string_view bytes) {
  if (bytes.starts_with(kPngMagic)) return decode_png(bytes);
  if (bytes.starts_with(kJpegMagic)) return decode_jpeg(bytes);
  return std::nullopt;
}

}  // namespace rigor::view
