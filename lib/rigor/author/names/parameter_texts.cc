// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/parameter_texts.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rigor::author {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// Walks over lines; knows the keys around each text by indentation, brackets and tables.
class ParameterScanner {
 public:
  ParameterScanner(std::string_view bytes, ParameterFormat format, SourceId source,
                   const IsWantedText& is_wanted)
      : bytes_(bytes),
        is_yaml_(format == ParameterFormat::kYaml),
        source_(source),
        is_wanted_(is_wanted) {}

  std::vector<ParameterText> scan() && {
    for (std::size_t at = 0; at < bytes_.size();) {
      const std::size_t end = std::min(bytes_.find('\n', at), bytes_.size());
      line(at, end);
      at = end + 1;
    }
    return std::move(found_);
  }

 private:
  struct Key {
    std::size_t indent;
    std::string text;
  };
  struct Bracket {
    char open;
    std::string key;  // of the value that is read next
  };

  void line(std::size_t at, std::size_t end) {
    const std::size_t begin = at;
    while (at < end && bytes_[at] == ' ') ++at;
    if (brackets_.empty()) {
      line_key_.clear();
      if (!is_yaml_ && at < end && bytes_[at] == '[') return table(at, end);
      while (is_yaml_ && at + 1 < end && bytes_[at] == '-' && is_space(bytes_[at + 1])) {
        close(at - begin + 1);
        at += 2;
        while (at < end && bytes_[at] == ' ') ++at;
      }
      if (is_yaml_ && at < end) column_ = at - begin;
    }
    while (at < end) at = piece(at, end);
  }

  /// `[joints]`, `[[step]]`
  void table(std::size_t at, std::size_t end) {
    keys_.clear();
    const std::size_t first = bytes_.find_first_not_of('[', at);
    const std::size_t last = std::min(bytes_.find(']', at), end);
    if (first < last) keys_.push_back({0, std::string(bytes_.substr(first, last - first))});
  }

  /// Forgets keys at this column and behind it.
  void close(std::size_t column) {
    while (!keys_.empty() && keys_.back().indent >= column) keys_.pop_back();
  }

  /// The next offset; that of the line's end behind a comment.
  std::size_t piece(std::size_t at, std::size_t end) {
    const char c = bytes_[at];
    if (c == '#' && (at == 0 || is_space(bytes_[at - 1]) || bytes_[at - 1] == '\n')) return end;
    if (c == '[' || c == '{') {
      brackets_.push_back({c, {}});
    } else if (c == ']' || c == '}') {
      if (!brackets_.empty()) brackets_.pop_back();
    } else if (c == ',') {
      if (!brackets_.empty() && brackets_.back().open == '{') brackets_.back().key.clear();
    } else if (c == '"' || c == '\'') {
      const std::size_t close = std::min(bytes_.find(c, at + 1), end);
      return std::min(end, scalar(at + 1, close, std::min(close + 1, end), end));
    } else if (!is_space(c)) {
      const std::size_t past = plain_end(at, end);
      std::size_t trimmed = past;
      while (trimmed > at && is_space(bytes_[trimmed - 1])) --trimmed;
      return std::max(at + 1, scalar(at, trimmed, past, end));
    }
    return at + 1;
  }

  std::size_t plain_end(std::size_t at, std::size_t end) const {
    for (; at < end; ++at) {
      const char c = bytes_[at];
      if (is_key_mark(at, end)) return at;
      if (!brackets_.empty() && (c == ',' || c == ']' || c == '}' || c == '[' || c == '{'))
        return at;
      if (c == '#' && at > 0 && is_space(bytes_[at - 1])) return at;
    }
    return end;
  }

  bool is_key_mark(std::size_t at, std::size_t end) const {
    if (!is_yaml_) return bytes_[at] == '=';
    return bytes_[at] == ':' && (at + 1 == end || is_space(bytes_[at + 1]));
  }

  /// A text from `begin` to `end`; `past` is behind its quote.
  std::size_t scalar(std::size_t begin, std::size_t end, std::size_t past, std::size_t line_end) {
    std::size_t next = past;
    while (next < line_end && is_space(bytes_[next])) ++next;
    const bool is_key = next < line_end && is_key_mark(next, line_end);
    std::string text(bytes_.substr(begin, end - begin));
    if (is_key && brackets_.empty() && is_yaml_) close(column_);
    if (is_key && brackets_.empty()) line_key_.clear();
    take(begin, text, is_key ? ParameterRole::kKey : ParameterRole::kValue);
    if (!is_key) return past;
    if (!brackets_.empty()) {
      brackets_.back().key = std::move(text);
    } else if (is_yaml_) {
      keys_.push_back({column_, std::move(text)});
    } else {
      line_key_ = std::move(text);
    }
    return next + 1;
  }

  void take(std::size_t begin, std::string_view text, ParameterRole role) {
    if (!is_wanted_(text, role)) return;
    ParameterText found;
    found.where = {source_, static_cast<std::uint32_t>(begin),
                   static_cast<std::uint32_t>(begin + text.size())};
    for (const Key& key : keys_) found.keys.push_back(key.text);
    if (!line_key_.empty()) found.keys.push_back(line_key_);
    for (const Bracket& bracket : brackets_) {
      if (!bracket.key.empty()) found.keys.push_back(bracket.key);
    }
    found_.push_back(std::move(found));
  }

  std::string_view bytes_;
  bool is_yaml_;
  SourceId source_;
  const IsWantedText& is_wanted_;
  std::vector<ParameterText> found_;
  std::vector<Key> keys_;
  std::vector<Bracket> brackets_;
  std::string line_key_;  // of TOML
  std::size_t column_ = 0;
};

}  // namespace

std::vector<ParameterText> parameter_texts(std::string_view bytes, ParameterFormat format,
                                           SourceId source, const IsWantedText& is_wanted) {
  return ParameterScanner(bytes, format, source, is_wanted).scan();
}

}  // namespace rigor::author
