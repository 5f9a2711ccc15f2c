// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/assembled/twins.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>

namespace rigor::robot {
namespace {

struct SidePair {
  std::string_view first;  // left, or front
  std::string_view second;
};

constexpr std::array<SidePair, 11> kAcross{{{"left", "right"},
                                            {"l", "r"},
                                            {"fl", "fr"},
                                            {"rl", "rr"},
                                            {"bl", "br"},
                                            {"hl", "hr"},
                                            {"ml", "mr"},
                                            {"lf", "rf"},
                                            {"lh", "rh"},
                                            {"lr", "rr"},
                                            {"lb", "rb"}}};

constexpr std::array<SidePair, 11> kAlong{{{"front", "rear"},
                                           {"front", "back"},
                                           {"fore", "hind"},
                                           {"fl", "rl"},
                                           {"fr", "rr"},
                                           {"fl", "bl"},
                                           {"fr", "br"},
                                           {"fl", "hl"},
                                           {"fr", "hr"},
                                           {"lf", "lh"},
                                           {"rf", "rh"}}};

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
char lowered(char c) { return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c; }
char raised(char c) { return is_lower(c) ? static_cast<char>(c - 'a' + 'A') : c; }

/// Whether a new word begins at `i`: behind what is no letter, at the hump of a camel's back, and behind a
/// capital that represents a word, as in LHipYaw.
bool begins_word(std::string_view name, std::size_t i) {
  const char before = name[i - 1];
  const char here = name[i];
  if (!is_lower(before) && !is_upper(before)) return true;
  if (is_lower(before)) return is_upper(here);
  return is_upper(here) && i + 1 < name.size() && is_lower(name[i + 1]);
}

struct Word {
  std::size_t at = 0;
  std::size_t size = 0;

  std::size_t end() const { return at + size; }
};

/// The next word at `from` or behind it; of size 0 at the end.
Word next_word(std::string_view name, std::size_t from) {
  const auto is_letter = [](char c) { return is_lower(c) || is_upper(c); };
  while (from < name.size() && !is_letter(name[from])) ++from;
  std::size_t end = from;
  while (end < name.size() && is_letter(name[end]) && (end == from || !begins_word(name, end)))
    ++end;
  return {from, end - from};
}

bool is_word(std::string_view written, std::string_view word) {
  return std::equal(written.begin(), written.end(), word.begin(), word.end(),
                    [](char a, char b) { return lowered(a) == b; });
}

/// `word` in the case of what was written: left, Left or LEFT.
std::string in_case_of(std::string_view written, std::string_view word) {
  std::string result(word);
  const bool first = is_upper(written.front());
  const bool all = first && is_upper(written.back());
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (all || (first && i == 0)) result[i] = raised(result[i]);
  }
  return result;
}

/// Whether it may be a word of the tables: most words of names are derived from them by their length and first letter.
bool may_say_side(std::string_view written) {
  constexpr std::size_t kLongest = 5;  // right, front
  constexpr std::string_view kFirst = "lrfbhm";
  return written.size() <= kLongest && written.size() != 3 &&
         kFirst.find(lowered(written.front())) != kFirst.npos;
}

/// What the word is on the other side; empty when it says none.
std::vector<std::string> exchanged(std::string_view written, Side side) {
  std::vector<std::string> result;
  if (!may_say_side(written)) return result;
  for (const auto& [first, second] : side == Side::kAcross ? kAcross : kAlong) {
    if (is_word(written, first)) result.push_back(in_case_of(written, second));
    if (is_word(written, second)) result.push_back(in_case_of(written, first));
  }
  return result;
}

bool says_first(std::string_view name, Side side) {
  for (Word word = next_word(name, 0); word.size > 0; word = next_word(name, word.end())) {
    for (const auto& [first, second] : side == Side::kAcross ? kAcross : kAlong) {
      if (is_word(name.substr(word.at, word.size), first)) return true;
      if (is_word(name.substr(word.at, word.size), second)) return false;
    }
  }
  return false;
}

}  // namespace

std::vector<std::string> mirrored_names(std::string_view name, Side side) {
  struct Change {
    Word word;
    std::vector<std::string> to;
  };
  std::vector<Change> changes;
  for (Word word = next_word(name, 0); word.size > 0; word = next_word(name, word.end())) {
    auto to = exchanged(name.substr(word.at, word.size), side);
    if (!to.empty()) changes.push_back({word, std::move(to)});
  }
  std::vector<std::string> names;
  if (changes.size() > 1) {
    std::string all(name);
    for (std::size_t i = changes.size(); i-- > 0;) {
      all.replace(changes[i].word.at, changes[i].word.size, changes[i].to.front());
    }
    names.push_back(std::move(all));
  }
  for (const Change& change : changes) {
    for (const std::string& to : change.to) {
      std::string one(name);
      names.push_back(one.replace(change.word.at, change.word.size, to));
    }
  }
  return names;
}

std::string role_name(std::string_view name) {
  std::string role;
  std::size_t copied = 0;
  for (Word word = next_word(name, 0); word.size > 0; word = next_word(name, word.end())) {
    const std::string_view written = name.substr(word.at, word.size);
    if (exchanged(written, Side::kAcross).empty() && exchanged(written, Side::kAlong).empty())
      continue;
    role.append(name.substr(copied, word.at - copied)).append("*");
    copied = word.end();
  }
  return role.append(name.substr(copied));
}

std::string family_name(std::string_view name) {
  std::string family;
  for (const char c : role_name(name)) {
    const bool digit = c >= '0' && c <= '9';
    if (!digit) family += c;
    if (digit && (family.empty() || family.back() != '#')) family += '#';
  }
  return family;
}

std::vector<Twins> twins(const std::vector<std::string_view>& names, Side side) {
  if (names.size() < 2) return {};
  std::unordered_map<std::string_view, std::uint32_t> places;  // filled when a name says a side
  std::vector<bool> taken(names.size(), false);
  std::vector<Twins> pairs;
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    if (taken[i]) continue;
    const std::vector<std::string> mirrored = mirrored_names(names[i], side);
    if (mirrored.empty()) continue;
    if (places.empty()) {
      for (std::uint32_t k = 0; k < names.size(); ++k) places.emplace(names[k], k);
    }
    for (const std::string& other : mirrored) {
      const auto found = places.find(other);
      if (found == places.end() || taken[found->second] || found->second == i) continue;
      taken[i] = taken[found->second] = true;
      pairs.push_back(says_first(names[i], side) ? Twins{i, found->second}
                                                 : Twins{found->second, i});
      break;
    }
  }
  return pairs;
}

}  // namespace rigor::robot
