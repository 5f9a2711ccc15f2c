// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What xacro's own tags do, which no schema of a model has.

#pragma once

#include <string_view>

namespace rigor::lsp {

/// Whether the element is xacro's: a tag of its own or the call of a macro.
bool is_of_xacro(std::string_view element);

/// A sentence on `xacro:include`; empty for the call of a macro.
std::string_view xacro_tag_text(std::string_view element);

}  // namespace rigor::lsp
