// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <optional>
#include <string_view>

#include <rigor/read/values.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::xml_duplicate_attribute {

/// The value, with its quotes, of the attribute whose name ends at `at`.
std::string_view value_after(std::string_view bytes, std::size_t at) {
  const std::size_t open = bytes.find_first_of("\"'", at);
  if (open == std::string_view::npos) return {};
  const std::size_t close = bytes.find(bytes[open], open + 1);
  return close == std::string_view::npos ? std::string_view()
                                         : bytes.substr(open, close + 1 - open);
}

/// Of two that say the same one can go, along with the white space before it.
std::optional<Fix> remove_second(const xml::Fault& fault, std::string_view bytes) {
  const std::string_view first = value_after(bytes, fault.related.end);
  const std::string_view second = value_after(bytes, fault.where.end);
  if (second.empty() || first != second) return std::nullopt;
  Span whole = fault.where;
  whole.end = static_cast<std::uint32_t>(second.data() + second.size() - bytes.data());
  while (whole.begin > 0 && read::trimmed(bytes.substr(whole.begin - 1, 1)).empty()) --whole.begin;
  return Fix{"remove the second '" + fault.detail + "'", Applicability::kSafe, {{whole, ""}}};
}

void check(const xml::Fault& fault, Context& context) {
  context.report({.where = fault.where,
                  .message = "the attribute '" + fault.detail + "' stands twice in this tag",
                  .related = {{fault.related, "first here"}},
                  .fix = remove_second(fault, context.document().bytes())});
}

Rule rule() {
  return {
      .name = "xml-duplicate-attribute",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .fix = FixGrade::kSafe,
      .summary = "a tag has the same attribute twice",
      .why = "tinyxml2, which libsdformat, Gazebo and urdfdom read with, refuses the file at this "
             "tag.",
      .what_to_do = "Keep one of the two.",
      .checks = {on_xml({xml::FaultKind::kDuplicateAttribute}, check)},
  };
}

}  // namespace rigor::rules::xml_duplicate_attribute
