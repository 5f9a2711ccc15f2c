// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers of a target with the digits that their author wrote in the source. Private to the room.
//
//   shape.radius = written_number(documents, sphere.radius);
//   visual.origin = written_origin(documents, visual.pose);  // where the frames are the same

#pragma once

#include <rigor/convert/urdf/robot.h>
#include <rigor/model/field.h>
#include <rigor/model/model.h>
#include <rigor/model/pose.h>
#include <rigor/read/documents.h>

namespace rigor::convert {

/// Defaults, and what is not written as the value's own digits, have no text.
Number written_number(const read::Documents& documents, const model::Field<double>& field);
Number3 written_numbers(const read::Documents& documents,
                        const model::Field<model::Vector3>& field);

/// The pose itself, whatever it is relative to. Angles in degrees and quaternions are computed.
UrdfOrigin written_origin(const read::Documents& documents, const model::PoseField& pose);

/// What may be left of two frames that are one, m and rad, when their poses were multiplied out: a
/// thousandth of what any reader compares with.
inline constexpr double kSameFrame = 1e-12;

bool is_identity(const model::Pose& X);

}  // namespace rigor::convert
