// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include <rigor/robot/assembled/axles.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::slider_looks_like_hinge {

using model::Vector3;

// Times the robot's size: no rail that is drawn is so long.
constexpr double kTimesLonger = 2;

// Joints of the robot that turn, within limits of their own.
constexpr std::size_t kFewestHinges = 3;

bool has_limits(const model::Axis& axis) {
  return axis.lower.written && axis.upper.written && std::isfinite(axis.lower.value) &&
         std::isfinite(axis.upper.value) && axis.lower.value < axis.upper.value &&
         axis.upper.value - axis.lower.value < 1e6;
}

std::size_t hinges_beside(const model::Joint& joint, const model::Root& root) {
  return static_cast<std::size_t>(
      std::count_if(root.joints.begin(), root.joints.end(), [&joint](const model::Joint& other) {
        return other.model == joint.model && other.type == model::JointType::kRevolute;
      }));
}

/// m, of the box around all shapes of its model, or of its links' origins where that is larger.
double size_of_robot(const robot::AssembledLink& link, const robot::Assembled& robot) {
  robot::Links links;
  std::optional<mesh::Bounds> origins;
  for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].top != link.top || !robot.links[i].X_WL) continue;
    links.push_back(i);
    const Vector3& at = robot.links[i].X_WL->translation;
    origins = origins ? robot::joined(*origins, {at, at}) : mesh::Bounds{at, at};
  }
  const auto shapes = robot.bounds_W(links);
  return std::max(origins ? mesh::diagonal(*origins) : 0, shapes ? mesh::diagonal(*shapes) : 0);
}

/// Whether a shape of the link is round about the axis and in its middle.
bool is_round(model::Id<model::Joint> id, std::uint32_t child, Context& context) {
  const auto axis_W = context.frames().axis(id, 0);
  const auto X_WJ = context.frames().pose(id);
  if (!axis_W || !X_WJ) return false;
  const robot::Assembled& robot = context.assembled();
  const model::Root& root = context.root();
  const auto& shapes = robot.links[child].shapes;
  return std::any_of(shapes.begin(), shapes.end(), [&](std::uint32_t s) {
    const robot::AssembledShape& shape = robot.shapes[s];
    const model::Shape& of = shape.role == robot::ShapeRole::kCollision
                                 ? root.collisions[shape.index].geometry.shape
                                 : root.visuals[shape.index].geometry.shape;
    if (std::holds_alternative<model::Mesh>(of)) return false;
    const auto radius = robot::radius_about(shape, of, *axis_W);
    constexpr double kOffCenter = 0.2;  // of the radius
    const Vector3 arm = shape.box_W.center_W - X_WJ->translation;
    return radius && length(arm - dot(arm, *axis_W) * *axis_W) < kOffCenter * *radius;
  });
}

/// The reason to doubt it; empty when there is none.
std::string doubt(const model::Joint& joint, model::Id<model::Joint> id, Context& context) {
  const auto& ends = context.frames().ends(id);
  if (!ends.child || !ends.parent) return {};
  const model::Axis& axis = joint.axes.front();
  const robot::Assembled& robot = context.assembled();
  const robot::AssembledLink& child = robot.links[ends.child.value];
  if (!has_limits(axis)) {
    const model::JointType type = model::JointType::kContinuous;
    const bool wheels = std::any_of(
        context.root().joints.begin(), context.root().joints.end(), [&](const model::Joint& other) {
          return other.model == joint.model && &other != &joint && !other.axes.empty() &&
                 (other.type == type || other.type == model::JointType::kRevolute);
        });
    if (!wheels || !is_round(id, ends.child.value, context)) return {};
    return fmt::format("'{}' slides without end along the axis that it is round about",
                       context.root()[ends.child].name.value);
  }
  // A base that slides over the ground has nothing beneath it.
  const std::size_t hinges = hinges_beside(joint, context.root());
  const bool seen = !child.shapes.empty() || child.unknown > 0;
  const double travel = axis.upper.value - axis.lower.value;
  const double most = std::max(std::abs(axis.lower.value), std::abs(axis.upper.value));
  if (hinges < kFewestHinges || !seen || !robot.links[ends.parent.value].carrier) return {};
  if (most > 2 * std::numbers::pi + 0.01) return {};
  const double size = size_of_robot(child, robot);
  if (!(size > 0) || travel < kTimesLonger * size) return {};
  return fmt::format("the joint slides by {:.3g} m, and the robot is {:.3g} m long; its {} other "
                     "joints turn",
                     travel, size, hinges);
}

void check(const model::Joint& joint, Context& context) {
  if (joint.type != model::JointType::kPrismatic || joint.axes.empty()) return;
  const model::Id<model::Joint> id{
      static_cast<std::uint32_t>(&joint - context.root().joints.data())};
  std::string message = doubt(joint, id, context);
  if (message.empty()) return;
  const bool unlimited = context.is_urdf() && !has_limits(joint.axes.front());
  const std::string type = unlimited ? "continuous" : "revolute";
  context.report(
      {.where = joint.type_name.span,
       .message = std::move(message),
       .subject = context.subject(joint),
       .help = "did you mean '" + type + "'?",
       .fix = Fix{"make it " + type, Applicability::kUnsafe, {{joint.type_name.span, type}}}});
}

Rule rule() {
  return {
      .name = "slider-looks-like-hinge",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a prismatic joint slides as far as only a hinge turns",
      .why = "The wheel shoots off along its axle, or the arm's link away from the arm. The joint "
             "is prismatic, and either has no limits and a child that is round about its axis, or "
             "slides twice as far as the robot is long by numbers that are angles elsewhere: the "
             "type is that of another joint.",
      .what_to_do = "Write the type that was meant.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::slider_looks_like_hinge
