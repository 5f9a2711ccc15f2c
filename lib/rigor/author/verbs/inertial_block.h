// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An `<inertial>` with all digits, since a proof compares it with a sum.
//
// Private to the room.

#pragma once

#include <cstdint>
#include <string>

#include <rigor/mass/mass_properties.h>

namespace rigor::author {

enum class InertialForm : std::uint8_t { kSdf, kUrdf };

/// In the link's frame; lines are ended by '\n' and indented from nothing.
std::string inertial_block(const mass::MassProperties& body, InertialForm form);

/// Each line with that in front, and the document's line end between them.
std::string indented_by(const std::string& text, const std::string& by, const std::string& line);

}  // namespace rigor::author
