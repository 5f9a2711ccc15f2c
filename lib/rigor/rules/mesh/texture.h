// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the rules on a mesh's textures share: which are reported, and their names.

#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/mesh/asset/asset.h>
#include <rigor/rules/mesh/file_fault.h>
#include <rigor/text/path.h>

namespace rigor::rules {

using References = std::vector<mesh::FileReference>;

/// Contacts need no pictures.
inline bool is_drawn(const MeshFile& file) { return !file.collision(); }

/// Those that are in the state, each name once.
inline References in_state(const References& all, mesh::FileReference::State state) {
  References found;
  std::set<std::string_view> seen;
  for (const mesh::FileReference& reference : all) {
    if (reference.state == state && seen.insert(reference.written).second) {
      found.push_back(reference);
    }
  }
  return found;
}

/// "'wood.png' (line 12), 'rust.png' (shell.mtl, line 3)" and how many more.
inline std::string names_of(const References& references) {
  constexpr std::size_t kListed = 3;
  std::string text;
  for (std::size_t i = 0; i < references.size() && i < kListed; ++i) {
    const mesh::FileReference& reference = references[i];
    text += (i > 0 ? ", '" : "'") + reference.written + '\'';
    if (reference.line == 0) continue;
    const std::string from =
        reference.from.empty() ? "" : std::string(file_name(reference.from)) + ", ";
    text += " (" + from + "line " + std::to_string(reference.line) + ')';
  }
  if (references.size() <= kListed) return text;
  return text + " and " + std::to_string(references.size() - kListed) + " more";
}

/// "1 texture is not found: 'wood.png'"; without any, nothing.
inline void report_references(const MeshFile& file, Context& context, const References& references,
                              const std::string& one, const std::string& several) {
  if (references.empty()) return;
  const std::string count = std::to_string(references.size());
  report_mesh_text(
      file, context,
      (references.size() == 1 ? one : count + ' ' + several) + ": " + names_of(references));
}

}  // namespace rigor::rules
