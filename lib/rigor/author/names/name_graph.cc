// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/name_graph.h>

#include <algorithm>
#include <set>
#include <utility>

#include <rigor/read/model_config.h>
#include <rigor/text/path.h>

namespace rigor::author {
namespace {

constexpr std::string_view kScopeMark = "::";

constexpr NameKinds kAnyKind{NameKind::kLink, NameKind::kJoint, NameKind::kFrame, NameKind::kModel};

/// The models around a scope, outermost first, as entities of the file; none of a world.
std::vector<std::uint32_t> models_around(const FileNames& names, std::uint32_t scope) {
  std::vector<std::uint32_t> models;
  while (true) {
    const NameScope& here = names.scopes[scope];
    if (here.model != kNoEntity) models.insert(models.begin(), here.model);
    if (here.outer == scope) return models;
    scope = here.outer;
  }
}

}  // namespace

void NameGraph::add_robot(const std::string& path) {
  std::string normal = normalize_path(path);
  if (std::find(robots_.begin(), robots_.end(), normal) != robots_.end()) return;
  robots_.push_back(std::move(normal));
  uses_.clear();  // names that meant nothing may mean something now
}

void NameGraph::index(Indexed& file) {
  const std::vector<NamedEntity>& entities = file.names.entities;
  for (std::uint32_t i = 0; i < entities.size(); ++i) {
    const NamedEntity& entity = entities[i];
    if (!entity.name.empty()) file.by_name[{entity.scope, entity.name}].push_back(i);
    if (!entity.uri.empty() && (entity.name.empty() || entity.merged))
      file.unnamed[entity.scope].push_back(i);
  }
}

const NameGraph::Indexed& NameGraph::indexed(const std::string& path) {
  const std::string normal = normalize_path(path);
  const auto known = names_.find(normal);
  if (known != names_.end()) return known->second;
  const read::File& file = workspace_.open(path);
  Indexed& indexed = names_[normal];
  if (!file.document) return indexed;
  indexed.names = file_names(*file.document);
  index(indexed);
  return indexed;
}

/// Of a folder, the file that its model.config names, as the reader has it.
std::optional<std::string> NameGraph::included(const std::string& path,
                                               const NamedEntity& include) {
  const read::Resolution& found = workspace_.resolve(resolver_, include.uri, path);
  if (!found.path) return std::nullopt;
  if (workspace_.disk().kind(*found.path) != PathKind::kFolder) return *found.path;
  const read::File& config = workspace_.open(join_path(*found.path, "model.config"));
  if (!config.document) return std::nullopt;
  const read::ModelConfig read = read::read_model_config(*config.document);
  const read::SdfEntry* entry = read::choose(read);
  if (entry == nullptr) return std::nullopt;
  return join_path(*found.path, entry->file.value);
}

std::optional<NameGraph::Place> NameGraph::inside(const EntityId& model) {
  const NamedEntity& entity = this->entity(model);
  if (entity.kind != NameKind::kModel) return std::nullopt;
  if (entity.inside != kNoEntity) return Place{model.path, entity.inside};
  if (entity.uri.empty()) return std::nullopt;
  const auto path = included(model.path, entity);
  if (!path) return std::nullopt;
  const FileNames& names = this->names(*path);
  for (const NamedEntity& each : names.entities) {
    if (each.kind == NameKind::kModel && each.scope == 0 && each.inside != kNoEntity)
      return Place{normalize_path(*path), each.inside};
  }
  return std::nullopt;
}

/// Here, then in the models that are merged into the place, however they include each other.
std::optional<EntityId> NameGraph::find_here(const Place& place, std::string_view name,
                                             NameKinds kinds) {
  std::vector<Place> open{{normalize_path(place.path), place.scope}};
  std::set<std::pair<std::string, std::uint32_t>> seen;
  for (std::size_t next = 0; next < open.size(); ++next) {
    const Place here = open[next];
    if (!seen.emplace(here.path, here.scope).second) continue;
    const Indexed& file = indexed(here.path);
    if (const auto named = file.by_name.find({here.scope, name}); named != file.by_name.end()) {
      for (const std::uint32_t index : named->second) {
        if (kinds.has(file.names.entities[index].kind)) return EntityId{here.path, index};
      }
    }
    const auto unnamed = file.unnamed.find(here.scope);
    if (unnamed == file.unnamed.end()) continue;
    for (const std::uint32_t index : unnamed->second) {
      const auto there = inside({here.path, index});
      if (!there) continue;
      if (file.names.entities[index].merged) {
        open.push_back(*there);
      } else if (kinds.has(NameKind::kModel)) {
        const FileNames& names = this->names(there->path);
        const std::uint32_t model = names.scopes[there->scope].model;
        if (names.entities[model].name == name) return EntityId{there->path, model};
      }
    }
  }
  return std::nullopt;
}

/// A name is tried whole first, since older files have `::` in names.
std::vector<NameUse> NameGraph::parts_in(Place place, const NameReference& reference) {
  std::vector<NameUse> uses;
  std::string_view rest = reference.text;
  std::uint32_t begin = reference.where.begin;
  while (true) {
    if (const auto whole = find_here(place, rest, reference.kinds)) {
      const Span where{reference.where.source, begin,
                       begin + static_cast<std::uint32_t>(rest.size())};
      uses.push_back({*whole, where});
      return uses;
    }
    const std::size_t mark = rest.find(kScopeMark);
    if (mark == std::string_view::npos) return {};
    const std::string_view first = rest.substr(0, mark);
    const auto model = find_here(place, first, {NameKind::kModel});
    const auto next = model ? inside(*model) : std::nullopt;
    if (!next) return {};
    uses.push_back(
        {*model, {reference.where.source, begin, begin + static_cast<std::uint32_t>(mark)}});
    rest.remove_prefix(mark + kScopeMark.size());
    begin += static_cast<std::uint32_t>(mark + kScopeMark.size());
    place = *next;
  }
}

/// SRDF says of which robot it is by that one's name; several files may have it.
std::vector<std::string> NameGraph::described_robots(const std::string& path) {
  const FileNames& names = this->names(path);
  if (names.shared_kinds || names.entities.size() != 1) return {};
  std::vector<std::string> robots;
  for (const std::string& robot : robots_) {
    const FileNames& others = this->names(robot);
    if (!others.entities.empty() && others.entities[0].name == names.entities[0].name)
      robots.push_back(robot);
  }
  return robots;
}

std::vector<NameUse> NameGraph::parts(const std::string& path, const NameReference& reference) {
  if (reference.within != kNoEntity) {
    const auto place = inside({normalize_path(path), reference.within});
    return place ? parts_in(*place, reference) : std::vector<NameUse>{};
  }
  std::vector<NameUse> uses = parts_in({normalize_path(path), reference.scope}, reference);
  if (!uses.empty()) return uses;
  // Plugins name what is around them, too: from the world, or from their own model on.
  const FileNames& names = this->names(path);
  for (std::uint32_t scope = reference.scope;
       !reference.certain && scope != names.scopes[scope].outer;) {
    scope = names.scopes[scope].outer;
    uses = parts_in({normalize_path(path), scope}, reference);
    if (!uses.empty()) return uses;
  }
  for (const std::string& robot : described_robots(path)) {
    for (NameUse& use : parts_in({robot, 0}, reference)) uses.push_back(std::move(use));
  }
  return uses;
}

std::vector<NameUse> NameGraph::find_uses(const std::string& path) {
  std::vector<NameUse> uses;
  const FileNames& names = this->names(path);
  const std::string normal = normalize_path(path);
  for (std::uint32_t i = 0; i < names.entities.size(); ++i) {
    if (!names.entities[i].where.nowhere())
      uses.push_back({{normal, i}, names.entities[i].where, true});
  }
  for (const NameReference& reference : names.references) {
    for (NameUse& use : parts(path, reference)) uses.push_back(std::move(use));
  }
  return uses;
}

const std::vector<NameUse>& NameGraph::uses(const std::string& path) {
  const std::string normal = normalize_path(path);
  const auto known = uses_.find(normal);
  if (known != uses_.end()) return known->second;
  return uses_[normal] = find_uses(path);
}

std::optional<EntityId> NameGraph::find(const std::string& path, std::string_view name) {
  const FileNames& names = this->names(path);
  NameReference reference;
  reference.text = name;
  reference.kinds = kAnyKind;
  for (std::uint32_t scope = 0; scope < names.scopes.size(); ++scope) {
    const auto uses = parts_in({normalize_path(path), scope}, reference);
    if (!uses.empty()) return uses.back().target;
  }
  return std::nullopt;
}

std::vector<EntityId> NameGraph::find_each_kind(const Place& place, std::string_view name) {
  std::vector<EntityId> found;
  NameReference reference;
  reference.text = name;
  for (const NameKind kind :
       {NameKind::kModel, NameKind::kLink, NameKind::kJoint, NameKind::kFrame}) {
    reference.kinds = {kind};
    const auto uses = parts_in(place, reference);
    if (!uses.empty()) found.push_back(uses.back().target);
  }
  return found;
}

std::vector<EntityId> NameGraph::find_all(const std::string& path, std::string_view name,
                                          std::string_view model) {
  const FileNames& names = this->names(path);
  const std::string normal = normalize_path(path);
  std::vector<EntityId> found;
  std::map<std::uint32_t, std::size_t>
      depths;  // of what is found, by the outermost model around it
  for (std::uint32_t scope = 0; scope < names.scopes.size(); ++scope) {
    for (EntityId& id : find_each_kind({normal, scope}, name)) {
      const bool is_own = id.path == normal;
      const auto around = models_around(names, is_own ? names.entities[id.index].scope : scope);
      const std::uint32_t outermost = !around.empty() ? around.front()
                                      : is_own        ? id.index
                                                      : kNoEntity;
      const bool is_asked =
          model.empty() || (outermost != kNoEntity && names.entities[outermost].name == model);
      if (!is_asked || std::find(found.begin(), found.end(), id) != found.end()) continue;
      if (around.empty() ||
          depths.try_emplace(outermost, around.size()).first->second >= around.size())
        found.push_back(std::move(id));
    }
    // A model of another file, by what this one calls it.
    if (model.empty() || names.scopes[scope].model != kNoEntity) continue;
    const auto included = find_here({normal, scope}, model, {NameKind::kModel});
    const auto place = included ? inside(*included) : std::nullopt;
    if (!place || place->path == normal) continue;
    for (EntityId& id : find_each_kind(*place, name)) found.push_back(std::move(id));
  }
  return found;
}

std::string NameGraph::scoped_name(const EntityId& id) {
  const FileNames& names = this->names(id.path);
  std::string scoped;
  if (names.shared_kinds) {
    for (const std::uint32_t model : models_around(names, names.entities[id.index].scope))
      scoped += names.entities[model].name + std::string(kScopeMark);
  }
  return scoped + names.entities[id.index].name;
}

std::vector<std::string> NameGraph::visible(const std::string& path, std::uint32_t offset,
                                            NameKinds kinds) {
  const FileNames& names = this->names(path);
  std::uint32_t scope = 0;
  for (const NamedEntity& entity : names.entities) {
    const bool around = entity.element.begin < offset && offset < entity.element.end;
    if (entity.inside != kNoEntity && around) scope = entity.inside;
  }
  // A world is a scope without a name of its own.
  if (scope == 0 && names.shared_kinds && names.scopes.size() > 1) scope = 1;
  std::vector<std::string> visible;
  for (std::uint32_t i = 0; i < names.entities.size(); ++i) {
    const NamedEntity& entity = names.entities[i];
    if (entity.scope != scope || entity.inside == scope || entity.name.empty()) continue;
    if (kinds.has(entity.kind)) visible.push_back(entity.name);
    const auto there = inside({normalize_path(path), i});
    if (!there) continue;
    for (const NamedEntity& part : this->names(there->path).entities) {
      if (part.scope == there->scope && kinds.has(part.kind) && !part.name.empty())
        visible.push_back(entity.name + std::string(kScopeMark) + part.name);
    }
  }
  for (const std::string& robot : described_robots(path)) {
    for (const NamedEntity& part : this->names(robot).entities) {
      if (kinds.has(part.kind) && !part.name.empty()) visible.push_back(part.name);
    }
  }
  return visible;
}

std::optional<EntityId> NameGraph::taken(const EntityId& target, std::string_view name) {
  const FileNames& names = this->names(target.path);
  const NamedEntity& entity = names.entities[target.index];
  const NameKinds same{entity.kind};
  return find_here({target.path, entity.scope}, name, names.shared_kinds ? kAnyKind : same);
}

}  // namespace rigor::author
