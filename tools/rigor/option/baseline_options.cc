// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "option/baseline_options.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/text/path.h>
#include "command/command.h"
#include "output/atomic_file.h"
#include "output/output.h"
#include "project/project.h"

namespace rigor::tool {
namespace {

/// Changes of a baseline that are listed; the file itself has them all, and version control shows them.
constexpr std::size_t kMaxBaselineLines = 20;

std::string entry_of(const rules::BaselineKey& key) {
  return key.rule + " " + report::printable(key.path);
}

/// Counts before and after; zero where there was none.
using BaselineChange = std::pair<std::size_t, std::size_t>;

std::map<rules::BaselineKey, BaselineChange> baseline_changes(const rules::Baseline& before,
                                                              const rules::Baseline& after) {
  std::map<rules::BaselineKey, BaselineChange> changes;
  for (const auto& [key, count] : before) changes[key].first = count;
  for (const auto& [key, count] : after) changes[key].second = count;
  std::erase_if(changes,
                [](const auto& change) { return change.second.first == change.second.second; });
  return changes;
}

std::string change_line(const rules::BaselineKey& key, const BaselineChange& change) {
  const auto [before, after] = change;
  const bool more = after > before;
  std::string line = fmt::format("  {} {} {}", more ? "added" : "removed",
                                 more ? after - before : before - after, entry_of(key));
  if (before > 0 && after > 0) line += fmt::format(" ({} before, {} now)", before, after);
  return line;
}

std::size_t baseline_total(const rules::Baseline& baseline) {
  std::size_t total = 0;
  for (const auto& [key, count] : baseline) total += count;
  return total;
}

}  // namespace

void BaselineOptions::declare(CLI::App& app) {
  app.add_option("--baseline", path_, "Hide the findings that this file counts")->type_name("FILE");
  app.add_option("--baseline-write", write_,
                 "Write the findings of this run to the file, and hide them from now on")
      ->type_name("FILE");
  app.add_flag("--baseline-prune", prune_, "Remove from the baseline what is no longer found");
  app.add_flag("--baseline-strict", strict_,
               "Fail if the baseline counts more findings than there are");
}

void BaselineOptions::read(const Disk& disk, const std::optional<std::string>& configured) {
  if (path().empty() && configured) {
    path_ = *configured;
    configured_ = true;
  }
  if (!path_.empty() && !write_.empty()) {
    throw UsageError(
        "--baseline and --baseline-write exclude each other: one hides known findings, the other "
        "rewrites the file");
  }
  if (path_.empty() && (prune_ || strict_)) {
    throw UsageError(std::string(prune_ ? "--baseline-prune" : "--baseline-strict") +
                     " needs --baseline FILE");
  }
  if (path().empty()) return;
  there_ = disk.kind(path()) != PathKind::kMissing;
  if (!there_ && !write_.empty()) return;
  const ReadResult read = disk.read(path(), rules::kMaxBaselineBytes);
  if (!read.bytes) {
    throw UsageError(path() + ": " + read.problem +
                     (there_ ? "" : "; --baseline-write makes a baseline"));
  }
  rules::BaselineFile file = rules::read_baseline(*read.bytes);
  if (!file.problems.empty()) {
    const rules::BaselineProblem& first = file.problems.front();
    throw UsageError(fmt::format("{}:{}: the line {}", path(), first.line, first.what));
  }
  baseline_ = std::move(file.baseline);
}

rules::BaselinePlace BaselineOptions::place() const {
  std::error_code error;  // of a folder that is gone: paths are as they are written
  const std::string working = std::filesystem::current_path(error).string();
  return {std::string(parent_path(join_path(working, path()))), working};
}

rules::ValidateResult BaselineOptions::apply(const Environment& environment,
                                             const rules::ValidateOptions& options,
                                             rules::ValidateResult result) {
  if (path().empty()) return result;
  const rules::BaselineRun run(environment, options, result, place());
  const bool whole = result.unusable.empty();
  if (!write_.empty() && whole) keep(rules::next_baseline(baseline_, run));
  rules::BaselineResult applied = rules::apply_baseline(baseline_, run, std::move(result));
  if (prune_ && whole) {
    keep(rules::pruned_baseline(baseline_, run));
  } else {
    tell_stale(applied.stale);
  }
  if (write_.empty() && applied.hidden > 0) {
    told_.insert(told_.begin(),
                 report::counted(applied.hidden, "finding") + " hidden by " + path());
  }
  return std::move(applied.left);
}

void BaselineOptions::keep(rules::Baseline next) {
  const auto changes = baseline_changes(baseline_, next);
  const std::string what =
      fmt::format("{}: {}", path(), report::counted(baseline_total(next), "known finding"));
  told_.push_back(what + (changes.empty() && there_ ? ", as before" : ""));
  std::size_t listed = 0;
  for (const auto& [key, change] : changes) {
    if (++listed <= kMaxBaselineLines) told_.push_back(change_line(key, change));
  }
  if (listed > kMaxBaselineLines) {
    told_.push_back("  and " + report::counted(listed - kMaxBaselineLines, "more change"));
  }
  if (!changes.empty() || !there_) write(rules::baseline_text(next));
  baseline_ = std::move(next);
}

/// One that a configuration names is written below the top of the project only, and through no link.
void BaselineOptions::write(const std::string& text) const {
  if (!configured_) return replace_file(path(), text);
  const report::ProjectFolders folders = project_folders();
  const std::string whole = join_path(folders.working, path());
  put_file(folders.root, relative_path(folders.root, whole), text);
}

void BaselineOptions::tell_stale(const std::vector<rules::StaleBaseline>& stale) {
  stale_ = !stale.empty();
  if (!stale_) return;
  told_.push_back(fmt::format("{}: {} more than is found; --baseline-prune lowers {}", path(),
                              stale.size() == 1
                                  ? "1 entry counts"
                                  : report::counted(stale.size(), "entry", "entries") + " count",
                              stale.size() == 1 ? "it" : "them"));
  if (!strict_) return;
  const std::size_t listed = std::min(stale.size(), kMaxBaselineLines);
  for (std::size_t i = 0; i < listed; ++i) {
    told_.push_back(fmt::format("  {} ({} counted, {} found)", entry_of(stale[i].key),
                                stale[i].counted, stale[i].now));
  }
  if (listed < stale.size()) {
    told_.push_back("  and " +
                    report::counted(stale.size() - listed, "more entry", "more entries"));
  }
}

void BaselineOptions::conclude() const {
  for (const std::string& line : told_) say(line);
}

}  // namespace rigor::tool
