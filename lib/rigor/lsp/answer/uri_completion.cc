// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/uri_completion.h>

#include <algorithm>
#include <array>

#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

constexpr std::array<std::string_view, 3> kSchemes{"model://", "package://", "file://"};

void list_folder(const State& state, const std::string& folder, std::uint32_t begin,
                 std::vector<UriStep>& steps) {
  for (const std::string& name : state.disk.list(folder)) {
    if (name.starts_with('.')) continue;
    const bool is_folder = state.disk.kind(join_path(folder, name)) == PathKind::kFolder;
    steps.push_back({is_folder ? name + '/' : name, begin, is_folder});
  }
}

/// Folders in which models and packages are searched by their names, and the neighbors of the file's own.
std::vector<std::string> searched(const State& state, const std::string& path) {
  std::vector<std::string> folders;
  const read::SearchPaths& paths = state.environment().resolver.paths();
  if (const auto* configured = state.project->settings().resolve_paths(path))
    folders = configured->folders;
  for (const auto* list : {&paths.given, &paths.environment}) {
    for (const read::SearchPath& each : *list) folders.push_back(each.folder);
  }
  std::string folder(parent_path(path));
  for (int level = 0; level < 2; ++level) {
    folder = enclosing_folder(folder);
    folders.push_back(folder);
  }
  return folders;
}

}  // namespace

std::vector<UriStep> uri_steps(const State& state, const std::string& path,
                               std::string_view typed) {
  std::vector<UriStep> steps;
  const std::size_t slash = typed.rfind('/');
  const auto begin = static_cast<std::uint32_t>(slash == std::string_view::npos ? 0 : slash + 1);
  const std::size_t scheme = typed.find("://");
  if (slash == std::string_view::npos) {
    for (const std::string_view each : kSchemes) steps.push_back({std::string(each), 0, true});
    list_folder(state, std::string(parent_path(path)), begin, steps);
  } else if (scheme != std::string_view::npos && slash == scheme + 2) {
    for (const std::string& folder : searched(state, path))
      list_folder(state, folder, begin, steps);
    std::erase_if(steps, [](const UriStep& step) { return !step.is_folder; });
  } else {
    const read::Resolution found =
        state.environment().resolver.resolve(typed.substr(0, slash), path);
    if (found.path) list_folder(state, *found.path, begin, steps);
  }
  return steps;
}

}  // namespace rigor::lsp
