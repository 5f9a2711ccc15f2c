// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/json/json.h>

#include <string_view>

#include <rigor/report/json/diagnostic.h>
#include <rigor/report/json/file.h>
#include <rigor/report/tool.h>
#include <rigor/report/validation.h>

namespace rigor::report {
namespace {

std::string_view kind(model::Format format) {
  switch (format) {
    case model::Format::kSdf: return "sdf";
    case model::Format::kUrdf: return "urdf";
    case model::Format::kModelConfig: return "model-config";
    case model::Format::kMjcf: return "mjcf";
    case model::Format::kUnknown: break;
  }
  return "unknown";
}

Json summary_of(const rules::ValidateResult& result) {
  return {{"files", result.files.size()},
          {"errors", result.diagnostics.count(Severity::kError)},
          {"warnings", result.diagnostics.count(Severity::kWarning)},
          {"infos", result.diagnostics.count(Severity::kInfo)},
          {"not_looked_at", result.not_looked_at.size()},
          {"places", result.diagnostics.places()}};
}

}  // namespace

Json file_json(const rules::FileSummary& file) {
  return {{"path", file.path},     {"kind", kind(file.format)}, {"version", file.version},
          {"models", file.models}, {"links", file.links},       {"joints", file.joints}};
}

std::string json(const rules::ValidateResult& each, const Sources& sources) {
  const rules::ValidateResult result = grouped(each, GroupScope::kRun);
  Json files = Json::array();
  for (const rules::FileSummary& file : result.files) files.push_back(file_json(file));
  const Json document = {{"tool", {{"name", kToolName}, {"version", tool_version()}}},
                         {"schema_version", kSchemaVersion},
                         {"summary", summary_of(result)},
                         {"files", std::move(files)},
                         {"diagnostics", diagnostics_of(result.diagnostics, sources)}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rigor::report
