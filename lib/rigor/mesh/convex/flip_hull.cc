// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/convex/flip_hull.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <rigor/mesh/spatial/predicate.h>
#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/topology/weld.h>

namespace rigor::mesh {
namespace {

constexpr std::uint32_t kNoFace = std::numeric_limits<std::uint32_t>::max();

// Work per triangle before the hull is made in another way. A ball with rounded coordinates takes
// less than one flip, a box of grids about three; vertices have six edges in the mean, so only one
// with very many takes more steps.
constexpr std::uint64_t kMaxFlips = 8;
constexpr std::uint64_t kMaxSteps = 64;

struct HullFace {
  Triangle corners;                     ///< places; all the same when it is no more
  std::array<std::uint32_t, 3> across;  ///< the face beyond the edge from corner i to the next
};

constexpr std::size_t corner_after(std::size_t i) { return i == 2 ? 0 : i + 1; }

class FlipHull {
 public:
  explicit FlipHull(const TriangleMesh& mesh) : mesh_(mesh), welded_(weld(mesh.positions)) {}

  std::optional<TriangleMesh> run() {
    if (!take_faces() || !seen_once() || !find_neighbors() || !flip()) return std::nullopt;
    TriangleMesh hull{.positions = mesh_.positions};
    for (const HullFace& face : faces_) {
      if (!degenerate(face.corners)) hull.triangles.push_back(as_positions(face.corners));
    }
    return hull;
  }

 private:
  // ---- The surface

  bool take_faces() {
    if (mesh_.triangles.size() >= kNoFace / 3) return false;
    if (!std::all_of(mesh_.positions.begin(), mesh_.positions.end(),
                     [](const Vector3& p) { return exactly_seen(p); })) {
      return false;
    }
    Vector3 sum;
    for (const Triangle& t : mesh_.triangles) {
      const Triangle places = places_of(welded_, t);
      if (degenerate(places)) continue;
      faces_.push_back({places, {kNoFace, kNoFace, kNoFace}});
      for (const std::uint32_t place : places) sum = sum + at(place);
    }
    if (faces_.empty()) return false;
    inside_ = 1 / (3 * static_cast<double>(faces_.size())) * sum;
    return exactly_seen(inside_);
  }

  /// From inside all triangles show their backs, and cover each direction once: their solid angles
  /// (A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30, 1983) add up to that of a sphere,
  /// where a second layer would add as much again.
  bool seen_once() const {
    double angle = 0;
    for (const HullFace& face : faces_) {
      if (!faces_outward(face.corners)) return false;
      const Vector3 a = at(face.corners[0]) - inside_;
      const Vector3 b = at(face.corners[1]) - inside_;
      const Vector3 c = at(face.corners[2]) - inside_;
      const double la = length(a);
      const double lb = length(b);
      const double lc = length(c);
      angle += 2 * std::atan2(dot(a, cross(b, c)),
                              la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return std::abs(angle / (4 * std::numbers::pi) - 1) < 0.25;
  }

  /// Whether each edge has two triangles, which run along it in opposite directions.
  bool find_neighbors() {
    std::vector<std::uint32_t> first(welded_.places(), kNoFace);  // half-edge, by its begin
    std::vector<std::uint32_t> next(3 * faces_.size());
    for (std::uint32_t h = 0; h < next.size(); ++h) {
      next[h] = std::exchange(first[faces_[h / 3].corners[h % 3]], h);
    }
    std::uint64_t steps = kMaxSteps * faces_.size();
    for (std::uint32_t h = 0; h < next.size(); ++h) {
      const Triangle& corners = faces_[h / 3].corners;
      const std::uint32_t begin = corners[h % 3];
      for (std::uint32_t g = first[corners[corner_after(h % 3)]]; g != kNoFace; g = next[g]) {
        if (steps-- == 0) return false;
        if (faces_[g / 3].corners[corner_after(g % 3)] != begin) continue;
        std::uint32_t& across = faces_[h / 3].across[h % 3];
        if (across != kNoFace) return false;
        across = g / 3;
      }
      if (faces_[h / 3].across[h % 3] == kNoFace) return false;
    }
    return true;
  }

  // ---- Mending

  /// An edge as the face on its left and its number there.
  struct Edge {
    std::uint32_t face;
    std::size_t i;
  };

  bool flip() {
    std::vector<Edge> open = inward_edges();
    std::uint64_t left = kMaxFlips * faces_.size();
    while (!open.empty()) {
      const Edge edge = open.back();
      open.pop_back();
      if (degenerate(faces_[edge.face].corners) || !bends_inward(edge)) continue;
      if (left-- == 0) return false;
      // Else it waits until something beside it is mended, which opens it once more.
      if (!turn_over(edge, open) && !leave_out(edge, open)) leave_out(twin(edge), open);
    }
    return inward_edges().empty();
  }

  std::vector<Edge> inward_edges() const {
    std::vector<Edge> edges;
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      if (degenerate(faces_[f].corners)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        if (f < faces_[f].across[i] && bends_inward({f, i})) edges.push_back({f, i});
      }
    }
    return edges;
  }

  /// Whether the corner beyond the edge is above the triangle.
  bool bends_inward(const Edge& edge) const {
    const Triangle& t = faces_[edge.face].corners;
    return side(at(t[0]), at(t[1]), at(t[2]), at(opposite(twin(edge)))) > 0;
  }

  /// The triangles abc and bad become cad and dbc, when both face outward.
  bool turn_over(const Edge& edge, std::vector<Edge>& open) {
    const Edge back = twin(edge);
    const auto [a, b, c, d] = around(edge);
    if (!faces_outward({c, a, d}) || !faces_outward({d, b, c})) return false;
    const std::uint32_t f = edge.face;
    const std::uint32_t g = back.face;
    const auto [bc, ca] = others(edge);
    const auto [ad, db] = others(back);
    faces_[f] = {{c, a, d}, {ca, ad, g}};
    faces_[g] = {{d, b, c}, {db, bc, f}};
    replace_neighbor(ad, g, f, d, a);
    replace_neighbor(bc, f, g, c, b);
    for (const std::size_t i : {0U, 1U}) {
      open.push_back({f, i});
      open.push_back({g, i});
    }
    return true;
  }

  /// A vertex a with only the neighbors b, c and d, under the triangle bcd, which takes its place.
  bool leave_out(const Edge& edge, std::vector<Edge>& open) {
    const Edge back = twin(edge);
    const auto [a, b, c, d] = around(edge);
    const auto [bc, third] = others(edge);
    const auto [other_third, db] = others(back);
    if (third != other_third || third == bc || side(at(b), at(c), at(d), at(a)) >= 0) return false;
    std::size_t i = 0;
    while (i < 3 && faces_[third].corners[i] != c) ++i;
    if (i == 3 || faces_[third].corners[corner_after(i)] != d) return false;
    const std::uint32_t f = edge.face;
    const std::uint32_t cd = faces_[third].across[i];
    faces_[f] = {{b, c, d}, {bc, cd, db}};
    replace_neighbor(cd, third, f, d, c);
    replace_neighbor(db, back.face, f, b, d);
    faces_[third].corners = faces_[back.face].corners = {};
    for (const std::size_t edge_of_f : {0U, 1U, 2U}) open.push_back({f, edge_of_f});
    return true;
  }

  // ---- Round an edge

  Edge twin(const Edge& edge) const {
    const HullFace& face = faces_[edge.face];
    const std::uint32_t beyond = face.across[edge.i];
    const std::uint32_t end = face.corners[corner_after(edge.i)];
    const Triangle& t = faces_[beyond].corners;
    return {beyond, t[0] == end ? std::size_t{0} : t[1] == end ? std::size_t{1} : std::size_t{2}};
  }

  std::uint32_t opposite(const Edge& edge) const {
    return faces_[edge.face].corners[corner_after(corner_after(edge.i))];
  }

  /// Begin, end, and the corners on the left and right.
  std::array<std::uint32_t, 4> around(const Edge& edge) const {
    const Triangle& t = faces_[edge.face].corners;
    return {t[edge.i], t[corner_after(edge.i)], opposite(edge), opposite(twin(edge))};
  }

  /// The faces beyond the other two edges, from the one that follows.
  std::array<std::uint32_t, 2> others(const Edge& edge) const {
    const HullFace& face = faces_[edge.face];
    return {face.across[corner_after(edge.i)], face.across[corner_after(corner_after(edge.i))]};
  }

  /// Of `face`, beyond its edge from `begin` to `end`.
  void replace_neighbor(std::uint32_t face, std::uint32_t was, std::uint32_t is,
                        std::uint32_t begin, std::uint32_t end) {
    for (std::size_t i = 0; i < 3; ++i) {
      HullFace& f = faces_[face];
      if (f.across[i] == was && f.corners[i] == begin && f.corners[corner_after(i)] == end) {
        f.across[i] = is;
      }
    }
  }

  bool faces_outward(const Triangle& t) const {
    return side(at(t[0]), at(t[1]), at(t[2]), inside_) < 0;
  }

  const Vector3& at(std::uint32_t place) const { return mesh_.positions[welded_.first[place]]; }

  Triangle as_positions(const Triangle& t) const {
    return {welded_.first[t[0]], welded_.first[t[1]], welded_.first[t[2]]};
  }

  const TriangleMesh& mesh_;
  Weld welded_;
  std::vector<HullFace> faces_;
  Vector3 inside_;
};

}  // namespace

std::optional<TriangleMesh> flip_hull(const TriangleMesh& mesh) { return FlipHull(mesh).run(); }

}  // namespace rigor::mesh
