// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/assembled.h>
#include <rigor/rules/assembly/undone_slips.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_scale_differs {

using model::Vector3;

// Other meshes of the robot in the same format, all of one scale.
constexpr std::size_t kFewest = 3;

struct UnitFactor {
  double factor;
  const char* slip;
  bool is_unit;  ///< of files: one among others may be drawn in it
};
constexpr std::array<UnitFactor, 5> kFactors{
    {{10, "a decimal point slipped", false},
     {25.4, "it is in inches where the others are in millimeters", true},
     {39.37, "it is in inches where the others are in meters", true},
     {100, "it is in centimeters where the others are in meters", true},
     {1000, "it is in millimeters where the others are in meters", true}}};

struct Scaled {
  robot::ShapeRole role{};
  std::uint32_t index = 0;
  const model::Geometry* geometry = nullptr;
  const model::Mesh* mesh = nullptr;
};

std::string extension_of(const std::string& uri) {
  std::string result = uri.substr(std::min(uri.size(), uri.find_last_of('.') + 1));
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

bool same_scale(const Vector3& a, const Vector3& b, double factor) {
  constexpr double kExact = 1e-3;
  for (const double Vector3::*axis : kCoordinates) {
    const double p = std::abs(a.*axis), q = factor * std::abs(b.*axis);
    if (!(std::abs(p - q) <= kExact * q)) return false;
  }
  return true;
}

/// How many times larger, or smaller when below 1, by a known slip.
std::optional<std::pair<UnitFactor, bool>> factor_between(const Vector3& odd,
                                                          const Vector3& usual) {
  for (const UnitFactor& one : kFactors) {
    if (same_scale(odd, usual, one.factor)) return std::pair{one, true};
    if (same_scale(usual, odd, one.factor)) return std::pair{one, false};
  }
  return std::nullopt;
}

using Group = std::vector<Scaled>;

template <class Shapes>
void add_meshes(const Shapes& shapes, robot::ShapeRole role, const model::Root& root,
                std::map<std::pair<std::uint32_t, std::string>, Group>& groups) {
  for (std::uint32_t i = 0; i < shapes.size(); ++i) {
    const auto* mesh = std::get_if<model::Mesh>(&shapes[i].geometry.shape);
    if (mesh == nullptr || mesh->uri.value.empty() || !root.own(shapes[i].site)) continue;
    const model::Id<model::Model> model = root[shapes[i].link].model;
    if (!model) continue;
    groups[{model.value, extension_of(mesh->uri.value)}].push_back(
        {role, i, &shapes[i].geometry, mesh});
  }
}

/// The scale that all have but one; nothing when there is no such.
const Scaled* odd_one(const Group& group) {
  const Scaled* odd = nullptr;
  for (const std::size_t reference : {std::size_t{0}, std::size_t{1}}) {
    odd = nullptr;
    std::size_t others = 0;
    for (const Scaled& one : group) {
      if (same_scale(one.mesh->scale.value, group[reference].mesh->scale.value, 1)) continue;
      odd = &one;
      ++others;
    }
    if (others == 1) return odd;
  }
  return nullptr;
}

/// m; nothing when the mesh is not read.
std::optional<double> length_of(const Scaled& one, const robot::Assembled& robot) {
  for (const robot::AssembledShape& shape : robot.shapes) {
    if (shape.role == one.role && shape.index == one.index) return mesh::diagonal(shape.bounds_S);
  }
  return std::nullopt;
}

/// Whether as written the mesh is as large as others of the robot are: then its file has that unit.
bool is_as_large(const Scaled& one, const Group& group, double factor,
                 const robot::Assembled& robot) {
  const auto length = length_of(one, robot);
  if (!length) return false;
  double most = 0;
  for (const Scaled& other : group) {
    if (&other != &one) most = std::max(most, length_of(other, robot).value_or(0));
  }
  return factor > 1 ? *length <= most : *length * 20 >= most;
}

/// Not scaled at all: then it is the others that have an unusual scale.
bool is_plain(const Vector3& scale) { return scale == Vector3{1, 1, 1}; }

/// Of a file whose unit is below the meter. None is in kilometers.
bool may_be_unit(const Vector3& scale) {
  return std::max({std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)}) <= 1;
}

/// What the others have: their scale, or none at all.
std::optional<Fix> fix_for(const Scaled& odd, const Scaled& other, const Context& context) {
  const model::Field<Vector3>& scale = odd.mesh->scale;
  if (!scale.written || scale.span.nowhere()) return std::nullopt;
  if (!other.mesh->scale.written && context.is_urdf()) {
    return fix_of("leave the scale out", Applicability::kUnsafe,
                  attribute_removed(context, odd.geometry->site, "scale"));
  }
  const std::string meant = written_as(other.mesh->scale.value);
  return Fix{"write " + meant, Applicability::kUnsafe, {{scale.span, meant}}};
}

void check_group(const Group& group, Context& context) {
  if (group.size() <= kFewest) return;
  const Scaled* odd = odd_one(group);
  if (odd == nullptr) return;
  const Scaled& other = odd == &group[0] ? group[1] : group[0];
  const auto found = factor_between(odd->mesh->scale.value, other.mesh->scale.value);
  if (!found) return;
  const auto& [unit, larger] = *found;
  const robot::Assembled& robot = context.assembled();
  const bool fits = is_as_large(*odd, group, larger ? unit.factor : 1 / unit.factor, robot);
  if (unit.is_unit && fits) return;
  const model::Root& root = context.root();
  const model::Field<Vector3>& scale = odd->mesh->scale;
  std::optional<Fix> fix = fix_for(*odd, other, context);
  const bool collision = odd->role == robot::ShapeRole::kCollision;
  const bool known = length_of(*odd, robot).has_value();
  context.report(
      {.where = scale.written ? scale.span : odd->geometry->site.name,
       .message = fmt::format("the mesh is scaled by {}, and the robot's {} other meshes of this "
                              "format by {}",
                              written_as(scale.value), group.size() - 1,
                              written_as(other.mesh->scale.value)),
       .subject = collision ? context.subject(root.collisions[odd->index])
                            : context.subject(root.visuals[odd->index]),
       .help = fmt::format("it is {:g} times {} than theirs: {}", unit.factor,
                           larger ? "larger" : "smaller", unit.slip),
       .fix = std::move(fix),
       .severity =
           fits || is_plain(scale.value) || (unit.is_unit && !known && may_be_unit(scale.value))
               ? std::optional(Severity::kInfo)
               : std::nullopt});
}

void check(const model::Root& root, Context& context) {
  if (root.links.size() < 2) return;
  std::map<std::pair<std::uint32_t, std::string>, Group> groups;
  add_meshes(root.collisions, robot::ShapeRole::kCollision, root, groups);
  add_meshes(root.visuals, robot::ShapeRole::kVisual, root, groups);
  for (const auto& [key, group] : groups) check_group(group, context);
}

Rule rule() {
  return {
      .name = "mesh-scale-differs",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "one mesh of a robot has another scale than all others",
      .why =
          "One part is ten times as large as it should be, or a thousandth: it covers the robot, "
          "or cannot be seen. All other meshes of the robot in the same format have one scale, "
          "and that of this one is off by 10, 25.4, 39.37, 100 or 1000. A mesh that is drawn in "
          "another unit and as large as the others once scaled is not reported, and an "
          "info where the factor is 10; where the file cannot be read, a unit is an info.",
      .what_to_do = "Write the scale of the others, or leave it out as they do.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::mesh_scale_differs
