// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/answers.h>

#include <utility>

namespace rigor::lsp {
namespace {

constexpr std::pair<std::string_view, Answer> kAnswers[] = {
    {"textDocument/codeAction", code_actions},
    {"codeAction/resolve", resolved_code_action},
    {"textDocument/formatting", formatted_document},
    {"textDocument/rangeFormatting", formatted_range},
    {"textDocument/definition", definition},
    {"textDocument/references", references},
    {"textDocument/documentHighlight", highlights},
    {"textDocument/prepareRename", prepared_rename},
    {"textDocument/rename", rename},
    {"textDocument/completion", completion},
    {"textDocument/hover", hover},
    {"textDocument/documentSymbol", document_symbols},
    {"workspace/symbol", workspace_symbols},
    {"textDocument/foldingRange", folding_ranges},
    {"textDocument/selectionRange", selection_ranges},
    {"textDocument/documentLink", document_links},
    {"textDocument/documentColor", document_colors},
    {"textDocument/colorPresentation", color_presentations},
    {"textDocument/inlayHint", inlay_hints},
    {"textDocument/semanticTokens/full", semantic_tokens},
    {"textDocument/codeLens", code_lenses},
    {"textDocument/linkedEditingRange", linked_editing_ranges},
    {"textDocument/onTypeFormatting", typed_edits},
    {"textDocument/prepareCallHierarchy", prepared_call_hierarchy},
    {"callHierarchy/incomingCalls", incoming_calls},
    {"callHierarchy/outgoingCalls", outgoing_calls},
    {"rigor/expanded", expanded_template},
    {"rigor/explain", explained_rule},
};

}  // namespace

Answer find_answer(std::string_view method) {
  for (const auto& [name, answer] : kAnswers) {
    if (name == method) return answer;
  }
  return nullptr;
}

}  // namespace rigor::lsp
