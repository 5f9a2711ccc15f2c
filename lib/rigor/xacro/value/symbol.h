// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names as numbers: each distinct name of an expansion gets the next one, so that scopes and expressions
// compare numbers.

#pragma once

#include <cstdint>
#include <cstring>
#include <memory_resource>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace rigor::xacro {

using Symbol = std::uint32_t;

class Symbols {
 public:
  Symbol of(std::string_view name) {
    const auto found = numbers_.find(name);
    if (found != numbers_.end()) return found->second;
    if (name.empty()) return of_constant({});
    char* kept = static_cast<char*>(memory_.allocate(name.size(), 1));
    std::memcpy(kept, name.data(), name.size());
    return add({kept, name.size()});
  }
  /// Of a name that outlives this, and is not copied.
  Symbol of_constant(std::string_view name) {
    const auto found = numbers_.find(name);
    return found != numbers_.end() ? found->second : add(name);
  }
  std::string_view name(Symbol symbol) const { return names_[symbol]; }

 private:
  Symbol add(std::string_view kept) {
    names_.push_back(kept);
    const auto number = static_cast<Symbol>(names_.size() - 1);
    numbers_.emplace(kept, number);
    return number;
  }

  static constexpr std::size_t kFirstBlock = std::size_t{16} << 10U;
  /// More than the names that every template knows.
  static constexpr std::size_t kFirstNames = 256;
  std::pmr::monotonic_buffer_resource memory_{kFirstBlock};
  std::pmr::vector<std::string_view> names_{&memory_};
  std::pmr::unordered_map<std::string_view, Symbol> numbers_{kFirstNames, &memory_};
};

}  // namespace rigor::xacro
