// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Links that touch at rest only with other collisions than a robot had.
//
//   const RestContacts contacts(before, surfaces, has_collision);
//   for (const auto& [a, b] : contacts.added(after, surfaces)) say(after.bodies[a].name);
//
// Private to the room.

#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <rigor/robot/collision/collision_bodies.h>
#include <rigor/robot/robot.h>

namespace rigor::author {

using BodyPair = std::pair<std::uint32_t, std::uint32_t>;

class RestContacts {
 public:
  /// `has_collision` of each body, before or after. The robot outlives it.
  RestContacts(const robot::Robot& before, const robot::FindSurface& surfaces,
               std::vector<bool> has_collision);

  /// Of two links that no joint connects. `after` has the same bodies.
  std::vector<BodyPair> added(const robot::Robot& after, const robot::FindSurface& surfaces) const;

  /// How many pairs are checked.
  std::size_t checked() const { return pairs_.size(); }

 private:
  std::vector<BodyPair> pairs_;
  std::vector<bool> touched_;  // of each pair, before
};

}  // namespace rigor::author
