// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "project/reach.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <system_error>
#include <utility>

#include <rigor/mesh/read.h>
#include <rigor/read/package_index.h>
#include <rigor/text/disk.h>
#include <rigor/text/path.h>

namespace rigor::tool {
namespace {

namespace fs = std::filesystem;

/// The nearest folder with a manifest, at or above one; empty when there is none.
std::string package_of(const std::string& real_folder) {
  std::string folder = real_folder;
  for (int i = 0; i < read::kMaxAncestors; ++i) {
    for (const char* manifest : {"package.xml", "model.config"}) {
      std::error_code ignored;
      if (fs::is_regular_file(join_path(folder, manifest), ignored)) return folder;
    }
    std::string above(parent_path(folder));
    if (above == folder) break;
    folder = std::move(above);
  }
  return {};
}

bool in_repository_data(std::string_view real) {
  return real.find("/.git/") != std::string_view::npos || real.ends_with("/.git");
}

/// Whether a folder below the tree, or the file itself, is hidden.
bool is_hidden_in(std::string_view real, std::string_view tree) {
  return real.substr(std::min(tree.size(), real.size())).find("/.") != std::string_view::npos;
}

/// What holds a robot and nothing else, going by its name.
bool has_name_of_model(std::string_view real) {
  constexpr std::string_view kModels[] = {".sdf", ".srdf", ".urdf", ".world", ".xacro"};
  return std::find(std::begin(kModels), std::end(kModels), extension(real)) != std::end(kModels);
}

/// What takes the place of a message.
std::string place_only(const Sources& sources, Span where) {
  const Position position = sources.position(where.source, where.begin);
  return std::string(sources.path(where.source)) + ':' + std::to_string(position.line);
}

/// Whether it tells no more than how a mesh is shaped, as of `../meshes/arm.stl` beside a folder `urdf` that is in no
/// package. A link to something else is no mesh.
bool measures_mesh(const Diagnostic& diagnostic) {
  return diagnostic.measured && mesh::has_mesh_ending(real_path_of(diagnostic.of_file));
}

class Withholding {
 public:
  Withholding(const Sources& sources, const Reach& reach) : sources_(sources), reach_(reach) {}

  Diagnostic of(Diagnostic diagnostic) {
    const bool own = is_out(diagnostic.where);
    const bool of_other = !own && !diagnostic.of_file.empty() && !measures_mesh(diagnostic) &&
                          !reach_.holds(diagnostic.of_file);
    if (own || of_other) {
      diagnostic.message = (own ? place_only(sources_, diagnostic.where) : diagnostic.of_file) +
                           " lies outside of what was named, and is not quoted";
      if (own) {
        diagnostic.path = sources_.path(diagnostic.where.source);
        diagnostic.where = {};
      }
      diagnostic.subject.clear();
      diagnostic.cause.clear();
      diagnostic.fixes.clear();
    }
    for (const Label& label : diagnostic.related) {
      if (!is_out(label.where)) continue;
      diagnostic.message += " (see " + place_only(sources_, label.where) + ')';
    }
    std::erase_if(diagnostic.related, [this](const Label& label) { return is_out(label.where); });
    for (MacroCall& call : diagnostic.origin) {
      if (own || is_out(call.where)) call.params.clear();
    }
    const auto spans_out = [this](const MacroCall& call) { return is_out(call.where); };
    std::erase_if(diagnostic.origin, spans_out);
    for (Diagnostic& other : diagnostic.others) other = of(std::move(other));
    return diagnostic;
  }

 private:
  bool is_out(Span where) {
    if (where.nowhere()) return false;
    const auto [known, is_new] = out_.try_emplace(where.source, false);
    if (is_new) known->second = !reach_.holds(std::string(sources_.path(where.source)));
    return known->second;
  }

  const Sources& sources_;
  const Reach& reach_;
  std::map<SourceId, bool> out_;
};

}  // namespace

std::string real_path_of(const std::string& path) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? normalize_path(path) : real.generic_string();
}

bool lies_below(std::string_view path, std::string_view folder) {
  if (folder == "/") return true;
  return path.starts_with(folder) && (path.size() == folder.size() || path[folder.size()] == '/');
}

Reach::Reach(const std::vector<std::string>& named, const read::SearchPaths& paths)
    : everything_(false) {
  for (const std::string& path : named) {
    if (path.empty()) continue;  // an option that was not given
    std::error_code ignored;
    const bool is_folder = fs::is_directory(path, ignored);
    if (!is_folder) named_.push_back(normalize_path(path));
    std::string folder = real_path_of(is_folder ? path : std::string(parent_path(path)));
    std::string package = package_of(folder);
    if (!package.empty()) {
      neighbors_.emplace_back(parent_path(package));
      folders_.push_back(std::move(package));
    }
    add_trees(folder);
    folders_.push_back(std::move(folder));
  }
  const auto add = [this](const std::string& folder) {
    if (!folder.empty()) folders_.push_back(real_path_of(folder));
  };
  for (const read::SearchPath& path : paths.given) add(path.folder);
  for (const read::SearchPath& path : paths.environment) add(path.folder);
  for (const auto& [name, folder] : paths.packages) add(folder);
  add(paths.fuel_cache);
}

bool Reach::holds(const std::string& path) const {
  if (everything_) return true;
  const std::string written = normalize_path(path);
  if (std::find(named_.begin(), named_.end(), written) != named_.end()) return true;
  const std::string real = real_path_of(path);
  if (in_repository_data(real)) return false;
  const auto holds_it = [&real](const std::string& folder) { return lies_below(real, folder); };
  if (std::any_of(folders_.begin(), folders_.end(), holds_it)) return true;
  if (std::any_of(trees_.begin(), trees_.end(),
                  [&](const Tree& tree) { return holds_in(tree, real); }))
    return true;
  if (std::none_of(neighbors_.begin(), neighbors_.end(), holds_it)) return false;
  const std::string package = package_of(std::string(parent_path(real)));
  return !package.empty() &&
         std::find(neighbors_.begin(), neighbors_.end(), parent_path(package)) != neighbors_.end();
}

void Reach::add_trees(const std::string& real_folder) {
  for (std::string& tree : read::trees_around(RealDisk(), real_folder)) {
    const auto is_it = [&tree](const Tree& known) { return known.folder == tree; };
    if (std::any_of(trees_.begin(), trees_.end(), is_it)) continue;
    std::error_code ignored;
    const bool is_repository = fs::exists(join_path(tree, ".git"), ignored);
    trees_.push_back({std::move(tree), is_repository});
  }
}

bool Reach::holds_in(const Tree& tree, const std::string& real) const {
  if (!lies_below(real, tree.folder) || is_hidden_in(real, tree.folder)) return false;
  if (tree.is_repository && has_name_of_model(real)) return true;
  const std::string package = package_of(std::string(parent_path(real)));
  return !package.empty() && lies_below(package, tree.folder);
}

Diagnostics withheld(const Diagnostics& found, const Sources& sources, const Reach& reach) {
  Withholding withholding(sources, reach);
  Diagnostics told;
  for (const Diagnostic& diagnostic : found.list()) told.add(withholding.of(diagnostic));
  return told;
}

}  // namespace rigor::tool
