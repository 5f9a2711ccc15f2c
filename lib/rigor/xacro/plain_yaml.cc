// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/plain_yaml.h>

#include <algorithm>
#include <array>

namespace rigor::xacro {
namespace {

/// The tag that YAML gives to what is in quotes.
constexpr std::string_view kQuoted = "!";

constexpr std::string_view kNulls[] = {"~", "null", "Null", "NULL"};

constexpr bool is_yaml_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// What has no meaning of its own anywhere within a plain scalar.
constexpr std::array<bool, 256> kIsPlainScalarByte = [] {
  std::array<bool, 256> plain{};
  for (std::size_t c = 0; c < plain.size(); ++c) plain[c] = is_yaml_word(static_cast<char>(c));
  for (const char c : std::string_view(".+-/()$*^~=<>,{} "))
    plain[static_cast<unsigned char>(c)] = true;
  return plain;
}();
bool is_plain_scalar_byte(char c) { return kIsPlainScalarByte[static_cast<unsigned char>(c)]; }

class PlainYamlReader {
 public:
  explicit PlainYamlReader(std::string_view bytes) : bytes_(bytes) {}

  std::optional<std::vector<PlainYamlEvent>> run() {
    events_.reserve(bytes_.size() / 12);
    for (std::size_t begin = 0; begin < bytes_.size();) {
      const std::size_t end = std::min(bytes_.find('\n', begin), bytes_.size());
      if (!take_line(begin, end)) return std::nullopt;
      begin = end + 1;
    }
    if (levels_.empty() || expects_map_) return std::nullopt;
    close_levels(0);
    return std::move(events_);
  }

 private:
  using Kind = PlainYamlEvent::Kind;

  bool take_line(std::size_t begin, std::size_t end) {
    std::size_t at = bytes_.find_first_not_of(' ', begin);
    if (at >= end) return true;
    if (bytes_[at] == '#') return take_comment(at, end);
    if (bytes_.substr(begin, end - begin) == "---" && events_.empty() && !is_started_) {
      is_started_ = true;
      return true;
    }
    if (!take_level(at - begin, at)) return false;
    const std::size_t key = at;
    while (at < end && is_yaml_word(bytes_[at])) ++at;
    if (at == key || at == end || bytes_[at] != ':') return false;
    const std::string_view name = bytes_.substr(key, at - key);
    if (std::find(std::begin(kNulls), std::end(kNulls), name) != std::end(kNulls)) return false;
    events_.push_back({Kind::kScalar, static_cast<std::uint32_t>(key), {}, name});
    if (++at < end && bytes_[at] != ' ') return false;
    at = std::min(bytes_.find_first_not_of(' ', at), end);
    anchor_ = {};
    if (at < end && bytes_[at] == '&') {
      const std::size_t behind = behind_word(at + 1, end);
      if (behind == at + 1 || (behind < end && bytes_[behind] != ' ')) return false;
      anchor_ = {static_cast<std::uint32_t>(at), bytes_.substr(at + 1, behind - at - 1)};
      at = std::min(bytes_.find_first_not_of(' ', behind), end);
      if (at < end && bytes_[at] != '#') return false;
    }
    if (at < end && bytes_[at] == '*') return take_alias(at, end);
    if (at >= end || bytes_[at] == '#') {
      expects_map_ = true;
      return at >= end || take_comment(at, end);
    }
    return take_scalar(at, end);
  }

  std::size_t behind_word(std::size_t at, std::size_t end) const {
    while (at < end && is_yaml_word(bytes_[at])) ++at;
    return at;
  }

  bool take_alias(std::size_t at, std::size_t end) {
    const std::size_t behind = behind_word(at + 1, end);
    const std::string_view name = bytes_.substr(at + 1, behind - at - 1);
    // The last of a name counts.
    const auto known = std::find(anchors_.rbegin(), anchors_.rend(), name);
    if (known == anchors_.rend()) return false;
    events_.push_back({Kind::kAlias,
                       static_cast<std::uint32_t>(at),
                       {},
                       {},
                       static_cast<std::uint32_t>(anchors_.rend() - known)});
    const std::size_t rest = std::min(bytes_.find_first_not_of(' ', behind), end);
    return rest >= end || (bytes_[rest] == '#' && rest > behind && take_comment(rest, end));
  }

  /// Opens and closes dictionaries for a key at that indentation.
  bool take_level(std::size_t indentation, std::size_t at) {
    if (levels_.empty() || (expects_map_ && indentation > levels_.back())) {
      if (levels_.size() >= kMaxLevels) return false;
      levels_.push_back(indentation);
      PlainYamlEvent event{Kind::kMapStart, static_cast<std::uint32_t>(at), {}, {}};
      if (!anchor_.name.empty()) {
        anchors_.push_back(anchor_.name);
        event.offset = anchor_.offset;
        event.anchor = static_cast<std::uint32_t>(anchors_.size());
      }
      events_.push_back(event);
      expects_map_ = false;
      anchor_ = {};
      return true;
    }
    // The second line of a scalar, or an anchor of nothing.
    if (indentation > levels_.back() || !anchor_.name.empty()) return false;
    if (expects_map_) events_.push_back({Kind::kNull, static_cast<std::uint32_t>(at), {}, {}});
    expects_map_ = false;
    const auto level = std::find(levels_.begin(), levels_.end(), indentation);
    if (level == levels_.end()) return false;
    close_levels(static_cast<std::size_t>(level - levels_.begin()) + 1);
    return true;
  }

  void close_levels(std::size_t kept) {
    for (; levels_.size() > kept; levels_.pop_back()) events_.push_back({Kind::kMapEnd, 0, {}, {}});
  }

  bool take_scalar(std::size_t at, std::size_t end) {
    PlainYamlEvent event{Kind::kScalar, static_cast<std::uint32_t>(at), {}, {}};
    if (bytes_[at] == '!') {
      std::size_t behind = at + 1;
      while (behind < end && is_yaml_word(bytes_[behind])) ++behind;
      if (behind == at + 1 || behind == end || bytes_[behind] != ' ') return false;
      event.tag = bytes_.substr(at, behind - at);
      at = std::min(bytes_.find_first_not_of(' ', behind), end);
      if (at >= end) return false;
    }
    const char first = bytes_[at];
    if (event.tag.empty() && (first == '"' || first == '\'')) return take_quoted(event, at, end);
    const bool is_sign = first == '-' && at + 1 < end && bytes_[at + 1] != ' ';
    if (!is_sign && !is_yaml_word(first) && first != '.' && first != '+' && first != '$')
      return false;
    std::size_t behind = at;
    for (; behind < end && is_plain_scalar_byte(bytes_[behind]); ++behind) {
    }
    if (behind < end) {
      // Anything but a comment is not for this reader.
      if (bytes_[behind] != '#' || bytes_[behind - 1] != ' ') return false;
      if (!take_comment(behind, end)) return false;
    }
    event.text = bytes_.substr(at, behind - at);
    event.text = event.text.substr(0, event.text.find_last_not_of(' ') + 1);
    if (std::find(std::begin(kNulls), std::end(kNulls), event.text) != std::end(kNulls))
      return false;
    events_.push_back(event);
    return true;
  }

  /// On one line, and without escapes.
  bool take_quoted(PlainYamlEvent event, std::size_t at, std::size_t end) {
    const std::size_t close = std::min(bytes_.find(bytes_[at], at + 1), end);
    if (close == end) return false;
    event.tag = kQuoted;
    event.text = bytes_.substr(at + 1, close - at - 1);
    const auto is_own_character = [](char c) { return c >= 0x20 && c < 0x7f && c != '\\'; };
    if (!std::all_of(event.text.begin(), event.text.end(), is_own_character)) return false;
    events_.push_back(event);
    const std::size_t rest = std::min(bytes_.find_first_not_of(' ', close + 1), end);
    if (rest == end) return true;
    return bytes_[rest] == '#' && rest > close + 1 && take_comment(rest, end);
  }

  /// Control characters have meanings of their own even there.
  bool take_comment(std::size_t at, std::size_t end) const {
    return std::all_of(bytes_.begin() + static_cast<std::ptrdiff_t>(at),
                       bytes_.begin() + static_cast<std::ptrdiff_t>(end),
                       [](char c) { return static_cast<unsigned char>(c) >= 0x20 || c == '\t'; });
  }

  static constexpr std::size_t kMaxLevels = 100;

  std::string_view bytes_;
  std::vector<PlainYamlEvent> events_;
  std::vector<std::size_t> levels_;  ///< indentations of the open dictionaries
  struct Anchor {
    std::uint32_t offset = 0;
    std::string_view name = {};
  };
  Anchor anchor_;                          ///< of the dictionary that is expected
  std::vector<std::string_view> anchors_;  ///< of those so far
  bool expects_map_ = false;               ///< the last key has no value yet
  bool is_started_ = false;
};

}  // namespace

std::optional<std::vector<PlainYamlEvent>> read_plain_yaml(std::string_view bytes) {
  return PlainYamlReader(bytes).run();
}

}  // namespace rigor::xacro
