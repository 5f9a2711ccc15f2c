// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What was found out before and may be forgotten at any time: bytes under a key, a file each, in a
// folder that stays about a size. Nothing that is wrong with the folder is an error: what cannot be
// read is not there, what cannot be written is not kept.
//
// Entries are spread over sub-folders, the parts, by their keys. One write in some lists its part and removes the
// oldest entries of a part that is too full, so that a write into a full store costs as much as into an empty
// one. Nothing is counted between writes: safe across threads and processes, which need not know of each other.
//
//   const FolderStore store("/home/me/.cache/rigor");
//   if (const auto bytes = store.get(key)) use(*bytes);
//   else store.put(key, found);

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/text/digest.h>

namespace rigor {

class FolderStore {
 public:
  /// The entries of thousands of meshes, which have some kilobytes each.
  static constexpr std::uint64_t kMaxBytes = std::uint64_t{256} << 20U;

  /// Files in all parts. A part is brought down before it has its share, as some tens are written between two
  /// listings, so that all together stay at this.
  static constexpr std::size_t kMaxEntries = 16384;

  /// Sub-folders. Few enough that a part can hold a large entry, many enough that it is listed in no time.
  static constexpr std::size_t kParts = 64;

  /// A larger entry is not kept: it would push many others out, and take long to read.
  static constexpr std::uint64_t kMaxEntryBytes = kMaxBytes / kParts / 4;

  /// The folder is made when the first entry is written.
  explicit FolderStore(std::string folder, std::uint64_t max_bytes = kMaxBytes);

  /// What was put, all of it and unharmed, or nothing.
  std::optional<std::string> get(const Digest& key) const;

  /// Readers see it whole or not at all: an entry says what it must hold. The oldest entries of its part go when there is no room.
  void put(const Digest& key, std::string_view bytes) const;

 private:
  std::string part_of(const Digest& key) const;
  std::string path_of(const Digest& key) const;
  void make_room(const Digest& key) const;

  std::string folder_;
  std::uint64_t max_part_bytes_;
};

}  // namespace rigor
