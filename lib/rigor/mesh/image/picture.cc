// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/image/picture.h>

#include <string>
#include <string_view>

namespace rigor::mesh {
namespace {

// The signature and the name of the header, which is the first chunk (PNG 1.2, 3 and 4.1.1).
constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kPngHeader = "IHDR";

// Segments before a JPEG's frame: thumbnails and color profiles take some dozens.
constexpr int kMaxSegments = 1000;

std::string bytes_at(const OpenFile& file, std::uint64_t offset, std::size_t count) {
  std::string bytes(count, '\0');
  bytes.resize(file.read(offset, bytes.data(), count));
  return bytes;
}

/// The most significant byte first.
std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes) value = value << 8U | static_cast<unsigned char>(byte);
  return value;
}

/// Whether a marker begins a frame (ITU-T T.81, table B.1): SOF0 to SOF15 without DHT, JPG, DAC.
bool begins_frame(std::uint32_t marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

PictureSize jpeg_size(const OpenFile& file) {
  std::uint64_t at = 2;
  for (int i = 0; i < kMaxSegments; ++i) {
    const std::string segment = bytes_at(file, at, 9);
    if (segment.size() < 9 || segment[0] != '\xFF') break;
    const std::uint32_t marker = big_endian(std::string_view(segment).substr(1, 1));
    if (marker == 0xFF) {  // a fill byte
      ++at;
      continue;
    }
    const std::string_view body = std::string_view(segment).substr(2);
    if (begins_frame(marker)) return {big_endian(body.substr(5, 2)), big_endian(body.substr(3, 2))};
    at += 2 + big_endian(body.substr(0, 2));
  }
  return {};
}

}  // namespace

PictureSize picture_size(const OpenFile& file) {
  const std::string begin = bytes_at(file, 0, 24);
  const std::string_view header = begin;
  if (header.starts_with("\xFF\xD8")) return jpeg_size(file);
  if (header.size() < 24 || !header.starts_with(kPng) || header.substr(12, 4) != kPngHeader) {
    return {};
  }
  return {big_endian(header.substr(16, 4)), big_endian(header.substr(20, 4))};
}

}  // namespace rigor::mesh
