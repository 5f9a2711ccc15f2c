// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "option/search.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>

#include <rigor/mesh/importer/scene.h>
#include <rigor/text/disk.h>
#include "command/command.h"
#include "option/numbers.h"

namespace rigor::tool {
namespace {

/// GiB. More than any machine that this runs on; as bytes it fits well.
constexpr double kMaxMeshMemory = 1024;

void add_argument(const std::string& text, read::TemplateArguments& arguments) {
  const std::size_t assign = text.find(":=");
  // As ROS has them: what is left empty is not given.
  if (assign + 2 == text.size()) return;
  arguments.emplace_back(text.substr(0, assign), text.substr(assign + 2));
}

/// Several files are all given the same arguments.
void require_one_value_each(const std::vector<std::string>& arguments) {
  std::map<std::string, std::string> given;
  for (const std::string& text : arguments) {
    const std::string name = text.substr(0, text.find(":="));
    const auto [known, is_new] = given.emplace(name, text);
    if (is_new || known->second == text) continue;
    throw UsageError(
        known->second + " and " + text +
        ": all files are given the same arguments; check them in two runs, or give sets "
        "in [[xacro]] of rigor.toml");
  }
}

void require_folder(const std::string& option, const std::string& folder) {
  if (RealDisk().kind(folder) == PathKind::kFolder) return;
  throw UsageError(option + " " + folder + ": no such folder");
}

}  // namespace

std::string path_variable(const std::string& name) {
  const char* value = std::getenv(name.c_str());
  return value == nullptr ? "" : value;
}

void SearchOptions::declare(CLI::App& app) {
  app_ = &app;
  app.add_option("--model-path", model_paths_, "Search model:// and relative URIs here first")
      ->type_name("DIR")
      ->allow_extra_args(false);
  app.add_option("--package", packages_, "Folder of package://NAME")
      ->type_name("NAME=DIR")
      ->allow_extra_args(false);
  argument_option_ =
      app.add_option(kTemplateArgumentOption, template_arguments_, "An argument of templates")
          ->type_name("name:=value")
          ->allow_extra_args(false)
          ->group("");
  app.add_option("--mesh-memory", mesh_memory_,
                 "Memory that the import of one mesh file may take (default 1)")
      ->type_name("GIB");
  config_.declare(app);
}

read::SearchPaths SearchOptions::paths(const std::vector<std::string>& named) const {
  read::SearchPaths paths = read::search_paths_from(path_variable);
  for (const std::string& path : named) {
    if (RealDisk().kind(path) == PathKind::kFolder) paths.named.push_back(path);
  }
  for (const std::string& folder : model_paths_) {
    require_folder("--model-path", folder);
    paths.given.push_back({folder, "--model-path"});
  }
  for (const std::string& package : packages_) {
    auto [name, folder] = split_assignment("--package", package);
    require_folder("--package", folder);
    paths.packages[std::move(name)] = std::move(folder);
  }
  if (named.size() > 1) require_one_value_each(template_arguments_);
  for (const std::string& text : template_arguments_) add_argument(text, paths.templates.arguments);
  paths.templates.variable = [](std::string_view name) -> std::optional<std::string> {
    const char* value = std::getenv(std::string(name).c_str());
    return value == nullptr ? std::nullopt : std::optional<std::string>(value);
  };
  std::error_code error;
  paths.templates.working_folder = std::filesystem::current_path(error).string();
  config_.open();
  paths.configured = [this](std::string_view file) { return config_.resolve_paths(file); };
  return paths;
}

read::TemplateArguments SearchOptions::arguments_of(
    const CLI::Option& file, const std::vector<const CLI::Option*>& files) const {
  read::TemplateArguments arguments;
  const CLI::Option* behind = nullptr;
  std::size_t next = 0;
  for (const CLI::Option* option : app_->parse_order()) {
    if (std::find(files.begin(), files.end(), option) != files.end()) behind = option;
    if (option != argument_option_) continue;
    const std::string& text = template_arguments_.at(next++);
    if (behind == nullptr || behind == &file) add_argument(text, arguments);
  }
  return arguments;
}

void SearchOptions::allow(process::Workers& workers) const {
  if (mesh_memory_.empty()) return;
  const double gib = positive_number("--mesh-memory", mesh_memory_, "GiB");
  if (gib > kMaxMeshMemory) {
    throw UsageError("--mesh-memory " + mesh_memory_ + ": no more than 1024 GiB");
  }
  mesh::allow_imports(workers, static_cast<std::uint64_t>(gib * 1024 * 1024 * 1024));
}

GuardedDisk SearchOptions::disk(const std::vector<std::string>& named) const {
  for (const std::string& path : named) {
    if (!path.empty()) config_.of(path);
  }
  return unchecked_disk(named);
}

GuardedDisk SearchOptions::unchecked_disk(const std::vector<std::string>& named) const {
  return GuardedDisk(Reach(named, paths()), config_.confinement());
}

std::pair<std::string, std::string> split_assignment(const std::string& option,
                                                     const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError(option + " takes NAME=VALUE, not \"" + text + '"');
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace rigor::tool
