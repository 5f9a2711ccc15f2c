// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/prefix.h>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/names/name_graph.h>
#include <rigor/author/names/parameter_names.h>
#include <rigor/author/names/rename.h>
#include <rigor/author/names/text_mentions.h>
#include <rigor/text/path.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

/// A name of the model's own scope to another; nothing where it stays.
using NewName = std::function<std::optional<std::string>(const std::string&)>;

/// Of `hand::palm` the part that is in the model's own scope.
void rename_outermost(std::string& name, const NewName& new_name) {
  const std::size_t mark = name.find("::");
  if (const auto first = new_name(name.substr(0, mark)))
    name = *first + (mark == std::string::npos ? "" : name.substr(mark));
}

robot::Robot with_names(robot::Robot robot, const NewName& new_name) {
  for (robot::Body& body : robot.bodies) rename_outermost(body.name, new_name);
  for (robot::Joint& joint : robot.joints) {
    rename_outermost(joint.name, new_name);
    for (robot::Axis& axis : joint.axes) {
      if (axis.follow) rename_outermost(axis.follow->joint, new_name);
    }
  }
  for (robot::Frame& frame : robot.frames) rename_outermost(frame.name, new_name);
  return robot;
}

/// The scope of the model in its file's names.
std::uint32_t scope_of(const EditedModel& edited, const FileNames& names) {
  const Span element = edited.root()[edited.model].site.span;
  for (const NamedEntity& entity : names.entities) {
    if (entity.kind == NameKind::kModel && entity.element.begin == element.begin)
      return entity.inside;
  }
  return kNoEntity;
}

/// An include that takes its model's own name gets one.
std::vector<Edit> named_include(const EditedModel& edited, const NamedEntity& entity,
                                const NewName& new_name) {
  for (const model::Include& include : edited.root().includes) {
    if (include.site.span.begin != entity.element.begin || !edited.root().own(include.site))
      continue;
    if (!include.loaded) return {};
    const auto name = new_name(edited.root()[include.loaded].name.value);
    const xml::Element element = edited.element(include.site);
    return name ? xml::insert_child(edited.document(), element, element.child("uri"),
                                    "<name>" + xml::escaped(*name) + "</name>")
                : std::vector<Edit>{};
  }
  return {};
}

/// What refers to a model of another file by that one's own name refers to its include now.
void rename_included(const EditedModel& edited, NameGraph& graph, const std::string& path,
                     const NewName& new_name, Change& change) {
  std::set<std::string> files;
  for (const model::Include& include : edited.root().includes) {
    if (include.model == edited.model && !include.name.written)
      files.insert(normalize_path(include.path));
  }
  for (const NameUse& use : graph.uses(path)) {
    const NamedEntity& entity = graph.entity(use.target);
    if (use.defines || !files.contains(use.target.path) || entity.kind != NameKind::kModel)
      continue;
    if (const auto name = new_name(entity.name)) change.steps.push_back({{use.where, *name}});
  }
}

Change with_new_names(const EditedModel& edited, const NewName& new_name,
                      const ReferringFiles& files) {
  NameGraph graph(edited.workspace, edited.environment.resolver);
  graph.add_robot(edited.path());
  const std::string path = normalize_path(edited.path());
  const FileNames& names = graph.names(path);
  const std::uint32_t scope = scope_of(edited, names);
  Change change;
  std::map<EntityId, std::string> targets;
  bool has_unnamed = false;
  for (std::uint32_t i = 0; i < names.entities.size(); ++i) {
    const NamedEntity& entity = names.entities[i];
    if (entity.scope != scope || entity.inside == scope) continue;
    if (entity.merged)
      return refusal("the names of " + entity.uri +
                     ", which is merged into it, are in another file");
    if (entity.name.empty() && !entity.uri.empty()) {
      change.steps.push_back(named_include(edited, entity, new_name));
      has_unnamed = true;
    } else if (auto name = new_name(entity.name)) {
      targets.emplace(EntityId{path, i}, *std::move(name));
    }
  }
  if (targets.empty() && change.steps.empty()) return refusal("no name of the model would change");
  Renaming renaming = renamed({graph, edited.environment.resolver, edited.sources}, targets, files);
  if (!renaming.refused.empty()) return refusal(std::move(renaming.refused));
  for (Edit& edit : renaming.edits) change.steps.push_back({std::move(edit)});
  if (has_unnamed) rename_included(edited, graph, path, new_name, change);
  for (const std::string& line : mention_lines(edited.sources, renaming.suspected))
    change.notes.push_back(line + "; not renamed");
  change.expected = with_names(edited.robot, new_name);
  change.references = References::kKept;
  // What is in a link of another name is another link's: the names that refer to it are counted instead.
  change.asks_for_setting = [](const robot::Difference&) { return true; };
  return change;
}

}  // namespace

Change prefixed(const EditedModel& edited, std::string_view prefix, const ReferringFiles& files) {
  return with_new_names(
      edited,
      [prefix](const std::string& name) -> std::optional<std::string> {
        if (name == robot::kWorldBody || name.empty()) return std::nullopt;
        return std::string(prefix) + name;
      },
      files);
}

Change unprefixed(const EditedModel& edited, std::string_view prefix, const ReferringFiles& files) {
  return with_new_names(
      edited,
      [prefix](const std::string& name) -> std::optional<std::string> {
        if (!name.starts_with(prefix)) return std::nullopt;
        return name.substr(prefix.size());
      },
      files);
}

}  // namespace rigor::author
