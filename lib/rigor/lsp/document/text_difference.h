// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where two texts differ.
//
//   TextChange change = difference("<link/>", "<link a/>");   // {.begin = 5, .end = 5, .size = 2}

#pragma once

#include <string_view>

#include <rigor/lsp/document/moving_place.h>

namespace rigor::lsp {

/// The bytes of `before` that became others in `after`, without what both begin with, then end with. Nothing is
/// between `begin` and `end`, and `size` is 0, when the texts are equal.
TextChange difference(std::string_view before, std::string_view after);

}  // namespace rigor::lsp
