// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What has a name in a file, scope by scope.

#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <rigor/rules/context.h>

namespace rigor::rules {

/// One named thing.
struct Named {
  std::string_view kind;  ///< the element's name: "link"
  std::string_view name;
  Span where;             ///< of the name, where it was written in the file itself
  std::string subject;
};

/// Things among which names are told apart: the parts of a model, of a world, of a link.
struct NameScope {
  enum class Of { kFile, kWorld, kModel, kLink };
  Of of;
  int version;  ///< SDF 1.`version`
  std::vector<Named> members;
};

class NameCollector {
 public:
  explicit NameCollector(const Context& context) : context_(context), root_(context.root()) {}

  std::vector<NameScope> collect() {
    add_worlds();
    for (const model::Model& model : root_.models) {
      if (root_.own(model.site)) add_model(model);
    }
    for (const model::Link& link : root_.links) {
      if (root_.own(link.site)) add_link(link);
    }
    return std::move(scopes_);
  }

 private:
  template <class Entity>
  void add(NameScope& scope, std::string_view kind, const Entity& entity) {
    if (!entity.name.written || !root_.own(entity.site)) return;
    const Span where = entity.name.span.size() > 0 ? entity.name.span : entity.site.tag;
    scope.members.push_back({kind, entity.name.value, where, context_.subject(entity)});
  }

  /// A nested model, which an include may have brought; what a merge brought has left no model.
  void add_nested(NameScope& scope, const model::Model& model) {
    if (root_.own(model.site)) return add(scope, "model", model);
    if (model.include >= root_.includes.size()) return;
    const model::Include& include = root_.includes[model.include];
    if (!root_.own(include.site) || include.merge.value) return;
    const Span where = include.name.written ? include.name.span : include.site.name;
    scope.members.push_back({"model", model.name.value, where, context_.subject(model)});
  }

  void add_worlds() {
    NameScope file{NameScope::Of::kFile, root_.version, {}};
    for (const model::World& world : root_.worlds) {
      add(file, "world", world);
      NameScope scope{NameScope::Of::kWorld, root_.version, {}};
      for (const auto id : world.models) add_nested(scope, root_[id]);
      for (const auto id : world.joints) add(scope, "joint", root_[id]);
      for (const auto id : world.frames) add(scope, "frame", root_[id]);
      scopes_.push_back(std::move(scope));
    }
    for (const model::Model& model : root_.models) {
      if (!model.parent && !model.world) add(file, "model", model);
    }
    scopes_.push_back(std::move(file));
  }

  void add_model(const model::Model& model) {
    NameScope scope{NameScope::Of::kModel, root_.version, {}};
    for (const auto id : model.links) add(scope, "link", root_[id]);
    for (const auto id : model.joints) add(scope, "joint", root_[id]);
    for (const auto id : model.frames) add(scope, "frame", root_[id]);
    for (const auto id : model.models) add_nested(scope, root_[id]);
    scopes_.push_back(std::move(scope));
  }

  void add_link(const model::Link& link) {
    NameScope scope{NameScope::Of::kLink, root_.version, {}};
    for (const auto id : link.collisions) add(scope, "collision", root_[id]);
    for (const auto id : link.visuals) add(scope, "visual", root_[id]);
    for (const auto id : link.sensors) add(scope, "sensor", root_[id]);
    scopes_.push_back(std::move(scope));
  }

  const Context& context_;
  const model::Root& root_;
  std::vector<NameScope> scopes_;
};

/// The scopes that the file itself holds. Where an include names a thing, that is its place.
inline std::vector<NameScope> name_scopes(const Context& context) {
  return NameCollector(context).collect();
}

enum class Kinds { kSame, kDifferent };

/// Calls `tell(first, again)` for every member whose name an earlier one of its kind, or of a
/// different kind, has.
template <class Tell>
void for_each_repetition(const NameScope& scope, Kinds kinds, Tell tell) {
  std::unordered_map<std::string, const Named*> seen;
  for (const Named& named : scope.members) {
    if (named.name.empty()) continue;
    std::string key(named.name);
    if (kinds == Kinds::kSame) key = std::string(named.kind) + " " + key;
    const auto [first, is_new] = seen.emplace(key, &named);
    if (is_new) continue;
    if (kinds == Kinds::kDifferent && first->second->kind == named.kind) continue;
    tell(*first->second, named);
  }
}

}  // namespace rigor::rules
