// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What an edit did: the findings that came, those that went, and how many are as they were.
//
//   const std::vector<KnownFinding> after = known_findings(result.diagnostics, sources);
//   const FindingChanges changes = what_changed(before, after);
//   out += report::changes(before, result.diagnostics, sources, color);
//
// A finding is the same when it says the same of the same thing, wherever it stands now: a line that was
// added above it makes nothing new.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <rigor/report/terminal/color.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>

namespace rigor::report {

/// A finding that outlives the texts that it was found in.
struct KnownFinding {
  std::string path;
  std::string rule;
  Severity severity = Severity::kError;
  std::string subject;
  std::string message;
  std::string line;  ///< as `concise` writes it; it has no say in what is the same
};

/// In the order of the list.
std::vector<KnownFinding> known_findings(const Diagnostics& diagnostics, const Sources& sources);

struct FindingChanges {
  std::vector<std::size_t> fresh;  ///< indices of those after that were not there before
  std::vector<std::size_t> fixed;  ///< indices of those before that are not there any more
  /// Of those before that were not met in a file that cannot be read to its end: nobody knows.
  std::vector<std::size_t> hidden;
  std::size_t same = 0;
};

/// Of several that are the same, as many stay as both have; the last ones are new, or fixed or hidden.
FindingChanges what_changed(const std::vector<KnownFinding>& before,
                            const std::vector<KnownFinding>& after);

/// What to hold the next findings against: those after, and those before that are hidden.
std::vector<KnownFinding> remembered(const std::vector<KnownFinding>& before,
                                     std::vector<KnownFinding> after);

/// The new ones as `pretty` shows them, a line for each that is fixed, and a line of counts, "1 new, 2
/// fixed, 4 as before", or "nothing changed, 4 as before". What is hidden is counted behind.
std::string changes(const std::vector<KnownFinding>& before, const Diagnostics& after,
                    const Sources& sources, Color color);

}  // namespace rigor::report
