// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Findings as the protocol has them.

#pragma once

#include <map>
#include <string>
#include <vector>

#include <rigor/lsp/session/state.h>

namespace rigor::lsp {

/// Of a document, by the URI of the file that each stands in: those of a template stand where its author wrote
/// what is wrong. The document's own URI is among the keys, if only with an empty list.
std::map<std::string, std::vector<Json>> diagnostics_by_uri(State& state, OpenDocument& document,
                                                            const CheckedDocument& checked);

/// Where a finding of the document is shown, as a range in it; nothing when that is in another file.
bool stands_in(const OpenDocument& document, const CheckedDocument& checked,
               const Diagnostic& finding);

/// Equal for those that say the same of the same place.
std::string diagnostic_key(const Json& diagnostic);

Json diagnostic_json(const State& state, const Diagnostic& finding, PlacesJson& places);

}  // namespace rigor::lsp
