// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/mjcf_proof.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <rigor/convert/mjcf/written_robot.h>
#include <rigor/mass/nearest.h>
#include <rigor/robot/compare.h>

namespace rigor::author {
namespace {

using convert::Note;
using convert::NoteKind;
using convert::Notes;
using robot::DifferenceKind;
using robot::Robot;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

bool is_primitive(const robot::Part& part) {
  const std::string& kind = part.shape.kind;
  return kind == "box" || kind == "sphere" || kind == "cylinder" || kind == "capsule" ||
         kind == "ellipsoid";
}

void keep_primitives(std::vector<robot::Part>& parts) {
  std::erase_if(parts, [](const robot::Part& part) {
    const auto& n = part.shape.numbers;
    const bool sized = std::all_of(n.begin(), n.end(), [](double each) { return each > 0; });
    return !is_primitive(part) || !sized;
  });
  for (robot::Part& part : parts) part.name.clear(), part.color.reset();
}

/// Of both sides: without what MJCF has nothing to compare with. Meshes are other files, and planes have
/// another size; names of shapes are MJCF's.
void keep_comparable(Robot& robot) {
  for (robot::Body& body : robot.bodies) {
    keep_primitives(body.collisions);
    keep_primitives(body.visuals);
  }
  robot.frames.clear();
  robot.is_static.reset();
}

/// The source as the account says that it is written: inertias that were put right, loops cut.
Robot expected(const convert::MjcfConversion& result) {
  Robot robot = result.robot;
  for (robot::Body& body : robot.bodies) {
    if (mass::judge(body.mass).possible()) continue;
    const auto nearest = mass::nearest_possible(body.mass.about_com);
    if (nearest && body.mass.mass > 0) {
      body.mass.about_com = *nearest;
    } else {
      body.mass = {};
    }
  }
  std::erase_if(robot.joints, [](const robot::Joint& joint) { return joint.closes_loop; });
  robot.X_WM = model::Pose{};
  for (robot::Joint& joint : robot.joints) {
    if (joint.type == model::JointType::kFixed) {
      joint.name = convert::mjcf_fixed_name(robot.bodies[joint.child].name);
    }
    for (robot::Axis& axis : joint.axes) {
      if (axis.lower <= -convert::kMjcfUnlimited) axis.lower = -kNoLimit;
      if (axis.upper >= convert::kMjcfUnlimited) axis.upper = kNoLimit;
    }
  }
  keep_comparable(robot);
  robot::connect(robot);
  return robot;
}

/// Efforts that no actuator has, velocities that nothing limits, and what other notes tell.
bool is_told(const robot::Difference& difference, const std::set<std::string>& driven) {
  switch (difference.kind) {
    case DifferenceKind::kVelocity:
    case DifferenceKind::kColor:
    case DifferenceKind::kStatic:
    case DifferenceKind::kModelPose:
    case DifferenceKind::kPartRenamed: return true;
    case DifferenceKind::kEffort: return !driven.contains(difference.a);
    default: return false;
  }
}

std::string value_words(const robot::DifferenceValue& value, std::string_view unit) {
  if (value.numbers.empty()) return value.text.empty() ? "nothing" : value.text;
  std::string text = fmt::format("{}", fmt::join(value.numbers, " "));
  if (!unit.empty()) text += fmt::format(" {}", unit);
  return text;
}

std::set<std::string> driven_joints(const Robot& written) {
  std::set<std::string> driven;
  for (const robot::Joint& joint : written.joints) {
    if (!joint.axes.empty() && std::isfinite(joint.axes[0].effort)) {
      driven.insert("joint " + joint.name);
    }
  }
  return driven;
}

}  // namespace

Notes prove_mjcf(const convert::MjcfConversion& result, const std::string& text, Span where) {
  std::optional<Robot> written = convert::written_mjcf_robot(text);
  if (!written) {
    return {{.kind = NoteKind::kRefused, .where = where, .written = "no MJCF robot in it"}};
  }
  keep_comparable(*written);
  const Robot before = expected(result);
  robot::Correspondence names;
  names.joints = result.joints;
  for (const Note& note : result.account.notes) {
    const bool about_it =
        note.kind == NoteKind::kLimitInverted || note.kind == NoteKind::kAxisZero ||
        note.kind == NoteKind::kJointTypeLost || note.kind == NoteKind::kMimicLost;
    if (about_it) return {};  // another robot, and the account says so
  }
  const std::set<std::string> driven = driven_joints(*written);
  Notes notes;
  for (const robot::Difference& difference : robot::compare(before, *written, names)) {
    if (is_told(difference, driven)) continue;
    notes.push_back(
        {.kind = NoteKind::kNotTheSame,
         .where = difference.span_a.nowhere() ? where : difference.span_a,
         .subject = difference.a.empty() ? difference.b : difference.a,
         .written = fmt::format("{}: {}, in the result {}", robot::to_string(difference.kind),
                                value_words(difference.from, difference.unit),
                                value_words(difference.to, difference.unit))});
  }
  return notes;
}

}  // namespace rigor::author
