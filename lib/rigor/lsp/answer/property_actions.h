// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Code actions on the properties of a template: a value becomes one, or one becomes its value again.

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <rigor/lsp/session/state.h>

namespace rigor::lsp {

/// Those for a selection. Their edits are made when one is chosen, as templates are expanded for the proof.
std::vector<Json> property_actions(State& state, OpenDocument& document, std::uint32_t begin,
                                   std::uint32_t end);

/// The edit of an action with that data; a RequestError when it cannot be made, nothing for other actions.
std::optional<Json> property_edit(State& state, OpenDocument& document, const Json& data);

}  // namespace rigor::lsp
