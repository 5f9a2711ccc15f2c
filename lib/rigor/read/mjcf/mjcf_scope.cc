// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/mjcf/mjcf_scope.h>

#include <utility>

#include <rigor/text/path.h>

namespace rigor::read {

MjcfScope::MjcfScope(Workspace& workspace, const File& file, std::string names_prefix,
                     MjcfFacts& facts)
    : tree(workspace, file, facts),
      settings(mjcf_settings(tree)),
      defaults(tree, facts),
      assets(mjcf_assets(tree, settings, defaults)),
      prefix(std::move(names_prefix)) {
  // A model without a name has that of its own file.
  for (const xml::Element element : tree.in_sections("asset")) {
    if (element.name() != "model" || element.attribute("name")) continue;
    const std::string name = mjcf_name(element, "file").value;
    const std::string path = join_path(parent_path(file.path), name);
    if (workspace.disk().kind(path) != PathKind::kFile) continue;
    const File& inner = workspace.open(path);
    if (!inner.document || !inner.document->root()) continue;
    const auto own = mjcf_name(*inner.document->root(), "model");
    if (own.written) assets.models.try_emplace(own.value, element);
  }
  for (const xml::Element pair : tree.in_sections("contact")) {
    if (pair.name() != "pair") continue;
    for (const char* side : {"geom1", "geom2"}) {
      in_pairs.insert(mjcf_name(pair, side).value);
    }
  }
}

}  // namespace rigor::read
