// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What answers are computed with: the environment over the editor's disk, and the configuration. Both remember
// what they read, so there is a new one whenever a file on the disk changes.

#pragma once

#include <string>
#include <utility>

#include <rigor/lsp/document/editor_disk.h>
#include <rigor/lsp/project/project_settings.h>
#include <rigor/read/resolver.h>
#include <rigor/rules/environment.h>

namespace rigor::lsp {

/// Neither copied nor moved: the environment asks the settings.
class Project {
 public:
  /// The disk outlives it. `worker` is the path of rigor-worker; empty to find it.
  Project(const EditorDisk& disk, read::SearchPaths paths, const std::string& worker,
          std::shared_ptr<const Knowledge> knowledge)
      : settings_(disk),
        environment_(disk, configured(std::move(paths)), worker, std::move(knowledge)) {}
  Project(const Project&) = delete;
  Project& operator=(const Project&) = delete;

  const Environment& environment() const { return environment_; }
  const ProjectSettings& settings() const { return settings_; }

 private:
  read::SearchPaths configured(read::SearchPaths paths) const {
    paths.configured = [this](std::string_view file) { return settings_.resolve_paths(file); };
    return paths;
  }

  ProjectSettings settings_;
  Environment environment_;
};

}  // namespace rigor::lsp
