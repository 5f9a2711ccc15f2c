// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/diagnostics.h>

#include <rigor/config/config.h>
#include <rigor/config/configs.h>
#include <rigor/lsp/answer/edits_json.h>
#include <rigor/text/grouping.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

/// Of the protocol's DiagnosticTag.
constexpr int kUnnecessary = 1;
constexpr int kDeprecated = 2;

/// Of the protocol's DiagnosticSeverity.
int severity_number(Severity severity) { return static_cast<int>(severity) + 1; }

Json tags_of(std::string_view rule) {
  Json tags = Json::array();
  if (rule.find("unused") != std::string_view::npos || rule == "xacro-no-effect")
    tags.push_back(kUnnecessary);
  if (rule.find("deprecated") != std::string_view::npos) tags.push_back(kDeprecated);
  return tags;
}

/// What a command line shows under the message.
std::string message_of(const Diagnostic& finding) {
  std::string text = finding.message;
  if (const std::string_view why = why_of(finding); !why.empty()) text += "\n" + std::string(why);
  if (const std::string_view help = help_of(finding); !help.empty())
    text += "\nHelp: " + std::string(help);
  return text;
}

Json related_of(const Diagnostic& finding, PlacesJson& places) {
  Json list = Json::array();
  const auto add = [&](Span where, const std::string& message) {
    if (!where.nowhere())
      list.push_back({{"location", places.location(where)}, {"message", message}});
  };
  for (const Label& label : finding.related) add(label.where, label.message);
  for (const MacroCall& call : finding.origin)
    add(call.where, "in this call of macro '" + call.macro + "'");
  for (const Diagnostic& other : finding.others) add(other.where, other.message);
  return list;
}

/// The lines of a configuration that cannot stand in it.
std::vector<Json> of_configuration(const OpenDocument& document) {
  std::vector<Json> list;
  for (const config::Problem& problem :
       config::read_config(document.path(), document.text()).problems) {
    const std::uint32_t line =
        std::min(problem.line > 0 ? problem.line - 1 : 0U, document.lines().line_count() - 1);
    const LineIndex& lines = document.lines();
    list.push_back({{"range", range_json(lines, lines.line_begin(line), lines.line_end(line))},
                    {"severity", severity_number(Severity::kError)},
                    {"source", "rigor"},
                    {"message", problem.message}});
  }
  return list;
}

}  // namespace

Json diagnostic_json(const State& state, const Diagnostic& finding, PlacesJson& places) {
  const Json first_place{{"start", position_json({})}, {"end", position_json({})}};
  Json json{{"range", finding.where.nowhere() ? first_place : places.range(finding.where)},
            {"severity", severity_number(finding.severity)},
            {"code", std::string(finding.rule)},
            {"source", "rigor"},
            {"message", message_of(finding)}};
  if (!state.client.rule_pages.empty()) {
    json["codeDescription"] = {
        {"href", state.client.rule_pages + std::string(finding.rule) + ".html"}};
  }
  if (Json related = related_of(finding, places); !related.empty())
    json["relatedInformation"] = std::move(related);
  if (Json tags = tags_of(finding.rule); !tags.empty()) json["tags"] = std::move(tags);
  return json;
}

bool stands_in(const OpenDocument& document, const CheckedDocument& checked,
               const Diagnostic& finding) {
  if (finding.where.nowhere()) return true;
  return normalize_path(checked.sources->path(finding.where.source)) ==
         normalize_path(document.path());
}

std::map<std::string, std::vector<Json>> diagnostics_by_uri(const State& state,
                                                            const OpenDocument& document,
                                                            const CheckedDocument& checked) {
  std::map<std::string, std::vector<Json>> by_uri;
  std::vector<Json>& own = by_uri[document.uri()];
  if (file_name(document.path()) == config::kConfigName) own = of_configuration(document);
  PlacesJson places(*checked.sources, state.client.encoding);
  for (const Diagnostic& finding : checked.result.diagnostics.list()) {
    const bool is_own = stands_in(document, checked, finding);
    by_uri[is_own ? document.uri()
                  : uri_of_file(state, checked.sources->path(finding.where.source))]
        .push_back(diagnostic_json(state, finding, places));
  }
  return by_uri;
}

std::string diagnostic_key(const Json& diagnostic) {
  return json_text(member(diagnostic, "range")) + json_text(member(diagnostic, "code")) +
         json_text(member(diagnostic, "message"));
}

}  // namespace rigor::lsp
