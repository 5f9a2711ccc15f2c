// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/baseline_action.h>

#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/lsp/answer/edits_json.h>
#include <rigor/rules/baseline.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

Json text_of_new_file(const std::string& uri, const std::string& text) {
  const Json begin{{"start", position_json({})}, {"end", position_json({})}};
  const Json insert{{"range", begin}, {"newText", text}};
  return {{"documentChanges",
           {{{"kind", "create"}, {"uri", uri}, {"options", {{"ignoreIfExists", true}}}},
            {{"textDocument", {{"uri", uri}, {"version", nullptr}}}, {"edits", {insert}}}}}};
}

}  // namespace

Json baseline_action(const State& state, const OpenDocument& document,
                     const CheckedDocument& checked, const Diagnostic& finding) {
  const std::optional<std::string> path = state.project->settings().baseline(document.path());
  if (!path) return nullptr;
  const ReadResult read = state.disk.read(*path, rules::kMaxBaselineBytes);
  const bool is_new = state.disk.kind(*path) == PathKind::kMissing;
  if (is_new ? !state.client.creates_files || !state.client.document_changes : !read.bytes)
    return nullptr;
  rules::BaselineFile file = rules::read_baseline(read.bytes.value_or(std::string()));
  if (!file.problems.empty()) return nullptr;
  const auto options = check_options(*state.project, document.path(), rules::MeshPolicy::kLeaveOut);
  const rules::BaselineRun run(state.environment(), options, checked.result, baseline_place(*path));
  const auto found = run.found().find({run.name(document.path()), std::string(finding.rule)});
  if (found == run.found().end()) return nullptr;
  file.baseline[found->first] = found->second;
  const std::string text = rules::baseline_text(file.baseline);
  Json edit;
  if (is_new) {
    edit = text_of_new_file(uri_of_file(state, *path), text);
  } else {
    Sources sources;
    const SourceId source = sources.add(*path, *read.bytes);
    const auto size = static_cast<std::uint32_t>(read.bytes->size());
    edit = workspace_edit(state, sources, {{{source, 0, size}, text}});
  }
  const std::string what =
      found->second == 1 ? std::string("finding") : fmt::format("{} findings", found->second);
  return {{"title", fmt::format("add the {} of {} in this file to {}", what, finding.rule,
                                file_name(*path))},
          {"kind", "quickfix"},
          {"edit", std::move(edit)}};
}

}  // namespace rigor::lsp
