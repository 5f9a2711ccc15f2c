// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/other_case.h>

#include <rigor/text/letter_case.h>
#include <rigor/text/path.h>

namespace rigor {

std::string OtherCase::find(const std::string& path) {
  const std::string_view wanted = file_name(path);
  const std::string_view written = parent_path(path);
  const std::lock_guard lock(mutex_);
  const std::string& there = folder(written);
  if (there.empty() || wanted.empty()) return {};
  const Names& names_there = names(there);
  const auto found = names_there.find(lowered(wanted));
  if (found == names_there.end()) return {};
  for (const std::string& name : found->second) {
    if (name != wanted || there != written) return join_path(there, name);
  }
  return {};
}

const std::string& OtherCase::folder(std::string_view asked) {
  if (const auto known = folders_.find(asked); known != folders_.end()) return known->second;
  const std::string path(asked);
  std::string result;
  if (path == "." || disk_.kind(path) == PathKind::kFolder) {
    result = path;
  } else if (const std::string above(parent_path(path)); above.size() < path.size()) {
    const std::string there = folder(above);
    const Names none;
    const Names& candidates = there.empty() ? none : names(there);
    const auto found = candidates.find(lowered(file_name(path)));
    if (found != candidates.end()) {
      for (const std::string& name : found->second) {
        const std::string inside = join_path(there, name);
        if (result.empty() && disk_.kind(inside) == PathKind::kFolder) result = inside;
      }
    }
  }
  return folders_.emplace(path, std::move(result)).first->second;
}

const OtherCase::Names& OtherCase::names(const std::string& folder) {
  const auto [known, is_new] = names_.try_emplace(folder);
  if (is_new) {
    for (const std::string& name : disk_.list(folder)) known->second[lowered(name)].push_back(name);
  }
  return known->second;
}

}  // namespace rigor
