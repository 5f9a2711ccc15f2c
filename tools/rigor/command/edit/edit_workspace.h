// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The files around the one that is edited; private to `rigor edit`.

#pragma once

#include <set>
#include <string>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor::tool {

class EditWorkspace {
 public:
  /// No files but those that are named.
  EditWorkspace() = default;
  /// Those of the repository or package of the file.
  EditWorkspace(const std::string& file, const Disk& disk);

  /// The paths, and the folder of the workspace.
  std::vector<std::string> in_reach(std::vector<std::string> named) const;

  /// Others than the named ones that may hold one of the names. Says so where not all were searched.
  std::vector<std::string> files_with(const std::set<std::string>& names,
                                      const std::vector<std::string>& named,
                                      const Disk& disk) const;

 private:
  std::string folder_;  ///< empty for none
};

}  // namespace rigor::tool
