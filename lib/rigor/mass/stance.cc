// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/stance.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <variant>

#include <rigor/mass/mesh/survey.h>
#include <rigor/mass/support_polygon.h>

namespace rigor::mass {
namespace {

using model::Id;
using model::Vector3;

// What is flat may be this much off level, rad, by the rounding of its numbers. Less than the edge of a
// rim's first points, which a wheel does not stand on.
constexpr double kLevel = 0.01;

// Points on a rim: those of a round shape that stands on its end.
constexpr int kRim = 32;

/// Points of a shape, in its frame, of which the lowest is the shape's lowest wherever it is turned:
/// the corners of a box, two rims of a cylinder. What is round touches where its lowest point is.
struct Feet {
  const model::Pose& X_WS;
  const FindMesh& find_mesh;

  std::vector<Vector3> operator()(const model::Box& s) const { return corners(0.5 * s.size.value); }
  std::vector<Vector3> operator()(const model::Sphere& s) const {
    return {s.radius.value * down()};
  }
  std::vector<Vector3> operator()(const model::Ellipsoid& s) const {
    // The support of an ellipsoid in direction d is R² d / |R d|.
    const Vector3& r = s.radii.value;
    const Vector3 d = down();
    const Vector3 rd{r.x * d.x, r.y * d.y, r.z * d.z};
    const double size = length(rd);
    return {{r.x * rd.x / size, r.y * rd.y / size, r.z * rd.z / size}};
  }
  std::vector<Vector3> operator()(const model::Cylinder& s) const {
    std::vector<Vector3> points = rim(s.radius.value, s.length.value / 2);
    const std::vector<Vector3> other = rim(s.radius.value, -s.length.value / 2);
    points.insert(points.end(), other.begin(), other.end());
    return points;
  }
  std::vector<Vector3> operator()(const model::Cone& s) const {
    std::vector<Vector3> points = rim(s.radius.value, -s.length.value / 2);
    points.push_back({0, 0, s.length.value / 2});
    return points;
  }
  std::vector<Vector3> operator()(const model::Capsule& s) const {
    const Vector3 cap = s.radius.value * down();
    return {cap + Vector3{0, 0, s.length.value / 2}, cap - Vector3{0, 0, s.length.value / 2}};
  }
  std::vector<Vector3> operator()(const model::Mesh& s) const {
    const MeshSurvey* survey = find_mesh ? find_mesh(s) : nullptr;
    if (survey == nullptr || !survey->usable()) return {};
    const auto scaled = [&s](const Vector3& p) {
      const Vector3& k = s.scale.value;
      return Vector3{k.x * p.x, k.y * p.y, k.z * p.z};
    };
    const Vector3 low = scaled(survey->bounds.min);
    const Vector3 high = scaled(survey->bounds.max);
    std::vector<Vector3> points = corners(0.5 * (high - low));
    for (Vector3& p : points) p = p + 0.5 * (low + high);
    return points;
  }
  template <class Other>
  std::vector<Vector3> operator()(const Other&) const {
    return {};
  }

  /// Down, along the shape's axes.
  Vector3 down() const { return rotate(conjugate(X_WS.rotation), {0, 0, -1}); }

  static std::vector<Vector3> corners(const Vector3& half) {
    std::vector<Vector3> points;
    for (const double x : {-half.x, half.x}) {
      for (const double y : {-half.y, half.y}) {
        for (const double z : {-half.z, half.z}) points.push_back({x, y, z});
      }
    }
    return points;
  }

  /// Evenly, beginning at the lowest place.
  std::vector<Vector3> rim(double radius, double z) const {
    constexpr double kTau = 6.283185307179586;
    const Vector3 d = down();
    const double start = std::atan2(d.y, d.x);
    std::vector<Vector3> points;
    for (int i = 0; i < kRim; ++i) {
      const double angle = start + kTau * i / kRim;
      points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
    return points;
  }
};

/// Those that touch level ground where the lowest one does.
void add_lowest(const std::vector<Vector3>& shape, std::vector<Vector3>& points) {
  const auto lowest = std::min_element(shape.begin(), shape.end(),
                                       [](const auto& a, const auto& b) { return a.z < b.z; });
  std::copy_if(shape.begin(), shape.end(), std::back_inserter(points),
               [&](const Vector3& p) { return p.z - lowest->z <= kLevel * length(p - *lowest); });
}

void add_feet(const model::Root& root, const model::Frames& frames, Id<model::Model> id,
              const FindMesh& find_mesh, std::vector<Vector3>& points) {
  for (const Id<model::Link> link : root[id].links) {
    for (const Id<model::Collision> collision : root[link].collisions) {
      const auto X_WS = frames.pose(collision);
      if (!X_WS) continue;
      std::vector<Vector3> shape =
          std::visit(Feet{*X_WS, find_mesh}, root[collision].geometry.shape);
      for (Vector3& p : shape) p = transform(*X_WS, p);
      add_lowest(shape, points);
    }
  }
  for (const Id<model::Model> nested : root[id].models) {
    add_feet(root, frames, nested, find_mesh, points);
  }
}

/// By a joint; in URDF, by the convention of a link of that name.
bool is_held(const model::Root& root, const model::Frames& frames, Id<model::Model> id) {
  const model::Model& model = root[id];
  return std::any_of(model.joints.begin(), model.joints.end(),
                     [&](auto joint) { return frames.ends(joint).parent_is_world; }) ||
         std::any_of(model.links.begin(), model.links.end(),
                     [&](auto link) {
                       return root.format == model::Format::kUrdf &&
                              root[link].name.value == "world";
                     }) ||
         std::any_of(model.models.begin(), model.models.end(),
                     [&](auto nested) { return is_held(root, frames, nested); });
}

}  // namespace

std::optional<Stance> stance_of(const model::Root& root, const model::Frames& frames,
                                Id<model::Model> model, const FindMesh& find_mesh,
                                const Vector3& com) {
  std::vector<Vector3> points;
  if (is_held(root, frames, model)) return std::nullopt;
  add_feet(root, frames, model, find_mesh, points);
  if (points.empty()) return std::nullopt;
  Stance stance;
  stance.height = std::numeric_limits<double>::infinity();
  for (const Vector3& p : points) stance.height = std::min(stance.height, p.z);
  std::vector<GroundPoint> contacts;
  for (const Vector3& p : points) {
    if (p.z <= stance.height + kTouching) contacts.push_back({p.x, p.y});
  }
  const SupportPolygon polygon(contacts);
  stance.points = polygon.corners().size();
  if (stance.points >= 3) stance.margin = polygon.margin({com.x, com.y});
  return stance;
}

}  // namespace rigor::mass
