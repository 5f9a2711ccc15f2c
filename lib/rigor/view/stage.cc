// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/stage.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <rigor/model/pose.h>

namespace rigor::view {
namespace {

/// One thread builds, so that the same tree comes out on every run.
constexpr const char* kDeviceSettings = "threads=1,set_affinity=0,start_threads=0";

/// Of the ground's radius: from here on it fades.
constexpr double kGroundFades = 0.45;

// Bodies of one mesh in exactly one place of which a ray meets all: thousands take a picture minutes. Nothing is seen
// of more, whatever light the others let through.
constexpr unsigned kMaxInOnePlace = 16;
/// The cosine of 172°: from there on two surfaces face opposite ways; of 8°: up to there the same.
constexpr double kOpposite = -0.99;
constexpr double kSameWay = 0.99;

/// Of the drawing's size: how far off its surface a shadow's ray begins.
constexpr double kLift = 2e-5;

bool is_finite_vector(const model::Vector3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool can_be_placed(const Body& body) {
  const model::Quaternion& q = body.pose.rotation;
  // Embree computes with squares in single precision.
  constexpr double kMinFactor = 1e-15;
  const auto usable = [](double factor) {
    return std::isfinite(factor) && std::abs(factor) >= kMinFactor;
  };
  return body.mesh && !body.mesh->triangles.empty() && is_finite_vector(body.pose.translation) &&
         std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) &&
         usable(body.scale.x) && usable(body.scale.y) && usable(body.scale.z);
}

model::Vector3 scaled(const model::Vector3& factors, const model::Vector3& v) {
  return {factors.x * v.x, factors.y * v.y, factors.z * v.z};
}

/// The finite ones' middle.
model::Vector3 middle_of(const std::vector<model::Vector3>& positions) {
  mesh::Bounds bounds = mesh::bounds_of(positions);
  if (!is_finite_vector(bounds.min) || !is_finite_vector(bounds.max)) return {};
  const model::Vector3 middle = 0.5 * (bounds.min + bounds.max);
  return is_finite_vector(middle) ? middle : model::Vector3{};
}

bool marks_what_is_inside(Layer layer) {
  return layer == Layer::kInertia || layer == Layer::kCom || layer == Layer::kFrames ||
         layer == Layer::kAxes || layer == Layer::kContacts;
}

model::Vector3 unit_or(const model::Vector3& v, const model::Vector3& otherwise) {
  const double size = std::sqrt(dot(v, v));
  return size > 0 && std::isfinite(size) ? (1 / size) * v : otherwise;
}

template <class T>
model::Vector3 between_corners(const std::array<std::array<T, 3>, 3>& corners, double u, double v) {
  const auto mean = [&](std::size_t i) {
    return (1 - u - v) * static_cast<double>(corners[0][i]) +
           u * static_cast<double>(corners[1][i]) + v * static_cast<double>(corners[2][i]);
  };
  return {mean(0), mean(1), mean(2)};
}

RTCSceneFlags filtered_scene() { return RTC_SCENE_FLAG_ROBUST | kQueriesFilter; }

RTCRay embree_ray(const Ray& ray, double from, double to) {
  RTCRay result = {};
  result.org_x = static_cast<float>(ray.origin.x);
  result.org_y = static_cast<float>(ray.origin.y);
  result.org_z = static_cast<float>(ray.origin.z);
  result.dir_x = static_cast<float>(ray.direction.x);
  result.dir_y = static_cast<float>(ray.direction.y);
  result.dir_z = static_cast<float>(ray.direction.z);
  result.tnear = static_cast<float>(from);
  result.tfar = static_cast<float>(to);
  result.mask = ~0U;
  return result;
}

}  // namespace

Stage::Stage(const Embree& embree, const Drawing& drawing, const Encoding& encoding)
    : embree_(embree), encoding_(encoding), problem_(embree.problem) {
  if (!problem_.empty()) return;
  const bool empty = !(drawing.bounds.min.x <= drawing.bounds.max.x);
  if (!empty && std::isfinite(mesh::diagonal(drawing.bounds))) {
    middle_ = 0.5 * (drawing.bounds.min + drawing.bounds.max);
    size_ = std::max(mesh::diagonal(drawing.bounds), std::numeric_limits<float>::min() * 1e6);
  }
  device_ = embree_.new_device(kDeviceSettings);
  if (!device_) {
    problem_ = "Embree cannot start on this machine";
    return;
  }
  // Else it prints.
  embree_.set_error_function(
      device_, [](void*, RTCError, const char*) {}, nullptr);
  solid_ = embree_.new_scene(device_);
  glass_ = embree_.new_scene(device_);
  embree_.set_scene_flags(solid_, filtered_scene());
  embree_.set_scene_flags(glass_, RTC_SCENE_FLAG_ROBUST);
  bodies_.resize(drawing.bodies.size());
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    if (can_be_placed(drawing.bodies[i])) place(drawing.bodies[i], i);
  }
  embree_.commit_scene(solid_);
  embree_.commit_scene(glass_);
  measure_ground(drawing);
  if (embree_.device_error(device_) != RTC_ERROR_NONE) {
    problem_ = "Embree cannot hold this drawing: there may not be enough memory";
  }
}

Stage::~Stage() {
  for (const auto& [mesh, held] : scenes_) embree_.release_scene(held.scene);
  if (solid_) embree_.release_scene(solid_);
  if (glass_) embree_.release_scene(glass_);
  if (device_) embree_.release_device(device_);
}

void Stage::place(const Body& body, std::uint32_t index) {
  const MeshScene& held = scene_of(*body.mesh);
  Placed& placed = bodies_[index];
  placed.mesh = body.mesh.get();
  placed.mark = marks_what_is_inside(body.layer);
  placed.ground = body.layer == Layer::kGround;
  placed.glass = placed.mark;
  placed.looks = looks_of(body, placed.glass);

  const model::Matrix3 turn = model::to_matrix(model::normalized(body.pose.rotation));
  for (std::size_t row = 0; row < 3; ++row) {
    placed.normal_rows[row] = {turn[row][0] / body.scale.x, turn[row][1] / body.scale.y,
                               turn[row][2] / body.scale.z};
  }
  const model::Vector3 at = model::transform(body.pose, scaled(body.scale, held.middle)) - middle_;
  const double factors[] = {body.scale.x, body.scale.y, body.scale.z};
  std::array<float, 12> columns{};
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      columns[3 * column + row] = static_cast<float>(turn[row][column] * factors[column]);
    }
  }
  columns[9] = static_cast<float>(at.x);
  columns[10] = static_cast<float>(at.y);
  columns[11] = static_cast<float>(at.z);
  if (!std::all_of(columns.begin(), columns.end(), [](float f) { return std::isfinite(f); })) {
    return;
  }
  if (++in_one_place_[{body.mesh.get(), columns}] > kMaxInOnePlace) return;
  const RTCGeometry instance = embree_.new_geometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
  if (!instance) return;
  embree_.set_instanced_scene(instance, held.scene);
  embree_.set_transform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
  embree_.commit_geometry(instance);
  embree_.attach_geometry(placed.glass ? glass_ : solid_, instance, index);
  embree_.release_geometry(instance);
  may_coincide_ = may_coincide_ || placed_ > 0 || placed.looks.size() > 1;
  ++placed_;
  has_glass_ = has_glass_ || placed.glass;
  has_marks_ = has_marks_ || placed.mark;
  if (placed.glass && !placed.ground) ground_is_all_glass_ = false;
}

const Stage::MeshScene& Stage::scene_of(const mesh::TriangleMesh& mesh) {
  const auto [found, fresh] = scenes_.try_emplace(&mesh);
  MeshScene& held = found->second;
  if (!fresh) return held;
  held.middle = middle_of(mesh.positions);
  held.scene = embree_.new_scene(device_);
  embree_.set_scene_flags(held.scene, filtered_scene());
  const RTCGeometry geometry = embree_.new_geometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  if (geometry && fill(mesh, held.middle, geometry)) {
    embree_.commit_geometry(geometry);
    embree_.attach_geometry(held.scene, geometry, 0);
  }
  if (geometry) embree_.release_geometry(geometry);
  embree_.commit_scene(held.scene);
  return held;
}

bool Stage::fill(const mesh::TriangleMesh& mesh, const model::Vector3& middle,
                 RTCGeometry geometry) const {
  constexpr unsigned kOnlySlot = 0;
  auto* const corners = static_cast<float*>(
      embree_.new_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, kOnlySlot, RTC_FORMAT_FLOAT3,
                         3 * sizeof(float), mesh.positions.size()));
  auto* const triangles = static_cast<std::uint32_t*>(
      embree_.new_buffer(geometry, RTC_BUFFER_TYPE_INDEX, kOnlySlot, RTC_FORMAT_UINT3,
                         3 * sizeof(std::uint32_t), mesh.triangles.size()));
  if (!corners || !triangles) return false;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const model::Vector3 p = mesh.positions[i] - middle;
    corners[3 * i] = static_cast<float>(p.x);
    corners[3 * i + 1] = static_cast<float>(p.y);
    corners[3 * i + 2] = static_cast<float>(p.z);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const mesh::Triangle& t = mesh.triangles[i];
    const bool known = std::max({t[0], t[1], t[2]}) < mesh.positions.size();
    // One without an area keeps the numbers of those behind it.
    for (std::size_t corner = 0; corner < 3; ++corner) {
      triangles[3 * i + corner] = known ? t[corner] : 0;
    }
  }
  return true;
}

std::vector<Stage::Look> Stage::looks_of(const Body& body, bool& glass) const {
  std::vector<Look> looks;
  for (const Surface& surface : body.surfaces) {
    Look look{{Encoding::to_linear(surface.color), std::clamp(surface.color.a, 0.0F, 1.0F)}};
    const Picture* texture = surface.texture.get();
    const bool whole = texture && !texture->pixels.empty() &&
                       texture->pixels.size() == std::size_t{texture->width} * texture->height;
    if (whole && !body.mesh->corners.texture.empty()) look.texture = texture;
    look.texture_opacity = surface.texture_opacity;
    const bool see_through = look.texture && look.texture_opacity &&
                             std::any_of(texture->pixels.begin(), texture->pixels.end(),
                                         [](const Pixel& pixel) { return pixel[3] != 255; });
    glass = glass || look.paint.opacity < 1 || see_through;
    looks.push_back(look);
  }
  if (looks.empty()) looks.push_back({{Encoding::to_linear(Color{}), 1}});
  return looks;
}

void Stage::measure_ground(const Drawing& drawing) {
  std::vector<model::Vector3> corners;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].ground) continue;
    const Body& body = drawing.bodies[i];
    for (const model::Vector3& p : body.mesh->positions) {
      corners.push_back(model::transform(body.pose, scaled(body.scale, p)));
    }
  }
  if (corners.empty()) return;
  const mesh::Bounds bounds = mesh::bounds_of(corners);
  ground_middle_ = 0.5 * (bounds.min + bounds.max) - middle_;
  ground_radius_ = std::min(bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y) / 2;
}

double Stage::ground_left(const model::Vector3& point) const {
  const model::Vector3 off = point - ground_middle_;
  const double share = ground_radius_ > 0 ? std::hypot(off.x, off.y) / ground_radius_ : 1;
  const double s = std::clamp((1 - share) / (1 - kGroundFades), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

std::optional<Hit> Stage::first(RTCScene scene, RayQuery& query, const Ray& ray, double from,
                                double to) const {
  RTCRayHit found = {};
  found.ray = embree_ray(ray, from, to);
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree_.intersect(scene, query, found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  Hit hit{found.ray.tfar, found.hit.instID[0], found.hit.primID, found.hit.u, found.hit.v};
  // Embree's is in the mesh's axes.
  const model::Vector3 normal{found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z};
  hit.back = dot(bodies_[hit.body].turned(normal), ray.direction) > 0;
  return hit;
}

model::Vector3 Stage::outward(std::uint32_t body, std::uint32_t triangle) const {
  const Placed& placed = bodies_[body];
  const mesh::TriangleMesh& mesh = *placed.mesh;
  const model::Vector3 n = mesh::area_vector(facet(mesh, mesh.triangles[triangle]));
  return unit_or(
      {dot(placed.normal_rows[0], n), dot(placed.normal_rows[1], n), dot(placed.normal_rows[2], n)},
      {});
}

/// Embree hands it to the filter, as the query that it begins with.
struct Stage::OtherSide {
  RayQuery query;
  const Stage* stage;
  model::Vector3 back;

  static void refuse_others(const RTCFilterFunctionNArguments* met) {
    const auto* self = reinterpret_cast<const OtherSide*>(met->context);
    const std::uint32_t body = RTCHitN_instID(met->hit, met->N, 0, 0);
    const std::uint32_t triangle = RTCHitN_primID(met->hit, met->N, 0);
    const bool opposite = dot(self->stage->outward(body, triangle), self->back) < kOpposite;
    if (!opposite) met->valid[0] = 0;
  }
};

/// Of surfaces in one place that face the same way, the first of the drawing: which of them Embree meets first is
/// chance, another one in each pixel.
struct Stage::FirstDrawn {
  RayQuery query;
  const Stage* stage;
  model::Vector3 facing;
  Hit best;

  static void keep(const RTCFilterFunctionNArguments* met) {
    auto* self = reinterpret_cast<FirstDrawn*>(met->context);
    const std::uint32_t body = RTCHitN_instID(met->hit, met->N, 0, 0);
    const std::uint32_t triangle = RTCHitN_primID(met->hit, met->N, 0);
    met->valid[0] = 0;  // so that the next is met, too
    if (std::pair(body, triangle) >= std::pair(self->best.body, self->best.triangle)) return;
    if (dot(self->stage->outward(body, triangle), self->facing) < kSameWay) return;
    self->best = {
        RTCRayN_tfar(met->ray, met->N, 0), body,           triangle, RTCHitN_u(met->hit, met->N, 0),
        RTCHitN_v(met->hit, met->N, 0),    self->best.back};
  }
};

Hit Stage::first_drawn(RTCScene scene, const Ray& ray, const Hit& hit) const {
  if (!may_coincide_) return hit;
  FirstDrawn first{RayQuery(FirstDrawn::keep), this, outward(hit.body, hit.triangle), hit};
  this->first(scene, first.query, ray, hit.t * (1 - kInOnePlace), hit.t * (1 + kInOnePlace));
  return first.best;
}

std::optional<Hit> Stage::first_front(RTCScene scene, const Ray& ray, double from,
                                      double to) const {
  const std::optional<Hit> hit = nearest_front(scene, ray, from, to);
  return hit ? std::optional(first_drawn(scene, ray, *hit)) : hit;
}

std::optional<Hit> Stage::nearest_front(RTCScene scene, const Ray& ray, double from,
                                        double to) const {
  RayQuery plain;
  const std::optional<Hit> hit = first(scene, plain, ray, from, to);
  if (!hit || !hit->back) return hit;
  OtherSide other{RayQuery(OtherSide::refuse_others), this, outward(hit->body, hit->triangle)};
  const std::optional<Hit> front =
      first(scene, other.query, ray, std::max(from, hit->t * (1 - kInOnePlace)),
            std::min(to, hit->t * (1 + kInOnePlace)));
  return front ? front : hit;
}

std::optional<Hit> Stage::first_solid(const Ray& ray) const {
  return first_front(solid_, ray, 0, INFINITY);
}

std::optional<Hit> Stage::first_glass(const Ray& ray, double from, double to) const {
  return first_front(glass_, ray, from, to);
}

bool Stage::reaches_lamp(const model::Vector3& point) const {
  RayQuery query;
  RTCRay ray = embree_ray({point, kTowardsLamp}, kLift * size_, INFINITY);
  embree_.occluded(solid_, query, ray);
  return ray.tfar >= 0;
}

const Stage::Look& Stage::look_of(const Placed& placed, std::uint32_t triangle) const {
  const std::vector<mesh::Part>& parts = placed.mesh->parts;
  if (placed.looks.size() == 1 || parts.empty()) return placed.looks.front();
  const auto next =
      std::upper_bound(parts.begin(), parts.end(), triangle,
                       [](std::uint32_t at, const mesh::Part& part) { return at < part.first; });
  const auto part = next == parts.begin() ? 0 : static_cast<std::size_t>(next - parts.begin()) - 1;
  return placed.looks[std::min(part, placed.looks.size() - 1)];
}

Touched Stage::touched(const Hit& hit, const Ray& ray) const {
  const Placed& placed = bodies_[hit.body];
  const mesh::TriangleMesh& triangles = *placed.mesh;
  const Look& look = look_of(placed, hit.triangle);
  Touched result{look.paint, {}, {}};
  const mesh::Corners& corners = triangles.corners;
  if (look.texture && hit.triangle < corners.texture.size()) {
    const auto& uv = corners.texture[hit.triangle];
    const auto mean = [&](std::size_t i) {
      return (1 - hit.u - hit.v) * static_cast<double>(uv[0][i]) +
             hit.u * static_cast<double>(uv[1][i]) + hit.v * static_cast<double>(uv[2][i]);
    };
    const Paint print = sample(*look.texture, encoding_, mean(0), mean(1));
    result.paint = {result.paint.light * print.light, result.paint.opacity};
    if (look.texture_opacity) result.paint.opacity *= print.opacity;
  }
  if (hit.triangle < corners.colors.size()) {
    Light sum;
    const double shares[] = {1 - hit.u - hit.v, hit.u, hit.v};
    for (std::size_t i = 0; i < 3; ++i) {
      const mesh::Corners::Color& c = corners.colors[hit.triangle][i];
      sum = sum + static_cast<float>(shares[i]) * Encoding::to_linear(Color{c[0], c[1], c[2], 1});
    }
    result.paint.light = result.paint.light * sum;
  }

  const model::Vector3 to_eye = -1.0 * ray.direction;
  // Meshes are wound either way: what faces the eye is the outside.
  const mesh::Facet at = facet(triangles, triangles.triangles[hit.triangle]);
  result.facet = unit_or(placed.turned(mesh::area_vector(at)), to_eye);
  if (dot(result.facet, to_eye) < 0) result.facet = -1.0 * result.facet;
  result.normal = result.facet;
  if (hit.triangle < corners.normals.size()) {
    result.normal = unit_or(
        placed.turned(between_corners(corners.normals[hit.triangle], hit.u, hit.v)), result.facet);
    if (dot(result.normal, result.facet) < 0) result.normal = -1.0 * result.normal;
  }
  return result;
}

}  // namespace rigor::view
