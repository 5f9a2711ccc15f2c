// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a page's data as a browser would, without any of the code that writes them.

#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <zlib.h>

namespace rigor::test {

/// RFC 4648, 4.
inline std::string from_base64(std::string_view text) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  unsigned count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t value = kLetters.find(c);
    EXPECT_NE(value, std::string_view::npos) << "no letter of base64: " << c;
    bits = bits << 6U | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255U);
  }
  return bytes;
}

inline std::string inflated(const std::string& packed) {
  z_stream stream{};
  EXPECT_EQ(inflateInit(&stream), Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string out;
  int result = Z_OK;
  while (result == Z_OK) {
    std::array<char, 65536> buffer;
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = static_cast<uInt>(buffer.size());
    result = inflate(&stream, Z_NO_FLUSH);
    out.append(buffer.data(), buffer.size() - stream.avail_out);
  }
  EXPECT_EQ(result, Z_STREAM_END);
  inflateEnd(&stream);
  return out;
}

/// Numbers as they lie there, on a little-endian machine.
template <class T>
std::vector<T> numbers_at(const std::string& bytes, std::size_t at, std::size_t size) {
  EXPECT_EQ(at % 4, 0U);
  EXPECT_LE(at + size, bytes.size());
  std::vector<T> out(size / sizeof(T));
  if (at + size <= bytes.size()) std::memcpy(out.data(), bytes.data() + at, size);
  return out;
}

/// A page without any script.
inline constexpr std::string_view kPlainPage = "<body><!--DATA--></body>";

/// The text between what opens it and what closes it.
inline std::string between(const std::string& text, std::string_view open, std::string_view close) {
  const std::size_t begin = text.find(open);
  EXPECT_NE(begin, std::string::npos) << open;
  if (begin == std::string::npos) return {};
  const std::size_t from = begin + open.size();
  return text.substr(from, text.find(close, from) - from);
}

}  // namespace rigor::test
