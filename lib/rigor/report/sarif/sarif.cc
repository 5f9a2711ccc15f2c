// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/sarif/sarif.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/report/fingerprint.h>
#include <rigor/report/json/values.h>
#include <rigor/report/sarif/rules.h>
#include <rigor/report/sarif/text.h>
#include <rigor/report/tool.h>
#include <rigor/text/path.h>

namespace rigor::report {
namespace {

constexpr std::string_view kSarifSchema = "https://json.schemastore.org/sarif-2.1.0.json";
/// Of a result: GitHub refuses a log with more.
constexpr std::size_t kMaxLocations = 1000;
constexpr std::string_view kSourceRoot = "SRCROOT";

class SarifLog {
 public:
  explicit SarifLog(const Validation& validation)
      : validation_(validation),
        places_(validation.sources),
        rules_(sarif_rules(validation)),
        ids_(finding_ids(validation)) {
    find_line_hashes();
  }

  std::string text() {
    Json results = Json::array();
    for (const Diagnostic& diagnostic : findings()) {
      results.push_back(result(diagnostic, ids_[results.size()]));
    }
    Json artifacts = Json::array();
    for (const rules::FileSummary& file : validation_.result.files) {
      artifacts.push_back(
          {{"location", artifact(file.path)}, {"roles", Json::array({"analysisTarget"})}});
    }
    Json run = {{"tool",
                 {{"driver",
                   {{"name", kToolName},
                    {"semanticVersion", tool_version()},
                    {"rules", std::move(rules_.descriptors)}}}}},
                {"columnKind", "unicodeCodePoints"},
                {"originalUriBaseIds",
                 {{kSourceRoot, {{"description", {{"text", "The top of the repository."}}}}}}},
                {"invocations", Json::array({invocation()})},
                {"artifacts", std::move(artifacts)},
                {"results", std::move(results)}};
    const Json log = {
        {"$schema", kSarifSchema}, {"version", "2.1.0"}, {"runs", Json::array({std::move(run)})}};
    return log.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  }

 private:
  const std::vector<Diagnostic>& findings() const { return validation_.result.diagnostics.list(); }

  void find_line_hashes() {
    std::map<SourceId, std::set<std::uint32_t>> lines;
    for (const Diagnostic& diagnostic : findings()) {
      if (diagnostic.where.nowhere()) continue;
      lines[diagnostic.where.source].insert(places_.begin(diagnostic.where).line);
    }
    for (const auto& [source, wanted] : lines) {
      line_hashes_.emplace(source, line_hashes(places_.bytes(source), wanted));
    }
  }

  Json artifact(std::string_view path) const {
    const std::string relative = project_path(validation_, path);
    if (is_absolute(relative)) return {{"uri", "file://" + percent_encoded(relative)}};
    return {{"uri", percent_encoded(relative)}, {"uriBaseId", kSourceRoot}};
  }

  Json region(Span span) {
    const Position begin = places_.begin(span);
    const Position end = places_.end(span);
    return {{"startLine", begin.line},
            {"startColumn", begin.column},
            {"endLine", end.line},
            {"endColumn", end.column}};
  }

  Json physical(Span span, std::string_view path) {
    if (span.nowhere()) return {{"artifactLocation", artifact(path)}};
    Json marked = region(span);
    // Nothing would be marked of a place between two characters.
    if (span.begin == span.end) marked["endColumn"] = marked["endColumn"].get<std::uint32_t>() + 1;
    return {{"artifactLocation", artifact(places_.path(span))}, {"region", std::move(marked)}};
  }

  Json related_of(const Diagnostic& diagnostic) {
    Json related = Json::array();
    std::size_t id = 0;
    for (const Label& label : diagnostic.related) {
      ++id;
      if (label.where.nowhere()) continue;
      related.push_back({{"id", id},
                         {"physicalLocation", physical(label.where, {})},
                         {"message", {{"text", label.message}}}});
    }
    return related;
  }

  Json fix(const Fix& fix) {
    std::map<SourceId, Json> changes;
    for (const Edit& edit : fix.edits) {
      Json& replacements = changes[edit.span.source];
      if (replacements.is_null()) replacements = Json::array();
      Json replacement = {{"deletedRegion", region(edit.span)}};
      if (!edit.text.empty()) replacement["insertedContent"] = {{"text", edit.text}};
      replacements.push_back(std::move(replacement));
    }
    Json files = Json::array();
    for (auto& [source, replacements] : changes) {
      files.push_back({{"artifactLocation", artifact(validation_.sources.path(source))},
                       {"replacements", std::move(replacements)}});
    }
    return {{"description", {{"text", fix.title}}},
            {"artifactChanges", std::move(files)},
            {"properties", {{"applicability", to_string(fix.applicability)}}}};
  }

  Json location(const Diagnostic& diagnostic) {
    Json json = {{"physicalLocation", physical(diagnostic.where, diagnostic.path)}};
    if (!diagnostic.subject.empty()) {
      json["logicalLocations"] = Json::array({{{"fullyQualifiedName", diagnostic.subject}}});
    }
    return json;
  }

  Json result(const Diagnostic& diagnostic, const std::string& id) {
    Json json = {{"ruleId", diagnostic.rule}};
    const auto rule = rules_.index.find(diagnostic.rule);
    if (rule != rules_.index.end()) json["ruleIndex"] = rule->second;
    json["level"] = sarif_level(diagnostic.severity);
    json["message"] = {{"text", sarif_message(diagnostic)}};
    json["locations"] = Json::array({location(diagnostic)});
    for (const Diagnostic& other : diagnostic.others) {
      if (json["locations"].size() == kMaxLocations) break;
      json["locations"].push_back(location(other));
    }
    Json related = related_of(diagnostic);
    if (!related.empty()) json["relatedLocations"] = std::move(related);
    json["partialFingerprints"] = fingerprints(diagnostic, id);
    if (!diagnostic.fixes.empty() && !diagnostic.fixes.front().edits.empty()) {
      json["fixes"] = Json::array({fix(diagnostic.fixes.front())});
    }
    return json;
  }

  Json fingerprints(const Diagnostic& diagnostic, const std::string& id) {
    Json prints = Json::object();
    if (!diagnostic.where.nowhere()) {
      const auto& lines = line_hashes_.at(diagnostic.where.source);
      const auto line = lines.find(places_.begin(diagnostic.where).line);
      if (line != lines.end()) prints["primaryLocationLineHash"] = line->second;
    }
    prints["rigorId/v2"] = id;
    return prints;
  }

  /// What was not examined, and arguments that could not be used, are notifications.
  Json invocation() const {
    Json json = {{"executionSuccessful", validation_.exit_code <= 1},
                 {"exitCode", validation_.exit_code}};
    for (const rules::NotLookedAt& item : validation_.result.not_looked_at) {
      json["toolExecutionNotifications"].push_back(
          {{"level", "note"},
           {"message", {{"text", "skipped: " + item.what}}},
           {"locations",
            Json::array({{{"physicalLocation", {{"artifactLocation", artifact(item.path)}}}}})}});
    }
    for (const std::string& argument : validation_.result.unusable) {
      json["toolConfigurationNotifications"].push_back(
          {{"level", "error"}, {"message", {{"text", argument}}}});
    }
    return json;
  }

  const Validation& validation_;
  Places places_;
  SarifRules rules_;
  std::vector<std::string> ids_;
  std::map<SourceId, std::map<std::uint32_t, std::string>> line_hashes_;
};

}  // namespace

std::string sarif(const Validation& ungrouped) {
  const rules::ValidateResult result = grouped(ungrouped.result, GroupScope::kRun);
  return SarifLog({result, ungrouped.sources, ungrouped.registry, ungrouped.folders,
                   ungrouped.exit_code})
      .text();
}

}  // namespace rigor::report
