// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
#include <rigor/schema/suggest.h>

#include <algorithm>
#include <utility>

#include <rigor/text/letter_case.h>

namespace rigor::schema {
namespace {

constexpr std::size_t kMaxEdits = 2;
// names of robot formats are shorter; the bound keeps a long run of text from costing its square
constexpr std::size_t kLongestName = 128;

std::size_t allowed_edits(std::size_t length) {
  if (length < 3) return 0;
  return length <= 4 ? 1 : kMaxEdits;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
  const std::size_t difference = std::max(a.size(), b.size()) - std::min(a.size(), b.size());
  if (difference > limit) return limit + 1;
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, row);
    row[0] = i;
    std::size_t least = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const char x = lower(a[i - 1]);
      const char y = lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (x == y ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && x == lower(b[j - 2]) && lower(a[i - 2]) == y;
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
      least = std::min(least, row[j]);
    }
    if (least > limit)
      return limit + 1;  // then what a swap could reach in the row before is no less
  }
  return std::min(row[b.size()], limit + 1);
}

std::vector<std::string_view> near(std::string_view name,
                                   const std::vector<std::string_view>& candidates) {
  std::vector<std::pair<std::size_t, std::string_view>> found;
  if (name.size() > kLongestName) return {};
  const std::size_t limit = allowed_edits(name.size());
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = edit_distance(name, candidate, limit);
    const std::pair entry(distance, candidate);
    if (distance <= limit && std::find(found.begin(), found.end(), entry) == found.end()) {
      found.push_back(entry);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string_view> names;
  for (const auto& [distance, candidate] : found) {
    if (names.size() == kMaxSuggestions) break;
    names.push_back(candidate);
  }
  return names;
}

}  // namespace rigor::schema
