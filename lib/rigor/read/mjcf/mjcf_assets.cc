// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/mjcf/mjcf_assets.h>

#include <algorithm>
#include <cmath>

#include <rigor/text/path.h>

namespace rigor::read {
namespace {

using Law = model::GeomWeight::MeshLaw;

Law mesh_law(std::string_view name) {
  if (name == "convex") return Law::kConvex;
  if (name == "exact") return Law::kExact;
  if (name == "shell") return Law::kShell;
  return Law::kLegacy;
}

/// The name that an asset has when the file gives none: that of its file, without the ending.
std::string asset_name(const MjcfValues& values) {
  const std::string name = values.string("name").value;
  if (!name.empty()) return name;
  const std::string file = values.string("file").value;
  const std::string_view last = file_name(file);
  return std::string(last.substr(0, last.rfind('.')));
}

void add_vertices(const MjcfValues& values, model::Mesh& mesh) {
  const std::vector<double> n = values.numbers("vertex");
  for (std::size_t i = 0; i + 2 < n.size(); i += 3)
    mesh.vertices.push_back({n[i], n[i + 1], n[i + 2]});
  const std::vector<double> faces = values.numbers("face");
  for (std::size_t i = 0; i + 2 < faces.size(); i += 3) {
    std::array<std::uint32_t, 3> face{};
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const double corner = faces[i + k];
      inside = inside && corner >= 0 && corner < static_cast<double>(mesh.vertices.size());
      face[k] = inside ? static_cast<std::uint32_t>(corner) : 0;
    }
    if (inside) mesh.faces.push_back(face);
  }
}

/// MuJoCo takes `refpos` from each vertex, rotates the rest by R, the inverse of `refquat`, and scales last: S R (v - p).
/// A pose rotates last: that is R (RᵀS R) v, where RᵀS R is a scale if R only swaps axes that S scales otherwise.
void place_reference(MjcfMesh& asset, const model::Vector3& p, const model::Quaternion& R) {
  model::Mesh& mesh = asset.mesh;
  const model::Vector3 s = mesh.scale.value;
  const auto stretched = [&s](const model::Vector3& v) {
    return model::Vector3{s.x * v.x, s.y * v.y, s.z * v.z};
  };
  const std::array<model::Vector3, 3> axes{rotate(R, {1, 0, 0}), rotate(R, {0, 1, 0}),
                                           rotate(R, {0, 0, 1})};
  const auto entry = [&](std::size_t i, std::size_t k) { return dot(axes[i], stretched(axes[k])); };
  constexpr double kRounding = 1e-9;
  const double most = std::max({std::abs(s.x), std::abs(s.y), std::abs(s.z)});
  const bool is_scale = std::max({std::abs(entry(0, 1)), std::abs(entry(0, 2)),
                                  std::abs(entry(1, 2))}) <= kRounding * most;
  if (!is_scale && !mesh.vertices.empty()) {
    for (model::Vector3& v : mesh.vertices) v = stretched(rotate(R, v - p));
    mesh.scale.value = {1, 1, 1};
    return;
  }
  asset.sheared = !is_scale;
  const model::Vector3 back = stretched(rotate(R, p));
  asset.X_RM = {{-back.x, -back.y, -back.z}, R};
  const bool even = s.x == s.y && s.y == s.z;  // then to the last bit
  if (!even) mesh.scale.value = {entry(0, 0), entry(1, 1), entry(2, 2)};
}

MjcfMesh mesh_asset(const MjcfTree& tree, const MjcfSettings& settings, const MjcfValues& values) {
  MjcfMesh asset;
  asset.site = site_of(values.element());
  asset.mesh.scale = values.vector("scale", {1, 1, 1});
  const auto file = values.string("file");
  if (file.written) {
    asset.mesh.uri = file;
    asset.mesh.uri.value =
        mjcf_asset_path(tree, settings, values.element(), settings.mesh_folder, file.value);
  } else {
    add_vertices(values, asset.mesh);
    asset.built_in = values.text("builtin") || values.element().child("plugin");
  }
  const model::Vector3 p = values.vector("refpos", {}).value;
  const std::vector<double> q = values.numbers("refquat");
  model::Quaternion turn;
  if (q.size() == 4) turn = conjugate(model::normalized({q[0], q[1], q[2], q[3]}));
  place_reference(asset, p, turn);
  if (const auto law = values.text("inertia")) asset.law = mesh_law(law->text);
  asset.mesh.sheet = asset.law == Law::kShell;
  return asset;
}

}  // namespace

std::string mjcf_asset_path(const MjcfTree& tree, const MjcfSettings& settings,
                            xml::Element element, std::string_view folder, std::string_view file) {
  const std::string_view given = settings.strip_path ? file_name(file) : file;
  if (is_absolute(given)) return std::string(given);
  const std::string path = join_path(parent_path(tree.file().path), join_path(folder, given));
  const std::string_view here = parent_path(tree.path_of(element));
  return is_absolute(path) != is_absolute(here) ? path : relative_path(here, path);
}

MjcfAssets mjcf_assets(const MjcfTree& tree, const MjcfSettings& settings,
                       const MjcfDefaults& defaults) {
  MjcfAssets assets;
  for (const xml::Element element : tree.in_sections("asset")) {
    const std::string_view tag = element.name();
    const std::string class_name = mjcf_name(element, "class").value;
    const auto class_id = defaults.find(class_name).value_or(MjcfDefaults::kMain);
    const MjcfValues values = defaults.values(element, tag, class_id);
    const std::string name = asset_name(values);
    if (tag == "mesh") {
      assets.meshes.try_emplace(name, mesh_asset(tree, settings, values));
    } else if (tag == "hfield") {
      MjcfHeightField field;
      field.site = site_of(element);
      field.heightmap.uri = values.string("file");
      if (field.heightmap.uri.written) {
        field.heightmap.uri.value = mjcf_asset_path(tree, settings, element, settings.mesh_folder,
                                                    field.heightmap.uri.value);
      }
      const std::vector<double> n = values.numbers("size");
      if (n.size() == 4) field.heightmap.size = {{2 * n[0], 2 * n[1], n[2]}, {}, true};
      assets.height_fields.try_emplace(name, std::move(field));
    } else if (tag == "material") {
      MjcfMaterial material;
      material.site = site_of(element);
      const std::vector<double> n = values.numbers("rgba");
      if (n.size() == 4) material.rgba = {n[0], n[1], n[2], n[3]};
      assets.materials.try_emplace(name, material);
    } else if (tag == "model") {
      assets.models.try_emplace(name, element);
    }
  }
  return assets;
}

}  // namespace rigor::read
