// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/project/mesh_check.h>

#include <set>
#include <tuple>
#include <utility>

#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

/// Of findings in two runs over the same bytes.
using FindingKey =
    std::tuple<std::string_view, std::string, std::uint32_t, std::uint32_t, std::string>;

FindingKey key_of(const Diagnostic& finding, const Sources& sources) {
  std::string path =
      finding.where.nowhere() ? finding.path : normalize_path(sources.path(finding.where.source));
  return {finding.rule, std::move(path), finding.where.begin, finding.where.end, finding.message};
}

}  // namespace

MeshCheck::MeshCheck(const Disk& below, OpenTexts texts, read::SearchPaths paths,
                     std::string worker, std::string uri, std::string path)
    : disk_(below),
      texts_(std::move(texts)),
      paths_(std::move(paths)),
      worker_(std::move(worker)),
      uri_(std::move(uri)),
      path_(std::move(path)) {}

void MeshCheck::run() {
  const EditorDisk disk(disk_, texts_);
  const Project project(disk, paths_, worker_);
  checked_ = check(disk, project, path_, rules::MeshPolicy::kOpen);
  const CheckedDocument without = check(disk, project, path_, rules::MeshPolicy::kDoNotOpen);
  std::set<FindingKey> known;
  for (const Diagnostic& finding : without.result.diagnostics.list())
    known.insert(key_of(finding, *without.sources));
  for (const Diagnostic& finding : checked_.result.diagnostics.list()) {
    if (!known.contains(key_of(finding, *checked_.sources))) findings_.push_back(finding);
  }
}

}  // namespace rigor::lsp
