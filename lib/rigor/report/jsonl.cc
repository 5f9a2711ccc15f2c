// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/jsonl.h>

#include <map>
#include <string_view>

#include <rigor/report/json/diagnostic.h>
#include <rigor/report/json/file.h>
#include <rigor/report/json/values.h>

namespace rigor::report {
namespace {

using Reasons = std::map<std::string_view, Json>;  // what of a file was not examined, by its path

Reasons reasons_of(const rules::ValidateResult& result) {
  Reasons reasons;
  for (const rules::NotLookedAt& item : result.not_looked_at) {
    if (item.index) continue;  // a file of its own
    Json& list = reasons[item.path];
    if (list.is_null()) list = Json::array();
    list.push_back(item.what);
  }
  return reasons;
}

Json mesh_json(const mass::OpenedMesh& mesh) {
  Json json = {{"path", mesh.path},
               {"digest", mesh.digest},
               {"bytes", mesh.bytes},
               {"triangles", mesh.triangles ? Json(*mesh.triangles) : Json(nullptr)},
               {"extents", nullptr}};
  if (mesh.min && mesh.max)
    json["extents"] = {{"min", vector_of(*mesh.min)}, {"max", vector_of(*mesh.max)}};
  return json;
}

std::string line_of(const rules::FileSummary& file, const Validation& validation,
                    const Reasons& reasons, Places& places) {
  const rules::ValidateResult& result = validation.result;
  Json line = {{"case", {{"index", file.index}, {"of", result.all_files}, {"id", file.path}}}};
  line.update(file_json(file));
  const auto reason = reasons.find(file.path);
  line["not_looked_at"] = reason == reasons.end() ? Json::array() : reason->second;
  line["meshes"] = Json::array();
  for (const mass::OpenedMesh& mesh : file.meshes) line["meshes"].push_back(mesh_json(mesh));
  line["diagnostics"] = Json::array();
  for (std::size_t i = file.first_finding; i < file.end_finding; ++i) {
    line["diagnostics"].push_back(diagnostic_json(result.diagnostics.list()[i], places));
  }
  return line.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// A file that was left out, in the shape of the others.
std::string line_of(const rules::NotLookedAt& item, const Validation& validation) {
  Json line = {
      {"case", {{"index", *item.index}, {"of", validation.result.all_files}, {"id", item.path}}}};
  line.update(file_json({.path = item.path}));
  line["not_looked_at"] = Json::array({item.what});
  line["meshes"] = Json::array();
  line["diagnostics"] = Json::array();
  return line.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string jsonl(const Validation& ungrouped) {
  const rules::ValidateResult result = grouped(ungrouped.result, GroupScope::kFile);
  const Validation validation{result, ungrouped.sources, ungrouped.registry, ungrouped.folders,
                              ungrouped.exit_code};
  const Reasons reasons = reasons_of(validation.result);
  Places places(validation.sources);
  std::string out;
  for (const rules::FileSummary& file : validation.result.files) {
    out += line_of(file, validation, reasons, places);
  }
  for (const rules::NotLookedAt& item : validation.result.not_looked_at) {
    if (item.index) out += line_of(item, validation);
  }
  return out;
}

}  // namespace rigor::report
