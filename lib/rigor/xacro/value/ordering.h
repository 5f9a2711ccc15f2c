// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Sorting as Python sorts: stable, by keys, in either direction.

#pragma once

#include <optional>
#include <vector>

#include <rigor/xacro/expression/evaluator.h>

namespace rigor::xacro {

/// `key` of each item; the items themselves when it is None. Nothing on failure.
std::optional<std::vector<Value>> keys_of(Evaluator& evaluator, const std::vector<Value>& items,
                                          Value key);

/// In place, by the named arguments `key` and `reverse`; false on failure.
bool sort_values(Evaluator& evaluator, std::vector<Value>& items, const Arguments& arguments);

}  // namespace rigor::xacro
