// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/project/check.h>

#include <array>
#include <utility>

#include <rigor/text/path.h>
#include <rigor/xml/document.h>

namespace rigor::lsp {
namespace {

/// A baseline that is not there or is none hides nothing; the command line says so.
void hide_known(const Disk& disk, const Project& project, const std::string& path,
                const rules::ValidateOptions& options, rules::ValidateResult& result) {
  const ReadResult read = disk.read(path, rules::kMaxBaselineBytes);
  if (!read.bytes) return;
  rules::BaselineFile file = rules::read_baseline(*read.bytes);
  if (!file.problems.empty()) return;
  const rules::BaselineRun run(project.environment(), options, result, baseline_place(path));
  // Whether other files are still there does not matter to this one.
  std::erase_if(file.baseline,
                [&](const auto& entry) { return !run.found().contains(entry.first); });
  result = rules::apply_baseline(file.baseline, run, std::move(result)).left;
}

}  // namespace

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

rules::BaselinePlace baseline_place(const std::string& path) {
  return {std::string(parent_path(path)), "/"};
}

namespace {

CheckedDocument check_with(const rules::ValidateOptions& options, const EditorDisk& disk,
                           const Project& project, const std::string& path) {
  CheckedDocument checked;
  checked.sources = std::make_unique<Sources>();
  disk.take_asked();
  checked.result = rules::validate(project.environment(), options, *checked.sources);
  if (const auto baseline = project.settings().baseline(path))
    hide_known(disk, project, *baseline, options, checked.result);
  checked.asked_files = disk.take_asked();
  return checked;
}

}  // namespace

CheckedDocument check(const EditorDisk& disk, const Project& project, const std::string& path,
                      rules::MeshPolicy meshes, rules::TemplateDepth depth) {
  rules::ValidateOptions options = check_options(project, path, meshes);
  options.template_depth = depth;
  return check_with(options, disk, project, path);
}

CheckedDocument check_text(const EditorDisk& disk, const Project& project, const std::string& path,
                           std::string text, rules::MeshPolicy meshes) {
  rules::ValidateOptions options = check_options(project, path, meshes);
  options.paths.clear();
  options.buffer = {path, std::move(text)};
  return check_with(options, disk, project, path);
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
