// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Properties, parameters and macros by name, in scopes within scopes.

#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/xacro/node.h>
#include <rigor/xacro/value/symbol.h>
#include <rigor/xacro/value/value.h>

namespace rigor::xacro {

/// A row of pairs while few, with an index when many: most scopes are those of macro calls.
template <class T>
class SymbolMap {
 public:
  T* find(Symbol symbol) {
    if (!index_.empty()) {
      const std::uint32_t row = index_[slot_of(symbol)];
      return row == kNoRow ? nullptr : &rows_[row].second;
    }
    for (auto& [key, value] : rows_) {
      if (key == symbol) return &value;
    }
    return nullptr;
  }
  T& operator[](Symbol symbol) {
    if (T* found = find(symbol)) return *found;
    rows_.emplace_back(symbol, T{});
    if (!index_.empty() || rows_.size() > kIndexed) {
      if (2 * rows_.size() > index_.size()) {
        rebuild();
      } else {
        index_[slot_of(symbol)] = static_cast<std::uint32_t>(rows_.size() - 1);
      }
    }
    return rows_.back().second;
  }
  void erase(Symbol symbol) {
    std::erase_if(rows_, [symbol](const auto& row) { return row.first == symbol; });
    if (!index_.empty()) rebuild();
  }
  void clear() {
    rows_.clear();
    index_.clear();
  }
  auto begin() const { return rows_.begin(); }
  auto end() const { return rows_.end(); }

 private:
  static constexpr std::size_t kIndexed = 16;
  static constexpr std::uint32_t kNoRow = 0xffffffffU;

  /// Where a symbol's row is noted, or would be: open addressing, at most half full.
  std::size_t slot_of(Symbol symbol) const {
    constexpr std::uint32_t kGoldenRatio = 0x9e3779b1U;
    const std::size_t last = index_.size() - 1;
    std::size_t slot = (symbol * kGoldenRatio >> 12U) & last;
    while (index_[slot] != kNoRow && rows_[index_[slot]].first != symbol) slot = (slot + 1) & last;
    return slot;
  }
  void rebuild() {
    std::size_t size = 4 * kIndexed;
    while (size < 4 * rows_.size()) size *= 2;
    index_.assign(size, kNoRow);
    for (std::size_t i = 0; i < rows_.size(); ++i)
      index_[slot_of(rows_[i].first)] = static_cast<std::uint32_t>(i);
  }

  std::vector<std::pair<Symbol, T>> rows_;
  std::vector<std::uint32_t> index_;  ///< of rows; a power of two, or empty while they are few
};

inline constexpr std::uint32_t kNoDefinition = 0xffffffffU;

struct Binding {
  Value value;
  bool lazy = false;       ///< the value is a text that its first use evaluates
  bool resolving = false;  ///< and that is under way
  bool used = false;
  TextCode code = TextCode::kUnknown;  ///< of the text
  Place place = {};                    ///< where the value is written
  Span from = {};                      ///< where the property or YAML value that it refers to is
  std::uint32_t definition = kNoDefinition;  ///< which property's
};

enum class ScopeKind : std::uint8_t { kFile, kMacro, kNamespace };

class Scope {
 public:
  Scope(Scope* parent, ScopeKind kind) : parent_(parent), kind_(kind) {}

  Scope* parent() const { return parent_; }
  ScopeKind kind() const { return kind_; }
  SymbolMap<Binding>& own() { return bindings_; }

  /// Here or in a scope around; null where there is none.
  Binding* find(Symbol symbol, Scope** found_in = nullptr) {
    for (Scope* scope = this; scope != nullptr; scope = scope->parent_) {
      if (Binding* binding = scope->bindings_.find(symbol)) {
        if (found_in != nullptr) *found_in = scope;
        return binding;
      }
    }
    return nullptr;
  }

  /// The scope of the file that everything began with.
  Scope& top() {
    Scope* scope = this;
    while (scope->parent_ != nullptr) scope = scope->parent_;
    return *scope;
  }

  void reset(Scope* parent) {
    parent_ = parent;
    bindings_.clear();
  }

 private:
  Scope* parent_;
  ScopeKind kind_;
  SymbolMap<Binding> bindings_;
};

struct MacroParameter {
  std::string_view name;  ///< with the `*` or `**` of a block
  Symbol symbol = 0;      ///< of the name with its stars
  bool has_default = false;
  bool forwards = false;  ///< `^`: takes the caller's property of the same name
  std::string_view text;  ///< of the default, behind `^|` when it forwards
  TextCode code = TextCode::kUnknown;
  Place place = {};
  bool used = false;
};

struct Macro {
  std::string_view name;
  const Node* body = nullptr;
  std::vector<MacroParameter> parameters;
  std::string_view file;
  bool used = false;
};

/// Splits a macro's `params`. Defaults may hold blanks in quotes, `${…}` and `$(…)`.
std::vector<MacroParameter> parse_parameters(std::string_view params, Place place,
                                             Symbols& symbols);

class MacroScope;

struct MacroEntry {
  Macro* macro = nullptr;
  MacroScope* name_space = nullptr;
};

/// Macros of a file, of a macro's call, or of a namespace, which has none around it.
class MacroScope {
 public:
  explicit MacroScope(MacroScope* parent) : parent_(parent) {}
  SymbolMap<MacroEntry>& own() { return entries_; }
  MacroScope* parent() const { return parent_; }
  MacroEntry* find(Symbol symbol) {
    for (MacroScope* scope = this; scope != nullptr; scope = scope->parent_) {
      if (MacroEntry* entry = scope->entries_.find(symbol)) return entry;
    }
    return nullptr;
  }
  void reset(MacroScope* parent) {
    parent_ = parent;
    entries_.clear();
  }

 private:
  MacroScope* parent_;
  SymbolMap<MacroEntry> entries_;
};

}  // namespace rigor::xacro
