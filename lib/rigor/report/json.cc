// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/json.h>

#include <string_view>

#include <nlohmann/json.hpp>

#include <rigor/report/places.h>
#include <rigor/report/tool.h>

namespace rigor::report {
namespace {

using Json = nlohmann::ordered_json;

std::string_view kind(model::Format format) {
  switch (format) {
    case model::Format::kSdf: return "sdf";
    case model::Format::kUrdf: return "urdf";
    case model::Format::kModelConfig: return "model-config";
    case model::Format::kUnknown: break;
  }
  return "unknown";
}

Json summary_of(const rules::ValidateResult& result) {
  return {{"files", result.files.size()},
          {"errors", result.diagnostics.count(Severity::kError)},
          {"warnings", result.diagnostics.count(Severity::kWarning)},
          {"infos", result.diagnostics.count(Severity::kInfo)},
          {"not_looked_at", result.not_looked_at.size()}};
}

Json file_of(const rules::FileSummary& file) {
  return {{"path", file.path},     {"kind", kind(file.format)}, {"version", file.version},
          {"models", file.models}, {"links", file.links},       {"joints", file.joints}};
}

void add_place(Json& json, Span span, std::string_view path, Places& places) {
  json["path"] = span.nowhere() ? path : places.path(span);
  if (span.nowhere()) {
    for (const char* key : {"line", "column", "end_line", "end_column"}) json[key] = nullptr;
    return;
  }
  const Position begin = places.begin(span);
  const Position end = places.end(span);
  json["line"] = begin.line;
  json["column"] = begin.column;
  json["end_line"] = end.line;
  json["end_column"] = end.column;
}

Json fix_of(const Diagnostic& diagnostic) {
  if (diagnostic.fixes.empty()) return nullptr;
  const Fix& fix = diagnostic.fixes.front();
  Json edits = Json::array();
  for (const Edit& edit : fix.edits) {
    edits.push_back({{"begin", edit.span.begin}, {"end", edit.span.end}, {"text", edit.text}});
  }
  return {{"title", fix.title}, {"applicability", to_string(fix.applicability)}, {"edits", edits}};
}

Json diagnostic_of(const Diagnostic& diagnostic, Places& places) {
  Json json = {{"rule", diagnostic.rule},
               {"category", diagnostic.category},
               {"severity", to_string(diagnostic.severity)},
               {"message", diagnostic.message}};
  add_place(json, diagnostic.where, diagnostic.path, places);
  json["subject"] = diagnostic.subject;
  json["related"] = Json::array();
  for (const Label& label : diagnostic.related) {
    Json related = {{"message", label.message}};
    add_place(related, label.where, diagnostic.path, places);
    json["related"].push_back(std::move(related));
  }
  json["fix"] = fix_of(diagnostic);
  return json;
}

}  // namespace

std::string json(const rules::ValidateResult& result, const Sources& sources) {
  Places places(sources);
  Json files = Json::array();
  for (const rules::FileSummary& file : result.files) files.push_back(file_of(file));
  Json diagnostics = Json::array();
  for (const Diagnostic& diagnostic : result.diagnostics.list()) {
    diagnostics.push_back(diagnostic_of(diagnostic, places));
  }
  const Json document = {{"tool", {{"name", kToolName}, {"version", tool_version()}}},
                         {"schema_version", kSchemaVersion},
                         {"summary", summary_of(result)},
                         {"files", std::move(files)},
                         {"diagnostics", std::move(diagnostics)}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rigor::report
