// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The list of all rules; CMake writes its source from the files in this room's folders.

#pragma once

#include <vector>

#include <rigor/rules/rule.h>

namespace rigor::rules {

std::vector<Rule> registered_rules();

}  // namespace rigor::rules
