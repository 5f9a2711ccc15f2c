// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The models that become one MJCF file, as one robot seen from the world. Private to the room.
//
//   MjcfAssembly assembly = mjcf_assembly(source, options, ledger, models);
//   if (!assembly.unknown.empty()) refuse();

#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <rigor/convert/to_mjcf.h>

namespace rigor::convert {

struct MjcfAssembly {
  /// Bodies of all models; names begin with the model's where there are several. Roots stand in the world;
  /// the roots of a static model are fixed to it, and its joints are fixed. `world` is its last body.
  robot::Robot robot;
  std::vector<std::uint32_t> model_of;  ///< of each body, which of the models; the world: none
  std::uint32_t world = robot::kNoIndex;
  bool any_static = false;                     ///< whether a model is static
  std::map<std::string, std::string> held_by;  ///< of lumped links
  /// Bodies with an inertia that no rigid body has, on fixed joints: it is in another one, where the sum is
  /// possible. `to` is the world's where the body never moves: then the nearest inertia does no harm.
  struct MovedInertia {
    std::uint32_t from = robot::kNoIndex;
    std::uint32_t to = robot::kNoIndex;
    std::array<double, 3> moments{};  ///< kg·m²
  };
  std::vector<MovedInertia> moved_inertias;
};

MjcfAssembly mjcf_assembly(const MjcfSource& source, const MjcfOptions& options,
                           const std::vector<model::Id<model::Model>>& models);

/// kg, of each link without mass that has to have one: all of them together weigh next to nothing.
double massless_link_mass(const robot::Robot& robot);
/// The same, as much as MuJoCo takes.
double mjcf_massless_link(const robot::Robot& robot);

/// Whether the body's frame never moves.
std::vector<bool> fixed_to_world(const robot::Robot& robot, std::uint32_t world);

}  // namespace rigor::convert
