// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/rule.h>
#include <rigor/schema/schema.h>

namespace rigor::rules::element_newer_than_classic {

constexpr schema::Version kNewestOfClassic{7};

/// An element, what its place is in the file's version, and in the newest of Gazebo classic.
struct Place {
  xml::Element element;
  schema::Node now;
  schema::Node classic;
};

/// Tells of each name once in a file: a world full of capsules has one thing to change.
class NewerTeller {
 public:
  explicit NewerTeller(Context& context) : context_(context) {}

  void tell(const schema::Node& node, Span where) {
    if (!reported_.insert(node.name()).second) return;
    context_.report({.where = where,
                     .message = "'" + std::string(node.name()) + "' came with SDF " +
                                schema::to_string(node.since()) +
                                ": Gazebo classic reads SDF up to 1.7"});
  }

 private:
  Context& context_;
  std::set<std::string_view> reported_;
};

void check(const model::Root& root, Context& context) {
  // In an older file element-newer-than-version reports it, whatever the file is for.
  if (root.version <= kNewestOfClassic.minor || context.schema() == nullptr) return;
  const auto top = context.document().root();
  if (!top) return;
  const auto now = context.schema()->root(top->name(), {root.version});
  const auto classic = context.schema()->root(top->name(), kNewestOfClassic);
  if (!now || !classic) return;
  NewerTeller teller(context);
  std::vector<Place> open{{*top, *now, *classic}};
  while (!open.empty()) {
    const Place at = open.back();
    open.pop_back();
    if (at.now.open()) continue;
    for (const xml::Attribute attribute : at.element.attributes()) {
      const auto known = at.now.attribute(attribute.name());
      if (known && !at.classic.attribute(attribute.name())) {
        teller.tell(*known, attribute.name_span());
      }
    }
    const std::size_t first = open.size();
    for (const xml::Element child : at.element.children()) {
      const auto known = at.now.child(child.name());
      const auto was = at.classic.child(child.name());
      if (known && was) open.push_back({child, *known, *was});
      if (known && !was) teller.tell(*known, child.name_span());
    }
    std::reverse(open.begin() + static_cast<std::ptrdiff_t>(first), open.end());
  }
}

Rule rule() {
  return {
      .name = "element-newer-than-classic",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .targets = {Target::kGazeboClassic},
      .summary = "an element or attribute is newer than what Gazebo classic reads",
      .why = "Gazebo classic reads SDF up to 1.7. What came later it ignores: a capsule is no "
             "shape, an include with merge nests its model, degrees are taken for radians.",
      .what_to_do =
          "Write it as SDF 1.7 has it: a cylinder for a capsule, radians for degrees, the parts "
          "themselves for an include that merges. Each name is reported once in a file.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::element_newer_than_classic
