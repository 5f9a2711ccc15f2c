// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <set>

#include <rigor/report/page/json_page.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/text/base64.h>
#include <rigor/view/image/shrink.h>

namespace rigor::report {
namespace {

using view::Body;
using view::Picture;
using view::Surface;

std::string png_url(const Picture& picture) {
  return "data:image/png;base64," + base64(view::to_png(picture));
}

Json range_json(const ByteRange& range) { return {{"at", range.at}, {"bytes", range.bytes}}; }
Json range_json(const std::optional<ByteRange>& range) {
  return range ? range_json(*range) : Json(nullptr);
}

class SceneWriter {
 public:
  SceneWriter(const view::Drawing& drawing, PageFiles& files, PageBytes& bytes)
      : files_(files), bytes_(bytes) {
    for (const Body& body : drawing.bodies) {
      if (body.surfaces.size() > 1) in_parts_.insert(body.mesh.get());
      for (const Surface& surface : body.surfaces) {
        if (!surface.texture || body.mesh->corners.texture.empty()) continue;
        textured_.insert(body.mesh.get());
        pictures_.insert(surface.texture.get());
      }
    }
    while (texels() > kMaxPageTexels && side_ > 1) side_ /= 2;
  }

  void add(const Body& body) {
    body_index_.push_back(-1);
    const auto [known, is_new] = mesh_index_.try_emplace(body.mesh.get(), -1);
    if (is_new && triangles_ + body.mesh->triangles.size() <= kMaxPageTriangles) {
      known->second = static_cast<int>(meshes.size());
      meshes.push_back(mesh_json(*body.mesh));
    }
    if (known->second < 0) {
      not_drawn.push_back(
          {{"name", body.name},
           {"reason", "a page is limited to " + counted(kMaxPageTriangles, "triangle")}});
      return;
    }
    Json json = {{"layer", to_string(body.layer)},
                 {"name", body.name},
                 {"link", index_or_none(body.link)},
                 {"joint", index_or_none(body.joint)},
                 {"mesh", known->second},
                 {"pose", pose_array(body.pose)},
                 {"scale", vector_of(body.scale)},
                 {"surfaces", Json::array()}};
    for (const Surface& surface : body.surfaces)
      json["surfaces"].push_back(surface_json(surface, body));
    files_.place(json, body.where);
    body_index_.back() = static_cast<int>(bodies.size());
    bodies.push_back(std::move(json));
  }

  /// After all bodies.
  void add(const PageGhost& ghost) {
    const int body = body_index_[ghost.body];
    if (body < 0) return;
    ghosts.push_back({{"finding", ghost.finding},
                      {"body", body},
                      {"pose", pose_array(ghost.pose)},
                      {"scale", vector_of(ghost.scale)}});
  }

  Json bodies = Json::array();
  Json ghosts = Json::array();
  Json meshes = Json::array();
  Json textures = Json::array();
  Json not_drawn = Json::array();

 private:
  std::uint64_t texels() const {
    std::uint64_t sum = 0;
    for (const Picture* picture : pictures_) {
      const std::uint64_t longer = std::max({picture->width, picture->height, side_});
      sum += std::uint64_t{picture->width} * side_ / longer * picture->height * side_ / longer;
    }
    return sum;
  }

  Json mesh_json(const mesh::TriangleMesh& mesh) {
    const PageMesh packed =
        bytes_.add(mesh, textured_.contains(&mesh) ? Textured::kYes : Textured::kNo);
    triangles_ += packed.triangles;
    Json parts = Json::array();
    if (in_parts_.contains(&mesh)) {
      for (const mesh::Part& part : mesh.parts) {
        parts.push_back({{"first", part.first}, {"count", part.count}});
      }
    }
    return {{"vertices", packed.vertices},
            {"triangles", packed.triangles},
            {"low", vector_of(packed.low)},
            {"step", vector_of(packed.step)},
            {"positions", range_json(packed.positions)},
            {"normals", range_json(packed.normals)},
            {"uvs", range_json(packed.uvs)},
            {"colors", range_json(packed.colors)},
            {"indices", range_json(packed.indices)},
            {"parts", std::move(parts)}};
  }

  Json surface_json(const Surface& surface, const Body& body) {
    const view::Color& c = surface.color;
    const bool textured = surface.texture && !body.mesh->corners.texture.empty();
    return {{"color", Json::array({channel(c.r), channel(c.g), channel(c.b), channel(c.a)})},
            {"texture", textured ? texture_index(*surface.texture) : -1}};
  }

  /// A float as short as it was written.
  static Json channel(float value) {
    return finite(std::round(1e4 * static_cast<double>(value)) / 1e4);
  }

  int texture_index(const Picture& picture) {
    const auto [known, is_new] =
        texture_index_.try_emplace(&picture, static_cast<int>(textures.size()));
    if (is_new) textures.push_back(png_url(view::shrunk(picture, side_)));
    return known->second;
  }

  PageFiles& files_;
  PageBytes& bytes_;
  std::vector<int>
      body_index_;  // of each body of the drawing, that of the page; -1 for one that is left out
  std::size_t triangles_ = 0;
  std::uint32_t side_ = kPageTextureSide;
  std::set<const mesh::TriangleMesh*> in_parts_;
  std::set<const mesh::TriangleMesh*> textured_;
  std::set<const Picture*> pictures_;
  std::map<const mesh::TriangleMesh*, int> mesh_index_;
  std::map<const Picture*, int> texture_index_;
};

}  // namespace

void add_scene(Json& data, const ModelPage& page, PageFiles& files, PageBytes& bytes) {
  SceneWriter writer(page.drawing, files, bytes);
  for (const view::NotDrawn& missing : page.drawing.not_drawn) {
    writer.not_drawn.push_back({{"name", missing.name}, {"reason", missing.reason}});
  }
  for (const Body& body : page.drawing.bodies) writer.add(body);
  for (const PageGhost& ghost : page.ghosts) writer.add(ghost);
  data["bodies"] = std::move(writer.bodies);
  data["ghosts"] = std::move(writer.ghosts);
  data["meshes"] = std::move(writer.meshes);
  data["textures"] = std::move(writer.textures);
  data["pictures"] = Json::array();
  for (const PagePicture& each : page.pictures) {
    data["pictures"].push_back({{"view", each.view}, {"src", png_url(each.picture)}});
  }
  data["notDrawn"] = std::move(writer.not_drawn);
}

}  // namespace rigor::report
