// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a property's text means as a value, and what a condition's value means.

#pragma once

#include <optional>
#include <string_view>

#include <rigor/xacro/value/value.h>

namespace rigor::xacro {

class Heap;

/// A text in single quotes is what is between them; else the first of a whole number, a real number, a
/// truth value that it is; else the text itself. What holds `_` is a text. Other values stay.
Value literal_value(Heap& heap, Value value);

/// Of a condition: "true", "True", "false", "False", a whole number in a text; any other value's truth.
/// Nothing for other texts.
std::optional<bool> boolean_value(Heap& heap, Value value);

}  // namespace rigor::xacro
