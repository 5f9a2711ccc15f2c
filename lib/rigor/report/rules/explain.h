// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// One rule's page, for `rigor explain`.

#pragma once

#include <string>

#include <rigor/rules/example.h>
#include <rigor/rules/rule.h>

namespace rigor::report {

/// What it is, why it matters, what to do, and its examples, the bytes it points at underlined.
std::string explain(const rules::Rule& rule, const rules::Examples& examples);

}  // namespace rigor::report
