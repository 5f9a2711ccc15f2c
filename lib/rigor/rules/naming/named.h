// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What has a name in a file, scope by scope.

#pragma once

#include <optional>
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
  Span where;  ///< of the name, where it was written in the file itself
  xml::Element element;
};

/// Things among which names are told apart: all that one element holds.
struct NameScope {
  std::string_view of;  ///< the element's name: "model"
  std::vector<Named> members;
};

/// Walks the elements of a file, since a name is unique among its siblings whatever they are.
class NameCollector {
 public:
  explicit NameCollector(const Context& context) : context_(context) {}

  std::vector<NameScope> collect() {
    const xml::Document& document = context_.document();
    for (std::uint32_t i = 0; i < document.element_count(); ++i) add(document.element(i));
    return std::move(scopes_);
  }

 private:
  void add(xml::Element element) {
    if (element.children().empty()) return;
    NameScope scope{element.name(), {}};
    for (const xml::Element child : element.children()) {
      const std::string_view kind = child.name();
      // What a plugin holds is its own business, and so is its name.
      if (kind == "plugin" || kind.find(':') != std::string_view::npos) continue;
      const auto name = child.attribute("name");
      if (name) {
        const Span where = name->value_span().size() > 0 ? name->value_span() : child.tag_span();
        scope.members.push_back({kind, name->value(), where, child});
      } else if (kind == "include") {
        add_include(scope, child);
      }
    }
    if (scope.members.size() > 1 && !in_plugin(element)) scopes_.push_back(std::move(scope));
  }

  static bool in_plugin(std::optional<xml::Element> element) {
    for (; element; element = element->parent()) {
      if (element->name() == "plugin") return true;
    }
    return false;
  }

  /// An include stands for the model that it brings, under the name that it gives it.
  void add_include(NameScope& scope, xml::Element element) {
    const model::Root& root = context_.root();
    for (const model::Include& include : root.includes) {
      if (!root.own(include.site) || include.site.element != element.index()) continue;
      if (!include.loaded || include.merge.value) return;
      const Span where = include.name.written ? include.name.span : include.site.name;
      const model::Model& model = root[include.loaded];
      scope.members.push_back({"model", model.name.value, where, element});
    }
  }

  const Context& context_;
  std::vector<NameScope> scopes_;
};

/// "arm/link palm/collision pad": the names on the way in from the root.
inline std::string subject_of(const Named& named) {
  std::string subject;
  for (std::optional<xml::Element> at = named.element; at; at = at->parent()) {
    const auto name = at->attribute("name");
    const bool itself = *at == named.element;
    if (!name && !itself) continue;
    const std::string_view called = itself ? named.name : name->value();
    const bool model = at->name() == "model" || at->name() == "robot" || at->name() == "include";
    std::string part = model ? "" : std::string(at->name()) + " ";
    part += called;
    subject = subject.empty() ? part : part + "/" + subject;
  }
  return subject;
}

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
