// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// All rules at a glance, for `rigor rules`.

#pragma once

#include <string>

#include <rigor/rules/registry.h>

namespace rigor::report {

/// A table with a headline.
std::string rules_text(const rules::Registry& registry);
std::string rules_json(const rules::Registry& registry);
/// The reference: a table of all rules, then each rule's page (page.cc).
std::string rules_markdown(const rules::Registry& registry);

/// "none", "safe", "unsafe".
std::string_view fix_name(rules::FixGrade grade);
/// "any", "sdf", "urdf", "model-config".
std::string_view formats_name(rules::Formats formats);

}  // namespace rigor::report
