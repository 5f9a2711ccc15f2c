// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/store/folder_store.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <cli/program.h>

namespace rigor {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  return files;
}

/// A key in the part that `part` says, whose writing lists the part or does not.
Digest key_in(std::uint8_t part, std::uint64_t number, std::uint8_t listing) {
  Digest key = digest_of(std::to_string(number));
  key[0] = part;
  key[1] = listing;
  return key;
}

constexpr std::size_t kPartEntries = FolderStore::kMaxEntries / FolderStore::kParts;

TEST(FolderStore, GivesBackWhatWasPut) {
  const test::Folder folder;
  const FolderStore store(folder.path("a/b"));
  const Digest key = digest_of("key");
  EXPECT_EQ(store.get(key), std::nullopt);
  store.put(key, std::string("some\0bytes", 10));
  EXPECT_EQ(store.get(key), std::string("some\0bytes", 10));
  EXPECT_EQ(store.get(digest_of("other")), std::nullopt);
  store.put(key, "");
  EXPECT_EQ(store.get(key), "");
  EXPECT_EQ(files_in(folder.path("a/b")).size(), 1U);
}

TEST(FolderStore, AnEntryIsWholeAndUnderItsOwnKeyOrNotThere) {
  const test::Folder folder;
  const FolderStore store(folder.path("cache"));
  const Digest key = digest_of("key");
  store.put(key, "bytes");
  const fs::path file = files_in(folder.path("cache")).front();
  const std::string part = "cache/" + file.parent_path().filename().string() + '/';
  const std::string name = part + file.filename().string();
  const std::string good = folder.get(name);
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 1);
    folder.put(name, bad);
    EXPECT_EQ(store.get(key), std::nullopt) << i;
    folder.put(name, good.substr(0, i));
    EXPECT_EQ(store.get(key), std::nullopt) << i;
  }
  folder.put(name, good);
  EXPECT_EQ(store.get(key), "bytes");
  Digest other = key;
  other[15] ^= 1;
  folder.put(part + hex(other) + ".entry", good);
  EXPECT_EQ(store.get(other), std::nullopt);
}

TEST(FolderStore, TheOldestGo) {
  const test::Folder folder;
  folder.put("cache/notes.txt", std::string(5000, 'x'));  // not the store's
  const FolderStore store(folder.path("cache"), 4000 * FolderStore::kParts);
  for (std::uint8_t i = 0; i < 8; ++i) {
    store.put(key_in(3, i, 0), std::string(900, 'x'));
    // Older than all that follow, whatever the clock's steps are.
    const fs::path file = folder.path("cache/03/" + hex(key_in(3, i, 0)) + ".entry");
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::seconds(100 - i));
  }
  // A part is brought to six eighths of its share: three such entries.
  EXPECT_FALSE(store.get(key_in(3, 3, 0)));
  for (std::uint8_t i = 5; i < 8; ++i) EXPECT_TRUE(store.get(key_in(3, i, 0))) << +i;
  store.put(key_in(3, 9, 0), std::string(5000, 'x'));  // larger than all there may be
  EXPECT_EQ(store.get(key_in(3, 9, 0)), std::nullopt);
  EXPECT_TRUE(store.get(key_in(3, 7, 0)));
  EXPECT_EQ(folder.get("cache/notes.txt").size(), 5000U);
}

TEST(FolderStore, AWriteIntoAFullStoreSeldomLooksForRoom) {
  const test::Folder folder;
  const FolderStore store(folder.path("cache"));
  for (std::size_t i = 0; i < kPartEntries; ++i) store.put(key_in(5, i, 1), "x");
  std::size_t listings = 0;
  std::size_t before = kPartEntries;
  for (std::size_t i = 0; i < 512; ++i) {
    store.put(key_in(5, 1'000'000 + i, static_cast<std::uint8_t>(i)), "x");
    if (i % 16 > 1) continue;
    const std::size_t now = files_in(folder.path("cache")).size();
    if (now < before) ++listings;
    before = now;
    EXPECT_LE(now, kPartEntries + 16);
    EXPECT_GE(now, kPartEntries / 2);
  }
  EXPECT_GT(listings, 0U);
  EXPECT_LE(listings, 512U / 16U);
}

TEST(FolderStore, AFolderThatIsMuchTooFullIsEmptiedBitByBit) {
  const test::Folder folder;
  for (int i = 0; i < 300; ++i) {
    const std::string name = hex(digest_of(std::to_string(i))) + ".entry";
    folder.put("cache/" + name, "of an older rigor, which had no parts");
  }
  const FolderStore store(folder.path("cache"));
  std::size_t before = 300;
  for (std::uint64_t i = 0; i < 6; ++i) {
    store.put(key_in(0, i, 0), "x");
    const std::size_t now = files_in(folder.path("cache")).size();
    EXPECT_LE(before - std::min(before, now), 128U);
    before = now;
  }
  EXPECT_EQ(before, 6U);
}

TEST(FolderStore, ManyWritersKeepTheSizeAndEveryEntryIsRight) {
  const test::Folder folder;
  constexpr std::uint64_t kWriters = 8;
  constexpr std::uint64_t kEach = 1500;
  const auto bytes_of = [](std::uint64_t i) {
    return std::string(i % 97, 'x') + std::to_string(i);
  };
  // All in four parts, so that each is filled ten times over; each writer has a store of its own, as processes have.
  const auto key_of = [](std::uint64_t i) {
    Digest key = digest_of(std::to_string(i));
    key[0] = static_cast<std::uint8_t>(i % 4);
    return key;
  };
  std::vector<std::thread> writers;
  std::atomic<int> wrong = 0;
  for (std::uint64_t w = 0; w < kWriters; ++w) {
    writers.emplace_back([&, w] {
      const FolderStore store(folder.path("cache"));
      for (std::uint64_t n = 0; n < kEach; ++n) {
        const std::uint64_t i = n * (1 + w % 2) + w / 2 * kEach;  // some are written by two
        store.put(key_of(i), bytes_of(i));
        const std::uint64_t other = i / 2;
        const std::optional<std::string> read = store.get(key_of(other));
        if (read && *read != bytes_of(other)) ++wrong;
      }
    });
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(wrong, 0);
  // In each part its share, and what is written between two listings: 32 on average, with luck some times that.
  const std::size_t kept = files_in(folder.path("cache")).size();
  EXPECT_LE(kept, 4 * (kPartEntries + 10 * 16));
  EXPECT_GE(kept, 4 * kPartEntries / 2);
}

TEST(FolderStore, AFolderThatCannotBeIsNoError) {
  const test::Folder folder;
  folder.put("file", "");
  const FolderStore store(folder.path("file/cache"));
  store.put(digest_of("key"), "bytes");
  EXPECT_EQ(store.get(digest_of("key")), std::nullopt);
  EXPECT_EQ(folder.get("file"), "");
}

}  // namespace
}  // namespace rigor
