// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "command/edit/edit_workspace.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include <rigor/author/names/workspace_files.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/text/path.h>

#include "output/output.h"

namespace rigor::tool {

EditWorkspace::EditWorkspace(const std::string& file, const Disk& disk)
    : folder_(author::workspace_folder(disk, file)) {}

std::vector<std::string> EditWorkspace::in_reach(std::vector<std::string> named) const {
  if (!folder_.empty()) named.push_back(folder_);
  return named;
}

std::vector<std::string> EditWorkspace::files_with(const std::set<std::string>& names,
                                                   const std::vector<std::string>& named,
                                                   const Disk& disk) const {
  if (folder_.empty()) return {};
  std::error_code error;
  const std::string working = std::filesystem::current_path(error).string();
  if (error) return {};
  const author::WorkspaceFiles files = author::workspace_files(disk, {folder_}, working);
  if (!files.is_complete) {
    say("rigor: " + report::printable(folder_) +
        " has too many files: not all were searched; name those that go along");
  }
  std::set<std::string> known;
  for (const std::string& path : named) known.insert(join_path(working, path));
  std::vector<std::string> found = files.that_may_hold(names, disk);
  std::erase_if(found,
                [&](const std::string& path) { return known.contains(join_path(working, path)); });
  return found;
}

}  // namespace rigor::tool
