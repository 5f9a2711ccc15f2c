// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/assembled/siblings.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <unordered_map>
#include <utility>

namespace rigor::robot {
namespace {

constexpr std::array<std::string_view, 35> kPlaces{
    "left",  "right", "front", "rear",   "back",  "fore",  "hind",   "mid",  "middle",
    "l",     "r",     "f",     "b",      "fl",    "fr",    "rl",     "rr",   "bl",
    "br",    "hl",    "hr",    "ml",     "mr",    "lf",    "rf",     "lh",   "rh",
    "index", "ring",  "pinky", "little", "thumb", "first", "second", "third"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || is_capital(c); }

struct NamePart {
  std::string_view text;
  bool number = false;
  bool place = false;
};

bool is_place(std::string_view word) {
  std::string lowered(word);
  for (char& c : lowered) c = is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c;
  return std::find(kPlaces.begin(), kPlaces.end(), lowered) != kPlaces.end();
}

/// Runs of digits, words (that a capital may begin), and single characters.
std::vector<NamePart> parts_of(std::string_view name) {
  std::vector<NamePart> parts;
  for (std::size_t i = 0; i < name.size();) {
    std::size_t end = i + 1;
    if (is_digit(name[i])) {
      while (end < name.size() && is_digit(name[end])) ++end;
      parts.push_back({name.substr(i, end - i), true, false});
    } else if (is_letter(name[i])) {
      while (end < name.size() && is_letter(name[end]) &&
             !(is_capital(name[end]) && !is_capital(name[end - 1])))
        ++end;
      const std::string_view word = name.substr(i, end - i);
      parts.push_back({word, false, is_place(word)});
    } else {
      parts.push_back({name.substr(i, 1), false, false});
    }
    i = end;
  }
  return parts;
}

/// What is left of the name: the words and the other numbers, with one mark between them.
std::string without(const std::vector<NamePart>& parts, std::size_t number) {
  const bool all = number == parts.size();
  std::string result;
  bool gap = false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const NamePart& part = parts[i];
    const bool left_out = all ? part.number || part.place : i == number;
    const bool word = part.number || is_letter(part.text.front());
    if (left_out || !word) {
      gap = true;
      continue;
    }
    if (gap && !result.empty()) result += '_';
    result += part.text;
    gap = false;
  }
  return result;
}

}  // namespace

std::vector<std::string> family_names(std::string_view name) {
  const std::vector<NamePart> parts = parts_of(name);
  std::vector<std::string> families{without(parts, parts.size())};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].number) continue;
    std::string family = without(parts, i) + '#' + std::to_string(i);
    if (std::find(families.begin(), families.end(), family) == families.end())
      families.push_back(std::move(family));
  }
  return families;
}

std::vector<std::vector<std::uint32_t>> siblings(const std::vector<std::string>& names) {
  constexpr std::size_t kFewest = 2;
  std::vector<std::vector<std::uint32_t>> groups;
  if (names.size() < kFewest) return groups;
  std::unordered_map<std::string, std::vector<std::uint32_t>> by_family;
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    for (std::string& family : family_names(names[i])) by_family[std::move(family)].push_back(i);
  }
  std::set<std::vector<std::uint32_t>> different;
  for (auto& [family, members] : by_family) {
    if (members.size() >= kFewest) different.insert(std::move(members));
  }
  groups.assign(different.begin(), different.end());
  return groups;
}

}  // namespace rigor::robot
