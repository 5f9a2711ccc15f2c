// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The page that finds models by words of their path.
//
//   ResultsSearch search(save);
//   search.add(model, page);
//   search.finish();

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include <rigor/report/results/results_site.h>

namespace rigor::report {

/// Well-formed inside XML as it is: neither `<` nor `&`.
std::string_view results_search_script();

/// Of the script, as a content security policy names it: "sha256-…".
std::string_view results_search_script_hash();

/// Names are written page by page; no more than one page of them is in memory.
class ResultsSearch {
 public:
  explicit ResultsSearch(const std::function<void(const SiteFile&)>& save) : save_(save) {}

  /// `page` is the number of the page of models that it is on.
  void add(const results::ModelRow& model, std::size_t page);

  /// How many pages there are.
  std::size_t finish();

 private:
  void flush();

  const std::function<void(const SiteFile&)>& save_;
  std::string names_;
  std::size_t models_ = 0;  // in names_
  std::size_t pages_ = 0;
};

}  // namespace rigor::report
