// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/metric/metric.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <rigor/simulate/metric/parts.h>

namespace rigor::simulate {
namespace {

constexpr double kEarthGravity = 9.8;  // m/s²

std::string scoped_to_model(std::string_view scoped) {
  const std::size_t at = scoped.rfind("::");
  return at == std::string_view::npos ? std::string() : std::string(scoped.substr(0, at));
}

/// Of a scene that lacks collisions nobody knows how it would stand with them. Without any it falls, of which nothing is said:
/// that the meshes are missing was, when the scene was built.
void forgive_missing_meshes(MetricSheet& sheet) {
  const auto lacks = [](const SceneModel& model) { return model.missing_shapes > 0; };
  const auto of_world = [](const SceneShape& shape) { return shape.body == kWorld; };
  const auto& models = sheet.scene.models;
  const auto& shapes = sheet.scene.shapes;
  if (std::none_of(models.begin(), models.end(), lacks)) return;
  const bool falls =
      sheet.scenario.base == Base::kFree && std::all_of(shapes.begin(), shapes.end(), of_world);
  for (Metric& metric : sheet.metrics) {
    if (!metric.fact || !hangs_on_contacts(metric.fact->kind)) continue;
    metric.verdict = Verdict::kWarn;
    metric.fact->severe = false;
    if (falls) metric.fact.reset();
  }
}

std::string_view last_name(std::string_view scoped) {
  const std::size_t at = scoped.rfind("::");
  return at == std::string_view::npos ? scoped : scoped.substr(at + 2);
}

}  // namespace

std::string subject_of(std::string_view scoped, std::string_view kind) {
  std::string outer = scoped_to_model(scoped);
  if (!outer.empty()) outer += '/';
  return outer.append(kind).append(" ").append(last_name(scoped));
}

Fact about_body(const Scene& scene, std::uint32_t body) {
  if (body >= scene.bodies.size()) return {};
  return {.where = scene.bodies[body].where,
          .subject = subject_of(scene.bodies[body].name, "link")};
}

Fact about_shape(const Scene& scene, std::uint32_t shape) {
  if (shape >= scene.shapes.size()) return {};
  const SceneShape& s = scene.shapes[shape];
  const std::string link = scoped_to_model(s.name);
  std::string subject = link.empty() ? std::string() : subject_of(link, "link") + "/";
  return {.where = s.where, .subject = subject.append("collision ").append(last_name(s.name))};
}

Fact about_joint(const Scene& scene, std::uint32_t joint) {
  if (joint >= scene.joints.size()) return {};
  return {.where = scene.joints[joint].where,
          .subject = subject_of(scene.joints[joint].name, "joint"),
          .slides = scene.joints[joint].type == model::JointType::kPrismatic};
}

Fact about_axis(const Scene& scene, std::uint32_t axis) {
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    const auto count = static_cast<std::uint32_t>(scene.joints[j].axes.size());
    if (axis < count) return about_joint(scene, j);
    axis -= count;
  }
  return {};
}

Fact about_model(const Scene& scene, std::uint32_t model) {
  if (model >= scene.models.size()) return {};
  return {.where = scene.models[model].where, .subject = scene.models[model].name};
}

Fact about_scene(const Scene& scene) {
  const auto moves = [](const SceneModel& model) { return !model.is_static; };
  const auto first = std::find_if(scene.models.begin(), scene.models.end(), moves);
  const auto index = first == scene.models.end() ? 0 : first - scene.models.begin();
  return about_model(scene, static_cast<std::uint32_t>(index));
}

bool hangs_on_contacts(FactKind shown) {
  using enum FactKind;
  constexpr std::array kShown{
      kNeverSettles, kRestless,     kCreeps,     kUnbalanced,     kTips,        kNearlyTips,
      kSinks,        kFalls,        kDriveSlips, kDriveBackwards, kDriveDrifts, kDriveBounces,
      kTurnOff,      kDoesNotBrake, kPushedOver, kTiltsEarly,     kTooFast};
  return std::find(kShown.begin(), kShown.end(), shown) != kShown.end();
}

bool stands_free(const Scene& scene, std::uint32_t model) {
  if (scene.models[model].is_static || scene.models[model].base >= scene.bodies.size())
    return false;
  return std::none_of(scene.joints.begin(), scene.joints.end(), [&](const SceneJoint& joint) {
    const bool to_world = joint.parent == kWorld || joint.child == kWorld;
    const std::uint32_t body = joint.parent == kWorld ? joint.child : joint.parent;
    return to_world && body < scene.bodies.size() && scene.bodies[body].model == model;
  });
}

double gravity_scale(const Scene& scene) {
  const double g = length(scene.gravity);
  return g > 0 ? g : kEarthGravity;
}

double tilt_since_start(const Scene& scene, std::uint32_t model, const BodyState& base) {
  const Quaternion R_WB = scene.bodies[scene.models[model].base].X_WB.rotation;
  const Vector3 up = rotate(base.R_WB, rotate(conjugate(R_WB), {0, 0, 1}));
  return std::atan2(std::hypot(up.x, up.y), up.z);
}

void MetricSheet::add(std::string_view id, double value, Fact about, double scale) {
  about.test = scenario.name;
  metrics.push_back(make_metric(id, value, std::move(about), scale));
}

const PhaseMeasures* MetricSheet::phase(std::string_view name) const {
  for (std::size_t i = 0; i < scenario.phases.size() && i < record.measures.phases.size(); ++i) {
    const PhaseMeasures& measures = record.measures.phases[i];
    if (scenario.phases[i].name == name && measures.steps > 0) return &measures;
  }
  return nullptr;
}

double MetricSheet::seconds(const PhaseMeasures& phase) const {
  if (record.steps == 0) return 0;
  return record.end_time * static_cast<double>(phase.steps) / static_cast<double>(record.steps);
}

std::vector<Metric> metrics_of(const Scene& scene, const Scenario& scenario, const Record& record,
                               const DriveTrain& wheels) {
  MetricSheet sheet{scene, scenario, record, wheels, {}, footings_of(scene)};
  const bool finite = record.end != Record::End::kNotFinite;
  const bool near = record.end != Record::End::kFarAway;
  sheet.add("state.nonfinite", finite ? 0 : 1, about_body(scene, record.culprit));
  sheet.add("state.oversize", near ? 0 : 1, about_body(scene, record.culprit));
  add_spawn_metrics(sheet);
  add_motion_metrics(sheet);
  add_joint_metrics(sheet);
  if (record.end == Record::End::kDone) {
    // The rest refers to how it ended.
    add_rest_metrics(sheet);
    add_drive_metrics(sheet);
    add_turn_metrics(sheet);
    add_brake_metrics(sheet);
    add_push_metrics(sheet);
    add_sweep_metrics(sheet);
    add_hold_metrics(sheet);
    add_tilt_table_metrics(sheet);
  }
  forgive_missing_meshes(sheet);
  sheet.add("solver.messages", static_cast<double>(record.solver_messages));
  return std::move(sheet.metrics);
}

}  // namespace rigor::simulate
