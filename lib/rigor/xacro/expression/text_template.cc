// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/expression/text_template.h>

#include <algorithm>
#include <utility>

#include <rigor/xacro/value/heap.h>
#include <rigor/xacro/value/unicode.h>

namespace rigor::xacro {
namespace {

bool names_a_value(const Expression& expression) {
  if (expression.trouble) return false;
  return std::all_of(expression.nodes.begin(), expression.nodes.end(),
                     [](const ExpressionNode& node) {
                       return node.op == Op::kName || node.op == Op::kAttribute ||
                              node.op == Op::kSubscript || node.op == Op::kConstant;
                     }) &&
         expression.nodes[expression.root].op != Op::kConstant;
}

}  // namespace

const Expression& TextTemplates::expression(std::string_view text) {
  const std::uint32_t hash = short_hash(text);
  const std::uint32_t known = expression_index_.find(
      hash, [&](std::uint32_t row) { return expressions_[row].text == text; });
  if (known != TextIndex::kNoRow) return expressions_[known];
  expression_index_.add(hash, static_cast<std::uint32_t>(expressions_.size()));
  Expression& parsed = expressions_.emplace_back(parse_expression(text, heap_, symbols_, memory_));
  if (!parsed.trouble) parsed.degrees = find_degrees(parsed, symbols_);
  heap_.charge(sizeof(Expression) + parsed.nodes.size() * sizeof(ExpressionNode));
  return parsed;
}

const TextTemplate& TextTemplates::of(std::string_view text) {
  const TextTemplate*& known = by_text_[text];
  if (known == nullptr) known = &templates_.emplace_back(taken_apart(text));
  return *known;
}

const TextTemplate& TextTemplates::of(TextCode code, std::string_view text) {
  if (code < TextCode::kFirst) return of(text);
  const TextTemplate*& known =
      by_code_[static_cast<std::uint32_t>(code) - static_cast<std::uint32_t>(TextCode::kFirst)];
  // Few are written twice, so none is looked for.
  if (known == nullptr) known = &templates_.emplace_back(taken_apart(text));
  return *known;
}

TextCode TextTemplates::new_code() {
  by_code_.push_back(nullptr);
  return static_cast<TextCode>(static_cast<std::uint32_t>(TextCode::kFirst) + by_code_.size() - 1);
}

TextTemplate TextTemplates::taken_apart(std::string_view text) {
  TextTemplate result{std::pmr::vector<TextSegment>(&memory_)};
  const auto add = [&](TextSegment::Kind kind, std::size_t begin, std::size_t end) -> TextSegment& {
    result.segments.push_back(
        {kind, text.substr(begin, end - begin), static_cast<std::uint32_t>(begin)});
    return result.segments.back();
  };
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] != '$') {
      const std::size_t end = std::min(text.find('$', at), text.size());
      add(TextSegment::Kind::kText, at, end);
      at = end;
      continue;
    }
    std::size_t dollars = at;
    while (dollars < text.size() && text[dollars] == '$') ++dollars;
    const char next = dollars < text.size() ? text[dollars] : '\0';
    const bool opens = next == '{' || next == '(';
    if (dollars - at > 1 && opens) {
      add(TextSegment::Kind::kText, at + 1, dollars + 1);
      at = dollars + 1;
      continue;
    }
    if (dollars - at == 1 && opens) {
      const std::size_t close = text.find(next == '{' ? '}' : ')', at);
      if (close != std::string_view::npos) {
        TextSegment& segment =
            add(next == '{' ? TextSegment::Kind::kExpression : TextSegment::Kind::kCommand, at + 2,
                close);
        if (next == '{' && segment.text.find('$') == std::string_view::npos) {
          const std::string_view left = stripped_left(segment.text);
          segment.skipped = static_cast<std::uint32_t>(segment.text.size() - left.size());
          segment.expression = &expression(stripped_right(left));
        }
        at = close + 1;
        continue;
      }
    }
    // A `$` at the end, or before other characters, represents itself.
    const bool last = dollars == text.size() && dollars - at == 1;
    if (!last && (opens || dollars - at > 1)) {
      result.trouble = static_cast<std::uint32_t>(at);
      break;
    }
    const std::size_t end = std::min(text.find_first_of("{($", at + 1), text.size());
    add(TextSegment::Kind::kText, at, end);
    at = end;
  }
  result.is_reference = result.segments.size() == 1 && result.segments[0].expression != nullptr &&
                        names_a_value(*result.segments[0].expression);
  return result;
}

std::uint32_t find_degrees(const Expression& expression, const Symbols& symbols) {
  std::uint32_t of_name = kNoNode;
  for (std::uint32_t i = 0; i < expression.nodes.size(); ++i) {
    const ExpressionNode& call = expression.nodes[i];
    if (call.op != Op::kCall || expression.lists[call.b] != 1) continue;
    const ExpressionNode& callee = expression.nodes[call.a];
    if (callee.op != Op::kName && callee.op != Op::kAttribute) continue;
    const std::string_view name = symbols.name(callee.symbol);
    if (name != "sin" && name != "cos" && name != "tan") continue;
    const ExpressionNode& argument = expression.nodes[expression.lists[call.b + 1]];
    if (argument.op == Op::kConstant && argument.constant.is(Type::kInteger) &&
        argument.constant.integer_ > kMostRadians) {
      return i;
    }
    if (argument.op == Op::kName && of_name == kNoNode) of_name = i;
  }
  return of_name;
}

}  // namespace rigor::xacro
