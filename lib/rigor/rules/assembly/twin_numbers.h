// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers of two parts that a robot has twice, side by side: what is the same up to its sign, and what
// differs by a slip.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/robot/assembled/twins.h>
#include <rigor/rules/assembly/undone_slips.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// Of names that are literals, most of which are in one place.
inline bool same_text(std::string_view a, std::string_view b) {
  return (a.data() == b.data() && a.size() == b.size()) || a == b;
}

/// A number of the file: as one of its own, or as one of a pose, a size or a tensor.
struct TwinNumber {
  std::string_view value_name;  ///< "mass", "origin"; static
  const char* unit = "";
  double value = 0;
  Span written_at;                         ///< not of a pose: see `place_of_number`
  const model::PoseField* pose = nullptr;  ///< in whose translation it is
  std::size_t coordinate = kNone;          ///< of a vector
  std::size_t group = 0;                   ///< of the numbers that are one value: a pose, a tensor

  static constexpr std::size_t kNone = 3;

  std::string name() const {
    std::string result(value_name);
    if (coordinate != kNone) result.append(" ").append(coordinate_name(coordinate));
    return result;
  }
  bool is_of_same_kind(const TwinNumber& other) const {
    return coordinate == other.coordinate && same_text(value_name, other.value_name);
  }
};

/// Of the number in the file, or of the pose it is in.
inline Span place_of_number(const TwinNumber& number, const Context& context) {
  return number.pose ? place_of(*number.pose, context) : number.written_at;
}

using TwinNumbers = std::vector<TwinNumber>;

class NumberLister {
 public:
  explicit NumberLister(const Context& context) : context_(context) {}

  // Without what is left to its default, so that only parts with the same elements are compared.
  TwinNumbers of_link(const model::Link& link) {
    begin();
    const model::Inertial& inertial = link.inertial;
    add("mass", "kg", inertial.mass);
    add_pose("center of mass", inertial.pose);
    add_rotation("inertial rotation", inertial.pose);
    const std::array<std::pair<const char*, const model::Field<double>*>, 6> tensor{
        {{"ixx", &inertial.ixx},
         {"ixy", &inertial.ixy},
         {"ixz", &inertial.ixz},
         {"iyy", &inertial.iyy},
         {"iyz", &inertial.iyz},
         {"izz", &inertial.izz}}};
    ++group_;
    for (const auto& [name, field] : tensor) push({name, "kg·m²", field->value, field->span});
    const model::Root& root = context_.root();
    for (const auto id : link.collisions) add_shape(kCollision, root[id].pose, root[id].geometry);
    for (const auto id : link.visuals) add_shape(kVisual, root[id].pose, root[id].geometry);
    return std::move(numbers_);
  }

  TwinNumbers of_joint(const model::Joint& joint) {
    begin();
    add_pose("origin", joint.pose);
    add_rotation("origin rotation", joint.pose);
    for (const model::Axis& axis : joint.axes) {
      add("effort", "N·m", axis.effort);
      add("velocity", "rad/s", axis.velocity);
      add("damping", "N·m·s/rad", axis.damping);
      add("friction", "N·m", axis.friction);
      add_limits(axis, joint.type == model::JointType::kPrismatic ? "m" : "rad");
    }
    return std::move(numbers_);
  }

  TwinNumbers of_placement(const model::Link& link) {
    begin();
    add_pose("pose", link.pose);
    return std::move(numbers_);
  }

 private:
  void begin() {
    constexpr std::size_t kUsual = 64;
    numbers_.clear();
    numbers_.reserve(kUsual);
  }

  void push(const TwinNumber& number) {
    numbers_.push_back(number);
    numbers_.back().group = group_;
  }

  void add(std::string_view name, const char* unit, const model::Field<double>& field) {
    ++group_;
    if (field.written) push({name, unit, field.value, field.span});
  }

  /// The smaller first: sides may exchange them, with their signs.
  void add_limits(const model::Axis& axis, const char* unit) {
    if (!axis.lower.written || !axis.upper.written) return;
    const model::Field<double>* low = &axis.lower;
    const model::Field<double>* high = &axis.upper;
    if (std::abs(low->value) > std::abs(high->value)) std::swap(low, high);
    ++group_;
    push({"smaller limit", unit, low->value, low->span});
    push({"larger limit", unit, high->value, high->span});
  }

  void add_pose(std::string_view name, const model::PoseField& pose) {
    ++group_;
    for (std::size_t k = 0; k < 3; ++k)
      push({name, "m", pose.pose.value.translation.*kCoordinates[k], {}, &pose, k});
  }

  /// A mirrored rotation has the same quaternion but for signs.
  void add_rotation(std::string_view name, const model::PoseField& pose) {
    const model::Quaternion& q = pose.pose.value.rotation;
    ++group_;
    for (const double part : {q.w, q.x, q.y, q.z}) push({name, "", part, pose.pose.span});
  }

  void add_vector(std::string_view name, const char* unit,
                  const model::Field<model::Vector3>& field) {
    ++group_;
    for (std::size_t k = 0; k < 3 && field.written; ++k)
      push({name, unit, field.value.*kCoordinates[k], field.span, nullptr, k});
  }

  /// What the numbers of a collision, or of a visual, are called.
  struct ShapeNames {
    std::string_view origin, rotation, radius, length, size, scale;
  };
  static constexpr ShapeNames kCollision{"collision",        "collision rotation",
                                         "collision radius", "collision length",
                                         "collision size",   "collision scale"};
  static constexpr ShapeNames kVisual{"visual",        "visual rotation", "visual radius",
                                      "visual length", "visual size",     "visual scale"};

  void add_shape(const ShapeNames& names, const model::PoseField& pose,
                 const model::Geometry& geometry) {
    add_pose(names.origin, pose);
    add_rotation(names.rotation, pose);
    const auto add_round = [&](const auto& shape) {
      add(names.radius, "m", shape.radius);
      add(names.length, "m", shape.length);
    };
    if (const auto* s = std::get_if<model::Sphere>(&geometry.shape))
      add(names.radius, "m", s->radius);
    if (const auto* s = std::get_if<model::Cylinder>(&geometry.shape)) add_round(*s);
    if (const auto* s = std::get_if<model::Capsule>(&geometry.shape)) add_round(*s);
    if (const auto* s = std::get_if<model::Box>(&geometry.shape))
      add_vector(names.size, "m", s->size);
    if (const auto* s = std::get_if<model::Mesh>(&geometry.shape))
      add_vector(names.scale, "", s->scale);
  }

  const Context& context_;
  TwinNumbers numbers_;
  std::size_t group_ = 0;
};

/// Whether two numbers are the same but for their sign: to the digits that people write.
inline bool same_size(double a, double b) {
  constexpr double kDigits = 1e-5;
  constexpr double kNothing = 1e-9;
  const double p = std::abs(a), q = std::abs(b);
  return std::abs(p - q) <= kDigits * std::max(p, q) + kNothing;
}

/// The factor by which the larger is too large, when that is one of a slip: 10, 100 or 1000.
inline std::optional<double> slip_factor(double a, double b) {
  constexpr double kExact = 1e-6;
  const double p = std::abs(a), q = std::abs(b);
  if (!(std::min(p, q) > 0)) return std::nullopt;
  const double ratio = std::max(p, q) / std::min(p, q);
  for (const double factor : {10.0, 100.0, 1000.0}) {
    if (std::abs(ratio - factor) < kExact * factor) return factor;
  }
  return std::nullopt;
}

/// Shares of a value's largest number.
inline constexpr double kSameValue = 0.01;   // rounded, or calibrated
inline constexpr double kOtherValue = 0.05;  // no calibration is off by so much

/// What the numbers of two parts have in common; nothing when they are not of the same kinds, or when a value is
/// neither the same nor clearly another: the parts are calibrated, or drawn anew.
struct TwinDifference {
  std::size_t same = 0;  ///< numbers that are not zero, and of values that are equal but for signs
  std::vector<std::size_t> begins;  ///< of the values that differ: places of their first numbers
};

inline bool is_inertial(const TwinNumber& number) {
  return number.value_name == "inertial rotation";
}

/// How far two values are apart that begin at these numbers, and where they end.
struct ValueDifference {
  std::size_t end = 0;
  double apart = 0;  ///< of the numbers that differ most, signs aside
  double size = 0;   ///< of the largest number
};

inline ValueDifference value_difference(const TwinNumbers& a, const TwinNumbers& b,
                                        std::size_t begin) {
  ValueDifference result{begin, 0, 0};
  for (std::size_t& i = result.end; i < a.size() && a[i].group == a[begin].group; ++i) {
    const double p = std::abs(a[i].value), q = std::abs(b[i].value);
    if (std::isinf(p) && std::isinf(q)) continue;
    result.apart = std::max(result.apart, std::abs(p - q));
    result.size = std::max({result.size, p, q});
  }
  return result;
}

inline std::optional<TwinDifference> difference_of(const TwinNumbers& a, const TwinNumbers& b) {
  constexpr double kSamePlace = 1e-3;   // m
  constexpr double kOtherPlace = 3e-3;  // m
  if (a.size() != b.size()) return std::nullopt;
  TwinDifference result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!a[i].is_of_same_kind(b[i])) return std::nullopt;
  }
  for (std::size_t i = 0; i < a.size();) {
    const ValueDifference value = value_difference(a, b, i);
    const bool place = a[i].pose != nullptr;
    // A part that is mirrored by rotating it, as most are drawn, is no other part.
    const bool shown = a[i].value_name.ends_with("rotation") && !is_inertial(a[i]);
    if (shown && value.apart > kSameValue * value.size) {
      i = value.end;
      continue;
    }
    if (value.apart <= kSameValue * value.size || (place && value.apart <= kSamePlace)) {
      for (std::size_t k = i; k < value.end; ++k) result.same += a[k].value != 0;
    } else if (value.apart > kOtherValue * value.size && (!place || value.apart > kOtherPlace)) {
      result.begins.push_back(i);
    } else {
      return std::nullopt;
    }
    i = value.end;
  }
  return result;
}

/// The links, or the joints, of a model.
template <class Entity>
const std::vector<model::Id<Entity>>& members_of(const model::Model& model) {
  if constexpr (std::is_same_v<Entity, model::Link>) {
    return model.links;
  } else {
    return model.joints;
  }
}

/// Pairs of entities of one list that are twins by name, of the same model and of the file itself.
template <class Entity>
std::vector<robot::Twins> twins_of(const std::vector<Entity>& all, robot::Side side,
                                   const model::Root& root) {
  std::vector<robot::Twins> result;
  std::vector<std::string_view> names;
  std::vector<std::uint32_t> own;
  for (const model::Model& model : root.models) {
    const auto& members = members_of<Entity>(model);
    if (members.size() < 2) continue;
    names.clear();
    own.clear();
    for (const auto id : members) {
      if (!root.own(all[id.value].site)) continue;
      names.push_back(all[id.value].name.value);
      own.push_back(id.value);
    }
    for (const robot::Twins& pair : robot::twins(names, side))
      result.push_back({own[pair.a], own[pair.b]});
  }
  return result;
}

}  // namespace rigor::rules
