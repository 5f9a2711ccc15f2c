// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An expression's text as Python's tokens.

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <rigor/xacro/fact.h>

namespace rigor::xacro {

enum class TokenType : std::uint8_t { kEnd, kName, kNumber, kText, kOperator, kTrouble };

/// An operator as a number, of its first three bytes: tokens are compared with operators all the time.
constexpr std::uint32_t operator_code(std::string_view text) {
  std::uint32_t code = 0;
  for (const char c : text) code = code << 8U | static_cast<unsigned char>(c);
  return code;
}

struct Token {
  TokenType type = TokenType::kEnd;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint32_t code = 0;  ///< of an operator
  /// Of a text literal, escapes replaced; why there is trouble. Valid up to the next token, but for a text
  /// without escapes, which is a part of the expression.
  std::string_view text = {};
  FactKind trouble = FactKind::kSyntax;  ///< or kOutsideLanguage
};

/// Letters, digits and `_`; a keyword is one, too.
bool is_name(std::string_view text);

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  Token next();

 private:
  bool skip_blanks();
  Token name_or_prefix();
  Token number();
  Token quoted(std::uint32_t begin, bool raw);
  bool append_escape(std::string& into);
  Token operation();
  Token token(TokenType type, std::uint32_t begin) const { return {type, begin, at_, 0}; }
  Token trouble(FactKind kind, std::uint32_t begin, std::string why);
  char peek(std::uint32_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  std::string_view text_;
  std::uint32_t at_ = 0;
  int open_brackets_ = 0;  ///< within any, a line break is a blank
  std::string kept_;       ///< what a token's text refers to
};

}  // namespace rigor::xacro
