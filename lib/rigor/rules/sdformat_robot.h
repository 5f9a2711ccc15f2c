// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What libsdformat 12 makes of a URDF robot: it reads the file with urdfdom, lumps links at fixed joints
// into their parents, leaves out links without mass and all that hangs on them, and judges what remains.
//
//   const SdformatRobot& robot = context.sdformat_robot();
//   if (robot.known && robot.links == 0) say_that_nothing_is_left();

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <rigor/mass/mass_properties.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>

namespace rigor::rules {

struct SdformatRobot {
  enum class Fate : std::uint8_t {
    kDropped,  ///< without mass, or below a link without mass
    kLumped,   ///< part of another link
    kLink,     ///< a link of the model
  };
  struct Part {
    Fate fate = Fate::kDropped;
    std::size_t head = 0;           ///< the link that it is part of; itself unless lumped
    model::Id<model::Joint> joint;  ///< whose child it is; none for the root
    bool has_inertial = false;      ///< its own, or one of those lumped into it
    mass::MassProperties body;      ///< in the link frame, with those lumped into it
  };

  /// Whether urdfdom gets as far as a tree: if not it refuses the file, and there are no parts.
  bool known = false;
  std::vector<Part> parts;  ///< per link of the robot, in its order
  std::size_t links = 0;    ///< how many are links of the model

  /// Whether libsdformat refuses the inertia of the link that this one became or is part of.
  bool refuses_inertia(std::size_t link) const;
};

/// Of the first model of a URDF file.
SdformatRobot sdformat_robot(const model::Root& root, const model::Frames& frames);

}  // namespace rigor::rules
