// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/substitute/substitute.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <rigor/mesh/convex/hull.h>
#include <rigor/mesh/convex/pieces.h>
#include <rigor/mesh/reduce.h>
#include <rigor/mesh/select.h>
#include <rigor/mesh/spatial/distance.h>
#include <rigor/mesh/topology/topology.h>

namespace rigor::mesh {
namespace {

/// On each surface, its corners aside: at a hundredth of the mesh's size, well below any bound that is asked for.
constexpr std::size_t kSamples = 10'000;

/// More triangles are reduced, by a quarter of the bound, before they are cut into pieces.
constexpr std::size_t kMaxCut = 4000;

/// How many triangles of the mesh one is to stand for, the most first.
constexpr std::size_t kShares[] = {50, 20, 10, 5, 3, 2};

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

class SubstituteFinder {
 public:
  SubstituteFinder(const TriangleMesh& mesh, const SubstituteLimits& limits)
      : mesh_(mesh), limits_(limits), hull_(convex_hull(mesh.positions)) {}

  std::optional<Substitute> find() {
    if (!hull_ || !(limits_.max_error > 0)) return std::nullopt;
    own_volume_ = std::abs(volume(mesh_));
    is_open_ = !(own_volume_ > 0) || !topology_of(mesh_).closed();
    using Try = void (SubstituteFinder::*)();
    constexpr std::pair<SubstituteKind, Try> kTries[] = {
        {SubstituteKind::kPrimitive, &SubstituteFinder::try_primitives},
        {SubstituteKind::kHull, &SubstituteFinder::try_hull},
        {SubstituteKind::kPieces, &SubstituteFinder::try_pieces},
        {SubstituteKind::kReduced, &SubstituteFinder::try_reduced}};
    for (const auto& [kind, attempt] : kTries) {
      if (kind < limits_.first) continue;
      (this->*attempt)();
      if (best_) return std::move(best_);
    }
    return std::nullopt;
  }

 private:
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

  /// The one that is nearest, where one with more numbers must be so by much.
  void try_primitives() {
    for (const FitKind kind :
         {FitKind::kBox, FitKind::kSphere, FitKind::kCylinder, FitKind::kCapsule}) {
      if (kind == FitKind::kCapsule && limits_.capsules == Capsules::kRefused) continue;
      auto fit = fit_primitive(mesh_, kind);
      if (!fit || fit->deepest > limits_.max_error) continue;
      TriangleMesh drawn = mesh_of(fit->shape);
      for (Vector3& p : drawn.positions) p = model::transform(fit->pose, p);
      const double error = error_of(drawn);
      if (error > limits_.max_error || (best_ && error > kNearer * best_->hausdorff)) continue;
      Substitute found;
      found.kind = SubstituteKind::kPrimitive;
      const double fitted = fit->volume;
      found.primitive = std::move(fit);
      finish(std::move(found), error, fitted);
    }
  }

  void try_hull() {
    const double error = error_of(*hull_);
    if (error > limits_.max_error) return;
    // Most corners of the hull of a rounded part are not needed.
    const auto hull_of = [](Reduced fewer) { return convex_hull(fewer.mesh.positions); };
    if (take_fewest(SubstituteKind::kHull, *hull_, hull_of)) return;
    if (hull_->triangles.size() < mesh_.triangles.size())
      take(SubstituteKind::kHull, {*hull_}, error);
  }

  void try_pieces() {
    const TriangleMesh* source = &mesh_;
    Reduced reduced;
    if (mesh_.triangles.size() > kMaxCut) {
      reduced = reduce(mesh_, {.triangles = kMaxCut, .max_error = limits_.max_error / 4});
      source = &reduced.mesh;
    }
    if (source->triangles.size() > 2 * kMaxCut) return;
    Pieces pieces = convex_pieces(*source, {.count = std::min(limits_.pieces, kMaxPieces)});
    if (pieces.hulls.size() < 2) return;
    std::size_t triangles = 0;
    for (const TriangleMesh& piece : pieces.hulls) triangles += piece.triangles.size();
    if (triangles >= mesh_.triangles.size()) return;
    const double step = std::max(2 * limits_.max_error, diagonal(bounds_of(mesh_.positions)) / 100);
    const double error = error_of(outer_skin(pieces.hulls, step));
    if (error <= limits_.max_error) take(SubstituteKind::kPieces, std::move(pieces.hulls), error);
  }

  void try_reduced() {
    take_fewest(SubstituteKind::kReduced, mesh_, [this](Reduced fewer) {
      const bool good = !fewer.mesh.triangles.empty() && (is_open_ || !fewer.flaws.any());
      return good ? std::optional(std::move(fewer.mesh)) : std::nullopt;
    });
  }

  /// What is made of the source with as few triangles as the bound allows.
  template <class Make>
  bool take_fewest(SubstituteKind kind, const TriangleMesh& source, const Make& make) {
    constexpr std::size_t kFewest = 8;
    for (const std::size_t share : kShares) {
      const std::size_t target = std::max(kFewest, mesh_.triangles.size() / share);
      if (target >= source.triangles.size()) continue;
      auto made = make(reduce(source, {.triangles = target, .seams = Seams::kIgnore}));
      if (!made || 2 * made->triangles.size() > mesh_.triangles.size()) continue;
      const double error = error_of(*made);
      if (error > limits_.max_error) continue;
      take(kind, {*std::move(made)}, error);
      return true;
    }
    return false;
  }

  const TriangleMesh& mesh_;
  const SubstituteLimits& limits_;
  std::optional<TriangleMesh> hull_;
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
