// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/image/height_picture.h>

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>

namespace rigor::mesh {
namespace {

/// What the calls of libpng share. Plain data and pointers, since an error leaves them by a jump.
struct PngReading {
  const char* next;
  std::size_t left;
  png_structp png;
  png_infop info;
  HeightPicture* picture;
  std::vector<png_byte>* bytes;
};

void take_bytes(png_structp png, png_bytep out, png_size_t count) {
  auto& reading = *static_cast<PngReading*>(png_get_io_ptr(png));
  if (count > reading.left) png_error(png, "the file ends too early");
  std::memcpy(out, reading.next, count);
  reading.next += count;
  reading.left -= count;
}

[[noreturn]] void leave_png(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void ignore_png(png_structp, png_const_charp) {}  // a chunk that does not matter

/// Whether it went well. No object with a destructor lives here: libpng may jump out of any call.
bool read_png(PngReading& reading) {
  png_structp png = reading.png;
  png_infop info = reading.info;
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_read_fn(png, &reading, take_bytes);
  png_set_user_limits(png, kMaxHeightPicture, kMaxHeightPicture);
  png_read_info(png, info);
  png_set_expand(png);  // palettes, and less than eight bits
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  HeightPicture& picture = *reading.picture;
  picture.width = png_get_image_width(png, info);
  picture.height = png_get_image_height(png, info);
  const std::size_t row = png_get_rowbytes(png, info);
  reading.bytes->resize(row * picture.height);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t y = 0; y < picture.height; ++y) {
      png_read_row(png, reading.bytes->data() + y * row, nullptr);
    }
  }
  png_read_end(png, nullptr);
  return true;
}

/// The first channel of each pixel; of 16 bits the most significant byte comes first.
void take_levels(const PngReading& reading) {
  HeightPicture& picture = *reading.picture;
  const bool wide = png_get_bit_depth(reading.png, reading.info) == 16;
  const std::size_t pixels = std::size_t{picture.width} * picture.height;
  const std::size_t stride = reading.bytes->size() / pixels;
  picture.levels.reserve(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const png_byte* pixel = reading.bytes->data() + i * stride;
    picture.levels.push_back(wide ? (256.0 * pixel[0] + pixel[1]) / 65535 : pixel[0] / 255.0);
  }
}

}  // namespace

std::optional<HeightPicture> read_height_picture(std::string_view bytes) {
  HeightPicture picture;
  std::vector<png_byte> rows;
  PngReading reading{bytes.data(), bytes.size(), nullptr, nullptr, &picture, &rows};
  reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leave_png, ignore_png);
  if (reading.png == nullptr) return std::nullopt;
  reading.info = png_create_info_struct(reading.png);
  const bool whole = reading.info != nullptr && read_png(reading);
  if (whole) take_levels(reading);
  png_destroy_read_struct(&reading.png, &reading.info, nullptr);
  if (!whole) return std::nullopt;
  return picture;
}

}  // namespace rigor::mesh
