// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/mesh_operations.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include <rigor/mass/polyhedron.h>
#include <rigor/mesh/convex/hull.h>
#include <rigor/mesh/convex/pieces.h>
#include <rigor/mesh/normals.h>
#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/reduce.h>
#include <rigor/mesh/repair/repair.h>
#include <rigor/mesh/select.h>
#include <rigor/mesh/spatial/distance.h>
#include <rigor/mesh/split.h>
#include <rigor/mesh/topology/topology.h>
#include <rigor/write/safe_name.h>

namespace rigor::author {
namespace {

using mesh::TriangleMesh;

// Points of each surface from which the distance to the other is measured, its vertices aside.
constexpr std::size_t kSamples = 100'000;

std::string triangles_text(std::uint64_t before, std::uint64_t after) {
  return fmt::format("{} triangles, {} before", after, before);
}

std::string_view noun_of(mesh::RepairStep step) {
  using mesh::RepairStep;
  switch (step) {
    case RepairStep::kWeld:
    case RepairStep::kCloseSeams: return "vertices";
    case RepairStep::kFillHoles: return "holes";
    case RepairStep::kFaceOutward:
    case RepairStep::kDropSpecks: return "components";
    default: return "triangles";
  }
}

/// "drop duplicates: 12 triangles".
std::string changed_text(const mesh::StepDone& step) {
  std::string_view noun = noun_of(step.step);
  if (step.changed == 1) noun = noun == "vertices" ? "vertex" : noun.substr(0, noun.size() - 1);
  return fmt::format("{} {}", step.changed, noun);
}

/// What a repaired mesh is, and why it is not sound.
std::string outcome(const mesh::RepairReport& report) {
  const mesh::Topology& now = report.after;
  const auto some = [](std::uint64_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
  };
  std::string what = now.closed() ? "closed" : "";
  const auto add = [&what](const std::string& flaw) { what += (what.empty() ? "" : ", ") + flaw; };
  if (now.boundary_edges > 0) add("open at " + some(now.boundary_edges, "edge"));
  if (now.nonmanifold_edges > 0) {
    add(some(now.nonmanifold_edges, "edge") + " of more than two triangles");
  }
  if (now.inconsistent_edges > 0) {
    add(some(now.inconsistent_edges, "edge") + " between triangles that face opposite ways");
  }
  if (report.holes.too_large > 0) {
    add(some(report.holes.too_large, "hole") + " too large to fill without guessing");
  }
  if (report.holes.left > 0) add(some(report.holes.left, "hole") + " that cannot be filled");
  return what;
}

class Operation {
 public:
  explicit Operation(const MeshOperations& asked) : asked_(asked) {}

  OperatedMesh run(TriangleMesh mesh) && {
    mesh = mended(std::move(mesh));
    mesh = moved(std::move(mesh));
    if (asked_.crease) {
      mesh = mesh::recomputed_normals(std::move(mesh), *asked_.crease);
      step("normals", *asked_.crease > 0 ? "smooth, computed anew" : "flat");
    }
    mesh = reduced(std::move(mesh));
    if (mesh.triangles.empty()) {
      done_.problem = "no triangle is left of it";
    } else {
      make_product(std::move(mesh));
    }
    return std::move(done_);
  }

 private:
  void step(std::string name, std::string what) {
    done_.steps.push_back({std::move(name), std::move(what)});
  }

  TriangleMesh mended(TriangleMesh mesh) {
    if (asked_.repair) {
      mesh::Repaired repaired = mesh::repair(std::move(mesh), {});
      for (const mesh::StepDone& one : repaired.report.steps) {
        if (one.changed == 0) continue;
        step(std::string(mesh::to_string(one.step)),
             one.undone ? "undone, as something would get worse" : changed_text(one));
      }
      step("repaired", outcome(repaired.report));
      return std::move(repaired.mesh);
    }
    if (asked_.weld) {
      const std::size_t before = mesh.positions.size();
      mesh::compact(mesh);
      step("weld", fmt::format("{} vertices, {} before", mesh.positions.size(), before));
    }
    return mesh;
  }

  TriangleMesh moved(TriangleMesh mesh) {
    mesh::Transform& by = done_.transform;
    by = {.unit = asked_.unit, .scale = asked_.scale, .up = asked_.up};
    switch (asked_.center) {
      case MeshCenter::kNone: break;
      case MeshCenter::kBounds: by.center = mesh::Center::kBounds; break;
      case MeshCenter::kBottom: by.center = mesh::Center::kBottom; break;
      case MeshCenter::kCom: by.center = mesh::Center::kPoint; by.point = center_of_mass(mesh);
    }
    mesh::Transformed result = mesh::transformed(std::move(mesh), by);
    done_.translation = result.translation;
    const auto vector = [](const model::Vector3& v) {
      return fmt::format("{:.9g} {:.9g} {:.9g}", v.x, v.y, v.z);
    };
    if (by.unit != 1) step("unit", fmt::format("coordinates by {:.9g}", by.unit));
    if (by.scale != model::Vector3{1, 1, 1}) step("scale", vector(by.scale));
    if (by.up != mesh::UpAxis::kZ) step("up axis", "y turned to z");
    if (by.center != mesh::Center::kNone) step("center", "moved by " + vector(result.translation));
    return std::move(result.mesh);
  }

  /// Of an open mesh what it encloses is not known: its hull replaces it.
  model::Vector3 center_of_mass(const TriangleMesh& mesh) {
    const mass::PolyhedronMoments own = mass::moments_of(mesh);
    if (own.volume != 0 && mesh::topology_of(mesh).closed()) return mass::centroid(own);
    if (const auto hull = mesh::convex_hull(mesh.positions)) {
      step("center of mass", "of the convex hull, as the mesh is no solid");
      return mass::centroid(mass::moments_of(*hull));
    }
    step("center of mass", "the middle of the bounds, as the mesh encloses nothing");
    const mesh::Bounds bounds = mesh::bounds_of(mesh.positions);
    return 0.5 * bounds.min + 0.5 * bounds.max;
  }

  TriangleMesh reduced(TriangleMesh mesh) {
    const std::uint64_t before = mesh.triangles.size();
    std::uint64_t target = asked_.triangles.value_or(before);
    if (asked_.share) {
      target =
          static_cast<std::uint64_t>(std::llround(*asked_.share * static_cast<double>(before)));
    }
    if (target >= before) return mesh;
    using mesh::Seams;
    mesh::Reduction to{.triangles = target,
                       .seams = asked_.keep_seams ? Seams::kKeep : Seams::kPrefer};
    if (asked_.max_error) to.max_error = *asked_.max_error;
    mesh::Reduced result = mesh::reduce(mesh, to);
    done_.hausdorff = mesh::deviation(mesh, result.mesh, kSamples).hausdorff();
    std::string what = triangles_text(before, result.mesh.triangles.size());
    what += fmt::format(", {:.3g} off at most where it was measured", *done_.hausdorff);
    if (!result.seams_kept) what += "; seams of texture or color were in the way, and moved";
    if (result.mesh.triangles.size() > target && !asked_.max_error) {
      what += fmt::format(
          "; {} were asked for: borders, seams or edges of more than two triangles are in the way",
          target);
    }
    if (result.flaws.any()) what += ", and new flaws, as it could not be kept together";
    step("reduce", std::move(what));
    return std::move(result.mesh);
  }

  void make_product(TriangleMesh mesh) {
    switch (asked_.product) {
      case MeshProduct::kMesh: done_.meshes.push_back({{}, std::move(mesh)}); return;
      case MeshProduct::kConvexHull: return make_hull(mesh);
      case MeshProduct::kConvexPieces: return make_pieces(mesh);
      case MeshProduct::kPrimitive: return make_primitive(mesh);
      case MeshProduct::kComponents: return take_parts(mesh::split_by_component(mesh));
      case MeshProduct::kMaterials: return take_parts(mesh::split_by_material(mesh));
    }
  }

  void make_hull(const TriangleMesh& mesh) {
    auto hull = mesh::convex_hull(mesh.positions);
    if (!hull) {
      done_.problem = "the mesh is flat: it has no convex hull";
      return;
    }
    step("convex hull", triangles_text(mesh.triangles.size(), hull->triangles.size()));
    done_.meshes.push_back({{}, std::move(*hull)});
  }

  void make_pieces(const TriangleMesh& mesh) {
    const std::size_t most = std::min<std::uint64_t>(asked_.pieces, mesh::kMaxPieces);
    mesh::Pieces pieces = mesh::convex_pieces(mesh, {.count = most});
    if (pieces.hulls.empty()) {
      done_.problem = "the mesh is flat: it has no convex pieces";
      return;
    }
    std::string what = fmt::format("{}", pieces.hulls.size());
    if (const auto outside = pieces.outside()) {
      what += fmt::format(", {:.2g} % of the volume outside the mesh",
                          100 * *outside / *pieces.mesh_volume);
    }
    if (pieces.open > 0) what += fmt::format("; {} open, taken whole", pieces.open);
    if (pieces.too_large > 0) what += fmt::format("; {} too large to cut", pieces.too_large);
    if (pieces.flat > 0) what += fmt::format("; {} flat, left out", pieces.flat);
    step("convex pieces", std::move(what));
    for (std::size_t i = 0; i < pieces.hulls.size(); ++i) {
      done_.meshes.push_back({std::to_string(i + 1), std::move(pieces.hulls[i])});
    }
  }

  void make_primitive(const TriangleMesh& mesh) {
    done_.primitive = mesh::fit_primitive(mesh, asked_.primitive);
    if (!done_.primitive) {
      done_.problem = "the mesh is flat: no primitive fits it";
      return;
    }
    TriangleMesh fitted = mesh::mesh_of(done_.primitive->shape);
    for (model::Vector3& p : fitted.positions) p = model::transform(done_.primitive->pose, p);
    done_.meshes.push_back({{}, std::move(fitted)});
  }

  void take_parts(mesh::Split split) {
    if (split.too_many()) {
      done_.problem = fmt::format("it would be split into {} files", split.count);
      return;
    }
    step("split", fmt::format("{} parts", split.pieces.size()));
    write::SafeNames names;
    for (mesh::SplitPiece& piece : split.pieces) {
      done_.meshes.push_back(
          {names.take(piece.name.empty() ? "rest" : piece.name), std::move(piece.mesh)});
    }
  }

  const MeshOperations& asked_;
  OperatedMesh done_;
};

}  // namespace

OperatedMesh operate(mesh::TriangleMesh mesh, const MeshOperations& operations) {
  return Operation(operations).run(std::move(mesh));
}

}  // namespace rigor::author
