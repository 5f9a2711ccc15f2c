// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine_comparison.h>

#include <algorithm>
#include <array>
#include <charconv>

#include <rigor/simulate/confirm.h>
#include <rigor/simulate/metric/parts.h>

namespace rigor::simulate {
namespace {

bool is_failure(Verdict verdict) {
  return verdict == Verdict::kFail || verdict == Verdict::kInvalid;
}

std::string in_few_digits(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3);
  return {text.data(), end.ptr};
}

std::string valued(double value, std::string_view unit) {
  return in_few_digits(value) + (unit.empty() ? "" : " ") + std::string(unit);
}

std::vector<MetricPair> paired_metrics(const Run& ode, const Run& mujoco) {
  std::vector<MetricPair> pairs;
  for (const Metric& metric : ode.metrics) {
    const auto same = std::find_if(mujoco.metrics.begin(), mujoco.metrics.end(),
                                   [&](const Metric& other) { return other.id == metric.id; });
    if (same == mujoco.metrics.end()) continue;
    pairs.push_back(
        {metric.id, metric.unit, metric.value, same->value, metric.verdict, same->verdict});
  }
  return pairs;
}

void find_differences(const Run& ode, const Run& mujoco, EngineComparison& comparison) {
  std::vector<std::string>& found = comparison.differences;
  for (const MetricPair& pair : comparison.metrics) {
    const bool in_ode = is_failure(pair.ode_verdict);
    if (in_ode == is_failure(pair.mujoco_verdict)) continue;
    found.push_back(std::string(pair.id) + " fails in " + (in_ode ? "ODE" : "MuJoCo") +
                    " only: " + valued(pair.ode, pair.unit) + " in ODE, " +
                    valued(pair.mujoco, pair.unit) + " in MuJoCo");
  }
  for (const Run* run : {&ode, &mujoco}) {
    const Run& other = run == &ode ? mujoco : ode;
    if (was_stopped(run->record) && !was_stopped(other.record)) {
      found.push_back(std::string(run == &ode ? "ODE" : "MuJoCo") +
                      " does not run it: " + run->record.message);
    }
  }
  const bool both_end =
      ode.record.end == Record::End::kDone && mujoco.record.end == Record::End::kDone;
  if (found.empty() && both_end && comparison.apart > kEnginesApart) {
    found.push_back("ends " + in_few_digits(100 * comparison.apart) +
                    " % of its size or path apart in ODE and MuJoCo");
  }
}

bool any_surface(const Scene& scene, bool (*has)(const ContactSurface&)) {
  return std::any_of(scene.shapes.begin(), scene.shapes.end(),
                     [&](const SceneShape& shape) { return has(shape.surface); });
}

bool any_axis(const Scene& scene, bool (*has)(const SceneAxis&)) {
  return std::any_of(scene.joints.begin(), scene.joints.end(), [&](const SceneJoint& joint) {
    return std::any_of(joint.axes.begin(), joint.axes.end(), has);
  });
}

bool any_joint(const Scene& scene, bool (*has)(const SceneJoint&)) {
  return std::any_of(scene.joints.begin(), scene.joints.end(), has);
}

/// Bodies that differ by more are beyond what ODE's iterative solver brings together in 200 iterations.
constexpr double kMassRatio = 1000;

double mass_ratio(const Scene& scene) {
  double least = kInfinity;
  double most = 0;
  for (const SceneBody& body : scene.bodies) {
    if (body.kinematic) continue;
    least = std::min(least, body.mass.mass);
    most = std::max(most, body.mass.mass);
  }
  return most > 0 ? most / least : 1;
}

bool differs_in(const EngineComparison& comparison, std::string_view part) {
  return std::any_of(comparison.differences.begin(), comparison.differences.end(),
                     [&](const std::string& words) { return words.find(part) == 0; });
}

}  // namespace

std::string explanation_of(const Scene& scene, const EngineComparison& comparison) {
  if (differs_in(comparison, "MuJoCo does not run") || differs_in(comparison, "ODE does not run")) {
    return "an engine refuses what the other takes";
  }
  for (const SceneShape& shape : scene.shapes) {
    if (std::holds_alternative<TriangleSoup>(shape.kind)) {
      return "a hulled mesh: '" + shape.name +
             "' collides as its convex hull in MuJoCo and as triangles in ODE";
    }
  }
  if (any_surface(scene, [](const ContactSurface& s) { return s.restitution > 0; })) {
    return "restitution: MuJoCo bounces by a spring, at any speed";
  }
  if (any_surface(scene, [](const ContactSurface& s) { return s.slip1 > 0 || s.slip2 > 0; })) {
    return "slip: MuJoCo has no friction that gives way to force";
  }
  const bool about_joints = differs_in(comparison, "joint.") || differs_in(comparison, "hold.");
  if (differs_in(comparison, "joint.anchor")) {
    return "joints: MuJoCo's cannot come apart, ODE's are held by its solver";
  }
  if (mass_ratio(scene) > kMassRatio) {
    return "mass ratios: ODE's iterative solver does not converge on them, MuJoCo's does";
  }
  if (differs_in(comparison, "rest.residual_v fails in ODE") ||
      differs_in(comparison, "joint.jitter fails in ODE")) {
    return "small inertias and overlaps: ODE's iterative solver trembles on them, MuJoCo's does "
           "not";
  }
  if (about_joints && any_axis(scene, [](const SceneAxis& a) { return a.spring_stiffness > 0; })) {
    return "stiff springs: MuJoCo takes a spring's force from the start of the step, uncut";
  }
  if (about_joints && any_axis(scene, [](const SceneAxis& a) { return a.damping > 0; })) {
    return "damping: while a motor drives, ODE cuts it at what stops a joint within a step, MuJoCo "
           "does not";
  }
  if (any_joint(scene, [](const SceneJoint& j) {
        return !j.mimics.empty() || j.type == model::JointType::kScrew ||
               j.type == model::JointType::kGearbox;
      })) {
    return "coupled joints: constraints in MuJoCo, forces in ODE";
  }
  if (about_joints) return "motors: MuJoCo's solver converges, ODE's iterative one may not";
  if (comparison.test == "turn") {
    return "wide wheels: where on its line of contact a wheel turns is open, and each engine "
           "chooses for itself";
  }
  if (differs_in(comparison, "energy.") || differs_in(comparison, "speed.") ||
      differs_in(comparison, "accel.")) {
    return "overlap: ODE pushes it apart at no more than 0.1 m/s, MuJoCo as a spring of 10 ms";
  }
  return "contact softness and the friction cone: MuJoCo's contacts are soft and their cone is "
         "elliptic, ODE's are hard and their cone is a pyramid";
}

void compare_engines(const Scene& scene, Simulation& simulation) {
  for (std::size_t i = 0; i + 1 < simulation.runs.size(); ++i) {
    const Run& ode = simulation.runs[i];
    Run& mujoco = simulation.runs[i + 1];
    if (ode.test != mujoco.test || ode.engine == mujoco.engine) continue;
    EngineComparison comparison{.test = ode.test,
                                .ode = ode.verdict,
                                .mujoco = mujoco.verdict,
                                .apart = difference_of(scene, ode.record, mujoco.record),
                                .metrics = paired_metrics(ode, mujoco)};
    find_differences(ode, mujoco, comparison);
    if (!comparison.differences.empty()) {
      comparison.explanation = explanation_of(scene, comparison);
      Fact fact = about_scene(scene);
      fact.kind = FactKind::kEnginesDiffer;
      fact.test = comparison.test;
      fact.severe = false;
      for (const std::string& words : comparison.differences) {
        fact.name += (fact.name.empty() ? "" : "; ") + words;
      }
      fact.help = "look at " + comparison.explanation + " (docs/engines.md)";
      mujoco.facts.push_back(std::move(fact));
      mujoco.verdict = worse(mujoco.verdict, Verdict::kWarn);
    }
    simulation.comparisons.push_back(std::move(comparison));
    ++i;
  }
}

}  // namespace rigor::simulate
