// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The kinematics of a robot against that of `model::Frames`, which moves displacements in the top frame
// instead of chaining joint frames.

#include <variant>

#include <robot/robots.h>
#include "support/corpus.h"

namespace rigor::test {
namespace {

using model::Id;
using model::JointType;

/// m and rad, for models of less than a hundred meters.
constexpr double kSamePose = 1e-9;

/// What `Frames` moves as a robot does.
bool moves_alike(const robot::Robot& robot) {
  return std::none_of(robot.joints.begin(), robot.joints.end(), [](const auto& joint) {
    return joint.closes_loop || joint.type == JointType::kScrew || joint.type == JointType::kBall ||
           joint.type == JointType::kPlanar || joint.type == JointType::kGearbox;
  });
}

model::JointPositions named(const robot::Robot& robot, const std::string& model,
                            const robot::Positions& positions) {
  model::JointPositions result;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    auto& both = result[model + "::" + robot.joints[i].name];
    for (std::size_t k = 0; k < positions[i].size(); ++k) both[k] = positions[i][k];
  }
  return result;
}

/// How many collisions were held against each other.
/// Frames move what a joint names as its child; a robot whose joint hangs the other way round moves the
/// parent instead (turned_joints_test.cc).
bool has_turned_joint(const model::Root& root, const model::Frames& frames,
                      const robot::Robot& robot, Id<model::Model> top) {
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const std::string name = scoped_name(root, Id<model::Joint>{i});
    const model::Frames::Ends& ends = frames.ends(Id<model::Joint>{i});
    if (ends.child.value >= root.links.size()) continue;
    for (const robot::Joint& joint : robot.joints) {
      if (scoped_name(root, top) + "::" + joint.name != name) continue;
      const std::string child = scoped_name(root, top) + "::" + robot.bodies[joint.child].name;
      if (child != scoped_name(root, ends.child)) return true;
    }
  }
  return false;
}

std::size_t hold(const model::Root& root, Id<model::Model> top) {
  const model::Frames at_rest(root);
  const robot::Robot robot = robot::robot_of(root, at_rest, top);
  if (!robot.unknown.empty() || !moves_alike(robot)) return 0;
  if (has_turned_joint(root, at_rest, robot, top)) return 0;
  std::size_t count = 0;
  for (const robot::Positions& positions : robot::configurations(robot, 3)) {
    const model::Frames frames(root, named(robot, scoped_name(root, top), positions));
    const auto X_MB = body_poses(robot, positions);
    const model::Pose X_WM = robot.X_WM.value_or(model::Pose{});
    std::size_t body = 0;  // in the order of the file, as the robot's
    for (std::uint32_t i = 0; i < root.links.size(); ++i) {
      const std::string name = scoped_name(root, Id<model::Link>{i});
      if (!name.starts_with(scoped_name(root, top) + "::")) continue;
      for (std::size_t n = 0; n < root.links[i].collisions.size(); ++n) {
        const auto X_WC = frames.pose(root.links[i].collisions[n]);
        const model::Pose own =
            compose(X_WM, compose(X_MB[body], robot.bodies[body].collisions[n].X_BS));
        const model::Quaternion turn = conjugate(X_WC->rotation) * own.rotation;
        const double reach = std::max(100.0, length(own.translation)) / 100;
        EXPECT_LT(length(X_WC->translation - own.translation), kSamePose * reach) << name;
        EXPECT_LT(length(model::Vector3{turn.x, turn.y, turn.z}), kSamePose) << name;
        ++count;
      }
      ++body;
    }
  }
  return count;
}

TEST(RobotMotion, AgreesWithFramesOverTheCorpus) {
  RIGOR_NEEDS_CORPUS();
  const auto sdf = std::get<schema::Schema>(schema::Schema::parse(schema::sdf_schema_text()));
  const auto urdf = std::get<schema::Schema>(schema::Schema::parse(schema::urdf_schema_text()));
  const RealDisk disk;
  const read::Resolver resolver(disk, {});
  std::size_t models = 0, collisions = 0;
  for (const std::string& path : corpus_models()) {
    Sources sources;
    read::Workspace workspace(disk, sources);
    const read::File& file = workspace.open(path);
    if (!file.document) continue;
    const read::Loaded loaded = read::load({workspace, resolver, sdf, urdf}, file);
    if (loaded.root.models.empty() || loaded.root.joints.empty()) continue;
    const auto of_world = [](const model::Joint& joint) { return !joint.model; };
    if (std::any_of(loaded.root.joints.begin(), loaded.root.joints.end(), of_world)) continue;
    SCOPED_TRACE(path);
    const std::size_t held = hold(loaded.root, {0});
    if (held > 0) ++models;
    collisions += held;
  }
  EXPECT_GT(models, 100U);
  RecordProperty("models", static_cast<int>(models));
  RecordProperty("collisions", static_cast<int>(collisions));
}

}  // namespace
}  // namespace rigor::test
