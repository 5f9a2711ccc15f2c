// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Templates of `rigor edit add`: elements with placeholders, in templates/add/TARGET/NAME.xml.
//
//   const std::string text = filled(*add_template("gz-sim", "diff-drive"), {{"LEFT", {"fl", "rl"}}});
//
// A line with a placeholder of several values is written once for each; with one of none, not at all. A value of
// several lines keeps the line's indentation. Private to the room.

#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::author {

/// Its text; nothing when there is none.
std::optional<std::string_view> add_template(std::string_view target, std::string_view name);

/// By what stands between the `@`. Values are XML as they are.
using TemplateValues = std::map<std::string, std::vector<std::string>>;

/// Without an end of line at its end.
std::string filled(std::string_view text, const TemplateValues& values);

}  // namespace rigor::author
