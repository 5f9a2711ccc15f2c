// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/cached_disk.h>

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace rigor::lsp {
namespace {

constexpr std::uint64_t kMax = std::uint64_t{1} << 26U;

struct CachedDiskTest : testing::Test {
  MemoryDisk below;
  CachedDisk::Time time = CachedDisk::Time() + std::chrono::hours(1);
  CachedDisk disk{below, [this] { return time; }};
};

TEST_F(CachedDiskTest, AnswersTheSameUntilASecondHasPassed) {
  disk.expire();
  EXPECT_EQ(disk.kind("/a"), PathKind::kMissing);
  below.put("/a", "new");
  below.put("/b", "old");
  EXPECT_EQ(disk.read("/b", kMax).bytes, "old");
  below.put("/b", "newer");
  time += CachedDisk::kMaxAge;
  disk.expire();
  EXPECT_EQ(disk.kind("/a"), PathKind::kMissing);
  EXPECT_EQ(disk.read("/b", kMax).bytes, "old");
  time += std::chrono::milliseconds(1);
  disk.expire();
  EXPECT_EQ(disk.kind("/a"), PathKind::kFile);
  EXPECT_EQ(disk.read("/b", kMax).bytes, "newer");
}

TEST_F(CachedDiskTest, ForgetsWhenFilesHaveChanged) {
  EXPECT_EQ(disk.kind("/a"), PathKind::kMissing);
  below.put("/a", "new");
  disk.forget();
  EXPECT_EQ(disk.kind("/a"), PathKind::kFile);
}

TEST_F(CachedDiskTest, RefusesWhatIsTooLargeForWhoeverAsks) {
  below.put("/a", "12345");
  EXPECT_EQ(disk.read("/a", 5).bytes, "12345");
  EXPECT_EQ(disk.read("/a", 4).error, ReadError::kTooLarge);
}

TEST_F(CachedDiskTest, KeepsNoLargeFiles) {
  below.put("/a", std::string(CachedDisk::kMaxFileBytes + 1, 'a'));
  EXPECT_EQ(disk.read("/a", kMax).bytes->front(), 'a');
  below.put("/a", "b");
  EXPECT_EQ(disk.read("/a", kMax).bytes, "b");
}

}  // namespace
}  // namespace rigor::lsp
