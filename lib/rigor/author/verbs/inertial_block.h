// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An `<inertial>` with the digits of write::kComputedDigits, since a proof compares it with a sum.
//
// Private to the room.

#pragma once

#include <cstdint>
#include <string>

#include <rigor/author/verbs/draft.h>
#include <rigor/author/verbs/edited_model.h>
#include <rigor/mass/mass_properties.h>

namespace rigor::author {

enum class InertialForm : std::uint8_t { kSdf, kUrdf };

/// Lines are ended by '\n' and indented from nothing. `X_LB` is where the frame of the body is in that of the link; its
/// rotation is written, rather than the tensor rotated: by a rounding a rod's would be none that a body can have.
std::string inertial_block(const mass::MassProperties& body, InertialForm form,
                           const model::Pose& X_LB = {});

/// Gives a link of the file that inertial, in the link's frame: number by number where it has one, so that comments and
/// layout stay, else as its first child behind a pose.
void set_inertial(Draft& draft, const EditedModel& edited, const model::Link& link,
                  const mass::MassProperties& body);

/// Each line with that in front, and the document's line end between them.
std::string indented_by(const std::string& text, const std::string& by, const std::string& line);

}  // namespace rigor::author
