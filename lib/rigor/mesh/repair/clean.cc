// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/repair/clean.h>

#include <algorithm>
#include <array>
#include <utility>

#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/topology/thinness.h>

namespace rigor::mesh {
namespace {

// Lines on lines are taken away from the outside in, each round a layer; each flip shortens an edge.
constexpr int kMaxCleanRounds = 64;

Triangle sorted_corners(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

bool is_line(const Workpiece& work, const Triangle& t) {
  return !degenerate(t) &&
         thinness({work.at(t[0]), work.at(t[1]), work.at(t[2])}) == Thinness::kLine;
}

bool is_line(const Workpiece& work, std::uint32_t face) {
  return work.has(face) && is_line(work, work[face]);
}

double span(const Workpiece& work, std::uint32_t a, std::uint32_t b) {
  return length(work.at(a) - work.at(b));
}

/// Triangles that have the same corners as others, in groups of such, each in order.
std::vector<std::vector<std::uint32_t>> copies(const Workpiece& work) {
  std::vector<std::pair<Triangle, std::uint32_t>> all;
  for (std::uint32_t face = 0; face < work.size(); ++face) {
    if (work.has(face) && !degenerate(work[face]))
      all.push_back({sorted_corners(work[face]), face});
  }
  std::sort(all.begin(), all.end());
  std::vector<std::vector<std::uint32_t>> groups;
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    while (end < all.size() && all[end].first == all[begin].first) ++end;
    if (end - begin < 2) continue;
    groups.emplace_back();
    for (std::size_t i = begin; i < end; ++i) groups.back().push_back(all[i].second);
  }
  return groups;
}

bool face_each_other(const Workpiece& work, const std::vector<std::uint32_t>& group) {
  const Triangle& t = work[group[0]];
  return group.size() == 2 && !runs(work[group[1]], t[0], t[1]);
}

/// Walls: pairs of copies that face each other, joined across edges that no other triangle has, when
/// two others meet at every edge of the rim.
class Walls {
 public:
  explicit Walls(Workpiece& work) : work_(work), twin_(work.size(), kNone), taken_(work.size()) {}

  std::uint64_t drop() {
    const std::vector<std::vector<std::uint32_t>> groups = copies(work_);
    for (const auto& group : groups) {
      if (!face_each_other(work_, group)) continue;
      twin_[group[0]] = group[1];
      twin_[group[1]] = group[0];
    }
    std::uint64_t dropped = 0;
    for (const auto& group : groups) {
      if (twin_[group[0]] == kNone || taken_[group[0]]) continue;
      const std::vector<std::uint32_t> wall = wall_of(group[0]);
      if (wall.empty() || work_.tired()) continue;
      const bool gone = work_.attempt([&] {
        for (const std::uint32_t face : wall) work_.remove(face);
      });
      dropped += gone ? wall.size() : 0;
    }
    return dropped;
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  /// Takes its pairs as it goes. Empty when there is no rim, or nothing holds on to it.
  std::vector<std::uint32_t> wall_of(std::uint32_t first) {
    std::vector<std::uint32_t> wall;
    bool has_rim = false;
    bool held = true;
    std::vector<std::uint32_t> open = {first};
    while (!open.empty()) {
      const std::uint32_t face = open.back();
      open.pop_back();
      if (taken_[face]) continue;
      wall.insert(wall.end(), {face, twin_[face]});
      taken_[face] = true;
      taken_[twin_[face]] = true;
      const Triangle& t = work_[face];
      for (const auto& [i, k] : kSides) {
        std::size_t others = 0;
        std::size_t pairs = 0;
        for (const std::uint32_t other : work_.faces_at(t[i])) {
          if (apex(work_[other], t[i], t[k]) == apex(t, t[i], t[k])) continue;
          if (!runs(work_[other], t[i], t[k]) && !runs(work_[other], t[k], t[i])) continue;
          ++others;
          if (twin_[other] == kNone) continue;
          ++pairs;
          open.push_back(other);
        }
        if (pairs == others && others > 0) continue;
        has_rim = true;
        held = held && others == 2 && pairs == 0;
      }
    }
    return has_rim && held ? wall : std::vector<std::uint32_t>{};
  }

  Workpiece& work_;
  std::vector<std::uint32_t> twin_;  // of each triangle, the other of its pair
  std::vector<bool> taken_;          // into a wall
};

std::uint64_t drop_all_but_one(Workpiece& work) {
  std::uint64_t dropped = 0;
  for (const std::vector<std::uint32_t>& group : copies(work)) {
    std::size_t left = group.size();
    for (auto face = group.rbegin(); face != group.rend() && left > 1 && !work.tired(); ++face) {
      if (work.attempt([&] { work.remove(*face); })) --left;
    }
    dropped += group.size() - left;
  }
  return dropped;
}

/// Turns the triangle so that its longest edge is from its first corner to its second.
Triangle longest_first(const Workpiece& work, const Triangle& t) {
  const std::array<double, 3> spans{span(work, t[0], t[1]), span(work, t[1], t[2]),
                                    span(work, t[2], t[0])};
  const auto at =
      static_cast<std::size_t>(std::max_element(spans.begin(), spans.end()) - spans.begin());
  return {t[at], t[(at + 1) % 3], t[(at + 2) % 3]};
}

/// Splits `neighbor`, at the line's edge from x to y, at the line's third corner z.
bool flip(Workpiece& work, std::uint32_t line, std::uint32_t neighbor) {
  const auto [x, y, z] = longest_first(work, work[line]);
  const Triangle n = work[neighbor];
  const std::uint32_t d = apex(n, x, y);
  if (d == z) {  // its copy
    return work.attempt([&] {
      work.remove(line);
      work.remove(neighbor);
    });
  }
  const bool against = runs(n, y, x);
  const Triangle one = against ? Triangle{y, z, d} : Triangle{x, z, d};
  const Triangle two = against ? Triangle{z, x, d} : Triangle{z, y, d};
  const int before = 1 + (is_line(work, n) ? 1 : 0);
  const int after = (is_line(work, one) ? 1 : 0) + (is_line(work, two) ? 1 : 0);
  // Where there are as many lines after it, at least the edge must be shorter: so there is an end.
  if (after > before || (after == before && span(work, z, d) >= span(work, x, y))) return false;
  return work.attempt([&] {
    work.remove(line);
    work.remove(neighbor);
    work.add_piece(one, neighbor);
    work.add_piece(two, neighbor);
  });
}

bool drop_line(Workpiece& work, std::uint32_t line) {
  const Triangle t = longest_first(work, work[line]);
  const EdgeFaces beside = work.faces_at(t[0], t[1]);
  if (beside.count == 2) {
    return flip(work, line, beside.faces[0] == line ? beside.faces[1] : beside.faces[0]);
  }
  return work.attempt([&] { work.remove(line); });
}

}  // namespace

std::uint64_t drop_degenerate(Workpiece& work) {
  std::uint64_t dropped = 0;
  for (std::uint32_t face = 0; face < work.size(); ++face) {
    if (!work.has(face) || !degenerate(work[face])) continue;
    work.remove(face);
    ++dropped;
  }
  return dropped;
}

std::uint64_t drop_duplicates(Workpiece& work) {
  const std::uint64_t walls = Walls(work).drop();
  return walls + drop_all_but_one(work);
}

std::uint64_t drop_lines(Workpiece& work) {
  std::vector<std::uint32_t> faces;
  for (std::uint32_t face = 0; face < work.size(); ++face) {
    if (is_line(work, face)) faces.push_back(face);
  }
  return drop_lines(work, std::move(faces));
}

std::uint64_t drop_lines(Workpiece& work, std::vector<std::uint32_t> faces) {
  const std::uint64_t before = work.defects().zero_area;
  for (int round = 0; round < kMaxCleanRounds && !faces.empty(); ++round) {
    std::vector<std::uint32_t> left;
    bool changed = false;
    for (const std::uint32_t face : faces) {
      if (!is_line(work, face) || work.tired()) continue;
      const std::uint32_t end = work.size();
      const bool dropped = drop_line(work, face);
      changed = changed || dropped;
      if (!dropped) left.push_back(face);
      for (std::uint32_t added = end; added < work.size(); ++added) {
        if (is_line(work, added)) left.push_back(added);
      }
    }
    if (!changed) break;
    faces = std::move(left);
  }
  return before - work.defects().zero_area;
}

}  // namespace rigor::mesh
