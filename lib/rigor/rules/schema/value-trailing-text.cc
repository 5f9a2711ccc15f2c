// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/refused_value.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_trailing_text {

using FaultKind = schema::ValueFault::Kind;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// "1, 2, 3" loses its commas, "1.5 kg" its unit.
std::vector<Edit> numbers_alone(const read::SchemaFact& fact, const Context& context) {
  const std::string_view text = fact.text;
  const std::size_t first = fact.value_fault->begin;
  if (text.substr(first, 1) != "," ||
      context.bytes(fact.where) != text.substr(first, fact.where.size())) {
    return {without_part(context, fact.where)};
  }
  std::vector<Edit> edits;
  for (std::size_t at = first; at != text.npos; at = text.find(',', at + 1)) {
    Span comma = fact.where;
    comma.begin += static_cast<std::uint32_t>(at - first);
    comma.end = comma.begin + 1;
    const bool apart = at + 1 < text.size() && is_space(text[at + 1]);
    edits.push_back({comma, apart ? "" : " "});
  }
  return edits;
}

/// What is cut off may be a part of the number: "3.1l2e-05", "1e".
bool is_part_of_number(std::string_view tail) {
  if (tail.starts_with(',')) return false;
  return tail.starts_with('e') || tail.starts_with('E') ||
         tail.find_first_of("0123456789") != tail.npos;
}

std::optional<Fix> fix_for(const read::SchemaFact& fact, const Context& context) {
  const auto& fault = *fact.value_fault;
  if (is_part_of_number(fact.text.substr(fault.begin, fault.end - fault.begin))) {
    return std::nullopt;
  }
  return fix_of("remove it", Applicability::kUnsafe, numbers_alone(fact, context));
}

/// "818.0" is the count that its author meant, and libsdformat reads it so.
std::optional<Severity> severity_of(const read::SchemaFact& fact, const Context& context) {
  const auto& fault = *fact.value_fault;
  std::string_view rest = fact.text.substr(fault.begin, fault.end - fault.begin);
  rest = read::trimmed(rest);
  const bool zeros = rest.starts_with('.') && rest.find_first_not_of('0', 1) == rest.npos;
  if (zeros && context.is_sdf()) return Severity::kInfo;
  // "0.5kg" is read as the 0.5 kg that are meant, "0.5g" is not.
  if (context.is_sdf() && !fact.node->unit().empty() && rest == fact.node->unit() &&
      !refuses_value(fact, context)) {
    return Severity::kWarning;
  }
  return std::nullopt;
}

std::string why_of(const read::SchemaFact& fact, const Context& context) {
  if (context.is_urdf()) {
    if (urdfdom_refuses_in(fact.element)) return "urdfdom rejects the whole robot.";
    const auto parent = fact.element.parent();
    const bool inertial = parent && parent->name() == "inertial";
    return inertial ? "urdfdom drops the whole <inertial> with an error, so the link has no mass."
                    : "urdfdom stops reading the link with an error.";
  }
  if (refuses_value(fact, context)) return "libsdformat rejects the file.";
  const std::string_view read = read::trimmed(fact.text.substr(0, fact.value_fault->begin));
  if (read.empty() || read.find_first_of(" \t\n") != read.npos) {
    return "libsdformat reads the numbers before it, and ignores the rest silently.";
  }
  return "libsdformat reads " + std::string(read) + ", and ignores the rest silently.";
}

void check(const read::SchemaFact& fact, Context& context) {
  if (!has_kind(fact, FaultKind::kTrailingText) || left_for_xacro(fact)) return;
  const std::string_view unit = fact.node->unit();
  context.report({.where = fact.where,
                  .message = owner_of(fact) + " takes " + std::string(expected(fact, context)) +
                             ": " + quoted_fault(fact) +
                             (context.is_urdf() ? " is rejected" : " is ignored"),
                  .subject = subject_of(fact.element),
                  .help = unit.empty() ? "" : "the number is in " + std::string(unit),
                  .fix = fix_for(fact, context),
                  .refused = refuses_value(fact, context),
                  .why = why_of(fact, context),
                  .severity = severity_of(fact, context)});
}

Rule rule() {
  return {
      .name = "value-trailing-text",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .fix = FixGrade::kUnsafe,
      .summary = "text follows a number",
      .why = "libsdformat reads the number, or the part of it that it understands, and ignores "
             "the rest: 1.5kg is 1.5, 1e is 1. urdfdom rejects the value. Numbers carry no unit: "
             "lengths are in meters, angles in radians, masses in kilograms. The unit itself "
             "after a number of SDF is a warning.",
      .what_to_do = "Write the number alone, in the unit of the format.",
      .checks = {on_schema({read::SchemaFactKind::kBadValue}, check)},
  };
}

}  // namespace rigor::rules::value_trailing_text
