// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The names that repeat in a file, scope by scope.

#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/model/model.h>
#include <rigor/xml/document.h>

namespace rigor::rules {

/// One named thing.
struct Named {
  std::string_view kind;  ///< the element's name: "link"
  std::string_view name;
  Span where;  ///< of the name, where it was written in the file itself
  xml::Element element;
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

/// Things among which names are distinguished: all that one element holds.
struct NameScope {
  std::string_view of;  ///< the element's name: "model"
  std::vector<Named> members;
};

/// Walks the elements of a file, since a name is unique among its siblings whatever they are.
class NameCollector {
 public:
  NameCollector(const xml::Document& document, const model::Root& root)
      : document_(document), root_(root) {}

  /// The scopes of the file itself in which some name repeats: nearly none. Where an include names a
  /// thing, that is its place.
  std::vector<NameScope> collect() {
    all_.reserve(document_.element_count() / 8);
    for (std::uint32_t i = 1; i < document_.element_count(); ++i) {
      const xml::Element element = document_.element(i);
      if (!element.attributes().empty()) add(element);
    }
    for (const model::Include& include : root_.includes) {
      if (root_.own(include.site)) add(include);
    }
    // One scope after the other, each in the order of the file.
    std::sort(all_.begin(), all_.end(), [](const Member& a, const Member& b) {
      return a.scope != b.scope ? a.scope < b.scope : a.element < b.element;
    });
    for (auto scope = all_.begin(); scope != all_.end();) {
      const auto end = std::find_if(
          scope, all_.end(), [&](const Member& member) { return member.scope != scope->scope; });
      if (some_repeat(scope, end)) keep(scope, end);
      scope = end;
    }
    return std::move(scopes_);
  }

 private:
  struct Member {
    std::string_view name;
    std::uint32_t scope;                      // index of the element around it
    std::uint32_t element;                    // its own
    const model::Include* include = nullptr;  // that brings what has the name
  };
  using Members = std::vector<Member>::const_iterator;

  void add(xml::Element element) {
    const auto name = element.attribute("name");
    const auto parent = element.parent();
    if (!name || !parent) return;
    // What a plugin holds is its own business, and so is its name.
    const std::string_view kind = element.name();
    if (kind == "plugin" || kind.find(':') != std::string_view::npos) return;
    all_.push_back({name->value(), parent->index(), element.index()});
  }

  /// An include represents the model that it brings, under the name that it gives it.
  void add(const model::Include& include) {
    const xml::Element element = document_.element(include.site.element);
    const auto parent = element.parent();
    if (!include.loaded || include.merge.value || !parent || element.attribute("name")) return;
    all_.push_back({root_[include.loaded].name.value, parent->index(), element.index(), &include});
  }

  bool some_repeat(Members begin, Members end) {
    if (end - begin < 2) return false;
    names_.clear();
    for (auto member = begin; member != end; ++member) names_.push_back(member->name);
    std::sort(names_.begin(), names_.end());
    return std::adjacent_find(names_.begin(), names_.end()) != names_.end();
  }

  void keep(Members begin, Members end) {
    const xml::Element around = document_.element(begin->scope);
    if (in_plugin(around)) return;
    NameScope& scope = scopes_.emplace_back(NameScope{around.name(), {}});
    for (auto member = begin; member != end; ++member) scope.members.push_back(named(*member));
  }

  Named named(const Member& member) const {
    const xml::Element element = document_.element(member.element);
    if (const model::Include* include = member.include) {
      const Span where = include->name.written ? include->name.span : include->site.name;
      return {"model", member.name, where, element};
    }
    const Span value = element.attribute("name")->value_span();
    return {element.name(), member.name, value.size() > 0 ? value : element.tag_span(), element};
  }

  static bool in_plugin(std::optional<xml::Element> element) {
    for (; element; element = element->parent()) {
      if (element->name() == "plugin") return true;
    }
    return false;
  }

  const xml::Document& document_;
  const model::Root& root_;
  std::vector<Member> all_;
  std::vector<std::string_view> names_;  // of the scope that is examined, sorted
  std::vector<NameScope> scopes_;
};

}  // namespace rigor::rules
