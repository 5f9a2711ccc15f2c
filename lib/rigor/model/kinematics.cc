// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Forward kinematics: at given joint positions a link is displaced by D (in the frame of the poses)
// from where it is at zero, and all that is fixed to it is displaced with it.

#include <cstdint>
#include <optional>
#include <vector>

#include <rigor/model/frames.h>

namespace rigor::model {

class JointMover {
 public:
  JointMover(Frames& frames, const Root& root) : frames_(frames), root_(root) {}

  void move(const JointPositions& positions) {
    std::vector<Id<Joint>> moved_by(root_.links.size());
    for (std::size_t i = root_.joints.size(); i-- > 0;) {  // of two parents the first one drives
      const Id<Link> child = frames_.ends_[i].child;
      if (child) moved_by[child.value] = {static_cast<std::uint32_t>(i)};
    }
    std::vector<std::optional<Pose>> displaced(root_.links.size());
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      displacement({i}, moved_by, positions, displaced);
    }
    const auto displace = [](std::optional<Pose>& X, const std::optional<Pose>& D) {
      if (X && D) X = compose(*D, *X);
    };
    for (std::size_t i = 0; i < root_.joints.size(); ++i) {
      // A joint's frame is fixed to its child in SDF, to its parent in URDF.
      const Frames::Ends& ends = frames_.ends_[i];
      const Id<Link> carrier = in_urdf(root_.joints[i]) ? ends.parent : ends.child;
      if (!carrier) continue;
      displace(frames_.joints_[i], displaced[carrier.value]);
      for (auto& axis : frames_.axes_[i]) {
        if (axis && displaced[carrier.value]) {
          axis = rotate(displaced[carrier.value]->rotation, *axis);
        }
      }
    }
    const auto displace_parts = [&](const auto& parts, Frames::Poses& poses) {
      for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].link) displace(poses[i], displaced[parts[i].link.value]);
      }
    };
    displace_parts(root_.collisions, frames_.collisions_);
    displace_parts(root_.visuals, frames_.visuals_);
    displace_parts(root_.sensors, frames_.sensors_);
    displace_parts(root_.lights, frames_.lights_);
    for (std::size_t i = 0; i < root_.frames.size(); ++i) {
      const Id<Link> carrier = frames_.carriers_[i];
      if (carrier) displace(frames_.frames_[i], displaced[carrier.value]);
    }
    for (std::size_t i = 0; i < root_.models.size(); ++i) {
      const Id<Link> canonical = frames_.canonical_[i];
      if (canonical) displace(frames_.models_[i], displaced[canonical.value]);
    }
    for (std::size_t i = 0; i < root_.links.size(); ++i) displace(frames_.links_[i], displaced[i]);
  }

 private:
  void displacement(Id<Link> link, const std::vector<Id<Joint>>& moved_by,
                    const JointPositions& positions,
                    std::vector<std::optional<Pose>>& displaced) const {
    std::vector<Id<Link>> chain;  // from the link up to one that is known, or that nothing moves
    Id<Link> at = link;
    while (at && !displaced[at.value] && chain.size() <= root_.links.size()) {
      chain.push_back(at);
      const Id<Joint> joint = moved_by[at.value];
      at = joint ? frames_.ends_[joint.value].parent : Id<Link>{};
    }
    if (chain.size() > root_.links.size()) return;  // a loop of joints has no tree to move along
    for (; !chain.empty(); chain.pop_back()) {
      const Id<Link> current = chain.back();
      const Id<Joint> joint = moved_by[current.value];
      Pose D;
      if (joint) {
        const Id<Link> parent = frames_.ends_[joint.value].parent;
        if (parent && displaced[parent.value]) D = *displaced[parent.value];
        D = compose(D, motion(joint, positions));
      }
      displaced[current.value] = D;
    }
  }

  /// What a joint's positions do to its child, in the top frame.
  Pose motion(Id<Joint> id, const JointPositions& positions) const {
    const auto found = positions.find(scoped_name(root_, id));
    if (found == positions.end()) return {};
    Pose D;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& axis = frames_.axes_[id.value][k];
      const auto& X_TJ = frames_.joints_[id.value];
      if (!axis || !X_TJ) continue;
      const double q = found->second[k];
      Pose step;
      if (root_[id].type == JointType::kPrismatic) {
        step.translation = q * *axis;
      } else {
        // Turning about an axis through the joint's origin o: x ↦ R (x - o) + o.
        const Vector3 o = X_TJ->translation;
        step.rotation = from_axis_angle(*axis, q);
        step.translation = o - rotate(step.rotation, o);
      }
      D = compose(D, step);
    }
    return D;
  }

  bool in_urdf(const Joint& joint) const {
    return joint.model && root_[joint.model].format == Format::kUrdf;
  }

  Frames& frames_;
  const Root& root_;
};

void Frames::move_joints(const Root& root, const JointPositions& positions) {
  JointMover(*this, root).move(positions);
}

}  // namespace rigor::model
