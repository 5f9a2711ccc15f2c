// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor inertia MODEL --loads`: what gravity asks of the joints, beside what their motors can give.

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rigor/report/inertia/static_loads_report.h>
#include <rigor/rules/environment.h>

#include "command/command.h"
#include "command/inertia.h"
#include "model/model_file.h"
#include "model/robot_file.h"
#include "output/progress.h"

namespace rigor::tool {
namespace {

/// A run of this many takes about a second for a robot of 30 joints.
constexpr std::uint64_t kMaxSamples = 1'000'000;

std::uint64_t whole_number(const char* option, const std::string& text, std::uint64_t most) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value > most) {
    throw UsageError(std::string(option) + " " + text + " is not a whole number from 0 to " +
                     std::to_string(most));
  }
  return value;
}

robot::LoadRequest request_of(const InertiaArguments& a) {
  robot::LoadRequest request;
  if (!a.samples.empty()) request.samples = whole_number("--samples", a.samples, kMaxSamples);
  if (!a.seed.empty()) request.seed = whole_number("--seed", a.seed, UINT64_MAX);
  return request;
}

}  // namespace

int run_static_loads(const InertiaArguments& a) {
  if (a.what.empty() || is_shape_name(a.what)) throw UsageError("--loads needs a model");
  if (a.diff || a.write) throw UsageError("--loads prints a table; leave out --diff and --write");
  const robot::LoadRequest request = request_of(a);
  const std::vector<Target> targets = a.output.targets_of({"text", "json"});
  const GuardedDisk real = a.search.disk({a.what});
  const ProgressDisk disk(real);
  Environment environment(disk, a.search.paths());
  a.search.allow(environment.workers);
  Sources sources;
  read::Workspace workspace(environment.resolver, sources);
  RobotFiles files(environment, sources, workspace);
  const read::Loaded loaded = files.load(a.what);
  const std::optional<robot::Robot> robot = files.robot(loaded, a.model);
  if (!robot) return kFindings;
  const robot::StaticLoads loads = static_loads(*robot, request);
  const report::LoadTable table{loaded.file->path, *robot, request, loads};
  bool holds = true;
  for (const robot::AxisLoad& load : loads.axes) {
    holds = holds && !(std::abs(load.effort) > load.limit);
  }
  for (const Target& target : targets) {
    write(target, target.format == 0 ? report::loads_text(table) : report::loads_json(table));
  }
  return holds ? kClean : kFindings;
}

}  // namespace rigor::tool
