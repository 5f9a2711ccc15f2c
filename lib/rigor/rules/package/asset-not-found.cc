// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/read/resolver.h>
#include <rigor/read/values.h>
#include <rigor/rules/package/assets.h>
#include <rigor/rules/package/missing_part.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/xml/xacro.h>
#include <rigor/text/path.h>

namespace rigor::rules::asset_not_found {

/// What Gazebo brings along: file://media/materials/scripts/gazebo.material; for actors and projectors
/// a bare name, as walk.dae.
bool is_of_gazebo(std::string_view uri, xml::Element element) {
  if (uri.starts_with("file://media/") || uri == "__default__") return true;
  if (uri.find('/') != std::string_view::npos) return false;
  const auto above = element.parent();
  if (element.name() != "filename") return above && above->name() == "projector";
  constexpr std::array<std::string_view, 9> kActors = {"moonwalk.dae", "run.dae",    "sit_down.dae",
                                                       "sitting.dae",  "stand.dae",  "stand_up.dae",
                                                       "talk_a.dae",   "talk_b.dae", "walk.dae"};
  return std::find(kActors.begin(), kActors.end(), uri) != kActors.end();
}

/// Of a path of one machine, and of what is no path, other rules speak.
bool is_reported_elsewhere(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  const std::string_view scheme = uri.substr(0, colon);
  const bool known = colon == std::string_view::npos || scheme == "model" || scheme == "package" ||
                     scheme == "file";
  const std::string_view path = uri.starts_with("file://") ? uri.substr(7) : uri;
  return !known || is_absolute(path) || uri.find('\\') != std::string_view::npos;
}

/// Puts the file's own spelling in, when only the last part of the URI differs.
std::optional<Fix> other_case(const read::Text& text, const read::Resolution& found) {
  const std::string_view written = file_name(found.tried.front().path);
  const std::string_view right = file_name(found.other_case);
  const std::size_t at = text.text.rfind(written);
  const bool same_folder = parent_path(found.tried.front().path) == parent_path(found.other_case);
  if (!same_folder || at == std::string_view::npos) return std::nullopt;
  Span span = text.span;
  span.begin += static_cast<std::uint32_t>(at);
  span.end = span.begin + static_cast<std::uint32_t>(written.size());
  return Fix{"write " + std::string(right), Applicability::kSafe, {{span, std::string(right)}}};
}

void check(const model::Root& /*root*/, Context& context) {
  for (const xml::Element element : context.elements_about_files()) {
    const std::string_view kind = kind_of_asset(element);
    if (kind.empty()) continue;
    const auto written = asset_uri(element);
    if (!written) continue;
    const std::string uri(read::trimmed(written->text));
    if (uri.empty() || has_xacro(uri) || is_of_gazebo(uri, element) || is_reported_elsewhere(uri)) {
      continue;
    }
    const read::Resolution& found = context.resolve(uri);
    if (found.path || found.remote) continue;
    Finding finding{.where = written->span,
                    .message = "the " + std::string(kind) + " '" + uri + "' is not found",
                    .cause = missing_part(uri, found, context),
                    .why = kind == "texture"
                               ? "The simulator draws the part without it, in one color."
                               : ""};
    if (!found.other_case.empty()) {
      finding.message += ", but '" + found.other_case + "' is: only the case of letters differs";
      finding.fix = other_case(*written, found);
    }
    context.report(std::move(finding));
  }
}

Rule rule() {
  return {
      .name = "asset-not-found",
      .severity = Severity::kWarning,
      .fix = FixGrade::kSafe,
      .summary = "a texture, height map, material script or skin is not found",
      .why = "The part is drawn without it, in one color; a heightmap or an actor is not drawn at "
             "all. The simulator logs one line. The checker (ign sdf -k, gz sdf -k) opens no such "
             "files.",
      .what_to_do =
          "Correct the path, or give the folders of the files: --model-path and --package, "
          "rigor.toml, GZ_SIM_RESOURCE_PATH. Gazebo's own media (file://media/…) are not checked.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::asset_not_found
