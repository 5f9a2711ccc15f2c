// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What was found out before and may be forgotten at any time: bytes under a key, a file each, in a
// folder that stays below a size. Nothing that is wrong with the folder is an error: what cannot be
// read is not there, what cannot be written is not kept.
//
// Safe across threads and processes.
//
//   const FolderStore store("/home/me/.cache/rigor");
//   if (const auto bytes = store.get(key)) use(*bytes);
//   else store.put(key, found);

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/text/digest.h>

namespace rigor {

class FolderStore {
 public:
  /// The entries of thousands of meshes, which have some kilobytes each.
  static constexpr std::uint64_t kMaxBytes = std::uint64_t{256} << 20U;

  /// A larger entry is not kept: it would push many others out, and take long to read.
  static constexpr std::uint64_t kMaxEntryBytes = kMaxBytes / 16;

  /// To look at so many files takes some tens of milliseconds, once a run and when there is no room.
  static constexpr std::size_t kMaxEntries = 16384;

  /// The folder is made when the first entry is written.
  explicit FolderStore(std::string folder, std::uint64_t max_bytes = kMaxBytes);

  /// What was put, all of it and unharmed, or nothing.
  std::optional<std::string> get(const Digest& key) const;

  /// Readers see it whole or not at all. The oldest entries go when there is no room.
  void put(const Digest& key, std::string_view bytes) const;

 private:
  std::string path_of(const Digest& key) const;
  void make_room(std::uint64_t added) const;

  /// What the folder holds at most, as far as this run knows.
  struct Room;

  std::string folder_;
  std::uint64_t max_bytes_;
  std::shared_ptr<Room> room_;
};

}  // namespace rigor
