// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// "Did you mean": the candidates that a mistyped name was probably meant to be.
//
//   std::vector<std::string_view> names;
//   for (Node child : link.children()) names.push_back(child.name());
//   near("colision", names);  // {"collision"}
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace rigor::schema {

constexpr std::size_t kMaxSuggestions = 3;  // a longer list is not read

// At most three candidates, the nearest first and ties in the given order: those that are equal but
// for the case of letters; then those at most two edits away, an edit being a byte inserted,
// removed, replaced or swapped with its neighbor. A short name must be nearer: one edit for up to
// four bytes, none below three.
std::vector<std::string_view> near(std::string_view name,
                                   const std::vector<std::string_view>& candidates);

// Edits from one text to the other, case of ASCII letters ignored; `limit` + 1 when there are more
// than `limit`. Optimal string alignment: Damerau (1964) without edits inside a swapped pair.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

}  // namespace rigor::schema
