// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A folder of pages to browse a database of results, of any number of models: totals by rule, a page for each rule and
// for each chunk of models, the worst first, and a search by name. The pages load nothing; only the search needs a
// script. The same database gives the same bytes.
//
//   const results::Reader reader("results.sqlite");
//   write_results_site(reader, [&](const SiteFile& file) { save(file.path, file.bytes); });

#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include <rigor/results/reader.h>

namespace rigor::report {

struct SiteFile {
  std::string path;  ///< "models/12.html": digits and letters of ours, never of a model
  std::string bytes;
};

/// A page of models ends at so many, or at so many bytes, whichever is first.
inline constexpr std::size_t kModelsPerPage = 200;
inline constexpr std::size_t kBytesPerPage = std::size_t{4} << 20U;

/// Names in one page of the search.
inline constexpr std::size_t kBytesPerSearch = std::size_t{12} << 20U;

/// Models that the page of a rule lists; the others are counted.
inline constexpr std::size_t kModelsPerRule = 2000;

/// No page is larger than 30 MB, whatever the models' names and messages. The index is the last, so that it never links
/// to what is not there yet. Throws what `reader` and `save` throw.
void write_results_site(const results::Reader& reader,
                        const std::function<void(const SiteFile&)>& save);

}  // namespace rigor::report
