// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/diff.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace rigor {
namespace {

constexpr std::size_t kContext = 3;

using Lines = std::vector<std::string>;

/// With their line ends.
Lines lines_of(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::size_t length = end == std::string_view::npos ? text.size() : end + 1;
    lines.emplace_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return lines;
}

/// Old lines [first, first + removed.size()) that become `added`.
struct Change {
  std::size_t first;
  Lines removed;
  Lines added;

  std::size_t end() const { return first + removed.size(); }
};

/// Without the lines that are the same at both ends.
void trim(Change& change) {
  Lines& a = change.removed;
  Lines& b = change.added;
  while (!a.empty() && !b.empty() && a.back() == b.back()) {
    a.pop_back();
    b.pop_back();
  }
  const auto [end_a, end_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  const auto same = end_a - a.begin();
  a.erase(a.begin(), end_a);
  b.erase(b.begin(), end_b);
  change.first += static_cast<std::size_t>(same);
}

class Differ {
 public:
  Differ(std::string_view bytes, std::vector<Edit> edits)
      : bytes_(bytes), lines_(lines_of(bytes)), edits_(std::move(edits)) {
    std::stable_sort(edits_.begin(), edits_.end(),
                     [](const Edit& a, const Edit& b) { return a.span.begin < b.span.begin; });
    std::size_t at = 0;
    for (const std::string& line : lines_) starts_.push_back(std::exchange(at, at + line.size()));
    starts_.push_back(at);
  }

  std::vector<Change> changes() {
    std::vector<Change> changes;
    for (std::size_t i = 0; i < edits_.size();) {
      const std::size_t first = line_at(edits_[i].span.begin);
      std::size_t last = line_at(edits_[i].span.end);
      std::vector<Edit> inside;
      for (; i < edits_.size() && line_at(edits_[i].span.begin) <= last; ++i) {
        last = std::max(last, line_at(edits_[i].span.end));
        inside.push_back(edits_[i]);
      }
      Change change = replaced(first, std::min(last + 1, lines_.size()), std::move(inside));
      trim(change);
      if (!change.removed.empty() || !change.added.empty()) changes.push_back(std::move(change));
    }
    return changes;
  }

  const Lines& lines() const { return lines_; }

 private:
  std::size_t line_at(std::size_t offset) const {
    const auto after = std::upper_bound(starts_.begin(), starts_.end() - 1, offset);
    return after == starts_.begin() ? 0 : static_cast<std::size_t>(after - starts_.begin()) - 1;
  }

  Change replaced(std::size_t first, std::size_t end, std::vector<Edit> edits) const {
    const std::size_t begin = starts_[first];
    const std::string_view old = bytes_.substr(begin, starts_[end] - begin);
    for (Edit& edit : edits) {
      edit.span.begin -= static_cast<std::uint32_t>(begin);
      edit.span.end -= static_cast<std::uint32_t>(begin);
    }
    return {first, lines_of(old), lines_of(*apply_edits(old, std::move(edits)))};
  }

  std::string_view bytes_;
  Lines lines_;
  std::vector<std::size_t> starts_;  // of each line, and of what is behind the last
  std::vector<Edit> edits_;
};

void put(std::string& out, char mark, const std::string& line) {
  out += mark + line;
  if (!line.ends_with('\n')) out += "\n\\ No newline at end of file\n";
}

/// "12,3"; a range of nothing stands behind the line before it.
std::string range(std::size_t first, std::size_t count) {
  return std::to_string(count == 0 ? first : first + 1) + ',' + std::to_string(count);
}

/// The changes from `begin` to `end`, near enough to share their context.
std::string hunk(const Lines& lines, const Change* begin, const Change* end, std::ptrdiff_t shift) {
  const std::size_t first = begin->first - std::min(begin->first, kContext);
  const std::size_t last = std::min((end - 1)->end() + kContext, lines.size());
  std::string body;
  std::size_t at = first;
  std::size_t added = 0;
  std::size_t removed = 0;
  for (const Change* change = begin; change != end; ++change) {
    for (; at < change->first; ++at) put(body, ' ', lines[at]);
    for (const std::string& line : change->removed) put(body, '-', line);
    for (const std::string& line : change->added) put(body, '+', line);
    at = change->end();
    added += change->added.size();
    removed += change->removed.size();
  }
  for (; at < last; ++at) put(body, ' ', lines[at]);
  const auto new_first = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(first) + shift);
  return "@@ -" + range(first, last - first) + " +" +
         range(new_first, last - first - removed + added) + " @@\n" + body;
}

}  // namespace

std::string unified_diff(std::string_view path, std::string_view bytes, std::vector<Edit> edits) {
  if (!apply_edits(bytes, edits)) return {};
  Differ differ(bytes, std::move(edits));
  const std::vector<Change> changes = differ.changes();
  if (changes.empty()) return {};
  const std::string name = path.starts_with('/') ? std::string(path) : '/' + std::string(path);
  std::string out = "--- a" + name + "\n+++ b" + name + "\n";
  std::ptrdiff_t shift = 0;
  for (std::size_t i = 0; i < changes.size();) {
    std::size_t end = i + 1;
    while (end < changes.size() && changes[end].first <= changes[end - 1].end() + 2 * kContext)
      ++end;
    out += hunk(differ.lines(), &changes[i], &changes[i] + (end - i), shift);
    for (; i < end; ++i) {
      shift += static_cast<std::ptrdiff_t>(changes[i].added.size()) -
               static_cast<std::ptrdiff_t>(changes[i].removed.size());
    }
  }
  return out;
}

}  // namespace rigor
