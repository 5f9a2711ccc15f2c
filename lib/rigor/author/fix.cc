// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/fix.h>

#include <optional>

#include <rigor/author/file_fixer.h>
#include <rigor/mass/mesh/facts.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/read/workspace.h>

namespace rigor::author {
namespace {

/// The file's own source: that of a fix of it.
std::optional<SourceId> fixable_source(const rules::FileSummary& file,
                                       const rules::ValidateResult& result, const Sources& sources,
                                       Applicability most) {
  for (std::size_t i = file.first_finding; i < file.end_finding; ++i) {
    const Diagnostic& finding = result.diagnostics.list()[i];
    if (!has_fix(finding, most)) continue;
    const Span where = finding.fixes.front().edits.front().span;
    if (!where.nowhere() && sources.path(where.source) == file.path) return where.source;
  }
  return std::nullopt;
}

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
  for (const rules::FileSummary& file : result.files) {
    const auto source = fixable_source(file, result, sources, most);
    if (!source) continue;
    const std::string bytes(sources.bytes(*source));
    if (!stands_on_disk(environment, options, file.path, bytes)) continue;
    FileFixer fixer(environment, recheck, file.path, bytes, most);
    fixed.push_back(fixer.run(*source));
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
