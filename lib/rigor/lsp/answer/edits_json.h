// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Byte edits as the protocol has them.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/lsp/session/state.h>
#include <rigor/text/edit.h>

namespace rigor::lsp {

/// Edits of one text.
Json text_edits(const LineIndex& lines, const std::vector<Edit>& edits);

/// Edits that a person has to confirm one by one, and why.
struct DoubtfulEdits {
  std::string reason;
  std::vector<Edit> edits;
};

/// Edits of any number of files, as a WorkspaceEdit: with the versions of open documents where the client takes
/// them. Doubtful ones are left out where the client cannot ask.
Json workspace_edit(const State& state, const Sources& sources, const std::vector<Edit>& edits,
                    const DoubtfulEdits& doubtful = {});

/// Edits of one document, whose offsets count in its text.
Json workspace_edit(const State& state, const OpenDocument& document,
                    const std::vector<Edit>& edits);

/// The URI that the client has for a file, when it is open; else the path's.
std::string uri_of_file(const State& state, std::string_view path);

}  // namespace rigor::lsp
