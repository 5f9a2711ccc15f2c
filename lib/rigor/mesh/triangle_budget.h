// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How many triangles a mesh should have at most. The rules' pages say where the numbers come from.

#pragma once

#include <cstdint>

namespace rigor::mesh {

inline constexpr std::uint64_t kMaxVisualTriangles = 100'000;
inline constexpr std::uint64_t kMaxCollisionTriangles = 20'000;

}  // namespace rigor::mesh
