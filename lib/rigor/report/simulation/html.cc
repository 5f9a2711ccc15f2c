// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <rigor/report/html/finding_list.h>
#include <rigor/report/html/markup.h>
#include <rigor/report/html/page.h>
#include <rigor/report/places.h>
#include <rigor/report/simulation/run.h>
#include <rigor/report/simulation/simulation.h>
#include <rigor/report/team/script.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/report/tool.h>
#include <rigor/text/base64.h>

namespace rigor::report {
namespace {

using author::SimulatedModel;

/// Findings that are told beside the image.
constexpr std::size_t kCauses = 3;
constexpr std::size_t kLongestCause = 240;  // of a help; all of it is in the folded list

/// A model takes no more height than its image, so that ten fit on three screens.
constexpr std::string_view kSimulationStyle = R"(
.model{margin-top:.8rem;padding-top:.6rem;contain-intrinsic-size:auto 15rem}.model>.facts{gap:1rem;flex-wrap:nowrap}
.facts>img{width:15rem;flex:none}.facts>div{flex:1 1 24rem}.model h2{font-size:1.1rem;display:inline;margin:0 .7rem 0 0}
.verdict{font-weight:bold;border:1px solid currentColor;border-radius:.4rem;padding:0 .5rem}
.causes{padding-left:1.2rem;margin:.3rem 0;line-height:1.3;font-size:.9rem}.causes li{margin:.25rem 0}.causes small{display:block;font-size:.8rem}
.runs{list-style:none;padding:0;margin:.2rem 0;font-size:.9rem}.runs li{display:inline-block;margin-right:1.2rem}
.model details{margin:.2rem 0}
@media(max-width:40rem){.model>.facts{flex-wrap:wrap}}
)";

using Findings = std::vector<const Diagnostic*>;

/// Those that name a cause come first, then the most severe.
Findings causes_of(const SimulatedModel& model) {
  Findings all;
  for (const Diagnostic& each : model.diagnostics.list()) all.push_back(&each);
  std::stable_sort(all.begin(), all.end(), [](const Diagnostic* a, const Diagnostic* b) {
    const auto names_none = [](const Diagnostic* finding) { return finding->help.empty(); };
    if (a->severity != b->severity) return a->severity < b->severity;
    return names_none(a) < names_none(b);
  });
  all.resize(std::min(all.size(), kCauses));
  return all;
}

std::string causes_html(const SimulatedModel& model) {
  std::string items;
  for (const Diagnostic* each : causes_of(model)) {
    items +=
        fmt::format("<li>{}<small class=\"soft\">{}</small></li>\n",
                    escaped(printable(each->subject.empty() ? each->message
                                                            : each->subject + ": " + each->message,
                                      kLongestCause)),
                    escaped(printable(help_of(*each), kLongestCause)));
  }
  return items.empty() ? "" : "<ol class=\"causes\">\n" + items + "</ol>\n";
}

std::string runs_html(const std::vector<simulate::Run>& runs) {
  std::string items;
  for (const simulate::Run& run : runs) {
    items += fmt::format("<li>{} {}</li>", escaped(run_name(run)), verdict_html(run.verdict));
  }
  return items.empty() ? "" : "<ul class=\"runs\">" + items + "</ul>\n";
}

std::string picture_html(const std::string& png) {
  if (png.empty()) return {};
  return fmt::format(
      "<img src=\"data:image/png;base64,{}\" alt=\"The model as it begins\" width=\"{}\" "
      "height=\"{}\"/>",
      base64(png), kSimulatedPictureWidth, kSimulatedPictureHeight);
}

/// What is folded: "3 findings, 2 tests with plots, 1 note, 1 left out".
std::string folded_words(const SimulatedModel& model) {
  std::string words = counted(model.diagnostics.list().size(), "finding") + ", " +
                      counted(model.simulation.runs.size(), "test") + " with metrics and plots";
  if (!model.notes.empty()) words += ", " + counted(model.notes.size(), "note");
  if (!model.left_out.empty()) words += ", " + std::to_string(model.left_out.size()) + " left out";
  return words;
}

std::string model_section(const SimulatedModel& model, const std::string& png, Places& places) {
  const std::vector<simulate::Run>& runs = model.simulation.runs;
  std::string out = fmt::format(
      "<section class=\"model\">\n<div class=\"facts\">{}<div>\n<h2>{}</h2>\n<span "
      "class=\"verdict {}\">{}</span>\n{}{}{}",
      picture_html(png), escaped(printable(case_name(model))), to_string(model.verdict()),
      to_string(model.verdict()), runs_html(runs), causes_html(model),
      model.untested() ? "<p>Nothing was tested.</p>\n" : "");
  out += "<details><summary>" + folded_words(model) + "</summary>\n";
  for (const std::string& note : model.notes) {
    out += "<p>" + escaped(printable(note)) + "</p>\n";
  }
  for (const std::string& why : model.left_out) {
    out += "<p>left out: " + escaped(printable(why)) + "</p>\n";
  }
  Findings findings;
  for (const Diagnostic& each : model.diagnostics.list()) findings.push_back(&each);
  if (!findings.empty()) out += finding_list(findings, places, "#rule-");
  for (const simulate::Run& run : runs) out += run_html(model.scene, run);
  return out + "</details></div></div>\n</section>\n";
}

}  // namespace

std::string simulation_html(const SimulationReport& report) {
  const std::string style = std::string(team_report_style()).append(kSimulationStyle);
  std::string out = begin_page({.title = "rigor simulate", .style = style, .images = "data:"}) +
                    fmt::format("<h1>{}</h1>\n<p class=\"soft\">{} {}</p>\n",
                                escaped(simulation_summary(report)), kToolName, tool_version());
  Places places(report.sources);
  for (std::size_t i = 0; i < report.models.size(); ++i) {
    const bool drawn = i < report.pictures.size();
    out += model_section(report.models[i], drawn ? report.pictures[i] : "", places);
  }
  return out + end_page();
}

}  // namespace rigor::report
