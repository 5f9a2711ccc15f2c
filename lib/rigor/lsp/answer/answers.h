// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Requests by their method.
//
//   if (const Answer answer = find_answer("textDocument/hover")) send(answer(state, params));

#pragma once

#include <string_view>

#include <rigor/lsp/protocol/json.h>
#include <rigor/lsp/session/state.h>

namespace rigor::lsp {

/// The result of a request; a RequestError when there is none.
using Answer = Json (*)(State& state, const Json& params);

/// Null for a method that is not served.
Answer find_answer(std::string_view method);

/// Names of the kinds of token that `semantic_tokens` counts in.
Json semantic_token_types();

Json code_actions(State& state, const Json& params);
Json resolved_code_action(State& state, const Json& params);
Json formatted_document(State& state, const Json& params);
Json formatted_range(State& state, const Json& params);
Json definition(State& state, const Json& params);
Json references(State& state, const Json& params);
Json highlights(State& state, const Json& params);
Json prepared_rename(State& state, const Json& params);
Json rename(State& state, const Json& params);
Json completion(State& state, const Json& params);
Json hover(State& state, const Json& params);
Json document_symbols(State& state, const Json& params);
Json workspace_symbols(State& state, const Json& params);
Json folding_ranges(State& state, const Json& params);
Json selection_ranges(State& state, const Json& params);
Json document_links(State& state, const Json& params);
Json document_colors(State& state, const Json& params);
Json color_presentations(State& state, const Json& params);
Json inlay_hints(State& state, const Json& params);
Json semantic_tokens(State& state, const Json& params);
Json code_lenses(State& state, const Json& params);
Json linked_editing_ranges(State& state, const Json& params);
Json typed_edits(State& state, const Json& params);
Json prepared_call_hierarchy(State& state, const Json& params);
Json incoming_calls(State& state, const Json& params);
Json outgoing_calls(State& state, const Json& params);
Json expanded_template(State& state, const Json& params);
Json explained_rule(State& state, const Json& params);

}  // namespace rigor::lsp
