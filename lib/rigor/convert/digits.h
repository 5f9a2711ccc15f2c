// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The author's digits for what was computed, where it came out as what somebody wrote: a joint's origin
// is mostly the pose of the joint or of a link. Private to the room.

#pragma once

#include <initializer_list>

#include <rigor/convert/urdf/robot.h>
#include <rigor/model/field.h>
#include <rigor/model/model.h>
#include <rigor/model/pose.h>
#include <rigor/read/documents.h>

namespace rigor::convert {

/// Two numbers this near came from the same one by way of a few sums and turns: the last bits of
/// doubles of about a meter, and a hundredth of what a pose may be off by. m, or of a quaternion.
inline constexpr double kDigitNoise = 1e-14;

/// `v`, each number with its text in the field where that says the same.
Number3 numbers_like(const read::Documents& documents, const model::Vector3& v,
                     const model::Field<model::Vector3>& field);

/// `X`, each number with its text in the first of the written poses that says the same.
UrdfOrigin origin_like(const read::Documents& documents, const model::Pose& X,
                       std::initializer_list<const model::PoseField*> written);

}  // namespace rigor::convert
