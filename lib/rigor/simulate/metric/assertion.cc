// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/metric/assertion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace rigor::simulate {
namespace {

/// Roll, pitch and yaw, as in model::from_rpy.
std::array<double, 3> rpy_of(const Quaternion& q) {
  const model::Matrix3 R = model::to_matrix(q);
  return {std::atan2(R[2][1], R[2][2]), std::asin(std::clamp(-R[2][0], -1.0, 1.0)),
          std::atan2(R[1][0], R[0][0])};
}

std::optional<double> of_pose(const Pose& pose, std::string_view what) {
  if (what == "x") return pose.translation.x;
  if (what == "y") return pose.translation.y;
  if (what == "z") return pose.translation.z;
  const std::array<double, 3> rpy = rpy_of(pose.rotation);
  if (what == "roll") return rpy[0];
  if (what == "pitch") return rpy[1];
  if (what == "yaw") return rpy[2];
  return std::nullopt;
}

/// What is asked for, in one row of the trajectory.
std::optional<double> in_row(const Scene& scene, const Record& record, std::size_t row,
                             std::string_view what, std::string_view of) {
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    if (!is_named(scene.links[l].name, of)) continue;
    const std::size_t at = row * scene.links.size() + l;
    const std::optional<double> value =
        at < record.link_poses.size() ? of_pose(record.link_poses[at], what) : std::nullopt;
    if (value) return value;
  }
  std::size_t axes = 0;
  std::optional<std::size_t> axis;
  for (const SceneJoint& joint : scene.joints) {
    if (!axis && !joint.axes.empty() && is_named(joint.name, of)) axis = axes;
    axes += joint.axes.size();
  }
  if (!axis || (what != "position" && what != "velocity")) return std::nullopt;
  const std::size_t at = (row * axes + *axis) * 2 + (what == "velocity" ? 1 : 0);
  if (at >= record.axis_values.size()) return std::nullopt;
  return record.axis_values[at];
}

bool is_angle(std::string_view what) { return what == "roll" || what == "pitch" || what == "yaw"; }

}  // namespace

std::optional<double> quantity_at(const Scene& scene, const Record& record,
                                  std::string_view quantity, double time) {
  const std::size_t gap = quantity.find(" of ");
  if (gap == std::string_view::npos || record.times.empty()) return std::nullopt;
  const std::string_view what = quantity.substr(0, gap);
  const std::string_view of = quantity.substr(gap + 4);
  const auto after = std::lower_bound(record.times.begin(), record.times.end(), time);
  const std::size_t last = record.times.size() - 1;
  const std::size_t right = std::min(last, static_cast<std::size_t>(after - record.times.begin()));
  // Beyond the last row there is nothing to tell, but for the rounding of times.
  if (std::isfinite(time) && time > record.times[last] + 1e-6) return std::nullopt;
  const std::size_t left = right > 0 ? right - 1 : 0;
  const double span = record.times[right] - record.times[left];
  const double share = std::isfinite(time) && span > 0
                           ? std::clamp((time - record.times[left]) / span, 0.0, 1.0)
                           : 1;
  const std::optional<double> a = in_row(scene, record, left, what, of);
  const std::optional<double> b = in_row(scene, record, right, what, of);
  if (!a || !b) return std::nullopt;
  if (is_angle(what)) return share < 0.5 ? a : b;
  return *a + share * (*b - *a);
}

Facts broken_assertions(const Scene& scene, const Scenario& scenario, const Record& record,
                        const std::vector<Metric>& metrics) {
  Facts broken;
  for (const Assertion& assertion : scenario.assertions) {
    std::optional<double> value;
    if (assertion.metric.empty()) {
      value = quantity_at(scene, record, assertion.quantity,
                          assertion.at > 0 ? assertion.at : kInfinity);
    } else {
      const auto metric = std::find_if(metrics.begin(), metrics.end(),
                                       [&](const Metric& m) { return m.id == assertion.metric; });
      if (metric != metrics.end()) value = metric->value;
    }
    if (value && *value >= assertion.least && *value <= assertion.most) continue;
    Fact fact{.kind = FactKind::kAssertion, .name = assertion.name, .test = scenario.name};
    fact.value = value ? *value : std::numeric_limits<double>::quiet_NaN();
    fact.limit = value && *value < assertion.least ? assertion.least : assertion.most;
    broken.push_back(std::move(fact));
  }
  return broken;
}

}  // namespace rigor::simulate
