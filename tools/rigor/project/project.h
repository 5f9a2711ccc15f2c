// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a run stands in a repository, and what the CI service around it wants to be told.

#pragma once

#include <string_view>

#include <rigor/report/validation.h>

namespace rigor::tool {

/// The folder that the program runs in, and the top of the project around it: CI_PROJECT_DIR, GitLab's, when
/// that lies above; else the nearest folder with `.git`; else GITHUB_WORKSPACE; else the folder itself.
report::ProjectFolders project_folders();

/// To the page of the run, when GITHUB_STEP_SUMMARY names a file for it; after what other steps wrote.
void add_to_step_summary(std::string_view markdown);

}  // namespace rigor::tool
