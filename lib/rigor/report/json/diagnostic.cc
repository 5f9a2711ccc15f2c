// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/json/diagnostic.h>

#include <string>
#include <string_view>
#include <utility>

namespace rigor::report {
namespace {

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

Json origin_json(const Diagnostic& diagnostic, Places& places) {
  Json origin = Json::array();
  for (const MacroCall& call : diagnostic.origin) {
    Json one = {{"macro", call.macro}, {"path", nullptr}, {"line", nullptr}, {"column", nullptr}};
    if (!call.where.nowhere()) {
      const Position begin = places.begin(call.where);
      one["path"] = places.path(call.where);
      one["line"] = begin.line;
      one["column"] = begin.column;
    }
    one["params"] = Json::object();
    for (const auto& [name, value] : call.params) one["params"][name] = value;
    origin.push_back(std::move(one));
  }
  return origin;
}

/// Another place of a group, with what is its own.
Json place_json(const Diagnostic& other, Places& places) {
  Json json = Json::object();
  add_place(json, other.where, other.path, places);
  json["subject"] = other.subject;
  json["message"] = other.message;
  json["fix"] = fix_of(other);
  json["origin"] = origin_json(other, places);
  return json;
}

}  // namespace

Json diagnostic_json(const Diagnostic& diagnostic, Places& places) {
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
  json["why"] = why_of(diagnostic);
  json["help"] = help_of(diagnostic);
  json["docs"] = "rules/" + std::string(diagnostic.rule) + ".md";
  json["places"] = Json::array();
  for (const Diagnostic& other : diagnostic.others) {
    json["places"].push_back(place_json(other, places));
  }
  json["origin"] = origin_json(diagnostic, places);
  return json;
}

Json diagnostics_of(const Diagnostics& diagnostics, const Sources& sources) {
  Places places(sources);
  Json list = Json::array();
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    list.push_back(diagnostic_json(diagnostic, places));
  }
  return list;
}

}  // namespace rigor::report
