// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/path_patterns.h>

#include <cstddef>
#include <utility>

#include <rigor/text/glob.h>
#include <rigor/text/path.h>

namespace rigor::config {
namespace {

/// A pattern as .gitignore wants it, where `./` is nothing's name.
std::string_view without_dot_folder(std::string_view pattern) {
  if (pattern.starts_with("./")) pattern.remove_prefix(1);
  return pattern;
}

}  // namespace

PathPatterns::PathPatterns(std::string folder, std::vector<Name> patterns)
    : folder_(std::move(folder)), written_(std::move(patterns)) {
  for (const Name& name : written_) {
    patterns_.emplace_back(without_dot_folder(name.value), name.place.line);
  }
}

const Name* PathPatterns::covering(std::string_view path, PathKind kind) const {
  const std::string above = folder_ == "/" || folder_ == "." ? "" : folder_;
  if (!path.starts_with(above)) return nullptr;
  path.remove_prefix(above.size());
  const bool inside = path.starts_with('/');
  if (inside) path.remove_prefix(1);
  if (path.empty() || (!inside && folder_ != ".")) return nullptr;
  for (std::size_t slash = path.find('/'); slash != std::string_view::npos;
       slash = path.find('/', slash + 1)) {
    if (const Name* name = naming(path.substr(0, slash), PathKind::kFolder)) return name;
  }
  return naming(path, kind);
}

const Name* PathPatterns::naming(std::string_view path, PathKind kind) const {
  for (std::size_t i = patterns_.size(); i-- > 0;) {
    if (patterns_[i].matches(path, kind)) return patterns_[i].ignores ? &written_[i] : nullptr;
  }
  return nullptr;
}

std::string unusable_pattern(std::string_view pattern) {
  const std::string_view bare = pattern.substr(pattern.starts_with('!') ? 1 : 0);
  if (bare.empty() || bare == "/") return "is empty";
  if (!Glob(bare).usable()) return "matches nothing: [ needs its ], and \\ a sign after it";
  const std::string parts = '/' + std::string(bare) + '/';
  if (parts.find("/../") != std::string::npos) {
    return "leads out of this file's folder, which patterns are relative to";
  }
  return {};
}

}  // namespace rigor::config
