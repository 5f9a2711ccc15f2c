// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules that have been renamed: configuration, options, suppression comments and baselines may still have
// the former names.
//
//   const Rule* rule = registry.find(current_name("limit-stands-for-none"));

#pragma once

#include <string_view>
#include <vector>

namespace rigor::rules {

/// The name that a rule has now; any other name as it is.
std::string_view current_name(std::string_view name);

/// In alphabetical order.
std::vector<std::string_view> former_names();

}  // namespace rigor::rules
