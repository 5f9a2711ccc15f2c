// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "project/show_config.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/report/json/settings.h>
#include <rigor/report/terminal/printable.h>

#include "command/command.h"

namespace rigor::tool {
namespace {

/// A line of what is shown.
struct ShownSetting {
  std::string key;  ///< "severity.axis-zero"
  std::string value;
  std::string option = {};
  config::Place place = {};
};

class ShownSettings {
 public:
  void add(const std::string& key, const Said& said) {
    settings_.push_back({key, said.value, said.option, said.place});
  }

  void add(const std::string& key, const std::vector<Said>& list, const std::string& otherwise) {
    for (const Said& said : list) add(key, said);
    if (list.empty()) settings_.push_back({key, otherwise});
  }

  void add(const std::string& key, const config::Name& name, const std::string& value) {
    settings_.push_back({key, value, {}, name.place});
  }

  const std::vector<ShownSetting>& list() const { return settings_; }

 private:
  std::vector<ShownSetting> settings_;
};

ShownSettings settings_shown(const SaidOfFile& said, const config::Config& config,
                             const ConfigOptions& options) {
  ShownSettings shown;
  shown.add("select", said.select, "all rules");
  shown.add("ignore", said.ignore, "no rule");
  for (const auto& [rule, level] : said.severity) shown.add("severity." + rule, level);
  shown.add("fail-on", said.fail_on);
  shown.add("target", said.targets, "none");
  for (const config::PathPatterns& list : config.exclude) {
    for (const config::Name& name : list.written()) shown.add("exclude", name, name.value);
  }
  if (config.baseline) {
    shown.add("baseline", *config.baseline, options.shown(config.baseline->value));
  }
  for (const config::Name& folder : config.resolve_paths) {
    shown.add("resolve.paths", folder, options.shown(folder.value));
  }
  for (const auto& [package, folder] : config.resolve_packages) {
    shown.add("resolve.packages." + package, folder, options.shown(folder.value));
  }
  if (const auto& indent = config.layout.indent) {
    shown.add("format.indent", *indent,
              indent->value == "\t" ? "tab" : std::to_string(indent->value.size()));
  }
  if (const auto& width = config.layout.width) {
    shown.add("format.width", {{}, width->place}, std::to_string(width->value));
  }
  if (const auto& quotes = config.layout.quotes) shown.add("format.quotes", *quotes, quotes->value);
  for (const auto& [name, density] : config.materials) {
    shown.add("materials." + name, {{}, density.place}, fmt::format("{} kg/m³", density.value));
  }
  return shown;
}

std::string said_by(const ShownSetting& setting, const ConfigOptions& options) {
  if (!setting.option.empty()) return setting.option;
  if (setting.place.path.empty()) return "default";
  return options.shown(setting.place);
}

std::string files_shown(const config::Config& config, const ConfigOptions& options) {
  if (config.files.empty()) return "no configuration";
  std::string text;
  for (const std::string& file : config.files) {
    text += (text.empty() ? "" : ", which extends ") + options.shown(file);
  }
  return text;
}

std::string config_text(const std::string& file, const config::Config& config,
                        const ShownSettings& shown, const ConfigOptions& options) {
  std::size_t key_width = 0;
  std::size_t value_width = 0;
  for (const ShownSetting& each : shown.list()) {
    key_width = std::max(key_width, each.key.size());
    value_width = std::max(value_width, each.value.size());
  }
  std::string text =
      report::printable(file) + ": " + report::printable(files_shown(config, options)) + '\n';
  std::string before;
  for (const ShownSetting& each : shown.list()) {
    text += fmt::format("  {:<{}}  {:<{}}  ({})\n",
                        each.key == before ? "" : report::printable(each.key), key_width,
                        report::printable(each.value), value_width,
                        report::printable(said_by(each, options)));
    before = each.key;
  }
  return text;
}

std::string config_json(const std::string& file, const config::Config& config,
                        const ShownSettings& shown, const ConfigOptions& options) {
  std::vector<std::string> files;
  for (const std::string& each : config.files) files.push_back(options.shown(each));
  std::vector<report::SettingLine> settings;
  for (const ShownSetting& each : shown.list()) {
    const std::string& path = each.place.path;
    settings.push_back({each.key, each.value, each.option,
                        path.empty() ? std::string() : options.shown(path), each.place.line});
  }
  return report::settings_json(file, files, settings);
}

}  // namespace

void ShowConfigOption::declare(CLI::App& app) {
  app.add_option("--show-config", file_,
                 "Show the settings for this file and where each comes from, and stop")
      ->type_name("FILE");
}

int ShowConfigOption::run(const RuleSettings& settings, const ConfigOptions& config,
                          const OutputOptions& output) const {
  const std::vector<Target> targets = output.targets_of({"text", "json"});
  const SaidOfFile said = settings.said(file_);
  const config::Config& found = config.of(file_);
  const ShownSettings shown = settings_shown(said, found, config);
  for (const Target& target : targets) {
    write(target, target.format == 0 ? config_text(file_, found, shown, config)
                                     : config_json(file_, found, shown, config));
  }
  return kClean;
}

}  // namespace rigor::tool
