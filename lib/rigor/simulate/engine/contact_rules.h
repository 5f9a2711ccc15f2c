// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which shapes of a scene touch, and with what surface, whatever the engine. After Gazebo 11
// (physics/ode/ODEPhysics.cc): the smaller mu, restitution and bounce threshold of the two, slips summed up (they
// give way one after the other), kp in series, kd summed up. Private to the room.
//
//   const ContactRules rules(scene);
//   if (rules.may_touch(a, b)) use(combined(scene.shapes[a].surface, scene.shapes[b].surface));

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

class ContactRules {
 public:
  explicit ContactRules(const Scene& scene);

  /// Two shapes of the scene, by their indices.
  bool may_touch(std::uint32_t a, std::uint32_t b) const;

 private:
  struct Shape {
    std::uint32_t body = kWorld;
    std::uint32_t model = kWorld;  ///< kWorld for ground that belongs to none
    bool self_collide = false;
    bool without_contact = false;
    std::uint32_t bitmask = 0;
  };

  bool are_jointed(std::uint32_t a, std::uint32_t b) const;

  std::vector<Shape> shapes_;
  std::vector<std::uint64_t> jointed_;  ///< pairs of bodies, sorted
};

/// Of a pair: mu, mu2, slips, restitution, bounce_threshold, kp, kd and max_contacts.
ContactSurface combined(const ContactSurface& a, const ContactSurface& b);

}  // namespace rigor::simulate
