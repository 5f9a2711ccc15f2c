// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/nesting.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace rigor::mesh {
namespace {

bool within(const Bounds& inner, const Bounds& outer) {
  return outer.min.x <= inner.min.x && inner.max.x <= outer.max.x && outer.min.y <= inner.min.y &&
         inner.max.y <= outer.max.y && outer.min.z <= inner.min.z && inner.max.z <= outer.max.z;
}

bool strictly_within(const Vector3& p, const Bounds& outer) {
  return outer.min.x < p.x && p.x < outer.max.x && outer.min.y < p.y && p.y < outer.max.y &&
         outer.min.z < p.z && p.z < outer.max.z;
}

auto key(const Vector3& p) { return std::tuple(p.x, p.y, p.z); }

/// Whether the edge, seen along z, passes p on the side of greater x. Its ends are taken in order of y,
/// so that both triangles at it get the same answer, whatever is rounded.
bool passes(const Vector3& a, const Vector3& b, const Vector3& p) {
  if ((a.y > p.y) == (b.y > p.y)) return false;
  const Vector3& low = a.y < b.y ? a : b;
  const Vector3& high = a.y < b.y ? b : a;
  return (high.x - low.x) * (p.y - low.y) > (p.x - low.x) * (high.y - low.y);
}

bool is_above(const Facet& f, const Vector3& p) {
  const int passing = passes(f[0], f[1], p) + passes(f[1], f[2], p) + passes(f[2], f[0], p);
  if (passing != 1) return false;  // seen along z, p lies beside the triangle
  const Vector3 normal = area_vector(f);
  return dot(normal, p - f[0]) * normal.z < 0;
}

class Nest {
 public:
  Nest(const TriangleMesh& mesh, Components& components)
      : mesh_(mesh), components_(components.list), begin_(components.list.size() + 1) {
    sort_faces(components.of_face);
  }

  void run() {
    std::vector<std::uint32_t> open;  // components whose range along x reaches the one examined
    for (const std::uint32_t inner : outer_first()) {
      Component& component = components_[inner];
      std::erase_if(open, [this, &component](std::uint32_t outer) {
        return components_[outer].bounds.max.x < component.bounds.min.x;
      });
      for (const std::uint32_t outer : open) {
        if (work_ > kMaxNestingWork) break;
        if (holds(outer, inner) && smaller(outer, component.inside)) component.inside = outer;
      }
      component.nesting = nesting(component);
      open.push_back(inner);
    }
  }

 private:
  void sort_faces(const std::vector<std::uint32_t>& of_face) {
    for (std::size_t i = 0; i < components_.size(); ++i) {
      begin_[i + 1] = begin_[i] + components_[i].triangles;
    }
    faces_.resize(begin_.back());
    std::vector<std::uint64_t> next = begin_;
    for (std::uint32_t face = 0; face < of_face.size(); ++face) {
      if (of_face[face] != kNoComponent) faces_[next[of_face[face]]++] = face;
    }
  }

  /// The closed ones; what holds another comes before it.
  std::vector<std::uint32_t> outer_first() const {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < components_.size(); ++i) {
      if (components_[i].closed) order.push_back(i);
    }
    const auto rank = [this](std::uint32_t i) {
      const Component& c = components_[i];
      return std::tuple(c.bounds.min.x, -c.bounds.max.x, -std::abs(c.volume));
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return rank(a) < rank(b); });
    return order;
  }

  std::span<const std::uint32_t> faces(std::uint32_t component) const {
    return {faces_.data() + begin_[component], faces_.data() + begin_[component + 1]};
  }

  bool smaller(std::uint32_t a, std::optional<std::uint32_t> b) const {
    return !b || std::abs(components_[a].volume) < std::abs(components_[*b].volume);
  }

  bool holds(std::uint32_t outer, std::uint32_t inner) {
    ++work_;
    const Bounds& bounds = components_[outer].bounds;
    if (!within(components_[inner].bounds, bounds) || !smaller(inner, outer)) return false;
    work_ += faces(inner).size() + faces(outer).size();
    const std::optional<Vector3> p = least_middle_within(bounds, inner);
    if (!p) return false;
    const auto above = std::count_if(
        faces(outer).begin(), faces(outer).end(),
        [&](std::uint32_t face) { return is_above(facet(mesh_, mesh_.triangles[face]), *p); });
    return above % 2 == 1;
  }

  /// Not a corner, in which the two may touch, nor on the bounds, where the outer one's surface may be;
  /// the least one, so that the order of the triangles does not matter.
  std::optional<Vector3> least_middle_within(const Bounds& outer, std::uint32_t inner) const {
    std::optional<Vector3> least;
    for (const std::uint32_t face : faces(inner)) {
      const Vector3 p = middle(facet(mesh_, mesh_.triangles[face]));
      if (strictly_within(p, outer) && (!least || key(p) < key(*least))) least = p;
    }
    return least;
  }

  Nesting nesting(const Component& component) const {
    if (work_ > kMaxNestingWork) return Nesting::kUnknown;
    if (!component.inside) return Nesting::kBody;
    const Component& outer = components_[*component.inside];
    if ((outer.volume < 0) == (component.volume < 0)) return Nesting::kDoubled;
    return outer.nesting == Nesting::kCavity ? Nesting::kBody : Nesting::kCavity;
  }

  const TriangleMesh& mesh_;
  std::vector<Component>& components_;
  std::vector<std::uint64_t> begin_;  // of each component's faces
  std::vector<std::uint32_t> faces_;
  std::uint64_t work_ = 0;
};

}  // namespace

void nest(const TriangleMesh& mesh, Components& components) {
  const auto closed = std::count_if(components.list.begin(), components.list.end(),
                                    [](const Component& c) { return c.closed; });
  if (closed > 1) Nest(mesh, components).run();
}

}  // namespace rigor::mesh
