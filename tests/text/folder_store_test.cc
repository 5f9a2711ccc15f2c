// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/folder_store.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cli/program.h>

namespace rigor {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  return files;
}

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
  const std::string name = "cache/" + file.filename().string();
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
  const Digest other = digest_of("other");
  folder.put("cache/" + hex(other) + ".entry", good);
  EXPECT_EQ(store.get(other), std::nullopt);
}

TEST(FolderStore, TheOldestGo) {
  const test::Folder folder;
  folder.put("cache/notes.txt", std::string(5000, 'x'));  // not the store's
  const FolderStore store(folder.path("cache"), 4000);
  const auto key = [](int i) { return digest_of(std::to_string(i)); };
  for (int i = 0; i < 8; ++i) {
    store.put(key(i), std::string(900, 'x'));
    // Older than all that follow, whatever the clock's steps are.
    const fs::path file = folder.path("cache/" + hex(key(i)) + ".entry");
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::seconds(100 - i));
  }
  for (int i = 0; i < 8; ++i) EXPECT_EQ(store.get(key(i)).has_value(), i >= 4) << i;
  store.put(key(9), std::string(5000, 'x'));  // larger than all there may be
  EXPECT_EQ(store.get(key(9)), std::nullopt);
  EXPECT_TRUE(store.get(key(7)));
  EXPECT_EQ(folder.get("cache/notes.txt").size(), 5000U);
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
