// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/mjcf/mjcf_joint.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace rigor::read {
namespace {

using model::JointType;

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// Whether a range counts: said, or left to be taken from a range that is not inverted.
bool is_limited(const MjcfValues& values, std::string_view switch_name, std::string_view range,
                const MjcfSettings& settings) {
  const auto text = values.text(switch_name);
  const std::string_view value = text ? trimmed(text->text) : "auto";
  if (value == "auto") {
    const std::vector<double> n = values.numbers(range);
    return settings.auto_limits && n.size() == 2 && n[0] < n[1];
  }
  return value == "true";
}

model::Axis mjcf_axis(const MjcfValues& values, const MjcfPlace& place, bool hinge) {
  const MjcfSettings& settings = place.scope->settings;
  const auto angle = [&](double value) { return hinge ? settings.radians(value) : value; };
  model::Axis axis;
  axis.site = site_of(values.element());
  axis.xyz = values.vector("axis", {0, 0, 1});
  axis.xyz.value = rotate(place.X_BF.rotation, axis.xyz.value);
  axis.position_at_rest = angle(values.number("ref", 0).value);
  axis.lower.value = -kEndless;
  axis.upper.value = axis.effort.value = axis.velocity.value = kEndless;
  const auto range = values.text("range");
  const std::vector<double> limits = values.numbers("range");
  if (range && limits.size() == 2 && is_limited(values, "limited", "range", settings)) {
    axis.limit_site = axis.site;
    axis.limit_written = true;
    axis.lower = {angle(limits[0]) - axis.position_at_rest, range->span, true};
    axis.upper = {angle(limits[1]) - axis.position_at_rest, range->span, true};
  }
  const std::vector<double> force = values.numbers("actuatorfrcrange");
  if (force.size() == 2 && is_limited(values, "actuatorfrclimited", "actuatorfrcrange", settings)) {
    axis.effort = {std::max(std::abs(force[0]), std::abs(force[1])),
                   values.text("actuatorfrcrange")->span, true};
  }
  axis.damping = values.number("damping", 0);
  axis.friction = values.number("frictionloss", 0);
  axis.armature = values.number("armature", 0);
  axis.spring_stiffness = values.number("stiffness", 0);
  const std::vector<double> tuned = values.numbers("springdamper");
  if (tuned.size() == 2 && tuned[0] > 0 && tuned[1] > 0) axis.spring_damper = {tuned[0], tuned[1]};
  axis.spring_reference = values.number("springref", 0);
  axis.spring_reference.value = angle(axis.spring_reference.value) - axis.position_at_rest;
  return axis;
}

/// rad, m: the largest force or torque that an actuator has on its joint; infinity when nothing bounds it.
double actuator_effort(const MjcfValues& values, const MjcfSettings& settings) {
  const auto largest = [](const std::vector<double>& range) {
    return std::max(std::abs(range[0]), std::abs(range[1]));
  };
  const std::vector<double> gears = values.numbers("gear");
  const double gear = gears.empty() ? 1 : std::abs(gears.front());
  double effort = kEndless;
  const std::vector<double> force = values.numbers("forcerange");
  if (force.size() == 2 && is_limited(values, "forcelimited", "forcerange", settings)) {
    effort = gear * largest(force);
  }
  const std::string_view tag = values.element().name();
  const std::string bias = values.string("biastype", "none").value;
  const std::string gain_type = values.string("gaintype", "fixed").value;
  const bool direct =
      tag == "motor" || (tag == "general" && bias == "none" && gain_type == "fixed");
  const std::vector<double> control = values.numbers("ctrlrange");
  if (direct && control.size() == 2 && is_limited(values, "ctrllimited", "ctrlrange", settings)) {
    const std::vector<double> gains = values.numbers("gainprm");
    const double gain = tag == "motor" || gains.empty() ? 1 : std::abs(gains.front());
    effort = std::min(effort, gear * gain * largest(control));
  }
  return effort;
}

/// joint1 = polycoef of joint2; what is not linear follows its tangent at rest.
void read_joint_equality(const MjcfValues& values, const MjcfScope& scope, const MjcfJoints& joints,
                         model::Root& root) {
  const auto active = values.text("active");
  if (active && trimmed(active->text) == "false") return;
  const auto leader = values.string("joint2");
  const auto follower = joints.find(scope.prefix + values.string("joint1").value);
  if (!leader.written || follower == joints.end()) return;
  if (joints.find(scope.prefix + leader.value) == joints.end()) return;
  std::vector<double> coefficients = values.numbers("polycoef");
  constexpr std::array<double, 2> kOwn{0, 1};  // of MuJoCo, where fewer are written
  for (std::size_t i = coefficients.size(); i < kOwn.size(); ++i) coefficients.push_back(kOwn[i]);
  model::Joint& joint = root.joints[follower->second.value];
  if (joint.axes.empty()) return;
  model::Mimic mimic;
  mimic.site = site_of(values.element());
  mimic.joint = leader;
  mimic.joint.value = scope.prefix + leader.value;
  const auto text = values.text("polycoef");
  mimic.offset = {coefficients[0], text ? text->span : Span{}, text.has_value()};
  mimic.multiplier = {coefficients[1], text ? text->span : Span{}, text.has_value()};
  joint.axes.front().mimic = std::move(mimic);
}

}  // namespace

model::Joint mjcf_joint(const MjcfValues& values, const MjcfPlace& place) {
  model::Joint joint;
  joint.site = site_of(values.element());
  joint.type_name = values.string("type", "hinge");
  const bool free = values.element().name() == "freejoint" || joint.type_name.value == "free";
  const std::string& type = joint.type_name.value;
  joint.type = free              ? JointType::kFloating
               : type == "ball"  ? JointType::kBall
               : type == "slide" ? JointType::kPrismatic
               : type == "hinge" ? JointType::kRevolute
                                 : JointType::kUnknown;
  if (free) return joint;
  joint.pose.site = joint.site;
  joint.pose.pose = {{transform(place.X_BF, values.vector("pos", {}).value), {}}, {}, true};
  joint.axes.push_back(mjcf_axis(values, place, type != "slide"));
  return joint;
}

void read_mjcf_couplings(const MjcfScope& scope, const MjcfJoints& joints, model::Root& root) {
  const auto class_of = [&](xml::Element element) {
    const std::string name = mjcf_name(element, "class").value;
    return scope.defaults.find(name).value_or(MjcfDefaults::kMain);
  };
  for (const xml::Element element : scope.tree.in_sections("equality")) {
    if (element.name() != "joint") continue;
    read_joint_equality(scope.defaults.values(element, "equality", class_of(element)), scope,
                        joints, root);
  }
  std::map<std::uint32_t, double> efforts;  // by joint: the sum of its actuators
  for (const xml::Element element : scope.tree.in_sections("actuator")) {
    // All kinds set one default, that of `general`.
    const MjcfValues values =
        scope.defaults.values_of_any(element, {element.name(), "general"}, class_of(element));
    auto target = values.string("joint");
    if (!target.written) target = values.string("jointinparent");
    const auto joint = joints.find(scope.prefix + target.value);
    if (!target.written || joint == joints.end()) continue;
    efforts[joint->second.value] += actuator_effort(values, scope.settings);
  }
  for (const auto& [index, effort] : efforts) {
    for (model::Axis& axis : root.joints[index].axes) {
      if (effort < axis.effort.value) {
        axis.effort = {effort, root.joints[index].site.tag, true};
      }
    }
  }
}

}  // namespace rigor::read
