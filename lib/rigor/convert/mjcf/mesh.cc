// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes as MuJoCo reads them: STL in `assets/`, whatever they were, or OBJ where a picture is on them. A binary STL
// is copied byte for byte.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/convert/mjcf/draft.h>
#include <rigor/convert/mjcf/look.h>
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

/// MuJoCo reads no larger STL; an OBJ may have any number.
constexpr std::size_t kMaxStlTriangles = 200'000;
constexpr std::size_t kStlHeader = 84;
constexpr std::size_t kStlTriangle = 50;

struct MeshOrigin {
  std::string path, submesh;
  bool centered = false;
  bool mirrored = false;  ///< by a scale that turns it inside out, which is folded in
  Vector3 scale{1, 1, 1};

  std::string key() const {
    const std::string folded = mirrored ? mjcf_numbers({scale.x, scale.y, scale.z}) : std::string();
    return fmt::format("{}\n{}\n{}\n{}", path, submesh, centered, folded);
  }
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

/// Positions, triangles and where the picture is.
TriangleMesh pictured(const TriangleMesh& mesh) {
  TriangleMesh result;
  result.positions = mesh.positions;
  result.triangles = mesh.triangles;
  result.parts = {{.count = mesh.triangles.size()}};
  result.corners.texture = mesh.corners.texture;
  mesh::compact(result);
  return result;
}

TriangleMesh parts_of(const TriangleMesh& mesh, const std::vector<std::size_t>& parts) {
  std::vector<std::uint32_t> faces;
  for (const std::size_t i : parts) {
    for (std::size_t k = 0; k < mesh.parts[i].count; ++k) {
      faces.push_back(static_cast<std::uint32_t>(mesh.parts[i].first + k));
    }
  }
  return mesh::selected(mesh, faces);
}

bool has_area(const TriangleMesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&mesh](const auto& t) { return mesh::area(mesh::facet(mesh, t)) > 0; });
}

class MjcfMesher {
 public:
  MjcfMesher(MjcfDraft& draft, const robot::Part& part, const model::Visual* visual,
             const std::string& subject, Span where)
      : draft_(draft), part_(part), visual_(visual), subject_(subject), where_(where) {}

  std::vector<MjcfMesh> make() {
    if (part_.shape.kind == "mesh") return of_file();
    std::string name = of_shape();
    return name.empty() ? std::vector<MjcfMesh>() : std::vector<MjcfMesh>{{std::move(name)}};
  }

 private:
  bool collides() const { return visual_ == nullptr; }

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

  std::vector<MjcfMesh> of_file() {
    const robot::Shape& shape = part_.shape;
    if (shape.path.empty()) {
      lose(NoteKind::kMjcfMeshMissing, shape.uri);
      return {};
    }
    MeshOrigin origin{shape.path, shape.submesh};
    constexpr std::string_view kCentered = " (centered)";
    if (origin.submesh.ends_with(kCentered)) {
      origin.submesh.resize(origin.submesh.size() - kCentered.size());
      origin.centered = true;
    }
    if (shape.numbers.size() == 3) {
      origin.scale = {shape.numbers[0], shape.numbers[1], shape.numbers[2]};
    }
    const Vector3& s = origin.scale;
    const double volume_factor = s.x * s.y * s.z;
    if (volume_factor == 0 || !std::isfinite(volume_factor)) {
      lose(collides() ? NoteKind::kCollisionLost : NoteKind::kShapeLost, "mesh of no size");
      return {};
    }
    origin.mirrored = s.x < 0 || s.y < 0 || s.z < 0;
    const std::vector<MjcfMeshGroup> groups =
        collides() ? std::vector<MjcfMeshGroup>() : looks(origin);
    std::vector<MjcfMesh> meshes = groups.size() > 1 || is_pictured(groups)
                                       ? of_groups(origin, groups)
                                       : of_whole(origin, groups);
    tell(origin, meshes);
    return meshes;
  }

  void tell(const MeshOrigin& origin, const std::vector<MjcfMesh>& meshes) {
    if (meshes.empty()) return;
    const std::string path = std::string(kMjcfAssetFolder) + first_file_;
    if (path != part_.shape.uri) note(NoteKind::kUri, Outcome::kRewritten, part_.shape.uri, path);
    if (collides()) return;
    const std::string written = "the look of " + part_.shape.uri;
    if (meshes[0].look) {
      note(NoteKind::kMjcfLook, Outcome::kRewritten, written,
           meshes.size() == 1 ? "that of its geom"
                              : fmt::format("those of {} geoms", meshes.size()));
    } else if (!part_.color && has_look(origin)) {
      note(NoteKind::kMjcfLook, Outcome::kLost, written, {});
    }
  }

  // --- how it looks ---

  static bool is_pictured(const std::vector<MjcfMeshGroup>& groups) {
    return std::any_of(groups.begin(), groups.end(),
                       [](const MjcfMeshGroup& group) { return !group.look.picture.empty(); });
  }

  bool has_look(const MeshOrigin& origin) {
    const auto mesh = outline(origin);
    return mesh && (!mesh->materials.empty() || !mesh->corners.colors.empty());
  }

  /// None where the model gives it a color, or nothing does.
  std::vector<MjcfMeshGroup> looks(const MeshOrigin& origin) {
    if (!draft_.options.looks) return {};
    const auto mesh = outline(origin);
    if (!mesh) return {};
    const bool urdf = draft_.root().format == model::Format::kUrdf;
    auto groups = grouped_by_look(mesh->parts, draft_.looks_of(*visual_, *mesh));
    const bool own = urdf && !mesh->materials.empty();
    if (part_.color && !own && !is_pictured(groups)) return {};
    return groups;
  }

  /// Its parts and materials, without a triangle.
  std::shared_ptr<const TriangleMesh> outline(const MeshOrigin& origin) {
    auto [known, is_new] = draft_.outlines.try_emplace(origin.key());
    if (!is_new) return known->second;
    const auto whole = load(origin);
    if (!whole) return nullptr;
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->parts = whole->parts;
    mesh->materials = whole->materials;
    mesh->corners.colors.resize(whole->corners.colors.empty() ? 0 : 1);
    return known->second = std::move(mesh);
  }

  // --- what is read ---

  /// Nothing where it cannot be read, or has no such submesh.
  std::optional<TriangleMesh> load(const MeshOrigin& origin) {
    if (draft_.mesh_path != origin.path) {
      draft_.mesh = std::make_shared<const mesh::LoadedMesh>(mesh::read_mesh(
          draft_.source.source.resolver.disk(), origin.path, draft_.source.source.workers));
      draft_.mesh_path = origin.path;
    }
    if (!draft_.mesh->usable() || draft_.mesh->mesh.triangles.empty()) return std::nullopt;
    return submesh_of(draft_.mesh->mesh, origin);
  }

  std::optional<TriangleMesh> load_or_lose(const MeshOrigin& origin) {
    auto whole = load(origin);
    if (whole) return whole;
    if (!draft_.mesh->usable() || draft_.mesh->mesh.triangles.empty()) {
      lose(NoteKind::kMjcfMeshMissing, part_.shape.uri, "cannot be read");
    } else {
      lose(collides() ? NoteKind::kCollisionLost : NoteKind::kSubmesh, "submesh " + origin.submesh);
    }
    return std::nullopt;
  }

  static std::string stem_of(const MeshOrigin& origin) {
    const std::string_view own_name = file_name(origin.path);
    std::string stem = write::safe_name(own_name.substr(0, own_name.rfind('.')));
    if (!origin.submesh.empty()) stem += '-' + write::safe_name(origin.submesh);
    return stem;
  }

  // --- one mesh for all of it ---

  std::vector<MjcfMesh> of_whole(const MeshOrigin& origin,
                                 const std::vector<MjcfMeshGroup>& groups) {
    std::string& file = draft_.mesh_names[origin.key() + (collides() ? "\nc" : "\nv")];
    if (file.empty()) file = write_whole(origin);
    if (file.empty()) return {};
    first_file_ = file;
    MjcfMesh mesh{asset(file, origin)};
    if (!groups.empty()) {
      mesh.look = groups[0].look;
      mesh.material = groups[0].name;
    }
    return {std::move(mesh)};
  }

  std::string write_whole(const MeshOrigin& origin) {
    const auto whole = load_or_lose(origin);
    if (!whole) return {};
    const MujocoSolid solid = solid_of(bare(*whole), origin);
    if (!solid.mesh) {
      return lose(collides() ? NoteKind::kCollisionLost : NoteKind::kShapeLost,
                  "mesh " + std::string(solid.problem));
    }
    if (!solid.change.empty()) {
      note(NoteKind::kMjcfMesh, Outcome::kSubstituted, part_.shape.uri, solid.change);
    }
    const bool binary =
        draft_.mesh->format == mesh::Format::kStlBinary && draft_.mesh->faults.empty();
    if (binary && origin.submesh.empty() && !origin.mirrored && !solid.replaced &&
        solid.mesh->triangles.size() <= kMaxStlTriangles) {
      const Disk& disk = draft_.source.source.resolver.disk();
      const ReadResult bytes = disk.read(origin.path, mesh::kMaxMeshBytes);
      if (bytes.bytes && is_plain_stl(*bytes.bytes)) {
        return put(stem_of(origin), ".stl", *bytes.bytes);
      }
    }
    return write(stem_of(origin), *solid.mesh);
  }

  MujocoSolid solid_of(TriangleMesh mesh, const MeshOrigin& origin) const {
    if (origin.mirrored) fold_scale(mesh, origin.scale);
    return mujoco_solid(std::move(mesh), collides() ? MujocoUse::kCollision : MujocoUse::kVisual);
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
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) mesh::turn_over(mesh, i);
  }

  // --- a mesh for each look ---

  /// Groups without an area are drawn nowhere, and have no file.
  std::vector<MjcfMesh> of_groups(const MeshOrigin& origin,
                                  const std::vector<MjcfMeshGroup>& groups) {
    std::string key = origin.key() + "\ng";
    for (const MjcfMeshGroup& group : groups) {
      key += group.look.picture.empty() ? "\n" : "\nt";
      for (const std::size_t part : group.parts) key += ' ' + std::to_string(part);
    }
    auto [known, is_new] = draft_.group_files.try_emplace(key);
    std::vector<std::string>& files = known->second;
    if (is_new) files = write_groups(origin, groups);
    std::vector<MjcfMesh> meshes;
    for (std::size_t i = 0; i < files.size(); ++i) {
      if (files[i].empty()) continue;
      if (meshes.empty()) first_file_ = files[i];
      meshes.push_back({asset(files[i], origin), groups[i].look, groups[i].name});
    }
    if (meshes.empty() && !files.empty()) lose(NoteKind::kShapeLost, "mesh without area");
    return meshes;
  }

  std::vector<std::string> write_groups(const MeshOrigin& origin,
                                        const std::vector<MjcfMeshGroup>& groups) {
    const auto whole = load_or_lose(origin);
    if (!whole) return {};
    std::vector<std::string> files;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const TriangleMesh mesh = parts_of(*whole, groups[i].parts);
      const bool textured = !groups[i].look.picture.empty() && !mesh.corners.texture.empty();
      std::string& file = files.emplace_back();
      if (!has_area(mesh)) continue;
      const MujocoSolid solid = solid_of(textured ? pictured(mesh) : bare(mesh), origin);
      if (!solid.mesh) continue;
      const std::string number = groups.size() == 1 ? "" : '_' + std::to_string(i + 1);
      file = write(stem_of(origin) + number, *solid.mesh);
    }
    return files;
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
    return asset(file, {});
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
    const bool plain = mesh.corners.texture.empty() && mesh.triangles.size() <= kMaxStlTriangles;
    const std::string ending = plain ? ".stl" : ".obj";
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
      if (file.bytes == bytes) return file.name.substr(kMjcfAssetFolder.size());
    }
    std::string name = draft_.name_for("file", stem) + ending;
    draft_.files.push_back({std::string(kMjcfAssetFolder) + name, std::move(bytes)});
    return name;
  }

  /// One file at several scales is several meshes.
  std::string asset(const std::string& file, const MeshOrigin& origin) {
    const Vector3 scale = origin.mirrored ? Vector3{1, 1, 1} : origin.scale;
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
  const model::Visual* visual_;  ///< null for a collision
  const std::string& subject_;
  Span where_;
  std::string first_file_;
};

}  // namespace

std::vector<MjcfMesh> mjcf_meshes(MjcfDraft& draft, const robot::Part& part,
                                  const model::Visual* visual, const std::string& subject,
                                  Span where) {
  return MjcfMesher(draft, part, visual, subject, where).make();
}

}  // namespace rigor::convert
