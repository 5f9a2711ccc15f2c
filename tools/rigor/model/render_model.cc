// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "model/render_model.h"

#include <algorithm>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/view/drawing/files.h>

#include "command/command.h"
#include "model/model_file.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

/// Off white, so that a white robot has an outline.
constexpr view::Color kBackdrop{0.95F, 0.96F, 0.97F, 1};

bool can_be_seen(const view::Body& body) {
  return body.layer != view::Layer::kGround &&
         std::any_of(body.surfaces.begin(), body.surfaces.end(),
                     [](const view::Surface& surface) { return surface.color.a > 0; });
}

}  // namespace

std::string why_nothing_is_seen(const read::Loaded& loaded, const view::Drawing& drawing) {
  const std::vector<view::Body>& bodies = drawing.bodies;
  if (std::any_of(bodies.begin(), bodies.end(), can_be_seen)) return {};
  if (loaded.root.format == model::Format::kUnknown) return "this is no robot model";
  if (!loaded.file->document->complete()) return "it is not well-formed";
  if (!drawing.not_drawn.empty()) return "nothing of it can be drawn";
  const bool hidden = std::any_of(bodies.begin(), bodies.end(), [](const view::Body& body) {
    return body.layer != view::Layer::kGround;
  });
  if (hidden) return "all that is drawn of it is wholly transparent";
  return "there is nothing to draw of the layers asked for";
}

ModelPainter::ModelPainter(const Disk& disk, const Environment& environment)
    : disk_(disk), environment_(environment), reads_(disk, environment.workers) {}

DrawnModel ModelPainter::draw(const std::string& path, const std::vector<std::string>& joints,
                              const std::set<view::Layer>& layers) {
  Sources sources;
  read::Workspace workspace(environment_.resolver, sources);
  const read::Reader reader{workspace, environment_.resolver, environment_.sdf, environment_.urdf};
  const read::Loaded loaded = read::load(reader, open_model(workspace, path));
  const model::Frames frames(loaded.root, joint_positions(loaded.root, joints));
  DrawnModel drawn{path, {}, {}};
  const view::Files files = view::files_of(environment_.resolver, sources, reads_);
  drawn.drawing = view::draw(loaded.root, frames, sources, files, {layers});
  drawn.problem = why_nothing_is_seen(loaded, drawn.drawing);
  return drawn;
}

view::Picture ModelPainter::picture(const view::Drawing& drawing, view::View view,
                                    const PictureOptions& options) {
  return picture(drawing, view, drawing.bounds, options);
}

view::Picture ModelPainter::picture(const view::Drawing& drawing, view::View view,
                                    const mesh::Bounds& bounds, const PictureOptions& options) {
  const double aspect = static_cast<double>(options.width) / options.height;
  view::Traced traced = view::trace(drawing, view::framing(bounds, view, aspect),
                                    {.width = options.width,
                                     .height = options.height,
                                     .threads = options.threads,
                                     .background = kBackdrop});
  if (!traced.picture) throw UsageError("no image: " + traced.problem);
  return std::move(*traced.picture);
}

void say_what_is_missing(const DrawnModel& drawn, std::size_t most) {
  const std::vector<view::NotDrawn>& missing = drawn.drawing.not_drawn;
  const std::size_t said = std::min(most, missing.size());
  for (std::size_t i = 0; i < said; ++i) {
    say("rigor: " + report::printable(drawn.path + ": " + missing[i].name) +
        " is not drawn: " + report::printable(missing[i].reason));
  }
  if (said < missing.size()) {
    say("rigor: " + report::printable(drawn.path) + ": nor " +
        report::counted(missing.size() - said, "other shape"));
  }
  if (!drawn.problem.empty()) {
    say("rigor: " + report::printable(drawn.path + ": " + drawn.problem));
  }
}

mesh::Bounds around(const mesh::Bounds& a, const mesh::Bounds& b) {
  const auto empty = [](const mesh::Bounds& bounds) { return bounds.min.x > bounds.max.x; };
  if (empty(a)) return b;
  if (empty(b)) return a;
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

}  // namespace rigor::tool
