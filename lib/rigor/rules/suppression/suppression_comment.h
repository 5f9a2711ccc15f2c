// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// One comment that suppresses findings, as it is written:
//
//   <!-- rigor: ignore[rule-a, rule-b] why -->
//
// Only a comment whose text begins with `rigor:` is one; what stands behind the list is the author's reason.
//
//   if (const auto comment = read_suppression(document, token)) use(comment->form, comment->names);

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <rigor/rules/suppression_fact.h>
#include <rigor/text/span.h>
#include <rigor/xml/document.h>

namespace rigor::rules {

/// How the text of such a comment begins.
inline constexpr std::string_view kSuppressionMark = "rigor:";

enum class SuppressionForm : std::uint8_t {
  kIgnore,      ///< the next element and all it contains
  kIgnoreNext,  ///< the next element's start tag
  kFileIgnore,  ///< the file
};

/// `ignore`, `ignore-next` and `file-ignore`, in the order of the enumeration.
std::vector<std::string_view> suppression_forms();

struct SuppressionComment {
  SuppressionForm form = SuppressionForm::kIgnore;
  Span word;                ///< that says the form
  std::vector<Span> names;  ///< of rules and categories; none when the comment is malformed
  SuppressionFacts faults;
};

/// Nothing when the comment is about something else.
std::optional<SuppressionComment> read_suppression(const xml::Document& document,
                                                   const xml::Token& comment);

}  // namespace rigor::rules
