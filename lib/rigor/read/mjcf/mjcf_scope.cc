// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/mjcf/mjcf_scope.h>

#include <utility>

namespace rigor::read {

MjcfScope::MjcfScope(Workspace& workspace, const File& file, std::string names_prefix,
                     MjcfFacts& facts)
    : tree(workspace, file, facts),
      settings(mjcf_settings(tree)),
      defaults(tree, facts),
      assets(mjcf_assets(tree, settings, defaults)),
      prefix(std::move(names_prefix)) {
  for (const xml::Element pair : tree.in_sections("contact")) {
    if (pair.name() != "pair") continue;
    for (const char* side : {"geom1", "geom2"}) {
      in_pairs.insert(string_field(attribute_text(pair, side)).value);
    }
  }
}

}  // namespace rigor::read
