// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/core.h>

#include <rigor/read/values.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_rate_negative {

/// Parameters that mean a rate in Hz wherever they are used. The update_frequency of PosePublisher is
/// not among them: there a negative one represents as often as possible.
constexpr std::string_view kRates[] = {"updateRate", "update_rate", "odom_publish_frequency",
                                       "publish_rate", "publishRate"};

void check(const model::Plugin& plugin, Context& context) {
  for (const model::Parameter& given : plugin.parameters) {
    if (std::find(std::begin(kRates), std::end(kRates), given.name) == std::end(kRates)) continue;
    const auto rate = read::number_field(given);
    if (!rate.written || !(rate.value < 0)) continue;
    context.report(
        {.where = rate.span,
         .message = fmt::format("the plugin is to run {} times in a second", rate.value),
         .subject = context.subject(plugin),
         .fix = Fix{"as often as possible", Applicability::kUnsafe, {{rate.span, "0"}}}});
  }
}

Rule rule() {
  return {
      .name = "plugin-rate-negative",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a plugin is to run a negative number of times in a second",
      .why = "Plugins that test whether the rate is above 0 run at every step, as for 0; the "
             "behavior of others is undefined.",
      .what_to_do = "Write the rate in Hz; 0 is every step for most plugins.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_rate_negative
