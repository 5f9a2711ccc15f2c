// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Causes in masses and inertias: those that are not of the link's own shapes, and bodies of very
// different mass in one joint.

#include <rigor/mass/shapes.h>
#include <rigor/simulate/advice/parts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>

#include <rigor/mass/resolve.h>
#include <rigor/simulate/metric/parts.h>

namespace rigor::simulate {
namespace {

/// Times the moment of the solid shapes. A thin shell of the same mass has up to 2, a part whose mass
/// is all at one end up to 4; beyond 10 no part of this shape comes.
constexpr double kInertiaFactor = 10;

/// A mesh in centimeters that is read in meters has 1e4 times its moment, one in millimeters 1e6 times. An inertia that is
/// only badly guessed is off by a thousand; and what is not this long is no robot in the wrong unit.
constexpr double kScaleMoment = 5e3;
constexpr double kScaleLength = 10;  // m

/// Iterative solvers converge slowly from here on; and at ten times as much, not in 200 iterations.
constexpr double kMassFactor = 100;
constexpr double kMassFactorSevere = 10;

/// What a link of this mass and shape would have; nothing where its shapes are no solids.
std::optional<mass::Inertia> solid_inertia(const Causes& causes, const SceneLink& link,
                                           double mass) {
  for (const mass::From from : {mass::From::kCollisions, mass::From::kVisuals}) {
    const mass::LinkBody body = mass::link_body(causes.input.root, causes.input.frames, link.id,
                                                from, causes.input.find_mesh);
    if (!body.complete()) continue;
    return mass::with_mass(mass::of_own_densities(body), mass).about_com;
  }
  return std::nullopt;
}

struct MomentFactor {
  double factor = 1;  ///< above 1, or its inverse below
  std::string name;
  double badness() const { return std::max(factor, 1 / factor); }
};

/// Of the moments about the link's axes the one that is farthest off; of a wheel, that about the axis
/// that it turns about.
MomentFactor farthest_off(const mass::Inertia& has, const mass::Inertia& should,
                          const std::optional<Vector3>& axis_L) {
  if (axis_L) {
    return {mass::moment_about(*axis_L, has) / mass::moment_about(*axis_L, should), "its axis"};
  }
  const std::array<MomentFactor, 3> all{{{has.ixx / should.ixx, "ixx"},
                                         {has.iyy / should.iyy, "iyy"},
                                         {has.izz / should.izz, "izz"}}};
  return *std::max_element(
      all.begin(), all.end(),
      [](const MomentFactor& a, const MomentFactor& b) { return a.badness() < b.badness(); });
}

/// Of the moments of all that is fixed to each other: what of it is less than that changes nothing that a run shows.
constexpr double kShareOfBody = 0.01;

/// Whether a link's own inertia makes up a part of that of its body: a camera's on a trunk does not.
bool matters_to_body(const Causes& causes, const SceneLink& link, const mass::Inertia& has) {
  const mass::MassProperties& whole = causes.scene.bodies[link.body].mass;
  return mass::trace(has) >= kShareOfBody * mass::trace(whole.about_com);
}

std::optional<Vector3> wheel_axis_in(const Causes& causes, const SceneLink& link) {
  const Quaternion R_WL = compose(causes.scene.bodies[link.body].X_WB, link.X_BL).rotation;
  for (const auto* side : {&causes.wheels.left, &causes.wheels.right}) {
    for (const Wheel& wheel : *side) {
      const SceneJoint& joint = causes.scene.joints[wheel.joint];
      if (joint.child == link.body) return rotate(conjugate(R_WL), joint.axes[0].direction_W);
    }
  }
  return std::nullopt;
}

/// The collision mesh of a link that makes it so large that only a wrong unit explains it; nothing else.
std::optional<Fact> oversized_mesh(const Causes& causes, const SceneLink& link, double factor) {
  if (!(factor < 1 / kScaleMoment)) return std::nullopt;
  for (const SceneShape& shape : causes.scene.shapes) {
    if (shape.link >= causes.scene.links.size()) continue;
    if (&causes.scene.links[shape.link] != &link || !(shape.extent > kScaleLength)) continue;
    for (const model::Collision& collision : causes.input.root.collisions) {
      const bool is_it = collision.geometry.site.name == shape.where;
      if (!is_it || !std::holds_alternative<model::Mesh>(collision.geometry.shape)) continue;
      // Moments go with the square of the length.
      return Fact{.where = shape.where,
                  .subject = subject_of(link.name, "link"),
                  .value = shape.extent,
                  .limit = shape.extent * std::sqrt(factor)};
    }
  }
  return std::nullopt;
}

/// kg·m²: a solid cube of that mass whose diagonal is the size of the scene, as a measure of how hard a model is to turn.
double moment_of_model(const Scene& scene) {
  return moving_mass(scene) * scene.size * scene.size / 18;
}

/// Of a link without an `<inertial>`, or with one that has a mass alone.
FactKind default_kind(const mass::Resolved& taken) {
  return taken.taken == mass::Taken::kIdentity ? FactKind::kCauseInertiaNotWritten
                                               : FactKind::kCauseDefaultInertia;
}

/// A link that is only a frame and has no `<inertial>`: SDFormat gives it 1 kg and 1 kg·m², which turns a small robot into a
/// flywheel.
void add_default_of_frame(Causes& causes, const SceneLink& link, const mass::Resolved& taken) {
  const double factor = mass::trace(taken.body.about_com) / 3 / moment_of_model(causes.scene);
  if (!(factor > 1)) return;
  Fact about{.where = link.where, .subject = subject_of(link.name, "link")};
  const std::vector<SceneModel>& models = causes.scene.models;
  const bool lacks_mesh = link.model < models.size() && models[link.model].missing_shapes > 0;
  about.help = lacks_mesh ? "give it an `<inertial>`"
                          : "replace the link with a `<frame>`, or give it a small `<inertial>`";
  causes.add(default_kind(taken), std::move(about), 0, kInertiaFactor, factor, 1);
}

}  // namespace

void add_inertia_causes(Causes& causes) {
  for (const SceneLink& link : causes.scene.links) {
    if (link.body >= causes.scene.bodies.size() || !link.id) continue;
    const mass::Resolved taken =
        mass::resolve(causes.input.root, causes.input.frames, link.id, causes.input.find_mesh);
    if (!(taken.body.mass > 0)) continue;
    const std::optional<mass::Inertia> should = solid_inertia(causes, link, taken.body.mass);
    const bool defaults =
        taken.taken == mass::Taken::kDefaults || taken.taken == mass::Taken::kIdentity;
    if (!should || !(mass::trace(*should) > 0)) {
      if (defaults) add_default_of_frame(causes, link, taken);
      continue;
    }
    const MomentFactor off =
        farthest_off(taken.body.about_com, *should, wheel_axis_in(causes, link));
    if (!std::isfinite(off.badness()) || off.badness() < kInertiaFactor) continue;
    if (!matters_to_body(causes, link, taken.body.about_com) &&
        !matters_to_body(causes, link, *should)) {
      continue;
    }
    const std::optional<Fact> oversized =
        defaults ? std::nullopt : oversized_mesh(causes, link, off.factor);
    if (oversized) {
      causes.add(FactKind::kCauseMeshScale, *oversized, oversized->value, oversized->limit,
                 off.badness() / kInertiaFactor, 1);
      continue;
    }
    Fact about{.where = link.where, .subject = subject_of(link.name, "link"), .name = off.name};
    causes.add(defaults ? default_kind(taken) : FactKind::kCauseInertia, std::move(about),
               off.factor, kInertiaFactor, off.badness() / kInertiaFactor, 1);
  }
}

void add_mass_ratio_causes(Causes& causes) {
  const Scene& scene = causes.scene;
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    if (joint.parent >= scene.bodies.size() || joint.child >= scene.bodies.size()) continue;
    const double parent = scene.bodies[joint.parent].mass.mass;
    const double child = scene.bodies[joint.child].mass.mass;
    if (!(parent > 0) || !(child > 0)) continue;
    const double ratio = std::max(parent / child, child / parent);
    if (ratio < kMassFactor) continue;
    // It is the light one that is to be changed, more often than not.
    const bool child_is_light = child < parent;
    Fact about = about_body(scene, child_is_light ? joint.child : joint.parent);
    about.name = about_body(scene, child_is_light ? joint.parent : joint.child).subject;
    // A light body at the end of a chain bears nothing, and harms little.
    causes.add(FactKind::kCauseMassRatio, std::move(about), ratio, kMassFactor, ratio / kMassFactor,
               child_is_light ? kMassFactorSevere : 1);
  }
}

}  // namespace rigor::simulate
