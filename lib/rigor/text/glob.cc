// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/glob.h>

#include <algorithm>
#include <array>
#include <utility>

namespace rigor {
namespace {

using ByteTest = bool (*)(unsigned char);

bool in_range(unsigned char c, char first, char last) {
  return c >= static_cast<unsigned char>(first) && c <= static_cast<unsigned char>(last);
}
bool is_upper(unsigned char c) { return in_range(c, 'A', 'Z'); }
bool is_lower(unsigned char c) { return in_range(c, 'a', 'z'); }
bool is_digit(unsigned char c) { return in_range(c, '0', '9'); }
bool is_alpha(unsigned char c) { return is_upper(c) || is_lower(c); }
bool is_alnum(unsigned char c) { return is_alpha(c) || is_digit(c); }
bool is_graph(unsigned char c) { return in_range(c, '!', '~'); }

/// Of ASCII only: the locale has no say.
constexpr std::array<std::pair<std::string_view, ByteTest>, 12> kByteClasses{{
    {"alnum", is_alnum},
    {"alpha", is_alpha},
    {"blank", [](unsigned char c) { return c == ' ' || c == '\t'; }},
    {"cntrl", [](unsigned char c) { return c < 0x20 || c == 0x7F; }},
    {"digit", is_digit},
    {"graph", is_graph},
    {"lower", is_lower},
    {"print", [](unsigned char c) { return is_graph(c) || c == ' '; }},
    {"punct", [](unsigned char c) { return is_graph(c) && !is_alnum(c); }},
    // Without vertical tab and form feed, as git has it.
    {"space", [](unsigned char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }},
    {"upper", is_upper},
    {"xdigit",
     [](unsigned char c) { return is_digit(c) || in_range(c, 'A', 'F') || in_range(c, 'a', 'f'); }},
}};

}  // namespace

Glob::Glob(std::string_view pattern) {
  usable_ = pattern.size() <= kMaxPatternBytes;
  for (std::size_t at = 0; usable_ && at < pattern.size();) {
    switch (pattern[at]) {
      case '*': add_stars(pattern, at); break;
      case '?':
        tokens_.push_back({Kind::kAny});
        ++at;
        break;
      case '[': add_set(pattern, at); break;
      case '\\':
        if (++at == pattern.size()) {
          usable_ = false;
          break;
        }
        [[fallthrough]];
      default: tokens_.push_back({Kind::kByte, pattern[at++]});
    }
  }
  const auto special = std::find_if(tokens_.begin(), tokens_.end(),
                                    [](const Token& token) { return token.kind != Kind::kByte; });
  literal_ = static_cast<std::size_t>(special - tokens_.begin());
}

void Glob::add_stars(std::string_view pattern, std::size_t& at) {
  const std::size_t begin = at;
  at = std::min(pattern.find_first_not_of('*', begin), pattern.size());
  const bool part = at - begin > 1 && (begin == 0 || pattern[begin - 1] == '/');
  if (part && (at == pattern.size() || pattern.substr(at).starts_with("\\/"))) {
    tokens_.push_back({Kind::kRest});
  } else if (part && pattern[at] == '/') {
    tokens_.push_back({Kind::kFolders});
    tokens_.push_back({Kind::kWithin});
    ++at;
  } else {
    tokens_.push_back({Kind::kStar});
  }
}

/// From `[` to behind its `]`. A `]` that comes first is one of the set.
void Glob::add_set(std::string_view pattern, std::size_t& at) {
  const std::string_view open = pattern.substr(at + 1);
  std::size_t i = 0;
  const auto byte_at = [&open](std::size_t k) { return static_cast<unsigned char>(open[k]); };
  const bool negated = open.starts_with('!') || open.starts_with('^');
  if (negated) ++i;
  Set set;
  int before = -1;  // what a range begins with; none after a range or a class
  for (const std::size_t first = i; usable_; ++i) {
    if (i >= open.size()) {
      usable_ = false;
      return;
    }
    if (open[i] == ']' && i > first) break;
    if (open[i] == '-' && before >= 0 && i + 1 < open.size() && open[i + 1] != ']') {
      if (open[++i] == '\\') ++i;
      usable_ = i < open.size();
      for (int c = before; usable_ && c <= byte_at(i); ++c) set.set(static_cast<std::size_t>(c));
      before = -1;
      continue;
    }
    if (open.substr(i).starts_with("[:")) {
      const std::size_t close = open.find(']', i + 2);
      usable_ = close != std::string_view::npos;
      if (!usable_) return;
      if (close > i + 2 && open[close - 1] == ':') {
        const std::string_view name = open.substr(i + 2, close - 1 - (i + 2));
        const auto known = std::find_if(kByteClasses.begin(), kByteClasses.end(),
                                        [name](const auto& each) { return each.first == name; });
        usable_ = known != kByteClasses.end();
        for (unsigned c = 0; usable_ && c < 256; ++c) {
          if (known->second(static_cast<unsigned char>(c))) set.set(c);
        }
        i = close;
        before = -1;
        continue;
      }
    }
    if (open[i] == '\\' && ++i >= open.size()) continue;  // which ends it
    before = byte_at(i);
    set.set(byte_at(i));
  }
  if (negated) set.flip();
  set.reset('/');
  tokens_.push_back({Kind::kSet, 0, static_cast<std::uint32_t>(sets_.size())});
  sets_.push_back(set);
  at += i + 2;
}

/// Whether the token is over once it took the byte.
bool Glob::takes(const Token& token, char byte) const {
  switch (token.kind) {
    case Kind::kByte: return byte == token.byte;
    case Kind::kAny: return byte != '/';
    case Kind::kSet: return sets_[token.set].test(static_cast<unsigned char>(byte));
    case Kind::kWithin: return byte == '/';
    default: return false;
  }
}

/// What is reached without a byte more.
void Glob::skip(std::string& reached) const {
  for (std::size_t i = literal_; i < tokens_.size(); ++i) {
    if (reached[i] == 0) continue;
    const Kind kind = tokens_[i].kind;
    if (kind == Kind::kStar || kind == Kind::kRest) reached[i + 1] = 1;
    if (kind == Kind::kFolders) reached[i + 1] = reached[i + 2] = 1;
  }
}

// All ways at once: `reached[i]` says whether the tokens before i can take the bytes so far.
bool Glob::matches(std::string_view path) const {
  if (!usable_ || path.size() < literal_) return false;
  for (std::size_t i = 0; i < literal_; ++i) {
    if (path[i] != tokens_[i].byte) return false;
  }
  if (literal_ == tokens_.size()) return path.size() == literal_;
  std::string reached(tokens_.size() + 1, 0);
  reached[literal_] = 1;
  skip(reached);
  for (const char byte : path.substr(literal_)) {
    bool any = false;
    for (std::size_t i = tokens_.size() + 1; i-- > literal_;) {
      const bool stays = reached[i] != 0 && i < tokens_.size() &&
                         (tokens_[i].kind == Kind::kRest || tokens_[i].kind == Kind::kWithin ||
                          (tokens_[i].kind == Kind::kStar && byte != '/'));
      const bool comes = i > literal_ && reached[i - 1] != 0 && takes(tokens_[i - 1], byte);
      reached[i] = stays || comes ? 1 : 0;
      any = any || reached[i] != 0;
    }
    if (!any) return false;
    skip(reached);
  }
  return reached.back() != 0;
}

}  // namespace rigor
