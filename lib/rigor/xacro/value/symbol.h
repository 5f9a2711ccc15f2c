// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names as numbers: each distinct name of an expansion gets the next one, so that scopes and expressions
// compare numbers.

#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>

namespace rigor::xacro {

using Symbol = std::uint32_t;

class Symbols {
 public:
  Symbol of(std::string_view name) {
    const auto found = numbers_.find(name);
    if (found != numbers_.end()) return found->second;
    const std::string& kept = names_.emplace_back(name);
    const auto number = static_cast<Symbol>(names_.size() - 1);
    numbers_.emplace(kept, number);
    return number;
  }
  std::string_view name(Symbol symbol) const { return names_[symbol]; }

 private:
  std::deque<std::string> names_;
  std::unordered_map<std::string_view, Symbol> numbers_;
};

}  // namespace rigor::xacro
