// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How often a closed mesh goes round the places inside it: once where it should, twice where parts of
// it overlap or stand there twice, minus once where it is inside out.
//
// A grid of lines along z is laid through the mesh; along each line the winding number steps by one at
// every triangle that is crossed. A place that the mesh counts twice counts twice in its volume too, so
// the lengths along the lines say how wrong that is. (Winding numbers of closed surfaces: A. Jacobson,
// L. Kavan, O. Sorkine-Hornung, "Robust inside-outside segmentation using generalized winding
// numbers", 2013.)
//
//   WindingProbe probe(bounds);
//   for (const Triangle& t : mesh.triangles) probe.add(facet(mesh, t));
//   if (probe.result().doubled > 0.01) warn();

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Shares of the length inside the mesh, from 0 to 1.
struct Winding {
  double doubled = 0;   ///< what is counted more often than once, by how often: 1 when all is twice
  double inverted = 0;  ///< winding number below zero
  int lines = 0;        ///< lines that met the mesh and came out as they went in
};

class WindingProbe {
 public:
  /// `bounds` need not be exact: they only say where the lines go.
  explicit WindingProbe(const Bounds& bounds);

  void add(const Facet& facet);
  void join(const WindingProbe& other);

  Winding result() const;

 private:
  struct Crossing {
    std::uint32_t line;
    std::int32_t step;  // +1 where the line enters
    double z;
  };

  void cross(const Facet& facet, int column, int row);

  double x_ = 0;  // of the first line
  double y_ = 0;
  double dx_ = 0;  // between lines
  double dy_ = 0;
  std::vector<Crossing> crossings_;
};

}  // namespace rigor::mesh
