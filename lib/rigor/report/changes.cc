// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/changes.h>

#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include <rigor/report/places.h>
#include <rigor/report/terminal/pretty.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/report/validation.h>

namespace rigor::report {
namespace {

auto identity_of(const KnownFinding& finding) {
  return std::tie(finding.path, finding.rule, finding.severity, finding.subject, finding.message);
}

/// Whether it says that a file was not read to its end, so that others in it may not be seen. All rules
/// on how an XML file is written begin so.
bool hides_others(const KnownFinding& finding) {
  return finding.severity == Severity::kError &&
         (finding.rule == "file-unreadable" || finding.rule.starts_with("xml-"));
}

}  // namespace

std::vector<KnownFinding> known_findings(const Diagnostics& diagnostics, const Sources& sources) {
  Places places(sources);
  std::vector<KnownFinding> known;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    known.push_back({std::string(places.path(diagnostic)), std::string(diagnostic.rule),
                     diagnostic.severity, diagnostic.subject, diagnostic.message,
                     concise_line(diagnostic, places) + '\n'});
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
  std::set<std::string_view> not_read;
  for (const KnownFinding& finding : after) {
    if (hides_others(finding)) not_read.insert(finding.path);
  }
  // What was not met again: the last ones of each kind.
  for (std::size_t i = before.size(); i-- > 0;) {
    std::size_t& count = left.at(identity_of(before[i]));
    if (count == 0) continue;
    --count;
    const bool hidden = not_read.contains(before[i].path) && !hides_others(before[i]);
    std::vector<std::size_t>& gone = hidden ? changes.hidden : changes.fixed;
    gone.insert(gone.begin(), i);
  }
  return changes;
}

std::vector<KnownFinding> remembered(const std::vector<KnownFinding>& before,
                                     std::vector<KnownFinding> after) {
  for (const std::size_t i : what_changed(before, after).hidden) after.push_back(before[i]);
  return after;
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
  out += ", ";
  out += after.list().empty() ? "no problems" : counted(found.same, "finding") + " as before";
  if (!found.hidden.empty()) {
    out += ", " + std::to_string(found.hidden.size()) +
           " not looked for in what cannot be read to its end";
  }
  return out + '\n';
}

}  // namespace rigor::report
