// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mesh/survey.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <rigor/mass/mesh/cache.h>
#include <rigor/mass/mesh/facet_stream.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/mass/pyramids.h>
#include <rigor/mass/shell.h>
#include <rigor/mesh/convex/hull.h>
#include <rigor/mesh/select.h>
#include <rigor/mesh/stl/stl.h>

namespace rigor::mass {
namespace {

using mesh::TriangleMesh;

// A file of more is not held in memory for what one pass over it tells.
constexpr std::uint64_t kStreamedBytes = std::uint64_t{32} << 20U;

// Less volume than this share of the bounds' is that of a sheet: of what a modeler means as a solid,
// the thinnest is a plate a thousand times as wide as thick.
constexpr double kMinFill = 1e-7;

double volume_of(const mesh::Bounds& b) {
  return (b.max.x - b.min.x) * (b.max.y - b.min.y) * (b.max.z - b.min.z);
}

bool finite_sums(const FacetSums& sums) {
  const PolyhedronMoments moments = sums.polyhedron.moments();
  return std::isfinite(moments.area) && std::isfinite(moments.volume);
}

/// A plain binary STL, of the size that its count says, without anything in memory.
std::optional<FacetSums> stream(const OpenFile& file, unsigned threads) {
  std::string header(512, '\0');
  header.resize(file.read(0, header.data(), header.size()));
  if (!mesh::is_binary_stl(header, file.size())) return std::nullopt;
  const std::uint64_t count = mesh::stl_triangles(header, file.size());
  if (count == 0 || count > mesh::kMaxTriangles) return std::nullopt;
  if (file.size() != mesh::kStlHeaderBytes + count * mesh::kStlFacetBytes) return std::nullopt;
  FacetSums sums = stream_stl(file, count, threads);
  if (!finite_sums(sums)) return std::nullopt;  // the reader says which number it is
  return sums;
}

TriangleMesh part_of(TriangleMesh mesh, std::string_view name) {
  std::vector<mesh::Triangle> kept;
  for (const mesh::Part& part : mesh.parts) {
    if (part.name != name) continue;
    const auto first = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(part.first);
    kept.insert(kept.end(), first, first + static_cast<std::ptrdiff_t>(part.count));
  }
  mesh.triangles = std::move(kept);
  mesh.parts.clear();
  return mesh;
}

void move_to_center(TriangleMesh& mesh) {
  const mesh::Bounds bounds = mesh::bounds_of(mesh::used_positions(mesh));
  const model::Vector3 center = 0.5 * (bounds.min + bounds.max);
  for (model::Vector3& p : mesh.positions) p = p - center;
}

TriangleMesh stretched(TriangleMesh mesh, const model::Vector3& s) {
  for (model::Vector3& p : mesh.positions) p = {s.x * p.x, s.y * p.y, s.z * p.z};
  return mesh;
}

FacetSums sums_of(const TriangleMesh& mesh) {
  const mesh::Bounds bounds = mesh::bounds_of(mesh::used_positions(mesh));
  FacetSums sums(bounds);
  for (const mesh::Triangle& t : mesh.triangles) sums.add(mesh::facet(mesh, t));
  return sums;
}

void take(const FacetSums& sums, MeshSurvey& survey) {
  survey.triangles = sums.triangles;
  survey.bounds = sums.bounds;
  survey.moments = sums.polyhedron.moments();
  survey.closed = sums.balance.closed();
  survey.winding = sums.winding.result();
}

bool flat(const MeshSurvey& survey) {
  return !(std::abs(survey.moments.volume) > kMinFill * volume_of(survey.bounds));
}

MeshState state_of(const MeshSurvey& survey) {
  const double inverted = survey.winding.inverted;
  if (!survey.closed) return MeshState::kOpen;
  if (flat(survey)) return MeshState::kFlat;
  if (survey.winding.doubled > kMaxDoubled) return MeshState::kOverlapping;
  if (inverted > kMaxDoubled && inverted < 1 - kMaxDoubled) return MeshState::kMixed;
  return survey.moments.volume < 0 ? MeshState::kInverted : MeshState::kSolid;
}

/// Whether the triangles themselves do not say what they enclose.
bool needs_hull(const MeshSurvey& survey) {
  const MeshState state = state_of(survey);
  return state != MeshState::kSolid && state != MeshState::kInverted;
}

void add_hull(const TriangleMesh& mesh, MeshSurvey& survey) {
  if (!survey.closed) survey.topology = mesh::topology_of(mesh);
  if (const auto hull = mesh::convex_hull(mesh::used_positions(mesh)))
    survey.hull = moments_of(*hull);
  survey.pyramids = pyramids_of(mesh);
  survey.pyramids_as_wound = pyramids_of(mesh, PyramidSigns::kAsWound);
}

/// Of a plain binary STL whose triangles say what they enclose.
std::optional<MeshSurvey> streamed(const Disk& disk, const MeshChoice& choice, unsigned threads) {
  if (!choice.submesh.empty() || choice.center || choice.sheet_scale) return std::nullopt;
  const auto file = disk.open(choice.path);
  const auto sums = file ? stream(*file, threads) : std::nullopt;
  if (!sums) return std::nullopt;
  MeshSurvey survey;
  survey.format = mesh::Format::kStlBinary;
  take(*sums, survey);
  if (needs_hull(survey)) return std::nullopt;
  return survey;
}

MeshSurvey survey_of(const mesh::LoadedMesh& loaded, const MeshChoice& choice) {
  MeshSurvey survey;
  survey.format = loaded.format;
  survey.faults = loaded.faults;
  if (!survey.usable()) {
    // Vertices without faces, which MuJoCo takes for their hull.
    const auto hull = mesh::convex_hull(loaded.mesh.positions);
    if (hull) survey.hull = moments_of(*hull);
    return survey;
  }
  std::optional<TriangleMesh> own;
  if (!choice.submesh.empty()) own = part_of(loaded.mesh, choice.submesh);
  if (choice.center) move_to_center(own ? *own : own.emplace(loaded.mesh));
  const TriangleMesh& mesh = own ? *own : loaded.mesh;
  if (mesh.triangles.empty()) {
    survey.faults.push_back({mesh::FaultKind::kEmpty, "it has no part named " + choice.submesh});
    return survey;
  }
  take(sums_of(mesh), survey);
  if (needs_hull(survey)) add_hull(mesh, survey);
  if (choice.sheet_scale) survey.sheet = shell_of(stretched(mesh, *choice.sheet_scale), 1);
  return survey;
}

}  // namespace

MeshChoice mesh_choice(const std::string& path, const model::Mesh& mesh) {
  MeshChoice choice{path, mesh.submesh.value, mesh.center.value};
  if (mesh.sheet) choice.sheet_scale = mesh.scale.value;
  return choice;
}

bool MeshSurvey::usable() const {
  return std::none_of(faults.begin(), faults.end(),
                      [](const mesh::Fault& fault) { return mesh::fatal(fault.kind); });
}

MeshSurvey survey_mesh(const Disk& disk, const MeshChoice& choice, unsigned threads) {
  return survey_mesh(disk, choice, process::Workers(), threads);
}

MeshSurvey survey_mesh(const Disk& disk, const MeshChoice& choice, const process::Workers& workers,
                       unsigned threads) {
  if (auto survey = streamed(disk, choice, threads)) return *std::move(survey);
  return survey_of(mesh::read_mesh(disk, choice.path, workers), choice);
}

MeshSurvey survey_mesh(const Disk& disk, const MeshChoice& choice, MeshReads& reads) {
  const auto file = disk.open(choice.path);
  if (file && file->size() > kStreamedBytes) return survey_mesh(disk, choice);
  return survey_of(*reads.find(choice.path), choice);
}

const MeshSurvey& MeshSurveys::find(const MeshChoice& choice) {
  const model::Vector3 s = choice.sheet_scale.value_or(model::Vector3{});
  return known_.find({choice.path, choice.submesh, choice.center, {s.x, s.y, s.z}}, [&] {
    const auto [cache, reads, workers] = memory_;
    if (cache) return cache->survey(disk_, choice, reads);
    if (reads) return survey_mesh(disk_, choice, *reads);
    return workers ? survey_mesh(disk_, choice, *workers) : survey_mesh(disk_, choice);
  });
}

MeshBody body_of(const MeshSurvey& survey, const model::Vector3& scale) {
  if (!survey.usable()) return {};
  MeshBody body{state_of(survey)};
  if (body.state == MeshState::kSolid) {
    body.solid = solid_of(scaled(survey.moments, scale));
  } else if (body.state == MeshState::kInverted) {
    body.from = BodyFrom::kTurnedMesh;
    body.solid = solid_of(scaled(inverted(survey.moments), scale));
  } else if (survey.hull) {
    body.from = BodyFrom::kHull;
    body.solid = solid_of(scaled(*survey.hull, scale));
  } else {
    body.state = MeshState::kFlat;
  }
  return body;
}

}  // namespace rigor::mass
