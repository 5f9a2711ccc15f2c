// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Applies the fixes that findings come with, to files in memory: pass after
// pass, until none is left that helps. A fix is done whole or not at all, and
// kept only if what it fixes is gone and nothing as severe is found that was not
// there before; else it is undone. What is less severe may come, and is reported:
// of a mesh that was not found, nobody knew that it has a hole. A file that ends to
// be XML somewhere is left alone, but for fixes of just that. Those of a file that
// templates include are tried over all of these that were checked.
//
//   Sources sources;
//   ValidateResult result = validate(environment, options, sources);
//   for (const FixedFile& file : fix_files(environment, options, result,
//   sources, Applicability::kSafe)) {
//     if (file.changed()) write(file.path, file.after);
//   }
//
// Nothing is written. What no edit names keeps its bytes.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/edit.h>
#include <rigor/text/sources.h>

namespace rigor::author {

/// Rounds of fixes in a file. One round uncovers what the next can fix: a
/// renamed element its children.
inline constexpr int kMaxFixPasses = 10;

/// Times a file is checked while its fixes are tried. Of a round that makes
/// something worse, halves are tried, and halves of those: one bad fix among a
/// thousand takes twenty.
inline constexpr int kMaxFixTrials = 200;

/// Why a fix was not kept.
enum class HeldBack : std::uint8_t {
  kBringsFinding,  ///< that was not there before, and is as severe as what it fixes
  kDoesNotHelp,    ///< what it fixes is still found
  kNotXml,         ///< the file is not, or less than before, XML with it
  kNotTried,       ///< the trials were used up
};

struct HeldBackFix {
  std::string_view rule;
  std::string subject;  ///< of the finding
  std::string title;    ///< of the fix
  HeldBack why = HeldBack::kNotTried;
  std::string_view brings = {};  ///< the rule of the new finding
};

/// A file with findings that have fixes.
struct FixedFile {
  std::string path;
  std::string before;
  std::string after;        ///< the same as before when no fix was kept
  std::vector<Edit> edits;  ///< of `before`, that make `after` of it: sorted,
                            ///< none touches another
  std::map<std::string_view, std::size_t> applied;  ///< findings that are fixed, by rule
  std::vector<HeldBackFix> held_back;
  /// Whether no fix was left to try. When not, another call may fix more.
  bool settled = true;

  bool changed() const { return !edits.empty(); }
};

/// The files among those that were named, in their order. `result` is what
/// `validate` gave with these options; fixes up to `most` are applied, those
/// that are manual never. A file whose bytes on the disk are not those that
/// were checked is left out.
std::vector<FixedFile> fix_files(const Environment& environment,
                                 const rules::ValidateOptions& options,
                                 const rules::ValidateResult& result, const Sources& sources,
                                 Applicability most);

/// Whether `--fix`, or with kUnsafe `--unsafe-fixes` as well, applies the
/// finding's fix.
bool has_fix(const Diagnostic& finding, Applicability most);

}  // namespace rigor::author
