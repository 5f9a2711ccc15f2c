// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the file says of a link or a joint, field by field, in a form in which parts on different sides of a
// robot are the same: origins and axes without their signs, limits as the pair or its mirror image.
//
//   const std::vector<SiblingField> fields = fields_of(link, context);

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/rules/assembly/twin_numbers.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

enum class FieldKind : std::uint8_t {
  kNumber,
  kSize,    ///< of a shape, m, or a mesh's scale
  kOrigin,  ///< m
  kAxis,
  kLimits,  ///< rad or m
  kType,
};

/// Three numbers at most.
class SmallList {
 public:
  SmallList(std::initializer_list<double> numbers) : size_(numbers.size()) {
    std::copy(numbers.begin(), numbers.end(), numbers_.begin());
  }
  const double* begin() const { return numbers_.data(); }
  const double* end() const { return numbers_.data() + size_; }
  std::size_t size() const { return size_; }
  double operator[](std::size_t k) const { return numbers_[k]; }
  double front() const { return numbers_.front(); }

 private:
  std::array<double, 3> numbers_{};
  std::size_t size_ = 0;
};

struct SiblingField {
  std::string_view part;  ///< "collision"; empty for the link or joint itself
  std::string_view name;  ///< "radius"
  FieldKind kind = FieldKind::kNumber;
  const char* unit = "";
  SmallList values;                              ///< to be compared
  Span span;                                     ///< of what is written; nowhere when nothing is
  const model::PoseField* pose = nullptr;        ///< of an origin
  const model::Field<double>* number = nullptr;  ///< of a number, or of a size that is one
  const model::Field<model::Vector3>* vector = nullptr;  ///< of an axis, or of a size that is three
};

class SiblingLister {
 public:
  explicit SiblingLister(const Context& context) : context_(context) {}

  std::vector<SiblingField> of_link(const model::Link& link) {
    begin();
    const model::Root& root = context_.root();
    if (context_.is_sdf()) add_origin("pose", link.pose);
    add_number("mass", "kg", link.inertial.mass);
    add_origin("center of mass", link.inertial.pose);
    for (const auto id : link.collisions) add_shape("collision", root[id].pose, root[id].geometry);
    for (const auto id : link.visuals) add_shape("visual", root[id].pose, root[id].geometry);
    return std::move(fields_);
  }

  std::vector<SiblingField> of_joint(const model::Joint& joint) {
    begin();
    add_origin("origin", joint.pose);
    fields_.push_back({.name = "type",
                       .kind = FieldKind::kType,
                       .values = {static_cast<double>(joint.type)},
                       .span = joint.type_name.span});
    for (const model::Axis& axis : joint.axes) {
      const model::Vector3& xyz = axis.xyz.value;
      fields_.push_back({.name = "axis",
                         .kind = FieldKind::kAxis,
                         .values = {std::abs(xyz.x), std::abs(xyz.y), std::abs(xyz.z)},
                         .span = axis.xyz.span,
                         .vector = &axis.xyz});
      add_limits(axis);
      add_number("effort", "N·m", axis.effort);
      add_number("velocity", "rad/s", axis.velocity);
      add_number("damping", "N·m·s/rad", axis.damping);
      add_number("friction", "N·m", axis.friction);
    }
    return std::move(fields_);
  }

 private:
  void begin() {
    constexpr std::size_t kUsual = 16;
    fields_.clear();
    fields_.reserve(kUsual);
  }

  void add_number(std::string_view name, const char* unit, const model::Field<double>& field,
                  FieldKind kind = FieldKind::kNumber, std::string_view part = {}) {
    fields_.push_back({.part = part,
                       .name = name,
                       .kind = kind,
                       .unit = unit,
                       .values = {field.value},
                       .span = field.span,
                       .number = &field});
  }

  void add_origin(std::string_view name, const model::PoseField& pose, std::string_view part = {}) {
    const model::Vector3& t = pose.pose.value.translation;
    fields_.push_back({.part = part,
                       .name = name,
                       .kind = FieldKind::kOrigin,
                       .unit = "m",
                       .values = {std::abs(t.x), std::abs(t.y), std::abs(t.z)},
                       .span = place_of(pose, context_),
                       .pose = &pose});
  }

  void add_limits(const model::Axis& axis) {
    std::pair<double, double> both{axis.lower.value, axis.upper.value};
    both = std::max(both, {-axis.upper.value, -axis.lower.value});
    fields_.push_back({.name = "limits",
                       .kind = FieldKind::kLimits,
                       .unit = "rad or m",
                       .values = {both.first, both.second},
                       .span = axis.lower.written ? axis.lower.span : axis.upper.span});
  }

  void add_vector(std::string_view part, std::string_view name,
                  const model::Field<model::Vector3>& field) {
    const model::Vector3& v = field.value;
    fields_.push_back({.part = part,
                       .name = name,
                       .kind = FieldKind::kSize,
                       .values = {std::abs(v.x), std::abs(v.y), std::abs(v.z)},
                       .span = field.span,
                       .vector = &field});
  }

  void add_shape(std::string_view part, const model::PoseField& pose,
                 const model::Geometry& geometry) {
    add_origin("origin", pose, part);
    const auto add_round = [&](const auto& shape) {
      add_number("radius", "m", shape.radius, FieldKind::kSize, part);
      add_number("length", "m", shape.length, FieldKind::kSize, part);
    };
    if (const auto* s = std::get_if<model::Sphere>(&geometry.shape))
      add_number("radius", "m", s->radius, FieldKind::kSize, part);
    if (const auto* s = std::get_if<model::Cylinder>(&geometry.shape)) add_round(*s);
    if (const auto* s = std::get_if<model::Capsule>(&geometry.shape)) add_round(*s);
    if (const auto* s = std::get_if<model::Box>(&geometry.shape)) add_vector(part, "size", s->size);
    if (const auto* s = std::get_if<model::Mesh>(&geometry.shape))
      add_vector(part, "scale", s->scale);
  }

  const Context& context_;
  std::vector<SiblingField> fields_;
};

/// Whether two fields say the same, but for the signs that the sides of a robot exchange.
inline bool same_field(const SiblingField& a, const SiblingField& b) {
  if (a.values.size() != b.values.size()) return false;
  for (std::size_t k = 0; k < a.values.size(); ++k) {
    if (std::isinf(a.values[k]) && a.values[k] == b.values[k]) continue;
    // Signs that differ are of limits: all else has none.
    if (a.values[k] * b.values[k] < 0 || !same_size(a.values[k], b.values[k])) return false;
  }
  return true;
}

}  // namespace rigor::rules
