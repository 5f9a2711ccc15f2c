// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/material_script.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/schema/value.h>

namespace rigor::view {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// Walks over lines of words. Braces are words of their own.
class ScriptWords {
 public:
  explicit ScriptWords(std::string_view text) : text_(text) {}

  /// The next word; "\n" at the end of a line, nothing at the end of the text.
  std::string_view next() {
    skip_blanks();
    if (at_ == text_.size()) return {};
    const std::size_t begin = at_++;
    if (ends_word(begin)) return text_.substr(begin, 1);
    if (text_[begin] == '"') {
      at_ = std::min(text_.find_first_of("\"\n", at_), text_.size());
      const std::string_view word = text_.substr(begin + 1, at_ - begin - 1);
      if (at_ < text_.size() && text_[at_] == '"') ++at_;
      return word.empty() ? std::string_view("\"") : word;
    }
    while (at_ < text_.size() && !is_blank(text_[at_]) && !ends_word(at_)) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  /// The words up to the end of the line, or to a brace.
  std::vector<std::string_view> rest() {
    std::vector<std::string_view> words;
    while (true) {
      const std::size_t before = at_;
      const std::string_view word = next();
      if (word.empty() || word == "\n") return words;
      if (word == "{" || word == "}") {
        at_ = before;
        return words;
      }
      words.push_back(word);
    }
  }

 private:
  bool ends_word(std::size_t i) const {
    return text_[i] == '\n' || text_[i] == '{' || text_[i] == '}';
  }

  void skip_blanks() {
    while (at_ < text_.size()) {
      const std::string_view left = text_.substr(at_);
      if (is_blank(left[0])) {
        ++at_;
      } else if (left.starts_with("//")) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (left.starts_with("/*")) {
        const std::size_t end = text_.find("*/", at_ + 2);
        at_ = end == std::string_view::npos ? text_.size() : end + 2;
      } else {
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

std::optional<std::array<double, 4>> numbers_of(const std::vector<std::string_view>& words) {
  std::array<double, 4> rgba{0, 0, 0, 1};
  if (words.size() < 3) return std::nullopt;
  for (std::size_t i = 0; i < std::min(words.size(), rgba.size()); ++i) {
    const auto parsed = schema::parse_double(words[i]);
    const double* number = std::get_if<double>(&parsed);
    if (number == nullptr || !(*number >= 0)) return std::nullopt;
    rgba[i] = std::min(*number, 1.0);
  }
  return rgba;
}

/// Up to the brace that closes the material.
void read_paint(ScriptWords& words, ScriptPaint& paint) {
  bool colored = false;
  bool pictured = false;
  for (std::size_t depth = 0;;) {
    const std::string_view word = words.next();
    if (word.empty()) return;
    if (word == "{") ++depth;
    if (word == "}" && (depth == 0 || --depth == 0)) return;
    if (word == "}" || word == "{" || word == "\n") continue;
    const auto rest = words.rest();
    if (depth == 0) continue;
    if (word == "diffuse" && !colored) {
      if (const auto color = numbers_of(rest)) {
        paint.diffuse = color;
        colored = true;
      }
    } else if (word == "texture" && !pictured && !rest.empty()) {
      paint.texture = std::string(rest.front());
      pictured = true;
    }
  }
}

}  // namespace

std::optional<ScriptPaint> find_in_script(std::string_view text, std::string_view name) {
  std::map<std::string_view, ScriptPaint> known;
  ScriptWords words(text);
  std::size_t depth = 0;  // of what is no material
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "{") ++depth;
    if (word == "}" && depth > 0) --depth;
    if (word != "material" || depth > 0) continue;
    const auto head = words.rest();  // NAME, or NAME : PARENT
    ScriptPaint paint;
    if (head.size() > 2 && head[1] == ":") {
      const auto parent = known.find(head[2]);
      if (parent != known.end()) paint = parent->second;
    }
    read_paint(words, paint);
    if (head.empty()) continue;
    if (head[0] == name) return paint;
    known.try_emplace(head[0], std::move(paint));
  }
  return std::nullopt;
}

}  // namespace rigor::view
