// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What of a run's findings a terminal lists: those that are severe enough, or a table of their rules.
//
//   out += pretty_with_reasons(shown(findings, Severity::kWarning), sources, color);
//   say(not_shown(findings, Severity::kWarning));  // "52 notes in 9 rules; --show info"

#pragma once

#include <string>

#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>

namespace rigor::report {

/// The findings that are as severe as `least` or more.
Diagnostics shown(const Diagnostics& findings, Severity least);

/// How many findings of how many rules `shown` leaves out, and how to list them; empty when it leaves out none.
std::string not_shown(const Diagnostics& findings, Severity least);

/// A line for each rule: severity, rule, findings, places, and the first place. The most severe first, then
/// those with the most places.
std::string rule_table(const Diagnostics& findings, const Sources& sources);

}  // namespace rigor::report
