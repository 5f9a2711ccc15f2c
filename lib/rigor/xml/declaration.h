// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The XML declaration, which tinyxml2 does not read.

#pragma once

#include <string>
#include <string_view>

namespace rigor::xml {

/// What is wrong with a declaration, as the end of a sentence; empty when nothing is. `inside` is what
/// stands between `<?xml` and `?>`. Source: XML 1.0 (fifth edition), production 23 XMLDecl.
std::string declaration_fault(std::string_view inside);

}  // namespace rigor::xml
