// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a URI leads and every place that was tried, for `rigor resolve`.

#pragma once

#include <string>
#include <string_view>

#include <rigor/read/resolver.h>

namespace rigor::report {

/// The path alone on the first line when it is found, then the search.
std::string resolution_text(std::string_view uri, const read::Resolution& resolution);
std::string resolution_json(std::string_view uri, const read::Resolution& resolution);

}  // namespace rigor::report
