// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/session/mesh_findings.h>

#include <algorithm>
#include <array>
#include <utility>

#include <rigor/lsp/answer/diagnostics.h>
#include <rigor/lsp/answer/edits_json.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

/// The bytes that a finding about a mesh depends on: its link's; of what is in no link, the element's.
Span guarded(const xml::Document& document, Span where) {
  static constexpr std::array<std::string_view, 3> kGuards{"link", "xacro:macro", "gazebo"};
  const auto innermost = document.element_at(where.begin);
  for (auto element = innermost; element; element = element->parent()) {
    if (std::find(kGuards.begin(), kGuards.end(), element->name()) != kGuards.end())
      return element->span();
  }
  return innermost ? innermost->span() : where;
}

}  // namespace

MeshFindings::MeshFindings(const State& state, OpenDocument& document,
                           const BackgroundCheck& check) {
  const xml::Document& written = document.analysis(state.environment()).written();
  PlacesJson places(check.sources(), state.client.encoding);
  const std::string own_path = normalize_path(document.path());
  for (const Diagnostic& finding : check.findings()) {
    Json diagnostic = diagnostic_json(state, finding, places);
    if (finding.where.nowhere()) {
      const auto size = static_cast<std::uint32_t>(document.text().size());
      own_.push_back({{0, 0, 0, size}, std::move(diagnostic)});
      continue;
    }
    const std::string path = normalize_path(check.sources().path(finding.where.source));
    if (path == own_path) {
      const Span guard = guarded(written, finding.where);
      own_.push_back({{finding.where.begin, finding.where.end, guard.begin, guard.end},
                      std::move(diagnostic)});
    } else {
      elsewhere_[uri_of_file(state, path)].push_back(std::move(diagnostic));
    }
  }
}

void MeshFindings::follow(const TextChange& change) {
  std::erase_if(own_, [&change](Own& each) { return !each.place.follow(change); });
  for (Own& each : own_) each.moved = each.moved || change.begin < each.place.guard_begin;
}

void MeshFindings::add_to(std::map<std::string, std::vector<Json>>& by_uri,
                          const OpenDocument& document) const {
  for (const Own& each : own_) {
    Json diagnostic = each.diagnostic;
    diagnostic["range"] = range_json(document.lines(), each.place.begin, each.place.end);
    // Its places may have moved by more or less than it has.
    if (each.moved) diagnostic.erase("relatedInformation");
    by_uri[document.uri()].push_back(std::move(diagnostic));
  }
  for (const auto& [uri, list] : elsewhere_) {
    std::vector<Json>& all = by_uri[uri];
    all.insert(all.end(), list.begin(), list.end());
  }
}

}  // namespace rigor::lsp
