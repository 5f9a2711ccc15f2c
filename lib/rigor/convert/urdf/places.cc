// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/places.h>

#include <variant>

namespace rigor::convert {

using model::Id;
using model::Pose;

UrdfPlaces::UrdfPlaces(const model::Root& root, const model::Frames& frames, Id<model::Model> model)
    : root_(root), frames_(frames), model_(model), X_WM_(frames.pose(model).value_or(Pose{})) {
  if (!(X_WM_ == Pose{})) X_MW_ = inverse(X_WM_);
}

bool UrdfPlaces::is_in_model_frame(const model::PoseField& pose, Id<model::Model> scope) const {
  return scope == model_ && root_[scope].format == model::Format::kSdf &&
         (pose.relative_to.value.empty() || pose.relative_to.value == "__model__");
}

Pose UrdfPlaces::in_model(const Pose& X_W) const {
  return X_MW_ == Pose{} ? X_W : compose(X_MW_, X_W);
}

Pose UrdfPlaces::X_M(Id<model::Link> link) const {
  const model::Link& written = root_[link];
  if (is_in_model_frame(written.pose, written.model)) return written.pose.pose.value;
  return in_model(*frames_.pose(link));
}

Pose UrdfPlaces::X_M(Id<model::Frame> frame) const { return in_model(*frames_.pose(frame)); }

Pose UrdfPlaces::X_M(Id<model::Joint> joint) const {
  const model::Joint& written = root_[joint];
  const Id<model::Link> child = frames_.ends(joint).child;
  if (child && is_in_link_frame(written, child)) {
    const Pose X_ML = X_M(child);
    return written.pose.pose.value == Pose{} ? X_ML : compose(X_ML, written.pose.pose.value);
  }
  return in_model(*frames_.pose(joint));
}

Pose UrdfPlaces::X_L(Id<model::Joint> joint, Id<model::Link> child) const {
  if (is_in_link_frame(root_[joint], child)) return root_[joint].pose.pose.value;
  return compose(inverse(X_M(child)), X_M(joint));
}

bool UrdfPlaces::is_in_link_frame(const model::Joint& joint, Id<model::Link> child) const {
  if (!joint.model || root_[joint.model].format != model::Format::kSdf) return false;
  const std::string& frame = joint.pose.relative_to.value;
  const model::Named named =
      frames_.names().find({joint.model, {}}, frame.empty() ? joint.child.value : frame);
  const auto* link = std::get_if<Id<model::Link>>(&named);
  return link != nullptr && *link == child;
}

}  // namespace rigor::convert
