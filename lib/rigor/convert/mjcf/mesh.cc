// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes as MuJoCo reads them: STL in `assets/`, whatever they were. A binary STL is copied byte for byte.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/convert/mjcf/draft.h>
#include <rigor/convert/mjcf/mesh_solid.h>
#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/select.h>
#include <rigor/mesh/write/write.h>
#include <rigor/text/path.h>
#include <rigor/write/safe_name.h>

namespace rigor::convert {
namespace {

using mesh::TriangleMesh;
using model::Vector3;

constexpr std::string_view kAssetFolder = "assets/";
/// MuJoCo reads no larger STL; an OBJ may have any number.
constexpr std::size_t kMaxStlTriangles = 200'000;
constexpr std::size_t kStlHeader = 84;
constexpr std::size_t kStlTriangle = 50;

struct MeshOrigin {
  std::string path, submesh;
  bool centered = false;
  bool mirrored = false;  ///< by a scale that turns it inside out, which is folded in
};

/// The part of that name, moved to the middle of its bounds where that is asked for.
std::optional<TriangleMesh> submesh_of(TriangleMesh whole, const MeshOrigin& origin) {
  if (origin.submesh.empty()) return whole;
  std::vector<std::uint32_t> faces;
  for (const mesh::Part& part : whole.parts) {
    if (part.name != origin.submesh) continue;
    for (std::size_t i = 0; i < part.count; ++i) {
      faces.push_back(static_cast<std::uint32_t>(part.first + i));
    }
  }
  if (faces.empty()) return std::nullopt;
  TriangleMesh part = mesh::selected(std::move(whole), faces);
  if (origin.centered) {
    const mesh::Bounds bounds = mesh::bounds_of(mesh::used_positions(part));
    const Vector3 middle = 0.5 * (bounds.min + bounds.max);
    for (Vector3& p : part.positions) p = p - middle;
  }
  return part;
}

/// Positions and triangles alone: what an STL or a bare OBJ holds.
TriangleMesh bare(const TriangleMesh& mesh) {
  TriangleMesh result = mesh::compacted(mesh.positions, mesh.triangles);
  for (mesh::Part& part : result.parts) part = {.first = part.first, .count = part.count};
  return result;
}

class MjcfMesher {
 public:
  MjcfMesher(MjcfDraft& draft, const robot::Part& part, std::string_view use,
             const std::string& subject, Span where)
      : draft_(draft), part_(part), use_(use), subject_(subject), where_(where) {}

  std::string make() {
    if (part_.shape.kind == "mesh") return of_file();
    return of_shape();
  }

 private:
  bool collides() const { return use_ == "collision"; }

  std::string lose(NoteKind kind, std::string written, std::string instead = {}) {
    note(kind, Outcome::kLost, std::move(written), std::move(instead));
    return {};
  }

  void note(NoteKind kind, Outcome outcome, std::string written, std::string instead) {
    draft_.ledger.note({.kind = kind,
                        .outcome = outcome,
                        .where = where_,
                        .subject = subject_,
                        .written = std::move(written),
                        .instead = std::move(instead)});
  }

  // --- a file ---

  std::string of_file() {
    const robot::Shape& shape = part_.shape;
    if (shape.path.empty()) return lose(NoteKind::kMjcfMeshMissing, shape.uri);
    MeshOrigin origin{shape.path, shape.submesh};
    constexpr std::string_view kCentered = " (centered)";
    if (origin.submesh.ends_with(kCentered)) {
      origin.submesh.resize(origin.submesh.size() - kCentered.size());
      origin.centered = true;
    }
    Vector3 scale{1, 1, 1};
    if (shape.numbers.size() == 3) scale = {shape.numbers[0], shape.numbers[1], shape.numbers[2]};
    const double volume_factor = scale.x * scale.y * scale.z;
    if (volume_factor == 0 || !std::isfinite(volume_factor)) {
      return lose(collides() ? NoteKind::kCollisionLost : NoteKind::kShapeLost, "mesh of no size");
    }
    origin.mirrored = scale.x < 0 || scale.y < 0 || scale.z < 0;
    const std::string file = file_for(origin, scale);
    if (file.empty()) return {};
    const std::string path = std::string(kAssetFolder) + file;
    if (path != shape.uri) note(NoteKind::kUri, Outcome::kRewritten, shape.uri, path);
    if (origin.mirrored) scale = {1, 1, 1};
    return asset(file, scale);
  }

  /// The file's name in `assets/`, written when it is first needed.
  std::string file_for(const MeshOrigin& origin, const Vector3& scale) {
    std::string key = fmt::format("{}\n{}\n{}\n{}", origin.path, origin.submesh, origin.centered,
                                  collides() ? "c" : "v");
    if (origin.mirrored) key += mjcf_numbers({scale.x, scale.y, scale.z});
    const auto known = draft_.mesh_names.find(key);
    if (known != draft_.mesh_names.end()) return known->second;
    const std::string file = write_file(origin, scale);
    if (!file.empty()) draft_.mesh_names.emplace(std::move(key), file);
    return file;
  }

  std::string write_file(const MeshOrigin& origin, const Vector3& scale) {
    const Disk& disk = draft_.source.source.resolver.disk();
    mesh::LoadedMesh loaded = mesh::read_mesh(disk, origin.path, draft_.source.source.workers);
    if (!loaded.usable() || loaded.mesh.triangles.empty()) {
      return lose(NoteKind::kMjcfMeshMissing, part_.shape.uri, "cannot be read");
    }
    const std::string_view own_name = file_name(origin.path);
    std::string stem = write::safe_name(own_name.substr(0, own_name.rfind('.')));
    if (!origin.submesh.empty()) stem += '-' + write::safe_name(origin.submesh);
    const bool looks = !loaded.mesh.materials.empty() || !loaded.mesh.corners.colors.empty();
    const bool binary = loaded.format == mesh::Format::kStlBinary && loaded.faults.empty();
    auto whole = submesh_of(std::move(loaded.mesh), origin);
    if (!whole) {
      return lose(collides() ? NoteKind::kCollisionLost : NoteKind::kSubmesh,
                  "submesh " + origin.submesh);
    }
    TriangleMesh mesh = bare(*whole);
    if (origin.mirrored) fold_scale(mesh, scale);
    MujocoSolid solid =
        mujoco_solid(std::move(mesh), collides() ? MujocoUse::kCollision : MujocoUse::kVisual);
    if (!solid.mesh) {
      return lose(collides() ? NoteKind::kCollisionLost : NoteKind::kShapeLost,
                  "mesh " + std::string(solid.problem));
    }
    if (!solid.change.empty()) {
      note(NoteKind::kMjcfMesh, Outcome::kSubstituted, part_.shape.uri, solid.change);
    }
    if (looks && !collides() && !part_.color) {
      note(NoteKind::kMjcfLook, Outcome::kLost, "colors and textures of " + part_.shape.uri, {});
    }
    if (binary && origin.submesh.empty() && !origin.mirrored && !solid.replaced &&
        solid.mesh->triangles.size() <= kMaxStlTriangles) {
      const ReadResult bytes = disk.read(origin.path, mesh::kMaxMeshBytes);
      if (bytes.bytes && is_plain_stl(*bytes.bytes)) return put(stem, ".stl", *bytes.bytes);
    }
    return write(stem, *solid.mesh);
  }

  static bool is_plain_stl(const std::string& bytes) {
    if (bytes.size() < kStlHeader || bytes.starts_with("solid")) return false;
    std::size_t count = 0;
    for (std::size_t i = 4; i-- > 0;)
      count = count << 8U | static_cast<unsigned char>(bytes[80 + i]);
    return bytes.size() == kStlHeader + kStlTriangle * count;
  }

  static void fold_scale(TriangleMesh& mesh, const Vector3& scale) {
    for (Vector3& p : mesh.positions) p = {p.x * scale.x, p.y * scale.y, p.z * scale.z};
    if (scale.x * scale.y * scale.z > 0) return;
    for (mesh::Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  }

  // --- a shape that MuJoCo lacks ---

  std::string of_shape() {
    const robot::Shape& shape = part_.shape;
    std::string key = shape.kind;
    for (const double number : shape.numbers) key += ' ' + mjcf_number(number);
    const auto known = draft_.mesh_names.find(key);
    std::string file = known == draft_.mesh_names.end() ? std::string() : known->second;
    if (file.empty()) {
      std::optional<TriangleMesh> mesh;
      if (shape.kind == "cone") mesh = mesh::cone_mesh(shape.numbers[0], shape.numbers[1]);
      if (shape.kind == "polyline") mesh = prism();
      if (!mesh) {
        return lose(collides() ? NoteKind::kCollisionLost : NoteKind::kShapeLost, shape.kind);
      }
      file = write(shape.kind, *mesh);
      if (file.empty()) return {};
      draft_.mesh_names.emplace(std::move(key), file);
    }
    note(NoteKind::kMjcfMesh, Outcome::kSubstituted, shape.kind,
         "becomes a mesh of its convex hull");
    return asset(file, {1, 1, 1});
  }

  std::optional<TriangleMesh> prism() const {
    const auto& n = part_.shape.numbers;
    std::vector<Vector3> points;
    for (std::size_t i = 1; i + 1 < n.size(); i += 2) {
      points.push_back({n[i], n[i + 1], 0});
      points.push_back({n[i], n[i + 1], n[0]});
    }
    return mujoco_hull(points);
  }

  // --- what is written ---

  std::string write(const std::string& stem, const TriangleMesh& mesh) {
    const bool small = mesh.triangles.size() <= kMaxStlTriangles;
    const std::string ending = small ? ".stl" : ".obj";
    auto written = mesh::write_mesh(mesh, stem + ending);
    if (!written.bytes) {
      return lose(collides() ? NoteKind::kCollisionLost : NoteKind::kShapeLost,
                  "mesh: " + written.problem);
    }
    return put(stem, ending, *std::move(written.bytes));
  }

  /// A mesh that is drawn and collides as well is often one file.
  std::string put(const std::string& stem, const std::string& ending, std::string bytes) {
    for (const SideFile& file : draft_.files) {
      if (file.bytes == bytes) return file.name.substr(kAssetFolder.size());
    }
    std::string name = draft_.name_for("file", stem) + ending;
    draft_.files.push_back({std::string(kAssetFolder) + name, std::move(bytes)});
    return name;
  }

  /// One file at several scales is several meshes.
  std::string asset(const std::string& file, const Vector3& scale) {
    const std::string numbers = mjcf_numbers({scale.x, scale.y, scale.z});
    std::string& name = draft_.mesh_names["asset\n" + file + '\n' + numbers];
    if (!name.empty()) return name;
    name = draft_.name_for("mesh", file.substr(0, file.rfind('.')));
    MjcfElement element{"mesh", {{"name", name}, {"file", file}}};
    if (numbers != "1 1 1") element.set("scale", numbers);
    draft_.asset.add(std::move(element));
    return name;
  }

  MjcfDraft& draft_;
  const robot::Part& part_;
  std::string_view use_;
  const std::string& subject_;
  Span where_;
};

}  // namespace

std::string mjcf_mesh(MjcfDraft& draft, const robot::Part& part, std::string_view use,
                      const std::string& subject, Span where) {
  return MjcfMesher(draft, part, use, subject, where).make();
}

}  // namespace rigor::convert
