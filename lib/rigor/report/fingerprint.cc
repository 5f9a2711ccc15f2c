// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/fingerprint.h>

#include <algorithm>
#include <array>
#include <deque>
#include <unordered_map>

#include <fmt/core.h>

#include <rigor/text/digest.h>

namespace rigor::report {
namespace {

constexpr std::size_t kHashedUnits = 100;
constexpr std::uint64_t kHashBase = 37;
constexpr std::uint16_t kEndOfText = 0xFFFF;

constexpr std::uint64_t power_of_base() {
  std::uint64_t power = 1;
  for (std::size_t i = 0; i < kHashedUnits; ++i) power *= kHashBase;
  return power;
}

/// The hash of the last kHashedUnits units; those before the first are zeros.
class RollingHash {
 public:
  void add(std::uint16_t unit) {
    std::uint16_t& oldest = window_[next_];
    value_ = value_ * kHashBase + unit - kLeaving * oldest;
    oldest = unit;
    next_ = (next_ + 1) % kHashedUnits;
  }
  std::uint64_t value() const { return value_; }

 private:
  static constexpr std::uint64_t kLeaving = power_of_base();
  std::array<std::uint16_t, kHashedUnits> window_{};
  std::size_t next_ = 0;
  std::uint64_t value_ = 0;
};

class LineHasher {
 public:
  explicit LineHasher(const std::set<std::uint32_t>& wanted) : wanted_(wanted) {}

  /// A unit that is no blank; line endings as LF.
  void add(std::uint16_t unit) {
    if (line_begins_) begins_.push_back(count_);
    line_begins_ = unit == '\n';
    roll(unit);
  }

  std::map<std::uint32_t, std::string> finish() {
    add(kEndOfText);
    while (!begins_.empty()) roll(0);
    return std::move(hashes_);
  }

 private:
  void roll(std::uint16_t unit) {
    hash_.add(unit);
    ++count_;
    if (begins_.empty() || count_ - begins_.front() < kHashedUnits) return;
    begins_.pop_front();
    const std::uint32_t occurrence = ++seen_[hash_.value()];
    if (!wanted_.contains(++line_)) return;
    hashes_[line_] = fmt::format("{:x}:{}", hash_.value(), occurrence);
  }

  const std::set<std::uint32_t>& wanted_;
  RollingHash hash_;
  std::size_t count_ = 0;
  std::deque<std::size_t> begins_;  // of the lines whose hash is not complete
  bool line_begins_ = true;
  std::uint32_t line_ = 0;
  std::unordered_map<std::uint64_t, std::uint32_t> seen_;
  std::map<std::uint32_t, std::string> hashes_;
};

/// The first character of a text that is not empty; U+FFFD for a byte that is no UTF-8.
std::uint32_t take_code_point(std::string_view& text) {
  const auto byte = [&text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const std::uint32_t lead = byte(0);
  const std::size_t size = lead < 0x80 ? 1 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  std::uint32_t value = size == 1 ? lead : lead & (0x7FU >> size);
  bool valid = lead < 0x80 || (lead >= 0xC2 && lead <= 0xF4);
  for (std::size_t i = 1; i < size; ++i) {
    valid = valid && (byte(i) & 0xC0U) == 0x80U;
    value = value << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::uint32_t kMin[] = {0, 0, 0x80, 0x800, 0x10000};
  valid = valid && value >= kMin[size] && value <= 0x10FFFF && (value < 0xD800 || value > 0xDFFF);
  text.remove_prefix(valid ? size : 1);
  return valid ? value : 0xFFFD;
}

/// The message in a form that stays when the model is tuned: each number, but not a digit of a name, is
/// one sign, and so are blanks.
std::string without_numbers(std::string_view message) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto of_name = [&is_digit](char c) {
    return is_digit(c) || c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  std::string text;
  for (std::size_t i = 0; i < message.size(); ++i) {
    const char c = message[i];
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (blank && text.ends_with(' ')) continue;
    const bool begins_number = is_digit(c) && (i == 0 || !of_name(message[i - 1]));
    if (!begins_number) {
      text += blank ? ' ' : c;
      continue;
    }
    if (text.ends_with('-')) text.pop_back();
    text += '#';
    while (i + 1 < message.size() &&
           (is_digit(message[i + 1]) ||
            ((message[i + 1] == '.' || message[i + 1] == ',') && i + 2 < message.size() &&
             is_digit(message[i + 2])) ||
            (message[i + 1] == 'e' && i + 2 < message.size() &&
             (is_digit(message[i + 2]) || message[i + 2] == '-' || message[i + 2] == '+')))) {
      ++i;
      if (message[i] == 'e' && !is_digit(message[i + 1])) ++i;
    }
  }
  return text;
}

}  // namespace

std::map<std::uint32_t, std::string> line_hashes(std::string_view bytes,
                                                 const std::set<std::uint32_t>& lines) {
  LineHasher hasher(lines);
  bool after_return = false;
  while (!bytes.empty()) {
    const std::uint32_t c = take_code_point(bytes);
    const bool skipped = c == ' ' || c == '\t' || (after_return && c == '\n');
    after_return = c == '\r';
    if (skipped) continue;
    if (c >= 0x10000) {
      hasher.add(static_cast<std::uint16_t>(0xD800 + ((c - 0x10000) >> 10U)));
      hasher.add(static_cast<std::uint16_t>(0xDC00 + ((c - 0x10000) & 0x3FFU)));
    } else {
      hasher.add(c == '\r' ? '\n' : static_cast<std::uint16_t>(c));
    }
  }
  return hasher.finish();
}

std::vector<std::string> finding_ids(const Validation& validation) {
  const Places places(validation.sources);
  std::unordered_map<std::string, std::size_t> seen;
  std::vector<std::string> ids;
  for (const Diagnostic& diagnostic : validation.result.diagnostics.list()) {
    std::string key;
    for (const std::string& part :
         {std::string(diagnostic.rule), project_path(validation, places.path(diagnostic)),
          diagnostic.subject, without_numbers(diagnostic.message)}) {
      key += part + '\0';
    }
    const std::size_t occurrence = ++seen[key];
    if (occurrence > 1) key += std::to_string(occurrence);
    ids.push_back(hex(digest_of(key)));
  }
  return ids;
}

}  // namespace rigor::report
