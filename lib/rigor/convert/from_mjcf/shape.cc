// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/from_mjcf/shape.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <variant>

#include <rigor/convert/mjcf/mesh_solid.h>
#include <rigor/convert/number_text.h>
#include <rigor/convert/urdf/shape_file.h>
#include <rigor/convert/urdf/uri.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/write/write.h>
#include <rigor/read/values.h>
#include <rigor/text/path.h>
#include <rigor/write/numbers.h>
#include <rigor/write/safe_name.h>

namespace rigor::convert {
namespace {

using mesh::TriangleMesh;
using model::Vector3;

/// m: MuJoCo draws a plane of size zero without an end.
constexpr double kEndlessPlane = 100;

constexpr std::string_view kFileFolder = "meshes/";

bool is_read_everywhere(const std::string& path) {
  std::string ending = extension(path);
  std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  if (ending.starts_with('.')) ending.erase(0, 1);
  return ending == "stl" || ending == "obj" || ending == "dae";
}

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8U | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

/// MuJoCo's own binary format: counts of vertices, normals, texture coordinates and faces, then the
/// numbers as 32-bit floats and indices, little-endian.
std::optional<TriangleMesh> msh_mesh(const std::string& bytes) {
  constexpr std::size_t kHeader = 16, kWord = 4;
  if (bytes.size() < kHeader) return std::nullopt;
  const std::size_t vertices = word_at(bytes, 0), normals = word_at(bytes, kWord),
                    textures = word_at(bytes, 2 * kWord), faces = word_at(bytes, 3 * kWord);
  const std::size_t words = 3 * vertices + 3 * normals + 2 * textures + 3 * faces;
  if (bytes.size() != kHeader + kWord * words || vertices == 0) return std::nullopt;
  TriangleMesh mesh;
  std::size_t at = kHeader;
  const auto number = [&] {
    const double value = std::bit_cast<float>(word_at(bytes, at));
    at += kWord;
    return value;
  };
  for (std::size_t i = 0; i < vertices; ++i) {
    const double x = number(), y = number(), z = number();
    mesh.positions.push_back({x, y, z});
  }
  at += kWord * (3 * normals + 2 * textures);
  for (std::size_t i = 0; i < faces; ++i, at += 3 * kWord) {
    const mesh::Triangle face{word_at(bytes, at), word_at(bytes, at + kWord),
                              word_at(bytes, at + 2 * kWord)};
    if (face[0] >= vertices || face[1] >= vertices || face[2] >= vertices) return std::nullopt;
    mesh.triangles.push_back(face);
  }
  return faces == 0 ? mujoco_hull(mesh.positions) : std::optional(std::move(mesh));
}

std::optional<TriangleMesh> inline_mesh(const model::Mesh& shape) {
  if (shape.faces.empty()) {
    return shape.vertices.empty() ? std::nullopt : mujoco_hull(shape.vertices);
  }
  TriangleMesh mesh;
  mesh.positions = shape.vertices;
  for (const auto& face : shape.faces) mesh.triangles.push_back({face[0], face[1], face[2]});
  return mesh;
}

}  // namespace

struct MjcfShapeMaker {
  MjcfShaper& shaper;
  const model::Geometry& geometry;
  const std::string& subject;

  bool urdf() const { return shaper.plan_.target == MjcfTarget::kUrdf; }

  std::vector<MjcfShape> operator()(const model::Box& s) const {
    return {{UrdfBox{numbers(s.size.value)}}};
  }
  std::vector<MjcfShape> operator()(const model::Sphere& s) const {
    return {{UrdfSphere{{s.radius.value, {}}}}};
  }
  std::vector<MjcfShape> operator()(const model::Cylinder& s) const {
    return {{UrdfCylinder{{s.radius.value, {}}, {s.length.value, {}}}}};
  }
  std::vector<MjcfShape> operator()(const model::Capsule& s) const {
    const Number radius{s.radius.value, {}}, length{s.length.value, {}};
    if (!urdf() || shaper.plan_.options.urdf.urdf_version >= 1) {
      return {{UrdfCapsule{radius, length}}};
    }
    tell("capsule", "cylinder and 2 spheres");
    const Vector3 end{0, 0, s.length.value / 2};
    return {{UrdfCylinder{radius, length}},
            {UrdfSphere{radius}, {}, model::Pose{end, {}}, "_top"},
            {UrdfSphere{radius}, {}, model::Pose{-1 * end, {}}, "_bottom"}};
  }
  std::vector<MjcfShape> operator()(const model::Ellipsoid& s) const {
    if (!urdf()) {
      SdfElement element{.name = "ellipsoid"};
      element.set("radii", number_texts(numbers(s.radii.value)));
      return {{{}, std::move(element)}};
    }
    if (!shaper.writes()) return {};
    const auto name = shape_file(*shaper.urdf_, geometry);
    if (!name) return {};
    tell("ellipsoid", *name);
    return {{UrdfMesh{*name, {}}}};
  }
  std::vector<MjcfShape> operator()(const model::Plane& /*plane*/) const {
    if (urdf()) return {};
    double x = kEndlessPlane, y = kEndlessPlane;
    const xml::Element element = shaper.plan_.source.source.documents.element(geometry.site);
    const auto written = read::attribute_text(element, "size");
    const auto size = written ? read::mjcf_numbers(written->text) : std::nullopt;
    if (size && size->size() >= 2) {
      if ((*size)[0] > 0) x = 2 * (*size)[0];
      if ((*size)[1] > 0) y = 2 * (*size)[1];
    }
    SdfElement plane{.name = "plane"};
    plane.set("normal", "0 0 1");
    plane.set("size", to_text({x, {}}) + ' ' + to_text({y, {}}));
    return {{{}, std::move(plane)}};
  }
  std::vector<MjcfShape> operator()(const model::Mesh& s) const {
    const auto file = shaper.mesh_file(s, geometry);
    if (!file) return {};
    UrdfMesh mesh{*file, {}};
    if (s.scale.value != Vector3{1, 1, 1}) mesh.scale = numbers(s.scale.value);
    return {{std::move(mesh)}};
  }
  template <class Other>
  std::vector<MjcfShape> operator()(const Other&) const {
    return {};
  }

  void tell(std::string written, std::string instead) const {
    shaper.ledger_.note({.kind = NoteKind::kShape,
                         .outcome = Outcome::kSubstituted,
                         .where = geometry.site.name,
                         .subject = subject,
                         .written = std::move(written),
                         .instead = std::move(instead)});
  }
};

std::vector<MjcfShape> MjcfShaper::shapes(const model::Geometry& geometry,
                                          const std::string& subject, MjcfUse use) {
  auto result = std::visit(MjcfShapeMaker{*this, geometry, subject}, geometry.shape);
  if (!result.empty()) {
    if (const auto* mesh = std::get_if<model::Mesh>(&geometry.shape)) {
      auto& written = std::get<UrdfMesh>(result.front().geometry);
      if (written.filename.empty()) written.filename = uri_of(mesh->uri, subject);
    }
    return result;
  }
  const bool plane = std::holds_alternative<model::Plane>(geometry.shape);
  const NoteKind kind = plane                     ? NoteKind::kFromMjcfWorld
                        : use == MjcfUse::kVisual ? NoteKind::kShapeLost
                                                  : NoteKind::kCollisionLost;
  ledger_.lose(
      geometry.site,
      {.kind = kind, .subject = subject, .written = std::string(shape_name(geometry.shape))});
  return {};
}

/// As a URI in the main file, whichever file names it.
std::string MjcfShaper::uri_of(const model::Field<std::string>& uri,
                               const std::string& subject) const {
  model::Field<std::string> field = uri;
  const std::string path = plan_.source.lookups.find_file(uri.value, uri.span.source);
  if (!path.empty()) field.value = relative_path(parent_path(plan_.source.source.path), path);
  return urdf_ != nullptr ? urdf_uri(*urdf_, field, subject) : sdf_uri(*sdf_, field, subject);
}

/// Empty where the file can be named as it is; nothing where there is no mesh.
std::optional<std::string> MjcfShaper::mesh_file(const model::Mesh& shape,
                                                 const model::Geometry& geometry) {
  const read::Documents& documents = plan_.source.source.documents;
  if (shape.uri.value.empty()) {
    const auto mesh = writes() ? inline_mesh(shape) : std::nullopt;
    if (!mesh) return std::nullopt;
    const auto name = read::attribute_text(documents.element(geometry.site), "mesh");
    const std::string stem = write::safe_name(name ? name->text : std::string_view("mesh"));
    auto written = mesh::write_mesh(*mesh, stem + ".stl");
    if (!written.bytes) return std::nullopt;
    // Made before the bytes are moved: the order of arguments is the compiler's.
    const std::string identity = "inline " + *written.bytes;
    return put(identity, stem, *std::move(written.bytes));
  }
  const std::string path = plan_.source.lookups.find_file(shape.uri.value, shape.uri.span.source);
  if (path.empty() || is_read_everywhere(path)) return std::string();
  if (!writes()) return std::nullopt;
  const Disk& disk = plan_.source.source.resolver.disk();
  std::optional<TriangleMesh> mesh;
  const ReadResult bytes = disk.read(path, mesh::kMaxMeshBytes);
  if (bytes.bytes) mesh = msh_mesh(*bytes.bytes);
  if (!mesh) {
    mesh::LoadedMesh loaded = mesh::read_mesh(disk, path, plan_.source.source.workers);
    if (!loaded.usable() || loaded.mesh.triangles.empty()) return std::nullopt;
    mesh = std::move(loaded.mesh);
  }
  const std::string_view name = file_name(path);
  const std::string stem = write::safe_name(name.substr(0, name.rfind('.')));
  auto written = mesh::write_mesh(*mesh, stem + ".stl");
  if (!written.bytes) return std::nullopt;
  return put(path, stem, *std::move(written.bytes));
}

std::string MjcfShaper::put(const std::string& identity, const std::string& stem,
                            std::string bytes) {
  if (const auto known = names_.find(identity); known != names_.end()) return known->second;
  std::string name = std::string(kFileFolder) + stem + ".stl";
  const auto is_taken = [&](const SideFile& file) { return file.name == name; };
  for (int n = 2; std::any_of(files_.begin(), files_.end(), is_taken); ++n) {
    name = std::string(kFileFolder) + stem + '-' + std::to_string(n) + ".stl";
  }
  files_.push_back({name, std::move(bytes)});
  names_.emplace(identity, name);
  return name;
}

}  // namespace rigor::convert
