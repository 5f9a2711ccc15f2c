// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/project/check.h>

#include <array>

#include <rigor/text/path.h>
#include <rigor/xml/document.h>

namespace rigor::lsp {

rules::ValidateOptions check_options(const Project& project, const std::string& path,
                                     rules::MeshPolicy meshes) {
  rules::ValidateOptions options;
  options.paths = {path};
  options.meshes = meshes;
  options.threads = 1;
  options.selection_for = [&project](const std::string& file) {
    return project.settings().selection(file);
  };
  options.arguments_for = [&project](const std::string& file) {
    return project.settings().arguments(file);
  };
  return options;
}

CheckedDocument check(const EditorDisk& disk, const Project& project, const std::string& path,
                      rules::MeshPolicy meshes) {
  CheckedDocument checked;
  checked.sources = std::make_unique<Sources>();
  disk.take_asked();
  checked.result = rules::validate(project.environment(), check_options(project, path, meshes),
                                   *checked.sources);
  checked.asked_files = disk.take_asked();
  return checked;
}

bool is_checked(std::string_view path, std::string_view text) {
  static constexpr std::array kEndings{".sdf", ".world", ".urdf", ".xacro", ".config"};
  const std::string ending = extension(path);
  for (const std::string_view each : kEndings) {
    if (ending == each) return true;
  }
  if (ending == ".srdf" || file_name(path) == "package.xml" || ending == ".toml") return false;
  const xml::Document document = xml::parse_own(text, SourceId{0});
  const auto root = document.root();
  return root && (root->name() == "sdf" || root->name() == "robot");
}

}  // namespace rigor::lsp
