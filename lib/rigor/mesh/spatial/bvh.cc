// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/spatial/bvh.h>

#include <cmath>
#include <tuple>
#include <utility>

namespace rigor::mesh {
namespace {

Vector3 along(const Vector3& from, double t, const Vector3& way) {
  return {from.x + t * way.x, from.y + t * way.y, from.z + t * way.z};
}

double squared_distance(const Vector3& a, const Vector3& b) {
  const Vector3 d = a - b;
  return dot(d, d);
}

Vector3 closest_on_edge(const Vector3& a, const Vector3& b, const Vector3& p) {
  const Vector3 way = b - a;
  const double t = dot(p - a, way);
  const double whole = dot(way, way);
  if (!(t > 0)) return a;
  return t >= whole ? b : along(a, t / whole, way);
}

Bounds facet_bounds(const Facet& f) {
  return {{std::min({f[0].x, f[1].x, f[2].x}), std::min({f[0].y, f[1].y, f[2].y}),
           std::min({f[0].z, f[1].z, f[2].z})},
          {std::max({f[0].x, f[1].x, f[2].x}), std::max({f[0].y, f[1].y, f[2].y}),
           std::max({f[0].z, f[1].z, f[2].z})}};
}

float at_most(double x) {
  const auto rounded = static_cast<float>(x);
  return rounded <= x ? rounded : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

float at_least(double x) { return -at_most(-x); }

struct Item {
  std::array<float, 3> middle;
  std::uint32_t index;
};

/// The axis along which the middles are spread most.
std::size_t longest_axis(const Item* begin, const Item* end) {
  std::array<float, 3> min = begin->middle;
  std::array<float, 3> max = begin->middle;
  for (const Item* item = begin; item != end; ++item) {
    for (std::size_t k = 0; k < 3; ++k) {
      min[k] = std::min(min[k], item->middle[k]);
      max[k] = std::max(max[k], item->middle[k]);
    }
  }
  const std::array<float, 3> size{max[0] - min[0], max[1] - min[1], max[2] - min[2]};
  return static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
}

/// Halves at powers of two, so that blocks of each level are halves of halves.
void sort_by_halving(std::vector<Item>& items, std::size_t leaf) {
  using Range = std::pair<std::size_t, std::size_t>;
  std::vector<Range> open{{0, items.size()}};
  while (!open.empty()) {
    const auto [begin, end] = open.back();
    open.pop_back();
    if (end - begin <= leaf) continue;
    const std::size_t middle = begin + std::bit_ceil(end - begin) / 2;
    Item* const first = items.data() + begin;
    Item* const last = items.data() + end;
    const std::size_t axis = longest_axis(first, last);
    std::nth_element(first, items.data() + middle, last, [axis](const Item& a, const Item& b) {
      if (a.middle[axis] != b.middle[axis]) return a.middle[axis] < b.middle[axis];
      return a.index < b.index;
    });
    open.emplace_back(begin, middle);
    open.emplace_back(middle, end);
  }
}

/// Middles as from one corner of all, so that a mesh far from the origin is distinguished as well.
std::vector<Item> items_of(const std::vector<Facet>& facets) {
  std::vector<Item> items(facets.size());
  if (items.empty()) return items;
  const Vector3 origin = facets[0][0];
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    const Bounds box = facet_bounds(facets[i]);
    const auto middle = [](double min, double max, double from) {
      return static_cast<float>((min / 2 + max / 2) - from);
    };
    items[i] = {{middle(box.min.x, box.max.x, origin.x), middle(box.min.y, box.max.y, origin.y),
                 middle(box.min.z, box.max.z, origin.z)},
                i};
  }
  return items;
}

}  // namespace

Vector3 closest_point(const Facet& f, const Vector3& p) {
  const Vector3 u = f[1] - f[0];
  const Vector3 v = f[2] - f[0];
  const Vector3 w = p - f[0];
  const Vector3 normal = cross(u, v);
  // What is left of each edge, as shares of the triangle's area: barycentric coordinates.
  const double area = dot(normal, normal);
  const double b = dot(cross(w, v), normal);
  const double c = dot(cross(u, w), normal);
  if (area > 0 && b >= 0 && c >= 0 && b + c <= area) {
    return along(along(f[0], b / area, u), c / area, v);
  }
  Vector3 best = closest_on_edge(f[0], f[1], p);
  for (std::size_t i = 1; i < 3; ++i) {
    const Vector3 other = closest_on_edge(f[i], f[(i + 1) % 3], p);
    if (squared_distance(other, p) < squared_distance(best, p)) best = other;
  }
  return best;
}

Bvh::Block::Block() {
  for (auto& side : min) side.fill(kFar);
  for (auto& side : max) side.fill(-kFar);
}

void Bvh::Block::set(std::uint32_t child, const Box& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    min[k][child] = box.min[k];
    max[k][child] = box.max[k];
  }
}

Bvh::Box Bvh::Block::at(std::uint32_t child) const {
  return {{min[0][child], min[1][child], min[2][child]},
          {max[0][child], max[1][child], max[2][child]}};
}

Bvh::Box Bvh::Block::all() const {
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.min[k] = *std::min_element(min[k].begin(), min[k].end());
    box.max[k] = *std::max_element(max[k].begin(), max[k].end());
  }
  return box;
}

std::array<double, Bvh::kWidth> Bvh::Block::squared_distances(const Vector3& p) const {
  const std::array<double, 3> at{p.x, p.y, p.z};
  std::array<double, kWidth> sum{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < kWidth; ++i) {
      const double out = std::max({double{min[k][i]} - at[k], at[k] - double{max[k][i]}, 0.0});
      sum[i] += out * out;
    }
  }
  return sum;
}

Bvh::Box Bvh::box_around(const Bounds& b) {
  return {{at_most(b.min.x), at_most(b.min.y), at_most(b.min.z)},
          {at_least(b.max.x), at_least(b.max.y), at_least(b.max.z)}};
}

Bvh::Bvh(const std::vector<Facet>& facets) { build(facets); }

Bvh::Bvh(const TriangleMesh& mesh) {
  std::vector<Facet> facets;
  std::vector<std::uint32_t> kept;
  facets.reserve(mesh.triangles.size());
  kept.reserve(mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    facets.push_back(mesh::facet(mesh, mesh.triangles[i]));
    const Facet& f = facets.back();
    if (std::all_of(f.begin(), f.end(), within_reach)) {
      kept.push_back(i);
    } else {
      facets.pop_back();
    }
  }
  build(facets);
  for (std::uint32_t& index : indices_) index = kept[index];
}

void Bvh::build(const std::vector<Facet>& facets) {
  std::vector<Item> items = items_of(facets);
  sort_by_halving(items, kWidth);
  facets_.reserve(items.size());
  indices_.reserve(items.size());
  for (const Item& item : items) {
    indices_.push_back(item.index);
    facets_.push_back(facets[item.index]);
  }
  stack_levels();
}

void Bvh::stack_levels() {
  level_begin_ = {0};
  blocks_.resize(leaves());
  for (std::uint32_t i = 0; i < size(); ++i) {
    blocks_[i / kWidth].set(i % kWidth, box_around(facet_bounds(facets_[i])));
  }
  for (std::size_t below = blocks_.size(); below > 1; below = (below + kWidth - 1) / kWidth) {
    const std::size_t begin = level_begin_.back();
    level_begin_.push_back(blocks_.size());
    blocks_.resize(blocks_.size() + (below + kWidth - 1) / kWidth);
    for (std::uint32_t i = 0; i < below; ++i) {
      blocks_[level_begin_.back() + i / kWidth].set(i % kWidth, blocks_[begin + i].all());
    }
  }
}

Nearest Bvh::nearest(const Vector3& p, std::uint32_t guess, double enough) const {
  Nearest best{guess, closest_point(facets_[guess], p), 0, 1};
  double least = squared_distance(best.at, p);
  const auto look_at = [&](std::uint32_t slot) {
    const Vector3 at = closest_point(facets_[slot], p);
    const double squared = squared_distance(at, p);
    if (std::tie(squared, indices_[slot]) >= std::tie(least, indices_[best.slot])) return;
    best.slot = slot;
    best.at = at;
    least = squared;
  };
  // A node here is one child: a triangle at level 0, else a block of the level below.
  struct Child {
    std::uint32_t level;
    std::uint32_t index;
    double squared;
  };
  Stack<Child> open;
  open.push({root().level + 1, 0, 0});
  while (!open.empty() && least > enough * enough) {
    const Child nearest = open.pop();
    ++best.looks;
    if (nearest.squared > least) continue;
    if (nearest.level == 0) {
      look_at(nearest.index);
      continue;
    }
    const Node node{nearest.level - 1, nearest.index};
    const std::array<double, kWidth> squared = block(node).squared_distances(p);
    std::array<std::uint32_t, kWidth> far_first{0, 1, 2, 3, 4, 5, 6, 7};
    std::sort(far_first.begin(), far_first.end(),
              [&](std::uint32_t a, std::uint32_t b) { return squared[a] > squared[b]; });
    for (const std::uint32_t i : far_first) {
      if (squared[i] <= least) open.push({node.level, node.block * kWidth + i, squared[i]});
    }
  }
  best.distance = std::sqrt(least);
  return best;
}

}  // namespace rigor::mesh
