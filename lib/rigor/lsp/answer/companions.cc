// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/companions.h>

#include <algorithm>
#include <string>
#include <utility>

#include <rigor/config/config.h>
#include <rigor/config/configs.h>
#include <rigor/lsp/answer/edits_json.h>
#include <rigor/lsp/answer/srdf.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

Json companion_json(const Json& range, Severity severity, const std::string& message) {
  return {{"range", range},
          {"severity", static_cast<int>(severity) + 1},
          {"source", "rigor"},
          {"message", message}};
}

std::vector<Json> of_configuration(const OpenDocument& document) {
  std::vector<Json> list;
  const LineIndex& lines = document.lines();
  for (const config::Problem& problem :
       config::read_config(document.path(), document.text()).problems) {
    const std::uint32_t line =
        std::min(problem.line > 0 ? problem.line - 1 : 0U, lines.line_count() - 1);
    list.push_back(companion_json(range_json(lines, lines.line_begin(line), lines.line_end(line)),
                                  Severity::kError, problem.message));
  }
  return list;
}

/// `${prefix}/models` is a folder of the package.
void check_exported_folder(const State& state, const OpenDocument& document,
                           xml::Attribute attribute, std::vector<CompanionFinding>& found) {
  constexpr std::string_view kPrefix = "${prefix}";
  const std::string_view value = attribute.value();
  if (!value.starts_with(kPrefix)) return;
  std::string rest(value.substr(kPrefix.size()));
  while (rest.starts_with('/')) rest.erase(0, 1);
  if (rest.starts_with("..")) return;  // beside the package: another one's, once installed
  const std::string folder = join_path(parent_path(document.path()), rest);
  if (rest.empty() || state.disk.kind(folder) == PathKind::kFolder) return;
  found.push_back({attribute.value_span(), Severity::kWarning,
                   "folder '" + rest + "' does not exist in the package"});
}

std::vector<CompanionFinding> package_findings(const State& state, const OpenDocument& document,
                                               const xml::Document& written) {
  std::vector<CompanionFinding> found;
  const auto root = written.root();
  if (!root || root->name() != "package") return found;
  for (const xml::Element part : root->children()) {
    if (part.name() != "export") continue;
    for (const xml::Element exported : part.children()) {
      for (const std::string_view name : {"gazebo_model_path", "gazebo_media_path"}) {
        if (const auto attribute = exported.attribute(name))
          check_exported_folder(state, document, *attribute, found);
      }
    }
  }
  if (!root->child("name"))
    found.push_back({root->name_span(), Severity::kError, "the package has no <name>"});
  return found;
}

}  // namespace

std::vector<Json> companion_diagnostics(State& state, OpenDocument& document) {
  const std::string_view file = file_name(document.path());
  if (file == config::kConfigName) return of_configuration(document);
  const bool is_srdf = extension(document.path()) == ".srdf";
  if (!is_srdf && file != "package.xml") return {};
  const xml::Document& written = document.analysis(state.environment()).written();
  std::vector<CompanionFinding> found;
  for (const xml::Fault& fault : written.faults()) {
    if (xml::is_fatal(fault.kind))
      found.push_back({fault.where, Severity::kError, "the file is not well-formed XML from here"});
  }
  if (found.empty())
    found = is_srdf ? srdf_findings(state, document) : package_findings(state, document, written);
  std::vector<Json> list;
  for (const CompanionFinding& each : found) {
    list.push_back(
        companion_json(range_json(document.lines(), each.where), each.severity, each.message));
  }
  return list;
}

}  // namespace rigor::lsp
