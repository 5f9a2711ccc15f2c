// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/rename.h>

#include <string>
#include <string_view>
#include <unordered_set>

namespace rigor::read {

void rename_siblings(model::Root& root, model::Id<model::Model> id) {
  const model::Model& model = root[id];
  if (model.joints.empty() && model.frames.empty()) return;
  std::unordered_set<std::string> taken;
  for (const auto link : model.links) taken.insert(root[link].name.value);
  for (const auto nested : model.models) taken.insert(root[nested].name.value);
  const auto claim = [&taken](const std::string& name, std::string_view suffix) {
    if (taken.insert(name).second) return std::string();
    const std::string base = name + std::string(suffix);
    std::string alias = base;
    for (int i = 0; !taken.insert(alias).second; ++i) alias = base + std::to_string(i);
    return alias;
  };
  for (const auto joint : model.joints) {
    root.joints[joint.value].alias = claim(root[joint].name.value, "_joint");
  }
  for (const auto frame : model.frames) {
    root.frames[frame.value].alias = claim(root[frame].name.value, "_frame");
  }
}

}  // namespace rigor::read
