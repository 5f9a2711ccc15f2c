// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/expression/lexer.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include <rigor/text/letter_case.h>
#include <rigor/xml/decode.h>

namespace rigor::xacro {
namespace {

enum NameByte : std::uint8_t { kFirstByte = 1, kDigitByte = 2 };

constexpr std::array<std::uint8_t, 256> kNameBytes = [] {
  std::array<std::uint8_t, 256> bytes{};
  for (std::size_t c = 0; c < bytes.size(); ++c) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    if (letter || c >= 0x80) bytes[c] = kFirstByte;
    if (c >= '0' && c <= '9') bytes[c] = kDigitByte;
  }
  return bytes;
}();

bool is_digit_byte(char c) { return c >= '0' && c <= '9'; }
bool begins_name(char c) { return kNameBytes[static_cast<unsigned char>(c)] == kFirstByte; }
bool continues_name(char c) { return kNameBytes[static_cast<unsigned char>(c)] != 0; }

/// Of two and three bytes, the longest first.
constexpr std::array<std::string_view, 20> kLongOperators{
    "**=", "//=", "<<=", ">>=", "...", "**", "//", "<<", ">>", "<=",
    ">=",  "==",  "!=",  ":=",  "->",  "+=", "-=", "*=", "/=", "%="};
constexpr std::string_view kSingleOperators = "+-*/%@<>()[]{},:.=|&^~;";

}  // namespace

bool is_name(std::string_view text) {
  return !text.empty() && begins_name(text[0]) &&
         std::all_of(text.begin(), text.end(), continues_name);
}

Token Lexer::trouble(FactKind kind, std::uint32_t begin, std::string why) {
  kept_ = std::move(why);
  return {TokenType::kTrouble, begin, std::max(at_, begin), 0, kept_, kind};
}

/// False at a line break that ends the expression.
bool Lexer::skip_blanks() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == '#') {
      while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    } else if (c == '\\' && peek(1) == '\n') {
      at_ += 2;
    } else if (c == '\n' || c == '\r') {
      if (open_brackets_ == 0) return false;
      ++at_;
    } else if (c == ' ' || c == '\t' || c == '\f') {
      ++at_;
    } else {
      break;
    }
  }
  return true;
}

Token Lexer::next() {
  if (!skip_blanks()) return trouble(FactKind::kSyntax, at_, "a line break within the expression");
  if (at_ >= text_.size()) return token(TokenType::kEnd, at_);
  const char c = text_[at_];
  if (begins_name(c)) return name_or_prefix();
  if (is_digit_byte(c) || (c == '.' && is_digit_byte(peek(1)))) return number();
  if (c == '\'' || c == '"') return quoted(at_, false);
  return operation();
}

Token Lexer::name_or_prefix() {
  const std::uint32_t begin = at_;
  while (at_ < text_.size() && continues_name(text_[at_])) ++at_;
  if (peek() != '\'' && peek() != '"') return token(TokenType::kName, begin);
  const std::string prefix = lowered(text_.substr(begin, at_ - begin));
  if (prefix == "r" || prefix == "u") return quoted(begin, prefix == "r");
  if (prefix == "f" || prefix == "rf" || prefix == "fr") {
    return trouble(FactKind::kOutsideLanguage, begin, "formatted string literals (f'…')");
  }
  if (prefix == "b" || prefix == "rb" || prefix == "br") {
    return trouble(FactKind::kOutsideLanguage, begin, "bytes literals (b'…')");
  }
  return token(TokenType::kName, begin);
}

Token Lexer::number() {
  const std::uint32_t begin = at_;
  const auto digits = [this](std::string_view allowed) {
    const std::uint32_t first = at_;
    while (at_ < text_.size()) {
      const bool digit = allowed.find(lower(text_[at_])) != std::string_view::npos;
      const bool joint = text_[at_] == '_' && at_ + 1 < text_.size() &&
                         allowed.find(lower(text_[at_ + 1])) != std::string_view::npos;
      if (!digit && !joint) break;
      ++at_;
    }
    return at_ > first;
  };
  constexpr std::string_view kDecimal = "0123456789";
  const char base = lower(peek(1));
  if (peek() == '0' && (base == 'x' || base == 'o' || base == 'b')) {
    at_ += 2;
    if (!digits(base == 'x' ? "0123456789abcdef" : base == 'o' ? "01234567" : "01")) {
      return trouble(FactKind::kSyntax, begin, "a number without digits");
    }
  } else {
    digits(kDecimal);
    bool real = false;
    if (peek() == '.') {
      real = true;
      ++at_;
      digits(kDecimal);
    }
    const std::uint32_t sign = peek(1) == '+' || peek(1) == '-' ? 2 : 1;
    if (lower(peek()) == 'e' && is_digit_byte(peek(sign))) {
      real = true;
      at_ += sign;
      digits(kDecimal);
    }
    if (lower(peek()) == 'j') {
      ++at_;
      return trouble(FactKind::kOutsideLanguage, begin, "complex numbers");
    }
    const std::string_view whole = text_.substr(begin, at_ - begin);
    if (!real && whole[0] == '0' && whole.find_first_not_of("0_") != std::string_view::npos) {
      return trouble(FactKind::kSyntax, begin, "leading zeros in a whole number");
    }
  }
  if (continues_name(peek()) && !begins_name(peek())) {
    return trouble(FactKind::kSyntax, begin, "a malformed number");
  }
  // `1if x else 2` is Python; `2x` is not.
  if (begins_name(peek())) {
    const std::string_view rest = text_.substr(at_);
    bool keyword = false;
    for (const std::string_view word : {"if", "else", "and", "or", "in", "is", "for", "not"}) {
      keyword = keyword || (rest.starts_with(word) &&
                            (rest.size() == word.size() || !continues_name(rest[word.size()])));
    }
    if (!keyword) return trouble(FactKind::kSyntax, begin, "a name directly after a number");
  }
  return token(TokenType::kNumber, begin);
}

bool Lexer::append_escape(std::string& into) {
  const char c = peek(1);
  at_ += 2;
  constexpr std::string_view kLetters = "\\'\"abfnrtv";
  constexpr std::string_view kMeanings = "\\'\"\a\b\f\n\r\t\v";
  if (const std::size_t letter = kLetters.find(c); letter != std::string_view::npos && c != '\0') {
    into += kMeanings[letter];
    return true;
  }
  if (c == '\n') return true;
  std::uint32_t code_point = 0;
  if (c >= '0' && c <= '7') {
    --at_;
    for (int i = 0; i < 3 && peek() >= '0' && peek() <= '7'; ++i, ++at_) {
      code_point = code_point * 8 + static_cast<std::uint32_t>(peek() - '0');
    }
  } else if (c == 'x' || c == 'u' || c == 'U') {
    const std::uint32_t size = c == 'x' ? 2 : c == 'u' ? 4 : 8;
    const std::string_view digits = text_.substr(std::min<std::size_t>(at_, text_.size()), size);
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), code_point, 16);
    if (digits.size() < size || error != std::errc() || end != digits.data() + size) return false;
    at_ += size;
  } else if (c == 'N') {
    return false;
  } else {
    // Python keeps a backslash that means nothing.
    into += '\\';
    --at_;
    return true;
  }
  if (code_point < 0x20) {
    into += static_cast<char>(code_point);
  } else {
    xml::append_utf8(into, code_point);
  }
  return true;
}

Token Lexer::quoted(std::uint32_t begin, bool raw) {
  const char quote = text_[at_];
  const std::string_view closing =
      peek(1) == quote && peek(2) == quote ? text_.substr(at_, 3) : text_.substr(at_, 1);
  at_ += static_cast<std::uint32_t>(closing.size());
  // Most texts are on one line, without escapes.
  if (closing.size() == 1) {
    const std::uint32_t first = at_;
    std::uint32_t last = first;
    while (last < text_.size() && text_[last] != quote && text_[last] != '\\' &&
           text_[last] != '\n')
      ++last;
    if (last < text_.size() && text_[last] == quote) {
      at_ = last + 1;
      Token result = token(TokenType::kText, begin);
      result.text = text_.substr(first, last - first);
      return result;
    }
  }
  std::string text;
  while (at_ < text_.size() && !text_.substr(at_).starts_with(closing)) {
    if (text_[at_] == '\n' && closing.size() == 1) break;
    if (text_[at_] != '\\' || at_ + 1 >= text_.size()) {
      text += text_[at_++];
    } else if (raw) {
      text += text_.substr(at_, 2);
      at_ += 2;
    } else if (!append_escape(text)) {
      return trouble(FactKind::kSyntax, begin, "an escape that is none");
    }
  }
  if (!text_.substr(std::min<std::size_t>(at_, text_.size())).starts_with(closing)) {
    return trouble(FactKind::kSyntax, begin, "a text without its closing quote");
  }
  at_ += static_cast<std::uint32_t>(closing.size());
  kept_ = std::move(text);
  Token result = token(TokenType::kText, begin);
  result.text = kept_;
  return result;
}

Token Lexer::operation() {
  const std::uint32_t begin = at_;
  const char first = text_[at_];
  if (kSingleOperators.find(first) == std::string_view::npos && first != '!') {
    ++at_;
    return trouble(FactKind::kSyntax, begin, std::string("the character '") + first + "'");
  }
  std::uint32_t size = 1;
  const char second = peek(1);
  // Each operator of two bytes or three ends in one of these.
  if (second == '=' || second == first || second == '>') {
    for (const std::string_view known : kLongOperators) {
      if (!text_.substr(at_).starts_with(known)) continue;
      size = static_cast<std::uint32_t>(known.size());
      break;
    }
  }
  at_ += size;
  if (size == 1) {
    if (first == '!') return trouble(FactKind::kSyntax, begin, "the character '!'");
    if (first == '(' || first == '[' || first == '{') ++open_brackets_;
    if ((first == ')' || first == ']' || first == '}') && open_brackets_ > 0) --open_brackets_;
  }
  Token result = token(TokenType::kOperator, begin);
  result.code = operator_code(text_.substr(begin, size));
  return result;
}

}  // namespace rigor::xacro
