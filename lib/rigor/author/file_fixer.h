// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The fixes of one file, tried and kept or undone (fix.h says what is kept).
//
//   FixedFile fixed = FileFixer(environment, options, {path, bytes},
//   Applicability::kSafe).run(source);

#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/checked_text.h>
#include <rigor/author/edit_set.h>
#include <rigor/author/fix.h>
#include <rigor/author/patched_text.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/diagnostic.h>

namespace rigor::author {

class FileFixer {
 public:
  struct File {
    std::string path;
    std::string bytes;
    /// Templates that read it: its fixes are tried over all of them, and not over
    /// the file by itself.
    std::vector<std::string> robots = {};
  };

  /// The environment and the options outlive it.
  FileFixer(const Environment& environment, const rules::ValidateOptions& options, File file,
            Applicability most);

  /// Once. `source` is what the spans of its edits name.
  FixedFile run(SourceId source);

 private:
  using Indices = std::vector<std::size_t>;

  /// The edits of one fix, and the findings that have it.
  struct Candidate {
    std::vector<Edit> edits;
    Indices findings;
  };
  using Candidates = std::vector<Candidate>;

  /// What some fixes at once, and fixes of what they uncover, come to.
  struct Trial {
    PatchedText patched;
    std::unique_ptr<CheckedText> after;
    FindingsChange change = {};
    std::map<std::string_view, std::size_t> uncovered = {};  ///< and fixed as well, by rule
    std::optional<HeldBack> refused = std::nullopt;
  };

  std::unique_ptr<CheckedText> checked(std::string bytes) const;
  bool may_fix(const CheckedText& text, const Diagnostic& finding) const;
  Candidates find_candidates() const;

  bool advance(const Candidates& candidates);
  static EditSet joined(const Candidates& candidates, Indices& tried, std::size_t begin,
                        std::size_t end);
  Trial attempt(const Candidates& candidates, const Indices& tried, const EditSet& edits);
  bool fix_uncovered(Trial& trial) const;

  std::optional<HeldBack> refused(const Candidates& candidates, const Indices& tried,
                                  const Trial& trial) const;
  std::optional<HeldBack> refused_of_cut(const Trial& trial) const;

  void keep(const Candidates& candidates, const Indices& accepted, Trial trial);
  void hold_back(const Candidate& candidate, const Trial& trial);
  FixedFile finished(SourceId source);

  const Environment& environment_;
  const rules::ValidateOptions& options_;
  Applicability max_;
  std::vector<std::string> robots_;
  FixedFile fixed_;
  PatchedText patched_;
  std::unique_ptr<CheckedText> state_;  // of `patched_.text()`
  int trials_ = 0;
  std::optional<HeldBackFix> of_cut_;  // the last that was done while the file was cut
};

}  // namespace rigor::author
