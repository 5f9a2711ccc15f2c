// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/digits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <rigor/convert/written_number.h>

namespace rigor::convert {
namespace {

using model::Pose;
using model::Quaternion;
using model::Vector3;

bool is_same_rotation(const Quaternion& a, const Quaternion& b) {
  const double sign = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z < 0 ? -1 : 1;
  const std::array apart{a.w - sign * b.w, a.x - sign * b.x, a.y - sign * b.y, a.z - sign * b.z};
  return std::all_of(apart.begin(), apart.end(),
                     [](double part) { return std::abs(part) <= kDigitNoise; });
}

/// Gives numbers that have no text yet that of `written`, where it says `v`.
void adopt(Number3& target, const Vector3& v, const Number3& written) {
  const std::array values{v.x, v.y, v.z};
  const double size = std::max({1.0, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  for (std::size_t i = 0; i < 3; ++i) {
    if (!target[i].text.empty() || written[i].text.empty()) continue;
    if (std::abs(values[i] - written[i].value) <= kDigitNoise * size) target[i] = written[i];
  }
}

}  // namespace

Number3 numbers_like(const read::Documents& documents, const Vector3& v,
                     const model::Field<Vector3>& field) {
  Number3 result = numbers(v);
  adopt(result, v, written_numbers(documents, field));
  return result;
}

UrdfOrigin origin_like(const read::Documents& documents, const Pose& X,
                       std::initializer_list<const model::PoseField*> written) {
  UrdfOrigin origin = origin_of(X);
  for (const model::PoseField* field : written) {
    if (!field->pose.written) continue;
    const UrdfOrigin said = written_origin(documents, *field);
    adopt(origin.xyz, X.translation, said.xyz);
    if (origin.rpy[0].text.empty() && !said.rpy[0].text.empty() &&
        is_same_rotation(X.rotation, pose_of(said).rotation)) {
      origin.rpy = said.rpy;
    }
  }
  return origin;
}

}  // namespace rigor::convert
