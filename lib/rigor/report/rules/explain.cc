// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/rules/explain.h>

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

#include <rigor/report/rules/list.h>
#include <rigor/rules/example.h>
#include <rigor/text/sources.h>

namespace rigor::report {
namespace {

constexpr std::size_t kTextWidth = 88;
constexpr std::string_view kIndent = "  ";
constexpr std::string_view kCodeIndent = "    ";

/// The words of a text in lines; an empty line stays one.
std::string wrapped(std::string_view text) {
  std::string out;
  std::string line;
  const auto flush = [&] {
    if (!line.empty()) out += std::string(kIndent) + line + '\n';
    line.clear();
  };
  while (!text.empty()) {
    if (text.starts_with("\n\n")) {
      flush();
      out += '\n';
    }
    text.remove_prefix(std::min(text.find_first_not_of(" \n"), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(" \n"));
    text.remove_prefix(word.size());
    const std::uint32_t length = count_code_points(line) + count_code_points(word);
    if (!line.empty() && length + 1 > kTextWidth) flush();
    if (!line.empty() && !word.empty()) line += ' ';
    line += word;
  }
  flush();
  return out;
}

std::string section(std::string_view title, std::string_view text) {
  return text.empty() ? "" : fmt::format("\n{}\n{}", title, wrapped(text));
}

/// The carets under one line of a file, if anything in it is marked.
std::string carets(const LineTable& table, std::uint32_t line,
                   const std::vector<rules::ParsedExample::Marked>& marked) {
  std::string signs;
  for (const rules::ParsedExample::Marked& mark : marked) {
    const Position begin = table.position(mark.begin);
    const Position end = table.position(mark.end);
    if (begin.line != line) continue;
    const std::uint32_t rest = count_code_points(table.line(line)) + 1;
    const std::uint32_t last = end.line == line ? end.column : rest;
    signs.resize(std::max<std::size_t>(signs.size(), begin.column - 1), ' ');
    signs.resize(std::max<std::size_t>(signs.size(), begin.column), '^');
    signs.resize(std::max<std::size_t>(signs.size(), last - 1), '^');
  }
  return signs.empty() ? signs : std::string(kCodeIndent) + signs + '\n';
}

std::string marked_code(std::string_view bytes,
                        const std::vector<rules::ParsedExample::Marked>& marked) {
  const LineTable table(bytes);
  std::string out;
  // What follows the last line break is no line of its own.
  const std::uint32_t count = table.line_count() - (bytes.ends_with('\n') ? 1U : 0U);
  for (std::uint32_t line = 1; line <= count; ++line) {
    const std::string_view text = table.line(line);
    if (!text.empty()) out += std::string(kCodeIndent);
    out += text;
    out += '\n' + carets(table, line, marked);
  }
  return out;
}

std::string example(std::string_view title, const rules::Example& source) {
  const rules::ParsedExample parsed = rules::parse_example(source.text);
  std::string out;
  for (std::size_t i = 0; i < parsed.files.size(); ++i) {
    const rules::ParsedExample::File& file = parsed.files[i];
    if (i == 0) {
      out +=
          fmt::format("\n{}: {}\n\n{}", title, file.path, marked_code(file.bytes, parsed.marked));
    } else {
      out += fmt::format("\n{}with {}\n\n{}", kIndent, file.path, marked_code(file.bytes, {}));
    }
  }
  if (!source.fixed.empty()) {
    out +=
        fmt::format("\nFixed: {}\n\n{}", parsed.files.front().path, marked_code(source.fixed, {}));
  }
  return out;
}

}  // namespace

std::string explain(const rules::Rule& rule, const rules::Examples& examples) {
  std::string out = fmt::format("{}: {}\n\n", rule.name, rule.summary);
  out += fmt::format("{}severity {}, category {}, formats {}, fix {}, since {}\n", kIndent,
                     to_string(rule.severity), to_string(rule.category), formats_name(rule.formats),
                     fix_name(rule.fix), rule.since);
  out += section("Why", rule.why);
  out += section("What to do", rule.what_to_do);
  for (const rules::Example& bad : examples.bad) out += example("Bad", bad);
  for (const rules::Example& good : examples.good) out += example("Good", good);
  return out;
}

}  // namespace rigor::report
