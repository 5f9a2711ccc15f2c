// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <fmt/core.h>

#include <rigor/report/rules/list.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/rules/example.h>

namespace rigor::report {
namespace {

std::string table_cell(std::string_view cell) {
  std::string text;
  for (const char c : cell) {
    if (c == '|' || c == '<') text += '\\';
    text += c;
  }
  return text;
}

/// Angle brackets of prose would be taken for HTML.
std::string prose(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == '<' ? std::string("\\<") : std::string(1, c);
  return result;
}

/// The page stays text, whatever an example is about: a byte that is not UTF-8 is a sign.
std::string readable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Glyph glyph = first_glyph(text);
    const bool blank = text.front() == '\n' || text.front() == '\t';
    result += blank ? std::string(text.substr(0, 1)) : glyph.shown;
    text.remove_prefix(glyph.size);
  }
  return result;
}

std::string code_block(std::string_view title, std::string_view text) {
  const std::string_view end = text.ends_with('\n') ? "" : "\n";
  return fmt::format("\n{}\n\n```xml\n{}{}```\n", title, readable(text), end);
}

/// A rule's first example of each kind; `rigor explain` shows all.
std::string page(const rules::Rule& rule) {
  std::string out = fmt::format("\n## {}\n\n{} · {} · {} · fix: {} · since {}\n\n", rule.name,
                                to_string(rule.severity), to_string(rule.category),
                                formats_name(rule.formats), fix_name(rule.fix), rule.since);
  out += fmt::format("{}.\n\n{}\n\n{}\n", prose(rule.summary), prose(rule.why),
                     prose(rule.what_to_do));
  const auto [bad, good] = rules::examples_of(rule);
  if (!bad.empty()) {
    out += code_block("Bad:", rules::parse_example(bad.front().text).files.front().bytes);
    if (!bad.front().fixed.empty()) out += code_block("Fixed:", bad.front().fixed);
  }
  if (!good.empty() && (bad.empty() || bad.front().fixed.empty())) {
    out += code_block("Good:", rules::parse_example(good.front().text).files.front().bytes);
  }
  return out;
}

}  // namespace

std::string rules_markdown(const rules::Registry& registry) {
  std::string out =
      "# Rules\n\n| rule | category | severity | fix | what is wrong |\n|---|---|---|---|---|\n";
  for (const rules::Rule& rule : registry.rules()) {
    out += fmt::format("| [{0}](#{0}) | {1} | {2} | {3} | {4} |\n", rule.name,
                       to_string(rule.category), to_string(rule.severity), fix_name(rule.fix),
                       table_cell(rule.summary));
  }
  for (const rules::Rule& rule : registry.rules()) out += page(rule);
  return out;
}

}  // namespace rigor::report
