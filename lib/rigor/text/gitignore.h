// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Lists of patterns that say which paths to leave out, as git reads a `.gitignore`.
//
//   const IgnorePatterns patterns("build/\n*.sdf\n!keep.sdf\n");   // what stands in a folder's file
//   const IgnorePattern* last = patterns.last_match("worlds/lab.sdf", PathKind::kFile);
//   if (last != nullptr && last->ignores) skip();                  // paths as seen from that folder
//
// The last pattern that matches decides. One without a slash is held against a name in any folder, any
// other against the whole path; one that ends in a slash matches folders only. What is inside a folder
// that is left out is not asked for: neither git nor a walk goes there.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/disk.h>
#include <rigor/text/glob.h>

namespace rigor {

/// One line of such a file.
class IgnorePattern {
 public:
  /// Without its line's end and the spaces before it; `line` counts from 1.
  IgnorePattern(std::string_view text, std::size_t line);

  bool matches(std::string_view path, PathKind kind) const;

  std::string text;      ///< as written
  std::size_t line = 0;  ///< where
  bool ignores = true;   ///< false for one that begins with `!`: it takes back

 private:
  bool folders_only_ = false;
  bool name_only_ = false;
  std::string beginning_;  ///< its bytes before the first special one represent themselves
  Glob rest_;
  bool plain_ = false;  ///< there is no rest
};

class IgnorePatterns {
 public:
  IgnorePatterns() = default;

  /// The bytes of a file: a pattern a line, `#` begins a comment.
  explicit IgnorePatterns(std::string_view bytes);

  /// What decides of `path`, which is relative to the folder of the patterns and has no `.` or `..`;
  /// nullptr when no pattern matches. Folders above it are the caller's to ask for first.
  const IgnorePattern* last_match(std::string_view path, PathKind kind) const;

  bool empty() const { return patterns_.empty(); }

 private:
  std::vector<IgnorePattern> patterns_;
};

}  // namespace rigor
