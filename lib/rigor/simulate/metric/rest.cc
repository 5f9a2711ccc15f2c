// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Metrics of a robot that should stand still: of the phase "rest", and of how it got there.

#include <rigor/simulate/metric/parts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <rigor/simulate/footprint.h>
#include <rigor/simulate/test/parts.h>

namespace rigor::simulate {
namespace {

/// What had half of gravity all the time is held by nothing.
constexpr double kFallingShare = 0.5;

/// A run that is shorter can't tell what takes long from what never ends.
constexpr double kLongEnough = 1;  // s

/// A servo that is solved with the motion comes to rest to within a step: 0.1 mrad to and fro in steps of 1 ms are 0.1 rad/s that
/// no encoder sees. Limits on speed at rest are so many times as wide where servos hold a robot.
constexpr double kServoNoise = 10;

bool is_held_by_servos(const Scenario& scenario) {
  return std::any_of(scenario.commands.begin(), scenario.commands.end(), [](const Command& each) {
    return each.gains && each.control == Control::kImplicit;
  });
}

double level_distance(const Vector3& a, const Vector3& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

void add_settle_time(MetricSheet& sheet) {
  const std::vector<Phase>& phases = sheet.scenario.phases;
  const bool told = phases.empty() || (phases[0].name != "settle" && phases[0].name != "drop");
  if (told || phases[0].end - phases[0].begin < kLongEnough) return;
  const double settled = sheet.record.measures.settle_time;
  const double impact = std::sqrt(2 * sheet.scenario.drop / gravity_scale(sheet.scene));
  const bool never = !(settled <= phases[0].end);
  sheet.add("settle.time", std::max(0.0, (never ? phases[0].end : settled) - impact),
            about_scene(sheet.scene), settling_time(sheet.scene));
  Metric& metric = sheet.metrics.back();
  if (!never || metric.verdict != Verdict::kPass) return;
  // Not seen to settle, in a time that would have been soon enough.
  Fact fact = about_scene(sheet.scene);
  fact.kind = FactKind::kNeverSettles;
  fact.name = metric.id;
  fact.value = metric.value;
  fact.limit = phases[0].end - kSettleHold;
  fact.test = sheet.scenario.name;
  fact.severe = false;
  metric.warn = fact.limit;  // the table and the finding refer to one limit
  metric.verdict = Verdict::kWarn;
  metric.fact = std::move(fact);
}

void add_creep(MetricSheet& sheet, const PhaseMeasures& rest, double seconds) {
  Peak creep, yaw;
  for (std::uint32_t m = 0; m < sheet.scene.models.size(); ++m) {
    const std::uint32_t base = sheet.scene.models[m].base;
    if (!sheet.stands(m) || base >= rest.begin.size()) continue;
    const BodyState& begin = rest.begin[base];
    const BodyState& end = rest.end[base];
    creep.see(level_distance(begin.p_WBcm, end.p_WBcm) / seconds, m, 0);
    yaw.see(std::abs(rest.yaw_path[m]) / seconds, m, 0);
  }
  sheet.add("rest.creep", creep.value, about_model(sheet.scene, creep.of));
  Fact turns = about_model(sheet.scene, yaw.of);
  turns.name = "yaw";
  sheet.add("rest.yaw_creep", yaw.value, std::move(turns));
}

void add_weight(MetricSheet& sheet, const PhaseMeasures& rest) {
  const Scene& scene = sheet.scene;
  double weight = 0;
  for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
    if (!scene.models[m].is_static && !sheet.stands(m)) return;
  }
  for (const SceneBody& body : scene.bodies) {
    if (body.kinematic) return;
    if (body.gravity) weight -= body.mass.mass * scene.gravity.z;
  }
  const double borne = rest.ground_force.z / static_cast<double>(rest.steps);
  if (!sheet.scenario.gravity || !(weight > 0) || borne == 0) return;  // or nobody asked for forces
  sheet.add("rest.weight_balance", std::abs(borne / weight - 1), about_scene(scene));
}

void add_support(MetricSheet& sheet) {
  const Scene& scene = sheet.scene;
  const PhaseMeasures& first = sheet.record.measures.phases.front();
  for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
    if (!sheet.stands(m)) continue;
    std::vector<Vector3> points;
    for (const SupportPoint& point : sheet.record.measures.support) {
      if (point.model == m) points.push_back(point.point);
    }
    const std::vector<Vector3> corners = footprint(std::move(points));
    if (corners.size() < 3)
      continue;  // a ball, or two wheels: whether it falls is seen by its tilt
    Vector3 center;
    double mass = 0;
    for (std::size_t b = 0; b < scene.bodies.size() && b < first.end.size(); ++b) {
      if (scene.bodies[b].model != m) continue;
      center = center + scene.bodies[b].mass.mass * first.end[b].p_WBcm;
      mass += scene.bodies[b].mass.mass;
    }
    if (!(mass > 0)) continue;
    const FootprintMargin margin = margin_in(corners, (1 / mass) * center);
    sheet.add("rest.support_margin", margin.distance / margin.half_width, about_model(scene, m));
  }
}

void add_falls(MetricSheet& sheet, const PhaseMeasures& rest) {
  const Scene& scene = sheet.scene;
  if (!sheet.scenario.gravity) return;
  for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
    if (!sheet.stands(m)) continue;
    const double down = -rest.end[scene.models[m].base].v_WBcm.z;
    const double free = -scene.gravity.z * sheet.record.end_time;
    if (free > 0) {
      sheet.add("rest.falls", down > kFallingShare * free ? 1 : 0, about_model(scene, m));
    }
  }
}

/// A world may be meant to move: things roll, swing and fall over in it. Motion is only held against it
/// when energy comes from nowhere, or joints tremble.
void forgive_motion(MetricSheet& sheet) {
  if (sheet.scene.alone) return;
  constexpr std::array<std::string_view, 2> kUnsound{"energy.gain", "joint.jitter"};
  constexpr std::array<std::string_view, 5> kMotion{"settle.time", "rest.residual_v", "rest.creep",
                                                    "rest.yaw_creep", "rest.weight_balance"};
  const auto fails_in = [](const auto& ids) {
    return [&ids](const Metric& metric) {
      return metric.verdict == Verdict::kFail &&
             std::find(ids.begin(), ids.end(), metric.id) != ids.end();
    };
  };
  if (std::any_of(sheet.metrics.begin(), sheet.metrics.end(), fails_in(kUnsound))) return;
  for (Metric& metric : sheet.metrics) {
    if (!fails_in(kMotion)(metric)) continue;
    metric.verdict = Verdict::kWarn;
    metric.fact->severe = false;
    metric.fact->limit = *metric.warn;
  }
}

}  // namespace

void add_rest_metrics(MetricSheet& sheet) {
  add_settle_time(sheet);
  const PhaseMeasures* rest = sheet.phase("rest");
  if (rest == nullptr) return;
  const double seconds = sheet.seconds(*rest);
  const Scene& scene = sheet.scene;
  const double noise = is_held_by_servos(sheet.scenario) ? kServoNoise : 1;
  sheet.add("rest.residual_v", rest->residual.value, about_body(scene, rest->residual.of), noise);
  add_creep(sheet, *rest, seconds);
  add_weight(sheet, *rest);
  sheet.add("rest.contacts", static_cast<double>(rest->contact_changes) / seconds,
            about_scene(scene));
  add_support(sheet);
  add_falls(sheet, *rest);
  sheet.add("ground.sink", rest->sunk.value, about_shape(scene, rest->sunk.of));
  Peak jitter;
  for (std::uint32_t i = 0; i < rest->jitter_square.size(); ++i) {
    const double square = rest->jitter_square[i] / static_cast<double>(rest->steps);
    jitter.see(std::sqrt(square), i, 0);
  }
  if (!rest->jitter_square.empty()) {
    sheet.add("joint.jitter", jitter.value, about_axis(scene, jitter.of), noise);
  }
  forgive_motion(sheet);
}

}  // namespace rigor::simulate
