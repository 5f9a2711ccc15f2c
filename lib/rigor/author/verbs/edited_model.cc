// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/edited_model.h>

#include <algorithm>
#include <set>
#include <utility>

#include <rigor/read/template/template_expander.h>
#include <rigor/robot/lookups.h>
#include <rigor/rules/mesh_finder.h>
#include <rigor/text/path.h>

namespace rigor::author {
namespace {

using model::Id;

/// What the root calls it, without the models around the one that is changed.
template <class T>
std::string name_inside(const EditedModel& edited, Id<T> id) {
  const std::string whole = scoped_name(edited.root(), id);
  const std::size_t prefix = scoped_name(edited.root(), edited.model).size() + 2;
  return whole.size() > prefix ? whole.substr(prefix) : std::string();
}

/// Without its scope. A joint or frame with a link's name has another one to refer to.
template <class T>
std::string_view own_name(const T& each) {
  if constexpr (requires { each.alias; }) {
    if (!each.alias.empty()) return each.alias;
  }
  return each.name.value;
}

template <class T>
Id<T> named_inside(const EditedModel& edited, const std::vector<T>& all, std::string_view name) {
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    // Thousands of names are not put together for each question.
    if (!name.ends_with(own_name(all[i]))) continue;
    if (edited.inside(all[i].model) && name_inside(edited, Id<T>{i}) == name) return {i};
  }
  return {};
}

template <class T>
std::uint32_t index_named(const std::vector<T>& all, std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const T& each) { return each.name == name; });
  return found == all.end() ? robot::kNoIndex : static_cast<std::uint32_t>(found - all.begin());
}

std::string unreadable(const read::Loaded& loaded) {
  if (!loaded.file->document) return ": " + loaded.file->problem;
  if (!loaded.file->document->complete()) return " is not well-formed";
  const model::Format format = loaded.root.format;
  if (format == model::Format::kMjcf) return std::string(kMjcfNotEdited);
  if (format != model::Format::kSdf && format != model::Format::kUrdf) return " is no robot model";
  if (loaded.root.models.empty()) return " has no model";
  for (const model::Include& include : loaded.root.includes) {
    if (!include.followed) return ": the include of " + include.uri.value + " cannot be followed";
  }
  return {};
}

/// Those of the file itself that no other model holds.
std::vector<Id<model::Model>> outermost(const model::Root& root) {
  std::vector<Id<model::Model>> models;
  for (std::uint32_t i = 0; i < root.models.size(); ++i) {
    if (!root.models[i].parent && root.own(root.models[i].site)) models.push_back({i});
  }
  return models;
}

/// "two joints are named 'elbow'"; empty when names are unique.
std::string name_used_twice(const robot::Robot& robot) {
  std::set<std::string_view> links, joints;
  for (const robot::Body& body : robot.bodies) {
    if (!links.insert(body.name).second) return "two links are named '" + body.name + '\'';
  }
  for (const robot::Joint& joint : robot.joints) {
    if (!joints.insert(joint.name).second) return "two joints are named '" + joint.name + '\'';
  }
  return {};
}

}  // namespace

EditedModel::EditedModel(read::Workspace& the_workspace, const Environment& the_environment,
                         Sources& the_sources, read::Loaded the_loaded, Id<model::Model> the_model,
                         mass::FindMesh the_find_mesh)
    : workspace(the_workspace),
      environment(the_environment),
      sources(the_sources),
      loaded(std::move(the_loaded)),
      frames(loaded.root),
      model(the_model),
      find_mesh(std::move(the_find_mesh)),
      robot(robot_with(loaded.root)) {}

robot::Robot EditedModel::robot_with(const model::Root& changed) const {
  robot::Lookups lookups = robot::lookups_in(changed, workspace, environment.resolver);
  lookups.find_mesh = find_mesh;
  return robot::robot_of(changed, model::Frames(changed), model, lookups);
}

bool EditedModel::inside(Id<model::Model> id) const {
  for (; id; id = root()[id].parent) {
    if (id == model) return true;
  }
  return false;
}

Id<model::Link> EditedModel::link(std::string_view name) const {
  return named_inside(*this, root().links, name);
}
Id<model::Joint> EditedModel::joint(std::string_view name) const {
  return named_inside(*this, root().joints, name);
}
Id<model::Frame> EditedModel::frame(std::string_view name) const {
  return named_inside(*this, root().frames, name);
}

std::uint32_t EditedModel::body_index(std::string_view name) const {
  return index_named(robot.bodies, name);
}
std::uint32_t EditedModel::joint_index(std::string_view name) const {
  return index_named(robot.joints, name);
}

std::string EditedModel::name_of(Id<model::Link> id) const { return name_inside(*this, id); }
std::string EditedModel::name_of(Id<model::Joint> id) const { return name_inside(*this, id); }
std::string EditedModel::name_of(Id<model::Frame> id) const { return name_inside(*this, id); }

ModelReader::ModelReader(const Environment& environment, Sources& sources)
    : environment_(environment),
      sources_(sources),
      surveys_(environment.disk, {.workers = &environment.workers}),
      workspace_(environment.resolver, sources) {}

ModelReader::~ModelReader() = default;

OpenedModel ModelReader::open(const std::string& path, const std::string& model) {
  return opened(workspace_, workspace_.open(path), model);
}

OpenedModel ModelReader::open_changed(const std::string& path, const std::string& model,
                                      const std::map<std::string, std::string>& texts) {
  changed_.push_back(std::make_unique<read::Workspace>(environment_.resolver, sources_));
  read::Workspace& workspace = *changed_.back();
  const std::string normal = normalize_path(path);
  const std::string* own = nullptr;
  for (const auto& [file, text] : texts) {
    if (normalize_path(file) == normal) {
      own = &text;
    } else {
      workspace.put_included(file, text);
    }
  }
  for (const auto& [file, text] : texts) {
    if (&text != own && !read::is_template(file)) workspace.put(file, text);
  }
  return opened(workspace, own ? workspace.put(path, *own) : workspace.open(path), model);
}

OpenedModel ModelReader::opened(read::Workspace& workspace, const read::File& file,
                                const std::string& model) {
  const read::Reader reader{workspace, environment_.resolver, environment_.sdf, environment_.urdf};
  read::Loaded loaded = read::load(reader, file);
  if (const std::string why = unreadable(loaded); !why.empty()) return {nullptr, file.path + why};
  if (file.expanded && !file.expanded->ok()) return {nullptr, file.path + " does not expand"};
  const std::vector<Id<model::Model>> models = outermost(loaded.root);
  if (models.empty())
    return {nullptr, file.path + " has no model of its own: edit those that it includes"};
  Id<model::Model> chosen = models.front();
  if (models.size() > 1) {
    const auto named = std::find_if(models.begin(), models.end(), [&](Id<model::Model> id) {
      return loaded.root[id].name.value == model;
    });
    if (named == models.end())
      return {nullptr, file.path + " has several models: choose one with --model"};
    chosen = *named;
  }
  auto edited =
      std::make_unique<EditedModel>(workspace, environment_, sources_, std::move(loaded), chosen,
                                    rules::mesh_finder(environment_.resolver, sources_, surveys_));
  const std::vector<std::string>& unknown = edited->robot.unknown;
  if (!unknown.empty()) return {nullptr, file.path + ": " + unknown.front()};
  // What is asked of a name would be of both.
  if (const std::string twice = name_used_twice(edited->robot); !twice.empty())
    return {nullptr, file.path + ": " + twice};
  return {std::move(edited), {}};
}

}  // namespace rigor::author
