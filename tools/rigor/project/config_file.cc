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

namespace rigor::tool {
namespace {

/// Problems that are told one by one; nobody reads more before the first are mended.
constexpr std::size_t kMostProblemsTold = 50;

read::ConfiguredPaths configured_paths(const config::Config& config) {
  read::ConfiguredPaths paths;
  for (const config::Name& folder : config.resolve_paths) paths.folders.push_back(folder.value);
  for (const auto& [name, folder] : config.resolve_packages) {
    paths.packages.emplace(name, folder.value);
  }
  return paths;
}

bool lies_in(std::string_view path, std::string_view folder) {
  if (folder == "/") return true;
  return path.starts_with(folder) && (path.size() == folder.size() || path[folder.size()] == '/');
}

}  // namespace

void ConfigOptions::declare(CLI::App& app) {
  app.add_option("--config", file_, "Use this configuration, not the nearest rigor.toml")
      ->type_name("FILE");
  app.add_flag("--isolated", isolated_, "Use no configuration at all");
}

ConfigOptions::Opened& ConfigOptions::opened() const {
  if (opened_) return *opened_;
  using config::ConfigChoice;
  ConfigChoice choice;
  if (isolated_ && !file_.empty()) {
    throw UsageError("--config names a configuration and --isolated wants none: give one of them");
  }
  if (isolated_) choice.of = ConfigChoice::Of::kNone;
  if (!file_.empty()) choice = {ConfigChoice::Of::kFile, file_};
  std::error_code error;
  const std::filesystem::path working = std::filesystem::current_path(error);
  opened_ = std::make_unique<Opened>(*disk_, error ? "/" : working.string(), choice);
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

std::string ConfigOptions::shown(const std::string& path) const {
  const std::string here = configs().absolute(".");
  const bool near = lies_in(path, here) || lies_in(here, parent_path(path));
  return near && path != here ? relative_path(here, path) : path;
}

std::string ConfigOptions::shown(const config::Place& place) const {
  return shown(place.path) + (place.line > 0 ? ':' + std::to_string(place.line) : "");
}

std::string ConfigOptions::told(const config::Problem& problem) const {
  const std::vector<std::string_view> known(problem.known.begin(), problem.known.end());
  return shown(config::Place{problem.path, problem.line}) + ": " + problem.message +
         did_you_mean(problem.name, known);
}

void ConfigOptions::refuse(std::vector<config::Problem> problems) const {
  if (problems.empty()) return;
  std::stable_sort(problems.begin(), problems.end(), [](const auto& a, const auto& b) {
    return std::tie(a.path, a.line) < std::tie(b.path, b.line);
  });
  if (problems.size() == 1) throw UsageError(told(problems.front()));
  const std::size_t count = std::min(problems.size(), kMostProblemsTold);
  for (std::size_t i = 0; i < count; ++i) say("rigor: " + report::printable(told(problems[i])));
  throw UsageError(report::counted(problems.size(), "problem") + " in the configuration");
}

}  // namespace rigor::tool
