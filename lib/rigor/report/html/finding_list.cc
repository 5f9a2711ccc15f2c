// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/html/finding_list.h>

#include <algorithm>
#include <cstddef>

#include <fmt/core.h>

#include <rigor/report/html/markup.h>
#include <rigor/report/terminal/pretty.h>
#include <rigor/report/terminal/printable.h>

namespace rigor::report {
namespace {

/// Of one rule in one file: the others say the same.
constexpr std::size_t kOpen = 3;

/// A value that is quoted in a message may be as long as the file.
constexpr std::size_t kLongestMessage = 1000;

using FindingGroup = std::vector<const Diagnostic*>;

std::string finding_item(const Diagnostic& finding, Places& places, std::string_view rules) {
  const std::string_view severity = to_string(finding.severity);
  const FindingDetails details = finding_details(finding, places);
  std::string notes;
  for (const std::string& note : details.notes) {
    notes += fmt::format("<p class=\"note\">{}</p>", escaped(note));
  }
  return fmt::format(
      "<li class=\"finding {0}\"><p><span class=\"badge\">{0}</span> {1} "
      "<a href=\"{2}{3}\">{3}</a></p><pre>{4}</pre>{5}</li>\n",
      severity, escaped(printable(finding.message, kLongestMessage)), rules, escaped(finding.rule),
      escaped(details.excerpt), notes);
}

/// By severity, then rules in the order in which they first spoke.
std::vector<FindingGroup> by_rule(FindingGroup findings) {
  std::stable_sort(findings.begin(), findings.end(), [](const Diagnostic* a, const Diagnostic* b) {
    return a->severity < b->severity;
  });
  std::vector<FindingGroup> groups;
  for (const Diagnostic* each : findings) {
    const auto same = [each](const FindingGroup& group) {
      return group.front()->rule == each->rule && group.front()->severity == each->severity;
    };
    const auto group = std::find_if(groups.begin(), groups.end(), same);
    if (group == groups.end()) {
      groups.push_back({each});
    } else {
      group->push_back(each);
    }
  }
  return groups;
}

}  // namespace

std::string finding_list(const std::vector<const Diagnostic*>& findings, Places& places,
                         std::string_view rules) {
  const auto items = [&](const FindingGroup& list, std::size_t from, std::size_t to) {
    std::string out = "<ul class=\"findings\">\n";
    for (std::size_t i = from; i < to; ++i) out += finding_item(*list[i], places, rules);
    return out + "</ul>\n";
  };
  std::string out;
  for (const FindingGroup& group : by_rule(findings)) {
    const bool info = group.front()->severity == Severity::kInfo;
    const std::size_t open = info ? 0 : std::min(group.size(), kOpen);
    if (open > 0) out += items(group, 0, open);
    if (open == group.size()) continue;
    const std::string what = info ? "info" : "more";
    out += fmt::format("<details><summary>{} {}: {}</summary>\n{}</details>\n", group.size() - open,
                       what, escaped(group.front()->rule), items(group, open, group.size()));
  }
  return out;
}

}  // namespace rigor::report
