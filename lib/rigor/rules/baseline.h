// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The findings that a repository lives with for now: how many of each rule in each file. What is counted
// is hidden; one more of a rule in a file, and all of that rule there are shown, since nobody can tell which
// is new. Counts need no line numbers, so that edits elsewhere in a file change nothing.
//
//   # rigor.baseline
//   3 inertia-identity models/arm/model.sdf
//
//   const BaselineFile file = read_baseline(bytes);
//   const BaselineRun run(environment, options, result, {"/home/me/robots", "/home/me"});
//   BaselineResult applied = apply_baseline(file.baseline, run, std::move(result));
//   write(baseline_text(next_baseline(file.baseline, run)));

#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

namespace rigor::rules {

/// A rule in a file. Sorted by path, then rule, as the lines are.
struct BaselineKey {
  std::string path;  ///< seen from the baseline's folder
  std::string rule;

  auto operator<=>(const BaselineKey&) const = default;
};

/// How many findings of each are known; none is zero.
using Baseline = std::map<BaselineKey, std::size_t>;

/// "line 7 is not `count rule path`"
struct BaselineProblem {
  std::uint32_t line = 0;
  std::string what;
};

struct BaselineFile {
  Baseline baseline;
  std::vector<BaselineProblem> problems;  ///< the first few; such a file is not to be used
};

/// A baseline has a line for a rule in a file: a file of this size has a million.
inline constexpr std::uint64_t kMaxBaselineBytes = 64ULL << 20U;

/// Never fails: what is wrong stands in `problems`. Empty lines and those that begin with # are passed over.
BaselineFile read_baseline(std::string_view bytes);

/// The file: a line a rule and file, sorted. White space, controls and \ in a path are escaped.
std::string baseline_text(const Baseline& baseline);

/// Where the baseline's paths are seen from, and those of the run. Both absolute.
struct BaselinePlace {
  std::string folder;   ///< of the baseline
  std::string working;  ///< of the run
};

using BaselineCounts = std::map<BaselineKey, std::optional<std::size_t>>;

/// What a run of `validate` found, and what it could not know: files that it did not check, and rules
/// that did not run.
class BaselineRun {
 public:
  /// All but the place outlive it.
  BaselineRun(const Environment& environment, const ValidateOptions& options,
              const ValidateResult& result, BaselinePlace place);

  const Baseline& found() const { return found_; }

  /// The path as the baseline has it.
  std::string name(const std::string& path) const;

  /// Of each entry the findings there are now; zero when its file or its rule is gone. Nothing when the run
  /// could not know.
  BaselineCounts now(const Baseline& baseline) const;

 private:
  class Knower;

  const Environment& environment_;
  const ValidateOptions& options_;
  BaselinePlace place_;
  Baseline found_;
  std::map<std::string, std::string> checked_;  // by name, the path as the run has it
  std::set<std::string> cut_;                   // names of files that were not read to their ends
};

/// An entry that counts more findings than there are.
struct StaleBaseline {
  BaselineKey key;
  std::size_t counted = 0;
  std::size_t now = 0;
};

struct BaselineResult {
  ValidateResult left;               ///< what the baseline does not hide
  std::size_t hidden = 0;            ///< findings
  std::vector<StaleBaseline> stale;  ///< sorted
};

/// `result` is the one that `run` was made of.
BaselineResult apply_baseline(const Baseline& baseline, const BaselineRun& run,
                              ValidateResult result);

/// What is found now, and what the run could not know as it was.
Baseline next_baseline(const Baseline& before, const BaselineRun& run);

/// What stood there before, without what is gone: no count is greater than it was.
Baseline pruned_baseline(const Baseline& before, const BaselineRun& run);

}  // namespace rigor::rules
