// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/workspace_files.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <utility>

#include <rigor/author/names/parameter_names.h>
#include <rigor/author/names/text_mentions.h>
#include <rigor/read/repository_ignores.h>
#include <rigor/read/template/template_expander.h>
#include <rigor/text/path.h>

namespace rigor::author {
namespace {

/// More than the largest repositories of robots have (the largest of the corpus: 12,000).
constexpr std::size_t kMaxWorkspaceEntries = 200'000;
constexpr int kMaxFolderDepth = 64;
/// Folders above a file that are asked for `.git`.
constexpr int kMaxFoldersAbove = 32;
/// Expanded although they do not hold the name: some 10 ms each.
constexpr std::size_t kMaxExpandedTemplates = 300;
/// What is larger is data.
constexpr std::uint64_t kMaxNamingBytes = std::uint64_t{16} << 20U;

bool is_word_byte(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// "base" of "base-link"; all of a name without letters.
std::string first_word(const std::string& name) {
  const auto begin = std::find_if(name.begin(), name.end(), is_word_byte);
  return {begin, std::find_if_not(begin, name.end(), is_word_byte)};
}

bool holds_word(std::string_view bytes, const std::unordered_set<std::string>& words) {
  std::string word;
  for (std::size_t at = 0; at < bytes.size();) {
    if (!is_word_byte(bytes[at])) {
      ++at;
      continue;
    }
    const std::size_t begin = at;
    while (at < bytes.size() && is_word_byte(bytes[at])) ++at;
    word.assign(bytes.substr(begin, at - begin));
    if (words.contains(word)) return true;
  }
  return false;
}

void sort_once(std::vector<std::string>& paths) {
  std::sort(paths.begin(), paths.end());
  paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
}

/// "robot.urdf" for "../urdf/robot.urdf" in a folder `urdf`.
std::string as_seen_from(const std::string& folder, const std::string& path) {
  return is_absolute(path) ? path : relative_path(folder, join_path(folder, path));
}

bool is_named_model(const std::string& path) {
  const std::string ending = extension(path);
  return ending == ".sdf" || ending == ".world" || ending == ".urdf" || ending == ".srdf" ||
         read::is_template(path) || file_name(path) == "model.config";
}

/// Links to folders are not followed: `Disk::list` leaves them out.
class WorkspaceWalk {
 public:
  WorkspaceWalk(const Disk& disk, const std::vector<std::string>& folders,
                const std::string& working_folder)
      : disk_(disk),
        folders_(folders),
        working_folder_(working_folder),
        ignores_(disk, absolute_folders()) {}

  WorkspaceFiles walk() {
    for (const std::string& folder : folders_) walk(folder, 0);
    return std::move(files_);
  }

 private:
  std::string absolute(const std::string& path) const { return join_path(working_folder_, path); }

  std::vector<std::string> absolute_folders() const {
    std::vector<std::string> all;
    for (const std::string& folder : folders_) all.push_back(absolute(folder));
    return all;
  }

  void walk(const std::string& folder, int depth) {
    if (depth > kMaxFolderDepth) return;
    const std::vector<std::string> names = disk_.list(folder);
    if (std::find(names.begin(), names.end(), "COLCON_IGNORE") != names.end()) return;
    for (const std::string& name : names) {
      if (name.starts_with('.')) continue;
      if (++entries_ > kMaxWorkspaceEntries) {
        files_.is_complete = false;
        return;
      }
      const std::string path = folder == "." ? name : join_path(folder, name);
      const bool is_model = is_named_model(name);
      const bool is_text = !is_model && (parameter_format(name) || is_mentioning_text(name));
      const PathKind kind = disk_.kind(path);
      const bool is_file = kind == PathKind::kFile && (is_model || is_text);
      if (!is_file && kind != PathKind::kFolder) continue;
      if (ignores_.left_out(absolute(path), kind)) continue;
      if (is_file) {
        (is_model ? files_.models : files_.texts).push_back(path);
      } else {
        walk(path, depth + 1);
      }
    }
  }

  const Disk& disk_;
  const std::vector<std::string>& folders_;
  const std::string& working_folder_;
  read::RepositoryIgnores ignores_;
  WorkspaceFiles files_;
  std::size_t entries_ = 0;
};

}  // namespace

std::string workspace_folder(const Disk& disk, const std::string& file) {
  const std::string own(parent_path(file));
  std::string package;
  std::string folder = own;
  for (int i = 0; i < kMaxFoldersAbove && disk.kind(folder) == PathKind::kFolder; ++i) {
    const auto has = [&](const char* name) {
      return disk.kind(join_path(folder, name)) != PathKind::kMissing;
    };
    if (has(".git")) return folder;
    if (package.empty() && (has("package.xml") || has("rigor.toml"))) package = folder;
    const std::string above = enclosing_folder(folder);
    if (above == folder) break;
    folder = above;
  }
  return package.empty() ? own : package;
}

WorkspaceFiles workspace_files(const Disk& disk, const std::vector<std::string>& folders,
                               const std::string& working_folder) {
  WorkspaceFiles files = WorkspaceWalk(disk, folders, working_folder).walk();
  for (auto* list : {&files.models, &files.texts}) {
    if (!working_folder.empty()) {
      for (std::string& path : *list) path = as_seen_from(working_folder, path);
    }
    sort_once(*list);
  }
  return files;
}

std::vector<std::string> WorkspaceFiles::that_may_hold(const std::set<std::string>& names,
                                                       const Disk& disk) const {
  std::unordered_set<std::string> words;
  for (const std::string& name : names) words.insert(first_word(name));
  std::size_t templates = 0;
  std::vector<std::string> some;
  for (const auto* list : {&models, &texts}) {
    for (const std::string& path : *list) {
      const bool is_expanded = read::is_template(path) && ++templates <= kMaxExpandedTemplates;
      const ReadResult read = disk.read(path, kMaxNamingBytes);
      if (read.bytes && (is_expanded || holds_word(*read.bytes, words))) some.push_back(path);
    }
  }
  return some;
}

ReferringFiles::ReferringFiles(std::vector<std::string> the_named,
                               std::vector<std::string> the_found)
    : named(std::move(the_named)), found(std::move(the_found)) {
  std::set<std::string> known;
  for (const std::string& path : named) known.insert(normalize_path(path));
  std::erase_if(found,
                [&](const std::string& path) { return known.contains(normalize_path(path)); });
}

std::vector<std::string> ReferringFiles::all() const {
  std::vector<std::string> files = named;
  files.insert(files.end(), found.begin(), found.end());
  return files;
}

}  // namespace rigor::author
