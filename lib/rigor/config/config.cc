// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/config.h>

#include <cmath>
#include <utility>

#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include <rigor/text/path.h>

namespace rigor::config {
namespace {

void read_materials(const toml::table& table, Config& config) {
  for (const auto& [name, node] : table) {
    const auto density = node.value<double>();
    if (density && *density > 0 && std::isfinite(*density)) {
      config.materials.emplace(name.str(), *density);
    } else {
      config.problems.push_back(
          {node.source().begin.line,
           "the density of '" + std::string(name.str()) + "' must be a number above 0 kg/m³"});
    }
  }
}

}  // namespace

std::optional<std::string> find_config(const Disk& disk, std::string_view path,
                                       std::string_view working_folder) {
  std::string folder = join_path(working_folder, path);
  if (disk.kind(folder) != PathKind::kFolder) folder = parent_path(folder);
  while (true) {
    std::string candidate = join_path(folder, "rigor.toml");
    if (disk.kind(candidate) == PathKind::kFile) return candidate;
    const bool repository = disk.kind(join_path(folder, ".git")) != PathKind::kMissing;
    const std::string parent(parent_path(folder));
    if (repository || parent == folder) return std::nullopt;
    folder = parent;
  }
}

Config read_config(const std::string& path, std::string_view bytes) {
  Config config{path, {}, {}};
  const toml::parse_result result = toml::parse(bytes);
  if (!result) {
    const toml::parse_error& error = result.error();
    config.problems.push_back({error.source().begin.line, std::string(error.description())});
    return config;
  }
  const toml::node* materials = result.table().get("materials");
  if (materials == nullptr) return config;
  if (const toml::table* table = materials->as_table()) {
    read_materials(*table, config);
  } else {
    config.problems.push_back({materials->source().begin.line, "[materials] must be a table"});
  }
  return config;
}

}  // namespace rigor::config
