// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The baseline that a project is configured with, with one entry more (rules/baseline.h).

#pragma once

#include <rigor/lsp/session/state.h>

namespace rigor::lsp {

/// A code action that adds all findings of a rule in the document to the baseline, since a baseline counts those of a
/// file; null where no baseline is configured, or the client cannot make the file that is not there yet.
Json baseline_action(const State& state, const OpenDocument& document,
                     const CheckedDocument& checked, const Diagnostic& finding);

}  // namespace rigor::lsp
