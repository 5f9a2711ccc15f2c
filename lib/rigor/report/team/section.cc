// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/team/section.h>

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include <rigor/mesh/triangle_budget.h>
#include <rigor/report/html/finding_list.h>
#include <rigor/report/html/markup.h>
#include <rigor/report/number.h>
#include <rigor/report/simulation/run.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>

namespace rigor::report {
namespace {

/// Lines of a list that are shown; what is missing in a large world is counted.
constexpr std::size_t kMaxLines = 20;

/// Of a model, before what is folded.
constexpr std::size_t kFirstFindings = 3;
constexpr std::size_t kLongestFinding = 200;

std::string list_of(const std::vector<std::string>& lines) {
  std::string out = "<ul>\n";
  for (std::size_t i = 0; i < std::min(lines.size(), kMaxLines); ++i) {
    out += "<li>" + escaped(printable(lines[i])) + "</li>\n";
  }
  if (lines.size() > kMaxLines) {
    out += fmt::format("<li>and {} more</li>\n", lines.size() - kMaxLines);
  }
  return out + "</ul>\n";
}

std::string fact(std::string_view name, const std::string& value) {
  return fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", name, value);
}

std::string facts(const ReportedModel& model, const TeamReportRow& row) {
  std::string out = "<table>\n" + fact("Format", escaped(row.format));
  out += fact("Links, joints", fmt::format("{}, {}", row.links, row.joints));
  out += fact("Mass", number(row.mass) + " kg");
  if (model.models.size() == 1 && model.models[0].totals.com) {
    out += fact("Center of mass", numbers(*model.models[0].totals.com, 4) + " m");
  }
  std::string triangles =
      fmt::format("{} to see, {} to collide with", row.visual.triangles, row.collision.triangles);
  if (const std::size_t unread = row.visual.unread + row.collision.unread; unread > 0) {
    triangles += fmt::format("; {} not read", counted(unread, "mesh", "meshes"));
  }
  out += fact("Triangles of meshes", triangles);
  return out + "</table>\n";
}

std::string top_models_table(const std::vector<TopModel>& models) {
  if (models.size() < 2) return {};
  std::string out = fmt::format(
      "<details><summary>{}</summary><div class=\"wide\"><table><tr><th>Model</th>"
      "<th class=\"n\">Links</th><th class=\"n\">Joints</th><th class=\"n\">Mass, kg</th></tr>\n",
      counted(models.size(), "model"));
  for (const TopModel& model : models) {
    out += fmt::format(
        "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
        "class=\"n\">{}</td></tr>\n",
        escaped(printable(model.name)), model.totals.links, model.totals.joints,
        number(model.totals.mass));
  }
  return out + "</table></div></details>\n";
}

std::uint64_t budget_of(const MeshUse& use) {
  return use.collision ? mesh::kMaxCollisionTriangles : mesh::kMaxVisualTriangles;
}

bool is_over(const MeshUse& use) { return use.triangles.value_or(0) > budget_of(use); }

/// Largest first.
std::string mesh_table(std::vector<MeshUse> meshes) {
  if (meshes.empty()) return {};
  std::stable_sort(meshes.begin(), meshes.end(),
                   [](const MeshUse& a, const MeshUse& b) { return a.triangles > b.triangles; });
  const auto over = static_cast<std::size_t>(std::count_if(meshes.begin(), meshes.end(), is_over));
  std::string out = fmt::format(
      "<details><summary>{}{}</summary><div class=\"wide\"><table><tr><th>Mesh</th><th>Used "
      "as</th>"
      "<th class=\"n\">Triangles</th><th class=\"n\">Budget</th><th></th></tr>\n",
      counted(meshes.size(), "mesh", "meshes"),
      over > 0 ? fmt::format(", {} over the budget of a mesh", over) : "");
  for (const MeshUse& use : meshes) {
    const std::string times = use.times > 1 ? fmt::format(", {} times", use.times) : "";
    out += fmt::format(
        "<tr><td>{}</td><td>{}{}</td><td class=\"n\">{}</td><td "
        "class=\"n\">{}</td><td>{}</td></tr>\n",
        escaped(printable(use.uri)), use.collision ? "collision" : "visual", times,
        use.triangles ? fmt::to_string(*use.triangles) : "not read", budget_of(use),
        is_over(use) ? "<span class=\"over\">over budget</span>" : "");
  }
  return out + "</table></div></details>\n";
}

std::string verdict_words(const TeamReportRow& row) {
  return row.verdict ? verdict_html(*row.verdict) : row.no_verdict;
}

/// The most severe findings of all, in a line each: what a reader wants to know before anything is unfolded.
std::string first_findings(std::vector<const Diagnostic*> findings, const ReportedModel& model) {
  if (model.simulation != nullptr) {
    for (const Diagnostic& each : model.simulation->diagnostics.list()) findings.push_back(&each);
  }
  std::stable_sort(findings.begin(), findings.end(), [](const Diagnostic* a, const Diagnostic* b) {
    return a->severity < b->severity;
  });
  std::string items;
  for (std::size_t i = 0; i < std::min(findings.size(), kFirstFindings); ++i) {
    const Diagnostic& each = *findings[i];
    items += fmt::format(
        "<li>{}</li>\n",
        escaped(printable(each.subject.empty() ? each.message : each.subject + ": " + each.message,
                          kLongestFinding)));
  }
  return items.empty() ? "" : "<ol class=\"causes\">\n" + items + "</ol>\n";
}

std::string simulation_part(const ReportedModel& model, const TeamReportRow& row,
                            const SectionPage& page) {
  if (model.simulation == nullptr) return {};
  const author::SimulatedModel& simulation = *model.simulation;
  std::string out = "<h3>Simulation: " + verdict_words(row) + "</h3>\n";
  std::vector<const Diagnostic*> findings;
  for (const Diagnostic& each : simulation.diagnostics.list()) findings.push_back(&each);
  out += finding_list(findings, page.places, page.rules);
  for (const simulate::Run& run : simulation.simulation.runs) {
    out += run_html(simulation.scene, run);
  }
  return out;
}

/// What nobody examined, so that silence about it is not taken for praise.
std::string not_looked_at(const ReportedModel& model, const SectionPage& page) {
  const rules::ValidateResult& result = page.validation.result;
  const std::string& path = result.files[model.file].path;
  std::vector<std::string> lines;
  for (const rules::NotLookedAt& item : result.not_looked_at) {
    if (item.path == path && !item.index) lines.push_back("not checked: " + item.what);
  }
  for (const std::string& each : model.not_drawn) lines.push_back("not drawn: " + each);
  if (!model.not_simulated.empty()) lines.push_back("not simulated: " + model.not_simulated);
  if (model.simulation != nullptr) {
    for (const std::string& each : model.simulation->left_out) {
      lines.push_back("not simulated: " + each);
    }
  }
  return lines.empty() ? "" : "<h3>Skipped</h3>\n" + list_of(lines);
}

}  // namespace

std::vector<const Diagnostic*> findings_of(const Validation& validation, std::size_t file) {
  const rules::FileSummary& summary = validation.result.files[file];
  std::vector<const Diagnostic*> findings;
  for (std::size_t i = summary.first_finding; i < summary.end_finding; ++i) {
    findings.push_back(&validation.result.diagnostics.list()[i]);
  }
  return findings;
}

std::string format_text(const rules::FileSummary& file) {
  switch (file.format) {
    case model::Format::kSdf: return "SDF " + printable(file.version, 8);
    case model::Format::kUrdf: return "URDF";
    case model::Format::kMjcf: return "MJCF";
    default: return "?";
  }
}

std::string team_report_section(const ReportedModel& model, const TeamReportRow& row,
                                const SectionPage& page) {
  const std::vector<const Diagnostic*> findings = findings_of(page.validation, model.file);
  std::string summary = findings.empty() ? "No findings" : counted(findings.size(), "finding");
  std::string verdict;
  if (model.simulation != nullptr) {
    verdict = "<p>Simulation: " + verdict_words(row) + "</p>\n";
    summary += ", simulation";
  }
  const std::string skipped = not_looked_at(model, page);
  if (!skipped.empty()) summary += ", what was skipped";
  std::string out = fmt::format(
      "<h2>{} <small>{}</small></h2>\n<div class=\"facts\">{}<div>{}{}</div><div>{}{}{}",
      escaped(printable(row.name, 200)), escaped(row.path), page.image, verdict,
      first_findings(findings, model), facts(model, row), top_models_table(model.models),
      mesh_table(model.meshes));
  out += "</div></div>\n<details><summary>" + summary + "</summary>\n";
  if (!findings.empty()) out += "<h3>Findings</h3>\n";
  out += finding_list(findings, page.places, page.rules);
  return out + simulation_part(model, row, page) + skipped + "</details>\n";
}

}  // namespace rigor::report
