// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>
#include <string>

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::effort_limit_negative {

constexpr int kInfiniteSince = 10;
constexpr double kNoLimit = -1;  // as older versions say it

void check(const model::Joint& joint, Context& context) {
  const bool old = context.root().version < kInfiniteSince;
  for (const model::Axis& axis : joint.axes) {
    for (const model::Field<double>* limit : {&axis.effort, &axis.velocity}) {
      if (!limit->written || !(limit->value < 0) || !std::isfinite(limit->value)) continue;
      const bool no_limit = limit->value == kNoLimit;
      if (old && no_limit) continue;
      const std::string unit = limit == &axis.effort
                                   ? effort_unit(joint.type)
                                   : std::string(position_unit(joint.type)) + "/s";
      context.report(
          {.where = limit->span,
           .message = fmt::format("the {} limit is {:.6g} {}: {}",
                                  limit == &axis.effort ? "effort" : "velocity", limit->value, unit,
                                  no_limit ? "unlimited, which SDF writes as 'inf' since 1.10"
                                           : "a negative one counts as none"),
           .subject = context.subject(joint),
           .fix =
               Fix{no_limit ? "write infinity" : "write it without the sign",
                   Applicability::kUnsafe,
                   {{limit->span, no_limit ? std::string("inf") : write::joined({-limit->value})}}},
           .severity = no_limit ? std::optional(Severity::kInfo) : std::nullopt});
    }
  }
}

Rule rule() {
  return {
      .name = "effort-limit-negative",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the effort or velocity limit of a joint is negative",
      .why = "Up to SDF 1.9 the default -1 stood for no limit, since 1.10 infinity does. "
             "libsdformat makes every negative one infinite, so a sign by mistake leaves the joint "
             "without a limit; other programs use it as a limit that no motion meets. A -1 is what "
             "older versions have for no limit, and an info.",
      .what_to_do = "Write the maximum effort or speed; for no limit omit it.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::effort_limit_negative
