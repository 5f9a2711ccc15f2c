// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include <rigor/convert/mjcf/draft.h>
#include <rigor/convert/mjcf/written_robot.h>
#include <rigor/model/subject.h>

namespace rigor::convert {
namespace {

using model::JointType;

MjcfElement moving_joint(const std::string& name, const robot::Axis& axis, std::string_view type) {
  MjcfElement element{"joint"};
  element.set("name", name);
  if (type != "hinge") element.set("type", std::string(type));
  const model::Vector3& d = axis.direction;
  element.set("axis", mjcf_numbers({d.x, d.y, d.z}));
  return element;
}

void set_range(MjcfElement& element, const robot::Axis& axis) {
  if (!(axis.lower < axis.upper)) return;  // one that cannot move is held by an equality
  if (std::isinf(axis.lower) && std::isinf(axis.upper)) return;
  const double lower = std::isinf(axis.lower) ? -kMjcfUnlimited : axis.lower;
  const double upper = std::isinf(axis.upper) ? kMjcfUnlimited : axis.upper;
  element.set("limited", "true");
  element.set("range", mjcf_numbers({lower, upper}));
}

void set_dynamics(MjcfElement& element, const robot::Axis& axis, double armature) {
  if (axis.damping > 0) element.set("damping", mjcf_number(axis.damping));
  if (axis.friction > 0) element.set("frictionloss", mjcf_number(axis.friction));
  if (axis.spring_stiffness > 0) {
    element.set("stiffness", mjcf_number(axis.spring_stiffness));
    if (axis.spring_reference != 0) element.set("springref", mjcf_number(axis.spring_reference));
  }
  if (armature > 0) element.set("armature", mjcf_number(armature));
}

void tell_limits(MjcfDraft& draft, const robot::Joint& joint, const robot::Axis& axis) {
  if (axis.lower < axis.upper) return;
  const model::Joint* source = draft.entities.joint(joint.span);
  if (source == nullptr) return;
  const bool locked = axis.lower == axis.upper;
  draft.ledger.note(
      {.kind = locked ? NoteKind::kMjcfLocked : NoteKind::kLimitInverted,
       .outcome = locked ? Outcome::kRewritten : Outcome::kLost,
       .where = axis.limit_span.nowhere() ? source->site.name : axis.limit_span,
       .subject = model::subject(draft.root(), *source),
       .written = locked ? mjcf_number(axis.lower) : mjcf_numbers({axis.lower, axis.upper})});
}

/// An axis that is not written has no direction.
void tell_axis(MjcfDraft& draft, const robot::Joint& joint, const robot::Axis& axis) {
  const model::Joint* source = draft.entities.joint(joint.span);
  if (source == nullptr || length(axis.direction) > 0) return;
  draft.ledger.note({.kind = NoteKind::kAxisZero,
                     .outcome = Outcome::kLost,
                     .where = axis.span.nowhere() ? source->site.name : axis.span,
                     .subject = model::subject(draft.root(), *source)});
}

void lose_type(MjcfDraft& draft, const robot::Joint& joint) {
  const model::Joint* source = draft.entities.joint(joint.span);
  if (source == nullptr) return;
  draft.ledger.note(
      {.kind = NoteKind::kJointTypeLost,
       .outcome = Outcome::kLost,
       .where = source->type_name.written ? source->type_name.span : source->site.name,
       .subject = model::subject(draft.root(), *source),
       .written = source->type_name.value});
}

/// What represents a joint of several degrees of freedom; empty for one that MuJoCo has.
std::string_view several_joints(const robot::Joint& joint, bool at_top) {
  switch (joint.type) {
    case JointType::kScrew: return "a hinge and a slide that an equality couples";
    case JointType::kUniversal:
    case JointType::kRevolute2: return joint.axes.size() > 1 ? "two hinges" : "";
    case JointType::kPlanar: return "two slides and a hinge";
    case JointType::kFloating: return at_top ? "" : "three slides and a ball";
    default: return "";
  }
}

void tell_type(MjcfDraft& draft, const robot::Joint& joint) {
  const model::Joint* source = draft.entities.joint(joint.span);
  const auto instead = several_joints(joint, joint.parent == draft.assembly.world);
  if (source == nullptr || instead.empty()) return;
  draft.ledger.take(source->type_name, Outcome::kRewritten);
  draft.ledger.note(
      {.kind = NoteKind::kMjcfJointType,
       .outcome = Outcome::kRewritten,
       .where = source->type_name.written ? source->type_name.span : source->site.name,
       .subject = model::subject(draft.root(), *source),
       .written = source->type_name.value,
       .instead = std::string(instead)});
}

/// Three slides and a ball: what `freejoint` is, for a body that is not at the top.
std::vector<MjcfElement> free_joints(MjcfDraft& draft, const std::string& name, bool at_top) {
  if (at_top) return {{"freejoint", {{"name", name}}}};
  std::vector<MjcfElement> joints;
  for (const auto& [end, axis] : {std::pair{"_x", "1 0 0"}, {"_y", "0 1 0"}, {"_z", "0 0 1"}}) {
    joints.push_back(
        {"joint",
         {{"name", draft.name_for("joint", name + end)}, {"type", "slide"}, {"axis", axis}}});
  }
  joints.push_back({"joint", {{"name", name}, {"type", "ball"}}});
  return joints;
}

std::vector<std::string> degree_names(MjcfDraft& draft, const robot::Joint& joint) {
  const auto own = [&](const std::string& end) {
    return draft.name_for("joint", joint.name + end);
  };
  switch (joint.type) {
    case JointType::kFixed:
    case JointType::kUnknown: return {};
    case JointType::kBall:
    case JointType::kFloating: return {own("")};
    case JointType::kUniversal:
    case JointType::kRevolute2:
      if (joint.axes.size() > 1) return {own(""), own("_axis2")};
      return {own("")};
    case JointType::kPlanar: return {own("_slide"), own("_slide2"), own("")};
    default: return {own("")};
  }
}

}  // namespace

std::vector<std::vector<std::string>> mjcf_joint_names(MjcfDraft& draft) {
  std::vector<std::vector<std::string>> names;
  for (const robot::Joint& joint : draft.robot().joints) {
    names.push_back(joint.closes_loop ? std::vector<std::string>() : degree_names(draft, joint));
  }
  return names;
}

std::vector<MjcfElement> mjcf_joints(MjcfDraft& draft, std::uint32_t index) {
  const robot::Joint& joint = draft.robot().joints[index];
  const std::vector<std::string>& names = draft.joint_names[index];
  if (joint.type == JointType::kUnknown) lose_type(draft, joint);
  if (names.empty()) return {};
  tell_type(draft, joint);
  if (joint.type == JointType::kFloating) {
    return free_joints(draft, names[0], joint.parent == draft.assembly.world);
  }
  if (joint.type == JointType::kBall) return {{"joint", {{"name", names[0]}, {"type", "ball"}}}};
  if (joint.axes.empty()) tell_axis(draft, joint, {});
  std::vector<MjcfElement> elements;
  for (std::size_t k = 0; k < joint.axes.size() && k < names.size(); ++k) {
    const robot::Axis& axis = joint.axes[k];
    tell_axis(draft, joint, axis);
    tell_limits(draft, joint, axis);
    if (length(axis.direction) == 0) continue;
    const bool slides = axis.motion == robot::Axis::Motion::kSlide;
    MjcfElement element = moving_joint(names[k], axis, slides ? "slide" : "hinge");
    set_range(element, axis);
    set_dynamics(element, axis, axis.follow ? 0 : draft.options.armature);
    if (axis.motion == robot::Axis::Motion::kScrew) {
      elements.push_back(moving_joint(names[k] + "_slide", axis, "slide"));
    }
    elements.push_back(std::move(element));
  }
  return elements;
}

robot::Positions home_positions(const robot::Robot& robot,
                                const std::map<std::string, double>& given) {
  robot::Positions home;
  for (const robot::Joint& joint : robot.joints) {
    std::vector<double>& own = home.emplace_back();
    const auto named = given.find(joint.name);
    const double wanted = named == given.end() || joint.axes.size() != 1 ? 0 : named->second;
    for (const robot::Axis& axis : joint.axes) {
      const bool bounded = axis.lower <= axis.upper;
      own.push_back(bounded ? std::clamp(wanted, axis.lower, axis.upper) : wanted);
    }
  }
  return robot::followed(robot, std::move(home));
}

}  // namespace rigor::convert
