// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the pages of a database of results say of one model, and in the row of a list.
//
//   page += results_model(model, reader.details(model.id, {}), pages_of_rules);

#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/results/reader.h>

namespace rigor::report {

/// The number of a rule's page, by its name and severity.
using RulePages = std::map<std::pair<std::string, std::string>, std::size_t>;

/// A path on one line, cut where nobody reads on, as HTML that may be broken behind folders.
std::string results_path(std::string_view path);

/// "error": the class that colors a model and the word that is said.
std::string_view results_worst(results::Worst worst);

/// A section with `id="m17"`.
std::string results_model(const results::ModelRow& model, const results::ModelDetails& details,
                          const RulePages& rules);

}  // namespace rigor::report
