// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/discover.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include <rigor/read/repository_ignores.h>
#include <rigor/text/path.h>

namespace rigor::read {
namespace {

/// Folders nest this deep at most, so that the walk is bounded whatever a disk says.
constexpr int kMaxFolderDepth = 64;

/// So many `.xml` files of such a size are looked into for MJCF, where a folder holds nothing else.
constexpr std::size_t kMaxXml = 20;
constexpr std::uint64_t kMaxXmlBytes = 1 << 20;

constexpr std::string_view kTemplate = "template: expand it first";
constexpr std::string_view kColconMarker = "COLCON_IGNORE";

bool is_model(const std::string& path) {
  const std::string ending = extension(path);
  return ending == ".sdf" || ending == ".world" || ending == ".urdf" ||
         file_name(path) == "model.config";
}

/// Why a file that will become a model is not examined; empty for any other file.
std::string_view template_of(const std::string& path) {
  const std::string ending = extension(path);
  if (ending == ".xacro") return "xacro: expand it first";
  if (ending == ".erb") return kTemplate;
  const std::string inner = extension(path.substr(0, path.size() - ending.size()));
  if (inner != ".sdf" && inner != ".world" && inner != ".urdf") return {};
  if (ending == ".jinja" || ending == ".em") return kTemplate;
  return {};
}

std::vector<std::string> absolute_folders(const Disk& disk, const std::vector<std::string>& paths,
                                          const std::string& working_folder) {
  std::vector<std::string> folders;
  if (!working_folder.empty()) folders.push_back(normalize_path(working_folder));
  for (const std::string& path : paths) {
    if (disk.kind(path) == PathKind::kFolder) folders.push_back(join_path(working_folder, path));
  }
  return folders;
}

class FolderWalk {
 public:
  FolderWalk(const Disk& disk, const std::vector<std::string>& paths,
             const DiscoverOptions& options, Discovered& found)
      : disk_(disk),
        options_(options),
        found_(found),
        ignores_(disk, absolute_folders(disk, paths, options.working_folder)) {}

  void argument(const std::string& path) {
    const PathKind kind = disk_.kind(path);
    if (kind != PathKind::kFile && kind != PathKind::kFolder) {
      found_.unusable.push_back(path + ": no such file or folder");
      return;
    }
    std::string why = options_.named == NamedPaths::kJudge ? why_not_named(path, kind) : "";
    if (!why.empty()) {
      found_.left_out.push_back({path, "left out by " + why, true});
    } else if (kind == PathKind::kFile) {
      file(path);
    } else {
      passed_over_.clear();
      xml_.clear();
      met_ = 0;
      unlisted_.clear();
      const std::size_t before = found_.unusable.size();
      folder(path, 0);
      if (met_ == 0 && found_.unusable.size() == before) no_model_in(path);
      std::move(unlisted_.begin(), unlisted_.end(), std::back_inserter(found_.left_out));
    }
  }

  /// Behind all arguments: more was found than git would show.
  void tell_unread_patterns() {
    for (const RepositoryIgnores::Unread& unread : ignores_.unread()) {
      // As seen from here, so that shards on several machines agree on whose it is.
      const std::string& here = options_.working_folder;
      found_.left_out.push_back({here.empty() ? unread.path : relative_path(here, unread.path),
                                 unread.problem + ", so what it ignores is not passed over", true});
    }
  }

 private:
  void file(const std::string& path) {
    const std::string_view why = template_of(path);
    ++met_;
    if (!seen_.insert(absolute(path)).second) return;
    if (options_.wanted && !options_.wanted(path)) return;
    if (why.empty()) {
      found_.files.push_back(path);
    } else {
      found_.left_out.push_back({path, std::string(why)});
    }
  }

  void folder(const std::string& path, int depth) {
    if (depth > kMaxFolderDepth) {
      unlisted_.push_back({path, "lies more than 64 folders deep", true});
      return;
    }
    const std::vector<std::string> names = disk_.list(path);
    if (names.empty()) {
      std::string why = disk_.obstacle(path);
      if (!why.empty() && depth == 0) found_.unusable.push_back(path + ": " + why);
      if (!why.empty() && depth > 0) unlisted_.push_back({path, std::move(why), true});
    }
    for (const std::string& name : names) {
      if (name.starts_with('.')) continue;
      const std::string inside = path == "." ? name : join_path(path, name);
      const PathKind kind = disk_.kind(inside);
      const bool is_folder = kind == PathKind::kFolder;
      const bool is_semantic = extension(inside) == ".srdf";
      if (extension(inside) == ".xml" && xml_.size() < kMaxXml) xml_.push_back(inside);
      if (!is_folder && !is_semantic && !is_model(inside) && template_of(inside).empty()) continue;
      if (is_semantic && !is_folder) {
        semantic_file(inside, kind);
        continue;
      }
      if (!is_folder && kind != PathKind::kFile) {
        const bool gone = kind == PathKind::kMissing;
        unlisted_.push_back({inside, gone ? "is a link to no file" : "is no regular file", true});
        continue;
      }
      if (std::string why = why_not(inside, kind); !why.empty()) {
        passed_over_.push_back({inside, std::move(why)});
      } else if (is_folder) {
        folder(inside, depth + 1);
      } else {
        file(inside);
      }
    }
  }

  void semantic_file(const std::string& path, PathKind kind) {
    if (kind != PathKind::kFile || !why_not(path, kind).empty()) return;
    ++met_;
    if (seen_.insert(absolute(path)).second) found_.semantic.push_back(path);
  }

  std::string why_not(const std::string& path, PathKind kind) {
    if (options_.excluded) {
      if (std::string why = options_.excluded(path, kind); !why.empty()) return why;
    }
    if (kind == PathKind::kFolder && is_marked(path)) return join_path(path, kColconMarker);
    if (options_.git_ignoring == GitIgnoring::kPassOver) return {};
    return ignores_.left_out(absolute(path), kind).value_or("");
  }

  /// Of a path that no walk led to: what is above it may be left out as well.
  std::string why_not_named(const std::string& path, PathKind kind) {
    if (std::string why = why_not(path, kind); !why.empty()) return why;
    if (options_.git_ignoring == GitIgnoring::kHonor) {
      if (auto why = ignores_.left_out_with_folders(absolute(path), kind)) return *why;
    }
    const std::string top = absolute(".");
    std::string above(parent_path(absolute(path)));
    for (; above != top && is_within(above, top); above = std::string(parent_path(above))) {
      if (is_marked(above)) return join_path(above, kColconMarker);
    }
    return {};
  }

  bool is_marked(const std::string& folder) const {
    return disk_.kind(join_path(folder, kColconMarker)) == PathKind::kFile;
  }

  std::string absolute(const std::string& path) const {
    return join_path(options_.working_folder, path);
  }

  void no_model_in(const std::string& path) {
    std::string message = path + ": holds no .sdf, .world, .urdf, .srdf, .xacro or model.config";
    if (!unlisted_.empty()) message += " in what can be listed";
    if (!passed_over_.empty()) {
      message += " but in what is left out: " + passed_over_.front().path + " by " +
                 passed_over_.front().why;
      if (passed_over_.size() > 1) {
        message += ", and " + std::to_string(passed_over_.size() - 1) + " more";
      }
    }
    if (const std::string mjcf = first_mjcf(); !mjcf.empty()) {
      message += "; MJCF is checked when it is named: " + mjcf;
    }
    found_.unusable.push_back(std::move(message));
  }

  /// Of the `.xml` files in the folder, most of which are something else.
  std::string first_mjcf() const {
    for (const std::string& path : xml_) {
      const ReadResult file = disk_.read(path, kMaxXmlBytes);
      if (file.bytes && file.bytes->find("<mujoco") != std::string::npos) return path;
    }
    return {};
  }

  const Disk& disk_;
  const DiscoverOptions& options_;
  Discovered& found_;
  RepositoryIgnores ignores_;
  std::vector<LeftOut> passed_over_;  ///< in the folder that is being walked
  std::vector<LeftOut> unlisted_;     ///< folders in it that nobody can look into
  std::vector<std::string> xml_;      ///< the first of its files with that ending
  std::size_t met_ = 0;               ///< models and templates in it
  std::set<std::string> seen_;
};

}  // namespace

Discovered discover(const Disk& disk, const std::vector<std::string>& paths,
                    const DiscoverOptions& options) {
  Discovered found;
  FolderWalk walk(disk, paths, options, found);
  for (const std::string& path : paths) walk.argument(path);
  walk.tell_unread_patterns();
  return found;
}

Discovered discover(const Disk& disk, const std::vector<std::string>& paths) {
  return discover(disk, paths, {});
}

}  // namespace rigor::read
