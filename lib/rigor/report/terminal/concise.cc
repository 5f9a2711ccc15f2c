// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/terminal/concise.h>

#include <rigor/report/places.h>
#include <rigor/report/validation.h>

namespace rigor::report {

std::string concise(const Diagnostics& diagnostics, const Sources& sources) {
  Places places(sources);
  std::string out;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    out += concise_line(diagnostic, places) + '\n';
  }
  return out;
}

}  // namespace rigor::report
