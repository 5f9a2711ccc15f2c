// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/terminal/summary.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <rigor/report/terminal/printable.h>
#include <rigor/text/grouping.h>

namespace rigor::report {
namespace {

/// Files named one by one at most; a tree of templates would fill the screen.
constexpr std::size_t kMaxNamed = 10;

constexpr Severity kSeverities[] = {Severity::kError, Severity::kWarning, Severity::kInfo};

/// What was met but not checked: whole files, and of files that were, what they include and how models stand
/// assembled.
struct NotChecked {
  std::vector<const rules::NotLookedAt*> files;
  std::size_t includes = 0;
  std::size_t assemblies = 0;
};

NotChecked not_checked(const rules::ValidateResult& result) {
  NotChecked found;
  for (const rules::NotLookedAt& item : result.not_looked_at) {
    if (item.what.starts_with("include of ")) {
      ++found.includes;
    } else if (item.what.starts_with("assembly: ")) {
      ++found.assemblies;
    } else {
      found.files.push_back(&item);
    }
  }
  return found;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) {
    if (!text.empty()) text += ", ";
    text += part;
  }
  return text;
}

std::string not_looked_at(const NotChecked& found) {
  std::vector<std::string> parts;
  if (found.includes > 0) parts.push_back(counted(found.includes, "include"));
  if (!found.files.empty()) parts.push_back(counted(found.files.size(), "file"));
  if (found.assemblies > 0) parts.push_back("assembly of " + counted(found.assemblies, "file"));
  return parts.empty() ? "" : "; " + joined(parts) + " skipped";
}

std::string counts_text(const GroupCounts& counts) {
  std::vector<std::string> parts;
  for (const Severity severity : kSeverities) {
    const std::size_t count = counts.by_severity[static_cast<std::size_t>(severity)];
    if (count > 0) parts.push_back(counted(count, to_string(severity)));
  }
  if (parts.empty()) return ", no problems";
  return ": " + joined(parts) + (counts.joined ? " at " + counted(counts.places, "place") : "");
}

std::string files_text(const rules::ValidateResult& result, const std::string& findings) {
  if (result.files.empty()) return "no files checked" + not_looked_at(not_checked(result));
  return counted(result.files.size(), "file") + " checked" + findings +
         not_looked_at(not_checked(result));
}

}  // namespace

std::string findings(const Diagnostics& diagnostics) {
  GroupCounts counts;
  for (const Severity severity : kSeverities) {
    counts.by_severity[static_cast<std::size_t>(severity)] = diagnostics.count(severity);
  }
  counts.places = diagnostics.places();
  counts.joined = std::any_of(diagnostics.list().begin(), diagnostics.list().end(),
                              [](const Diagnostic& each) { return !each.others.empty(); });
  return counts_text(counts);
}

std::string counted(std::size_t count, std::string_view noun, std::string_view plural) {
  std::string digits = fmt::format("{}", count);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  if (count != 1 && !plural.empty()) return fmt::format("{} {}", digits, plural);
  return fmt::format("{} {}{}", digits, noun, count == 1 ? "" : "s");
}

std::string summary(const rules::ValidateResult& result) {
  return files_text(result, findings(result.diagnostics));
}

std::string summary_of_groups(const rules::ValidateResult& result) {
  return files_text(result, counts_text(count_groups(result.diagnostics)));
}

std::string left_out(const rules::ValidateResult& result) {
  const NotChecked found = not_checked(result);
  const std::size_t named = std::min(found.files.size(), kMaxNamed);
  std::string out;
  for (std::size_t i = 0; i < named; ++i) {
    const rules::NotLookedAt& item = *found.files[i];
    out += fmt::format("skipped: {}: {}\n", printable(item.path), printable(item.what));
  }
  if (named < found.files.size()) {
    out += "skipped: " + counted(found.files.size() - named, "more file") + "\n";
  }
  return out;
}

}  // namespace rigor::report
