// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/sdformat_robot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <variant>

#include <rigor/mass/resolve.h>
#include <rigor/rules/kinematics/tree.h>
#include <rigor/rules/sdformat_inertia.h>

namespace rigor::rules {
namespace {

/// What libsdformat takes for no mass, kg.
constexpr double kNoMass = 1e-6;

using Part = SdformatRobot::Part;
using Fate = SdformatRobot::Fate;

/// As urdfdom reads it: what is not whole is zero from there on, and stays an inertial.
mass::MassProperties inertial_of_urdfdom(const model::Inertial& inertial) {
  if (!inertial.mass.written || !std::isfinite(inertial.mass.value)) return {};
  if (inertial.pose.malformed) return {};
  mass::MassProperties body{inertial.mass.value, {}, {}};
  const std::array entries{&inertial.ixx, &inertial.ixy, &inertial.ixz,
                           &inertial.iyy, &inertial.iyz, &inertial.izz};
  if (std::all_of(entries.begin(), entries.end(), [](const auto* entry) {
        return entry->written && std::isfinite(entry->value);
      })) {
    body.about_com = mass::tensor(inertial);
  }
  return mass::transformed(inertial.pose.pose.value, body);
}

/// The fixed joints that a `<gazebo>` block keeps from being lumped away.
std::set<std::string_view> kept_fixed_joints(const model::Root& root) {
  std::set<std::string_view> kept;
  for (const model::GazeboBlock& block : root.gazebo_blocks) {
    if (!root.own(block.site)) continue;
    for (const char* name : {"preserveFixedJoint", "disableFixedJointLumping"}) {
      const auto* flag = find(block.content, name);
      if (flag != nullptr && is_true(*flag)) kept.insert(block.reference.value);
    }
  }
  return kept;
}

class SdformatConversion {
 public:
  SdformatConversion(const model::Root& root, const model::Frames& frames)
      : root_(root), robot_(root.models.front()) {
    result_.parts.resize(robot_.links.size());
    children_.resize(robot_.links.size());
    parents_.resize(robot_.links.size(), kUnchecked);
    result_.known = connect(frames);
  }

  SdformatRobot run() {
    if (!result_.known) return {};
    kept_ = kept_fixed_joints(root_);
    order();
    lump();
    leave_out();
    return std::move(result_);
  }

 private:
  static constexpr std::size_t kUnchecked = static_cast<std::size_t>(-1);

  /// Whether the links are a tree. Loops beside it hang on nothing, and urdfdom does not see them.
  bool connect(const model::Frames& frames) {
    const Tree tree = tree_of(root_, frames, robot_);
    if (!tree.complete) return false;
    std::vector<std::size_t> place(root_.links.size(), kUnchecked);
    for (std::size_t i = 0; i < robot_.links.size(); ++i) place[robot_.links[i].value] = i;
    std::size_t roots = 0;
    for (std::size_t i = 0; i < tree.parents.size(); ++i) {
      if (tree.parents[i].size() > 1) return false;
      if (tree.parents[i].empty()) {
        root_link_ = i;
        ++roots;
        continue;
      }
      const auto joint = tree.parents[i].front();
      result_.parts[i].joint = joint;
      parents_[i] = place[frames.ends(joint).parent.value];
      children_[parents_[i]].push_back(i);
    }
    return roots == 1;
  }

  /// Parents before their children.
  void order() {
    order_.push_back(root_link_);
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const auto& next = children_[order_[i]];
      order_.insert(order_.end(), next.begin(), next.end());
    }
  }

  std::string_view name(std::size_t link) const { return root_[robot_.links[link]].name.value; }

  bool lumped(std::size_t link) const {
    const Part& part = result_.parts[link];
    if (!part.joint || name(parents_[link]) == "world") return false;
    const model::Joint& joint = root_[part.joint];
    return joint.type == model::JointType::kFixed && !kept_.contains(joint.name.value);
  }

  void lump() {
    for (const std::size_t link : order_) {
      const model::Inertial& inertial = root_[robot_.links[link]].inertial;
      Part& part = result_.parts[link];
      part.has_inertial = inertial.written;
      if (inertial.written) part.body = inertial_of_urdfdom(inertial);
      part.head = lumped(link) ? result_.parts[parents_[link]].head : link;
    }
    for (auto at = order_.rbegin(); at != order_.rend(); ++at) {
      const Part& part = result_.parts[*at];
      if (part.head == *at || !part.has_inertial) continue;
      Part& parent = result_.parts[parents_[*at]];
      const model::Pose& X_PC = root_[part.joint].pose.pose.value;
      parent.body = mass::add(parent.body, mass::transformed(X_PC, part.body));
      parent.has_inertial = true;
    }
  }

  void leave_out() {
    std::vector<bool> reached(robot_.links.size(), false);
    for (const std::size_t link : order_) {
      if (parents_[link] != kUnchecked && !reached[parents_[link]]) continue;
      Part& part = result_.parts[link];
      const bool is_world = name(link) == "world";
      if (!is_world && (!part.has_inertial || !(std::abs(part.body.mass) > kNoMass))) continue;
      reached[link] = true;
      if (is_world && link == root_link_) continue;  // the world is no link of the model
      part.fate = part.head == link ? Fate::kLink : Fate::kLumped;
      result_.links += part.head == link ? 1 : 0;
    }
  }

  const model::Root& root_;
  const model::Model& robot_;
  SdformatRobot result_;
  std::set<std::string_view> kept_;
  std::vector<std::vector<std::size_t>> children_;
  std::vector<std::size_t> parents_;
  std::vector<std::size_t> order_;
  std::size_t root_link_ = 0;
};

}  // namespace

bool SdformatRobot::refuses_inertia(std::size_t link) const {
  if (!known) return false;
  const Part& head = parts[parts[link].head];
  return head.fate == Fate::kLink && !sdformat_takes(head.body.mass, head.body.about_com);
}

SdformatRobot sdformat_robot(const model::Root& root, const model::Frames& frames) {
  if (root.format != model::Format::kUrdf || root.models.empty()) return {};
  return SdformatConversion(root, frames).run();
}

}  // namespace rigor::rules
