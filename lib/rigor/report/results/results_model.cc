// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/results/results_model.h>

#include <vector>

#include <fmt/core.h>

#include <rigor/report/html/markup.h>
#include <rigor/report/number.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>

namespace rigor::report {
namespace {

/// Characters of any one text, which may be as long as a file.
constexpr std::size_t kLongestResultText = 300;

std::string result_text(std::string_view text) {
  return escaped(printable(text, kLongestResultText));
}

std::string and_more(std::uint64_t all, std::size_t listed) {
  if (all <= listed) return {};
  return fmt::format("<p class=\"soft\">and {} more</p>\n", all - listed);
}

std::string place_words(const results::FindingRow& finding, const std::string& model) {
  std::string place;
  if (finding.place.path != model) place = result_text(finding.place.path);
  if (finding.place.line) {
    place += place.empty() ? "line " : ":";
    place += std::to_string(*finding.place.line);
  }
  if (finding.places > 1) place += fmt::format(" and {} more places", finding.places - 1);
  if (!finding.place.subject.empty())
    place += (place.empty() ? "" : ", ") + result_text(finding.place.subject);
  return place;
}

std::string findings_html(const results::ModelRow& model, const results::ModelDetails& details,
                          const RulePages& rules) {
  if (details.findings.empty()) return {};
  std::string out = "<ul class=\"findings\">\n";
  for (const results::FindingRow& each : details.findings) {
    const auto page = rules.find({each.rule, each.severity});
    std::string rule = result_text(each.rule);
    if (page != rules.end())
      rule = fmt::format("<a href=\"../rules/{}.html\">{}</a>", page->second, rule);
    const std::string severity = result_text(each.severity);
    out += fmt::format(
        "<li class=\"finding {0}\"><p><span class=\"badge\">{0}</span> {1} {2}</p>"
        "<p class=\"note\">{3}</p></li>\n",
        severity, result_text(each.place.message), rule, place_words(each, model.path));
  }
  return out + "</ul>\n" + and_more(details.all_findings, details.findings.size());
}

std::string extents_words(const results::MeshFile& mesh) {
  if (!mesh.min || !mesh.max) return {};
  std::string out;
  for (std::size_t i = 0; i < 3; ++i)
    out += (i == 0 ? "" : " × ") + number((*mesh.max)[i] - (*mesh.min)[i], 4);
  return out;
}

std::string meshes_html(const results::ModelDetails& details) {
  if (details.meshes.empty()) return {};
  std::string out = "<details><summary>" + counted(details.all_meshes, "mesh", "meshes") +
                    "</summary><table><thead><tr><th>File</th><th>Triangles</th><th>Bytes</th>"
                    "<th>Extents (file's unit)</th><th>Digest</th></tr></thead><tbody>\n";
  for (const results::MeshFile& each : details.meshes) {
    out += fmt::format(
        "<tr><td>{}</td><td class=\"n\">{}</td><td "
        "class=\"n\">{}</td><td>{}</td><td>{}</td></tr>\n",
        results_path(each.path), each.triangles ? std::to_string(*each.triangles) : "not read",
        each.bytes, extents_words(each), result_text(each.digest).substr(0, 12));
  }
  return out + "</tbody></table>" + and_more(details.all_meshes, details.meshes.size()) +
         "</details>\n";
}

std::string cases_html(const results::ModelDetails& details) {
  if (details.cases.empty()) return {};
  std::string out =
      "<table><thead><tr><th>Simulation</th><th>Verdict</th><th>Beyond limits</th></tr></thead>"
      "<tbody>\n";
  for (const results::CaseRow& each : details.cases) {
    out += fmt::format("<tr><td>{0}</td><td class=\"{1}\">{1}</td><td>{2}</td></tr>\n",
                       result_text(each.name), result_text(each.verdict), result_text(each.limits));
  }
  return out + "</tbody></table>\n" + and_more(details.all_cases, details.cases.size());
}

std::string skipped_html(const results::ModelDetails& details) {
  if (details.skipped.empty()) return {};
  std::string out = "<p>Skipped:</p><ul>\n";
  for (const std::string& each : details.skipped) out += "<li>" + result_text(each) + "</li>\n";
  return out + "</ul>\n" + and_more(details.all_skipped, details.skipped.size());
}

std::string model_words(const results::ModelRow& model) {
  std::string out(results_worst(model.worst));
  if (!model.kind.empty()) {
    out += " · " + result_text(model.kind);
    if (!model.version.empty()) out += " " + result_text(model.version);
  }
  const auto add = [&out](const std::optional<std::int64_t>& count, std::string_view noun) {
    if (count && *count >= 0) out += " · " + counted(static_cast<std::size_t>(*count), noun);
  };
  add(model.links, "link");
  add(model.joints, "joint");
  if (!model.verdict.empty()) out += " · simulation: " + result_text(model.verdict);
  return out;
}

}  // namespace

std::string results_path(std::string_view path) {
  std::string out;
  for (const char c : result_text(path))
    out += c == '/' ? std::string("/<wbr/>") : std::string(1, c);
  return out;
}

std::string_view results_worst(results::Worst worst) {
  switch (worst) {
    case results::Worst::kError: return "error";
    case results::Worst::kWarning: return "warning";
    case results::Worst::kInfo: return "info";
    case results::Worst::kClean: break;
  }
  return "clean";
}

std::string results_model(const results::ModelRow& model, const results::ModelDetails& details,
                          const RulePages& rules) {
  return fmt::format("<section class=\"model\" id=\"m{}\">\n<h2>{}<small>{}</small></h2>\n",
                     model.id, results_path(model.path), model_words(model)) +
         findings_html(model, details, rules) + cases_html(details) + meshes_html(details) +
         skipped_html(details) + "</section>\n";
}

}  // namespace rigor::report
