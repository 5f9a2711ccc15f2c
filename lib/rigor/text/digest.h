// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Tells whether bytes are the same as some that were seen before: 256 bits of BLAKE2b, of which nobody
// can make two texts agree.
//
//   Hasher hasher;
//   hasher.add(first);
//   hasher.add(second);
//   const std::string name = hex(hasher.digest());
//
// M.-J. Saarinen, J.-P. Aumasson, "The BLAKE2 Cryptographic Hash and Message Authentication Code
// (MAC)", RFC 7693, 2015. A gigabyte takes about a second.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <rigor/text/disk.h>

namespace rigor {

using Digest = std::array<std::uint8_t, 32>;

/// Bytes that are added piece by piece have the digest of the whole.
class Hasher {
 public:
  Hasher();

  void add(std::string_view bytes);
  Digest digest() const;

 private:
  static constexpr std::size_t kBlock = 128;
  using Block = std::array<char, kBlock>;

  void mix(const char* block, std::uint64_t last);

  std::array<std::uint64_t, 8> state_;
  std::uint64_t count_ = 0;  // of mixed bytes
  Block rest_{};             // what the next block begins with: mixed only when more follows
  std::size_t filled_ = 0;
};

Digest digest_of(std::string_view bytes);

/// Of all bytes of a file, as far as the disk gives them.
Digest digest_of(const OpenFile& file);

/// 64 lower-case digits.
std::string hex(const Digest& digest);

/// The digest's own bytes.
std::string_view digest_bytes(const Digest& digest);

}  // namespace rigor
