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

/// What Python's hashlib.blake2b(…, digest_size=32) says.
TEST(Digest, KnownAnswers) {
  const auto digest = [](std::string_view bytes) { return hex(digest_of(bytes)); };
  EXPECT_EQ(digest(""), "0e5751c026e543b2e8ab2eb06099daa1d1e5df47778f7787faab45cdf12fe3a8");
  EXPECT_EQ(digest("abc"), "bddd813c634239723171ef3fee98579b94964e3bb1cb3e427262c8c068d52319");
  EXPECT_EQ(digest(counting_bytes(128)),
            "c3582f71ebb2be66fa5dd750f80baae97554f3b015663c8be377cfcb2488c1d1");
  EXPECT_EQ(digest(counting_bytes(129)),
            "f7f3c46ba2564ff4c4c162da1f5b605f9f1c4aa6a20652a9f9a337c1a2f5b9c9");
  EXPECT_EQ(digest(counting_bytes(1'000'000)),
            "9e5e2f2d303e7db6db30a3355a9a7def57785f58e04a95b22254b60ab9e9a51b");
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
