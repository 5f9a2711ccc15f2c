// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <rigor/read/joint_type.h>
#include <rigor/read/sdf_reader.h>

namespace rigor::read {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What an absent `<effort>` or `<velocity>` means: zero in 1.0 and 1.2, then -1 as a sign for
/// "no limit", from 1.10 infinity.
double unlimited(int version) { return version < 3 ? 0 : version < 10 ? -1 : kInfinity; }

/// What an absent `<lower>` (negated) or `<upper>` means.
double unbounded(int version) { return version < 10 ? 1e16 : kInfinity; }

model::Mimic read_mimic(xml::Element element) {
  model::Mimic mimic;
  mimic.site = site_of(element);
  mimic.joint = string_field(attribute_text(element, "joint"));
  mimic.axis = string_field(attribute_text(element, "axis"), "axis");
  mimic.multiplier = number_field(child_text(element, "multiplier"), 1);
  mimic.offset = number_field(child_text(element, "offset"), 0);
  mimic.reference = number_field(child_text(element, "reference"), 0);
  return mimic;
}

/// In SDF 1.0 `<parent link="a"/>`, later `<parent>a</parent>`.
model::Field<std::string> link_name(xml::Element joint, std::string_view which) {
  const auto element = joint.child(which);
  if (!element) return {};
  if (const auto link = value_attribute(*element, "link")) return string_field(link);
  return string_field(Text{element->text(), element->text_span()});
}

bool is_implicit(xml::Element joint) {
  const auto physics = joint.child("physics");
  const auto ode = physics ? physics->child("ode") : std::nullopt;
  return ode && (bool_field(child_text(*ode, "implicit_spring_damper"), false).value ||
                 bool_field(child_text(*ode, "cfm_damping"), false).value);
}

}  // namespace

model::JointType joint_type(std::string_view name) {
  using model::JointType;
  constexpr std::array<std::pair<std::string_view, JointType>, 11> kTypes{{
      {"fixed", JointType::kFixed},
      {"revolute", JointType::kRevolute},
      {"continuous", JointType::kContinuous},
      {"prismatic", JointType::kPrismatic},
      {"ball", JointType::kBall},
      {"universal", JointType::kUniversal},
      {"revolute2", JointType::kRevolute2},
      {"screw", JointType::kScrew},
      {"gearbox", JointType::kGearbox},
      {"floating", JointType::kFloating},
      {"planar", JointType::kPlanar},
  }};
  const auto* found = std::find_if(kTypes.begin(), kTypes.end(), [name](const auto& type) {
    return std::equal(name.begin(), name.end(), type.first.begin(), type.first.end(),
                      [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
  });
  return found == kTypes.end() ? JointType::kUnknown : found->second;
}

model::Axis SdfReader::read_axis(xml::Element element) const {
  model::Axis axis;
  axis.site = site_of(element);
  axis.xyz = vector_field(child_text(element, "xyz"), {0, 0, 1});
  if (const auto xyz = element.child("xyz")) {
    axis.expressed_in = string_field(attribute_text(*xyz, "expressed_in"));
  }
  const auto flag = bool_field(child_text(element, "use_parent_model_frame"), version_ <= 4);
  if (version_ < 7 && flag.value) axis.expressed_in.value = "__model__";
  axis.lower.value = -unbounded(version_);
  axis.upper.value = unbounded(version_);
  axis.effort.value = axis.velocity.value = unlimited(version_);
  if (const auto limit = element.child("limit")) {
    axis.limit_site = site_of(*limit);
    axis.limit_written = true;
    axis.lower = number_field(child_text(*limit, "lower"), axis.lower.value);
    axis.upper = number_field(child_text(*limit, "upper"), axis.upper.value);
    axis.effort = number_field(child_text(*limit, "effort"), axis.effort.value);
    axis.velocity = number_field(child_text(*limit, "velocity"), axis.velocity.value);
  }
  if (const auto dynamics = element.child("dynamics")) {
    axis.damping = number_field(child_text(*dynamics, "damping"), 0);
    axis.friction = number_field(child_text(*dynamics, "friction"), 0);
    axis.spring_reference = number_field(child_text(*dynamics, "spring_reference"), 0);
    axis.spring_stiffness = number_field(child_text(*dynamics, "spring_stiffness"), 0);
  }
  if (const auto mimic = element.child("mimic")) axis.mimic = read_mimic(*mimic);
  return axis;
}

void SdfReader::read_joint(xml::Element element, Scope scope) {
  const model::Id<model::Joint> id = model::next_id(root_.joints);
  model::Joint& joint = root_.joints.emplace_back();
  joint.site = site_of(element);
  joint.name = string_field(attribute_text(element, "name"));
  joint.type_name = string_field(attribute_text(element, "type"));
  joint.type = joint_type(joint.type_name.value);
  joint.model = scope.model;
  joint.world = scope.world;
  joint.parent = link_name(element, "parent");
  joint.child = link_name(element, "child");
  joint.pose = read_pose(element);
  for (const std::string_view name : {"axis", "axis2"}) {
    if (const auto axis = element.child(name)) joint.axes.push_back(read_axis(*axis));
  }
  joint.thread_pitch = number_field(child_text(element, "thread_pitch"), 1);
  joint.screw_thread_pitch = number_field(child_text(element, "screw_thread_pitch"), 1);
  joint.gearbox_ratio = number_field(child_text(element, "gearbox_ratio"), 1);
  joint.gearbox_reference = string_field(child_text(element, "gearbox_reference_body"));
  joint.implicit_spring_damper = is_implicit(element);
  auto& siblings =
      scope.model ? root_.models[scope.model.value].joints : root_.worlds[scope.world.value].joints;
  siblings.push_back(id);
  for (const xml::Element child : element.children()) {
    if (child.name() != "sensor") continue;
    model::Sensor sensor;
    sensor.joint = id;
    read_sensor(child, std::move(sensor));
  }
}

}  // namespace rigor::read
