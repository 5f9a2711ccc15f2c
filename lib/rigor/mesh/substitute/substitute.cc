// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/substitute/substitute.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <variant>

#include <rigor/mesh/convex/hull.h>
#include <rigor/mesh/convex/pieces.h>
#include <rigor/mesh/reduce.h>
#include <rigor/mesh/select.h>
#include <rigor/mesh/spatial/distance.h>
#include <rigor/mesh/substitute/fitted.h>
#include <rigor/mesh/topology/topology.h>

namespace rigor::mesh {
namespace {

/// On each surface, its corners aside: at a hundredth of the mesh's size, well below any bound that is asked for.
constexpr std::size_t kSamples = 10'000;

/// More triangles are reduced, by a quarter of the bound, before they are cut into pieces.
constexpr std::size_t kMaxCut = 4000;

/// How many triangles of the mesh one is to stand for. A kind that comes first is taken only where it gets below the
/// first share that some kind reaches.
constexpr std::size_t kManyFewer[] = {5, 7, 10, 20, 50};
constexpr std::size_t kSomeFewer[] = {2, 3, 4};
constexpr std::size_t kAnyFewer[] = {1};

/// Moved corners may bring a reduced mesh so many times nearer, hardly more.
constexpr double kFitGain = 4;

/// Fewer triangles are few for any engine, and what has so few loses its shape with some more.
constexpr std::size_t kFewest = 8;

/// Of the error: a cylinder must be nearer by so much than a box or sphere, and a capsule than all, as a faceted ball is
/// a little nearer to a capsule.
constexpr double kNearer = 0.75;

/// Signed: the sum of the triangles' tetrahedra with one point.
double volume(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  const Vector3 o = mesh.positions[mesh.triangles.front()[0]];
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Facet f = facet(mesh, t);
    sum += dot(f[0] - o, cross(f[1] - o, f[2] - o));
  }
  return sum / 6;
}

using TriangleMeshes = std::vector<TriangleMesh>;

class SubstituteFinder {
 public:
  SubstituteFinder(const TriangleMesh& mesh, const SubstituteLimits& limits)
      : mesh_(mesh), limits_(limits), hull_(convex_hull(mesh.positions)) {}

  std::optional<Substitute> find() {
    if (!hull_ || !(limits_.max_error > 0)) return std::nullopt;
    own_volume_ = std::abs(volume(mesh_));
    is_open_ = !(own_volume_ > 0) || !topology_of(mesh_).closed();
    if (limits_.first == SubstituteKind::kPrimitive) try_primitives();
    for (const Shares shares : {Shares(kManyFewer), Shares(kSomeFewer), Shares(kAnyFewer)}) {
      if (!best_ && limits_.first <= SubstituteKind::kHull) try_hull(shares);
      if (!best_ && limits_.first <= SubstituteKind::kPieces) try_pieces(shares);
      if (shares.front() == 1) continue;
      if (!best_) try_reduced(shares, Surface::kSound);
      if (!best_) try_reduced(shares, Surface::kFlawed);
      if (!best_ && is_open_) try_reduced(shares, Surface::kLoose);
    }
    for (const Shares shares : {Shares(kManyFewer), Shares(kSomeFewer)}) {
      if (!best_ && !is_open_) try_reduced(shares, Surface::kLoose);
    }
    return std::move(best_);
  }

 private:
  using Shares = std::span<const std::size_t>;

  /// What a closed mesh becomes: closed, closed but for some edges, or triangles that only lie where it was.
  enum class Surface : std::uint8_t { kSound, kFlawed, kLoose };

  double error_of(const TriangleMesh& other) const {
    return deviation(mesh_, other, kSamples).hausdorff();
  }

  void take(SubstituteKind kind, std::vector<TriangleMesh> meshes, double error) {
    Substitute found;
    found.kind = kind;
    double sum = 0;
    for (const TriangleMesh& mesh : meshes) {
      found.triangles += mesh.triangles.size();
      sum += std::abs(volume(mesh));
    }
    found.meshes = std::move(meshes);
    finish(std::move(found), error, sum);
  }

  void finish(Substitute found, double error, double new_volume) {
    found.hausdorff = error;
    // What an open surface encloses is a number that only one much like it has too.
    found.of_hull = is_open_ && found.kind != SubstituteKind::kReduced;
    const double old_volume = found.of_hull ? volume(*hull_) : own_volume_;
    found.volume_error = old_volume > 0 ? (new_volume - old_volume) / old_volume : 0;
    best_ = std::move(found);
  }

  /// The one that is nearest, where one with more numbers must be so by much; around the mesh where one keeps within
  /// the bound, else through the middle of its surface.
  void try_primitives() {
    for (const FitKind kind :
         {FitKind::kBox, FitKind::kSphere, FitKind::kCylinder, FitKind::kCapsule}) {
      if (kind == FitKind::kCapsule && limits_.capsules == Capsules::kRefused) continue;
      auto fit = fit_primitive(mesh_, kind);
      if (!fit || fit->deepest > 2 * limits_.max_error) continue;
      try_primitive(*fit);
      if (fit->deepest <= limits_.max_error) continue;
      fit->shape = shrunk(fit->shape, fit->deepest / 2);
      fit->volume = std::abs(volume(mesh_of(fit->shape)));
      try_primitive(*fit);
    }
  }

  void try_primitive(const Fit& fit) {
    TriangleMesh drawn = mesh_of(fit.shape);
    for (Vector3& p : drawn.positions) p = model::transform(fit.pose, p);
    const double error = error_of(drawn);
    if (error > limits_.max_error || (best_ && error > kNearer * best_->hausdorff)) return;
    Substitute found;
    found.kind = SubstituteKind::kPrimitive;
    found.primitive = fit;
    finish(std::move(found), error, fit.volume);
  }

  /// By so much on each side.
  static Primitive shrunk(Primitive shape, double by) {
    struct Shrinker {
      double by;
      double less(double size) const { return std::max(size - 2 * by, size / 2); }
      void operator()(Box& s) const { s.size = {less(s.size.x), less(s.size.y), less(s.size.z)}; }
      void operator()(Sphere& s) const { s.radius = less(2 * s.radius) / 2; }
      void operator()(Cylinder& s) const {
        s.radius = less(2 * s.radius) / 2;
        s.length = less(s.length);
      }
      void operator()(Capsule& s) const { s.radius = less(2 * s.radius) / 2; }
    };
    std::visit(Shrinker{by}, shape);
    return shape;
  }

  /// Time is better spent on fewer triangles then.
  double near_enough() const { return limits_.max_error / 2; }

  void try_hull(Shares shares) {
    if (!hull_error_) hull_error_ = error_of(*hull_);
    if (*hull_error_ > limits_.max_error) return;
    // Most corners of the hull of a rounded part are not needed.
    take_fewest(SubstituteKind::kHull, shares, [this](std::size_t triangles) -> TriangleMeshes {
      if (triangles >= hull_->triangles.size()) return {*hull_};
      auto fewer = reduced_hull(*hull_, triangles);
      return fewer ? TriangleMeshes{*std::move(fewer)} : TriangleMeshes{};
    });
  }

  std::optional<TriangleMesh> reduced_hull(const TriangleMesh& hull, std::size_t triangles) const {
    const auto fewer =
        convex_hull(reduce(hull, {.triangles = triangles, .seams = Seams::kIgnore}).mesh.positions);
    return fewer ? convex_hull(fitted(*fewer, hull, near_enough()).positions) : std::nullopt;
  }

  void try_pieces(Shares shares) {
    const std::vector<TriangleMesh>& pieces = find_pieces();
    if (pieces.size() < 2) return;
    std::size_t all = 0;
    for (const TriangleMesh& piece : pieces) all += piece.triangles.size();
    take_fewest(SubstituteKind::kPieces, shares, [&](std::size_t triangles) {
      TriangleMeshes fewer = pieces;
      if (triangles >= all) return fewer;
      for (TriangleMesh& piece : fewer) {
        const std::size_t target = std::max(kFewest, piece.triangles.size() * triangles / all);
        if (target >= piece.triangles.size()) continue;
        if (auto hull = reduced_hull(piece, target)) piece = *std::move(hull);
      }
      return fewer;
    });
  }

  /// None where their whole is too far off.
  const std::vector<TriangleMesh>& find_pieces() {
    if (pieces_) return *pieces_;
    pieces_.emplace();
    const TriangleMesh* source = &mesh_;
    Reduced reduced;
    if (mesh_.triangles.size() > kMaxCut) {
      reduced = reduce(mesh_, {.triangles = kMaxCut, .max_error = limits_.max_error / 4});
      source = &reduced.mesh;
    }
    if (source->triangles.size() > 2 * kMaxCut) return *pieces_;
    Pieces found = convex_pieces(*source, {.count = std::min(limits_.pieces, kMaxPieces)});
    if (surface_error(found.hulls) <= limits_.max_error) pieces_ = std::move(found.hulls);
    return *pieces_;
  }

  /// Of what convex pieces fill together, or of one mesh.
  double surface_error(const TriangleMeshes& meshes) const {
    if (meshes.size() == 1) return error_of(meshes.front());
    const double step = std::max(2 * limits_.max_error, diagonal(bounds_of(mesh_.positions)) / 100);
    return error_of(outer_skin(meshes, step));
  }

  void try_reduced(Shares shares, Surface wanted) {
    take_fewest(SubstituteKind::kReduced, shares, [&](std::size_t triangles) -> TriangleMeshes {
      TriangleMesh fewer = reduced_to(triangles, wanted);
      if (fewer.triangles.empty() || error_of(fewer) > kFitGain * limits_.max_error) return {};
      return {fitted(std::move(fewer), mesh_, near_enough())};
    });
  }

  /// Empty where it is not as it is wanted.
  TriangleMesh reduced_to(std::size_t triangles, Surface wanted) const {
    constexpr std::size_t kBetween = 4;  // of a grid that is finer, edges are collapsed then
    const Reduction to{.triangles = triangles, .seams = Seams::kIgnore};
    if (wanted == Surface::kLoose)
      return reduce(reduced_loosely(mesh_, kBetween * triangles), to).mesh;
    Reduced fewer = reduce(mesh_, to);
    const bool is_sound = is_open_ || !fewer.flaws.any();
    return is_sound == (wanted == Surface::kSound) ? std::move(fewer.mesh) : TriangleMesh{};
  }

  /// What is made with as few triangles as the bound allows: of the shares the last that keeps within it.
  template <class Make>
  void take_fewest(SubstituteKind kind, Shares shares, const Make& make) {
    std::size_t least = mesh_.triangles.size();
    for (const std::size_t share : shares) {
      const std::size_t target = std::max(kFewest, mesh_.triangles.size() / share);
      TriangleMeshes made = make(target);
      std::size_t triangles = 0;
      for (const TriangleMesh& each : made) triangles += each.triangles.size();
      // A mesh of three fewer is not worth another file.
      if (triangles == 0 || triangles >= least ||
          share * triangles > mesh_.triangles.size() + share)
        return;
      const double error = surface_error(made);
      if (error > limits_.max_error) return;
      least = triangles;
      take(kind, std::move(made), error);
    }
  }

  const TriangleMesh& mesh_;
  const SubstituteLimits& limits_;
  std::optional<TriangleMesh> hull_;
  std::optional<double> hull_error_;
  std::optional<TriangleMeshes> pieces_;
  bool is_open_ = false;
  double own_volume_ = 0;
  std::optional<Substitute> best_;
};

}  // namespace

std::optional<Substitute> find_substitute(const TriangleMesh& mesh,
                                          const SubstituteLimits& limits) {
  return SubstituteFinder(mesh, limits).find();
}

}  // namespace rigor::mesh
