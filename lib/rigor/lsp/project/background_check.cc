// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/project/background_check.h>

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

BackgroundCheck::BackgroundCheck(const Disk& below, OpenTexts texts, read::SearchPaths paths,
                                 std::string worker, std::shared_ptr<const Knowledge> knowledge,
                                 BackgroundDocument document, rules::MeshPolicy meshes)
    : disk_(below),
      texts_(std::move(texts)),
      paths_(std::move(paths)),
      worker_(std::move(worker)),
      knowledge_(std::move(knowledge)),
      document_(std::move(document)),
      meshes_(meshes) {}

void BackgroundCheck::run() {
  const EditorDisk disk(disk_, texts_);
  const Project project(disk, paths_, worker_, knowledge_);
  const std::string& path = document_.path;
  whole_ = check(disk, project, path, rules::MeshPolicy::kLeaveOut);
  const auto text = texts_.find(normalize_path(path));
  if (text != texts_.end() && PartCheck::is_worth_it(path, *text->second, whole_))
    parts_ = PartCheck::of(path, *text->second);
  if (!opens_meshes() || stopped()) return;
  checked_ = check(disk, project, path, rules::MeshPolicy::kOpen);
  std::set<FindingKey> known;
  for (const Diagnostic& finding : whole_.result.diagnostics.list())
    known.insert(key_of(finding, *whole_.sources));
  for (const Diagnostic& finding : checked_.result.diagnostics.list()) {
    if (!known.contains(key_of(finding, *checked_.sources))) findings_.push_back(finding);
  }
}

}  // namespace rigor::lsp
