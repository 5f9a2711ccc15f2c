// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine/mujoco/geom_text.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include <rigor/simulate/engine/contact_rules.h>
#include <rigor/simulate/engine/engine.h>
#include <rigor/simulate/engine/mujoco/xml_text.h>

namespace rigor::simulate {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Each is tried in each step. A robot of a hundred shapes that collides with itself has five thousand.
constexpr std::size_t kMaxPairs = 50'000;

/// s: the time in which a contact's error dies away, at least two steps (MuJoCo's own bound). MuJoCo's default, 0.02,
/// lets a robot sink ten times as deep as a half of it, and slide down a slope as fast.
constexpr double kContactTime = 0.01;
constexpr double kContactSteps = 2;
/// Share of a force that the constraint takes, where it begins and at `kImpedanceWidth` (m) of depth: what is left
/// is its softness.
constexpr double kImpedanceBegin = 0.98;
constexpr double kImpedanceEnd = 0.999;
constexpr double kImpedanceWidth = 0.001;

/// Below it a contact has no friction at all (MuJoCo's mjMINMU).
constexpr double kMinFriction = 1e-5;

/// m/s: slower than any impact of a test. MuJoCo knows no threshold: a spring bounces always or never.
constexpr double kBounces = 1;

/// m below a height grid's lowest point that are solid.
constexpr double kGridBase = 10;

/// Share of a mesh's size: what is thinner is a sheet, and has no hull.
constexpr double kSheet = 1e-6;
/// … that a sheet gets as thickness, below its surface.
constexpr double kSheetThickness = 1e-3;

/// Of a spring with a damper that gives back the share `e` of a speed: ζ = -ln e/√(π² + ln² e).
double damping_ratio(double e) {
  if (!(e > 0)) return 1;
  const double log = std::log(std::min(e, 1.0));
  return std::max(1e-3, -log / std::sqrt(kPi * kPi + log * log));
}

bool is_half_space(const SceneShape& shape) {
  return std::holds_alternative<HalfSpace>(shape.kind);
}

bool is_grid(const SceneShape& shape) { return std::holds_alternative<HeightGrid>(shape.kind); }

const std::uint32_t* mesh_of(const SceneShape& shape) {
  if (const auto* hull = std::get_if<ConvexHull>(&shape.kind)) return &hull->mesh;
  if (const auto* soup = std::get_if<TriangleSoup>(&shape.kind)) return &soup->mesh;
  return nullptr;
}

/// The turn that brings z to a unit vector.
Quaternion from_z_to(const Vector3& n) {
  if (n.z < -1 + 1e-12) return {0, 1, 0, 0};
  return model::normalized({1 + n.z, -n.y, n.x, 0});
}

/// Of a mesh in a plane, with its unit normal; zero for a solid.
Vector3 sheet_normal(const std::vector<Vector3>& points, double& size) {
  size = 0;
  Vector3 along;
  for (const Vector3& p : points) {
    const Vector3 way = p - points.front();
    if (length(way) > size) {
      size = length(way);
      along = way;
    }
  }
  Vector3 normal;
  for (const Vector3& p : points) {
    const Vector3 across = cross(along, p - points.front());
    if (length(across) > length(normal)) normal = across;
  }
  if (!(length(normal) > 0)) return {};
  normal = (1 / length(normal)) * normal;
  for (const Vector3& p : points) {
    if (std::abs(dot(normal, p - points.front())) > kSheet * size) return {};
  }
  return normal;
}

/// MuJoCo collides with the hull of its points.
std::string points_text(const mesh::TriangleMesh& mesh) {
  std::string text;
  const auto add = [&text](const Vector3& p) {
    if (!text.empty()) text += ' ';
    text += number_text(p.x) + ' ' + number_text(p.y) + ' ' + number_text(p.z);
  };
  for (const Vector3& p : mesh.positions) add(p);
  if (mesh.positions.empty()) return text;
  double size = 0;
  const Vector3 normal = sheet_normal(mesh.positions, size);
  if (!(length(normal) > 0)) return text;
  const Vector3 down = (normal.z > 0 ? -kSheetThickness : kSheetThickness) * size * normal;
  for (const Vector3& p : mesh.positions) add(p + down);
  return text;
}

}  // namespace

GridRange range_of(const HeightGrid& grid) {
  if (grid.heights.empty()) return {0, 1e-6};
  const auto [low, high] = std::minmax_element(grid.heights.begin(), grid.heights.end());
  return {*low, std::max(*high - *low, 1e-6)};
}

GeomText::GeomText(const Scene& scene, const SolverSettings& settings)
    : scene_(scene),
      settings_(settings),
      touches_(scene.shapes.size(), false),
      has_asset_(scene.meshes.size(), false) {
  const ContactRules rules(scene);
  const auto count = static_cast<std::uint32_t>(scene.shapes.size());
  for (std::uint32_t a = 0; a < count; ++a) {
    if (is_half_space(scene.shapes[a]) && scene.shapes[a].body != kWorld) {
      throw EngineError("a plane cannot move: " + scene.shapes[a].name);
    }
    for (std::uint32_t b = a + 1; b < count; ++b) {
      if (is_still(scene.shapes[a].body) && is_still(scene.shapes[b].body)) continue;
      if (scene.shapes[a].body == scene.shapes[b].body) continue;
      if (is_grid(scene.shapes[a]) && is_grid(scene.shapes[b])) continue;
      if (rules.may_touch(a, b)) add_pair(a, b);
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    if (touches_[i]) add_asset(i);
  }
}

bool GeomText::is_still(std::uint32_t body) const {
  return body == kWorld || scene_.bodies[body].kinematic;
}

void GeomText::add_pair(std::uint32_t a, std::uint32_t b) {
  const ContactSurface surface = combined(scene_.shapes[a].surface, scene_.shapes[b].surface);
  if (std::min(surface.max_contacts, settings_.max_contacts) <= 0) return;
  if (++pair_count_ > kMaxPairs) {
    throw EngineError("MuJoCo tries every pair of shapes in every step, and more than " +
                      std::to_string(kMaxPairs) + " may touch; ODE takes such a scene");
  }
  touches_[a] = true;
  touches_[b] = true;
  const double bounce = surface.bounce_threshold < kBounces ? surface.restitution : 0;
  const double ratio = damping_ratio(bounce);
  const double time = std::max(kContactTime, kContactSteps * settings_.step) / ratio;
  const bool slides = std::max(surface.mu, surface.mu2) < kMinFriction;
  pairs_ += "<pair" + attribute("geom1", "g" + std::to_string(a)) +
            attribute("geom2", "g" + std::to_string(b)) +
            attribute("condim", {slides ? 1.0 : 3.0}) +
            attribute("friction", {std::max(surface.mu, kMinFriction),
                                   std::max(surface.mu2, kMinFriction), 0.005, 0.0001, 0.0001}) +
            attribute("solref", {time, ratio}) +
            attribute("solimp", {kImpedanceBegin, kImpedanceEnd, kImpedanceWidth}) + "/>\n";
}

void GeomText::add_asset(std::uint32_t index) {
  const SceneShape& shape = scene_.shapes[index];
  if (const std::uint32_t* mesh = mesh_of(shape)) {
    if (has_asset_[*mesh]) return;
    has_asset_[*mesh] = true;
    assets_ += "<mesh" + attribute("name", "m" + std::to_string(*mesh)) +
               attribute("vertex", points_text(scene_.meshes[*mesh])) + "/>\n";
  } else if (const auto* grid = std::get_if<HeightGrid>(&shape.kind)) {
    assets_ +=
        "<hfield" + attribute("name", "h" + std::to_string(index)) +
        attribute("nrow", {double(grid->rows)}) + attribute("ncol", {double(grid->columns)}) +
        attribute("size", {grid->width / 2, grid->depth / 2, range_of(*grid).range, kGridBase}) +
        "/>\n";
  }
}

std::string GeomText::geom(std::uint32_t index) const {
  const SceneShape& shape = scene_.shapes[index];
  Pose X = shape.X_BS;
  std::string kind;
  if (const auto* box = std::get_if<mesh::Box>(&shape.kind)) {
    kind = attribute("type", "box") + attribute("size", 0.5 * box->size);
  } else if (const auto* sphere = std::get_if<mesh::Sphere>(&shape.kind)) {
    kind = attribute("type", "sphere") + attribute("size", {sphere->radius});
  } else if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape.kind)) {
    kind =
        attribute("type", "cylinder") + attribute("size", {cylinder->radius, cylinder->length / 2});
  } else if (const auto* capsule = std::get_if<mesh::Capsule>(&shape.kind)) {
    kind = attribute("type", "capsule") + attribute("size", {capsule->radius, capsule->length / 2});
  } else if (const std::uint32_t* mesh = mesh_of(shape)) {
    kind = attribute("type", "mesh") + attribute("mesh", "m" + std::to_string(*mesh));
  } else if (const auto* grid = std::get_if<HeightGrid>(&shape.kind)) {
    kind = attribute("type", "hfield") + attribute("hfield", "h" + std::to_string(index));
    X.translation = transform(X, {0, 0, range_of(*grid).low});
  } else {
    kind = attribute("type", "plane") + attribute("size", {0, 0, 1});
    X.rotation = X.rotation * from_z_to(std::get<HalfSpace>(shape.kind).normal);
  }
  return "<geom" + attribute("name", "g" + std::to_string(index)) + kind + pose_attributes(X) +
         "/>\n";
}

std::string GeomText::of(std::uint32_t body) const {
  std::string text;
  for (const std::uint32_t shape : shapes_of(body)) text += geom(shape);
  return text;
}

std::vector<std::uint32_t> GeomText::shapes_of(std::uint32_t body) const {
  std::vector<std::uint32_t> shapes;
  for (std::uint32_t i = 0; i < scene_.shapes.size(); ++i) {
    if (touches_[i] && scene_.shapes[i].body == body) shapes.push_back(i);
  }
  return shapes;
}

}  // namespace rigor::simulate
