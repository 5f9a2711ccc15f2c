// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/changes.h>

#include <map>
#include <tuple>

#include <rigor/report/concise.h>
#include <rigor/report/places.h>
#include <rigor/report/pretty.h>
#include <rigor/report/printable.h>
#include <rigor/report/summary.h>

namespace rigor::report {
namespace {

auto identity_of(const KnownFinding& finding) {
  return std::tie(finding.path, finding.rule, finding.severity, finding.subject, finding.message);
}

}  // namespace

std::vector<KnownFinding> known_findings(const Diagnostics& diagnostics, const Sources& sources) {
  Places places(sources);
  std::vector<KnownFinding> known;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    Diagnostics alone;
    alone.add(diagnostic);
    known.push_back({std::string(places.path(diagnostic)), std::string(diagnostic.rule),
                     diagnostic.severity, diagnostic.subject, diagnostic.message,
                     concise(alone, sources)});
  }
  return known;
}

FindingChanges what_changed(const std::vector<KnownFinding>& before,
                            const std::vector<KnownFinding>& after) {
  std::map<decltype(identity_of(before.front())), std::size_t> left;
  for (const KnownFinding& finding : before) ++left[identity_of(finding)];
  FindingChanges changes;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto known = left.find(identity_of(after[i]));
    if (known == left.end() || known->second == 0) {
      changes.fresh.push_back(i);
    } else {
      --known->second;
      ++changes.same;
    }
  }
  // What was not met again: the last ones of each kind.
  for (std::size_t i = before.size(); i-- > 0;) {
    std::size_t& count = left.at(identity_of(before[i]));
    if (count == 0) continue;
    --count;
    changes.fixed.insert(changes.fixed.begin(), i);
  }
  return changes;
}

std::string changes(const std::vector<KnownFinding>& before, const Diagnostics& after,
                    const Sources& sources, Color color) {
  const FindingChanges found = what_changed(before, known_findings(after, sources));
  Diagnostics fresh;
  for (const std::size_t i : found.fresh) fresh.add(after.list()[i]);
  std::string out = pretty(fresh, sources, color);
  for (const std::size_t i : found.fixed) out += "fixed: " + before[i].line;
  if (!found.fixed.empty()) out += '\n';
  if (found.fresh.empty() && found.fixed.empty()) {
    out += "nothing changed";
  } else {
    if (!found.fresh.empty()) out += std::to_string(found.fresh.size()) + " new";
    if (!found.fresh.empty() && !found.fixed.empty()) out += ", ";
    if (!found.fixed.empty()) out += std::to_string(found.fixed.size()) + " fixed";
  }
  return out + ", " +
         (after.list().empty() ? "no problems" : counted(found.same, "finding") + " as before") +
         '\n';
}

}  // namespace rigor::report
