// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Findings as a part of a page, by rule, the most severe first. The rest of many and what is only worth knowing
// is folded. Each is linked to its rule.
//
//   page += finding_list(findings, places, "#rule-");

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/report/places.h>
#include <rigor/text/diagnostic.h>

namespace rigor::report {

/// A list item each. `rules` is what a link to a rule begins with.
std::string finding_list(const std::vector<const Diagnostic*>& findings, Places& places,
                         std::string_view rules);

}  // namespace rigor::report
