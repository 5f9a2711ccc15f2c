// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/axles.h>
#include <rigor/rules/assembly/undone_slips.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::wheel_size_differs {

using robot::Wheel;

// Tires wear and spring; wheels of one axle are made alike.
constexpr double kAlike = 1.05;

bool alike(double a, double b) { return std::max(a, b) < kAlike * std::min(a, b); }

/// How many other wheels of the model have this radius.
std::size_t others_alike(const std::vector<Wheel>& all, std::size_t of,
                         const robot::Assembled& robot) {
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](const Wheel& other) {
    return &other != &all[of] && robot.links[other.link].top == robot.links[all[of].link].top &&
           alike(other.radius(), all[of].radius());
  }));
}

bool agrees_with_visual(const Wheel& wheel) {
  return wheel.collision_radius && wheel.visual_radius &&
         alike(*wheel.collision_radius, *wheel.visual_radius);
}

bool contradicts_visual(const Wheel& wheel) {
  return wheel.collision_radius && wheel.visual_radius &&
         !alike(*wheel.collision_radius, *wheel.visual_radius);
}

/// How far its lowest point is from the lowest point of what else the robot has, m.
double off_ground(const Wheel& wheel, const Wheel& other, const robot::Assembled& robot) {
  robot::Links rest;
  for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
    if (i == wheel.link || i == other.link || robot.links[i].top != robot.links[wheel.link].top)
      continue;
    rest.push_back(i);
  }
  const auto bounds = robot.bounds_W(rest);
  const double bottom = wheel.center_W.z - wheel.radius();
  return bounds ? std::abs(bottom - bounds->min.z) : 0;
}

/// Which of the two is the wrong one: the one that its own visual, the other wheels or the ground contradict.
std::size_t wrong_one(const std::vector<Wheel>& all, const robot::Axle& axle,
                      const robot::Assembled& robot) {
  const Wheel& a = all[axle.a];
  const Wheel& b = all[axle.b];
  if (contradicts_visual(a) && agrees_with_visual(b)) return axle.a;
  if (contradicts_visual(b) && agrees_with_visual(a)) return axle.b;
  const std::size_t like_a = others_alike(all, axle.a, robot);
  const std::size_t like_b = others_alike(all, axle.b, robot);
  if (like_a != like_b) return like_a < like_b ? axle.a : axle.b;
  const double off_a = off_ground(a, b, robot);
  const double off_b = off_ground(b, a, robot);
  if (off_a != off_b) return off_a > off_b ? axle.a : axle.b;
  return a.radius() < b.radius() ? axle.a : axle.b;
}

/// The radius of the shape that rolls, as it is written; null for a mesh.
const model::Field<double>* radius_field(const model::Geometry& geometry) {
  if (const auto* ball = std::get_if<model::Sphere>(&geometry.shape)) return &ball->radius;
  if (const auto* wheel = std::get_if<model::Cylinder>(&geometry.shape)) return &wheel->radius;
  if (const auto* wheel = std::get_if<model::Capsule>(&geometry.shape)) return &wheel->radius;
  return nullptr;
}

const model::Geometry& geometry_of(const Wheel& wheel, const model::Root& root,
                                   const robot::Assembled& robot) {
  const robot::AssembledShape& shape = robot.shapes[wheel.shape];
  return shape.role == robot::ShapeRole::kCollision ? root.collisions[shape.index].geometry
                                                    : root.visuals[shape.index].geometry;
}

void report(const Wheel& wheel, const Wheel& other, Context& context) {
  const model::Root& root = context.root();
  const model::Geometry& geometry = geometry_of(wheel, root, context.assembled());
  const model::Geometry& beside = geometry_of(other, root, context.assembled());
  const model::Field<double>* field = radius_field(geometry);
  const model::Field<double>* meant = radius_field(beside);
  Finding finding{.where = field && field->written ? field->span : geometry.site.name,
                  .message = fmt::format(
                      "the wheel's radius is {:.4g} m, and that of '{}' on the same axle {:.4g} m",
                      wheel.radius(), root.links[other.link].name.value, other.radius()),
                  .subject = context.subject(root.links[wheel.link])};
  if (root.own(beside.site)) finding.related = {{beside.site.name, "the other wheel"}};
  if (field && meant && field->written) {
    const std::string value = write::joined({meant->value});
    finding.fix = Fix{"write " + value, Applicability::kUnsafe, {{field->span, value}}};
  }
  context.report(std::move(finding));
}

void check(const model::Root& root, Context& context) {
  if (root.joints.size() < 2 || root.links.size() < 3) return;
  const robot::Assembled& robot = context.assembled();
  const std::vector<Wheel> all = robot::wheels(root, context.frames(), robot);
  std::vector<bool> reported(all.size(), false);
  for (const robot::Axle& axle : robot::axles(all, robot)) {
    const Wheel& a = all[axle.a];
    const Wheel& b = all[axle.b];
    if (alike(a.radius(), b.radius())) continue;
    // A collision beside a visual says nothing.
    if (a.collision_radius.has_value() != b.collision_radius.has_value()) continue;
    const std::size_t wrong = wrong_one(all, axle, robot);
    const Wheel& other = wrong == axle.a ? b : a;
    if (reported[wrong] || !root.own(root.links[all[wrong].link].site)) continue;
    reported[wrong] = true;
    report(all[wrong], other, context);
  }
}

Rule rule() {
  return {
      .name = "wheel-size-differs",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "two wheels of one axle have different radii",
      .why = "The robot leans, drives in a curve when both wheels turn alike, and its odometry is "
             "wrong. The wheels turn about one line and are beside each other. The finding is at "
             "the one that its own visual, the robot's other wheels or the ground contradict.",
      .what_to_do = "Give both the same radius.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::wheel_size_differs
