// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The methods of texts. Upper and lower case are ASCII's: a text with other letters is named as outside
// of what rigor evaluates, not guessed.

#include <algorithm>
#include <utility>

#include <rigor/text/letter_case.h>
#include <rigor/xacro/expression/evaluator.h>
#include <rigor/xacro/expression/function.h>
#include <rigor/xacro/value/compare.h>
#include <rigor/xacro/value/format.h>
#include <rigor/xacro/value/integer.h>
#include <rigor/xacro/value/unicode.h>

namespace rigor::xacro {
namespace {

bool is_upper_byte(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower_byte(char c) { return c >= 'a' && c <= 'z'; }
bool is_letter_byte(char c) { return is_upper_byte(c) || is_lower_byte(c); }
bool is_digit_char(char c) { return c >= '0' && c <= '9'; }
char upper(char c) { return is_lower_byte(c) ? static_cast<char>(c - 'a' + 'A') : c; }

bool ascii_only(Evaluator& e, Value self) {
  if (is_ascii(self.as_text())) return true;
  e.fail(FactKind::kOutsideLanguage, {}, "letter case and classes of characters beyond ASCII");
  return false;
}

template <class Change>
Value changed(Evaluator& e, Value self, Change change) {
  if (!ascii_only(e, self)) return Value::error();
  std::string text(self.as_text());
  bool in_word = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    text[i] = change(c, i, in_word);
    in_word = is_letter_byte(c);
  }
  return e.text(text);
}

Value text_lower(Evaluator& e, Value self, Arguments&) {
  return changed(e, self, [](char c, std::size_t, bool) { return lower(c); });
}
Value text_upper(Evaluator& e, Value self, Arguments&) {
  return changed(e, self, [](char c, std::size_t, bool) { return upper(c); });
}
Value text_swapcase(Evaluator& e, Value self, Arguments&) {
  return changed(e, self,
                 [](char c, std::size_t, bool) { return is_upper_byte(c) ? lower(c) : upper(c); });
}
Value text_capitalize(Evaluator& e, Value self, Arguments&) {
  return changed(e, self, [](char c, std::size_t i, bool) { return i == 0 ? upper(c) : lower(c); });
}
Value text_title(Evaluator& e, Value self, Arguments&) {
  return changed(e, self,
                 [](char c, std::size_t, bool in_word) { return in_word ? lower(c) : upper(c); });
}

template <class Test>
Value all_of_text(Evaluator& e, Value self, Test test) {
  if (!ascii_only(e, self)) return Value::error();
  const std::string_view text = self.as_text();
  return Value::boolean(!text.empty() && std::all_of(text.begin(), text.end(), test));
}

Value text_isdigit(Evaluator& e, Value self, Arguments&) {
  return all_of_text(e, self, is_digit_char);
}
Value text_isalpha(Evaluator& e, Value self, Arguments&) {
  return all_of_text(e, self, is_letter_byte);
}
Value text_isalnum(Evaluator& e, Value self, Arguments&) {
  return all_of_text(e, self, [](char c) { return is_letter_byte(c) || is_digit_char(c); });
}
Value text_isspace(Evaluator&, Value self, Arguments&) {
  return Value::boolean(is_all_blank(self.as_text()));
}
Value text_isascii(Evaluator&, Value self, Arguments&) {
  return Value::boolean(is_ascii(self.as_text()));
}
Value text_isidentifier(Evaluator& e, Value self, Arguments&) {
  if (!ascii_only(e, self)) return Value::error();
  const std::string_view text = self.as_text();
  return Value::boolean(!text.empty() && !is_digit_char(text[0]) &&
                        std::all_of(text.begin(), text.end(), [](char c) {
                          return is_letter_byte(c) || is_digit_char(c) || c == '_';
                        }));
}
template <bool Upper>
Value text_iscase(Evaluator& e, Value self, Arguments&) {
  if (!ascii_only(e, self)) return Value::error();
  const std::string_view text = self.as_text();
  const bool other = std::any_of(text.begin(), text.end(), Upper ? is_lower_byte : is_upper_byte);
  return Value::boolean(
      !other && std::any_of(text.begin(), text.end(), Upper ? is_upper_byte : is_lower_byte));
}

std::optional<std::string_view> text_argument(Evaluator& e, Value v) {
  if (v.is_text()) return v.as_text();
  e.wrong_type("a text is due, not " + std::string(type_name(v)));
  return std::nullopt;
}

/// The part of a text that `start` and `end` arguments leave, and where it begins, in code points.
struct TextWindow {
  std::string_view text;
  std::size_t offset = 0;
  bool within = true;  ///< false where `start` is past the end: there not even "" is found
};

std::optional<TextWindow> window_of(Evaluator& e, Value self, const Arguments& a) {
  if (a.values.size() < 2) return TextWindow{self.as_text()};
  const auto size = static_cast<std::int64_t>(code_points(self.as_text()));
  const auto position = [&](Value v, std::int64_t otherwise) {
    if (v.is(Type::kNone)) return otherwise;
    std::int64_t i = v.is_small() ? v.integer_ : is_negative_integer(v) ? -size : size + 1;
    return i < 0 ? std::max<std::int64_t>(i + size, 0) : i;
  };
  for (const Value v : {a.get(1), a.get(2)}) {
    if (v.is(Type::kNone) || v.is_integral()) continue;
    e.wrong_type("a position in a text is a whole number");
    return std::nullopt;
  }
  const std::int64_t begin = position(a.get(1), 0);
  const std::int64_t end = std::min(position(a.get(2), size), size);
  if (begin > size) return TextWindow{{}, 0, false};
  return TextWindow{code_point_range(self.as_text(), static_cast<std::size_t>(begin),
                                     static_cast<std::size_t>(std::max(begin, end))),
                    static_cast<std::size_t>(begin), begin <= end};
}

enum class Missing : std::uint8_t { kMinusOne, kFails };

template <bool Last, Missing M>
Value text_find(Evaluator& e, Value self, Arguments& a) {
  const auto wanted = text_argument(e, a.values[0]);
  const auto window = wanted ? window_of(e, self, a) : std::nullopt;
  if (!window || !e.work(1 + self.size / 64)) return Value::error();
  const std::size_t at = !window->within ? std::string_view::npos
                         : Last          ? window->text.rfind(*wanted)
                                         : window->text.find(*wanted);
  if (at != std::string_view::npos) {
    return Value::integer(
        static_cast<std::int64_t>(window->offset + code_points(window->text.substr(0, at))));
  }
  if (M == Missing::kFails) return e.wrong_value("the text is not in it");
  return Value::integer(-1);
}

Value text_count(Evaluator& e, Value self, Arguments& a) {
  const auto wanted = text_argument(e, a.values[0]);
  const auto window = wanted ? window_of(e, self, a) : std::nullopt;
  if (!window || !e.work(1 + self.size / 16)) return Value::error();
  if (!window->within) return Value::integer(0);
  if (wanted->empty())
    return Value::integer(static_cast<std::int64_t>(code_points(window->text)) + 1);
  std::int64_t count = 0;
  for (std::size_t at = 0; (at = window->text.find(*wanted, at)) != std::string_view::npos;
       at += wanted->size())
    ++count;
  return Value::integer(count);
}

template <bool AtEnd>
Value text_startswith(Evaluator& e, Value self, Arguments& a) {
  const auto window = window_of(e, self, a);
  if (!window) return Value::error();
  std::vector<Value> wanted{a.values[0]};
  if (wanted[0].is(Type::kTuple)) wanted = a.values[0].sequence_->items->values;
  for (const Value v : wanted) {
    const auto text = text_argument(e, v);
    if (!text) return Value::error();
    if (window->within && (AtEnd ? window->text.ends_with(*text) : window->text.starts_with(*text)))
      return Value::boolean(true);
  }
  return Value::boolean(false);
}

enum class Side : std::uint8_t { kBoth, kLeft, kRight };

template <Side S>
Value text_strip(Evaluator& e, Value self, Arguments& a) {
  std::string_view text = self.as_text();
  if (a.get(0).is(Type::kNone)) {
    if (S != Side::kRight) text = stripped_left(text);
    if (S != Side::kLeft) text = stripped_right(text);
    return Value::text(text);
  }
  const auto characters = text_argument(e, a.values[0]);
  if (!characters) return Value::error();
  const auto listed = [&characters](std::string_view c) {
    return characters->find(c) != std::string_view::npos;
  };
  while (S != Side::kRight && !text.empty()) {
    std::size_t at = 0;
    next_code_point(text, at);
    if (!listed(text.substr(0, at))) break;
    text.remove_prefix(at);
  }
  while (S != Side::kLeft && !text.empty()) {
    std::size_t begin = text.size() - 1;
    while (begin > 0 && (static_cast<unsigned char>(text[begin]) & 0xC0) == 0x80) --begin;
    if (!listed(text.substr(begin))) break;
    text.remove_suffix(text.size() - begin);
  }
  return Value::text(text);
}

/// `maxsplit`, where a negative one is none.
std::size_t most_splits(const Arguments& a) {
  const Value most = a.find("maxsplit").value_or(a.get(1, Value::integer(-1)));
  return most.is_small() && most.integer_ >= 0 ? static_cast<std::size_t>(most.integer_)
                                               : static_cast<std::size_t>(-1);
}

template <bool FromRight>
Value text_split(Evaluator& e, Value self, Arguments& a) {
  const Value separator = a.find("sep").value_or(a.get(0));
  std::size_t left = most_splits(a);
  std::vector<Value> parts;
  std::string_view text = self.as_text();
  if (!e.fits(text.size() / 2)) return Value::error();
  if (separator.is(Type::kNone)) {
    text = FromRight ? stripped_right(text) : stripped_left(text);
    while (!text.empty()) {
      std::string_view word;
      if (left-- == 0) {
        word = std::exchange(text, {});  // with the blanks on its far side
      } else if (!FromRight) {
        std::size_t at = 0;
        while (at < text.size()) {
          std::size_t next = at;
          if (is_blank(next_code_point(text, next))) break;
          at = next;
        }
        word = text.substr(0, at);
        text = stripped_left(text.substr(at));
      } else {
        std::size_t begin = text.size();
        while (begin > 0) {
          std::size_t before = begin - 1;
          while (before > 0 && (static_cast<unsigned char>(text[before]) & 0xC0) == 0x80) --before;
          std::size_t at = before;
          if (is_blank(next_code_point(text, at))) break;
          begin = before;
        }
        word = text.substr(begin);
        text = stripped_right(text.substr(0, begin));
      }
      parts.push_back(Value::text(word));
    }
  } else {
    const auto by = text_argument(e, separator);
    if (!by) return Value::error();
    if (by->empty()) return e.wrong_value("an empty separator");
    while (left-- > 0) {
      const std::size_t at = FromRight ? text.rfind(*by) : text.find(*by);
      if (at == std::string_view::npos) break;
      parts.push_back(Value::text(FromRight ? text.substr(at + by->size()) : text.substr(0, at)));
      text = FromRight ? text.substr(0, at) : text.substr(at + by->size());
    }
    parts.push_back(Value::text(text));
  }
  if (FromRight) std::reverse(parts.begin(), parts.end());
  return e.list(std::move(parts));
}

Value text_splitlines(Evaluator& e, Value self, Arguments& a) {
  const bool keep = is_true(a.find("keepends").value_or(a.get(0, Value::boolean(false))));
  std::vector<Value> lines;
  std::string_view text = self.as_text();
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\n\r\v\f\x1c\x1d\x1e"), text.size());
    const std::size_t next = end == text.size()              ? end
                             : text.substr(end, 2) == "\r\n" ? end + 2
                                                             : end + 1;
    lines.push_back(Value::text(text.substr(0, keep ? next : end)));
    text.remove_prefix(next);
  }
  return e.list(std::move(lines));
}

template <bool FromRight>
Value text_partition(Evaluator& e, Value self, Arguments& a) {
  const auto by = text_argument(e, a.values[0]);
  if (!by) return Value::error();
  if (by->empty()) return e.wrong_value("an empty separator");
  const std::string_view text = self.as_text();
  const std::size_t at = FromRight ? text.rfind(*by) : text.find(*by);
  if (at == std::string_view::npos) {
    const Value none = Value::text({});
    return e.heap().tuple(FromRight ? std::vector<Value>{none, none, self}
                                    : std::vector<Value>{self, none, none});
  }
  return e.heap().tuple(
      {Value::text(text.substr(0, at)), a.values[0], Value::text(text.substr(at + by->size()))});
}

Value text_replace(Evaluator& e, Value self, Arguments& a) {
  const auto from = text_argument(e, a.values[0]);
  const auto to = from ? text_argument(e, a.values[1]) : std::nullopt;
  if (!to) return Value::error();
  std::size_t left = a.get(2).is_small() && a.get(2).integer_ >= 0
                         ? static_cast<std::size_t>(a.get(2).integer_)
                         : static_cast<std::size_t>(-1);
  const std::string_view text = self.as_text();
  std::string result;
  std::size_t at = 0;
  while (left > 0 && result.size() <= e.bounds().text_bytes) {
    if (from->empty()) {
      if (at > text.size()) break;
      result += *to;
      --left;
      if (at == text.size()) return e.text(result);
      const std::size_t begin = at;
      next_code_point(text, at);
      result += text.substr(begin, at - begin);
      continue;
    }
    const std::size_t found = text.find(*from, at);
    if (found == std::string_view::npos) break;
    result += text.substr(at, found - at);
    result += *to;
    at = found + from->size();
    --left;
  }
  result += text.substr(std::min(at, text.size()));
  return e.text(result);
}

Value text_join(Evaluator& e, Value self, Arguments& a) {
  const auto items = e.items_of(a.values[0]);
  if (!items) return Value::error();
  std::string result;
  for (std::size_t i = 0; i < items->size(); ++i) {
    const auto part = text_argument(e, (*items)[i]);
    if (!part) return Value::error();
    if (i > 0) result += self.as_text();
    result += *part;
    if (result.size() > e.bounds().text_bytes) break;
  }
  return e.text(result);
}

template <Side S>
Value text_pad(Evaluator& e, Value self, Arguments& a) {
  const std::string_view fill = a.has(1) && a.values[1].is_text() ? a.values[1].as_text() : " ";
  if (!a.values[0].is_small() || code_points(fill) != 1)
    return e.wrong_type("a width and one character are due");
  const auto size = static_cast<std::int64_t>(code_points(self.as_text()));
  const std::int64_t width = std::max<std::int64_t>(a.values[0].integer_, 0);
  const std::int64_t missing = width - size;
  if (missing <= 0) return self;
  if (static_cast<std::uint64_t>(missing) > e.bounds().text_bytes)
    return e.fail(FactKind::kBoundReached, {}, "the length of a text");
  const std::int64_t before = S == Side::kLeft    ? missing
                              : S == Side::kRight ? 0
                                                  : missing / 2 + (missing & width & 1);
  std::string result;
  for (std::int64_t i = 0; i < before; ++i) result += fill;
  result += self.as_text();
  for (std::int64_t i = before; i < missing; ++i) result += fill;
  return e.text(result);
}

Value text_zfill(Evaluator& e, Value self, Arguments& a) {
  if (!a.values[0].is_small()) return e.wrong_type("a width is due");
  const std::string_view text = self.as_text();
  const std::int64_t missing = std::max<std::int64_t>(a.values[0].integer_, 0) -
                               static_cast<std::int64_t>(code_points(text));
  if (missing <= 0) return self;
  if (static_cast<std::uint64_t>(missing) > e.bounds().text_bytes)
    return e.fail(FactKind::kBoundReached, {}, "the length of a text");
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  return e.text(std::string(text.substr(0, sign)) +
                std::string(static_cast<std::size_t>(missing), '0') +
                std::string(text.substr(sign)));
}

Value text_expandtabs(Evaluator& e, Value self, Arguments& a) {
  const Value size = a.find("tabsize").value_or(a.get(0, Value::integer(8)));
  const std::int64_t tab = size.is_small() ? std::clamp<std::int64_t>(size.integer_, 0, 1000) : 8;
  std::string result;
  std::int64_t column = 0;
  for (std::size_t at = 0; at < self.size;) {
    const std::size_t begin = at;
    const std::uint32_t c = next_code_point(self.as_text(), at);
    if (c == '\t') {
      const std::int64_t blanks = tab == 0 ? 0 : tab - column % tab;
      result.append(static_cast<std::size_t>(blanks), ' ');
      column += blanks;
    } else {
      result += self.as_text().substr(begin, at - begin);
      column = c == '\n' || c == '\r' ? 0 : column + 1;
    }
  }
  return e.text(result);
}

Value text_removeprefix(Evaluator& e, Value self, Arguments& a) {
  const auto prefix = text_argument(e, a.values[0]);
  if (!prefix) return Value::error();
  return self.as_text().starts_with(*prefix) ? Value::text(self.as_text().substr(prefix->size()))
                                             : self;
}
Value text_removesuffix(Evaluator& e, Value self, Arguments& a) {
  const auto suffix = text_argument(e, a.values[0]);
  if (!suffix) return Value::error();
  const bool there = self.as_text().ends_with(*suffix);
  return there ? Value::text(self.as_text().substr(0, self.size - suffix->size())) : self;
}

Value text_format(Evaluator& e, Value self, Arguments& a) {
  const auto text = format_braces(e, self.as_text(), a);
  return text ? e.text(*text) : Value::error();
}

constexpr Function kTextMethods[] = {{"capitalize", text_capitalize, 0, 0},
                                     {"casefold", text_lower, 0, 0},
                                     {"center", text_pad<Side::kBoth>, 1, 2},
                                     {"count", text_count, 1, 3},
                                     {"endswith", text_startswith<true>, 1, 3},
                                     {"expandtabs", text_expandtabs, 0, 1, "tabsize"},
                                     {"find", text_find<false, Missing::kMinusOne>, 1, 3},
                                     {"format", text_format, 0, kAnyCount, "*"},
                                     {"index", text_find<false, Missing::kFails>, 1, 3},
                                     {"isalnum", text_isalnum, 0, 0},
                                     {"isalpha", text_isalpha, 0, 0},
                                     {"isascii", text_isascii, 0, 0},
                                     {"isdecimal", text_isdigit, 0, 0},
                                     {"isdigit", text_isdigit, 0, 0},
                                     {"isidentifier", text_isidentifier, 0, 0},
                                     {"islower", text_iscase<false>, 0, 0},
                                     {"isnumeric", text_isdigit, 0, 0},
                                     {"isspace", text_isspace, 0, 0},
                                     {"isupper", text_iscase<true>, 0, 0},
                                     {"join", text_join, 1, 1},
                                     {"ljust", text_pad<Side::kRight>, 1, 2},
                                     {"lower", text_lower, 0, 0},
                                     {"lstrip", text_strip<Side::kLeft>, 0, 1},
                                     {"partition", text_partition<false>, 1, 1},
                                     {"removeprefix", text_removeprefix, 1, 1},
                                     {"removesuffix", text_removesuffix, 1, 1},
                                     {"replace", text_replace, 2, 3},
                                     {"rfind", text_find<true, Missing::kMinusOne>, 1, 3},
                                     {"rindex", text_find<true, Missing::kFails>, 1, 3},
                                     {"rjust", text_pad<Side::kLeft>, 1, 2},
                                     {"rpartition", text_partition<true>, 1, 1},
                                     {"rsplit", text_split<true>, 0, 2, "sep maxsplit"},
                                     {"rstrip", text_strip<Side::kRight>, 0, 1},
                                     {"split", text_split<false>, 0, 2, "sep maxsplit"},
                                     {"splitlines", text_splitlines, 0, 1, "keepends"},
                                     {"startswith", text_startswith<false>, 1, 3},
                                     {"strip", text_strip<Side::kBoth>, 0, 1},
                                     {"swapcase", text_swapcase, 0, 0},
                                     {"title", text_title, 0, 0},
                                     {"upper", text_upper, 0, 0},
                                     {"zfill", text_zfill, 1, 1}};

}  // namespace

const Function* text_method(std::string_view name) { return function_named(kTextMethods, name); }

}  // namespace rigor::xacro
