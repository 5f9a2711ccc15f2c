// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Tells whether bytes are the same as some that were seen before: 128 bits of XXH3, in which two texts do not
// meet by chance. It is no cryptographic hash: who wants two texts to agree can make them, so it names what a
// user keeps for themself, and proves nothing about what others send.
//
//   Hasher hasher;
//   hasher.add(first);
//   hasher.add(second);
//   const std::string name = hex(hasher.digest());

#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include <rigor/text/disk.h>

struct XXH3_state_s;

namespace rigor {

/// In xxHash's canonical form, highest byte first: the same on every machine.
using Digest = std::array<std::uint8_t, 16>;

/// Bytes that are added piece by piece have the digest of the whole.
class Hasher {
 public:
  Hasher();

  void add(std::string_view bytes);
  Digest digest() const;

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Free> state_;
};

Digest digest_of(std::string_view bytes);

/// Of all bytes of a file, as far as the disk gives them.
Digest digest_of(const OpenFile& file);

/// 32 lower-case digits.
std::string hex(const Digest& digest);

/// The digest's own bytes.
std::string_view digest_bytes(const Digest& digest);

}  // namespace rigor
