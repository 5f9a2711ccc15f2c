// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::size_not_positive {

struct Size {
  const char* name;
  const Span* span;
  double smallest;
};

Size of(const char* name, const model::Field<double>& field) {
  return {name, field.written ? &field.span : nullptr, field.value};
}
Size of(const char* name, const model::Field<model::Vector3>& field) {
  const model::Vector3& v = field.value;
  return {name, field.written ? &field.span : nullptr, std::min({v.x, v.y, v.z})};
}

std::vector<Size> sizes_of(const model::Shape& shape) {
  if (const auto* box = std::get_if<model::Box>(&shape)) return {of("size", box->size)};
  if (const auto* ball = std::get_if<model::Sphere>(&shape)) return {of("radius", ball->radius)};
  if (const auto* ellipsoid = std::get_if<model::Ellipsoid>(&shape)) {
    return {of("radii", ellipsoid->radii)};
  }
  if (const auto* polyline = std::get_if<model::Polyline>(&shape)) {
    return {of("height", polyline->height)};
  }
  if (const auto* ground = std::get_if<model::Heightmap>(&shape)) {
    // Its z may be zero: it is flat then.
    const model::Vector3& size = ground->size.value;
    return {
        {"size", ground->size.written ? &ground->size.span : nullptr, std::min(size.x, size.y)}};
  }
  const auto round = [](const auto& solid) -> std::vector<Size> {
    return {of("radius", solid.radius), of("length", solid.length)};
  };
  if (const auto* cylinder = std::get_if<model::Cylinder>(&shape)) return round(*cylinder);
  if (const auto* capsule = std::get_if<model::Capsule>(&shape)) return round(*capsule);
  if (const auto* cone = std::get_if<model::Cone>(&shape)) return round(*cone);
  return {};
}

template <class Part>
void check(const Part& part, Context& context) {
  const model::Shape& shape = part.geometry.shape;
  for (const Size& size : sizes_of(shape)) {
    if (size.span == nullptr || size.smallest > 0) continue;
    context.report({.where = *size.span,
                    .message = fmt::format("the {} of the {} is {} m: it must be above zero",
                                           size.name, model::shape_name(shape), size.smallest),
                    .subject = context.subject(part)});
  }
}

Rule rule() {
  return {
      .name = "size-not-positive",
      .severity = Severity::kError,
      .summary = "a size of a shape is zero or negative",
      .why = "ign sdf -k and check_urdf take it. Newer libsdformat puts a size of its own in its "
             "place, MuJoCo refuses the model, and ODE stops at an assertion.",
      .what_to_do = "Write a size above zero, in metres. For a thin plate write its thickness.",
      .checks = {on<model::Collision>(check), on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::size_not_positive
