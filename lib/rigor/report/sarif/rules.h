// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The rules of a SARIF log: what a reader shows beside a finding.

#pragma once

#include <map>
#include <string_view>

#include <rigor/report/json/values.h>
#include <rigor/report/validation.h>

namespace rigor::report {

struct SarifRules {
  Json descriptors = Json::array();               ///< sorted by name
  std::map<std::string_view, std::size_t> index;  ///< of a rule in that list
};

/// All that a check can say, whether or not it did: who reads the log sees what was looked for.
SarifRules sarif_rules(const Validation& validation);

/// "error", "warning", "note"
std::string_view sarif_level(Severity severity);

}  // namespace rigor::report
