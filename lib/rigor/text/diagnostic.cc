// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/diagnostic.h>

#include <algorithm>
#include <tuple>

namespace rigor {

std::string_view to_string(Severity severity) {
  switch (severity) {
    case Severity::kError: return "error";
    case Severity::kWarning: return "warning";
    case Severity::kInfo: break;
  }
  return "info";
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
  std::stable_sort(list_.begin(), list_.end(),
                   [&key](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
}

}  // namespace rigor
