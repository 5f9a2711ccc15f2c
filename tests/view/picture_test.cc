// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures as bytes, held against libpng's and libjpeg-turbo's own readers and
// writers.

#include <png.h>
#include <turbojpeg.h>

#include <cstdint>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <rigor/view/image/picture.h>

namespace rigor::view {
namespace {

Picture speckled(std::uint32_t width, std::uint32_t height, bool opaque) {
  std::mt19937 random(7);
  Picture picture{width, height, {}};
  for (std::size_t i = 0; i < std::size_t{width} * height; ++i) {
    const auto value = random();
    const auto byte = [value](unsigned shift) { return static_cast<std::uint8_t>(value >> shift); };
    picture.pixels.push_back({byte(0), byte(8), byte(16), opaque ? std::uint8_t{255} : byte(24)});
  }
  return picture;
}

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = word << 8U | static_cast<std::uint8_t>(bytes[at + i]);
  return word;
}

/// As the PNG specification defines it (annex D), bit by bit.
std::uint32_t crc_of(const std::string& bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char byte : bytes) {
    crc ^= static_cast<std::uint8_t>(byte);
    for (int i = 0; i < 8; ++i) crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xedb88320U : crc >> 1U;
  }
  return ~crc;
}

std::string jpeg_of(const Picture& picture) {
  const tjhandle encoder = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(tjCompress2(encoder, reinterpret_cast<const unsigned char*>(picture.pixels.data()),
                        static_cast<int>(picture.width), 0, static_cast<int>(picture.height),
                        TJPF_RGBA, &bytes, &size, TJSAMP_444, 95, 0),
            0);
  std::string result(reinterpret_cast<char*>(bytes), size);
  tjFree(bytes);
  tjDestroy(encoder);
  return result;
}

TEST(Picture, LibpngReadsWhatIsWritten) {
  for (const bool opaque : {true, false}) {
    const Picture picture = speckled(37, 21, opaque);
    const std::string bytes = to_png(picture);
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
    EXPECT_EQ((image.format & PNG_FORMAT_FLAG_ALPHA) != 0, !opaque);
    image.format = PNG_FORMAT_RGBA;
    ASSERT_EQ(image.width, 37U);
    ASSERT_EQ(image.height, 21U);
    std::vector<Pixel> pixels(37 * 21);
    ASSERT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr), 0);
    EXPECT_EQ(pixels, picture.pixels);
  }
}

TEST(Picture, ChunksAreSoundAndSayNoTime) {
  const std::string bytes = to_png(speckled(5, 4, true));
  ASSERT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  std::string kinds;
  for (std::size_t at = 8; at < bytes.size();) {
    const std::size_t length = word_at(bytes, at);
    const std::string chunk = bytes.substr(at + 4, 4 + length);
    EXPECT_EQ(crc_of(chunk), word_at(bytes, at + 8 + length)) << chunk.substr(0, 4);
    kinds += chunk.substr(0, 4) + ' ';
    at += 12 + length;
  }
  EXPECT_EQ(kinds.substr(0, 5), "IHDR ");
  EXPECT_EQ(kinds.substr(kinds.size() - 5), "IEND ");
  EXPECT_EQ(kinds.find("tIME"), std::string::npos);
  EXPECT_EQ(kinds.find("tEXt"), std::string::npos);
  EXPECT_EQ(bytes, to_png(speckled(5, 4, true)));
}

TEST(Picture, NoPictureHasNoBytes) {
  EXPECT_EQ(to_png({}), "");
  EXPECT_EQ(to_png({2, 2, std::vector<Pixel>(3)}), "");
}

TEST(Picture, PngComesBackAsItWas) {
  for (const bool opaque : {true, false}) {
    const Picture picture = speckled(64, 9, opaque);
    const auto decoded = decode(to_png(picture));
    ASSERT_TRUE(decoded);
    EXPECT_EQ(decoded->width, 64U);
    EXPECT_EQ(decoded->height, 9U);
    EXPECT_EQ(decoded->pixels, picture.pixels);
  }
}

TEST(Picture, JpegComesBackNearlyAsItWas) {
  Picture picture{48, 40, std::vector<Pixel>(48 * 40, Pixel{200, 60, 20, 255})};
  for (std::uint32_t y = 20; y < 40; ++y) {
    for (std::uint32_t x = 0; x < 48; ++x) picture.at(x, y) = {10, 90, 220, 255};
  }
  const auto decoded = decode(jpeg_of(picture));
  ASSERT_TRUE(decoded);
  ASSERT_EQ(decoded->width, 48U);
  ASSERT_EQ(decoded->height, 40U);
  for (const std::uint32_t y : {0U, 10U, 30U, 39U}) {
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(decoded->at(5, y)[i], picture.at(5, y)[i], 6) << y;
    }
  }
}

TEST(Picture, EveryPrefixIsRefused) {
  const Picture picture = speckled(16, 16, false);
  const std::string png = to_png(picture);
  // Without its last chunk, which says only that it ends, all pixels are there.
  for (std::size_t size = 0; size + 16 < png.size(); ++size) {
    EXPECT_FALSE(decode(std::string_view(png).substr(0, size))) << size;
  }
  const std::string jpeg = jpeg_of(picture);
  for (std::size_t size = 0; size + 2 < jpeg.size(); ++size) {
    EXPECT_FALSE(decode(std::string_view(jpeg).substr(0, size))) << size;
  }
}

TEST(Picture, DamagedBytesGiveAPictureOfTheirSizeOrNone) {
  std::mt19937 random(11);
  const Picture picture = speckled(24, 24, true);
  for (const std::string& whole : {to_png(picture), jpeg_of(picture)}) {
    for (int round = 0; round < 2000; ++round) {
      std::string bytes = whole;
      for (int i = 0; i < 1 + round % 4; ++i) {
        bytes[random() % bytes.size()] = static_cast<char>(random());
      }
      const auto decoded = decode(bytes);
      if (!decoded) continue;
      EXPECT_EQ(decoded->pixels.size(), std::size_t{decoded->width} * decoded->height);
    }
  }
}

TEST(Picture, ClaimsOfSizeAreNotBelieved) {
  std::string bytes = to_png(speckled(4, 4, true));
  const auto claim = [&bytes](std::uint32_t width, std::uint32_t height) {
    for (std::size_t i = 0; i < 4; ++i) {
      bytes[16 + i] = static_cast<char>(width >> (24 - 8 * i));
      bytes[20 + i] = static_cast<char>(height >> (24 - 8 * i));
    }
    const std::uint32_t crc = crc_of(bytes.substr(12, 17));
    for (std::size_t i = 0; i < 4; ++i) bytes[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
  };
  claim(4, 4);
  EXPECT_TRUE(decode(bytes));
  for (const auto& [width, height] : {std::pair{8000U, 8000U},
                                      {0xffffffffU, 0xffffffffU},
                                      {0x7fffffffU, 1U},
                                      {0U, 4U},
                                      {4U, 0U}}) {
    claim(width, height);
    EXPECT_FALSE(decode(bytes)) << width << 'x' << height;
  }
  EXPECT_FALSE(decode(""));
  EXPECT_FALSE(decode("GIF89a"));
}

}  // namespace
}  // namespace rigor::view
