// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/tool.h>

#include <fmt/core.h>
#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <rigor/mesh/engines.h>
#include <rigor/results/writer.h>
#include <rigor/simulate/engine/mujoco/mujoco_version.h>
#include <rigor/simulate/engine/ode/ode_version.h>
#include <rigor/xml/engine.h>

namespace rigor::report {

std::string_view tool_version() { return RIGOR_VERSION; }

std::vector<Engine> engines() {
  return {
      {"Eigen",
       fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"fmt",
       fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"meshoptimizer", mesh::meshoptimizer_version()},
      {"MuJoCo", simulate::mujoco_version().empty()
                     ? "(built without)"
                     : simulate::mujoco_version() + " (opened where it is installed)"},
      {"ODE", simulate::ode_version().empty() ? "(built without)" : simulate::ode_version()},
      {"Qhull", mesh::qhull_version()},
      {"SQLite", results::sqlite_version().empty() ? "(built without)" : results::sqlite_version()},
      {"tinyxml2", xml::tinyxml2_version()},
  };
}

std::string version_text() {
  std::string out = fmt::format("{} {}\n", kToolName, tool_version());
  for (const Engine& engine : engines())
    out += fmt::format("  {} {}\n", engine.name, engine.version);
  return out;
}

std::string version_json() {
  nlohmann::ordered_json json;
  json["tool"] = {{"name", kToolName}, {"version", tool_version()}};
  json["schema_version"] = kSchemaVersion;
  json["engines"] = nlohmann::ordered_json::object();
  for (const Engine& engine : engines()) json["engines"][engine.name] = engine.version;
  return json.dump(2) + '\n';
}

}  // namespace rigor::report
