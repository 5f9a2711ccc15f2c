// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The examples of all rules as the build embedded them; `example.h` is how they are asked for.

#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include <rigor/rules/example.h>

namespace rigor::rules {

enum class ExampleKind : std::uint8_t { kBad, kGood };

struct EmbeddedExample {
  std::string_view owner;  ///< the rule, or the category
  ExampleKind kind;
  Example example;
};

/// Those of one owner and kind are together, in the order of their numbers.
std::span<const EmbeddedExample> embedded_examples();

}  // namespace rigor::rules
