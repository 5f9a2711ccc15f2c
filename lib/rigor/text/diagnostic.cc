// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/diagnostic.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace rigor {

std::string_view to_string(Severity severity) {
  switch (severity) {
    case Severity::kError: return "error";
    case Severity::kWarning: return "warning";
    case Severity::kInfo: break;
  }
  return "info";
}

std::string_view why_of(const Diagnostic& diagnostic) {
  return diagnostic.why.empty() ? diagnostic.page_why : std::string_view(diagnostic.why);
}

std::string_view help_of(const Diagnostic& diagnostic) {
  return diagnostic.help.empty() ? diagnostic.page_help : std::string_view(diagnostic.help);
}

std::size_t Diagnostics::places() const {
  std::size_t places = 0;
  for (const Diagnostic& diagnostic : list_) places += diagnostic.count + diagnostic.others.size();
  return places;
}

std::size_t Diagnostics::count(Severity severity) const {
  std::size_t count = 0;
  for (const Diagnostic& diagnostic : list_) {
    if (diagnostic.severity == severity) count += diagnostic.count;
  }
  return count;
}

void Diagnostics::sort() {
  const auto key = [](const Diagnostic& d) {
    return std::tie(d.where.source, d.where.begin, d.where.end, d.rule, d.message);
  };
  // A diagnostic is large: it is moved once, when its place is known.
  std::vector<std::size_t> order(list_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return key(list_[a]) < key(list_[b]); });
  std::vector<Diagnostic> sorted;
  sorted.reserve(list_.size());
  for (const std::size_t i : order) sorted.push_back(std::move(list_[i]));
  list_ = std::move(sorted);
}

}  // namespace rigor
