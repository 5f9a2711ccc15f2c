// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which links of a model of MuJoCo's may touch each other, by the bit masks of their geoms; private to the room.

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/convert/from_mjcf/plan.h>

namespace rigor::convert {

/// Those that can touch others than their neighbors, ascending.
std::vector<std::uint32_t> links_that_touch_others(const MjcfPlan& plan);

}  // namespace rigor::convert
