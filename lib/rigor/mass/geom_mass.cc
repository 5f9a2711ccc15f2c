// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/geom_mass.h>

#include <algorithm>
#include <numbers>
#include <variant>

#include <rigor/mass/fitted_primitive.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/mass/polyhedron.h>
#include <rigor/mass/shapes.h>
#include <rigor/mass/shell.h>
#include <rigor/mesh/convex/hull.h>

namespace rigor::mass {
namespace {

using model::GeomWeight;
using std::numbers::pi;

/// A thin sheet of even density; `volume` is its area, m², and the unit inertia per kilogram.
Solid sheet(double area, const model::Vector3& moments) {
  return {area, {}, {moments.x, 0, 0, moments.y, 0, moments.z}};
}

Solid sphere_shell(double r) {
  const double moment = 2 * r * r / 3;
  return sheet(4 * pi * r * r, {moment, moment, moment});
}

/// Six plates: each adds about its own middle and by parallel axes.
Solid box_shell(const model::Vector3& s) {
  const double yz = s.y * s.z, xz = s.x * s.z, xy = s.x * s.y;
  const double area = 2 * (yz + xz + xy);
  // ∫ x² dA over the box's surface, and likewise of y and z.
  const double xx = 2 * (yz * s.x * s.x / 4 + (xz + xy) * s.x * s.x / 12);
  const double yy = 2 * (xz * s.y * s.y / 4 + (yz + xy) * s.y * s.y / 12);
  const double zz = 2 * (xy * s.z * s.z / 4 + (yz + xz) * s.z * s.z / 12);
  return sheet(area, {(yy + zz) / area, (xx + zz) / area, (xx + yy) / area});
}

/// A tube and two disks.
Solid cylinder_shell(double r, double length) {
  const double tube = 2 * pi * r * length, disk = pi * r * r, area = tube + 2 * disk;
  const double about_z = tube * r * r + 2 * disk * r * r / 2;
  const double across =
      tube * (r * r / 2 + length * length / 12) + 2 * disk * (r * r / 4 + length * length / 4);
  return sheet(area, {across / area, across / area, about_z / area});
}

/// A tube and two half spheres, whose middles are half a radius from their rims.
Solid capsule_shell(double r, double length) {
  const double tube = 2 * pi * r * length, cap = 2 * pi * r * r, area = tube + 2 * cap;
  const double about_z = tube * r * r + 2 * cap * 2 * r * r / 3;
  const double middle = length / 2 + r / 2;
  const double about_own = 2 * r * r / 3 - r * r / 4;  // of a cap about its center of mass
  const double across =
      tube * (r * r / 2 + length * length / 12) + 2 * cap * (about_own + middle * middle);
  return sheet(area, {across / area, across / area, about_z / area});
}

std::optional<Solid> shell_of_shape(const model::Shape& shape) {
  if (const auto* s = std::get_if<model::Sphere>(&shape)) return sphere_shell(s->radius.value);
  if (const auto* s = std::get_if<model::Box>(&shape)) return box_shell(s->size.value);
  if (const auto* s = std::get_if<model::Cylinder>(&shape)) {
    return cylinder_shell(s->radius.value, s->length.value);
  }
  if (const auto* s = std::get_if<model::Capsule>(&shape)) {
    return capsule_shell(s->radius.value, s->length.value);
  }
  return solid_of(shape);
}

std::optional<Solid> positive(const PolyhedronMoments& moments) {
  if (moments.volume > 0) return solid_of(moments);
  if (moments.volume < 0) return solid_of(inverted(moments));
  return std::nullopt;
}

/// Of a mesh that weighs as its surface: a sheet 1 m thick, so that kg/m³ are kg/m².
std::optional<Solid> sheet_of(const mesh::TriangleMesh& mesh) { return shell_of(mesh, 1); }

/// Of vertices that the model itself gives.
std::optional<Solid> solid_of_vertices(const model::Mesh& shape, const GeomWeight& weight) {
  std::vector<model::Vector3> points = shape.vertices;
  const model::Vector3& s = shape.scale.value;
  for (model::Vector3& p : points) p = {s.x * p.x, s.y * p.y, s.z * p.z};
  if (shape.faces.empty() || weight.mesh_law == GeomWeight::MeshLaw::kConvex) {
    const auto hull = mesh::convex_hull(points);
    if (hull && shape.sheet) return sheet_of(*hull);
    return hull ? positive(moments_of(*hull)) : std::nullopt;
  }
  mesh::TriangleMesh mesh;
  mesh.positions = std::move(points);
  mesh.triangles.assign(shape.faces.begin(), shape.faces.end());
  return shape.sheet ? sheet_of(mesh) : positive(moments_of(mesh));
}

std::optional<Solid> solid_of_mesh(const model::Mesh& shape, const GeomWeight& weight,
                                   const FindMesh& find_mesh) {
  if (!shape.vertices.empty()) return solid_of_vertices(shape, weight);
  const MeshSurvey* survey = find_mesh ? find_mesh(shape) : nullptr;
  if (survey == nullptr) return std::nullopt;
  if (!survey->usable()) {
    if (shape.sheet) return std::nullopt;
    return survey->hull ? positive(scaled(*survey->hull, shape.scale.value)) : std::nullopt;
  }
  if (shape.sheet) return survey->sheet;
  const MeshBody body = body_of(*survey, shape.scale.value);
  const bool hull = weight.mesh_law == GeomWeight::MeshLaw::kConvex;
  const auto& pyramids =
      weight.mesh_law == GeomWeight::MeshLaw::kExact ? survey->pyramids_as_wound : survey->pyramids;
  if (body.from == BodyFrom::kHull && !hull && pyramids) {
    return positive(scaled(*pyramids, shape.scale.value));
  }
  return body.solid;
}

MassProperties weighed(const Solid& solid, const GeomWeight& weight) {
  return weight.mass.written ? with_mass(solid, weight.mass.value)
                             : of_density(solid, weight.density.value);
}

/// Of the geom in the link frame; nothing when it cannot be said.
std::optional<MassProperties> of_geom(const model::Geometry& geometry, const model::Pose& X_LG,
                                      const GeomWeight& weight, const FindMesh& find_mesh) {
  const bool weightless = weight.mass.written ? weight.mass.value <= 0 : weight.density.value <= 0;
  if (weightless || std::holds_alternative<model::NoShape>(geometry.shape)) return MassProperties{};
  const auto* mesh = std::get_if<model::Mesh>(&geometry.shape);
  const model::Shape* shape = &geometry.shape;
  model::Pose X_LS = X_LG;
  std::optional<FittedPrimitive> fitted;
  if (mesh != nullptr) {
    const auto solid = solid_of_mesh(*mesh, weight, find_mesh);
    if (!solid) return std::nullopt;
    if (weight.fit == GeomWeight::Fit::kNone) return transformed(X_LG, weighed(*solid, weight));
    fitted = fitted_primitive(*solid, weight.fit, weight.fit_scale);
    shape = &fitted->shape;
    X_LS = compose(X_LG, fitted->X_MS);
  }
  const auto solid = weight.shell ? shell_of_shape(*shape) : solid_of(*shape);
  return solid ? transformed(X_LS, weighed(*solid, weight)) : MassProperties{};
}

Inertia of_moments(const PrincipalAxes& axes, const std::array<double, 3>& moments) {
  Inertia sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const model::Vector3& a = axes.axes[i];
    sum = sum +
          moments[i] * Inertia{a.x * a.x, a.x * a.y, a.x * a.z, a.y * a.y, a.y * a.z, a.z * a.z};
  }
  return sum;
}

/// What balanceinertia, boundmass and boundinertia leave of a body that moves or is written.
MassProperties settled(MassProperties body, const model::MassSettings& settings) {
  body.mass = std::max(body.mass, settings.bound_mass);
  if (!settings.balance_inertia && settings.bound_inertia <= 0) return body;
  const PrincipalAxes axes = principal_axes(body.about_com);
  std::array<double, 3> moments = axes.moments;
  for (double& moment : moments) moment = std::max(moment, settings.bound_inertia);
  const bool broken = moments[0] + moments[1] < moments[2];
  if (settings.balance_inertia && broken) {
    moments.fill((moments[0] + moments[1] + moments[2]) / 3);
  }
  if (moments != axes.moments) body.about_com = of_moments(axes, moments);
  return body;
}

std::optional<MassProperties> unscaled(const model::Root& root, const model::Link& link,
                                       const FindMesh& find_mesh) {
  const model::Inertial& inertial = link.inertial;
  // The world and what is between joints are no bodies of MuJoCo's that have mass.
  if (link.between_joints || link.name.value == "world") return MassProperties{};
  MassProperties body;
  if (inertial.written) {
    body = transformed(inertial.pose.pose.value,
                       {inertial.mass.value,
                        {},
                        {inertial.ixx.value, inertial.ixy.value, inertial.ixz.value,
                         inertial.iyy.value, inertial.iyz.value, inertial.izz.value}});
  } else {
    const auto add_all = [&](const auto& ids) {
      for (const auto id : ids) {
        const auto& part = root[id];
        if (!part.weight) continue;
        const auto one = of_geom(part.geometry, part.pose.pose.value, *part.weight, find_mesh);
        if (!one) return false;
        body = add(body, *one);
      }
      return true;
    };
    if (!add_all(link.collisions) || !add_all(link.visuals)) return std::nullopt;
  }
  return settled(body, root.mass_settings);
}

}  // namespace

std::optional<MassProperties> geom_mass(const model::Root& root, model::Id<model::Link> id,
                                        const FindMesh& find_mesh) {
  auto body = unscaled(root, root[id], find_mesh);
  const double wanted = root.mass_settings.total_mass;
  if (!body || wanted <= 0) return body;
  double total = 0;
  for (const model::Link& link : root.links) {
    const auto one = unscaled(root, link, find_mesh);
    if (!one) return std::nullopt;
    total += one->mass;
  }
  if (total <= 0) return body;
  const double factor = wanted / total;
  body->mass *= factor;
  body->about_com = factor * body->about_com;
  return body;
}

}  // namespace rigor::mass
