// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names from a file's content as names of files: a material may be called "../../x", and whoever wrote the mesh
// is not whoever runs rigor on it.
//
//   SafeNames names;
//   names.take("a/b");   // "a_b"
//   names.take("a:b");   // "a_b-2"

#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

namespace rigor::write {

/// Bytes of a safe name at most: with what a command puts before and behind it, it stays below the 255 that
/// file systems take.
inline constexpr std::size_t kMaxSafeName = 100;

/// The name as a part of one file's name: letters, digits, `.`, `_` and `-` of ASCII stay, each other byte
/// becomes `_`; so does a dot or a hyphen at the begin (a hidden file, an option) and a dot at the end. Never
/// empty.
std::string safe_name(std::string_view name);

/// Safe names of one run. No two are the same, not even where the file system takes no notice of case.
class SafeNames {
 public:
  std::string take(std::string_view name);

 private:
  std::set<std::string> taken_;  // in lower case
};

}  // namespace rigor::write
