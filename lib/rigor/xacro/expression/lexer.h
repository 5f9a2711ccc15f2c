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

struct Token {
  TokenType type = TokenType::kEnd;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::string text = {};  ///< of a text literal, escapes replaced; why there is trouble
  FactKind trouble = FactKind::kSyntax;  ///< or kOutsideLanguage
};

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
  Token token(TokenType type, std::uint32_t begin) const { return {type, begin, at_}; }
  Token trouble(FactKind kind, std::uint32_t begin, std::string why) const;
  char peek(std::uint32_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  std::string_view text_;
  std::uint32_t at_ = 0;
  int open_brackets_ = 0;  ///< within any, a line break is a blank
};

}  // namespace rigor::xacro
