// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/compare.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rigor/robot/compare_parts.h>
#include <rigor/robot/lumping.h>

namespace rigor::robot {
namespace {

/// A generator that is the same on every machine, which the standard library's
/// distributions are not. G. L. Steele, D. Lea, C. H. Flood, "Fast splittable
/// pseudorandom number generators", OOPSLA 2014.
class SplitMix {
 public:
  /// In [0, 1).
  double next() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
  }

 private:
  std::uint64_t state_ = 20;
};

/// In [-1, 1] inside the limits. Where they leave nothing of it, the first unit
/// inside the limits; a joint that is locked is moved all the same, since its
/// axis is to be examined.
double draw_position(SplitMix& random, const Axis& axis) {
  double low = std::max(-1.0, axis.lower), high = std::min(1.0, axis.upper);
  if (axis.lower > 1) low = axis.lower, high = std::min(axis.upper, low + 1);
  if (axis.upper < -1) high = axis.upper, low = std::max(axis.lower, high - 1);
  if (!(low < high)) low = -1, high = 1;
  return low + (high - low) * random.next();
}

}  // namespace

std::vector<Positions> configurations(const Robot& robot, std::size_t count) {
  SplitMix random;
  std::vector<Positions> all{followed(robot, {})};
  for (std::size_t n = 0; n < count; ++n) {
    Positions positions(robot.joints.size());
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      for (const Axis& axis : robot.joints[i].axes) {
        positions[i].push_back(draw_position(random, axis));
      }
    }
    all.push_back(followed(robot, std::move(positions)));
  }
  return all;
}

namespace {

/// A as B should be, by the choices that were made. Nothing where that is A itself.
std::optional<Robot> as_chosen(const Robot& a, const Robot& b, const Correspondence& names) {
  std::set<std::string> in_b;
  for (const Body& body : b.bodies) in_b.insert(plain_name(body.name));
  std::map<std::string, std::string> held_by;
  for (const auto& [body, holder] : names.held_by) {
    const auto given = names.links.find(body);
    const std::string& name = given == names.links.end() ? body : given->second;
    if (!in_b.contains(plain_name(name))) held_by.emplace(body, holder);
  }
  if (held_by.empty() && !names.from_world) return std::nullopt;
  Robot chosen = names.from_world ? in_world(a) : a;
  return held_by.empty() ? chosen : with_embedded(chosen, held_by);
}

/// With the mass of links between joints that represent one in what these carry: the source has no such
/// links. Nothing when they have none.
std::optional<Robot> with_rows_weighed(const Robot& robot, const Match::Side& side) {
  std::optional<Robot> result;
  for (const std::uint32_t i : robot.order) {
    if (!side.silent_body[i] || robot.bodies[i].mass.mass == 0) continue;
    const auto next = std::find_if(robot.joints.begin(), robot.joints.end(),
                                   [i](const Joint& joint) { return joint.parent == i; });
    if (next == robot.joints.end()) continue;
    if (!result) result = robot;
    mass::MassProperties& between = result->bodies[i].mass;
    mass::MassProperties& carried = result->bodies[next->child].mass;
    carried = mass::add(carried, mass::transformed(inverse(next->X_PJ), between));
    between = {};
  }
  return result;
}

}  // namespace

std::vector<Difference> compare(const Robot& written, const Robot& b,
                                const Correspondence& correspondence, const Tolerance& tolerance) {
  const std::optional<Robot> chosen = as_chosen(written, b, correspondence);
  const Robot& a = chosen ? *chosen : written;
  const Match matched = match(a, b, correspondence, tolerance);
  const std::optional<Robot> weighed = with_rows_weighed(b, matched.b);
  const Robot& whole = weighed ? *weighed : b;
  const TwinPoses poses(a, whole, matched, tolerance.configurations);
  const std::vector<BodyShift> shifted = shifts(a, whole, matched, poses, tolerance);
  Comparison comparison{a, whole, b, correspondence, tolerance, matched, poses, shifted};
  comparison.explained.resize(a.bodies.size());
  compare_links(comparison);
  compare_joints(comparison);
  compare_frames(comparison);
  compare_whole(comparison);
  return std::move(comparison.found);
}

std::string_view to_string(DifferenceKind kind) {
  switch (kind) {
    case DifferenceKind::kLinkOnlyInA: return "link-only-in-a";
    case DifferenceKind::kLinkOnlyInB: return "link-only-in-b";
    case DifferenceKind::kLinkRenamed: return "link-renamed";
    case DifferenceKind::kJointOnlyInA: return "joint-only-in-a";
    case DifferenceKind::kJointOnlyInB: return "joint-only-in-b";
    case DifferenceKind::kJointRenamed: return "joint-renamed";
    case DifferenceKind::kFrameOnlyInA: return "frame-only-in-a";
    case DifferenceKind::kFrameOnlyInB: return "frame-only-in-b";
    case DifferenceKind::kCollisionOnlyInA: return "collision-only-in-a";
    case DifferenceKind::kCollisionOnlyInB: return "collision-only-in-b";
    case DifferenceKind::kVisualOnlyInA: return "visual-only-in-a";
    case DifferenceKind::kVisualOnlyInB: return "visual-only-in-b";
    case DifferenceKind::kPartRenamed: return "part-renamed";
    case DifferenceKind::kJointMoved: return "joint-moved";
    case DifferenceKind::kJointMotion: return "joint-motion";
    case DifferenceKind::kJointType: return "joint-type";
    case DifferenceKind::kJointParent: return "joint-parent";
    case DifferenceKind::kJointChild: return "joint-child";
    case DifferenceKind::kJointAxis: return "joint-axis";
    case DifferenceKind::kLower: return "lower-limit";
    case DifferenceKind::kUpper: return "upper-limit";
    case DifferenceKind::kEffort: return "effort";
    case DifferenceKind::kVelocity: return "velocity";
    case DifferenceKind::kDamping: return "damping";
    case DifferenceKind::kFriction: return "friction";
    case DifferenceKind::kSpringReference: return "spring-reference";
    case DifferenceKind::kSpringStiffness: return "spring-stiffness";
    case DifferenceKind::kMimic: return "mimic";
    case DifferenceKind::kLinkMoved: return "link-moved";
    case DifferenceKind::kMass: return "mass";
    case DifferenceKind::kCenterOfMass: return "center-of-mass";
    case DifferenceKind::kInertia: return "inertia";
    case DifferenceKind::kCollisionMoved: return "collision-moved";
    case DifferenceKind::kVisualMoved: return "visual-moved";
    case DifferenceKind::kFrameMoved: return "frame-moved";
    case DifferenceKind::kShape: return "shape";
    case DifferenceKind::kSize: return "size";
    case DifferenceKind::kMesh: return "mesh";
    case DifferenceKind::kColor: return "color";
    case DifferenceKind::kTotalMass: return "total-mass";
    case DifferenceKind::kTotalFirst: return "total-first-moment";
    case DifferenceKind::kTotalSecond: return "total-second-moment";
    case DifferenceKind::kWorldPose: return "world-pose";
    case DifferenceKind::kModelPose: return "model-pose";
    case DifferenceKind::kRootPose: return "root-pose";
    case DifferenceKind::kStatic: return "static";
    case DifferenceKind::kSetting: return "setting";
    case DifferenceKind::kAttachmentOnlyInA: return "attachment-only-in-a";
    case DifferenceKind::kAttachmentOnlyInB: return "attachment-only-in-b";
  }
  return "difference";
}

}  // namespace rigor::robot
