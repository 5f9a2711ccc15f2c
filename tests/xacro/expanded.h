// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Expands templates that lie in memory.

#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <rigor/text/disk.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/expand.h>
#include <rigor/xacro/print.h>

namespace rigor::test {

/// A template as `robot.xacro` beside other files, expanded.
struct Expanded {
  explicit Expanded(std::string text, std::map<std::string, std::string> files = {},
                    xacro::Options options = {}) {
    files["robot.xacro"] = std::move(text);
    disk = MemoryDisk(std::move(files));
    xacro::World world{disk};
    world.find_package = [](std::string_view name, std::string_view) -> std::optional<std::string> {
      if (name == "arm_description") return "packages/arm";
      return std::nullopt;
    };
    world.variable = [](std::string_view name) -> std::optional<std::string> {
      if (name == "ROBOT") return "r2";
      return std::nullopt;
    };
    world.working_folder = "/work";
    expansion = xacro::expand("robot.xacro", world, options, sources);
  }

  /// Without the declaration and the banner.
  std::string text() const {
    if (expansion.document == nullptr) return {};
    std::string printed = xacro::print(*expansion.document, "robot.xacro");
    for (int line = 0; line < 5; ++line) printed.erase(0, printed.find('\n') + 1);
    return printed;
  }

  /// The source's bytes that a span means.
  std::string bytes(Span span) const { return std::string(sources.bytes(span)); }

  /// "LINE:COLUMN words" of each finding.
  std::vector<std::string> findings() const {
    std::vector<std::string> lines;
    for (const xacro::Fact& fact : expansion.facts) {
      const Position at = sources.position(fact.where.source, fact.where.begin);
      lines.push_back(std::to_string(at.line) + ':' + std::to_string(at.column) + ' ' +
                      xacro::describe(fact));
    }
    return lines;
  }

  MemoryDisk disk;
  Sources sources;
  xacro::Expansion expansion;
};

/// A robot element around `inside`, on its line 2 and the following.
inline std::string robot(const std::string& inside) {
  return "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n" + inside + "\n</robot>\n";
}

/// For an attribute or a text.
inline std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return result;
}

}  // namespace rigor::test
