// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Definition, references, highlights and renaming.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <rigor/author/names/template_rename.h>
#include <rigor/lsp/answer/answers.h>
#include <rigor/lsp/answer/edits_json.h>
#include <rigor/lsp/answer/name_lookup.h>
#include <rigor/lsp/answer/uri_at.h>
#include <rigor/lsp/document/srdf_elements.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

/// Of the protocol's DocumentHighlightKind.
constexpr int kReadHighlight = 2;
constexpr int kWriteHighlight = 3;

/// The document and a place in it that requests are about.
struct Cursor {
  OpenDocument& document;
  Analysis& analysis;  // the last text that could be read
  std::uint32_t offset;
};

Cursor cursor_of(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  Analysis& analysis = document.up_to_date(state.environment());
  return {document, analysis,
          document.to_readable(offset_in(document, member(params, "position")))};
}

Json location_json(const State& state, const Sources& sources, Span where) {
  const LineIndex lines(sources.bytes(where.source), state.client.encoding);
  return {{"uri", uri_of_file(state, sources.path(where.source))},
          {"range", range_json(lines, where)}};
}

/// Of a model that an include names, the file is open at its root.
Span defining_span(Analysis& analysis, const author::EntityId& id) {
  const author::NamedEntity& entity = analysis.names().entity(id);
  const Span where = entity.where.nowhere() ? entity.element : entity.where;
  return written_or_composed(analysis, analysis.names().file(id.path), where);
}

/// Each place once: those of one expression may be of several names.
void add_new(Json& list, Json location) {
  if (std::find(list.begin(), list.end(), location) == list.end())
    list.push_back(std::move(location));
}

/// Where the links and joints are defined whose name an expression composes; null for none.
Json composed_definitions(const State& state, const Cursor& cursor) {
  Json list = Json::array();
  const auto files = workspace_files(state, cursor.document);
  for (const NameAt& name : composed_names_at(cursor.analysis, cursor.offset, files)) {
    const Span where = defining_span(cursor.analysis, std::get<author::EntityId>(name.name));
    if (!where.nowhere()) add_new(list, location_json(state, cursor.analysis.sources(), where));
  }
  return list.empty() ? Json() : list;
}

/// The whole name that an expression composes; a RequestError where it composes several.
std::optional<NameAt> composed_name_at(Analysis& analysis, std::uint32_t offset,
                                       const std::vector<std::string>& files) {
  std::vector<NameAt> composed = composed_names_at(analysis, offset, files);
  std::string several;
  for (const NameAt& each : composed) {
    const auto& id = std::get<author::EntityId>(each.name);
    if (id == std::get<author::EntityId>(composed.front().name)) continue;
    several = "an expression composes '" + each.text + "', which is the name of several";
  }
  if (!several.empty()) throw RequestError(ErrorCode::kRequestFailed, several);
  if (composed.empty()) return std::nullopt;
  const auto& id = std::get<author::EntityId>(composed.front().name);
  composed.front().text = analysis.names().entity(id).name;
  return composed.front();
}

}  // namespace

Json definition(State& state, const Json& params) {
  const Cursor cursor = cursor_of(state, params);
  if (const auto path = path_at(state, cursor.analysis, cursor.offset)) {
    return {{"uri", uri_of_file(state, *path)},
            {"range", range_json(LineIndex("", state.client.encoding), 0, 0)}};
  }
  if (is_srdf(cursor.document.path()))
    add_robots(cursor.analysis.names(), workspace_files(state, cursor.document));
  const auto name = name_at(cursor.analysis, cursor.offset);
  if (!name) return composed_definitions(state, cursor);
  if (const auto* entity = std::get_if<author::EntityId>(&name->name)) {
    const Span where = defining_span(cursor.analysis, *entity);
    if (where.nowhere()) return nullptr;
    return location_json(state, cursor.analysis.sources(), where);
  }
  Json list = Json::array();
  for (const NamePlace& place : places_of(cursor.analysis, *name, {})) {
    if (place.defines) list.push_back(location_json(state, cursor.analysis.sources(), place.where));
  }
  return list;
}

Json references(State& state, const Json& params) {
  const Cursor cursor = cursor_of(state, params);
  Analysis fresh(state.environment(), cursor.analysis.path(), std::string(cursor.analysis.text()));
  const std::vector<std::string> files = workspace_files(state, cursor.document);
  add_robots(fresh.names(), files);
  std::vector<NameAt> names;
  if (auto name = name_at(fresh, cursor.offset)) {
    names.push_back(*std::move(name));
  } else {
    names = composed_names_at(fresh, cursor.offset, files);
  }
  Json list = Json::array();
  const bool with_definition = flag_at(params, "context", "includeDeclaration");
  for (const NameAt& name : names) {
    for (const NamePlace& place : places_of(fresh, name, files)) {
      if (with_definition || !place.defines)
        add_new(list, location_json(state, fresh.sources(), place.where));
    }
  }
  return list;
}

Json highlights(State& state, const Json& params) {
  const Cursor cursor = cursor_of(state, params);
  const auto name = name_at(cursor.analysis, cursor.offset);
  Json list = Json::array();
  if (!name) return list;
  for (const NamePlace& place : places_of(cursor.analysis, *name, {})) {
    if (normalize_path(cursor.analysis.sources().path(place.where.source)) !=
        normalize_path(cursor.document.path()))
      continue;
    const std::uint32_t begin = cursor.document.from_readable(place.where.begin);
    list.push_back(
        {{"range", range_json(cursor.document.lines(), begin, begin + place.where.size())},
         {"kind", place.defines ? kWriteHighlight : kReadHighlight}});
  }
  return list;
}

Json prepared_rename(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  Analysis& analysis = document.analysis(state.environment());
  if (!analysis.written().complete()) return nullptr;
  const std::uint32_t offset = offset_in(document, member(params, "position"));
  auto name = name_at(analysis, offset);
  if (!name) name = composed_name_at(analysis, offset, workspace_files(state, document));
  if (!name) return nullptr;
  return {{"range", range_json(document.lines(), name->where)}, {"placeholder", name->text}};
}

Json rename(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  Analysis fresh(state.environment(), document.path(), document.text());
  if (!fresh.written().complete())
    throw RequestError(ErrorCode::kRequestFailed, "the document is not well-formed XML");
  const author::WorkspaceFiles files = files_of_workspace(state, document);
  add_robots(fresh.names(), files.models);
  const std::uint32_t offset = offset_in(document, member(params, "position"));
  auto name = name_at(fresh, offset);
  if (!name) name = composed_name_at(fresh, offset, files.models);
  if (!name)
    throw RequestError(ErrorCode::kRequestFailed, "nothing here has a name that can be changed");
  const author::RenameContext context{fresh.names(), state.environment().resolver, fresh.sources()};
  const std::string new_name = text_at(params, "newName");
  std::vector<std::string> templates = files.models;
  templates.push_back(document.path());
  std::vector<std::string> all = files.models;
  all.insert(all.end(), files.texts.begin(), files.texts.end());
  const author::Renaming renaming =
      std::holds_alternative<author::EntityId>(name->name)
          ? author::renamed(context, std::get<author::EntityId>(name->name), new_name,
                            {{document.path()}, all})
          : author::renamed_in_templates(context, templates,
                                         std::get<author::TemplateName>(name->name), new_name);
  if (!renaming.refused.empty())
    throw RequestError(ErrorCode::kRequestFailed,
                       "'" + name->text + "' is not renamed: " + renaming.refused);
  std::vector<Edit> suspected;
  for (const Span where : renaming.suspected) suspected.push_back({where, new_name});
  return workspace_edit(state, fresh.sources(), renaming.edits,
                        {"may be the same name", std::move(suspected)});
}

}  // namespace rigor::lsp
