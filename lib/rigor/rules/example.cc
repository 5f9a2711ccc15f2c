// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/example.h>

#include <algorithm>
#include <stdexcept>

#include <rigor/rules/embedded_examples.h>
#include <rigor/rules/rule.h>

namespace rigor::rules {
namespace {

constexpr std::string_view kOpen = "«";
constexpr std::string_view kClose = "»";
constexpr std::string_view kNextFile = "=== ";

bool is_name_byte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '-';
}

/// The name in the first start tag; comments and declarations are no tags.
std::string_view root_name(std::string_view bytes) {
  for (std::size_t at = bytes.find('<'); at != std::string_view::npos; at = bytes.find('<', at)) {
    ++at;
    std::size_t end = at;
    while (end < bytes.size() && is_name_byte(bytes[end])) ++end;
    if (end > at && bytes[at] != '-') return bytes.substr(at, end - at);
    if (bytes.substr(at).starts_with("!--")) at = std::min(bytes.find("-->", at), bytes.size());
  }
  return {};
}

std::string default_name(std::string_view bytes) {
  const std::string_view root = root_name(bytes);
  if (root == "robot") return "robot.urdf";
  if (root == "mujoco") return "model.xml";
  if (root == "model") return "model.config";
  return "model.sdf";
}

void take_marks_out(std::string_view text, ParsedExample& example) {
  std::string& bytes = example.files.front().bytes;
  std::vector<std::size_t> open;
  while (!text.empty()) {
    const auto here = static_cast<std::uint32_t>(bytes.size());
    if (text.starts_with(kOpen)) {
      open.push_back(example.marked.size());
      example.marked.push_back({here, here});
      text.remove_prefix(kOpen.size());
    } else if (text.starts_with(kClose)) {
      if (open.empty()) throw std::logic_error("example: » without «");
      example.marked[open.back()].end = here;
      open.pop_back();
      text.remove_prefix(kClose.size());
    } else {
      bytes += text.front();
      text.remove_prefix(1);
    }
  }
  if (!open.empty()) throw std::logic_error("example: « without »");
}

std::vector<Example> examples_of(std::string_view owner, ExampleKind kind) {
  std::vector<Example> found;
  for (const EmbeddedExample& each : embedded_examples()) {
    if (each.owner == owner && each.kind == kind) found.push_back(each.example);
  }
  return found;
}

}  // namespace

Examples examples_of(const Rule& rule) {
  Examples examples{examples_of(rule.name, ExampleKind::kBad),
                    examples_of(rule.name, ExampleKind::kGood)};
  if (examples.good.empty()) {
    examples.good = examples_of(to_string(rule.category), ExampleKind::kGood);
  }
  return examples;
}

ParsedExample parse_example(std::string_view text) {
  std::vector<ParsedExample::File> files(1);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    if (!line.starts_with(kNextFile)) {
      files.back().bytes += line;
      continue;
    }
    line.remove_prefix(kNextFile.size());
    while (line.ends_with('\n') || line.ends_with('\r') || line.ends_with(' ')) {
      line.remove_suffix(1);
    }
    const bool is_first = files.size() == 1 && files[0].bytes.empty() && files[0].path.empty();
    if (!is_first) files.emplace_back();
    files.back().path = line;
  }
  const std::string first = std::move(files.front().bytes);
  ParsedExample example{std::move(files), {}};
  take_marks_out(first, example);
  std::string& path = example.files.front().path;
  if (path.empty()) path = default_name(example.files.front().bytes);
  return example;
}

std::string example_path(const ParsedExample::File& file) { return "demo/" + file.path; }

}  // namespace rigor::rules
