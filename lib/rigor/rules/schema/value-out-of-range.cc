// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/refused_value.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_out_of_range {

using FaultKind = schema::ValueFault::Kind;

bool is_outside(std::string_view value, const schema::Node& node) {
  const auto number = [](std::string_view text) {
    const auto parsed = schema::parse_double(text);
    const double* found = std::get_if<double>(&parsed);
    return found != nullptr ? *found : 0.0;
  };
  return (node.minimum() && number(value) < number(*node.minimum())) ||
         (node.maximum() && number(value) > number(*node.maximum()));
}

std::string message(const read::SchemaFact& fact, const schema::Node& node) {
  const std::string given = owner_of(fact) + " is " + quoted_fault(fact);
  if (has_kind(fact, FaultKind::kNegative)) return given + ": it cannot be negative";
  if (has_kind(fact, FaultKind::kOutOfRange))
    return given + ": too large for " + std::string(expected(fact.node->type()));
  if (has_kind(fact, FaultKind::kUnderflow))
    return given + ": too small to be distinguished from 0";
  std::string bounds;
  if (const auto low = node.minimum()) bounds = "at least " + std::string(*low);
  if (const auto high = node.maximum()) {
    bounds += (bounds.empty() ? "at most " : " and at most ") + std::string(*high);
  }
  const std::string unit(node.unit());
  return given + ": it has to be " + bounds + (unit.empty() ? "" : " " + unit);
}

std::string why_of(const read::SchemaFact& fact, const Context& context) {
  if (context.is_urdf()) return {};
  if (has_kind(fact, FaultKind::kNegative)) {
    return "libsdformat wraps a negative number around to one of some four billion.";
  }
  if (has_kind(fact, FaultKind::kOutOfRange)) {
    return "libsdformat rejects the file: the number does not fit its type.";
  }
  if (has_kind(fact, FaultKind::kUnderflow)) {
    return "libsdformat rejects a number that it cannot distinguish from zero.";
  }
  return "libsdformat holds every file to the bounds of its newest version, and rejects this one.";
}

void check(const read::SchemaFact& fact, Context& context) {
  const bool bad = fact.kind == read::SchemaFactKind::kBadValue;
  const bool ours = has_kind(fact, FaultKind::kNegative) ||
                    has_kind(fact, FaultKind::kOutOfRange) || has_kind(fact, FaultKind::kUnderflow);
  if (bad ? !ours : context.is_urdf()) return;  // urdfdom has no bounds: value-negative
  std::optional<schema::Node> node = fact.node;
  if (!bad) {
    // libsdformat holds every file to the bounds of the newest version.
    node = node_in(context.schema()->latest(), fact.element, *context.schema());
    if (!node || fact.attribute || !is_outside(fact.text, *node)) return;
  }
  context.report({.where = fact.where,
                  .message = message(fact, *node),
                  .subject = subject_of(fact.element),
                  .refused = refuses_value(fact, context),
                  .why = why_of(fact, context)});
}

Rule rule() {
  return {
      .name = "value-out-of-range",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .summary = "a number is outside what its place takes",
      .why = "libsdformat rejects numbers outside the format's bounds, too large for their type, "
             "or so small that they cannot be distinguished from zero. A negative unsigned number "
             "wraps around: a width of -1 is 4294967295.",
      .what_to_do = "Write a number within the bounds that the message names.",
      .checks = {on_schema({read::SchemaFactKind::kBadValue, read::SchemaFactKind::kOutOfRange},
                           check)},
  };
}

}  // namespace rigor::rules::value_out_of_range
