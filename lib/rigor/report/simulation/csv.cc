// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/report/number.h>
#include <rigor/report/simulation/run.h>
#include <rigor/report/simulation/simulation.h>

namespace rigor::report {
namespace {

/// As many digits as give a double back.
constexpr int kExact = 17;

/// RFC 4180: in quotes when it holds what separates.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') quoted += c;
  }
  return quoted + '"';
}

std::string csv_head(const simulate::Scene& scene) {
  std::string line = "model,test,seed,time";
  for (const simulate::SceneLink& link : scene.links) {
    for (const char* part : {"x", "y", "z", "qw", "qx", "qy", "qz"}) {
      line += ',' + csv_field(link.name + '.' + part);
    }
  }
  for (const simulate::SceneJoint& joint : scene.joints) {
    for (std::size_t axis = 0; axis < joint.axes.size(); ++axis) {
      const std::string name =
          axis == 0 ? joint.name : fmt::format("{}.axis{}", joint.name, axis + 1);
      line += ',' + csv_field(name + ".position") + ',' + csv_field(name + ".velocity");
    }
  }
  return line + '\n';
}

void add_number(std::string& line, double value) { line += ',' + number(value, kExact); }

std::string csv_rows(const author::SimulatedModel& model, const simulate::Run& run) {
  const simulate::Record& record = run.record;
  const std::size_t links = model.scene.links.size();
  const std::size_t values =
      record.times.empty() ? 0 : record.axis_values.size() / record.times.size();
  std::string out;
  for (std::size_t i = 0; i < record.times.size(); ++i) {
    std::string line =
        fmt::format("{},{},{}", csv_field(case_name(model)), csv_field(run_name(run)), run.seed);
    add_number(line, record.times[i]);
    for (std::size_t k = i * links; k < (i + 1) * links; ++k) {
      const auto& [p, q] = record.link_poses[k];
      for (const double each : {p.x, p.y, p.z, q.w, q.x, q.y, q.z}) add_number(line, each);
    }
    for (std::size_t k = i * values; k < (i + 1) * values; ++k)
      add_number(line, record.axis_values[k]);
    out += line + '\n';
  }
  return out;
}

}  // namespace

std::string simulation_csv(const SimulationReport& report) {
  std::string out;
  for (const author::SimulatedModel& model : report.models) {
    if (model.simulation.runs.empty()) continue;
    out += csv_head(model.scene);
    for (const simulate::Run& run : model.simulation.runs) out += csv_rows(model, run);
  }
  return out;
}

}  // namespace rigor::report
