// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/assembled.h>
#include <rigor/rules/assembly/twin_numbers.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::twin_axis_opposed {

using model::Vector3;

// 8°: less is camber or calibration.
constexpr double kAlong = 0.99;

/// How authors relate the axis of the right to that of the left: the same, its mirror image, or that negated, as
/// rotations are mirrored.
constexpr std::size_t kConventions = 3;

struct Relation {
  robot::Twins joints;
  std::array<bool, kConventions> follows{};
  std::string role;
  /// Whether the ranges of motion are mirror images, where they tell; nothing for symmetric limits.
  std::optional<bool> ranges_mirrored;

  bool follows_any() const { return follows[0] || follows[1] || follows[2]; }
  bool agrees_with(const Relation& other) const {
    return (follows[0] && other.follows[0]) || (follows[1] && other.follows[1]) ||
           (follows[2] && other.follows[2]);
  }
};

std::optional<bool> mirrored_ranges(const model::Joint& joint, const model::Joint& twin,
                                    bool opposed) {
  const model::Axis& a = joint.axes.front();
  const model::Axis& b = twin.axes.front();
  const double range = a.upper.value - a.lower.value;
  constexpr double kLopsided = 0.05;
  if (!std::isfinite(range) || !(range > 0) || !std::isfinite(b.lower.value + b.upper.value))
    return std::nullopt;
  if (std::abs(a.upper.value + a.lower.value) < kLopsided * range) return std::nullopt;
  const bool same =
      same_size(a.lower.value - b.lower.value, 0) && same_size(a.upper.value - b.upper.value, 0);
  const bool negated =
      same_size(a.lower.value + b.upper.value, 0) && same_size(a.upper.value + b.lower.value, 0);
  if (same == negated) return std::nullopt;
  return negated == opposed;
}

std::optional<Relation> relation_of(const robot::Twins& pair, Context& context) {
  const model::Root& root = context.root();
  const model::Frames& frames = context.frames();
  const model::Joint& a = root.joints[pair.a];
  const model::Joint& b = root.joints[pair.b];
  if (a.axes.size() != 1 || b.axes.size() != 1 || a.type != b.type) return std::nullopt;
  if (!a.axes.front().xyz.written || !b.axes.front().xyz.written) return std::nullopt;
  if (a.type == model::JointType::kFixed || a.type == model::JointType::kUnknown)
    return std::nullopt;
  const auto axis_a = frames.axis({pair.a}, 0), axis_b = frames.axis({pair.b}, 0);
  const auto X_WA = frames.pose(model::Id<model::Joint>{pair.a});
  const auto X_WB = frames.pose(model::Id<model::Joint>{pair.b});
  if (!axis_a || !axis_b || !X_WA || !X_WB) return std::nullopt;
  // A finger of the left hand is like that of the right hand on the same side, or on the other.
  constexpr std::size_t kOneSide = 2;
  if (robot::mirrored_names(a.name.value, robot::Side::kAcross).size() > kOneSide)
    return std::nullopt;
  const Vector3 between = X_WA->translation - X_WB->translation;
  constexpr double kApart = 1e-3;  // m
  if (length(between) < kApart) return std::nullopt;
  const Vector3 n = (1 / length(between)) * between;
  const Vector3 image = *axis_a - 2 * dot(*axis_a, n) * n;
  Relation result{.joints = pair, .role = robot::role_name(a.name.value)};
  result.follows = {dot(*axis_a, *axis_b) > kAlong, dot(image, *axis_b) > kAlong,
                    dot(image, *axis_b) < -kAlong};
  if (!result.follows_any() && dot(*axis_a, *axis_b) > -kAlong) return std::nullopt;
  // Positions are mirrored with the axis of a slider, and against that of a rotation.
  const bool with_axis = a.type == model::JointType::kPrismatic;
  if (result.follows[1]) result.ranges_mirrored = mirrored_ranges(a, b, !with_axis);
  if (result.follows[2]) result.ranges_mirrored = mirrored_ranges(a, b, with_axis);
  return result;
}

/// 1 when a twin in front or behind has this axis, -1 when it has the opposite, 0 without one.
int confirmed(std::uint32_t joint, const std::vector<robot::Twins>& along, Context& context) {
  const auto axis = context.frames().axis({joint}, 0);
  for (const robot::Twins& pair : along) {
    if (pair.a != joint && pair.b != joint) continue;
    const auto other = context.frames().axis({pair.a == joint ? pair.b : pair.a}, 0);
    if (!axis || !other || std::abs(dot(*axis, *other)) < kAlong) continue;
    return dot(*axis, *other) > 0 ? 1 : -1;
  }
  return 0;
}

std::optional<Fix> negated(const model::Axis& axis, const Context& context) {
  const auto written = write::numbers_in(context.bytes(axis.xyz.span));
  if (!written || written->size() != 3) return std::nullopt;
  const auto other = [](double x) { return x == 0 ? 0.0 : -x; };
  const std::string text =
      write::joined({other((*written)[0]), other((*written)[1]), other((*written)[2])});
  return Fix{"write the axis " + text, Applicability::kUnsafe, {{axis.xyz.span, text}}};
}

void report(const Relation& odd, std::string help, Severity severity, Context& context) {
  const model::Root& root = context.root();
  const auto along = twins_of(root.joints, robot::Side::kAlong, root);
  const int of_a = confirmed(odd.joints.a, along, context);
  const int of_b = confirmed(odd.joints.b, along, context);
  const bool first = of_a < of_b;
  const model::Joint& wrong = root.joints[first ? odd.joints.a : odd.joints.b];
  const model::Joint& right = root.joints[first ? odd.joints.b : odd.joints.a];
  const model::Axis& axis = wrong.axes.front();
  context.report({.where = axis.xyz.span,
                  .message = fmt::format("the axis points the other way than that of its twin '{}' "
                                         "does in other pairs: the same command moves them unlike",
                                         right.name.value),
                  .subject = context.subject(wrong),
                  .related = {{right.axes.front().xyz.span, "its twin's axis"}},
                  .help = std::move(help),
                  .fix = of_a != of_b ? negated(axis, context) : std::nullopt,
                  .severity = severity});
}

/// How many of the pairs follow a convention.
std::size_t followers(const std::vector<Relation>& all, std::size_t convention) {
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(),
                    [convention](const Relation& one) { return one.follows[convention]; }));
}

/// The convention that most pairs follow; of two, that with which ranges of motion are mirror images.
std::size_t convention_of(const std::vector<Relation>& all) {
  std::array<double, kConventions> score{};
  for (const Relation& one : all) {
    const double ranges = one.ranges_mirrored ? (*one.ranges_mirrored ? 0.4 : -0.4) : 0;
    for (std::size_t i = 0; i < kConventions; ++i) score[i] += one.follows[i] ? 1 + ranges : 0;
  }
  return static_cast<std::size_t>(std::max_element(score.begin(), score.end()) - score.begin());
}

/// Whether the other pair of the family, in front or behind, is related in another way.
bool family_disagrees(const Relation& one, const std::vector<Relation>& all) {
  return std::any_of(all.begin(), all.end(), [&one](const Relation& other) {
    return other.role == one.role && !one.agrees_with(other);
  });
}

void check(const model::Root& root, Context& context) {
  constexpr std::size_t kFewestJoints = 4;  // two pairs, of which one says what the other should be
  if (root.joints.size() < kFewestJoints || !context.frames().problems().empty()) return;
  std::vector<Relation> all;
  for (const robot::Twins& pair : context.assembled().joint_twins) {
    if (auto one = relation_of(pair, context)) all.push_back(std::move(*one));
  }
  const std::size_t best = convention_of(all);
  const std::size_t good = followers(all, best);
  const auto mirrored =
      static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](const Relation& one) {
        return one.ranges_mirrored.value_or(false);
      }));
  const auto not_mirrored =
      static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](const Relation& one) {
        return !one.ranges_mirrored.value_or(true);
      }));
  constexpr std::size_t kShare = 3;
  constexpr std::size_t kFewShare = 2;
  for (const Relation& one : all) {
    const bool odd_range = !one.ranges_mirrored.value_or(true) && mirrored >= kShare * not_mirrored;
    const bool odd_axis = !one.follows[best];
    const bool few = good >= kFewShare * (all.size() - good);
    const bool odd_family = family_disagrees(one, all) && (odd_axis || good == all.size());
    if (!odd_range && !(odd_axis && few) && !odd_family) continue;
    const std::string help =
        odd_range
            ? fmt::format("the limits of {} other pairs are mirror images, these are not", mirrored)
            : fmt::format("{} of {} pairs are related alike, and not this one", good, all.size());
    const bool contradicted = !one.ranges_mirrored.value_or(true) && mirrored > 0;
    const bool sure = odd_range || contradicted ? odd_axis || odd_family : odd_axis && odd_family;
    report(one, help, sure ? Severity::kWarning : Severity::kInfo, context);
  }
}

Rule rule() {
  return {
      .name = "twin-axis-opposed",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the joint axis of one side has the wrong sign",
      .why = "One knee bends forward while the other bends backward: the same command moves left "
             "and right unlike. Robots give the joints of both sides the same axis, its mirror "
             "image, or that negated, and do so throughout; this pair is related otherwise than "
             "most pairs, than the pair in front or behind, or has limits that are no mirror "
             "images with these axes. It is a warning where two of these agree.",
      .what_to_do = "Negate the axis of the joint that is wrong, or exchange its limits with the "
                    "other sign.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::twin_axis_opposed
