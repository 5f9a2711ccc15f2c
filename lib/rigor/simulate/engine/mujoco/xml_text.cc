// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine/mujoco/xml_text.h>

#include <array>
#include <charconv>
#include <cmath>

namespace rigor::simulate {
namespace {

/// Larger than any effort, angle or length of a scene, and harmless in a sum of squares.
constexpr double kAsGoodAsInfinite = 1e10;

}  // namespace

std::string number_text(double value) {
  std::array<char, 32> text{};
  if (std::isinf(value)) value = std::copysign(kAsGoodAsInfinite, value);
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string attribute(std::string_view name, std::initializer_list<double> values) {
  std::string all;
  for (const double value : values) all += (all.empty() ? "" : " ") + number_text(value);
  return attribute(name, all);
}

std::string attribute(std::string_view name, const Vector3& v) {
  return attribute(name, {v.x, v.y, v.z});
}

std::string attribute(std::string_view name, std::string_view text) {
  return std::string(" ").append(name).append("=\"").append(text).append("\"");
}

std::string pose_attributes(const Pose& X) {
  const Quaternion& q = X.rotation;
  return attribute("pos", X.translation) + attribute("quat", {q.w, q.x, q.y, q.z});
}

}  // namespace rigor::simulate
