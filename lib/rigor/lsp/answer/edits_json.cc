// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/edits_json.h>

#include <map>
#include <string>
#include <utility>

#include <rigor/lsp/protocol/uri.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

constexpr std::string_view kDoubtful = "doubtful";

Json edit_of_documents(const State& state, std::map<std::string, Json> by_uri) {
  if (!state.client.document_changes) {
    Json changes = Json::object();
    for (auto& [uri, edits] : by_uri) changes[uri] = std::move(edits);
    return {{"changes", std::move(changes)}};
  }
  Json changes = Json::array();
  for (auto& [uri, edits] : by_uri) {
    const auto open = state.documents.find(uri);
    Json version = nullptr;
    if (open != state.documents.end()) version = open->second->version();
    changes.push_back({{"textDocument", {{"uri", uri}, {"version", std::move(version)}}},
                       {"edits", std::move(edits)}});
  }
  return {{"documentChanges", std::move(changes)}};
}

}  // namespace

std::string uri_of_file(const State& state, std::string_view path) {
  const std::string normal = normalize_path(path);
  for (const auto& [uri, document] : state.documents) {
    if (normalize_path(document->path()) == normal) return uri;
  }
  return uri_of_path(normal);
}

Json text_edits(const LineIndex& lines, const std::vector<Edit>& edits) {
  Json list = Json::array();
  for (const Edit& edit : edits)
    list.push_back({{"range", range_json(lines, edit.span)}, {"newText", edit.text}});
  return list;
}

Json workspace_edit(const State& state, const Sources& sources, const std::vector<Edit>& edits,
                    const DoubtfulEdits& doubtful) {
  std::map<std::string, Json> by_uri;
  const bool can_ask = state.client.document_changes && state.client.change_annotations;
  const auto add = [&](const std::vector<Edit>& list, std::string_view annotation) {
    std::map<SourceId, std::vector<Edit>> by_source;
    for (const Edit& edit : list) by_source[edit.span.source].push_back(edit);
    for (const auto& [source, of_source] : by_source) {
      const LineIndex lines(sources.bytes(source), state.client.encoding);
      Json& all =
          by_uri.try_emplace(uri_of_file(state, sources.path(source)), Json::array()).first->second;
      for (Json& edit : text_edits(lines, of_source)) {
        if (!annotation.empty()) edit["annotationId"] = annotation;
        all.push_back(std::move(edit));
      }
    }
  };
  add(edits, {});
  if (can_ask) add(doubtful.edits, kDoubtful);
  Json edit = edit_of_documents(state, std::move(by_uri));
  if (can_ask && !doubtful.edits.empty()) {
    edit["changeAnnotations"][std::string(kDoubtful)] = {{"label", doubtful.reason},
                                                         {"needsConfirmation", true}};
  }
  return edit;
}

Json workspace_edit(const State& state, const OpenDocument& document,
                    const std::vector<Edit>& edits) {
  return edit_of_documents(state, {{document.uri(), text_edits(document.lines(), edits)}});
}

}  // namespace rigor::lsp
