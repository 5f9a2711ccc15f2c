// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/diagnostics.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

#include <fmt/core.h>

#include <rigor/lsp/answer/companions.h>
#include <rigor/lsp/answer/edits_json.h>
#include <rigor/text/grouping.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

/// Of the protocol's DiagnosticTag.
constexpr int kUnnecessary = 1;
constexpr int kDeprecated = 2;

/// Places of one cause that are shown: nobody looks at a thousand boxes of which each lacks the same, and to send them
/// takes longer than to find them. The last one says how many there are.
constexpr std::size_t kMaxPlaces = 100;

/// Of one cause.
struct Shown {
  std::size_t places = 0;
  std::vector<Json>* list = nullptr;  // that the last one is in
  std::size_t last = 0;
};

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
    if (where.nowhere()) return;
    Json& related = list.emplace_back();
    related["location"] = places.location(where);
    related["message"] = message;
  };
  for (const Label& label : finding.related) add(label.where, label.message);
  for (const MacroCall& call : finding.origin)
    add(call.where, "in this call of macro '" + call.macro + "'");
  for (const Diagnostic& other : finding.others) add(other.where, other.message);
  return list;
}

}  // namespace

Json diagnostic_json(const State& state, const Diagnostic& finding, PlacesJson& places) {
  Json json;
  Json& range = json["range"];
  if (finding.where.nowhere()) {
    range["start"] = range["end"] = position_json({});
  } else {
    range = places.range(finding.where);
  }
  json["severity"] = severity_number(finding.severity);
  json["code"] = finding.rule;
  json["source"] = "rigor";
  json["message"] = message_of(finding);
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

std::map<std::string, std::vector<Json>> diagnostics_by_uri(State& state, OpenDocument& document,
                                                            const CheckedDocument& checked) {
  std::map<std::string, std::vector<Json>> by_uri;
  by_uri[document.uri()] = companion_diagnostics(state, document);
  PlacesJson places(*checked.sources, state.client.encoding);
  std::unordered_map<std::string, Shown> shown;
  std::map<SourceId, std::string> uris;  // that findings in a file are shown at
  const auto uri_of = [&](const Diagnostic& finding) -> const std::string& {
    const auto known = uris.find(finding.where.source);
    if (known != uris.end()) return known->second;
    std::string uri = stands_in(document, checked, finding)
                          ? document.uri()
                          : uri_of_file(state, checked.sources->path(finding.where.source));
    return uris.emplace(finding.where.source, std::move(uri)).first->second;
  };
  for (const Diagnostic& finding : checked.result.diagnostics.list()) {
    Shown& cause = shown[cause_of(finding)];
    if (++cause.places > kMaxPlaces) continue;
    std::vector<Json>& list = by_uri[uri_of(finding)];
    list.push_back(diagnostic_json(state, finding, places));
    cause.list = &list;
    cause.last = list.size() - 1;
  }
  for (const auto& [key, cause] : shown) {
    if (cause.places <= kMaxPlaces) continue;
    Json& message = (*cause.list)[cause.last]["message"];
    message = message.get<std::string>() +
              fmt::format("\nand {} more places like this one", cause.places - kMaxPlaces);
  }
  return by_uri;
}

std::string diagnostic_key(const Json& diagnostic) {
  const auto number = [&diagnostic](std::string_view end, std::string_view coordinate) {
    return number_at(diagnostic, std::string_view("range"), end, coordinate);
  };
  return fmt::format("{}:{}-{}:{} {} {}", number("start", "line"), number("start", "character"),
                     number("end", "line"), number("end", "character"), text_at(diagnostic, "code"),
                     text_at(diagnostic, "message"));
}

}  // namespace rigor::lsp
