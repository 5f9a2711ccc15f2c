// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/rename.h>

#include <memory_resource>
#include <string>
#include <string_view>
#include <unordered_set>

namespace rigor::read {

void rename_siblings(model::Root& root, model::Id<model::Model> id) {
  const model::Model& model = root[id];
  if (model.joints.empty() && model.frames.empty()) return;
  std::pmr::monotonic_buffer_resource memory;
  std::pmr::unordered_set<std::string_view> taken(&memory);
  for (const auto link : model.links) taken.insert(root[link].name.value);
  for (const auto nested : model.models) taken.insert(root[nested].name.value);
  const auto claim = [&taken](auto& entity, std::string_view suffix) {
    entity.alias.clear();
    if (taken.insert(entity.name.value).second) return;
    const std::string base = entity.name.value + std::string(suffix);
    entity.alias = base;
    for (int i = 0; !taken.insert(entity.alias).second; ++i)
      entity.alias = base + std::to_string(i);
  };
  for (const auto joint : model.joints) {
    claim(root.joints[joint.value], "_joint");
  }
  for (const auto frame : model.frames) {
    claim(root.frames[frame.value], "_frame");
  }
}

}  // namespace rigor::read
