// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/add/add_template.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/embedded_templates.h>

namespace rigor::author {
namespace {

/// The line for each value of its placeholders; none where one has no value.
std::vector<std::string> filled_lines(std::string_view line, const TemplateValues& values) {
  const std::string indent(std::min(line.find_first_not_of(' '), line.size()), ' ');
  std::vector<std::string> lines{{}};
  std::size_t at = 0;
  while (true) {
    const std::size_t begin = line.find('@', at);
    const std::size_t end = begin == line.npos ? begin : line.find('@', begin + 1);
    for (std::string& each : lines) each += line.substr(at, (end == line.npos ? end : begin - at));
    if (end == line.npos) return lines;
    const auto found = values.find(std::string(line.substr(begin + 1, end - begin - 1)));
    if (found == values.end()) return {};
    std::vector<std::string> longer;
    for (const std::string& each : lines) {
      for (std::string value : found->second) {
        for (std::size_t i = 0; (i = value.find('\n', i)) != std::string::npos;)
          value.insert(++i, indent);
        longer.push_back(each + value);
      }
    }
    lines = std::move(longer);
    at = end + 1;
  }
}

}  // namespace

std::optional<std::string_view> add_template(std::string_view target, std::string_view name) {
  const std::string path = fmt::format("add/{}/{}.xml", target, name);
  for (const EmbeddedFile& file : embedded_templates()) {
    if (file.path == path) return file.text;
  }
  return std::nullopt;
}

std::string filled(std::string_view text, const TemplateValues& values) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    for (const std::string& line : filled_lines(text.substr(begin, end - begin), values))
      result += line + '\n';
    begin = end + 1;
  }
  if (!result.empty()) result.pop_back();
  return result;
}

}  // namespace rigor::author
