// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names as numbers: each distinct name of an expansion gets the next one, so that scopes and expressions
// compare numbers.

#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include <rigor/xacro/arena.h>
#include <rigor/xacro/value/text_index.h>

namespace rigor::xacro {

using Symbol = std::uint32_t;

class Symbols {
 public:
  Symbols() { names_.reserve(kFirstNames); }

  Symbol of(std::string_view name) {
    const std::uint32_t hash = short_hash(name);
    const Symbol known =
        index_.find(hash, [&](std::uint32_t symbol) { return names_[symbol] == name; });
    if (known != TextIndex::kNoRow) return known;
    if (!name.empty()) {
      char* const kept = static_cast<char*>(memory_.take(name.size(), 1));
      std::memcpy(kept, name.data(), name.size());
      name = {kept, name.size()};
    }
    names_.push_back(name);
    const auto symbol = static_cast<Symbol>(names_.size() - 1);
    index_.add(hash, symbol);
    return symbol;
  }
  std::string_view name(Symbol symbol) const { return names_[symbol]; }
  /// All that have a number so far.
  std::size_t size() const { return names_.size(); }

 private:
  static constexpr std::size_t kFirstNames = 64;
  Arena memory_;
  std::vector<std::string_view> names_;
  TextIndex index_;
};

}  // namespace rigor::xacro
