// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/session/capabilities.h>

#include <rigor/lsp/answer/answers.h>
#include <rigor/lsp/protocol/uri.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

PositionEncoding encoding_of(const Json& params) {
  for (const Json& encoding : member(params, "capabilities", "general", "positionEncodings")) {
    if (encoding == "utf-8") return PositionEncoding::kUtf8;
  }
  return PositionEncoding::kUtf16;
}

}  // namespace

Client client_of(const Json& params) {
  Client client;
  client.encoding = encoding_of(params);
  const Json& capabilities = member(params, "capabilities");
  client.snippets =
      flag_at(capabilities, "textDocument", "completion", "completionItem", "snippetSupport");
  client.document_changes = flag_at(capabilities, "workspace", "workspaceEdit", "documentChanges");
  client.change_annotations =
      member(capabilities, "workspace", "workspaceEdit", "changeAnnotationSupport").is_object();
  for (const Json& operation :
       member(capabilities, "workspace", "workspaceEdit", "resourceOperations"))
    client.creates_files = client.creates_files || operation == "create";
  client.pulls_diagnostics = member(capabilities, "textDocument", "diagnostic").is_object();
  client.refreshes_diagnostics =
      flag_at(capabilities, "workspace", "diagnostics", "refreshSupport");
  client.registers_watchers =
      flag_at(capabilities, "workspace", "didChangeWatchedFiles", "dynamicRegistration");
  client.shows_pictures = flag_at(params, "initializationOptions", "pictures");
  for (const Json& command : member(params, "initializationOptions", "commands")) {
    if (command.is_string()) client.commands.push_back(command.get<std::string>());
  }
  client.rule_pages = text_at(params, "initializationOptions", "rulePages");
  for (const Json& folder : member(params, "workspaceFolders"))
    client.folders.push_back(normalize_path(path_of_uri(text_at(folder, "uri"))));
  const std::string root = text_at(params, "rootUri");
  if (client.folders.empty() && !root.empty())
    client.folders.push_back(normalize_path(path_of_uri(root)));
  return client;
}

Json server_capabilities(const Client& client) {
  Json capabilities{
      {"positionEncoding", client.encoding == PositionEncoding::kUtf8 ? "utf-8" : "utf-16"},
      {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", true}}},
      {"codeActionProvider",
       {{"codeActionKinds",
         {"quickfix", "refactor.rewrite", "refactor.extract", "refactor.inline",
          "source.fixAll.rigor"}},
        {"resolveProvider", true}}},
      {"documentFormattingProvider", true},
      {"documentRangeFormattingProvider", true},
      {"definitionProvider", true},
      {"referencesProvider", true},
      {"documentHighlightProvider", true},
      {"renameProvider", {{"prepareProvider", true}}},
      {"completionProvider", {{"triggerCharacters", {"<", "\"", "'", "/", ":", " ", "{", "="}}}},
      {"hoverProvider", true},
      {"documentSymbolProvider", true},
      {"workspaceSymbolProvider", true},
      {"foldingRangeProvider", true},
      {"selectionRangeProvider", true},
      {"documentLinkProvider", Json::object()},
      {"colorProvider", true},
      {"inlayHintProvider", true},
      {"semanticTokensProvider",
       {{"legend", {{"tokenTypes", semantic_token_types()}, {"tokenModifiers", {"declaration"}}}},
        {"full", true}}},
      {"codeLensProvider", Json::object()},
      {"linkedEditingRangeProvider", true},
      {"documentOnTypeFormattingProvider",
       {{"firstTriggerCharacter", ">"}, {"moreTriggerCharacter", {"/"}}}},
      {"callHierarchyProvider", true},
      {"workspace", {{"workspaceFolders", {{"supported", true}, {"changeNotifications", true}}}}},
  };
  if (client.pulls_diagnostics) {
    capabilities["diagnosticProvider"] = {{"interFileDependencies", true},
                                          {"workspaceDiagnostics", false}};
  }
  return capabilities;
}

}  // namespace rigor::lsp
