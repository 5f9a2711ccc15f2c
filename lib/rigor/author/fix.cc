// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/fix.h>

#include <algorithm>
#include <map>
#include <optional>

#include <rigor/author/file_fixer.h>
#include <rigor/mass/mesh/facts.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/read/template/template_expander.h>
#include <rigor/read/workspace.h>
#include <rigor/text/path.h>

namespace rigor::author {
namespace {

/// Of each file that has fixes the source that they name, by its path; of a template and what it includes,
/// by the path from the working folder.
class FixableSources {
 public:
  FixableSources(const Environment& environment, const rules::ValidateResult& result,
                 const Sources& sources, Applicability most)
      : working_folder_(environment.resolver.paths().templates.working_folder) {
    for (const rules::FileSummary& file : result.files) {
      for (std::size_t i = file.first_finding; i < file.end_finding; ++i) {
        const Diagnostic& finding = result.diagnostics.list()[i];
        if (!has_fix(finding, most)) continue;
        const Span where = finding.fixes.front().edits.front().span;
        if (where.nowhere()) continue;
        const std::string_view path = sources.path(where.source);
        const bool is_own = path == file.path;
        if (is_own || !file.reads.empty()) known_.try_emplace(seen_from_here(path), where.source);
      }
    }
  }

  std::optional<SourceId> of(const rules::FileSummary& file) const {
    const auto found = known_.find(seen_from_here(file.path));
    return found == known_.end() ? std::nullopt : std::optional(found->second);
  }

  /// The templates that read a file; none when it is itself the only one.
  std::vector<std::string> robots_of(const rules::FileSummary& file,
                                     const rules::ValidateResult& result) const {
    const std::string path = seen_from_here(file.path);
    std::vector<std::string> robots;
    for (const rules::FileSummary& robot : result.files) {
      if (std::binary_search(robot.reads.begin(), robot.reads.end(), path))
        robots.push_back(robot.path);
    }
    if (robots.size() == 1 && robots.front() == file.path) robots.clear();
    return robots;
  }

 private:
  std::string seen_from_here(std::string_view path) const {
    return join_path(working_folder_, path);
  }

  std::string working_folder_;
  std::map<std::string, SourceId> known_;
};

/// Whether the bytes that were checked are the file's own: not made of a
/// template, nor written since.
bool stands_on_disk(const Environment& environment, const rules::ValidateOptions& options,
                    const std::string& path, std::string_view bytes) {
  if (options.buffer && options.buffer->path == path) return true;
  return environment.disk.read(path, read::kMaxModelBytes).bytes == bytes;
}

}  // namespace

std::vector<FixedFile> fix_files(const Environment& environment,
                                 const rules::ValidateOptions& options,
                                 const rules::ValidateResult& result, const Sources& sources,
                                 Applicability most) {
  const mass::MeshMemory memory{.workers = &environment.workers};
  mass::MeshSurveys surveys(environment.disk, memory);
  mass::MeshFiles mesh_files(environment.disk, mass::MeshDepth::kFile, memory);
  rules::ValidateOptions recheck = options;
  if (recheck.known.surveys == nullptr) recheck.known.surveys = &surveys;
  if (recheck.known.files == nullptr) recheck.known.files = &mesh_files;
  std::vector<FixedFile> fixed;
  const FixableSources fixable(environment, result, sources, most);
  for (const rules::FileSummary& file : result.files) {
    const auto source = fixable.of(file);
    if (!source) continue;
    const std::string bytes(sources.bytes(*source));
    if (!stands_on_disk(environment, options, file.path, bytes)) continue;
    FileFixer fixer(environment, recheck, {file.path, bytes, fixable.robots_of(file, result)},
                    most);
    fixed.push_back(fixer.run(*source));
    // Robots that share it are fixed with what it holds then.
    if (fixed.back().changed() && read::is_template(file.path))
      recheck.included.push_back({file.path, fixed.back().after});
  }
  return fixed;
}

bool has_fix(const Diagnostic& finding, Applicability most) {
  if (finding.fixes.empty() || finding.fixes.front().edits.empty()) return false;
  const Applicability needed = finding.fixes.front().applicability;
  return needed == Applicability::kSafe ||
         (needed == Applicability::kUnsafe && most == Applicability::kUnsafe);
}

}  // namespace rigor::author
