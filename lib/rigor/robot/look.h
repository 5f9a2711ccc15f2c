// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How shapes are drawn. Who can decode pictures finds it (view/drawing/looks.h); who converts asks.

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/model.h>
#include <rigor/robot/robot.h>

namespace rigor::robot {

enum class PictureShape : std::uint8_t { kAsItIs, kSquare };

struct Look {
  Color color;
  /// Of the picture that multiplies the color: its path, or another name that no other picture has; empty without one.
  std::string picture = {};
  std::function<std::string(PictureShape)> png = {};  ///< its bytes
};

/// Of a visual: one for each part of its mesh, or one for all of it, as simulators draw it; none where neither the
/// model nor the mesh says how it looks. Of the mesh, parts, materials and whether corners have colors are used.
using FindLooks =
    std::function<std::vector<Look>(model::Id<model::Visual>, const mesh::TriangleMesh&)>;

}  // namespace rigor::robot
