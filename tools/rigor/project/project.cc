// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "project/project.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "output/output.h"

namespace rigor::tool {
namespace {

std::filesystem::path real_path(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path real = std::filesystem::canonical(path, error);
  return error ? std::filesystem::path() : real;
}

/// What a variable names, if the working folder lies in it.
std::filesystem::path named_top(const char* name, const std::filesystem::path& working) {
  const char* value = std::getenv(name);
  if (value == nullptr || *value == '\0') return {};
  const std::filesystem::path top = real_path(value);
  for (std::filesystem::path folder = working;; folder = folder.parent_path()) {
    if (folder == top) return top;
    if (folder == folder.parent_path()) return {};
  }
}

/// The nearest folder with `.git`: a file in a worktree or a submodule.
std::filesystem::path repository_top(const std::filesystem::path& working) {
  std::error_code error;
  for (std::filesystem::path folder = working;; folder = folder.parent_path()) {
    if (std::filesystem::exists(folder / ".git", error)) return folder;
    if (folder == folder.parent_path()) return {};
  }
}

std::filesystem::path project_top(const std::filesystem::path& working) {
  std::filesystem::path top = named_top("CI_PROJECT_DIR", working);
  if (top.empty()) top = repository_top(working);
  if (top.empty()) top = named_top("GITHUB_WORKSPACE", working);
  return top.empty() ? working : top;
}

}  // namespace

report::ProjectFolders project_folders() {
  const std::filesystem::path working = real_path(".");
  if (working.empty()) return {};
  return {working.generic_string(), project_top(working).generic_string()};
}

void add_to_step_summary(std::string_view markdown) {
  const char* path = std::getenv("GITHUB_STEP_SUMMARY");
  if (path == nullptr || *path == '\0') return;
  std::ofstream file(path, std::ios::binary | std::ios::app);
  file.write(markdown.data(), static_cast<std::streamsize>(markdown.size()));
  file.close();
  // The findings are in the log too: that the page lacks them is no reason to fail.
  if (!file)
    say(std::string("rigor: ") + path + ", which GITHUB_STEP_SUMMARY names, cannot be written");
}

}  // namespace rigor::tool
