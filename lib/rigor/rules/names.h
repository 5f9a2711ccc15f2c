// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The names that repeat in a file, scope by scope.

#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
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

/// Things among which names are told apart: all that one element holds.
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
    for (std::uint32_t i = 0; i < document_.element_count(); ++i) look_at(document_.element(i));
    return std::move(scopes_);
  }

 private:
  void look_at(xml::Element element) {
    if (element.children().empty()) return;
    members_.clear();
    for (const xml::Element child : element.children()) {
      const std::string_view kind = child.name();
      const auto name = child.attribute("name");
      if (!name && kind != "include") continue;
      // What a plugin holds is its own business, and so is its name.
      if (kind == "plugin" || kind.find(':') != std::string_view::npos) continue;
      if (name) {
        const Span where = name->value_span().size() > 0 ? name->value_span() : child.tag_span();
        members_.push_back({kind, name->value(), where, child});
      } else {
        add_include(child);
      }
    }
    if (members_.size() > 1 && some_repeat() && !in_plugin(element)) scopes_.push_back({element.name(), members_});
  }

  bool some_repeat() {
    names_.clear();
    for (const Named& named : members_) names_.push_back(named.name);
    std::sort(names_.begin(), names_.end());
    return std::adjacent_find(names_.begin(), names_.end()) != names_.end();
  }

  static bool in_plugin(std::optional<xml::Element> element) {
    for (; element; element = element->parent()) {
      if (element->name() == "plugin") return true;
    }
    return false;
  }

  /// An include stands for the model that it brings, under the name that it gives it.
  void add_include(xml::Element element) {
    for (const model::Include& include : root_.includes) {
      if (!root_.own(include.site) || include.site.element != element.index()) continue;
      if (!include.loaded || include.merge.value) return;
      const Span where = include.name.written ? include.name.span : include.site.name;
      members_.push_back({"model", root_[include.loaded].name.value, where, element});
    }
  }

  const xml::Document& document_;
  const model::Root& root_;
  std::vector<Named> members_;           // of the scope that is looked at
  std::vector<std::string_view> names_;  // theirs, sorted
  std::vector<NameScope> scopes_;
};

}  // namespace rigor::rules
