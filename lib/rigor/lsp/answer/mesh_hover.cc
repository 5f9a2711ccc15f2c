// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/mesh_hover.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include <rigor/lsp/document/analysis.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/report/number.h>
#include <rigor/text/base64.h>
#include <rigor/text/path.h>
#include <rigor/view/drawing/files.h>
#include <rigor/view/trace.h>
#include <rigor/xml/edit.h>

namespace rigor::lsp {
namespace {

/// Read and drawn in a tenth of a second.
constexpr std::uint64_t kMaxShownBytes = std::uint64_t{16} << 20U;

constexpr std::uint32_t kPictureWidth = 240;
constexpr std::uint32_t kPictureHeight = 180;
constexpr view::Color kHoverBackground{0.95F, 0.96F, 0.97F, 1};

/// The mesh as the only shape of a model, from the front, its left and above; nothing where it cannot be drawn.
std::optional<std::string> picture_of(const State& state, const std::string& path) {
  const Environment& environment = state.environment();
  const std::string model =
      "<sdf version='1.9'><model name='m'><link name='l'><visual name='v'><geometry><mesh><uri>" +
      xml::escaped(path) + "</uri></mesh></geometry></visual></link></model></sdf>";
  Analysis analysis(environment, join_path(parent_path(path), "picture.sdf"), model);
  mass::MeshReads reads(state.disk, environment.workers);
  const view::Files files = view::files_of(environment.resolver, analysis.sources(), reads);
  const view::Drawing drawing =
      view::draw(analysis.loaded().root, analysis.frames(), analysis.sources(), files,
                 {.layers = {view::Layer::kVisual}});
  if (drawing.bodies.empty()) return std::nullopt;
  const double aspect = static_cast<double>(kPictureWidth) / kPictureHeight;
  const view::Traced traced =
      view::trace(drawing, view::framing(drawing.bounds, view::View::kPerspective, aspect),
                  {.width = kPictureWidth,
                   .height = kPictureHeight,
                   .threads = 1,
                   .background = kHoverBackground});
  if (!traced.picture) return std::nullopt;
  return view::to_png(*traced.picture);
}

}  // namespace

bool is_mesh_path(std::string_view path) {
  static constexpr std::array<std::string_view, 5> kEndings{".stl", ".dae", ".obj", ".glb",
                                                            ".gltf"};
  return std::find(kEndings.begin(), kEndings.end(), extension(path)) != kEndings.end();
}

std::string mesh_text(const State& state, const std::string& path) {
  std::string text = fmt::format("**mesh** `{}`", file_name(path));
  const auto file = state.disk.open(path);
  if (!file) return text + ": cannot be read";
  const auto bytes = static_cast<double>(file->size());
  text += bytes < 1e6 ? fmt::format(", {} kB", report::number(bytes / 1e3, 3))
                      : fmt::format(", {} MB", report::number(bytes / 1e6, 3));
  if (file->size() > kMaxShownBytes) return text;
  const mass::MeshSurvey survey =
      mass::survey_mesh(state.disk, {path}, state.environment().workers);
  if (!survey.usable()) return text + ": damaged, as `rigor mesh-check` tells";
  const model::Vector3& min = survey.bounds.min;
  const model::Vector3& max = survey.bounds.max;
  text += fmt::format("\n\n{} triangles, {}; extents ({}) in the file's unit", survey.triangles,
                      survey.closed ? "closed" : "not closed",
                      report::numbers({max.x - min.x, max.y - min.y, max.z - min.z}, 4));
  if (!state.client.shows_pictures) return text;
  if (const auto png = picture_of(state, path))
    text +=
        "\n\n![" + std::string(file_name(path)) + "](data:image/png;base64," + base64(*png) + ')';
  return text;
}

}  // namespace rigor::lsp
