// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/report/html/markup.h>
#include <rigor/report/html/page.h>
#include <rigor/report/simulation/run.h>
#include <rigor/report/simulation/simulation.h>
#include <rigor/report/terminal/concise.h>
#include <rigor/report/tool.h>

namespace rigor::report {
namespace {

using author::SimulatedModel;

std::string model_section(const SimulatedModel& model, const Sources& sources) {
  std::string out =
      fmt::format("<h2>{} – {}</h2>\n", escaped(case_name(model)), verdict_html(model.verdict()));
  if (model.untested()) out += "<p>Nothing was tested.</p>\n";
  const std::string findings = concise(model.diagnostics, sources);
  if (!findings.empty()) out += "<pre>" + escaped(findings) + "</pre>\n";
  for (const simulate::Run& run : model.simulation.runs) out += run_html(model.scene, run);
  for (const std::string& note : model.notes) out += "<p>" + escaped(note) + "</p>\n";
  for (const std::string& why : model.left_out) out += "<p>left out: " + escaped(why) + "</p>\n";
  return out;
}

}  // namespace

std::string simulation_html(const SimulationReport& report) {
  std::string out = begin_page({.title = "rigor simulate"}) +
                    fmt::format("<h1>{}</h1>\n<p>{} {}</p>\n", escaped(simulation_summary(report)),
                                kToolName, tool_version());
  for (const SimulatedModel& model : report.models) out += model_section(model, report.sources);
  return out + end_page();
}

}  // namespace rigor::report
