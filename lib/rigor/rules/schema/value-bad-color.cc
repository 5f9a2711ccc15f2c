// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_bad_color {

using FaultKind = schema::ValueFault::Kind;

/// Parts such as 128 or 255 are of a scale of bytes; 2 or 8 is a slip, or a light that is to be brighter.
bool is_in_bytes(std::string_view text) {
  constexpr double kMin = 16;
  bool large = false;
  std::string_view rest = read::trimmed(text);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find_first_of(" \t\r\n"), rest.size());
    const auto parsed = schema::parse_double(rest.substr(0, end));
    rest = read::trimmed(rest.substr(end));
    const double* part = std::get_if<double>(&parsed);
    if (part == nullptr || *part < 0 || *part > 255) return false;
    large = large || *part >= kMin;
  }
  return large;
}

void check(const read::SchemaFact& fact, Context& context) {
  if (!has_kind(fact, FaultKind::kBadColor)) return;
  context.report(
      {.where = fact.where,
       .message = owner_of(fact) + " has the part " + quoted_fault(fact) + ": each is from 0 to 1",
       .subject = subject_of(fact.element),
       .help = is_in_bytes(fact.text) ? "divide the parts by 255" : "write parts from 0 to 1",
       .severity = context.is_urdf() ? std::optional(Severity::kWarning) : std::nullopt});
}

Rule rule() {
  return {
      .name = "value-bad-color",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .summary = "a color has a part below 0 or above 1",
      .why =
          "libsdformat rejects the file. urdfdom drops the color with an error, and the visual "
          "is drawn in a color of the viewer's choice. In a URDF it is a warning. Parts from 0 to "
          "255 are those of other formats.",
      .what_to_do = "Write parts from 0 to 1: divide those of a scale to 255 by 255.",
      .checks = {on_schema({read::SchemaFactKind::kBadValue}, check)},
  };
}

}  // namespace rigor::rules::value_bad_color
