// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/refused_value.h>
#include <rigor/rules/schema/value_text.h>
#include <rigor/write/numbers.h>

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

/// How many numbers a value of the type has.
std::size_t numbers_due(const read::SchemaFact& fact, const Context& context) {
  switch (fact.node->type()) {
    case schema::Type::kVector2:
    case schema::Type::kVector2i: return 2;
    case schema::Type::kVector3:
    case schema::Type::kQuaternion: return 3;
    case schema::Type::kColor: return context.is_urdf() ? 4 : 0;
    case schema::Type::kPose: return expected(fact, context).starts_with("seven") ? 7 : 6;
    default: return 0;
  }
}

/// Of a value that is separated by commas alone, and has as many numbers as are due.
std::optional<Fix> write_spaces(const read::SchemaFact& fact, const Context& context) {
  const std::string_view text = fact.text;
  const std::size_t before = fact.value_fault->begin;
  Span whole = fact.where;
  whole.begin -= static_cast<std::uint32_t>(before);
  whole.end = whole.begin + static_cast<std::uint32_t>(text.size());
  if (context.bytes(whole) != text) return std::nullopt;
  std::string apart(text);
  Fix fix{"separate the numbers by spaces", Applicability::kUnsafe, {}};
  for (std::size_t at = text.find(','); at != text.npos; at = text.find(',', at + 1)) {
    const auto begin = whole.begin + static_cast<std::uint32_t>(at);
    apart[at] = ' ';
    fix.edits.push_back({{whole.source, begin, begin + 1}, " "});
  }
  const auto numbers = write::numbers_in(apart);
  const std::size_t due = numbers_due(fact, context);
  // Between all of them: "1,5 2,0 3,0" may be three numbers as well.
  if (!numbers || numbers->size() != due || fix.edits.size() + 1 != due) return std::nullopt;
  return fix;
}

void check(const read::SchemaFact& fact, Context& context) {
  if (!has_kind(fact, FaultKind::kDecimalComma)) return;
  const std::string_view number = context.bytes(fact.where);
  const auto fix = write_point(fact, number);
  context.report(
      {.where = fact.where,
       .message = owner_of(fact) + " has a comma in " + quoted_fault(fact) +
                  (context.is_urdf() ? ": urdfdom rejects it" : ": what follows it is ignored"),
       .subject = subject_of(fact.element),
       .help = "write a decimal point, and spaces between numbers",
       .fix = fix ? fix : write_spaces(fact, context),
       .refused = refuses_value(fact, context)});
}

Rule rule() {
  return {
      .name = "value-decimal-comma",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .fix = FixGrade::kUnsafe,
      .summary = "a number has a comma where a point is due",
      .why = "libsdformat reads the part before the comma: 1,5 is 1. urdfdom rejects the value.",
      .what_to_do = "Write a point; between the numbers of a vector write spaces.",
      .checks = {on_schema({read::SchemaFactKind::kBadValue}, check)},
  };
}

}  // namespace rigor::rules::value_decimal_comma
