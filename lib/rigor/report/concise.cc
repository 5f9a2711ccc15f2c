// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/concise.h>

#include <fmt/core.h>

#include <rigor/report/places.h>
#include <rigor/report/printable.h>

namespace rigor::report {

std::string concise(const Diagnostics& diagnostics, const Sources& sources) {
  Places places(sources);
  std::string out;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    out += printable(places.path(diagnostic));
    if (!diagnostic.where.nowhere()) {
      const Position begin = places.begin(diagnostic.where);
      out += fmt::format(":{}:{}", begin.line, begin.column);
    }
    out += fmt::format(": {}: {} [{}]\n", to_string(diagnostic.severity),
                       printable(diagnostic.message), diagnostic.rule);
  }
  return out;
}

}  // namespace rigor::report
