// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/mount.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <rigor/simulate/footprint.h>
#include <rigor/simulate/joint_load.h>
#include <rigor/simulate/metric/parts.h>
#include <rigor/simulate/reach.h>
#include <rigor/text/disjoint_sets.h>

namespace rigor::simulate {
namespace {

/// A slope of 1 in 20 throws it over: that is balancing, as a biped on two points does, and not standing.
constexpr double kStandAngle = 0.05;  // rad

/// A boom, a drawer and a lid are one joint.
constexpr std::size_t kJointsOfArm = 2;

constexpr const char* kAboutJoints = "the test is about the joints";

std::uint32_t free_model(const Scene& scene) {
  for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
    if (stands_free(scene, m)) return m;
  }
  return kWorld;
}

bool has_joint_to_move(const Scene& scene, std::uint32_t model) {
  return std::any_of(scene.joints.begin(), scene.joints.end(), [&](const SceneJoint& joint) {
    return can_be_commanded(joint) && joint.child < scene.bodies.size() &&
           scene.bodies[joint.child].model == model;
  });
}

/// An arm that the world holds stands on a table of which the file says nothing: its ground is not ours.
bool reaches_below_ground(const Scene& scene) {
  for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
    const bool moves = !scene.models[m].is_static && has_joint_to_move(scene, m);
    if (moves && lowest_of_model(scene, m) < -kFootSlack) return true;
  }
  return false;
}

bool stands_on(const Scene& scene, std::uint32_t model, double slack) {
  const std::vector<Vector3> corners = footprint_at_start(scene, model, slack);
  return corners.size() >= 3 && tip_angle(scene, model, corners).angle > kStandAngle;
}

double feet_slack(const Scene& scene) { return std::max(kFootSlack, kFeetSlack * scene.size); }

/// Legs and the like reach the ground with more than the base.
bool stands_on_its_base(const Scene& scene, std::uint32_t model) {
  const LowestPoints lowest(scene);
  const double ground = lowest.of_model[model] + feet_slack(scene);
  for (std::uint32_t b = 0; b < scene.bodies.size(); ++b) {
    const bool other = scene.bodies[b].model == model && b != scene.models[model].base;
    if (other && lowest.of_body[b] <= ground) return false;
  }
  return true;
}

/// How many joints in a row motors move, from the base to the farthest link.
std::size_t longest_chain(const Scene& scene, std::uint32_t base) {
  const CarriedBodies carried(scene);
  std::vector<std::size_t> joints(scene.bodies.size());
  const std::vector<std::uint32_t> outward = carried.by(base);  // parents come before children
  std::size_t longest = 0;
  for (const std::uint32_t body : outward) {
    for (const std::uint32_t j : carried.joints_on(body)) {
      const SceneJoint& joint = scene.joints[j];
      if (joints[joint.child] > 0) continue;
      joints[joint.child] = joints[body] + (can_be_commanded(joint) ? 1 : 0);
      longest = std::max(longest, joints[joint.child]);
    }
  }
  return longest;
}

/// Whether one joint alone moves all that the base carries.
bool has_one_branch(const Scene& scene, std::uint32_t base) {
  return std::count_if(scene.joints.begin(), scene.joints.end(), [&](const SceneJoint& joint) {
           return joint.parent == base && can_be_commanded(joint);
         }) == 1;
}

/// An arm is several joints in a row, the only ones of its base; or it stands on its base alone, which would stand
/// without what it carries. What stands on nothing that has an area is used in a frame or on a flange. Where there are
/// feet, it falls for want of balance.
bool is_made_to_be_held(const Scene& scene, std::uint32_t model, double slack) {
  const std::vector<Vector3> corners = footprint_at_start(scene, model, slack);
  if (corners.size() < 3 || tip_angle(scene, model, corners).angle > 0) return true;
  const std::uint32_t index = scene.models[model].base;
  const SceneBody& base = scene.bodies[index];
  if (longest_chain(scene, index) < kJointsOfArm) return false;
  return has_one_branch(scene, index) ||
         (stands_on_its_base(scene, model) &&
          margin_in(corners, transform(base.X_WB, base.mass.com)).distance > 0);
}

bool has_any_shape(const Scene& scene, std::uint32_t model) {
  return std::any_of(scene.shapes.begin(), scene.shapes.end(), [&](const SceneShape& shape) {
    return shape.body < scene.bodies.size() && scene.bodies[shape.body].model == model;
  });
}

}  // namespace

bool stands_by_itself(const Scene& scene, std::uint32_t model) {
  return stands_on(scene, model, feet_slack(scene));
}

bool is_to_be_bolted(const Scene& scene, std::uint32_t model, const DriveTrain& wheels) {
  if (!wheels.empty() || !has_joint_to_move(scene, model)) return false;
  return !stands_by_itself(scene, model) || stands_on_its_base(scene, model);
}

bool needs_free_base(std::string_view test) {
  constexpr std::array<std::string_view, 6> kTests{"drop",  "drive", "turn",
                                                   "brake", "push",  "tilt-table"};
  return std::find(kTests.begin(), kTests.end(), test) != kTests.end();
}

MountChoice choose_mount(std::string_view test, const Scene& scene, const DriveTrain& wheels) {
  if (!scene.alone || !wheels.empty()) return {};
  const std::uint32_t model = free_model(scene);
  // An arm that is bolted down already swings past the edge of what it is bolted to.
  if (model == kWorld && test == "joint-sweep") return {Base::kHang, kAboutJoints, false};
  if (model == kWorld && reaches_below_ground(scene)) {
    return {Base::kHang, "it is fixed to the world and reaches below its base", false};
  }
  if (model == kWorld || !has_joint_to_move(scene, model)) return {};
  const bool drives = test == "drive" || test == "turn" || test == "brake";
  if (drives) return {};  // without wheels there is another reason to leave it out
  if (test == "joint-sweep") return {Base::kHang, kAboutJoints, false};
  // What nothing can hold falls, and is to be said so.
  if (test == "settle" && !has_any_shape(scene, model)) return {};
  // Feet may differ in height by a little, and find the ground. A rigid base rocks.
  const bool rigid = stands_on_its_base(scene, model);
  const double slack = rigid ? kFootSlack : feet_slack(scene);
  if (stands_on(scene, model, slack)) return {};
  return {Base::kHang, "its center of mass is not above what it stands on",
          !is_made_to_be_held(scene, model, slack)};
}

Scene mounted(const Scene& scene, Base base) {
  Scene held = scene;
  if (base == Base::kFree) return held;
  const auto world = static_cast<std::uint32_t>(scene.bodies.size());
  DisjointSets joined(scene.bodies.size() + 1);
  for (const SceneJoint& joint : scene.joints) {
    joined.join(std::min(joint.parent, world), std::min(joint.child, world));
  }
  const auto hold = [&](std::uint32_t body) {
    if (body >= world || scene.models[scene.bodies[body].model].is_static) return;
    if (!joined.join(body, world)) return;
    SceneJoint joint;
    joint.name = scene.bodies[body].name + "::mount";
    joint.type = model::JointType::kFixed;
    joint.child = body;
    joint.anchor_W = transform(scene.bodies[body].X_WB, scene.bodies[body].mass.com);
    joint.model = scene.bodies[body].model;
    joint.where = scene.bodies[body].where;
    held.joints.push_back(std::move(joint));
  };
  for (const SceneModel& model : scene.models) hold(model.base);
  for (std::uint32_t body = 0; body < world; ++body) hold(body);
  return held;
}

}  // namespace rigor::simulate
