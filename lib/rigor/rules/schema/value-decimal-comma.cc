// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/refused_value.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_decimal_comma {

using FaultKind = schema::ValueFault::Kind;

/// 1,5 can only be 1.5; in a vector 1,2,3 may as well be three numbers.
std::optional<Fix> write_point(const read::SchemaFact& fact, std::string_view number) {
  const schema::Type type = fact.node->type();
  if (type != schema::Type::kDouble && type != schema::Type::kFloat) return std::nullopt;
  const std::size_t comma = number.find(',');
  if (comma == std::string_view::npos || number.find(',', comma + 1) != std::string_view::npos) {
    return std::nullopt;
  }
  Span span = fact.where;
  span.begin += static_cast<std::uint32_t>(comma);
  span.end = span.begin + 1;
  return Fix{"write a point", Applicability::kUnsafe, {{span, "."}}};
}

void check(const read::SchemaFact& fact, Context& context) {
  if (!has_kind(fact, FaultKind::kDecimalComma)) return;
  const std::string_view number = context.bytes(fact.where);
  context.report(
      {.where = fact.where,
       .message = owner_of(fact) + " has a comma in " + quoted_fault(fact) +
                  (context.is_urdf() ? ": urdfdom refuses it" : ": what follows it is passed over"),
       .subject = subject_of(fact.element),
       .help = "write a decimal point, and spaces between numbers",
       .fix = write_point(fact, number),
       .refused = refuses_value(fact, context)});
}

Rule rule() {
  return {
      .name = "value-decimal-comma",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .fix = FixGrade::kUnsafe,
      .summary = "a number has a comma where a point is due",
      .why = "libsdformat reads the part before the comma: 1,5 is 1. urdfdom refuses the value.",
      .what_to_do = "Write a point; between the numbers of a vector write spaces.",
      .checks = {on_schema({read::SchemaFactKind::kBadValue}, check)},
  };
}

}  // namespace rigor::rules::value_decimal_comma
