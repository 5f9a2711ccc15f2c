// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Takes bodies as long as there is room, and knows how far they reach. Private to the room.
//
//   Canvas canvas(root);
//   canvas.add(std::move(body));                       // or it says why not
//   const double meters = canvas.size_around(link);

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rigor/view/drawing/drawing.h>

namespace rigor::view {

class Canvas {
 public:
  explicit Canvas(const model::Root& root) : root_(root) {}

  void add(Body body);
  /// The same for one whose size is told later: it counts in no bounds. Whether there was room.
  [[nodiscard]] bool put_off(Body body);
  void refuse(const Body& body, std::string why);

  /// Whether so many more places may be examined, `kMaxPlacedTriangles` in all; if so they count.
  [[nodiscard]] bool may_look_at(std::size_t places);

  /// A place that belongs to the model of a link.
  void note(model::Id<model::Link> link, const model::Vector3& place);

  /// The diagonal (m) of the outermost model that a link is part of, as far as it is known; 1 where it has
  /// no size.
  double size_around(model::Id<model::Link> link) const;

  std::vector<Body>& bodies() { return drawing_.bodies; }
  const mesh::Bounds& bounds() const { return drawing_.bounds; }
  /// m, in the frame of the world: of visuals and collisions but planes; infinite when there are none.
  double lowest_shape() const { return lowest_shape_; }
  /// Of all bodies, those that were put off as well.
  void bound_all();

  Drawing drawing() { return std::move(drawing_); }

 private:
  bool has_room(const Body& body);
  std::uint32_t outermost(model::Id<model::Link> link) const;

  const model::Root& root_;
  Drawing drawing_{.bounds = mesh::bounds_of({})};
  std::map<std::uint32_t, mesh::Bounds> models_;  // by the index of an outermost model
  std::set<const mesh::TriangleMesh*> meshes_;
  double lowest_shape_ = HUGE_VAL;
  std::size_t triangles_ = 0;  // of `meshes_`
  std::size_t places_ = 0;
};

}  // namespace rigor::view
