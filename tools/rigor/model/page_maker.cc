// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "model/page_maker.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <rigor/mass/mesh/cache.h>
#include <rigor/mass/mesh/facts.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/mesh_finder.h>
#include <rigor/rules/validate.h>
#include <rigor/text/path.h>
#include <rigor/view/camera.h>
#include <rigor/view/drawing/files.h>
#include <rigor/view/trace.h>

#include "model/model_file.h"
#include "model/render_model.h"
#include "option/rule_settings.h"
#include "option/selection.h"
#include "project/cache.h"

namespace rigor::tool {
namespace {

constexpr std::array kPageViews{view::View::kPerspective, view::View::kFront, view::View::kSide,
                                view::View::kTop};
constexpr PictureOptions kPagePicture{480, 320, 0};

std::set<view::Layer> all_layers() {
  std::set<view::Layer> layers;
  for (const std::string_view name : view::layer_names()) layers.insert(*view::layer_named(name));
  return layers;
}

/// What a picture shows of all that the page has: what one sees, and where there is nothing to see, what
/// collides.
view::Drawing pictured(const view::Drawing& drawing) {
  const auto has = [&](view::Layer layer) {
    return std::any_of(drawing.bodies.begin(), drawing.bodies.end(),
                       [layer](const view::Body& body) { return body.layer == layer; });
  };
  const view::Layer shown =
      has(view::Layer::kVisual) ? view::Layer::kVisual : view::Layer::kCollision;
  view::Drawing out{.bounds = drawing.bounds};
  for (const view::Body& body : drawing.bodies) {
    if (body.layer == shown || body.layer == view::Layer::kGround) out.bodies.push_back(body);
  }
  return out;
}

std::vector<report::PagePicture> pictures_of(const view::Drawing& drawing) {
  if (view::tracer().empty()) return {};
  const view::Drawing shown = pictured(drawing);
  std::vector<report::PagePicture> pictures;
  for (const view::View view : kPageViews) {
    pictures.push_back(
        {std::string(to_string(view)), ModelPainter::picture(shown, view, kPagePicture)});
  }
  return pictures;
}

/// One check of the model's file, and of the model.config that named it.
class PageCheck {
 public:
  PageCheck(const Disk& disk, const SearchOptions& search, const Environment& environment,
            mass::MeshReads& reads)
      : environment_(environment),
        settings_(selection_, search.config(), environment.registry),
        cache_(CacheOption().cache(environment.workers)),
        surveys_(disk, {cache_ ? &*cache_ : nullptr, &reads}),
        files_(disk, mass::MeshDepth::kFile, {cache_ ? &*cache_ : nullptr, &reads}) {}

  Diagnostics run(std::vector<std::string> paths, Sources& sources) {
    rules::ValidateOptions options;
    options.paths = std::move(paths);
    options.selection_for = [this](const std::string& path) { return settings_.selection(path); };
    options.known = {&surveys_, &files_};
    return rules::validate(environment_, options, sources).diagnostics;
  }

  mass::MeshSurveys& surveys() { return surveys_; }

 private:
  const Environment& environment_;
  SelectionOptions selection_;
  RuleSettings settings_;
  std::optional<mass::MeshCache> cache_;
  mass::MeshSurveys surveys_;
  mass::MeshFiles files_;
};

std::vector<std::string> paths_to_check(const Disk& disk, const std::string& named,
                                        const std::string& file) {
  std::string config = named;
  if (disk.kind(named) == PathKind::kFolder) config = join_path(named, "model.config");
  if (file_name(config) != "model.config" || config == file) return {file};
  return {file, config};
}

/// A page shows where the parts of so many findings would be; each of them is a model that is read and drawn.
constexpr std::size_t kMaxGhostFindings = 50;

/// The file with the first fix of a finding; nothing when it has none in the file alone.
std::optional<std::string> fixed_text(const Diagnostic& finding, const read::File& file,
                                      const Sources& sources) {
  if (finding.fixes.empty() || file.expanded) return std::nullopt;
  const Fix& fix = finding.fixes.front();
  // What is safe moves nothing.
  if (fix.applicability != Applicability::kUnsafe || fix.edits.empty()) return std::nullopt;
  for (const Edit& edit : fix.edits) {
    if (edit.span.nowhere() || sources.path(edit.span.source) != file.path) return std::nullopt;
  }
  return apply_edits(sources.bytes(fix.edits.front().span.source), fix.edits);
}

std::vector<report::PageGhost> ghosts_of(const Diagnostics& findings, const read::File& file,
                                         const view::Drawing& now, const Sources& sources,
                                         const Environment& environment, mass::MeshReads& reads) {
  std::vector<report::PageGhost> ghosts;
  std::size_t tried = 0;
  for (std::size_t i = 0; i < findings.list().size() && tried < kMaxGhostFindings; ++i) {
    const auto text = fixed_text(findings.list()[i], file, sources);
    if (!text) continue;
    ++tried;
    Sources other;
    read::Workspace workspace(environment.resolver, other);
    const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
    const read::Loaded loaded = read::load(reader, workspace.put(file.path, *text));
    const view::Drawing then = view::draw(loaded.root, model::Frames(loaded.root), other,
                                          view::files_of(environment.resolver, other, reads),
                                          {{view::Layer::kVisual, view::Layer::kCollision}});
    for (const report::PageGhost& ghost : report::ghosts_between(now, then, i))
      ghosts.push_back(ghost);
  }
  return ghosts;
}

}  // namespace

MadePage make_page(const Disk& disk, const SearchOptions& search, const std::string& path,
                   report::PageUse use) {
  Environment environment(disk, search.paths());
  search.allow(environment.workers);
  Sources sources;
  read::Workspace workspace(environment.resolver, sources);
  const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
  const read::Loaded loaded = read::load(reader, open_model(workspace, path));
  MadePage made{.path = loaded.file->path, .data = {}, .facts = {}, .problem = {}};
  const model::Format format = loaded.root.format;
  if (format != model::Format::kSdf && format != model::Format::kUrdf &&
      format != model::Format::kMjcf) {
    made.problem = "this is no robot model";
    return made;
  }
  mass::MeshReads reads(disk, environment.workers);
  PageCheck check(disk, search, environment, reads);
  const Diagnostics findings = check.run(paths_to_check(disk, path, made.path), sources);
  const model::Frames frames(loaded.root);
  const view::Files files = view::files_of(environment.resolver, sources, reads);
  const view::Drawing drawing = view::draw(loaded.root, frames, sources, files, {all_layers()});
  const report::ModelPage page{
      .path = made.path,
      .root = loaded.root,
      .frames = frames,
      .drawing = drawing,
      .findings = findings,
      .sources = sources,
      .find_mesh = rules::mesh_finder(environment.resolver, sources, check.surveys()),
      .pictures = pictures_of(drawing),
      .ghosts = ghosts_of(findings, *loaded.file, drawing, sources, environment, reads),
      .use = use};
  made.data = report::page_data(page);
  if (use == report::PageUse::kServed) made.facts = report::facts_of(page);
  return made;
}

}  // namespace rigor::tool
