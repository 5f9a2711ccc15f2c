// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A file under a name of its own beside the one that it becomes.

#pragma once

#include <string>

#include <rigor/results/writer.h>

namespace rigor::results {

/// Throws `DatabaseError`.
class Writer::TemporaryFile {
 public:
  /// Created empty, readable as the umask allows. A link at `path` is followed.
  explicit TemporaryFile(const std::string& path);
  /// Removes it, unless it was renamed.
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return temporary_; }

  /// When its bytes are on the disk, to the name that was asked for.
  void rename();

 private:
  std::string target_;
  std::string temporary_;
};

}  // namespace rigor::results
