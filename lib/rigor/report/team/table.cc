// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/team/table.h>

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/core.h>

#include <rigor/report/html/markup.h>
#include <rigor/report/number.h>
#include <rigor/report/simulation/run.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>

namespace rigor::report {
namespace {

using simulate::Verdict;

constexpr std::array kVerdicts{Verdict::kPass, Verdict::kWarn, Verdict::kSolver, Verdict::kFail,
                               Verdict::kInvalid};

bool over_any(const TeamReportRow& row) { return row.visual.over() || row.collision.over(); }

bool any_verdict(const std::vector<TeamReportRow>& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const TeamReportRow& row) {
    return row.verdict || !row.no_verdict.empty();
  });
}

/// "1,204"
std::string grouped(std::uint64_t value) {
  std::string text = counted(value, "");
  while (!text.empty() && (text.back() == ' ' || text.back() == 's')) text.pop_back();
  return text;
}

std::string tile(std::size_t value, std::string_view what, std::string_view kind) {
  return fmt::format("<li class=\"{}\"><b>{}</b> {}</li>\n", value == 0 ? "none" : kind,
                     grouped(value), what);
}

/// May be broken behind its folders.
std::string path_text(std::string_view path) {
  std::string out;
  for (const char c : escaped(path)) out += c == '/' ? std::string("/<wbr/>") : std::string(1, c);
  return out;
}

std::string number_cell(double value, const std::string& shown, std::string_view kind = {}) {
  return fmt::format("<td class=\"n {}\" data-v=\"{}\">{}</td>", kind, number(value, 12), shown);
}

std::string triangle_cell(const TriangleCount& count) {
  const bool none = count.triangles == 0 && count.unread == 0;
  std::string shown = none ? "–" : grouped(count.triangles);
  if (count.unread > 0) {
    shown += fmt::format(" <span title=\"{} not read\">+ ?</span>",
                         counted(count.unread, "mesh", "meshes"));
  }
  if (count.over()) shown += " <span class=\"over\">over budget</span>";
  return number_cell(static_cast<double>(count.triangles), shown);
}

std::string finding_cell(std::size_t count, std::string_view kind) {
  return number_cell(static_cast<double>(count), count == 0 ? "–" : grouped(count),
                     count == 0 ? "" : kind);
}

/// What the table can be narrowed to.
std::string marks_of(const TeamReportRow& row) {
  std::string marks;
  const auto mark = [&marks](bool is, std::string_view word) {
    if (is) marks += (marks.empty() ? "" : " ") + std::string(word);
  };
  const bool failed = row.verdict == Verdict::kFail || row.verdict == Verdict::kInvalid;
  mark(row.errors > 0, "errors");
  mark(row.warnings > 0, "warnings");
  mark(failed, "fails");
  mark(over_any(row), "over");
  mark(row.errors + row.warnings == 0 && !failed && !over_any(row), "clean");
  return marks;
}

std::string verdict_cell(const TeamReportRow& row) {
  // Those that were not simulated are sorted behind the others.
  const auto rank = row.verdict ? static_cast<int>(*row.verdict) : -1;
  return fmt::format("<td data-v=\"{}\">{}</td>", rank,
                     row.verdict ? verdict_html(*row.verdict) : escaped(row.no_verdict));
}

std::string table_row(const TeamReportRow& row, bool verdicts) {
  std::string out = fmt::format(
      "<tr data-is=\"{}\"><td class=\"thumbnail\">{}</td><th scope=\"row\"><a href=\"{}\">{}</a>"
      "<small>{}</small></th><td>{}</td>",
      marks_of(row), row.image, escaped(row.link), escaped(printable(row.name, 80)),
      path_text(row.path), escaped(row.format));
  out += number_cell(static_cast<double>(row.links), grouped(row.links));
  out += number_cell(static_cast<double>(row.joints), grouped(row.joints));
  out += number_cell(row.mass, number(row.mass, 4));
  out += triangle_cell(row.visual) + triangle_cell(row.collision);
  out += finding_cell(row.errors, "error") + finding_cell(row.warnings, "warning");
  if (verdicts) out += verdict_cell(row);
  return out + "</tr>\n";
}

}  // namespace

std::string team_report_summary(const std::vector<TeamReportRow>& rows) {
  std::size_t errors = 0;
  std::size_t warnings = 0;
  std::size_t clean = 0;
  std::size_t over = 0;
  std::array<std::size_t, kVerdicts.size()> verdicts{};
  for (const TeamReportRow& row : rows) {
    errors += row.errors > 0 ? 1U : 0U;
    warnings += row.warnings > 0 ? 1U : 0U;
    clean += row.errors + row.warnings == 0 ? 1U : 0U;
    over += over_any(row) ? 1U : 0U;
    if (row.verdict) ++verdicts[static_cast<std::size_t>(*row.verdict)];
  }
  std::string out = "<ul class=\"tiles\">\n" + tile(rows.size(), "models", "") +
                    tile(clean, "without errors and warnings", "pass") +
                    tile(errors, "with errors", "error") +
                    tile(warnings, "with warnings", "warning") +
                    tile(over, "over a mesh budget", "warning") + "</ul>\n";
  if (!any_verdict(rows)) return out;
  out += "<ul class=\"tiles\" aria-label=\"Simulation\">\n";
  for (const Verdict verdict : kVerdicts) {
    const std::size_t count = verdicts[static_cast<std::size_t>(verdict)];
    if (count > 0)
      out += tile(count, fmt::format("simulated: {0}", to_string(verdict)), to_string(verdict));
  }
  return out + "</ul>\n";
}

std::string team_report_table(const std::vector<TeamReportRow>& rows) {
  if (rows.empty()) return "<p>No models.</p>\n";
  const bool verdicts = any_verdict(rows);
  std::string out =
      "<div id=\"tools\" hidden=\"hidden\"><label>Filter <input id=\"filter\" type=\"search\"/>"
      "</label> <label>Show <select id=\"only\"><option value=\"all\">all</option>"
      "<option value=\"errors\">with errors</option><option value=\"warnings\">with warnings"
      "</option><option value=\"fails\">failing in simulation</option>"
      "<option value=\"over\">over a budget</option><option value=\"clean\">clean</option>"
      "</select></label> <span id=\"shown\" role=\"status\"></span></div>\n"
      "<div class=\"wide\"><table id=\"models\"><thead><tr><th class=\"thumbnail\">Picture</th>"
      "<th>Model</th><th>Format</th><th class=\"n\">Links</th><th class=\"n\">Joints</th>"
      "<th class=\"n\">Mass, kg</th><th class=\"n\">Visual triangles</th>"
      "<th class=\"n\">Collision triangles</th><th class=\"n\">Errors</th>"
      "<th class=\"n\">Warnings</th>";
  if (verdicts) out += "<th>Simulation</th>";
  out += "</tr></thead><tbody>\n";
  for (const TeamReportRow& row : rows) out += table_row(row, verdicts);
  return out + "</tbody></table></div>\n";
}

}  // namespace rigor::report
