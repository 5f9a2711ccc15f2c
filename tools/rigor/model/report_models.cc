// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "model/report_models.h"

#include <map>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/rules/mesh_finder.h>
#include <rigor/view/drawing/files.h>
#include <rigor/view/image/shrink.h>

#include "model/render_model.h"

namespace rigor::tool {
namespace {

/// Each mesh once for each kind of shape, in the order of the file.
class MeshUses {
 public:
  explicit MeshUses(const view::Files& files) : files_(files) {}

  void add(const model::Geometry& geometry, bool collision) {
    const auto* mesh = std::get_if<model::Mesh>(&geometry.shape);
    if (mesh == nullptr) return;
    const std::string path = files_.resolve(mesh->uri.value, mesh->uri.span);
    const auto key =
        std::tuple(path.empty() ? mesh->uri.value : path, mesh->submesh.value, collision);
    const auto [known, is_new] = places_.try_emplace(key, uses_.size());
    if (!is_new) {
      ++uses_[known->second].times;
      return;
    }
    std::string why;
    const auto triangles = files_.mesh(*mesh, why);
    uses_.push_back({mesh->uri.value, collision});
    if (triangles) uses_.back().triangles = triangles->triangles.size();
  }

  std::vector<report::MeshUse> take() { return std::move(uses_); }

 private:
  const view::Files& files_;
  std::map<std::tuple<std::string, std::string, bool>, std::size_t> places_;
  std::vector<report::MeshUse> uses_;
};

std::string name_of(const model::Root& root) {
  if (root.worlds.size() == 1) return root.worlds[0].name.value;
  const auto models = report::top_models(root);
  return models.size() == 1 ? root[models[0]].name.value : "";
}

}  // namespace

bool GatheredModel::whole() const {
  return loaded.file != nullptr && loaded.file->document && loaded.file->document->complete() &&
         loaded.root.format != model::Format::kUnknown;
}

ModelGatherer::ModelGatherer(Checking& checking, Sources& sources)
    : checking_(checking),
      sources_(sources),
      workspace_(checking.environment().resolver, sources) {}

GatheredModel ModelGatherer::gather(const std::string& path, Pictures pictures) {
  const Environment& environment = checking_.environment();
  const read::Reader reader{workspace_, environment.resolver, environment.sdf, environment.urdf};
  GatheredModel model;
  const read::File& file = workspace_.open(path);
  if (!file.document) {
    model.told.not_drawn.push_back(file.problem);
    return model;
  }
  model.loaded = read::load(reader, file);
  const model::Root& root = model.loaded.root;
  const model::Frames frames(root);
  const report::Inspection inspection{
      path, root, frames, rules::mesh_finder(environment.resolver, sources_, checking_.surveys())};
  model.told.name = name_of(root);
  for (const model::Id<model::Model> top : report::top_models(root)) {
    model.told.models.push_back({root[top].name.value, report::totals(inspection, top)});
  }
  const view::Files files = view::files_of(environment.resolver, sources_, checking_.reads());
  MeshUses uses(files);
  for (const model::Visual& visual : root.visuals) uses.add(visual.geometry, false);
  for (const model::Collision& collision : root.collisions) uses.add(collision.geometry, true);
  model.told.meshes = uses.take();
  if (pictures == Pictures::kDraw) draw(model, frames, files);
  return model;
}

void ModelGatherer::draw(GatheredModel& model, const model::Frames& frames,
                         const view::Files& files) const {
  // Of what has nothing to see, what it collides with is better than nothing.
  const model::Root& root = model.loaded.root;
  const view::Layer layer = root.visuals.empty() ? view::Layer::kCollision : view::Layer::kVisual;
  const view::Drawing drawing =
      view::draw(root, frames, sources_, files, {{layer, view::Layer::kGround}});
  for (const view::NotDrawn& missing : drawing.not_drawn) {
    model.told.not_drawn.push_back(missing.name + ": " + missing.reason);
  }
  const std::string nothing = why_nothing_is_seen(model.loaded, drawing);
  if (!nothing.empty()) {
    model.told.not_drawn.insert(model.told.not_drawn.begin(), nothing);
    return;
  }
  const view::Picture picture =
      ModelPainter::picture(drawing, view::View::kPerspective,
                            {report::kReportPictureWidth, report::kReportPictureHeight, 1});
  model.told.picture = view::to_png(picture);
  model.told.thumbnail =
      view::to_png(view::shrunk(picture, report::kReportPictureWidth / report::kThumbnailShare));
}

}  // namespace rigor::tool
