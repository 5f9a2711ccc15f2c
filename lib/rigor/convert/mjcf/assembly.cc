// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/mjcf/assembly.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include <rigor/convert/bullet_urdf.h>
#include <rigor/convert/mjcf/draft.h>
#include <rigor/mass/nearest.h>
#include <rigor/mass/resolve.h>
#include <rigor/model/unique_names.h>
#include <rigor/robot/lumping.h>

namespace rigor::convert {
namespace {

using model::JointType;
using model::Pose;
using robot::kNoIndex;
using robot::Robot;

/// The links without mass that move weigh this share of the robot together: a tenth of what a comparison of
/// masses lets pass.
constexpr double kMasslessShare = 1e-10;
/// kg, of a robot that weighs nothing at all.
constexpr double kWeightlessRobot = 1;
/// kg: below it MuJoCo rejects the inertia that goes with it.
constexpr double kMinMasslessLink = 1e-12;

/// Each link on fixed joints → the first body above it that moves, or that nothing carries.
std::map<std::string, std::string> lumped(const Robot& robot) {
  std::vector<std::uint32_t> holder(robot.bodies.size(), kNoIndex);
  std::map<std::string, std::string> held_by;
  for (const std::uint32_t i : robot.order) {
    holder[i] = i;
    const std::uint32_t carrier = robot.bodies[i].carrier;
    if (carrier == kNoIndex || robot.joints[carrier].type != JointType::kFixed) continue;
    const std::uint32_t parent = robot.joints[carrier].parent;
    if (robot.bodies[parent].name == robot::kWorldBody) continue;
    holder[i] = holder[parent];
    held_by.emplace(robot.bodies[i].name, robot.bodies[holder[i]].name);
  }
  return held_by;
}

class MjcfAssembler {
 public:
  MjcfAssembler(const MjcfSource& source, const MjcfOptions& options)
      : source_(source), options_(options), entities_(source.source.root) {}

  MjcfAssembly assemble(const std::vector<model::Id<model::Model>>& models) {
    for (std::uint32_t i = 0; i < models.size(); ++i) {
      Robot robot =
          robot_of(source_.source.root, source_.source.frames, models[i], source_.lookups);
      if (source_.source.root.format == model::Format::kUrdf) read_as_bullet(robot);
      const bool fixes = robot.is_static.value_or(false) || options_.base == MjcfBase::kWorld;
      result_.any_static |= robot.is_static.value_or(false);
      if (robot.is_static.value_or(false)) freeze(robot);
      if (options_.fixed == MjcfFixed::kLump) lump(robot);
      add(robot, i, models.size() > 1 ? robot.name + "::" : std::string(), fixes);
    }
    add_world();
    robot::connect(result_.robot);
    move_inertias();
    return std::move(result_);
  }

 private:
  void read_as_bullet(Robot& robot) const {
    for (robot::Joint& joint : robot.joints) {
      const model::Joint* source = entities_.joint(joint.span);
      if (source == nullptr || !is_spherical(*source)) continue;
      joint.type = JointType::kBall;
      joint.axes = ball_axes();
    }
    for (robot::Body& body : robot.bodies) {
      const model::Link* link = entities_.link(body.span);
      if (link == nullptr || !has_incomplete_inertia(*link)) continue;
      const model::Inertial& inertial = link->inertial;
      body.mass = mass::transformed(inertial.pose.pose.value,
                                    {inertial.mass.value, {}, mass::tensor(inertial)});
    }
  }

  /// As a robot has them of a ball: yaw, pitch and roll, without limits.
  static std::vector<robot::Axis> ball_axes() {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    std::vector<robot::Axis> axes;
    for (const model::Vector3& d : {model::Vector3{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}) {
      axes.push_back({.direction = d, .lower = -kEndless, .upper = kEndless});
      axes.back().effort = axes.back().velocity = kEndless;
    }
    return axes;
  }

  /// Whatever its joints are, a static model does not move.
  static void freeze(Robot& robot) {
    for (robot::Joint& joint : robot.joints) {
      if (joint.closes_loop) continue;
      joint.type = JointType::kFixed;
      joint.axes.clear();
    }
  }

  void lump(Robot& robot) {
    std::map<std::string, std::string> held_by = lumped(robot);
    robot = robot::with_embedded(robot, held_by);
    result_.held_by.merge(held_by);
  }

  void add(const Robot& robot, std::uint32_t model, const std::string& prefix, bool fixes) {
    Robot& all = result_.robot;
    if (all.name.empty()) all.name = robot.name;
    const Pose X_WM = robot.X_WM.value_or(Pose{});
    std::vector<std::uint32_t> index(robot.bodies.size(), kNoIndex);
    std::vector<std::uint32_t> roots;
    for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
      robot::Body body = robot.bodies[i];
      const bool is_root = body.carrier == kNoIndex;
      if (is_root && body.name == robot::kWorldBody) {
        index[i] = kWorld;
        world_parts(std::move(body));
        continue;
      }
      index[i] = static_cast<std::uint32_t>(all.bodies.size());
      body.name = body_names_.add(prefix + body.name);
      body.X_MB = compose(X_WM, body.X_MB);
      all.bodies.push_back(std::move(body));
      result_.model_of.push_back(model);
      if (is_root) roots.push_back(index[i]);
    }
    for (robot::Joint joint : robot.joints) {
      // What it couples says so itself.
      if (joint.type == JointType::kGearbox && joint.closes_loop) continue;
      joint.name = joint_names_.add(prefix + joint.name);
      joint.parent = index[joint.parent];
      joint.child = index[joint.child];
      if (joint.parent == kWorld) joint.X_PJ = compose(X_WM, joint.X_PJ);
      for (robot::Axis& axis : joint.axes) {
        if (axis.follow) axis.follow->joint = prefix + axis.follow->joint;
      }
      all.joints.push_back(std::move(joint));
    }
    for (robot::Frame frame : robot.frames) {
      if (frame.body == kNoIndex) continue;
      frame.body = index[frame.body];
      frame.name = prefix + frame.name;
      if (frame.body == kWorld) frame.X_BF = compose(X_WM, frame.X_BF);
      all.frames.push_back(std::move(frame));
    }
    for (const std::string& unknown : robot.unknown) all.unknown.push_back(prefix + unknown);
    if (!fixes) return;
    for (const std::uint32_t root : roots) fix_to_world(root);
  }

  void fix_to_world(std::uint32_t root) {
    robot::Joint joint;
    joint.type = JointType::kFixed;
    joint.parent = kWorld;
    joint.child = root;
    joint.X_PJ = result_.robot.bodies[root].X_MB;
    joint.name = joint_names_.add(result_.robot.bodies[root].name + "_to_world");
    result_.robot.joints.push_back(std::move(joint));
  }

  /// A URDF's link of that name may have shapes.
  void world_parts(robot::Body body) {
    const auto move = [](std::vector<robot::Part>& from, std::vector<robot::Part>& to) {
      std::move(from.begin(), from.end(), std::back_inserter(to));
    };
    move(body.collisions, world_.collisions);
    move(body.visuals, world_.visuals);
    if (world_.span.nowhere()) world_.span = body.span;
  }

  void add_world() {
    Robot& all = result_.robot;
    result_.world = static_cast<std::uint32_t>(all.bodies.size());
    world_.name = robot::kWorldBody;
    all.bodies.push_back(std::move(world_));
    result_.model_of.push_back(kNoIndex);
    for (robot::Joint& joint : all.joints) {
      if (joint.parent == kWorld) joint.parent = result_.world;
      if (joint.child == kWorld) joint.child = result_.world;
    }
    for (robot::Frame& frame : all.frames) {
      if (frame.body == kWorld) frame.body = result_.world;
    }
  }

  /// From the leaves up. A sensor's link that somebody gave a mass and a rough tensor is common, and what it
  /// is fixed to moves with it.
  void move_inertias() {
    Robot& robot = result_.robot;
    const std::vector<bool> fixed = fixed_to_world(robot, result_.world);
    for (auto at = robot.order.rbegin(); at != robot.order.rend(); ++at) {
      robot::Body& body = robot.bodies[*at];
      if (*at == result_.world || mass::judge(body.mass).possible()) continue;
      const auto moments = mass::principal_moments(body.mass.about_com);
      if (fixed[*at]) {
        const auto nearest = mass::nearest_possible(body.mass.about_com);
        body.mass.about_com = nearest.value_or(mass::Inertia{});
        body.mass.mass = std::max(body.mass.mass, 0.0);
        result_.moved_inertias.push_back({*at, result_.world, moments});
        continue;
      }
      if (body.carrier == kNoIndex) continue;
      const robot::Joint& joint = robot.joints[body.carrier];
      robot::Body& parent = robot.bodies[joint.parent];
      if (joint.type != JointType::kFixed || !std::isfinite(moments[0])) continue;
      parent.mass = mass::add(parent.mass, mass::transformed(joint.X_PJ, body.mass));
      body.mass = {};
      result_.moved_inertias.push_back({*at, joint.parent, moments});
    }
  }

  static constexpr std::uint32_t kWorld = kNoIndex - 1;  // until its index is known

  const MjcfSource& source_;
  const MjcfOptions& options_;
  MjcfEntities entities_;
  MjcfAssembly result_;
  robot::Body world_;
  model::UniqueNames body_names_, joint_names_;
};

}  // namespace

MjcfAssembly mjcf_assembly(const MjcfSource& source, const MjcfOptions& options,
                           const std::vector<model::Id<model::Model>>& models) {
  return MjcfAssembler(source, options).assemble(models);
}

std::vector<bool> fixed_to_world(const Robot& robot, std::uint32_t world) {
  std::vector<bool> fixed(robot.bodies.size());
  for (const std::uint32_t i : robot.order) {
    const std::uint32_t carrier = robot.bodies[i].carrier;
    fixed[i] =
        i == world || (carrier != kNoIndex && robot.joints[carrier].type == JointType::kFixed &&
                       fixed[robot.joints[carrier].parent]);
  }
  return fixed;
}

double massless_link_mass(const robot::Robot& robot) {
  double total = 0;
  for (const robot::Body& body : robot.bodies) total += std::max(body.mass.mass, 0.0);
  if (!(total > 0) || !std::isfinite(total)) total = kWeightlessRobot;
  const auto count = static_cast<double>(std::max<std::size_t>(robot.bodies.size(), 1));
  return std::pow(10, std::floor(std::log10(kMasslessShare * total / count)));
}

double mjcf_massless_link(const robot::Robot& robot) {
  return std::max(massless_link_mass(robot), kMinMasslessLink);
}

}  // namespace rigor::convert
