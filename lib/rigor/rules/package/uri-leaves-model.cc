// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/rules/package/uris.h>
#include <rigor/rules/rule.h>
#include <rigor/text/disk.h>
#include <rigor/text/path.h>

namespace rigor::rules::uri_leaves_model {

/// Whether the path climbs out of the folder it begins in.
bool climbs_out(std::string_view path) { return normalize_path(path).starts_with("../"); }

void check(const model::Root& /*root*/, Context& context) {
  bool is_in_model = false;
  bool looked = false;
  for (const Uri& uri : context.uris()) {
    if (uri.text.find("..") == std::string_view::npos ||
        uri.text.find(':') != std::string_view::npos)
      continue;
    if (is_absolute(uri.text) || !climbs_out(uri.text)) continue;
    if (!looked) {
      const std::string config = join_path(context.folder(), "model.config");
      is_in_model = context.disk().kind(config) == PathKind::kFile;
    }
    looked = true;
    if (!is_in_model) return;
    context.report({.where = uri.where,
                    .message = "'" + std::string(uri.text) + "' leaves the folder of the model"});
  }
}

Rule rule() {
  return {
      .name = "uri-leaves-model",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a model names a file outside its own folder",
      .why = "A folder with a model.config is what is copied, put on Fuel and found by model://. "
             "Elsewhere it has other neighbors, and the file is not found.",
      .what_to_do = "Name the other model, as in model://wheel/meshes/rim.dae, or copy the file.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::uri_leaves_model
