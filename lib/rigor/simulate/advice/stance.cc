// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Causes in how a model stands: without collisions, top-heavy, on contacts too soft for its weight, or
// with links that a flag takes out of the physics.

#include <rigor/simulate/advice/parts.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <rigor/simulate/footprint.h>
#include <rigor/simulate/metric/parts.h>
#include <rigor/simulate/mount.h>
#include <rigor/simulate/reach.h>

namespace rigor::simulate {
namespace {

/// A table that tilts by less throws it over: a slope of 1 in 6, or a brake of a sixth of gravity.
constexpr double kTopHeavyAngle = 0.1745;  // rad, 10°
constexpr double kTopHeavySevere = 2;

/// Of what stands in the ground by more the metric `ground.sink` would be a failure.
constexpr double kSoftSink = 0.005;  // m

bool has_shape(const Scene& scene, std::uint32_t model) {
  return std::any_of(scene.shapes.begin(), scene.shapes.end(), [&](const SceneShape& shape) {
    return shape.body < scene.bodies.size() && scene.bodies[shape.body].model == model;
  });
}

/// Without them neither where the model stands nor what it touches is known.
void add_missing_shapes(Causes& causes, std::uint32_t m) {
  const Scene& scene = causes.scene;
  const std::uint32_t missing = scene.models[m].missing_shapes;
  const auto there =
      std::count_if(scene.shapes.begin(), scene.shapes.end(), [&](const SceneShape& shape) {
        return shape.link < scene.links.size() && scene.links[shape.link].model == m;
      });
  causes.add(FactKind::kCauseMeshMissing, about_model(scene, m), missing,
             missing + static_cast<double>(there), 1, kInfinity);
}

void add_top_heavy(Causes& causes, std::uint32_t m) {
  const Scene& scene = causes.scene;
  const std::vector<Vector3> corners = footprint_at_start(scene, m, kFootSlack);
  if (corners.size() < 3) return;
  // Nobody lowers the center of mass of an arm: it is bolted to something.
  if (is_to_be_bolted(scene, m, causes.wheels)) return;
  const double angle = tip_angle(scene, m, corners).angle;
  if (angle >= kTopHeavyAngle) return;
  const double weight = angle > 0 ? kTopHeavyAngle / angle : kInfinity;
  causes.add(FactKind::kCauseTopHeavy, about_model(scene, m), angle, kTopHeavyAngle, weight,
             kTopHeavySevere);
}

double weight_of(const Scene& scene, std::uint32_t model) {
  double mass = 0;
  for (const SceneBody& body : scene.bodies) {
    if (body.model == model && body.gravity && !body.kinematic) mass += body.mass.mass;
  }
  return mass * length(scene.gravity);
}

/// Each point that the model stands on is a spring of its shape's `kp`, where an engine honors it.
void add_soft_contacts(Causes& causes, std::uint32_t m) {
  const Scene& scene = causes.scene;
  const double ground = lowest_of_model(scene, m) + kTouchGap;
  double stiffness = 0;  // N/m
  std::uint32_t softest = kWorld;
  for (std::uint32_t s = 0; s < scene.shapes.size(); ++s) {
    const SceneShape& shape = scene.shapes[s];
    if (shape.body >= scene.bodies.size() || scene.bodies[shape.body].model != m) continue;
    const std::size_t points = low_points(scene, shape, ground).size();
    const int most = std::min(shape.surface.max_contacts, scene.solver.max_contacts);
    if (points == 0 || most < 1) continue;
    stiffness += shape.surface.kp * std::min(static_cast<double>(points), double(most));
    const bool softer = softest == kWorld || shape.surface.kp < scene.shapes[softest].surface.kp;
    if (softer) softest = s;
  }
  if (softest == kWorld) return;
  const double weight = weight_of(scene, m);
  const double sunk = stiffness > 0 ? weight / stiffness : kInfinity;
  if (!(weight > 0) || sunk <= kSoftSink) return;
  causes.add(FactKind::kCauseSoftContact, about_shape(scene, softest), sunk, kSoftSink,
             sunk / kSoftSink, 1);
}

/// What `rest.weight_balance` warns of: what weighs less is not missed.
constexpr double kMissedShare = 0.005;

/// A link that moves as commanded or that gravity forgets, a shape that may touch nothing, is often
/// meant: it goes along with what a run shows, and is no fault by itself.
void add_flags(Causes& causes, std::uint32_t m) {
  const Scene& scene = causes.scene;
  double whole = 0;
  bool any_falls = false;
  for (const SceneBody& body : scene.bodies) {
    if (body.model != m) continue;
    whole += body.mass.mass;
    any_falls = any_falls || body.gravity;
  }
  for (std::uint32_t b = 0; b < scene.bodies.size(); ++b) {
    const SceneBody& body = scene.bodies[b];
    if (body.model != m) continue;
    Fact about = about_body(scene, b);
    if (body.kinematic) {
      about.name = "kinematic";
    } else if (!body.gravity && !any_falls) {
      about.name = "no gravity";
    } else if (!body.gravity && body.mass.mass > kMissedShare * whole) {
      about.name = "gravity";
    } else {
      continue;
    }
    causes.add(FactKind::kCauseFlag, std::move(about), body.mass.mass, 0, 1, kInfinity);
  }
  for (std::uint32_t s = 0; s < scene.shapes.size(); ++s) {
    const SceneShape& shape = scene.shapes[s];
    if (shape.body >= scene.bodies.size() || scene.bodies[shape.body].model != m) continue;
    if (shape.surface.max_contacts > 0) continue;
    Fact about = about_shape(scene, s);
    about.name = "max_contacts";
    causes.add(FactKind::kCauseFlag, std::move(about), 0, 0, 1, kInfinity);
  }
}

}  // namespace

void add_stance_causes(Causes& causes) {
  const Scene& scene = causes.scene;
  for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
    add_flags(causes, m);
    if (scene.models[m].missing_shapes > 0) {
      add_missing_shapes(causes, m);
      continue;
    }
    if (!stands_free(scene, m)) continue;
    if (!has_shape(scene, m)) {
      causes.add(FactKind::kCauseNoCollision, about_model(scene, m), 0, 0, 1, 1);
      continue;
    }
    add_top_heavy(causes, m);
    add_soft_contacts(causes, m);
  }
}

}  // namespace rigor::simulate
