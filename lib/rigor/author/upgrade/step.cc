// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/upgrade/step.h>

#include <algorithm>

#include <fmt/core.h>

namespace rigor::author {

void UpgradeNotes::add(UpgradeNote note) {
  OfKind& of_kind = kinds_[note.kind];
  if (of_kind.listed.size() < kMaxOfKind) {
    of_kind.listed.push_back(std::move(note));
  } else {
    ++of_kind.more;
  }
}

bool UpgradeNotes::has_errors() const {
  return std::any_of(kinds_.begin(), kinds_.end(), [](const auto& kind) {
    return kind.second.listed.front().severity == Severity::kError;
  });
}

std::vector<UpgradeNote> UpgradeNotes::take_list() {
  std::vector<UpgradeNote> list;
  for (auto& [kind, of_kind] : kinds_) {
    for (UpgradeNote& note : of_kind.listed) list.push_back(std::move(note));
  }
  std::stable_sort(list.begin(), list.end(), [](const UpgradeNote& a, const UpgradeNote& b) {
    return a.where.begin < b.where.begin;
  });
  for (const auto& [kind, of_kind] : kinds_) {
    if (of_kind.more == 0) continue;
    list.push_back({kind,
                    of_kind.listed.front().severity,
                    {},
                    fmt::format("{} more of the kind {}", of_kind.more, to_string(kind))});
  }
  kinds_.clear();
  return list;
}

std::vector<std::optional<schema::Node>> schema_nodes(const xml::Document& document,
                                                      const schema::Schema& schema,
                                                      schema::Version version) {
  std::vector<std::optional<schema::Node>> nodes(document.element_count());
  const auto top = document.root();
  if (!top) return nodes;
  // An old root in a newer file, or the other way round, holds the same.
  nodes[0] = schema.root("sdf", version);
  if (!nodes[0]) nodes[0] = schema.root("gazebo", version);
  for (std::uint32_t i = 1; i < document.element_count(); ++i) {
    const xml::Element element = document.element(i);
    const auto parent = element.parent();
    if (!parent || !nodes[parent->index()] || nodes[parent->index()]->open()) continue;
    const schema::Node& above = *nodes[parent->index()];
    nodes[i] = above.child(element.name());
    if (!nodes[i]) nodes[i] = above.child_in_other_version(element.name());
  }
  return nodes;
}

}  // namespace rigor::author
