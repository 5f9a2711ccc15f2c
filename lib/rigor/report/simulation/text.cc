// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include <fmt/core.h>

#include <rigor/report/number.h>
#include <rigor/report/simulation/run.h>
#include <rigor/report/simulation/simulation.h>
#include <rigor/report/terminal/pretty.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/text/grouping.h>

namespace rigor::report {
namespace {

using author::SimulatedModel;
using simulate::Verdict;

constexpr int kMetricDigits = 4;

Paint paint_of_verdict(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass: return Paint::kStrong;
    case Verdict::kWarn:
    case Verdict::kSolver: return Paint::kWarning;
    case Verdict::kFail:
    case Verdict::kInvalid: break;
  }
  return Paint::kError;
}

/// Padded to a column, and painted.
std::string verdict_cell(Verdict verdict, Color color) {
  const std::string_view word = to_string(verdict);
  return paint(word, paint_of_verdict(verdict), color) + std::string(8 - word.size(), ' ');
}

std::string amount(double value, std::string_view unit) {
  std::string text = number(value, kMetricDigits);
  if (!unit.empty()) text += fmt::format(" {}", unit);
  return text;
}

std::string metric_line(const simulate::Metric& metric, Color color) {
  const auto& limit = metric.verdict == Verdict::kFail ? metric.fail : metric.warn;
  std::string line = fmt::format("              {}{:<24}{}", verdict_cell(metric.verdict, color),
                                 metric.id, amount(metric.value, metric.unit));
  if (limit) line += fmt::format(" (limit {})", amount(*limit, metric.unit));
  return line + '\n';
}

/// "the same", "the same but rest.creep", "pass".
std::string confirmation_words(const simulate::Confirmation& each) {
  if (!each.in_time) return "took too long to say";
  if (!each.agrees) return std::string(to_string(each.verdict));
  std::string words = "the same";
  const char* joint = " but ";
  for (const std::string_view id : each.lacking) {
    words.append(joint).append(id);
    joint = " and ";
  }
  return words;
}

std::string confirmations_line(const simulate::Run& run) {
  std::string line;
  for (const simulate::Confirmation& each : run.confirmations) {
    line += fmt::format("{}{}: {}", line.empty() ? "" : ", ", each.what, confirmation_words(each));
  }
  return line.empty() ? line : fmt::format("              run again with {}\n", line);
}

std::string run_lines(const simulate::Run& run, Color color) {
  std::string name = run_name(run);
  if (run.seed != 0) name += fmt::format(" #{}", run.seed);
  std::string out = fmt::format("  {:<11} {}{} s in {} steps, {}\n", name,
                                verdict_cell(run.verdict, color), number(run.record.end_time),
                                run.record.steps, counted(run.metrics.size(), "metric"));
  for (const simulate::Metric& metric : run.metrics) {
    if (metric.verdict != Verdict::kPass) out += metric_line(metric, color);
  }
  return out + confirmations_line(run);
}

/// A metric with its verdict, where that is not to pass.
std::string side_of(double value, std::string_view unit, Verdict verdict) {
  std::string text = amount(value, unit);
  if (verdict != Verdict::kPass) text += fmt::format(" {}", to_string(verdict));
  return text;
}

/// ODE and MuJoCo side by side: the verdicts, and the metrics that do not pass in both.
std::string comparison_lines(const simulate::EngineComparison& each) {
  std::string out = fmt::format("  {:<11} {:<24}{:<24}{}\n", each.test, "engine", "ode", "mujoco");
  out += fmt::format("              {:<24}{:<24}{}\n", "verdict", to_string(each.ode),
                     to_string(each.mujoco));
  for (const simulate::MetricPair& pair : each.metrics) {
    if (pair.ode_verdict == Verdict::kPass && pair.mujoco_verdict == Verdict::kPass) continue;
    out += fmt::format("              {:<24}{:<24}{}\n", pair.id,
                       side_of(pair.ode, pair.unit, pair.ode_verdict),
                       side_of(pair.mujoco, pair.unit, pair.mujoco_verdict));
  }
  if (std::isfinite(each.apart)) {
    out += fmt::format("              {:<24}{} %\n", "ends apart", number(100 * each.apart, 3));
  }
  return out;
}

std::string model_lines(const SimulatedModel& model, Color color) {
  std::string out =
      fmt::format("{}: {}{}\n", printable(case_name(model)),
                  paint(to_string(model.verdict()), paint_of_verdict(model.verdict()), color),
                  model.untested() ? ", but nothing was tested" : "");
  for (const simulate::Run& run : model.simulation.runs) out += run_lines(run, color);
  for (const simulate::EngineComparison& each : model.simulation.comparisons) {
    out += comparison_lines(each);
  }
  for (const std::string& note : model.notes) {
    out += fmt::format("  note        {}\n", printable(note));
  }
  for (const std::string& why : model.left_out) {
    out += fmt::format("  left out    {}\n", printable(why));
  }
  return out;
}

/// Of several models: a line each.
std::string table_line(const SimulatedModel& model, Color color) {
  std::string line = "  " + verdict_cell(model.verdict(), color) + printable(case_name(model));
  std::string failed;
  for (const simulate::Run& run : model.simulation.runs) {
    if (run.verdict == Verdict::kPass) continue;
    failed +=
        fmt::format("{}{} {}", failed.empty() ? "" : ", ", run_name(run), to_string(run.verdict));
  }
  if (model.untested()) failed = "nothing was tested";
  if (!failed.empty()) line += "  (" + failed + ')';
  return line + '\n';
}

}  // namespace

std::string simulation_text(const SimulationReport& report, Color color) {
  std::string out;
  for (const SimulatedModel& model : report.models) {
    out += pretty(grouped(model.diagnostics), report.sources, color);
  }
  const bool several = report.models.size() > 1;
  for (const SimulatedModel& model : report.models) {
    out += several ? table_line(model, color) : model_lines(model, color);
  }
  return out;
}

std::string case_name(const SimulatedModel& model) {
  const bool is_plain = model.one.values.empty() && model.one.seed == 0;
  return is_plain ? model.path : model.path + " [" + model.one.id + ']';
}

std::string simulation_summary(const SimulationReport& report) {
  std::array<std::size_t, 5> counts{};
  std::set<std::string_view> paths;
  for (const SimulatedModel& model : report.models) {
    paths.insert(model.path);
    ++counts[static_cast<std::size_t>(model.verdict())];
  }
  std::string out = counted(paths.size(), "model");
  if (paths.size() < report.models.size()) {
    out += " in " + counted(report.models.size(), "case");
  }
  const char* separator = ": ";
  for (const Verdict verdict :
       {Verdict::kPass, Verdict::kWarn, Verdict::kSolver, Verdict::kFail, Verdict::kInvalid}) {
    const std::size_t count = counts[static_cast<std::size_t>(verdict)];
    if (count == 0) continue;
    out += fmt::format("{}{} {}", separator, count, to_string(verdict));
    separator = ", ";
  }
  const auto untested = std::count_if(report.models.begin(), report.models.end(),
                                      [](const SimulatedModel& model) { return model.untested(); });
  if (untested > 0) out += fmt::format("; {} untested", untested);
  return out;
}

}  // namespace rigor::report
