// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A text with `${…}` and `$(…)` in it, taken apart once and used as often as it occurs.
//
// `$${` and `$$(` represent `${` and `$(`. An expression ends at the first `}`, a command at the first
// `)`, whatever is between; either may hold further `${…}` and `$(…)`, which are replaced first.

#pragma once

#include <cstdint>
#include <deque>
#include <memory_resource>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <rigor/xacro/arena.h>
#include <rigor/xacro/expression/expression.h>
#include <rigor/xacro/node.h>
#include <rigor/xacro/value/text_index.h>

namespace rigor::xacro {

class Heap;

struct TextSegment {
  enum class Kind : std::uint8_t { kText, kExpression, kCommand };
  Kind kind = Kind::kText;
  std::string_view text;                   ///< without `${` and `}`
  std::uint32_t begin = 0;                 ///< of `text` in the whole
  std::uint32_t skipped = 0;               ///< blanks at the start of an expression
  const Expression* expression = nullptr;  ///< null when it holds `$` itself
};

struct TextTemplate {
  std::pmr::vector<TextSegment> segments;
  /// Where a `$` begins neither, when one does.
  std::optional<std::uint32_t> trouble;
  /// Whether it is one expression that names a value: `${size}`, `${robot.mass}`.
  bool is_reference = false;
};

/// All texts and expressions of an expansion, parsed once. Texts outlive it.
class TextTemplates {
 public:
  TextTemplates(Heap& heap, Symbols& symbols) : heap_(heap), symbols_(symbols) {}

  const TextTemplate& of(std::string_view text);
  /// The same of a text with a code, which needs no search for it.
  const TextTemplate& of(TextCode code, std::string_view text);
  const Expression& expression(std::string_view text);

  /// The next number, for a text that holds a `$`; it is taken apart when it is asked for.
  TextCode new_code();
  /// A number only where there is a `$` in the text.
  TextCode code_of(std::string_view text) {
    return text.find('$') == std::string_view::npos ? TextCode::kPlain : new_code();
  }

 private:
  TextTemplate taken_apart(std::string_view text);

  Heap& heap_;
  Symbols& symbols_;
  Arena memory_;
  std::pmr::deque<TextTemplate> templates_{&memory_};
  std::pmr::deque<Expression> expressions_{&memory_};
  TextIndex expression_index_;
  /// Of texts without a code, which are few: an argument's value, a text that an expression made.
  std::unordered_map<std::string_view, const TextTemplate*> by_text_;
  std::vector<const TextTemplate*> by_code_;  ///< null as long as nobody asked
};

}  // namespace rigor::xacro
