// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What rigor has to say about a file, as data.
//
// The library never prints: it appends to a `Diagnostics`, and `report` speaks. A diagnostic names
// its rule, so that everything rigor can say has one page, one severity and one switch.
//
//   diagnostics.add({.rule = "joint-limit-inverted", .severity = Severity::kError,
//                    .message = "lower (1) is above upper (-1)", .where = limit.lower.span});

#pragma once

#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/text/edit.h>
#include <rigor/text/span.h>

namespace rigor {

enum class Severity {
  kError,    ///< a consumer rejects, crashes on or misreads the model
  kWarning,  ///< probably not what was meant
  kInfo,     ///< worth knowing
};

std::string_view to_string(Severity severity);

/// A second place that explains the first: "first defined here".
struct Label {
  Span where;
  std::string message;
};

/// A call of a xacro macro that brought a place into the model.
struct MacroCall {
  std::string macro;
  Span where;  ///< of the call's tag
  std::vector<std::pair<std::string, std::string>> params;
};

struct Diagnostic {
  std::string_view rule;      ///< kebab-case name; points into the registry, which is static data
  std::string_view category;  ///< of the rule
  Severity severity = Severity::kError;
  std::string message;  ///< lower case, no full stop: the value, the limit, the unit
  Span where;           ///< the bytes at fault; `nowhere()` when a whole file is (see `path`)
  std::string path;     ///< of the file, when `where` has no source: a mesh, a missing file
  std::string of_file;  ///< whose content it tells of, where that is another than the one of `where`
  bool measured = false;  ///< whether of that file it tells numbers only, and none of its text
  std::string subject;  ///< the entity, for people who think in robots: "arm/joint elbow"
  std::vector<Label> related;
  std::string help;           ///< what to do, in the imperative; empty when the message says it all
  std::vector<Fix> fixes;     ///< none or one; the first is the one to apply
  std::size_t instances = 1;  ///< elements of the expanded model that show it
  std::size_t count = 1;      ///< findings it represents: many when it says how many are not listed
  /// What findings of one rule have in common: the URI, the missing package, the misspelt name. Empty when
  /// the message says it (`text/grouping.h`).
  std::string cause;
  std::string why;             ///< what a consumer makes of this case; empty when the page says it
  std::string_view page_why;   ///< of the rule's page, in one sentence; static data
  std::string_view page_help;  ///< the same
  std::vector<MacroCall> origin;   ///< of what was expanded, the innermost call first
  std::vector<Diagnostic> others;  ///< the same rule and cause at other places, once grouped
};

/// Those of the case, else those of the rule's page.
std::string_view why_of(const Diagnostic& diagnostic);
std::string_view help_of(const Diagnostic& diagnostic);

/// Append-only. Rules and readers add, nobody removes.
class Diagnostics {
 public:
  void add(Diagnostic diagnostic) { list_.push_back(std::move(diagnostic)); }

  /// Adds all that another list holds.
  void take(Diagnostics&& other) {
    list_.insert(list_.end(), std::make_move_iterator(other.list_.begin()),
                 std::make_move_iterator(other.list_.end()));
  }

  const std::vector<Diagnostic>& list() const { return list_; }
  /// Findings, those that are counted and not listed among them.
  std::size_t count(Severity severity) const;
  /// Places of all findings: as many as there are findings before they are grouped.
  std::size_t places() const;

  /// By place (source, then offset), then rule, so that output depends on nothing else.
  void sort();

 private:
  std::vector<Diagnostic> list_;
};

}  // namespace rigor
