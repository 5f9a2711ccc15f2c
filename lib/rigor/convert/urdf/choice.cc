// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/choice.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <rigor/model/subject.h>
#include <rigor/read/values.h>

namespace rigor::convert {
namespace {

using model::FrameProblemKind;
using model::Id;

/// A list of names is cut here: more would not be read.
constexpr std::size_t kMaxNamesReported = 12;

std::string model_names(const model::Root& root, const std::vector<Id<model::Model>>& models) {
  std::string names;
  for (std::size_t i = 0; i < models.size() && i < kMaxNamesReported; ++i) {
    names += (i == 0 ? "" : ", ") + scoped_name(root, models[i]);
  }
  return models.size() > kMaxNamesReported ? names + ", …" : names;
}

void add_lost_includes(const model::Root& root, Id<model::Model> scope, Notes& notes) {
  for (const model::Include& include : root.includes) {
    if (include.followed || include.model != scope) continue;
    notes.push_back({.kind = NoteKind::kUnresolved,
                     .where = include.uri.written ? include.uri.span : include.site.name,
                     .subject = scope ? model::subject(root, root[scope]) : std::string(),
                     .written = "include " + include.uri.value + " does not exist"});
  }
}

/// Of a joint's ends the joint itself tells.
bool is_of_joint_end(FrameProblemKind kind) {
  return kind == FrameProblemKind::kParentMissing || kind == FrameProblemKind::kChildMissing ||
         kind == FrameProblemKind::kChildIsWorld || kind == FrameProblemKind::kParentIsChild;
}

bool is_cycle(FrameProblemKind kind) {
  return kind == FrameProblemKind::kRelativeToCycle || kind == FrameProblemKind::kAttachedToCycle;
}

Note unresolved(const model::FrameProblem& problem) {
  return {
      .kind = NoteKind::kUnresolved,
      .where = problem.where,
      .subject = problem.subject,
      .written = problem.name + (is_cycle(problem.kind) ? " is in a cycle" : " does not exist")};
}

template <class T>
Note without_pose(const model::Root& root, const T& entity) {
  return {.kind = NoteKind::kUnresolved,
          .where = entity.site.name,
          .subject = model::subject(root, entity),
          .written = "it has no pose"};
}

/// The notes on what has no pose though every name was found: it stands in a cycle, or in a model
/// that does.
Notes without_poses(const Source& source, const UrdfTree& tree) {
  Notes notes;
  const auto look = [&](const auto& entity, const auto& id) {
    if (!source.frames.pose(id)) notes.push_back(without_pose(source.root, entity));
  };
  for (const auto id : tree.models) look(source.root[id], id);
  for (const auto id : tree.links) look(source.root[id], id);
  for (const UrdfTree::Edge& edge : tree.edges) look(source.root[edge.joint], edge.joint);
  for (const auto id : tree.frames) look(source.root[id], id);
  if (notes.empty()) return notes;
  notes.resize(1);
  for (const model::FrameProblem& problem : source.frames.problems()) {
    if (is_cycle(problem.kind)) notes.push_back(unresolved(problem));
  }
  if (notes.size() > 1) notes.erase(notes.begin());
  return notes;
}

/// A robot stands in no world.
void lose_name(Ledger& ledger, xml::Element world) {
  const auto name = world.attribute("name");
  if (!name) return;
  ledger.note({.kind = NoteKind::kIdle,
               .outcome = Outcome::kImplied,
               .where = name->span(),
               .written = "name " + std::string(name->value()) + " of the world"});
}

}  // namespace

UrdfChoice choose_model(const Source& source, const std::string& name) {
  const model::Root& root = source.root;
  std::vector<Id<model::Model>> found;
  for (std::uint32_t i = 0; i < root.models.size(); ++i) {
    if (root.models[i].merged) continue;
    const Id<model::Model> id{i};
    if (name.empty() ? !root[id].parent : scoped_name(root, id) == name) found.push_back(id);
  }
  UrdfChoice choice;
  if (found.size() == 1) {
    choice.model = found.front();
    return choice;
  }
  if (found.empty()) {
    add_lost_includes(root, {}, choice.notes);
    choice.notes.push_back({.kind = NoteKind::kNoModel, .where = root.site.name, .written = name});
  } else {
    choice.notes.push_back({.kind = NoteKind::kSeveralModels,
                            .where = root[found[1]].site.name,
                            .subject = model::subject(root, root[found[1]]),
                            .written = model_names(root, found),
                            .count = found.size()});
  }
  return choice;
}

Notes unresolved_in(const Source& source, const UrdfTree& tree) {
  Notes notes;
  for (const Id<model::Model> id : tree.models) add_lost_includes(source.root, id, notes);
  std::vector<bool> inside(source.root.models.size());
  for (const Id<model::Model> id : tree.models) inside[id.value] = true;
  for (const model::FrameProblem& problem : source.frames.problems()) {
    if (!problem.model || !inside[problem.model.value] || is_of_joint_end(problem.kind)) continue;
    notes.push_back(unresolved(problem));
  }
  return notes.empty() ? without_poses(source, tree) : notes;
}

void lose_surroundings(const Source& source, Ledger& ledger, Id<model::Model> model) {
  const model::Root& root = source.root;
  if (root.site.span.nowhere()) return;
  const xml::Document& document = source.documents.of(root.source);
  const model::Model& chosen = root[model];
  const model::Site& kept = root.own(chosen.site) || chosen.include >= root.includes.size()
                                ? chosen.site
                                : root.includes[chosen.include].site;
  if (kept.span.source != root.source) return;
  // What stands beside the model, and beside the world that it may stand in.
  for (auto at = std::optional(document.element(kept.element)); at && at->parent();
       at = at->parent()) {
    if (at->name() == "world") lose_name(ledger, *at);
    for (const xml::Element sibling : at->parent()->children()) {
      if (sibling == *at) continue;
      const model::Site site = read::site_of(sibling);
      ledger.open(site);
      ledger.lose(site, {.kind = NoteKind::kWorld, .written = std::string(sibling.name())});
    }
  }
}

}  // namespace rigor::convert
