// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An expansion as the text that the reference prints: a banner, two blanks a level, attributes by name,
// a text alone in its element as it is.

#pragma once

#include <string>
#include <string_view>

#include <rigor/xacro/node.h>

namespace rigor::xacro {

/// `path` is the file's name in the banner, as it was given.
std::string print(const Node& document, std::string_view path);

}  // namespace rigor::xacro
