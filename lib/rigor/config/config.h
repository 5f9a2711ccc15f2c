// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor.toml`: what a project says once instead of on every command line. docs/configuration.md tells
// what each key means.
//
//   extend  = "../rigor.toml"
//   ignore  = ["mesh-unit-suspicious"]
//   fail-on = "warning"
//   exclude = ["third_party/"]
//   [severity]
//   axis-zero = "error"
//   [[per-file]]
//   files  = ["worlds/**"]
//   ignore = ["inertia"]
//   [resolve]
//   paths = ["models"]
//   [materials]
//   our-foam = 42          # kg/m³
//   [format]
//   indent = 4
//   [[xacro]]
//   file      = "urdf/arm.urdf.xacro"
//   arguments = [{ side = "left" }, { side = "right", sim = true }]
//
//   Config config = read_config("/home/me/robot/rigor.toml", bytes);
//   RuleChoice choice = rules_for(config, "/home/me/robot/worlds/lab.world");
//
// Every value knows its place. Names of rules and targets are taken as they are: who knows the rules
// checks them. Which file counts for a model, and what it extends, is decided by `Configs`.

#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/config/path_patterns.h>
#include <rigor/config/setting.h>
#include <rigor/text/diagnostic.h>

namespace rigor::config {

/// Something that cannot stand in the file: "rigor.toml:3: …".
struct Problem {
  unsigned line = 0;  ///< 1-based; 0 for the file as a whole
  std::string message;
  std::string name = {};                ///< what nobody knows, where that is the problem
  std::vector<std::string> known = {};  ///< what may have been meant
  std::string path = {};                ///< of the file, where it may be one of several

  bool operator==(const Problem&) const = default;
};

/// Nothing: "off" for a rule, "never" for what fails.
using Level = std::optional<Severity>;

/// Which rules run, and how severe they are.
struct RuleChoice {
  std::optional<std::vector<Name>> select;  ///< all when nothing says it
  std::vector<Name> ignore;
  std::map<std::string, Setting<Level>> severity;  ///< by rule
};

/// What holds for some files only.
struct PerFile {
  PathPatterns files;
  RuleChoice rules;
};

/// The sets of arguments that a template is expanded with.
struct TemplateArguments {
  Name file;  ///< joined to the configuration's folder
  std::vector<std::vector<std::pair<std::string, std::string>>> sets;
};

/// How `rigor fmt` lays files out.
struct Layout {
  std::optional<Name> indent;              ///< what a level adds: one to eight spaces, or a tab
  std::optional<Setting<unsigned>> width;  ///< columns
  std::optional<Name> quotes;              ///< one of `kQuotes`
  std::optional<Name> order;               ///< of children, one of `kOrders`
};
inline constexpr std::array<std::string_view, 3> kQuotes{"double", "single", "keep"};
inline constexpr std::array<std::string_view, 2> kOrders{"keep", "canonical"};

struct Config {
  /// The file, then what it extends, the nearest first; none when nothing is configured.
  std::vector<std::string> files;

  std::optional<Name> extend;         ///< of one file as it is written
  std::optional<Setting<bool>> root;  ///< of one file
  RuleChoice rules;
  std::optional<Setting<Level>> fail_on;
  std::optional<std::vector<Name>> targets;
  std::vector<PathPatterns> exclude;  ///< a list for each file that has one
  std::optional<Name> baseline;       ///< a path, joined to its file's folder
  std::vector<PerFile> per_file;
  std::vector<Name> resolve_paths;                   ///< folders, joined
  std::map<std::string, Name> resolve_packages;      ///< folders, joined, by package
  std::map<std::string, Setting<double>> materials;  ///< kg/m³, by name

  std::vector<TemplateArguments> templates;
  Layout layout;

  std::vector<Problem> problems;
};

/// Configurations are small; a larger file is none.
inline constexpr std::uint64_t kMaxConfigBytes = std::uint64_t{1} << 20U;

/// One file as it is written; `path` is its own.
Config read_config(const std::string& path, std::string_view bytes);

/// `config`, and under it what it extends: `base`. Single values and `select` are the config's where it
/// has them. Everything else adds up; of two that have the same name the config's counts.
Config extended(Config config, Config base);

/// What holds for a file: that of all files, then each `[[per-file]]` that covers it, in their order. A
/// later one adds to those before it as a config does to what it extends.
RuleChoice rules_for(const Config& config, std::string_view path);

/// The pattern of `exclude` that leaves out the file or folder, or a folder that it is in; null when none
/// does.
const Name* excluding(const Config& config, std::string_view path, PathKind kind);

}  // namespace rigor::config
