// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Comments in a model file that say which findings are meant to be there:
//
//   <!-- rigor: ignore[inertia-implausible, mesh-not-closed] weighed by hand -->
//   <link name="gripper">…</link>
//
// `ignore` covers the next sibling element and all it contains, `ignore-next` that element's own start
// tag, `file-ignore` before the root the whole file. A rule's name or a category's may stand there. Those that
// cover nothing are found, and reported by the rule `unused-suppression`.
//
//   Suppressions suppressions(document);
//   Diagnostics left = suppressions.uncovered(std::move(found));
//   SuppressionFacts facts = suppressions.facts(registry, runner, MeshPolicy::kOpen);

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <rigor/rules/names.h>
#include <rigor/rules/registry.h>
#include <rigor/rules/suppression_fact.h>
#include <rigor/rules/validate.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/span.h>
#include <rigor/xml/document.h>

namespace rigor::rules {

class Runner;

class Suppressions {
 public:
  Suppressions() = default;
  /// Those of a file. Linear in its size; the document is not kept.
  explicit Suppressions(const xml::Document& document);

  /// The findings that no comment covers, in their order; remembers which comments covered one. Findings in
  /// other sources, and those that stand nowhere, are covered by `file-ignore` only, and so is one that
  /// represents many that are not listed: they may be anywhere. What ended the reading is never covered,
  /// since nobody examined what follows it.
  Diagnostics uncovered(Diagnostics found);

  /// What is wrong with the comments, when all findings of the file went through `uncovered`. Of a rule
  /// that did not run, or of which more is found by other commands, nobody can tell whether it is
  /// suppressed in vain.
  SuppressionFacts facts(const Registry& registry, const Runner& runner,
                         MeshPolicy meshes = MeshPolicy::kOpen) const;

  /// A comment that names a rule or category covered a finding elsewhere.
  void use(std::string_view name);

  /// Those of a file with the same bytes, which covered findings of another run.
  void take_uses(const Suppressions& other);

  /// How many times a finding was held against a comment: with a file of thousands of either, no more
  /// than twice a finding for each level that it is nested.
  std::size_t comparisons() const { return comparisons_; }

 private:
  class Reader;

  struct Named {
    std::string name;
    Span where;
    bool used = false;
  };
  struct Comment {
    std::size_t first_name;
    std::size_t end_name;
    Span whole;  ///< the bytes to remove with it; nowhere when it cannot be removed
  };
  /// What one name covers. Covers of one name are nested or apart.
  struct Cover {
    std::uint32_t begin;
    std::uint32_t end;
    std::size_t outer;  ///< the one around it, among those of the same name
    std::size_t name;
  };
  using Covers = std::vector<Cover>;

  bool covers(const Diagnostic& diagnostic);
  bool covers(std::string_view name, const Diagnostic& diagnostic);
  bool ended_reading(const Diagnostic& diagnostic) const;
  void tell_unused(const Comment& comment, const std::vector<bool>& unused,
                   SuppressionFacts& facts) const;

  SourceId source_ = kNoSource;
  bool complete_ = true;
  Span root_;
  std::vector<Named> names_;
  std::vector<Comment> comments_;
  std::unordered_map<std::string, Covers> covers_;         // by name, in the order of their begins
  std::unordered_map<std::string, std::size_t> for_file_;  // by name, what names it
  std::vector<Span> fatal_;                                // what ended the reading
  bool meshes_in_doubt_ = false;                           // a mesh had findings of its own
  std::size_t comparisons_ = 0;
  SuppressionFacts faults_;  // found while reading
};

}  // namespace rigor::rules
