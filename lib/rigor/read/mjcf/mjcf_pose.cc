// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/mjcf/mjcf_pose.h>

#include <cmath>

namespace rigor::read {

using model::from_axes;
using model::Quaternion;
using model::Vector3;

namespace {

Vector3 unit_vector(const Vector3& v) {
  const double size = length(v);
  return size > 0 ? 1 / size * v : Vector3{};
}

}  // namespace

Quaternion rotation_to(const Vector3& direction) {
  const Vector3 z = unit_vector(direction);
  const double sine = std::hypot(z.x, z.y);
  constexpr double kAlong = 1e-10;  // below, the axis is rounding: MuJoCo takes x
  const Vector3 axis = sine < kAlong ? Vector3{1, 0, 0} : Vector3{-z.y / sine, z.x / sine, 0};
  return model::from_axis_angle(axis, std::atan2(sine < kAlong ? 0 : sine, z.z));
}

Quaternion from_euler_sequence(std::string_view sequence, const std::array<double, 3>& angles) {
  Quaternion q;
  for (std::size_t i = 0; i < 3 && i < sequence.size(); ++i) {
    const char letter = sequence[i];
    const bool moved = letter >= 'a';
    const char lower = static_cast<char>(moved ? letter : letter - 'A' + 'a');
    const Vector3 axis = lower == 'x'   ? Vector3{1, 0, 0}
                         : lower == 'y' ? Vector3{0, 1, 0}
                                        : Vector3{0, 0, 1};
    const Quaternion step = model::from_axis_angle(axis, angles[i]);
    q = moved ? q * step : step * q;
  }
  return q;
}

Quaternion mjcf_orientation(const MjcfValues& values, const MjcfSettings& settings) {
  if (const auto n = values.numbers("axisangle"); n.size() == 4) {
    const Vector3 axis{n[0], n[1], n[2]};
    if (length(axis) > 0) return model::from_axis_angle(axis, settings.radians(n[3]));
  }
  if (const auto n = values.numbers("euler"); n.size() == 3) {
    return from_euler_sequence(
        settings.euler_sequence,
        {settings.radians(n[0]), settings.radians(n[1]), settings.radians(n[2])});
  }
  if (const auto n = values.numbers("xyaxes"); n.size() == 6) {
    const Vector3 x = unit_vector({n[0], n[1], n[2]});
    const Vector3 given{n[3], n[4], n[5]};
    const Vector3 y = unit_vector(given - dot(x, given) * x);
    return from_axes(x, y, cross(x, y));
  }
  if (const auto n = values.numbers("zaxis"); n.size() == 3) {
    return rotation_to({n[0], n[1], n[2]});
  }
  if (const auto n = values.numbers("quat"); n.size() == 4) {
    return model::normalized({n[0], n[1], n[2], n[3]});
  }
  return {};
}

model::Pose mjcf_pose(const MjcfValues& values, const MjcfSettings& settings) {
  return {values.vector("pos", {}).value, mjcf_orientation(values, settings)};
}

std::optional<Segment> mjcf_segment(const MjcfValues& values) {
  const auto n = values.numbers("fromto");
  if (n.size() != 6) return std::nullopt;
  const Vector3 from{n[0], n[1], n[2]}, to{n[3], n[4], n[5]};
  return Segment{{0.5 * (from + to), rotation_to(from - to)}, length(from - to) / 2};
}

}  // namespace rigor::read
