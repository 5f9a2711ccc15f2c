// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/github.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/report/tool.h>

namespace rigor::report {
namespace {

/// Annotations of one kind that GitHub shows of a step.
constexpr std::size_t kShownOfAKind = 10;

/// Bytes of a step's summary; GitHub takes 1,048,576, of all that a step writes there.
constexpr std::size_t kMaxSummary = 1'000'000;

std::string_view command_of(Severity severity) {
  switch (severity) {
    case Severity::kError: return "error";
    case Severity::kWarning: return "warning";
    case Severity::kInfo: break;
  }
  return "notice";
}

/// As actions/toolkit escapes what follows the second pair of colons.
std::string command_data(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '%': out += "%25"; break;
      case '\r': out += "%0D"; break;
      case '\n': out += "%0A"; break;
      default: out += c;
    }
  }
  return out;
}

/// As it escapes the value of a property.
std::string command_property(std::string_view text) {
  std::string out;
  for (const char c : command_data(text)) {
    switch (c) {
      case ':': out += "%3A"; break;
      case ',': out += "%2C"; break;
      default: out += c;
    }
  }
  return out;
}

/// With all that explains it: the log shows nothing else.
std::string annotation_message(const Diagnostic& diagnostic, Places& places) {
  std::string text = place_text(diagnostic, places) + ": " + printable(diagnostic.message);
  for (const Label& label : diagnostic.related) {
    text += '\n';
    if (!label.where.nowhere()) {
      text += place_text({.where = label.where}, places) + ": ";
    }
    text += printable(label.message);
  }
  const std::string others = other_places(diagnostic, places);
  if (!others.empty()) text += "\nand " + others;
  for (const std::string& line : origin_lines(diagnostic, places)) text += '\n' + line;
  if (!diagnostic.help.empty()) text += "\nhelp: " + printable(diagnostic.help);
  return text;
}

std::string annotation(const Diagnostic& diagnostic, const Validation& validation, Places& places) {
  std::string out =
      fmt::format("::{} title={},file={}", command_of(diagnostic.severity),
                  command_property(fmt::format("{} ({})", kToolName, diagnostic.rule)),
                  command_property(printable(project_path(validation, places.path(diagnostic)))));
  if (!diagnostic.where.nowhere()) {
    const Position begin = places.begin(diagnostic.where);
    const Position end = places.end(diagnostic.where);
    out += fmt::format(",line={},endLine={}", begin.line, end.line);
    // Columns over several lines are refused.
    if (begin.line == end.line)
      out += fmt::format(",col={},endColumn={}", begin.column, end.column);
  }
  return out + "::" + command_data(annotation_message(diagnostic, places)) + '\n';
}

using Findings = std::vector<const Diagnostic*>;

Findings of_severity(const Validation& validation, Severity severity) {
  Findings findings;
  for (const Diagnostic& diagnostic : validation.result.diagnostics.list()) {
    if (diagnostic.severity == severity) findings.push_back(&diagnostic);
  }
  return findings;
}

std::size_t hidden(std::size_t count, std::size_t shown) {
  return count > shown ? count - shown : 0;
}

/// Text of a file as plain text in a cell of a table.
std::string markdown_cell(std::string_view text) {
  std::string out;
  for (const char c : printable(text)) {
    if (std::string_view("\\`*_[]<>|~&!").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

/// The first place, and how many more there are.
std::string where_text(const Diagnostic& diagnostic, Places& places) {
  const std::string first = place_text(diagnostic, places);
  if (diagnostic.others.empty()) return first;
  return first + " and " + counted(diagnostic.others.size(), "more place");
}

}  // namespace

std::string github(const Validation& ungrouped) {
  const rules::ValidateResult result = grouped(ungrouped.result, GroupScope::kRun);
  const Validation validation{result, ungrouped.sources, ungrouped.registry, ungrouped.folders,
                              ungrouped.exit_code};
  const Findings errors = of_severity(validation, Severity::kError);
  const Findings warnings = of_severity(validation, Severity::kWarning);
  const Findings infos = of_severity(validation, Severity::kInfo);
  Places places(validation.sources);
  std::string out;
  for (const Findings* findings : {&errors, &warnings}) {
    for (const Diagnostic* diagnostic : *findings)
      out += annotation(*diagnostic, validation, places);
  }
  const std::size_t loud =
      hidden(errors.size(), kShownOfAKind) + hidden(warnings.size(), kShownOfAKind);
  const bool some_hidden = loud > 0 || infos.size() > kShownOfAKind;
  // The notice is one of the ten that are shown.
  const std::size_t before = some_hidden ? kShownOfAKind - 1 : infos.size();
  for (std::size_t i = 0; i <= infos.size(); ++i) {
    if (some_hidden && i == std::min(before, infos.size())) {
      out += fmt::format(
          "::notice title=rigor::{} in the log only: GitHub shows {} errors, {} warnings and {} "
          "notices of a step\n",
          counted(loud + hidden(infos.size(), before), "more finding"), kShownOfAKind,
          kShownOfAKind, kShownOfAKind);
    }
    if (i < infos.size()) out += annotation(*infos[i], validation, places);
  }
  return out;
}

std::string github_summary(const Validation& ungrouped) {
  const rules::ValidateResult result = grouped(ungrouped.result, GroupScope::kRun);
  const Validation validation{result, ungrouped.sources, ungrouped.registry, ungrouped.folders,
                              ungrouped.exit_code};
  Places places(validation.sources);
  std::string out = "### rigor\n\n" + markdown_cell(summary(validation.result)) + "\n";
  if (validation.result.diagnostics.list().empty()) return out;
  out += "\n| | where | what | rule |\n|---|---|---|---|\n";
  std::size_t left = validation.result.diagnostics.list().size();
  for (const Severity severity : {Severity::kError, Severity::kWarning, Severity::kInfo}) {
    for (const Diagnostic* diagnostic : of_severity(validation, severity)) {
      const std::string row =
          fmt::format("| {} | {} | {} | {} |\n", to_string(severity),
                      markdown_cell(where_text(*diagnostic, places)),
                      markdown_cell(diagnostic->message), markdown_cell(diagnostic->rule));
      if (out.size() + row.size() > kMaxSummary) {
        return out + "\nAnd " + counted(left, "more finding") + ": see the log.\n";
      }
      out += row;
      --left;
    }
  }
  return out;
}

}  // namespace rigor::report
