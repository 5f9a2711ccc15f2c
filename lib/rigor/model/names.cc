// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/model/names.h>

namespace rigor::model {
namespace {

template <class T>
Id<T> id_of(std::size_t index) {
  return {static_cast<std::uint32_t>(index)};
}

}  // namespace

std::uint64_t Names::scope_key(ScopeId scope) {
  if (scope.model) return scope.model.value;
  return (std::uint64_t{1} << 32U) + scope.world.value;
}

Names::Names(const Root& root) : root_(root) {
  table_.reserve(root.models.size() + root.links.size() + root.joints.size() + root.frames.size());
  // Where a name is used twice the first one counts, as for a consumer that looks from the front.
  const auto add = [this](ScopeId scope, const std::string& name, Named what) {
    table_.try_emplace({scope_key(scope), name}, what);
  };
  for (std::size_t i = 0; i < root.links.size(); ++i) {
    add({root.links[i].model, {}}, root.links[i].name.value, id_of<Link>(i));
  }
  for (std::size_t i = 0; i < root.joints.size(); ++i) {
    const Joint& joint = root.joints[i];
    add({joint.model, joint.world}, joint.name.value, id_of<Joint>(i));
    if (!joint.alias.empty()) add({joint.model, joint.world}, joint.alias, id_of<Joint>(i));
  }
  for (std::size_t i = 0; i < root.frames.size(); ++i) {
    const Frame& frame = root.frames[i];
    add({frame.model, frame.world}, frame.name.value, id_of<Frame>(i));
    if (!frame.alias.empty()) add({frame.model, frame.world}, frame.alias, id_of<Frame>(i));
  }
  for (std::size_t i = 0; i < root.models.size(); ++i) {
    add({root.models[i].parent, root.models[i].world}, root.models[i].name.value, id_of<Model>(i));
  }
}

Named Names::find_here(ScopeId scope, std::string_view name) const {
  if (name == "__model__" && scope.model) return scope.model;
  const auto found = table_.find({scope_key(scope), name});
  return found == table_.end() ? Named{} : found->second;
}

Named Names::find(ScopeId scope, std::string_view name) const {
  while (true) {
    const Named found = find_here(scope, name);
    if (found.index() != 0) return found;
    const std::size_t separator = name.find("::");
    if (separator == std::string_view::npos) return {};
    const Named outer = find_here(scope, name.substr(0, separator));
    const auto* nested = std::get_if<Id<Model>>(&outer);
    if (nested == nullptr) return {};
    scope = {*nested, {}};
    name.remove_prefix(separator + 2);
  }
}

Id<Link> Names::find_link(Id<Model> model, std::string_view name) const {
  const Named found = find_here({model, {}}, name);
  const auto* link = std::get_if<Id<Link>>(&found);
  return link == nullptr ? Id<Link>{} : *link;
}

Id<Joint> Names::find_joint(Id<Model> model, std::string_view name) const {
  const Named found = find_here({model, {}}, name);
  if (const auto* joint = std::get_if<Id<Joint>>(&found)) return *joint;
  if (found.index() == 0) return {};  // nothing of any kind has the name
  for (const Id<Joint> id : root_[model].joints) {
    if (root_[id].name.value == name) return id;
  }
  return {};
}

std::vector<std::string> Names::in(ScopeId scope) const {
  std::vector<std::string> names;
  const auto add = [&](const auto& ids) {
    for (const auto id : ids) names.push_back(root_[id].name.value);
  };
  if (scope.model) {
    const Model& model = root_[scope.model];
    add(model.links);
    add(model.joints);
    add(model.frames);
    add(model.models);
  } else if (scope.world) {
    const World& world = root_[scope.world];
    add(world.models);
    add(world.frames);
    add(world.joints);
  }
  return names;
}

}  // namespace rigor::model
