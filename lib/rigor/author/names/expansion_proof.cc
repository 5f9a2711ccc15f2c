// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/expansion_proof.h>

#include <map>
#include <utility>

#include <fmt/core.h>

#include <rigor/read/template/template_expander.h>
#include <rigor/text/path.h>

namespace rigor::author {

std::string expansion_fault(const RenameContext& context, const std::vector<std::string>& templates,
                            const std::vector<Edit>& edits) {
  std::map<std::string, std::pair<SourceId, std::vector<Edit>>> by_file;
  for (const Edit& edit : edits) {
    auto& [source, list] = by_file[normalize_path(context.sources.path(edit.span.source))];
    source = edit.span.source;
    list.push_back(edit);
  }
  read::TemplateExpander expander(context.resolver);
  for (const auto& [written, change] : by_file) {
    const auto text = apply_edits(context.sources.bytes(change.first), change.second);
    if (!text) return fmt::format("edits of {} overlap", written);
    expander.replace(written, *text);
  }
  for (const std::string& path : templates) {
    const read::File& before = context.graph.file(path);
    const auto after = expander.expand(path, context.sources);
    if (!before.document || !after->document ||
        before.document->bytes() != after->document->bytes())
      return fmt::format("the template {} would expand to something else", path);
  }
  return {};
}

}  // namespace rigor::author
