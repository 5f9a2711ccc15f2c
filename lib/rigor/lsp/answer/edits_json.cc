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

Json workspace_edit(const State& state, const Sources& sources, const std::vector<Edit>& edits) {
  std::map<SourceId, std::vector<Edit>> by_source;
  for (const Edit& edit : edits) by_source[edit.span.source].push_back(edit);
  std::map<std::string, Json> by_uri;
  for (const auto& [source, of_source] : by_source) {
    const LineIndex lines(sources.bytes(source), state.client.encoding);
    by_uri[uri_of_file(state, sources.path(source))] = text_edits(lines, of_source);
  }
  return edit_of_documents(state, std::move(by_uri));
}

Json workspace_edit(const State& state, const OpenDocument& document,
                    const std::vector<Edit>& edits) {
  return edit_of_documents(state, {{document.uri(), text_edits(document.lines(), edits)}});
}

}  // namespace rigor::lsp
