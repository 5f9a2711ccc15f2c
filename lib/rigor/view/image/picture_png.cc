// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>

#include <rigor/view/image/picture.h>

namespace rigor::view {
namespace {

/// Between size and speed: the next level takes twice the time for a twentieth
/// of the bytes.
constexpr int kPngCompression = 4;

/// What the calls of libpng share. Plain data, since an error leaves them by a
/// jump.
struct PngWriting {
  const Picture* picture;
  std::string* bytes;
  std::uint8_t* row;
  int channels;
};

void append_png(png_structp png, png_bytep bytes, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), count);
}

/// Whether it went well. No object with a destructor lives here: libpng may
/// jump out of any call.
bool write_png(png_structp png, png_infop info, const PngWriting& writing) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  const Picture& picture = *writing.picture;
  png_set_write_fn(png, writing.bytes, append_png, nullptr);
  png_set_IHDR(png, info, picture.width, picture.height, 8,
               writing.channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_compression_level(png, kPngCompression);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB | PNG_FILTER_UP);
  png_write_info(png, info);
  const std::size_t channels = static_cast<std::size_t>(writing.channels);
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      std::memcpy(writing.row + channels * x, picture.at(x, y).data(), channels);
    }
    png_write_row(png, writing.row);
  }
  png_write_end(png, nullptr);
  return true;
}

}  // namespace

std::string to_png(const Picture& picture) {
  const bool whole = picture.pixels.size() == std::size_t{picture.width} * picture.height;
  if (picture.pixels.empty() || !whole) return {};
  const bool opaque = std::all_of(picture.pixels.begin(), picture.pixels.end(),
                                  [](const Pixel& pixel) { return pixel[3] == 255; });
  std::string bytes;
  std::vector<std::uint8_t> row(std::size_t{picture.width} * 4);
  // The library's own handlers print.
  const auto give_up = [](png_structp png, png_const_charp) { png_longjmp(png, 1); };
  const auto silent = [](png_structp, png_const_charp) {};
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, give_up, silent);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool written = info && write_png(png, info, {&picture, &bytes, row.data(), opaque ? 3 : 4});
  png_destroy_write_struct(&png, &info);
  return written ? bytes : std::string();
}

}  // namespace rigor::view
