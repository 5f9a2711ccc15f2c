// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <variant>

#include <fmt/core.h>

#include <rigor/mass/convex.h>
#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::visual_collision_scale {

using model::Vector3;

// The same shape in another scale is off by nearly the same factor along each axis.
constexpr double kEven = 1.1;

// How near the factor is to that of a slip. Collisions that are larger or smaller for a purpose, and
// models of tests with numbers drawn by chance, are off by any factor.
constexpr double kNear = 1.04;

// Less is a mark for "nothing here" that some exporters leave, in one of the two.
constexpr double kPlaceholder = 0.005;  // m

struct Slip {
  double factor;
  const char* help;
};
constexpr Slip kSlips[] = {
    {1000, "one of the two looks as if it were in millimeters"},
    {100, "one of the two looks as if it were in centimeters"},
    {10, "one of the two looks as if its decimal point had slipped"},
    {25.4, "one of the two looks as if it were in inches, and read as millimeters or the reverse"},
    {39.37, "one of the two looks as if it were in inches"},
};

Vector3 scaled(const Vector3& v, const Vector3& by) { return {v.x * by.x, v.y * by.y, v.z * by.z}; }

void include_box(mesh::Bounds& all, bool& first, const mesh::Bounds& box) {
  if (first) all = box;
  first = false;
  all.min = {std::min(all.min.x, box.min.x), std::min(all.min.y, box.min.y),
             std::min(all.min.z, box.min.z)};
  all.max = {std::max(all.max.x, box.max.x), std::max(all.max.y, box.max.y),
             std::max(all.max.z, box.max.z)};
}

/// The sides of the box around all of them; nothing when one has no closed form.
template <class Parts>
std::optional<Vector3> size_of(const Parts& parts, const Context& context) {
  mesh::Bounds all;
  bool first = true;
  for (const auto id : parts) {
    const auto X_WS = context.frames().pose(id);
    if (!X_WS) return std::nullopt;
    const auto convex = mass::ConvexShape::of(context.root()[id].geometry.shape, *X_WS);
    if (!convex) return std::nullopt;
    include_box(all, first, convex->bounds());
  }
  if (first) return std::nullopt;
  return all.max - all.min;
}

/// The same of a mesh as it is placed.
Vector3 size_of(const MeshFile& file, const model::Pose& X_WS) {
  const Vector3 low = scaled(file.facts.bounds.min, file.scale());
  const Vector3 high = scaled(file.facts.bounds.max, file.scale());
  mesh::Bounds box;
  bool first = true;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 p =
        transform(X_WS, {(corner & 1) != 0 ? low.x : high.x, (corner & 2) != 0 ? low.y : high.y,
                         (corner & 4) != 0 ? low.z : high.z});
    include_box(box, first, {p, p});
  }
  return box.max - box.min;
}

const Slip* slip_of(double factor) {
  for (const Slip& slip : kSlips) {
    if (factor > slip.factor / kNear && factor < slip.factor * kNear) return &slip;
  }
  return nullptr;
}

/// The one mesh of a link's collisions or visuals.
template <class Parts>
const model::Mesh* only_mesh(const Parts& parts, const model::Root& root) {
  if (parts.size() != 1) return nullptr;
  return std::get_if<model::Mesh>(&root[parts.front()].geometry.shape);
}

void compare(const model::Link& link, const Vector3& touched, const Vector3& seen,
             Context& context) {
  if (!(length(touched) > kPlaceholder) || !(length(seen) > kPlaceholder)) return;
  const auto [least, most] =
      std::minmax({touched.x / seen.x, touched.y / seen.y, touched.z / seen.z});
  if (!(least > 0) || !(most < kEven * least)) return;
  const double ratio = length(touched) / length(seen);
  const double factor = std::max(ratio, 1 / ratio);
  const Slip* slip = slip_of(factor);
  if (slip == nullptr) return;
  const model::Root& root = context.root();
  context.report(
      {.where = link.site.name,
       .message = fmt::format("the collision is {:.4g} times {} than what is seen, along all axes",
                              factor, ratio > 1 ? "larger" : "smaller"),
       .subject = context.subject(link),
       .related = {{root[link.collisions.front()].geometry.site.name, "the collision"},
                   {root[link.visuals.front()].geometry.site.name, "the visual"}},
       .help = slip->help});
}

void check(const model::Link& link, Context& context) {
  if (link.collisions.empty() || link.visuals.empty()) return;
  const model::Mesh* touched_mesh = only_mesh(link.collisions, context.root());
  const model::Mesh* seen_mesh = only_mesh(link.visuals, context.root());
  if (touched_mesh && seen_mesh) {
    // Of two files only their own rules know how large they are.
    if (touched_mesh->uri.value == seen_mesh->uri.value) {
      compare(link, touched_mesh->scale.value, seen_mesh->scale.value, context);
    }
    return;
  }
  const auto touched = size_of(link.collisions, context);
  const auto seen = touched ? size_of(link.visuals, context) : std::nullopt;
  if (seen) compare(link, *touched, *seen, context);
}

/// A mesh on one side, and shapes with a closed form on the other.
void check_mesh(const MeshFile& file, Context& context) {
  if (!file.use || !file.facts.usable() || !file.use->mesh.submesh.value.empty()) return;
  const model::Link* link = link_of(file, context);
  if (link == nullptr) return;
  const model::Root& root = context.root();
  const bool touched = file.collision();
  if (touched ? only_mesh(link->collisions, root) != &file.use->mesh
              : only_mesh(link->visuals, root) != &file.use->mesh) {
    return;
  }
  const auto X_WM = touched ? context.frames().pose(link->collisions.front())
                            : context.frames().pose(link->visuals.front());
  const auto other = touched ? size_of(link->visuals, context) : size_of(link->collisions, context);
  if (!X_WM || !other) return;
  const Vector3 own = size_of(file, *X_WM);
  compare(*link, touched ? own : *other, touched ? *other : own, context);
}

Rule rule() {
  return {
      .name = "visual-collision-scale",
      .severity = Severity::kWarning,
      .summary = "a link's collision is the visual in another scale",
      .why = "The robot touches what it does not reach, or reaches through what it touches. Both "
             "have the same proportions, and one is 10, 100, 1000 or 25.4 times as large: a unit "
             "or a scale was put right in one of them only. Two different meshes are not compared.",
      .what_to_do = "Write the size or the mesh's <scale> of the wrong one as in the other.",
      .checks = {on<model::Link>(check), on<MeshFile>(check_mesh)},
  };
}

}  // namespace rigor::rules::visual_collision_scale
