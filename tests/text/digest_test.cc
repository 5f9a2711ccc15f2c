// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/digest.h>

#include <string>

#include <gtest/gtest.h>

namespace rigor {
namespace {

/// 0 to 250, over and over.
std::string counting_bytes(std::size_t size) {
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(i % 251);
  return bytes;
}

/// What `xxhsum -H128` prints.
TEST(Digest, KnownAnswers) {
  const auto digest = [](std::string_view bytes) { return hex(digest_of(bytes)); };
  EXPECT_EQ(digest(""), "99aa06d3014798d86001c324468d497f");
  EXPECT_EQ(digest("abc"), "06b05ab6733a618578af5f94892f3950");
  EXPECT_EQ(digest(counting_bytes(128)), "14792fc3af88dc6c05321a0b64d67b41");
  EXPECT_EQ(digest(counting_bytes(129)), "dd5e74ac6b45f54ebc30b63382b09a3b");
  EXPECT_EQ(digest(counting_bytes(1'000'000)), "00d4a9d9f77c7d2ddf99c4163891c544");
}

TEST(Digest, PiecesAreTheWhole) {
  const std::string bytes = counting_bytes(1000);
  for (std::size_t size = 1; size < 300; ++size) {
    Hasher hasher;
    for (std::size_t at = 0; at < bytes.size(); at += size) hasher.add(bytes.substr(at, size));
    EXPECT_EQ(hasher.digest(), digest_of(bytes)) << size;
  }
}

TEST(Digest, OfAFile) {
  const std::string bytes = counting_bytes(700'000);
  const MemoryDisk disk({{"a", bytes}});
  EXPECT_EQ(digest_of(*disk.open("a")), digest_of(bytes));
}

}  // namespace
}  // namespace rigor
