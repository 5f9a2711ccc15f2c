// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collada/transform.h>

#include <numbers>
#include <string_view>
#include <vector>

#include <rigor/mesh/collada/index.h>

namespace rigor::mesh {
namespace {

using Values = std::vector<double>;

Affine translation(const Values& v) { return {.origin = {v[0], v[1], v[2]}}; }

Affine scaling(const Values& v) { return {{v[0], 0, 0}, {0, v[1], 0}, {0, 0, v[2]}, {}}; }

/// By rows; the last one says nothing.
Affine matrix(const Values& v) {
  return {{v[0], v[4], v[8]}, {v[1], v[5], v[9]}, {v[2], v[6], v[10]}, {v[3], v[7], v[11]}};
}

/// About an axis, which need not be a unit vector, by degrees.
Affine rotation(const Values& v) {
  const model::Vector3 axis{v[0], v[1], v[2]};
  if (axis == model::Vector3{}) return {};
  const double angle = v[3] * std::numbers::pi / 180;
  const model::Matrix3 R = to_matrix(model::from_axis_angle(axis, angle));
  return {
      {R[0][0], R[1][0], R[2][0]}, {R[0][1], R[1][1], R[2][1]}, {R[0][2], R[1][2], R[2][2]}, {}};
}

struct Kind {
  std::string_view name;
  std::size_t values;
  Affine (*make)(const Values&);  ///< null for one that is not understood
};

constexpr Kind kKinds[] = {{"matrix", 16, matrix},  {"translate", 3, translation},
                           {"rotate", 4, rotation}, {"scale", 3, scaling},
                           {"skew", 7, nullptr},    {"lookat", 9, nullptr}};

}  // namespace

std::optional<Affine> node_transform(xml::Element node) {
  Affine X_PN;
  for (const xml::Element child : node.children()) {
    for (const Kind& kind : kKinds) {
      if (child.name() != kind.name) continue;
      if (!kind.make) return std::nullopt;
      const std::optional<Values> values = numbers(child, kind.values);
      if (!values) return std::nullopt;
      X_PN = X_PN * kind.make(*values);
    }
  }
  return X_PN;
}

}  // namespace rigor::mesh
