// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the page of a report looks like, and the script that sorts and filters its table. The script is
// well-formed inside XML as it is: neither `<` nor `&`.

#pragma once

#include <string_view>

namespace rigor::report {

std::string_view team_report_style();
std::string_view team_report_script();

/// Of the script, as a content security policy names it: "sha256-…".
std::string_view team_report_script_hash();

}  // namespace rigor::report
