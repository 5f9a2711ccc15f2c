// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/finding_list.h>

#include <algorithm>
#include <cstddef>

#include <fmt/core.h>

#include <rigor/report/markup.h>
#include <rigor/report/pretty.h>
#include <rigor/report/printable.h>
#include <rigor/report/summary.h>

namespace rigor::report {
namespace {

/// So many are read; who wants more unfolds them.
constexpr std::size_t kOpen = 20;

/// A value that is quoted in a message may be as long as the file.
constexpr std::size_t kLongestMessage = 1000;

std::string finding_item(const Diagnostic& finding, Places& places, std::string_view rules) {
  const std::string_view severity = to_string(finding.severity);
  return fmt::format(
      "<li class=\"finding {0}\"><p><span class=\"badge\">{0}</span> {1} "
      "<a href=\"{2}{3}\">{3}</a></p><pre>{4}</pre></li>\n",
      severity, escaped(printable(finding.message, kLongestMessage)), rules, escaped(finding.rule),
      escaped(finding_details(finding, places)));
}

}  // namespace

std::string finding_list(std::vector<const Diagnostic*> findings, Places& places,
                         std::string_view rules) {
  std::stable_sort(findings.begin(), findings.end(), [](const Diagnostic* a, const Diagnostic* b) {
    return a->severity < b->severity;
  });
  const auto first_info =
      std::find_if(findings.begin(), findings.end(),
                   [](const Diagnostic* each) { return each->severity == Severity::kInfo; });
  const auto open = static_cast<std::size_t>(first_info - findings.begin());
  const auto items = [&](std::size_t from, std::size_t to) {
    std::string out = "<ul class=\"findings\">\n";
    for (std::size_t i = from; i < to; ++i) out += finding_item(*findings[i], places, rules);
    return out + "</ul>\n";
  };
  const auto folded = [&](std::size_t from, std::size_t to, std::string_view what) {
    if (from == to) return std::string();
    return fmt::format("<details><summary>{}</summary>\n{}</details>\n", counted(to - from, what),
                       items(from, to));
  };
  const std::size_t shown = std::min(open, kOpen);
  std::string out = shown > 0 ? items(0, shown) : std::string();
  return out + folded(shown, open, "more finding") + folded(open, findings.size(), "info");
}

}  // namespace rigor::report
