// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes a file so that a reader, and who looks after a crash, sees the old bytes or the new ones, never a part.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rigor::tool {

/// Writes a temporary file in the same folder, waits until its bytes are on the disk (fsync) and renames it
/// over `path`, keeping the mode of a file that is replaced; a link is followed. What is no regular file (a pipe, /dev/stderr) is written
/// directly. Throws UsageError when it cannot be written.
void replace_file(const std::string& path, std::string_view bytes);

/// The same for a file that rigor names itself, or that content names: `name`, which may have folders, below
/// `folder`, which somebody gave. Missing folders are made. No link below `folder` is followed, whatever a
/// repository has put there: one in the way is a UsageError with its name, as is whatever else is no regular file,
/// and a name that leads out of the folder.
void put_file(const std::string& folder, std::string_view name, std::string_view bytes);

/// A file and what it holds before and after.
struct FileReplacement {
  std::string path;
  std::string_view before;
  std::string_view after;
};

/// A file that is changed in its place. Who named `path` itself may mean a link, which is followed; what was found
/// in a folder that somebody named, or by the model.config that somebody named, is written as by `put_file`.
void replace_found(const std::vector<std::string>& named, const std::string& path,
                   std::string_view bytes);

/// The same for several files, all or none: each is on the disk under another name before the first gets its own, and
/// when one does not get it, those that have are as they were.
void replace_all_found(const std::vector<std::string>& named,
                       const std::vector<FileReplacement>& files);

}  // namespace rigor::tool
