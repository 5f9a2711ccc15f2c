// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/holes.h>

#include <array>
#include <optional>
#include <unordered_map>
#include <utility>

#include <rigor/mesh/topology/rings.h>

namespace rigor::mesh {
namespace {

/// An edge of one triangle, as the hole sees it: against the triangle's direction.
struct Rim {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t face;
};

class Walk {
 public:
  explicit Walk(const Workpiece& work) : work_(work), seen_(3 * std::size_t{work.size()}) {}

  std::vector<Hole> run() {
    for (std::uint32_t face = 0; face < work_.size(); ++face) {
      if (!work_.has(face) || degenerate(work_[face])) continue;
      const Triangle& t = work_[face];
      for (std::size_t i = 0; i < 3; ++i) {
        const Rim rim{t[(i + 1) % 3], t[i], face};
        if (!seen_[mark(rim)] && is_rim(rim)) follow(rim);
      }
    }
    return std::move(holes_);
  }

 private:
  std::size_t mark(const Rim& rim) const {
    const Triangle& t = work_[rim.face];
    const std::size_t i = t[0] == rim.to ? 0 : t[1] == rim.to ? 1 : 2;
    return 3 * std::size_t{rim.face} + i;
  }

  bool is_rim(const Rim& rim) const { return work_.faces_at(rim.from, rim.to).count == 1; }

  void follow(const Rim& first) {
    std::vector<Rim> loop;
    for (std::optional<Rim> rim = first; rim; rim = after(*rim)) {
      if (seen_[mark(*rim)]) {
        if (mark(*rim) == mark(first)) cut(loop);
        return;
      }
      seen_[mark(*rim)] = true;
      loop.push_back(*rim);
    }
  }

  std::optional<Rim> after(const Rim& rim) const {
    const std::optional<Rim> round = round_vertex(rim);
    return round ? round : only_one_at(rim.to);
  }

  /// From triangle to triangle across edges of two.
  std::optional<Rim> round_vertex(const Rim& rim) const {
    std::uint32_t face = rim.face;
    std::uint32_t edge = rim.from;  // the end of the last edge passed
    for (std::size_t steps = work_.faces_at(rim.to).size(); steps > 0; --steps) {
      edge = apex(work_[face], rim.to, edge);
      const EdgeFaces at = work_.faces_at(rim.to, edge);
      if (!runs(work_[face], edge, rim.to) || at.count > 2) return std::nullopt;
      if (at.count == 1) return Rim{rim.to, edge, face};
      face = at.faces[0] == face ? at.faces[1] : at.faces[0];
    }
    return std::nullopt;
  }

  /// Where the way round is barred, the only edge that leads on, if there is just one.
  std::optional<Rim> only_one_at(std::uint32_t vertex) const {
    std::optional<Rim> found;
    for (const std::uint32_t face : work_.faces_at(vertex)) {
      const Triangle& t = work_[face];
      const std::size_t i = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
      const Rim rim{vertex, t[(i + 2) % 3], face};
      if (!is_rim(rim)) continue;
      if (found) return std::nullopt;
      found = rim;
    }
    return found;
  }

  void cut(const std::vector<Rim>& loop) {
    std::unordered_map<std::uint32_t, std::size_t> position;  // of vertices in `path`
    std::vector<Rim> path;
    for (const Rim& rim : loop) {
      position[rim.from] = path.size();
      path.push_back(rim);
      const auto again = position.find(rim.to);
      if (again == position.end()) continue;
      const auto begin = path.begin() + static_cast<std::ptrdiff_t>(again->second);
      Hole hole;
      for (auto edge = begin; edge != path.end(); ++edge) {
        hole.vertices.push_back(edge->from);
        hole.faces.push_back(edge->face);
        position.erase(edge->from);
      }
      path.erase(begin, path.end());
      if (hole.vertices.size() > 2) holes_.push_back(std::move(hole));
    }
  }

  const Workpiece& work_;
  std::vector<bool> seen_;
  std::vector<Hole> holes_;
};

}  // namespace

std::vector<Hole> holes_of(const Workpiece& work) { return Walk(work).run(); }

}  // namespace rigor::mesh
