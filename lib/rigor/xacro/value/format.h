// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `'%.3f' % x`, `'{:.3f}'.format(x)` and `round(x, 3)`.

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <rigor/xacro/expression/evaluator.h>

namespace rigor::xacro {

/// Nothing on failure, which is recorded.
std::optional<std::string> format_percent(Evaluator& evaluator, std::string_view format,
                                          Value values);
std::optional<std::string> format_braces(Evaluator& evaluator, std::string_view format,
                                         const Arguments& arguments);

/// A real number to `digits` behind its point, which may be negative: half to even of its exact value.
double rounded(double d, int digits);

}  // namespace rigor::xacro
