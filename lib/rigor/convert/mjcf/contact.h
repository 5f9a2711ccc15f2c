// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What touches what, and how slippery it is. Private to the room.
//
// Two geoms collide when a bit of the one's `contype` is in the other's `conaffinity`, or the reverse. Bit 0
// is the ground's and that of everything else that a scene adds. A model whose parts move against each other has a bit
// of its own, which its own geoms do not accept, and those of links that may collide with their own model have bit 30
// in both. All others share bit 1, which they accept; so do models for which no bit is left, and their pairs of bodies
// are excluded one by one.
//
// Friction: MuJoCo takes the larger coefficient of two geoms, Gazebo the smaller; so a geom whose friction is
// written has `priority`, and its own coefficient holds against the ground.

#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <rigor/convert/mjcf/assembly.h>

namespace rigor::convert {

struct MjcfDraft;

struct MjcfContactBits {
  std::uint32_t type = 1;
  std::uint32_t affinity = 1;
  bool operator==(const MjcfContactBits&) const = default;
};

/// Of links of the only model that do not collide with each other: what the class `collision` has.
inline constexpr MjcfContactBits kMjcfOneModel{2, 1};

/// The bits of the models. Where there is only one, none is needed.
class MjcfModelBits {
 public:
  explicit MjcfModelBits(const MjcfAssembly& assembly);

  bool only_one() const { return models_.size() < 2; }
  /// In `contype`, of a model's geoms.
  std::uint32_t of(std::uint32_t model) const { return models_[model].bit; }
  /// Whether the bit is that of others, too, so that its bodies would collide with each other.
  bool is_excluded(std::uint32_t model) const { return models_[model].excluded; }

 private:
  struct Model {
    std::uint32_t bit = 0;
    bool excluded = false;
  };
  std::vector<Model> models_;
};

/// Pairs of bodies of one model that would collide and are not to, as the model has no bit of its own.
std::vector<std::pair<std::uint32_t, std::uint32_t>> bodies_to_exclude(MjcfDraft& draft);

/// Bits, friction and priority of a collision.
void set_contact(MjcfDraft& draft, std::uint32_t body, const model::Collision& collision,
                 MjcfElement& geom);

}  // namespace rigor::convert
