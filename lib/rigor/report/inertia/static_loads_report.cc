// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/report/inertia/static_loads_report.h>
#include <rigor/report/json/values.h>
#include <rigor/report/number.h>
#include <rigor/report/terminal/grid.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/tool.h>

namespace rigor::report {
namespace {

using robot::AxisLoad;

constexpr int kLoadDigits = 3;

// Joints of the worst pose that are listed: the first move most.
constexpr std::size_t kMaxJointsListed = 6;

const robot::Axis& axis_of(const LoadTable& table, const AxisLoad& load) {
  return table.robot.joints[load.joint].axes[load.axis];
}

const char* effort_unit(const robot::Axis& axis) {
  return axis.motion == robot::Axis::Motion::kSlide ? "N" : "N·m";
}

/// "shoulder", and "hip[1]" of a joint of several axes.
std::string axis_name(const LoadTable& table, const AxisLoad& load) {
  const robot::Joint& joint = table.robot.joints[load.joint];
  return joint.axes.size() == 1 ? joint.name : fmt::format("{}[{}]", joint.name, load.axis);
}

/// What the limit is of the load; nothing where one of them is none.
std::optional<double> margin(const AxisLoad& load) {
  const double effort = std::abs(load.effort);
  if (!std::isfinite(load.limit) || !(effort > 0)) return std::nullopt;
  return load.limit / effort;
}

std::string pose_text(const LoadTable& table, const AxisLoad& load) {
  std::string text;
  std::size_t listed = 0, moved = 0;
  for (std::size_t j = 0; j < load.at.size(); ++j) {
    for (std::size_t k = 0; k < load.at[j].size(); ++k) {
      const robot::Axis& axis = table.robot.joints[j].axes[k];
      if (axis.follow || load.at[j][k] == 0) continue;
      if (++moved > kMaxJointsListed) continue;
      text += fmt::format("{}{}={}", listed++ == 0 ? "" : " ", table.robot.joints[j].name,
                          number(load.at[j][k], kLoadDigits));
    }
  }
  if (moved > kMaxJointsListed) text += fmt::format(" and {} more", moved - kMaxJointsListed);
  return text.empty() ? "all at zero" : text;
}

}  // namespace

std::string loads_text(const LoadTable& table) {
  Grid grid;
  grid.row({"joint", "load", "limit", "limit/load", "at"});
  for (const AxisLoad& load : table.loads.axes) {
    const std::string unit = std::string(" ") + effort_unit(axis_of(table, load));
    const auto ratio = margin(load);
    grid.row({printable(axis_name(table, load)), number(std::abs(load.effort), kLoadDigits) + unit,
              std::isfinite(load.limit) ? number(load.limit, kLoadDigits) + unit : "none",
              ratio ? number(*ratio, kLoadDigits) + (*ratio < 1 ? ": cannot hold it" : "") : "-",
              printable(pose_text(table, load))});
  }
  std::string out = fmt::format("{}, gravity alone, {} poses and each joint's worst\n",
                                printable(table.path), table.request.samples + 1) +
                    grid.text();
  if (table.loads.reach) {
    const robot::Reach& reach = *table.loads.reach;
    out += fmt::format("reaches from {} to {} m\n", numbers(reach.min, kLoadDigits),
                       numbers(reach.max, kLoadDigits));
  }
  if (table.loads.has_loops) {
    out += "joints that close a loop are left open: the loads are those of the tree\n";
  }
  return out;
}

std::string loads_json(const LoadTable& table) {
  Json json;
  json["tool"] = {{"name", kToolName}, {"version", tool_version()}};
  json["schema_version"] = kSchemaVersion;
  json["path"] = table.path;
  json["model"] = table.robot.name;
  json["samples"] = table.request.samples;
  json["seed"] = table.request.seed;
  json["gravity"] = vector_of(table.request.gravity_M);
  json["has_loops"] = table.loads.has_loops;
  json["joints"] = Json::array();
  for (const AxisLoad& load : table.loads.axes) {
    const auto ratio = margin(load);
    Json at = Json::object();
    for (std::size_t j = 0; j < load.at.size(); ++j) {
      if (load.at[j].empty()) continue;
      at[table.robot.joints[j].name] = load.at[j];
    }
    json["joints"].push_back({{"name", table.robot.joints[load.joint].name},
                              {"axis", load.axis},
                              {"unit", effort_unit(axis_of(table, load))},
                              {"effort", finite(load.effort)},
                              {"limit", finite(load.limit)},
                              {"margin", ratio ? finite(*ratio) : Json(nullptr)},
                              {"at", std::move(at)}});
  }
  json["reach"] = nullptr;
  if (const auto& reach = table.loads.reach) {
    json["reach"] = {{"min", vector_of(reach->min)}, {"max", vector_of(reach->max)}};
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rigor::report
