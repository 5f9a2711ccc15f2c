// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/discover.h>

#include <algorithm>
#include <set>
#include <string_view>

#include <rigor/text/path.h>

namespace rigor::read {
namespace {

/// Folders nest this deep at most: a link that leads back up would never end.
constexpr int kMaxFolderDepth = 64;

bool is_model(const std::string& path) {
  const std::string ending = extension(path);
  return ending == ".sdf" || ending == ".world" || ending == ".urdf" ||
         file_name(path) == "model.config";
}

/// Why a file that will become a model is not looked at; empty for any other file.
std::string_view template_of(const std::string& path) {
  const std::string ending = extension(path);
  if (ending == ".xacro") return "xacro: expand it first";
  const std::string inner = extension(path.substr(0, path.size() - ending.size()));
  if (inner != ".sdf" && inner != ".world" && inner != ".urdf") return {};
  if (ending == ".erb" || ending == ".jinja" || ending == ".em") return "template: expand it first";
  return {};
}

class FolderWalk {
 public:
  FolderWalk(const Disk& disk, Discovered& found) : disk_(disk), found_(found) {}

  void argument(const std::string& path) {
    switch (disk_.kind(path)) {
      case PathKind::kMissing:
      case PathKind::kOther: found_.unusable.push_back(path + ": no such file or folder"); break;
      case PathKind::kFile: file(path); break;
      case PathKind::kFolder: {
        const std::size_t before = found_.files.size() + found_.left_out.size();
        folder(path, 0);
        if (found_.files.size() + found_.left_out.size() == before) {
          found_.unusable.push_back(path + ": holds no .sdf, .world, .urdf or model.config");
        }
        break;
      }
    }
  }

 private:
  void file(const std::string& path) {
    const std::string_view why = template_of(path);
    if (!why.empty()) {
      found_.left_out.push_back({path, std::string(why)});
    } else if (seen_.insert(normalize_path(path)).second) {
      found_.files.push_back(path);
    }
  }

  void folder(const std::string& path, int depth) {
    if (depth > kMaxFolderDepth) return;
    for (const std::string& name : disk_.list(path)) {
      if (name.starts_with('.')) continue;
      const std::string inside = path == "." ? name : join_path(path, name);
      const PathKind kind = disk_.kind(inside);
      if (kind == PathKind::kFolder) folder(inside, depth + 1);
      if (kind == PathKind::kFile && (is_model(inside) || !template_of(inside).empty())) {
        file(inside);
      }
    }
  }

  const Disk& disk_;
  Discovered& found_;
  std::set<std::string> seen_;
};

}  // namespace

Discovered discover(const Disk& disk, const std::vector<std::string>& paths) {
  Discovered found;
  FolderWalk walk(disk, found);
  for (const std::string& path : paths) walk.argument(path);
  return found;
}

}  // namespace rigor::read
