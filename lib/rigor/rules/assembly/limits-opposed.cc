// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/assembled.h>
#include <rigor/robot/assembled/travel.h>
#include <rigor/robot/assembled/twins.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::limits_opposed {

// Joints that have the same limits: two may by chance, or be the two sides of a robot.
constexpr std::size_t kFewest = 2;

/// Whether a joint moves farther to one side than to the other, so far that it matters. One number and zero are too little
/// to say that joints are alike: thumbs and fingers close in opposite directions, by a round angle.
bool is_lopsided(const robot::Range& range) {
  if (range.lower == 0 || range.upper == 0) return false;
  constexpr double kLeast = 0.05;  // rad or m
  const double off = std::abs(range.lower + range.upper);
  return range.upper - range.lower > kLeast && off > 0.1 * (range.upper - range.lower);
}

std::optional<Fix> exchanged(const model::Axis& axis, const robot::Range& range) {
  if (!axis.lower.written || !axis.upper.written) return std::nullopt;
  const std::string lower = write::joined({0 - range.upper});
  const std::string upper = write::joined({0 - range.lower});
  return Fix{fmt::format("write {} and {}", lower, upper),
             Applicability::kUnsafe,
             {{axis.lower.span, lower}, {axis.upper.span, upper}}};
}

/// Left and right, of which other pairs say whether their limits are the same or opposite. Axes are as written, in each
/// joint's own frame.
struct Pair {
  const model::Joint* a = nullptr;
  const model::Joint* b = nullptr;
  bool is_opposed = false;
};

std::vector<Pair> lopsided_pairs(Context& context) {
  std::vector<Pair> pairs;
  for (const robot::Twins& twins : context.assembled().joint_twins) {
    const model::Joint& a = context.root().joints[twins.a];
    const model::Joint& b = context.root().joints[twins.b];
    const auto of_a = robot::limited_range(a), of_b = robot::limited_range(b);
    if (!of_a || !of_b || a.type != b.type || !is_lopsided(*of_a)) continue;
    if (a.axes.front().xyz.value != b.axes.front().xyz.value) continue;
    const bool is_same = of_a->lower == of_b->lower && of_a->upper == of_b->upper;
    const bool is_opposed = of_a->lower == -of_b->upper && of_a->upper == -of_b->lower;
    if (is_same || is_opposed) pairs.push_back({&a, &b, is_opposed});
  }
  return pairs;
}

void report(const Pair& odd, std::size_t others, Context& context) {
  const robot::Range range = *robot::limited_range(*odd.a);
  context.report(
      {.where = odd.a->axes.front().limit_site.name,
       .message = fmt::format("limits {:.6g} to {:.6g} {} are those of its twin '{}' with the "
                              "opposite signs; {} other pairs have the same limits",
                              range.lower, range.upper, position_unit(odd.a->type),
                              odd.b->name.value, others),
       .subject = context.subject(*odd.a),
       .related = {{odd.b->axes.front().limit_site.name, "limits of its twin"}},
       .help = "Exchange the limits of one of them and their signs: both axes are the same",
       .severity = Severity::kInfo});
}

/// One pair among others about the same axis. A hip's yaw is opposed where its pitch is not.
void check_pairs(const model::Root& /*root*/, Context& context) {
  const std::vector<Pair> pairs = lopsided_pairs(context);
  for (const Pair& odd : pairs) {
    if (!odd.is_opposed) continue;
    std::size_t same = 0, opposed = 0;
    for (const Pair& other : pairs) {
      if (other.a->axes.front().xyz.value == odd.a->axes.front().xyz.value)
        ++(other.is_opposed ? opposed : same);
    }
    if (opposed == 1 && same >= kFewest) report(odd, same, context);
  }
}

void check(const model::Model& model, Context& context) {
  // By what they move about, and their limits.
  using Motion = std::tuple<model::JointType, double, double, double, double, double>;
  std::map<Motion, std::vector<const model::Joint*>> by_motion;
  const auto motion_of = [](const model::Joint& joint, const robot::Range& range) {
    const model::Vector3& axis = joint.axes.front().xyz.value;
    return Motion{joint.type, axis.x, axis.y, axis.z, range.lower, range.upper};
  };
  for (const auto id : model.joints) {
    const model::Joint& joint = context.root()[id];
    const auto range = context.root().own(joint.site) ? robot::limited_range(joint) : std::nullopt;
    if (range && is_lopsided(*range)) by_motion[motion_of(joint, *range)].push_back(&joint);
  }
  for (const auto& [motion, joints] : by_motion) {
    if (joints.size() != 1) continue;
    const model::Joint& odd = *joints.front();
    const robot::Range range = *robot::limited_range(odd);
    const auto others = by_motion.find(motion_of(odd, {0 - range.upper, 0 - range.lower}));
    if (others == by_motion.end() || others->second.size() < kFewest) continue;
    const model::Joint& other = *others->second.front();
    const model::Axis& axis = odd.axes.front();
    context.report(
        {.where = axis.lower.written ? axis.lower.span : axis.limit_site.name,
         .message = fmt::format("limits {:.6g} to {:.6g} {} are those of {} other joints, '{}' and "
                                "others, with the opposite signs",
                                range.lower, range.upper, position_unit(odd.type),
                                others->second.size(), other.name.value),
         .subject = context.subject(odd),
         .related = {{other.axes.front().limit_site.name, "limits of the others"}},
         .help = "Exchange the limits and their signs: the axis is the same",
         .fix = exchanged(axis, range)});
  }
}

Rule rule() {
  return {
      .name = "limits-opposed",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the limits of one joint have the opposite signs of those of like joints",
      .why = "One finger bends backward: two or more joints of the model have the same axis and "
             "the same limits, which reach farther to one side, and this joint alone has them with "
             "the signs exchanged. Of a left and a right joint with opposite limits it is an info, "
             "where two other pairs about that axis have the same limits on both sides.",
      .what_to_do = "Write the limits of the others, or negate the axis as well where the joint is "
                    "mounted the other way round.",
      .checks = {on<model::Model>(check), on<model::Root>(check_pairs)},
  };
}

}  // namespace rigor::rules::limits_opposed
