// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "model/model_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include <rigor/read/discover.h>
#include <rigor/read/model_config.h>
#include <rigor/read/template/template_expander.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/rules/xacro/entry_points.h>
#include <rigor/schema/value.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "model/expansion_map.h"
#include "option/numbers.h"
#include "option/search.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

std::string model_named_by(const std::string& config, const read::ModelConfig& read) {
  const read::SdfEntry* entry = choose(read);
  if (entry == nullptr) throw UsageError(config + ": names no SDF file");
  return join_path(parent_path(config), entry->file.value);
}

constexpr std::size_t kMaxListed = 3;

read::Discovered discovered_in(const Disk& disk, const std::string& folder) {
  read::Discovered found = read::discover(disk, {folder});
  for (const std::string& unusable : found.unusable) throw UsageError(unusable);
  std::erase_if(found.files,
                [](const std::string& path) { return path.ends_with("model.config"); });
  return found;
}

/// Its model.config, or the only model in it.
std::string model_file_in(const Disk& disk, const std::string& folder) {
  std::string config = join_path(folder, "model.config");
  if (disk.kind(config) == PathKind::kFile) return config;
  std::vector<std::string> found = discovered_in(disk, folder).files;
  std::erase_if(found, [](const std::string& path) { return path.ends_with(".srdf"); });
  if (found.empty()) throw UsageError(folder + ": no model in this folder");
  if (found.size() == 1) return found.front();
  std::string names;
  for (std::size_t i = 0; i < std::min(found.size(), kMaxListed); ++i) names += ' ' + found[i];
  throw UsageError(folder + ": " + report::counted(found.size(), "model") +
                   " in this folder, and no model.config: name one," + names +
                   (found.size() > kMaxListed ? " …" : ""));
}

/// Of a template with errors: the first of them.
[[noreturn]] void refuse(const read::File& file, const Sources& sources) {
  const Reach reach({file.path}, read::search_paths_from(path_variable));
  for (const xacro::Fact& fact : file.expanded->expansion().facts) {
    if (!xacro::is_error(fact.kind)) continue;
    throw InputError(shown_place(sources, fact.where) + ": " + described(fact, sources, reach) +
                     "; `rigor validate` says more");
  }
  throw InputError(file.path + ": holds nothing");
}

std::string joint_named(const model::Root& root, const std::string& name) {
  std::vector<std::string> names;
  std::vector<std::string> matching;
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    names.push_back(scoped_name(root, model::Id<model::Joint>{i}));
    if (names.back() == name) return name;
    if (root.joints[i].name.value == name) matching.push_back(names.back());
  }
  if (matching.size() == 1) return matching.front();
  std::vector<std::string_view> known(names.begin(), names.end());
  if (matching.empty()) {
    for (const model::Joint& joint : root.joints) known.push_back(joint.name.value);
    throw UsageError("--joint " + name + ": no such joint" + did_you_mean(name, known));
  }
  throw UsageError("--joint " + name + ": " + report::counted(matching.size(), "joint") +
                   " have this name; write " + matching[0] + " or " + matching[1]);
}

std::array<double, 2> joint_position(const std::string& option, const std::string& value) {
  std::array<double, 2> result{};
  const std::size_t comma = value.find(',');
  result[0] = finite_number("--joint " + option, value.substr(0, comma));
  if (comma != std::string::npos) {
    result[1] = finite_number("--joint " + option, value.substr(comma + 1));
  }
  return result;
}

/// The robots among what a folder holds beside models.
std::vector<std::string> robot_templates(const Environment& environment,
                                         const std::vector<read::LeftOut>& found) {
  std::vector<std::string> templates;
  for (const read::LeftOut& left : found) {
    const bool is_model = read::is_template(left.path) && !rules::is_srdf_template(left.path);
    if (!left.excluded && is_model) templates.push_back(left.path);
  }
  if (templates.empty()) return {};
  Sources sources;
  read::Workspace workspace(environment.resolver, sources);
  std::vector<std::string> robots =
      rules::entry_points(templates, {}, workspace,
                          environment.resolver.paths().templates.working_folder)
          .robots;
  std::erase_if(robots, [&workspace](const std::string& path) {
    const read::File& file = workspace.open(path);
    return !file.expanded || !file.expanded->ok();
  });
  return robots;
}

}  // namespace

std::vector<std::string> model_paths(const Environment& environment,
                                     const std::vector<std::string>& named) {
  const Disk& disk = environment.disk;
  std::vector<std::string> all;
  for (const std::string& path : named) {
    const bool folder = disk.kind(path) == PathKind::kFolder;
    if (!folder || disk.kind(join_path(path, "model.config")) == PathKind::kFile) {
      all.push_back(path);
      continue;
    }
    const read::Discovered found = discovered_in(disk, path);
    all.insert(all.end(), found.files.begin(), found.files.end());
    for (std::string& robot : robot_templates(environment, found.left_out))
      all.push_back(std::move(robot));
  }
  return all;
}

std::string model_path(read::Workspace& workspace, const std::string& named) {
  const Disk& disk = workspace.disk();
  std::string path = named;
  if (disk.kind(path) == PathKind::kFolder) path = model_file_in(disk, path);
  if (disk.kind(path) == PathKind::kFile && file_name(path) == "model.config") {
    const read::File& config = workspace.open(path);
    if (config.document) path = model_named_by(path, read::read_model_config(*config.document));
  }
  return path;
}

namespace {

const read::File& required_model(const read::File& file, read::Workspace& workspace) {
  if (!file.document) throw UsageError(file.path + ": " + file.problem);
  if (file.expanded && !file.expanded->ok()) refuse(file, workspace.sources());
  return file;
}

}  // namespace

const read::File& open_model(read::Workspace& workspace, const std::string& named) {
  return required_model(workspace.open(model_path(workspace, named)), workspace);
}

const read::File& open_model(read::Workspace& workspace, const std::string& named, std::size_t set,
                             const read::TemplateArguments& arguments) {
  const std::string path = model_path(workspace, named);
  const bool is_template = read::is_template(path);
  return required_model(is_template ? workspace.open(path, set, arguments) : workspace.open(path),
                        workspace);
}

const read::File& open_plain_model(read::Workspace& workspace, const std::string& named) {
  if (read::is_template(named)) {
    throw UsageError(named + " is a template: expand it, and edit the result");
  }
  return open_model(workspace, named);
}

void require_model(const std::string& name, const std::vector<const model::Root*>& roots) {
  if (name.empty()) return;
  std::vector<std::string> names;
  for (const model::Root* root : roots) {
    for (std::uint32_t i = 0; i < root->models.size(); ++i) {
      names.push_back(scoped_name(*root, model::Id<model::Model>{i}));
    }
  }
  choice("--model", name, std::vector<std::string_view>(names.begin(), names.end()));
}

std::size_t lost_includes(const read::Loaded& loaded) {
  const auto lost = [](const read::Fact& fact) {
    return fact.kind == read::FactKind::kIncludeNotFound ||
           fact.kind == read::FactKind::kIncludeUnreadable ||
           fact.kind == read::FactKind::kIncludeCycle;
  };
  return static_cast<std::size_t>(std::count_if(loaded.facts.begin(), loaded.facts.end(), lost));
}

std::string unread_part(const read::Loaded& loaded) {
  const model::Field<std::string>& cut = loaded.root.cut;
  return cut.written ? "is not read to its end: " + cut.value : std::string();
}

void tell_unfollowed(const read::Loaded& loaded) {
  const auto unfollowed = [](const read::Fact& fact) {
    return fact.kind == read::FactKind::kUnfollowedInclude;
  };
  const auto count = std::count_if(loaded.facts.begin(), loaded.facts.end(), unfollowed);
  if (count == 0) return;
  say("rigor: " + report::counted(static_cast<std::size_t>(count), "include") +
      " skipped, since nothing is downloaded: this is the model without");
}

model::JointPositions joint_positions(const model::Root& root,
                                      const std::vector<std::string>& assignments) {
  model::JointPositions positions;
  for (const std::string& text : assignments) {
    const auto [name, value] = split_assignment("--joint", text);
    positions[joint_named(root, name)] = joint_position(text, value);
  }
  return positions;
}

}  // namespace rigor::tool
