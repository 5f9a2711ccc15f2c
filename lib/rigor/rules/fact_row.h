// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A rule that only puts into words what a lower room found, as a row of a table: one for each kind of
// fact. `convert/` and `simulate/` have such tables; all other rules are sources of their own.
//
//   {.rule = {"convert-axis-unit", NoteKind::kAxisUnit, Severity::kInfo},
//    .message = "axis {written} is written as a unit vector",
//    .summary = "an axis was made a unit vector", .why = …, .what_to_do = …},

#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/rules/rule.h>

namespace rigor::rules {

/// The text of a finding, with names of the fact's fields in braces, as fmt has them ("{value:.3g} mm").
/// Where it depends on the case, a function of the fact chooses it.
template <class Fact>
class Message {
 public:
  constexpr Message(const char* text) : text_(text) {}
  template <std::invocable<const Fact&> Choice>
  constexpr Message(Choice choice) : choice_(choice) {}

  const char* text(const Fact& fact) const { return choice_ ? choice_(fact) : text_; }

 private:
  const char* text_ = "";
  const char* (*choice_)(const Fact&) = nullptr;
};

template <class Fact>
struct FactRow {
  using Kind = decltype(Fact::kind);
  struct Of {
    std::string_view name;
    Kind kind;
    Severity severity;
    Formats formats = Formats::kAny;
  };

  Of rule;
  std::optional<Kind> also = {};  ///< another kind that the rule puts into words
  Message<Fact> message;
  std::string_view help = {};
  std::string_view summary;  ///< this and what follows as in `Rule`
  std::string_view why;
  std::string_view what_to_do;

  bool is_of(Kind kind) const { return kind == rule.kind || kind == also; }
};

/// Each gives the rows of one file.
template <class Fact>
using FactTables = std::span<std::span<const FactRow<Fact>> (*const)()>;

/// The row of the kind. Throws std::logic_error when there is none: the tables are part of the program.
template <class Fact>
const FactRow<Fact>& row_of(const Fact& fact, FactTables<Fact> tables) {
  for (const auto table : tables) {
    for (const FactRow<Fact>& row : table()) {
      if (row.is_of(fact.kind)) return row;
    }
  }
  throw std::logic_error("a kind of fact has no row in the tables of rules");
}

/// The rules of the rows; all have the one check, which finds its row by the fact's kind.
template <class Fact>
std::vector<Rule> rules_of(FactTables<Fact> tables, CheckOf<Fact> check) {
  std::vector<Rule> rules;
  for (const auto table : tables) {
    for (const FactRow<Fact>& row : table()) {
      KindList kinds{row.rule.kind};
      if (row.also) kinds.add(*row.also);
      rules.push_back({.name = row.rule.name,
                       .severity = row.rule.severity,
                       .formats = row.rule.formats,
                       .summary = row.summary,
                       .why = row.why,
                       .what_to_do = row.what_to_do,
                       .checks = {FactCheck<Fact, decltype(Fact::kind)>{kinds, check}}});
    }
  }
  return rules;
}

}  // namespace rigor::rules
