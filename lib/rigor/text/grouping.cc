// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/grouping.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

namespace rigor {
namespace {

constexpr std::size_t kReservedForSeparators = 32;

/// Of "arm::hand/link palm/collision box": arm::hand, arm, hand, palm, box.
std::vector<std::string_view> names_in(std::string_view subject) {
  std::vector<std::string_view> names;
  const auto add = [&names](std::string_view name) {
    if (!name.empty()) names.push_back(name);
  };
  for (bool first = true; !subject.empty(); first = false) {
    const std::size_t slash = std::min(subject.find('/'), subject.size());
    std::string_view part = subject.substr(0, slash);
    subject.remove_prefix(std::min(slash + 1, subject.size()));
    // After the model's scoped name each part begins with a kind: "link palm".
    const std::size_t blank = part.find(' ');
    if (!first && blank != part.npos) part.remove_prefix(blank + 1);
    add(part);
    for (std::size_t colons = part.find("::"); colons != part.npos; colons = part.find("::")) {
      add(part.substr(0, colons));
      part.remove_prefix(colons + 2);
      if (part.find("::") == part.npos) add(part);
    }
  }
  return names;
}

/// Appends the text with … for each quoted name; whether there was one.
bool append_without_names(std::string_view text, const std::vector<std::string_view>& names,
                          std::string& out) {
  std::size_t done = 0;
  for (std::size_t open = names.empty() ? text.npos : text.find('\''); open != text.npos;) {
    const std::size_t close = text.find('\'', open + 1);
    if (close == text.npos) break;
    const auto quoted = text.substr(open + 1, close - open - 1);
    if (std::find(names.begin(), names.end(), quoted) == names.end()) {
      open = close;  // which may as well be where the next name begins
      continue;
    }
    out.append(text, done, open + 1 - done).append("…'");
    done = close + 1;
    open = text.find('\'', done);
  }
  out.append(text, done);
  return done != 0;
}

}  // namespace

std::string cause_of(const Diagnostic& finding) {
  std::string key;
  key.reserve(finding.rule.size() + finding.message.size() + finding.help.size() +
              finding.cause.size() + finding.path.size() + kReservedForSeparators);
  key.append(finding.rule).append(1, '\0').append(to_string(finding.severity)).append(1, '\0');
  if (!finding.cause.empty()) return key.append("cause").append(1, '\0').append(finding.cause);
  const std::vector<std::string_view> names = names_in(finding.subject);
  const bool is_named = append_without_names(finding.message, names, key);
  key.append(1, '\0');
  append_without_names(finding.help, names, key);
  if (!is_named) return key;
  key.append(1, '\0');
  return finding.where.nowhere()
             ? key.append(finding.path)
             : key.append(std::to_string(static_cast<std::uint32_t>(finding.where.source)));
}

std::string without_names(const std::string& message, std::string_view subject) {
  std::string out;
  append_without_names(message, names_in(subject), out);
  return out;
}

void Grouping::add(const Diagnostic& finding) {
  if (finding.count == 1) {
    const auto [entry, is_new] = known_.try_emplace(cause_of(finding), groups_.size());
    if (!is_new) {
      std::vector<Diagnostic>& others = groups_[entry->second].others;
      others.push_back(finding);
      std::vector<Diagnostic> more = std::exchange(others.back().others, {});
      std::move(more.begin(), more.end(), std::back_inserter(others));
      return;
    }
  }
  groups_.push_back(finding);
}

Diagnostics Grouping::take() {
  Diagnostics result;
  for (Diagnostic& group : groups_) result.add(std::move(group));
  groups_.clear();
  close();
  return result;
}

Diagnostics grouped(const Diagnostics& findings) {
  Grouping grouping;
  for (const Diagnostic& finding : findings.list()) grouping.add(finding);
  return grouping.take();
}

GroupCounts count_groups(const Diagnostics& findings) {
  GroupCounts counts;
  std::unordered_set<std::string> known;
  for (const Diagnostic& finding : findings.list()) {
    counts.places += finding.count + finding.others.size();
    const bool is_new = finding.count != 1 || known.insert(cause_of(finding)).second;
    counts.joined = counts.joined || !is_new || !finding.others.empty();
    if (is_new) counts.by_severity[static_cast<std::size_t>(finding.severity)] += finding.count;
  }
  return counts;
}

Diagnostics ungrouped(const Diagnostics& groups) {
  Diagnostics result;
  for (const Diagnostic& group : groups.list()) {
    Diagnostic first = group;
    std::vector<Diagnostic> others = std::exchange(first.others, {});
    result.add(std::move(first));
    for (Diagnostic& other : others) result.add(std::move(other));
  }
  return result;
}

}  // namespace rigor
