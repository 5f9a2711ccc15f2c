// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/merge.h>

#include <algorithm>
#include <string>
#include <utility>

namespace rigor::read {
namespace {

using model::Field;
using model::Id;

/// Rewrites references that meant the inner model's own frame.
class Renaming {
 public:
  explicit Renaming(std::string frame) : frame_(std::move(frame)) {}

  void explicit_only(Field<std::string>& reference) const {
    if (reference.value == "__model__") reference.value = frame_;
  }
  void or_default(Field<std::string>& reference) const {
    if (reference.value.empty()) reference.value = frame_;
    explicit_only(reference);
  }

 private:
  std::string frame_;
};

/// The link that a model without a `canonical_link` takes, as said inside it.
std::string canonical_link(const model::Root& root, Id<model::Model> id) {
  std::string name;
  while (root[id].links.empty()) {
    if (root[id].models.empty()) return {};
    id = root[id].models.front();
    name += root[id].name.value + "::";
    if (!root[id].canonical_link.value.empty()) return name + root[id].canonical_link.value;
  }
  return name + root[root[id].links.front()].name.value;
}

template <class T>
void move_ids(std::vector<Id<T>>& from, std::vector<Id<T>>& to) {
  to.insert(to.end(), from.begin(), from.end());
  from.clear();
}

}  // namespace

void merge_into_parent(model::Root& root, Id<model::Model> inner_id) {
  model::Model& inner = root.models[inner_id.value];
  const Id<model::Model> outer_id = inner.parent;
  model::Model& outer = root.models[outer_id.value];
  inner.merged = true;
  if (inner.canonical_link.value.empty()) {
    inner.canonical_link.value = canonical_link(root, inner_id);
  }
  inner.name.value = "_merged__" + inner.name.value + "__model__";
  const Renaming rename(inner.name.value);

  for (const Id<model::Link> id : inner.links) {
    model::Link& link = root.links[id.value];
    link.model = outer_id;
    rename.or_default(link.pose.relative_to);
    for (const auto part : link.collisions) {
      rename.explicit_only(root.collisions[part.value].pose.relative_to);
    }
    for (const auto part : link.visuals) {
      rename.explicit_only(root.visuals[part.value].pose.relative_to);
    }
    for (const auto part : link.sensors) {
      rename.explicit_only(root.sensors[part.value].pose.relative_to);
    }
  }
  for (const Id<model::Joint> id : inner.joints) {
    model::Joint& joint = root.joints[id.value];
    joint.model = outer_id;
    // A URDF's joint stands in its parent's frame, an SDF's in its child's.
    if (inner.format == model::Format::kUrdf) joint.pose.relative_to.value = joint.parent.value;
    rename.explicit_only(joint.parent);
    rename.explicit_only(joint.child);
    rename.explicit_only(joint.pose.relative_to);
    for (model::Axis& axis : joint.axes) rename.explicit_only(axis.expressed_in);
  }
  for (const Id<model::Frame> id : inner.frames) {
    model::Frame& frame = root.frames[id.value];
    frame.model = outer_id;
    rename.or_default(frame.attached_to);
    rename.explicit_only(frame.pose.relative_to);
  }
  for (const auto* models : {&inner.models, &inner.merged_models}) {
    for (const Id<model::Model> id : *models) {
      model::Model& nested = root.models[id.value];
      nested.parent = outer_id;
      rename.or_default(nested.pose.relative_to);
    }
  }
  for (model::Plugin& plugin : root.plugins) {
    if (plugin.model == inner_id) plugin.model = outer_id;
  }
  outer.models.erase(std::remove(outer.models.begin(), outer.models.end(), inner_id),
                     outer.models.end());
  move_ids(inner.links, outer.links);
  move_ids(inner.joints, outer.joints);
  move_ids(inner.frames, outer.frames);
  move_ids(inner.models, outer.models);
  move_ids(inner.merged_models, outer.merged_models);
  outer.merged_models.push_back(inner_id);
}

}  // namespace rigor::read
