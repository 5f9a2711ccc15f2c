// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A file's bytes and all that is said of them, to be held against what was said
// before they were edited: what is found that was not there must be less severe
// than what is gone.
//
//   const CheckedText before(environment, options, path, bytes);
//   const CheckedText after(environment, options, path, *apply_edits(bytes,
//   edits));
//   const FindingsChange change = compare(before, after, edits);
//   if (!change.brings) keep(after);

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/edit.h>
#include <rigor/text/sources.h>

namespace rigor::author {

class CheckedText {
 public:
  /// Checks `bytes` as what the file at `path` holds. Of the options, those
  /// that say what is looked for. With robots, these are what is checked:
  /// templates that read the file.
  CheckedText(const Environment& environment, const rules::ValidateOptions& options,
              std::string path, std::string bytes, std::vector<std::string> robots = {});
  CheckedText(const CheckedText&) = delete;
  CheckedText& operator=(const CheckedText&) = delete;

  const std::string& bytes() const { return bytes_; }
  const std::vector<Diagnostic>& findings() const { return result_.diagnostics.list(); }
  bool own(Span span) const;  ///< whether it stands in this text

  /// Where XML ends to be readable; nothing when it does not.
  const std::optional<Span>& cut() const { return cut_; }
  /// What is wrong with it as XML, whatever rules run.
  std::size_t xml_faults() const { return xml_faults_; }
  /// Whether a rule found more than it lists.
  bool all_listed(const Diagnostic& finding) const;
  /// Findings, those that are counted only among them: errors, errors and warnings, and all. A text with less of
  /// the first is better, whatever else it has more of; and so on.
  std::array<std::size_t, 3> count() const { return {errors_, count_ - infos_, count_}; }

 private:
  std::string path_;
  std::string working_folder_;  // where relative paths begin, of templates
  std::string bytes_;
  Sources sources_;
  rules::ValidateResult result_;
  std::optional<Span> cut_;
  std::size_t xml_faults_ = 0;
  std::vector<std::string_view> counted_;  // rules and categories
  std::size_t count_ = 0;
  std::size_t errors_ = 0;
  std::size_t infos_ = 0;
};

/// A finding that was not there before.
struct BroughtFinding {
  std::string_view rule;
  Severity severity = Severity::kError;
};

/// What became of the findings.
struct FindingsChange {
  std::vector<bool> gone;  ///< of those before
  /// Errors and warnings after that were not there, of rules that list all.
  std::vector<std::size_t> fresh;
  /// The first of the most severe of them; else of a rule of which there are more than before.
  std::optional<BroughtFinding> brings;
};

/// A finding is the same as before when it stands where that stood, or says the
/// same of the same entity.
FindingsChange compare(const CheckedText& before, const CheckedText& after,
                       const std::vector<Edit>& edits);

}  // namespace rigor::author
