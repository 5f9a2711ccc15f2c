// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which templates of a folder are robots, and which only hold parts of them. A robot has links, or is a
// world, once it is expanded, and no other robot includes it. What a robot includes is checked through it.
//
//   const EntryPoints found = entry_points(templates, named, workspace, working_folder);
//   for (const std::string& path : found.robots) check(path);

#pragma once

#include <set>
#include <string>
#include <vector>

#include <rigor/read/workspace.h>

namespace rigor::rules {

struct EntryPoints {
  /// Named ones, and what is a robot by itself.
  std::vector<std::string> robots;
  struct Part {
    std::string path;
    std::string robot;  ///< that includes it
  };
  std::vector<Part> parts;
  struct Unreached {
    std::string path;
    std::string why;
  };
  std::vector<Unreached> unreached;
};

/// Of `paths`, those in `named` are robots whatever they hold. Expands all of them.
EntryPoints entry_points(const std::vector<std::string>& paths, const std::set<std::string>& named,
                         read::Workspace& workspace, const std::string& working_folder);

/// Whether an expanded template has links (of an SRDF: groups) or is an SDF file, and no mere part of one.
bool makes_robot(const read::File& file);

/// Whether a template describes planning groups (SRDF), which no model rule is about.
bool is_srdf_template(std::string_view path);

}  // namespace rigor::rules
