// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/reference/srdf_facts.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include <rigor/model/model.h>
#include <rigor/read/load.h>
#include <rigor/read/srdf/robot_name.h>
#include <rigor/read/template/expanded_file.h>
#include <rigor/rules/context.h>
#include <rigor/schema/embedded.h>
#include <rigor/text/path.h>

namespace rigor::rules {
namespace {

using robot::SrdfFact;
using robot::SrdfFactKind;

/// A MoveIt configuration is a folder beside the robot's description, in one repository.
constexpr int kFoldersUp = 3;
/// Files and folders that are looked at for a robot: repositories of descriptions have a thousand.
constexpr std::size_t kMaxEntries = 3000;
/// Robots of one name: variants, of which the SRDF is about any.
constexpr std::size_t kMaxNamesakes = 8;

std::vector<std::string> robots_below(const Disk& disk, const std::string& top,
                                      std::string_view name) {
  std::vector<std::string> found, folders{top};
  std::size_t entries = 0;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    for (const std::string& each : disk.list(folders[i])) {
      if (each.starts_with('.')) continue;
      if (++entries > kMaxEntries || found.size() >= kMaxNamesakes) return found;
      std::string path = join_path(folders[i], each);
      const std::string ending = extension(each);
      const PathKind kind = disk.kind(path);
      if (kind == PathKind::kFolder) folders.push_back(std::move(path));
      if (kind != PathKind::kFile || (ending != ".urdf" && ending != ".xacro")) continue;
      const ReadResult file = disk.read(path, read::kMaxModelBytes);
      if (file.bytes && read::robot_name_in(*file.bytes) == name) found.push_back(std::move(path));
    }
  }
  return found;
}

/// The file that is checked, when it is an SRDF with a name.
std::optional<read::Srdf> srdf_of(Context& context) {
  const std::string_view path = context.sources().path(context.root().source);
  if (!path.ends_with(".srdf")) return std::nullopt;
  const auto root = context.document().root();
  if (!root || root->name() != "robot" || !root->attribute("name")) return std::nullopt;
  return read::read_srdf(*root);
}

/// `key: value` behind a line that begins a section, in YAML as MoveIt's setup assistant writes it.
std::string setting(std::string_view yaml, std::string_view key) {
  std::size_t at = yaml.find("URDF:");
  if (at == yaml.npos || (at = yaml.find(key, at)) == yaml.npos) return {};
  at = std::min(yaml.find_first_not_of(" \"'", at + key.size()), yaml.size());
  return std::string(yaml.substr(at, yaml.find_first_of(" \"'\r\n", at) - at));
}

/// The robot that MoveIt's setup assistant was given: a path in a package, wherever that one is.
std::vector<std::string> robot_of_setup_assistant(const read::Resolver& resolver,
                                                  const std::string& srdf_path) {
  constexpr std::uint64_t kMaxSettings = std::uint64_t{64} << 10U;
  const std::string folder(parent_path(srdf_path));
  for (const std::string& around : {folder, normalize_path(join_path(folder, ".."))}) {
    const ReadResult file =
        resolver.disk().read(join_path(around, ".setup_assistant"), kMaxSettings);
    if (!file.bytes) continue;
    const std::string package = setting(*file.bytes, "package:");
    const std::string path = setting(*file.bytes, "relative_path:");
    if (package.empty() || path.empty()) continue;
    const auto found = resolver.resolve("package://" + package + '/' + path, srdf_path).path;
    if (found) return {*found};
  }
  return {};
}

std::vector<robot::SemanticTarget> targets_of(Context& context, const read::Srdf& srdf) {
  std::vector<robot::SemanticTarget> targets;
  const std::string path(context.sources().path(context.root().source));
  const auto schema = schema::Schema::parse(schema::urdf_schema_text());
  Sources sources;
  const read::Resolver& resolver = context.resolver();
  read::Workspace workspace(resolver, sources);
  const read::Reader reader{workspace, resolver, context.sdf_schema(),
                            std::get<schema::Schema>(schema)};
  std::vector<std::string> files = robots_near(context.disk(), path, srdf.robot.text);
  if (files.empty()) files = robot_of_setup_assistant(resolver, path);
  for (const std::string& each : files) {
    const read::File& file = workspace.open(each);
    // Of a robot that is read in part, what is missing may be there.
    if (!file.document || !file.document->complete()) continue;
    if (file.expanded && !file.expanded->is_known()) continue;
    const read::Loaded loaded = read::load(reader, file);
    if (!loaded.root.links.empty()) targets.push_back(robot::semantic_target(loaded.root));
  }
  return targets;
}

std::string_view unit_of(const SrdfFact& fact) { return fact.in_meters ? "m" : "rad"; }

}  // namespace

std::string describe(const SrdfFact& fact, std::string_view robot) {
  switch (fact.kind) {
    case SrdfFactKind::kLinkUndefined:
      return fmt::format("link '{}' does not exist in robot '{}'", fact.name, robot);
    case SrdfFactKind::kJointUndefined:
      return fmt::format("joint '{}' does not exist in robot '{}'", fact.name, robot);
    case SrdfFactKind::kGroupUndefined: return fmt::format("group '{}' is not defined", fact.name);
    case SrdfFactKind::kChainEmpty:
      return fmt::format("chain from '{}' to itself has no joint", fact.name);
    case SrdfFactKind::kChainBroken:
      return fmt::format("chain: no joints lead from '{}' down to '{}'", fact.name, fact.other);
    case SrdfFactKind::kStateOutside:
      return fmt::format("{:.4g} {} is outside the limits {:.4g} to {:.4g} {} of joint '{}'",
                         fact.value, unit_of(fact), fact.lower, fact.upper, unit_of(fact),
                         fact.name);
    case SrdfFactKind::kPairsChecked:
      return fmt::format("links '{}' and '{}', which a joint connects, are checked for collision{}",
                         fact.name, fact.other,
                         fact.count > 1 ? fmt::format(" (and {} more pairs)", fact.count - 1) : "");
  }
  return {};
}

std::vector<std::string> robots_near(const Disk& disk, const std::string& srdf_path,
                                     std::string_view name) {
  std::string folder(parent_path(srdf_path));
  if (folder.empty()) folder = ".";
  for (int up = 0; up <= kFoldersUp; ++up) {
    std::vector<std::string> found = robots_below(disk, folder, name);
    if (!found.empty()) return found;
    if (disk.kind(join_path(folder, ".git")) != PathKind::kMissing) break;
    std::string around = normalize_path(join_path(folder, ".."));
    if (around == folder || around.empty()) break;
    folder = std::move(around);
  }
  return {};
}

void report_srdf(Context& context, std::initializer_list<SrdfFactKind> kinds) {
  const auto srdf = srdf_of(context);
  if (!srdf) return;
  const std::vector<robot::SemanticTarget> targets = targets_of(context, *srdf);
  if (targets.empty()) return;
  std::vector<const robot::SemanticTarget*> robots;
  for (const robot::SemanticTarget& target : targets) robots.push_back(&target);
  for (const SrdfFact& fact : robot::check_srdf(*srdf, robots)) {
    if (std::find(kinds.begin(), kinds.end(), fact.kind) == kinds.end()) continue;
    context.report({.where = fact.where, .message = describe(fact, srdf->robot.text)});
  }
}

std::optional<read::SrdfName> missing_robot(Context& context) {
  const auto srdf = srdf_of(context);
  if (!srdf || !targets_of(context, *srdf).empty()) return std::nullopt;
  return srdf->robot;
}

}  // namespace rigor::rules
