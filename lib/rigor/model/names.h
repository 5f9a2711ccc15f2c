// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The names of a root's scopes: which model, link, joint or frame a reference means.
//
// A scope is a model or a world. `a::b` means b in the nested model a; a name that itself holds `::`,
// as old files have, is tried whole first.

#pragma once

#include <cstdint>
#include <functional>
#include <memory_resource>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include <rigor/model/model.h>

namespace rigor::model {

/// A model, or a world when `model` is none; the top of a file when both are.
struct ScopeId {
  Id<Model> model;
  Id<World> world;
};

/// What a name can mean; monostate for nothing.
using Named = std::variant<std::monostate, Id<Model>, Id<Link>, Id<Joint>, Id<Frame>>;

class Names {
 public:
  /// Views into the root's strings: the root outlives this.
  explicit Names(const Root& root);

  /// What `name` means in a scope. `__model__` is the scope's own model.
  Named find(ScopeId scope, std::string_view name) const;
  /// Of one kind only, where a format lets kinds share names.
  Id<Link> find_link(Id<Model> model, std::string_view name) const;
  Id<Joint> find_joint(Id<Model> model, std::string_view name) const;

  /// The names a scope has, for "did you mean".
  std::vector<std::string> in(ScopeId scope) const;

 private:
  struct Key {
    std::uint64_t scope;
    std::string_view name;
    bool operator==(const Key&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const {
      return std::hash<std::string_view>()(key.name) ^ (key.scope * 0x9E3779B97F4A7C15U);
    }
  };
  static std::uint64_t scope_key(ScopeId scope);
  Named find_here(ScopeId scope, std::string_view name) const;

  const Root& root_;
  std::pmr::monotonic_buffer_resource memory_;  // they are never taken out
  std::pmr::unordered_map<Key, Named, Hash> table_{&memory_};
};

}  // namespace rigor::model
