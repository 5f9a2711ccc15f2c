// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers of two parts that a robot has twice, side by side: what is the same up to its sign, and what
// differs by a slip.

#pragma once

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

#include <rigor/robot/assembled/twins.h>
#include <rigor/rules/assembly/undone_slips.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// A number of the file: as one of its own, or as one of three of a pose or size.
struct TwinNumber {
  std::string name;  ///< "mass", "origin x"
  const char* unit = "";
  double value = 0;
  Span span;
  const model::PoseField* pose = nullptr;  ///< in whose translation it is
  std::size_t coordinate = 0;
};

using TwinNumbers = std::vector<TwinNumber>;

class NumberLister {
 public:
  explicit NumberLister(const Context& context) : context_(context) {}

  TwinNumbers of_link(const model::Link& link) {
    numbers_.clear();
    const model::Inertial& inertial = link.inertial;
    add("mass", "kg", inertial.mass);
    add_pose("center of mass", inertial.pose);
    const std::array<std::pair<const char*, const model::Field<double>*>, 6> tensor{
        {{"ixx", &inertial.ixx},
         {"ixy", &inertial.ixy},
         {"ixz", &inertial.ixz},
         {"iyy", &inertial.iyy},
         {"iyz", &inertial.iyz},
         {"izz", &inertial.izz}}};
    for (const auto& [name, field] : tensor) add(name, "kg·m²", *field);
    const model::Root& root = context_.root();
    for (const auto id : link.collisions) add_shape("collision", root[id].pose, root[id].geometry);
    for (const auto id : link.visuals) add_shape("visual", root[id].pose, root[id].geometry);
    return std::move(numbers_);
  }

  /// Without its limits, which sides may exchange.
  TwinNumbers of_joint(const model::Joint& joint) {
    numbers_.clear();
    add_pose("origin", joint.pose);
    for (const model::Axis& axis : joint.axes) {
      add("effort", "N·m", axis.effort);
      add("velocity", "rad/s", axis.velocity);
      add("damping", "N·m·s/rad", axis.damping);
      add("friction", "N·m", axis.friction);
    }
    return std::move(numbers_);
  }

  TwinNumbers of_placement(const model::Link& link) {
    numbers_.clear();
    add_pose("pose", link.pose);
    return std::move(numbers_);
  }

 private:
  void add(const std::string& name, const char* unit, const model::Field<double>& field) {
    numbers_.push_back({name, unit, field.value, field.span, nullptr, 0});
  }

  void add_pose(const std::string& name, const model::PoseField& pose) {
    for (std::size_t k = 0; k < 3; ++k) {
      numbers_.push_back({name + ' ' + std::string(coordinate_name(k)), "m",
                          pose.pose.value.translation.*kCoordinates[k], place_of(pose, context_),
                          &pose, k});
    }
  }

  void add_shape(const std::string& name, const model::PoseField& pose,
                 const model::Geometry& geometry) {
    add_pose(name, pose);
    const auto add_round = [&](const auto& shape) {
      add(name + " radius", "m", shape.radius);
      add(name + " length", "m", shape.length);
    };
    const auto add_vector = [&](const char* what, const model::Field<model::Vector3>& field) {
      for (std::size_t k = 0; k < 3; ++k)
        numbers_.push_back({name + what + std::string(coordinate_name(k)), "",
                            field.value.*kCoordinates[k], field.span, nullptr, k});
    };
    if (const auto* s = std::get_if<model::Sphere>(&geometry.shape))
      add(name + " radius", "m", s->radius);
    if (const auto* s = std::get_if<model::Cylinder>(&geometry.shape)) add_round(*s);
    if (const auto* s = std::get_if<model::Capsule>(&geometry.shape)) add_round(*s);
    if (const auto* s = std::get_if<model::Box>(&geometry.shape)) add_vector(" size ", s->size);
    if (const auto* s = std::get_if<model::Mesh>(&geometry.shape)) add_vector(" scale ", s->scale);
  }

  const Context& context_;
  TwinNumbers numbers_;
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

/// What the numbers of two parts have in common; nothing when they are not of the same kinds.
struct TwinDifference {
  std::size_t same = 0;                ///< numbers that are not zero, and equal but for their sign
  std::vector<std::size_t> different;  ///< places in the lists
};

inline std::optional<TwinDifference> difference_of(const TwinNumbers& a, const TwinNumbers& b) {
  if (a.size() != b.size()) return std::nullopt;
  TwinDifference result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].name != b[i].name) return std::nullopt;
    const bool both_unlimited = std::isinf(a[i].value) && std::isinf(b[i].value);
    if (both_unlimited || (a[i].value == 0 && b[i].value == 0)) continue;
    if (same_size(a[i].value, b[i].value)) {
      ++result.same;
    } else {
      result.different.push_back(i);
    }
  }
  return result;
}

/// Pairs of entities of one list that are twins by name, of the same model and of the file itself.
template <class Entity>
std::vector<robot::Twins> twins_of(const std::vector<Entity>& all, robot::Side side,
                                   const model::Root& root) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> by_model;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    if (root.own(all[i].site) && all[i].model) by_model[all[i].model.value].push_back(i);
  }
  std::vector<robot::Twins> result;
  for (const auto& [model, members] : by_model) {
    if (members.size() < 2) continue;
    std::vector<std::string> names;
    for (const std::uint32_t i : members) names.push_back(all[i].name.value);
    for (const robot::Twins& pair : robot::twins(names, side))
      result.push_back({members[pair.a], members[pair.b]});
  }
  return result;
}

}  // namespace rigor::rules
