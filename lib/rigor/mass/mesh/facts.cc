// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mesh/facts.h>

#include <algorithm>
#include <utility>

#include <rigor/mass/mesh/cache.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/mesh/convex/convexity.h>
#include <rigor/mesh/select.h>

namespace rigor::mass {
namespace {

using mesh::TriangleMesh;

/// A vertex is drawn once for each position that a file keeps apart; where triangles have normals of
/// their own, once for each of their corners.
std::uint64_t largest_part(const TriangleMesh& mesh) {
  std::uint64_t largest = 0;
  std::vector<std::size_t> seen_in(mesh.positions.size(), mesh.parts.size());
  for (std::size_t part = 0; part < mesh.parts.size(); ++part) {
    std::uint64_t vertices = 0;
    const std::size_t end = mesh.parts[part].first + mesh.parts[part].count;
    for (std::size_t t = mesh.parts[part].first; t < end; ++t) {
      for (const std::uint32_t corner : mesh.triangles[t]) {
        if (std::exchange(seen_in[corner], part) != part) ++vertices;
      }
    }
    largest = std::max(largest, vertices);
  }
  return largest;
}

bool outward(const MeshShape& shape) { return shape.topology.closed() && shape.moments.volume > 0; }

MeshShape shape_of(const TriangleMesh& mesh, MeshDepth depth) {
  MeshShape shape;
  shape.topology = mesh::topology_of(mesh);
  shape.moments = moments_of(mesh);
  shape.convex = outward(shape) && mesh::is_convex(mesh, shape.moments.volume);
  if (depth == MeshDepth::kAll || mesh.triangles.size() <= kSmallMesh) {
    shape.self_intersections = mesh::self_intersections(mesh);
  }
  return shape;
}

/// Of a glTF file that cannot be read: what it leans on, which may be why.
mesh::Asset what_is_lacking(const Disk& disk, const std::string& path, mesh::Format format) {
  if (format != mesh::Format::kGltf && format != mesh::Format::kGlb) return {};
  mesh::Asset asset = mesh::asset_of(disk, path, format);
  asset.textures.clear();
  return asset;
}

}  // namespace

bool MeshFacts::usable() const {
  return std::none_of(faults.begin(), faults.end(),
                      [](const mesh::Fault& fault) { return mesh::fatal(fault.kind); });
}

bool MeshFacts::whole() const {
  return usable() && std::none_of(faults.begin(), faults.end(), [](const mesh::Fault& fault) {
           return fault.kind == mesh::FaultKind::kTruncated;
         });
}

MeshFacts mesh_facts(const Disk& disk, const std::string& path, MeshDepth depth) {
  return mesh_facts(disk, path, depth, process::Workers());
}

MeshFacts mesh_facts(const Disk& disk, const std::string& path, MeshDepth depth,
                     const process::Workers& workers) {
  return mesh_facts(disk, path, mesh::read_mesh(disk, path, workers), depth);
}

MeshFacts mesh_facts(const Disk& disk, const std::string& path, const mesh::LoadedMesh& loaded,
                     MeshDepth depth) {
  MeshFacts facts;
  facts.path = path;
  if (const auto file = disk.open(path)) facts.bytes = file->size();
  facts.format = loaded.format;
  facts.faults = loaded.faults;
  if (!facts.usable()) {
    facts.asset = what_is_lacking(disk, path, loaded.format);
    return facts;
  }
  facts.asset = mesh::asset_of(disk, path, loaded.format);
  facts.triangles = loaded.mesh.triangles.size();
  facts.largest_part = largest_part(loaded.mesh);
  facts.normals = !loaded.mesh.corners.normals.empty();
  facts.bounds = mesh::bounds_of(mesh::used_positions(loaded.mesh));
  if (depth != MeshDepth::kFile) facts.shape = shape_of(loaded.mesh, depth);
  return facts;
}

Turns* MeshMemory::turns() const { return reads ? reads->turns() : nullptr; }

const MeshFacts& MeshFiles::find(const std::string& path, MeshDepth depth) {
  depth = std::max(depth, min_);
  return known_.find({path, depth}, [&] {
    const auto [cache, reads, workers] = memory_;
    if (cache) return cache->facts(disk_, path, depth, reads);
    if (reads) return mesh_facts(disk_, path, *reads->find(path), depth);
    return workers ? mesh_facts(disk_, path, depth, *workers) : mesh_facts(disk_, path, depth);
  });
}

}  // namespace rigor::mass
