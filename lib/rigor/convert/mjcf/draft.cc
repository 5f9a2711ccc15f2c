// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/mjcf/draft.h>

namespace rigor::convert {

MjcfEntities::MjcfEntities(const model::Root& root) {
  for (const auto& link : root.links) links_.try_emplace(key(link.site.tag), &link);
  for (const auto& joint : root.joints) joints_.try_emplace(key(joint.site.tag), &joint);
  for (const auto& each : root.collisions) collisions_.try_emplace(key(each.site.tag), &each);
  for (const auto& each : root.visuals) visuals_.try_emplace(key(each.site.tag), &each);
}

std::vector<robot::Look> MjcfDraft::looks_of(const model::Visual& visual,
                                             const mesh::TriangleMesh& shape) const {
  if (!options.looks) return {};
  const auto index = static_cast<std::uint32_t>(&visual - root().visuals.data());
  return options.looks({index}, shape);
}

std::string MjcfDraft::name_for(std::string_view kind, const std::string& name) {
  return names[std::string(kind)].add(name);
}

}  // namespace rigor::convert
