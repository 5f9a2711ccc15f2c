// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the system says of a file without reading it: as long as that is the same, so are the file's bytes.
//
//   const std::optional<FileStamp> before = stamp_of(path);
//   const Facts facts = look_at(path);
//   if (before && stamp_of(path) == before) keep(facts);

#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace rigor {

struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::uint64_t bytes = 0;
  std::int64_t modified = 0;  ///< content; ns since 1970
  std::int64_t changed = 0;   ///< content, or anything else but reading; ns since 1970

  bool operator==(const FileStamp&) const = default;
};

/// Nothing of what is no regular file, and of a file that has just changed: a second change within the same tick of
/// the file system's clock would leave the stamp as it is. ("Racy git" has the same problem.)
std::optional<FileStamp> stamp_of(const std::string& path);

}  // namespace rigor
