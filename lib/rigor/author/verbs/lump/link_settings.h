// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What links and joints say of themselves beside what they hold, when links become parts of others: gravity, friction,
// a material. A link has one gravity, and a `<gazebo>` of URDF is about all collisions and visuals of its link, so what
// differs cannot be said of a part.
//
//   if (std::string fault = fault_of_settings(edited, held_by, joints); !fault.empty()) return refusal(fault);
//   move_blocks(draft, edited, held_by, joints);
//
// Private to the room.

#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include <rigor/author/verbs/draft.h>
#include <rigor/author/verbs/edited_model.h>

namespace rigor::author {

/// Links by name, and the one that each becomes part of.
using HeldBy = std::map<std::string, std::string>;

/// What a link holds that can be another link's: a collision, a sensor, a battery.
bool is_movable_part(std::string_view element);

/// Whether an element of an SDF link says something of the link itself: `gravity`.
bool is_link_setting(std::string_view element);

/// Whether a key of a `<gazebo reference>` says something of the link or of its shapes; else it is something that the
/// link holds.
bool is_block_setting(std::string_view key);

/// Why something would be lost, or be said of another link, too; empty when nothing would. `joints` are those that go.
std::string fault_of_settings(const EditedModel& edited, const HeldBy& held_by,
                              const std::set<std::string>& joints);

/// Of URDF: `<gazebo reference>` of the links that hold, without what those say already or what is about shapes that a
/// link has not; those of joints go.
void move_blocks(Draft& draft, const EditedModel& edited, const HeldBy& held_by,
                 const std::set<std::string>& joints);

}  // namespace rigor::author
