// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "project/config_file.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <tuple>
#include <utility>

#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "output/output.h"
#include "project/project.h"

namespace rigor::tool {
namespace {

/// Problems that are reported one by one; more would not be read before the first are mended.
constexpr std::size_t kMaxProblemsReported = 50;

read::ConfiguredPaths configured_paths(const config::Config& config) {
  read::ConfiguredPaths paths;
  for (const config::Name& folder : config.resolve_paths) paths.folders.push_back(folder.value);
  for (const auto& [name, folder] : config.resolve_packages) {
    paths.packages.emplace(name, folder.value);
  }
  return paths;
}

}  // namespace

void ConfigOptions::declare(CLI::App& app) {
  app.add_option("--config", file_, "Use this configuration instead of the nearest rigor.toml")
      ->type_name("FILE");
  app.add_flag("--isolated", isolated_, "Use no configuration at all");
  app.add_option("--confine", confine_, "Read nothing outside of this folder, wherever models lead")
      ->type_name("DIR")
      ->allow_extra_args(false);
}

ConfigOptions::Opened& ConfigOptions::opened() const {
  if (opened_) return *opened_;
  using config::ConfigChoice;
  ConfigChoice choice;
  if (isolated_ && !file_.empty()) {
    throw UsageError("--config and --isolated exclude each other");
  }
  if (isolated_) choice.of = ConfigChoice::Of::kNone;
  if (!file_.empty()) choice = {ConfigChoice::Of::kFile, file_};
  std::error_code error;
  const std::filesystem::path working = std::filesystem::current_path(error);
  opened_ = std::make_unique<Opened>(disk(), error ? "/" : working.string(), choice);
  return *opened_;
}

void ConfigOptions::open() const {
  configs();
  if (!file_.empty()) of(".");
}

void ConfigOptions::reopen(const Disk& disk) const {
  opened_.reset();
  disk_ = &disk;
  open();
}

const config::Config& ConfigOptions::of(const std::string& path) const {
  return sound(configs().of(path));
}

const config::Config& ConfigOptions::sound(const config::Config& config) const {
  refuse(config.problems);
  return config;
}

std::map<std::string, double> ConfigOptions::materials(const std::string& path) const {
  std::map<std::string, double> densities;
  for (const auto& [name, density] : of(path).materials) densities.emplace(name, density.value);
  return densities;
}

const read::ConfiguredPaths* ConfigOptions::resolve_paths(std::string_view file) const {
  const config::Config& config = sound(configs().beside(file));
  if (config.resolve_paths.empty() && config.resolve_packages.empty()) return nullptr;
  return &opened().resolve_paths.find(&config, [&config] { return configured_paths(config); });
}

std::string ConfigOptions::why_excluded(const std::string& path, PathKind kind) const {
  const config::Name* pattern =
      excluding(sound(configs().beside(path)), configs().absolute(path), kind);
  if (pattern == nullptr) return {};
  return "exclude \"" + pattern->value + "\" in " + shown(pattern->place);
}

std::optional<std::string> ConfigOptions::baseline(const std::vector<std::string>& paths) const {
  std::optional<config::Name> found;
  for (const std::string& path : paths) {
    const std::optional<config::Name>& named = of(path).baseline;
    if (!named || (found && found->value == named->value)) continue;
    if (found) {
      throw UsageError(shown(found->place) + " and " + shown(named->place) +
                       " name different baselines: say which one with --baseline");
    }
    found = named;
  }
  if (!found) return std::nullopt;
  return shown(found->value);
}

const Disk& ConfigOptions::disk() const {
  if (disk_ == nullptr) {
    own_disk_ = std::make_unique<const GuardedDisk>(Reach(), confinement());
    disk_ = own_disk_.get();
  }
  return *disk_;
}

std::vector<std::string> ConfigOptions::confinement() const {
  std::vector<std::string> folders;
  for (const std::string& folder : confine_) {
    if (RealDisk().kind(folder) != PathKind::kFolder) {
      throw UsageError("--confine " + folder + ": no such folder");
    }
    folders.push_back(real_path_of(folder));
  }
  return folders;
}

std::string ConfigOptions::shown(const std::string& path) const {
  const std::string here = configs().absolute(".");
  const bool near = lies_below(path, here) || lies_below(here, parent_path(path));
  return near && path != here ? relative_path(here, path) : path;
}

std::string ConfigOptions::shown(const config::Place& place) const {
  return shown(place.path) + (place.line > 0 ? ':' + std::to_string(place.line) : "");
}

/// What a configuration extends may be any file of the machine, and a log is read by others.
bool ConfigOptions::quotable(const std::string& path) const {
  const std::string real = real_path_of(path);
  if (file_name(real) == config::kConfigName) return true;
  if (!file_.empty() && real == real_path_of(file_)) return true;
  return real.find("/.git/") == std::string::npos && lies_below(real, project_folders().root);
}

std::string ConfigOptions::told(const config::Problem& problem) const {
  const std::vector<std::string_view> known(problem.known.begin(), problem.known.end());
  const std::string place = shown(config::Place{problem.path, problem.line});
  if (!quotable(problem.path)) {
    return place + ": is no configuration; it lies outside of the project, and is not quoted";
  }
  return place + ": " + problem.message + did_you_mean(problem.name, known);
}

void ConfigOptions::refuse(std::vector<config::Problem> problems) const {
  if (problems.empty()) return;
  std::stable_sort(problems.begin(), problems.end(), [](const auto& a, const auto& b) {
    return std::tie(a.path, a.line) < std::tie(b.path, b.line);
  });
  if (problems.size() == 1) throw UsageError(told(problems.front()));
  const std::size_t count = std::min(problems.size(), kMaxProblemsReported);
  for (std::size_t i = 0; i < count; ++i) say("rigor: " + report::printable(told(problems[i])));
  throw UsageError(report::counted(problems.size(), "problem") + " in the configuration");
}

}  // namespace rigor::tool
