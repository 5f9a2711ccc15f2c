// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What edits cannot carry into the newer version, derived from the schema's tables.

#include <map>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/upgrade/step.h>
#include <rigor/read/conformance.h>

namespace rigor::author {
namespace {

using read::SchemaFact;
using read::SchemaFactKind;
using schema::Node;
using schema::Version;

std::string shown(const SchemaFact& fact) {
  const std::string parent = fact.parent ? std::string(fact.parent->name()) : std::string();
  if (fact.attribute) {
    return fmt::format("attribute {} of <{}>", fact.attribute->name(), fact.element.name());
  }
  return fmt::format("<{}> in <{}>", fact.element.name(), parent);
}

/// An element or attribute of the version that is not written, by the names of the element and it.
using Unwritten = std::pair<std::string_view, std::string_view>;

struct ChangedDefault {
  Span where;
  std::string_view before;
  std::string_view after;
  std::size_t count = 0;
};

/// Unlimited whatever the version calls it, and what has no bearing.
bool means_the_same(const Unwritten& name) {
  return name.first == "limit" || name.second == "version" || name.second == "view_controller";
}

class DefaultWalk {
 public:
  void look_at(xml::Element element, const Node& before, const Node& after) {
    for (const Node child : before.children()) compare(element, child, after);
    for (const Node attribute : before.attributes()) compare(element, attribute, after);
  }

  UpgradeNotes notes(Version from, Version to) const {
    UpgradeNotes notes;
    for (const auto& [name, changed] : changed_) {
      const std::string more =
          changed.count > 1 ? fmt::format(" (and {} more)", changed.count - 1) : "";
      notes.add({UpgradeNoteKind::kDefaultChanged, Severity::kInfo, changed.where,
                 fmt::format("{} of <{}> is not written{}: its default is {} in {} and {} in "
                             "{}; libsdformat takes the newest for either",
                             name.second, name.first, more, changed.before, to_string(from),
                             changed.after, to_string(to))});
    }
    return notes;
  }

 private:
  void compare(xml::Element element, const Node& part, const Node& after) {
    const std::string_view name = part.name();
    if (element.child(name) || element.attribute(name)) return;
    const auto child = after.child(name);
    const auto same = child ? child : after.attribute(name);
    if (!same || !part.default_value() || !same->default_value()) return;
    if (*part.default_value() == *same->default_value()) return;
    if (means_the_same({element.name(), name})) return;
    ChangedDefault& changed = changed_[{element.name(), name}];
    if (changed.count++ > 0) return;
    changed.where = element.name_span();
    changed.before = *part.default_value();
    changed.after = *same->default_value();
  }

  std::map<Unwritten, ChangedDefault> changed_;
};

}  // namespace

UpgradeNotes notes_after_upgrade(const xml::Document& after, const schema::Schema& schema,
                                 Version from, Version to) {
  UpgradeNotes notes;
  const auto top = after.root();
  const auto root = top ? schema.root(top->name(), to) : std::nullopt;
  if (!root) return notes;
  read::check_conformance(after, *root, [&](const SchemaFact& fact) {
    if (fact.kind == SchemaFactKind::kRemovedInVersion && fact.node && fact.node->until() &&
        *fact.node->until() >= from) {
      notes.add({UpgradeNoteKind::kRemoved, Severity::kWarning, fact.where,
                 fmt::format("{} stays as it is, but is nothing to {}: {} is the last "
                             "version that has it",
                             shown(fact), to_string(to), to_string(*fact.node->until()))});
    }
    if (fact.kind == SchemaFactKind::kDeprecated && fact.node && fact.node->deprecated_since() &&
        *fact.node->deprecated_since() > from) {
      const std::string instead = fact.node->instead().empty()
                                      ? ""
                                      : fmt::format("; its successor is {}", fact.node->instead());
      notes.add({UpgradeNoteKind::kDeprecated, Severity::kInfo, fact.where,
                 fmt::format("{} is deprecated since {}{}", shown(fact),
                             to_string(*fact.node->deprecated_since()), instead)});
    }
  });
  return notes;
}

UpgradeNotes notes_on_defaults(const xml::Document& before, const schema::Schema& schema,
                               Version from, Version to) {
  const auto old_nodes = schema_nodes(before, schema, from);
  const auto new_nodes = schema_nodes(before, schema, to);
  DefaultWalk walk;
  for (std::uint32_t i = 0; i < before.element_count(); ++i) {
    if (old_nodes[i] && new_nodes[i]) walk.look_at(before.element(i), *old_nodes[i], *new_nodes[i]);
  }
  return walk.notes(from, to);
}

}  // namespace rigor::author
