// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/target.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

namespace rigor::rules {
namespace {

constexpr std::array<std::string_view, 6> kTargetNames{"gazebo-classic", "gz-sim", "ros",
                                                       "mujoco",         "isaac",  "bullet"};
static_assert(kTargetNames.size() == static_cast<std::size_t>(Target::kBullet) + 1);

}  // namespace

std::string_view to_string(Target target) { return kTargetNames[static_cast<std::size_t>(target)]; }

std::optional<Target> target_named(std::string_view name) {
  const auto found = std::find(kTargetNames.begin(), kTargetNames.end(), name);
  if (found == kTargetNames.end()) return std::nullopt;
  return static_cast<Target>(std::distance(kTargetNames.begin(), found));
}

std::vector<std::string_view> target_names() { return {kTargetNames.begin(), kTargetNames.end()}; }

}  // namespace rigor::rules
