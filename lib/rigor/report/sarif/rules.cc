// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/sarif/rules.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include <rigor/convert/note.h>
#include <rigor/rules/rule.h>
#include <rigor/simulate/fact.h>

namespace rigor::report {
namespace {

/// GitHub refuses longer descriptions.
constexpr std::size_t kMaxDescription = 1024;

/// Whether `validate` runs it: any but the rules on conversions and simulations.
bool is_of_files(const rules::Rule& rule) {
  const auto other = [](const rules::Check& check) {
    using rules::FactCheck;
    return std::holds_alternative<FactCheck<convert::Note, convert::NoteKind>>(check) ||
           std::holds_alternative<FactCheck<simulate::Fact, simulate::FactKind>>(check);
  };
  return !std::all_of(rule.checks.begin(), rule.checks.end(), other);
}

std::string upper_camel(std::string_view kebab) {
  std::string name;
  bool begins = true;
  for (const char c : kebab) {
    const bool lower = c >= 'a' && c <= 'z';
    if (c != '-') name += begins && lower ? static_cast<char>(c - 'a' + 'A') : c;
    begins = c == '-';
  }
  return name;
}

/// As a sentence: summaries are written in lower case, without a full stop.
std::string sentence(std::string_view text) {
  std::string out(text);
  if (!out.empty() && out.front() >= 'a' && out.front() <= 'z') {
    out.front() = static_cast<char>(out.front() - 'a' + 'A');
  }
  if (!out.empty() && !out.ends_with('.')) out += '.';
  return out;
}

/// Not longer than GitHub takes, cut between characters.
std::string description(std::string text) {
  if (text.size() <= kMaxDescription) return text;
  constexpr std::string_view kCut = "…";
  std::size_t end = kMaxDescription - kCut.size();
  while ((static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end) + std::string(kCut);
}

/// Angle brackets of prose would be taken for HTML.
std::string markdown_prose(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '<' ? std::string("\\<") : std::string(1, c);
  return out;
}

/// What GitHub calls the severity of a finding; it has no "note" there.
std::string_view problem_severity(Severity severity) {
  return severity == Severity::kInfo ? "recommendation" : to_string(severity);
}

Json descriptor_of(const rules::Rule& rule) {
  const std::string summary = sentence(rule.summary);
  const std::string why = rule.why.empty() ? summary : std::string(rule.why);
  std::string text = why;
  std::string markdown = markdown_prose(summary) + "\n\n" + markdown_prose(rule.why);
  if (!rule.what_to_do.empty()) {
    text += "\n\n" + std::string(rule.what_to_do);
    markdown += "\n\n**What to do:** " + markdown_prose(rule.what_to_do);
  }
  markdown += "\n\n`rigor explain " + std::string(rule.name) + "` shows examples.";
  return {{"id", rule.name},
          {"name", upper_camel(rule.name)},
          {"shortDescription", {{"text", description(summary)}}},
          {"fullDescription", {{"text", description(why)}}},
          {"help", {{"text", text}, {"markdown", markdown}}},
          {"defaultConfiguration", {{"level", sarif_level(rule.severity)}}},
          {"properties",
           {{"tags", Json::array({to_string(rule.category)})},
            {"problem.severity", problem_severity(rule.severity)}}}};
}

}  // namespace

std::string_view sarif_level(Severity severity) {
  return severity == Severity::kInfo ? "note" : to_string(severity);
}

SarifRules sarif_rules(const Validation& validation) {
  std::set<std::string_view> reported;
  for (const Diagnostic& diagnostic : validation.result.diagnostics.list()) {
    reported.insert(diagnostic.rule);
  }
  SarifRules rules;
  for (const rules::Rule& rule : validation.registry.rules()) {
    if (!is_of_files(rule) && !reported.contains(rule.name)) continue;
    rules.index.emplace(rule.name, rules.index.size());
    rules.descriptors.push_back(descriptor_of(rule));
  }
  return rules;
}

}  // namespace rigor::report
