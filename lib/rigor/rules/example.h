// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The examples of rules, and the text of one taken apart: its files, and where findings are expected.
// They are the files of `rules/<category>/<rule-name>/`, embedded by cmake/EmbedExamples.cmake.
//
//   const Examples examples = examples_of(rule);
//   ParsedExample bad = parse_example(examples.bad[0].text);
//   disk.put(example_path(bad.files[0]), bad.files[0].bytes);

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::rules {

struct Rule;

/// A document that shows the rule, or shows how it is avoided.
///
/// In a bad one the bytes that the finding points at are between « and »; the marks are taken out
/// before the text is used. A line `=== path` begins another file; what comes before the first such
/// line is the file that is checked. `fixed` is the checked file after the fix, where there is one.
struct Example {
  std::string_view text;
  std::string_view fixed = {};
};

struct Examples {
  std::vector<Example> bad;
  std::vector<Example> good;  ///< of its category, where the rule has none of its own
};

Examples examples_of(const Rule& rule);

struct ParsedExample {
  struct File {
    std::string path;  ///< in the example's folder
    std::string bytes;
  };
  /// What stood between « and », as bytes of the first file without the marks.
  struct Marked {
    std::uint32_t begin;
    std::uint32_t end;
    bool operator==(const Marked&) const = default;
  };

  std::vector<File> files;     ///< the first is the one that is checked
  std::vector<Marked> marked;  ///< in the order of their begins
};

/// The first file, unless a line `=== path` names it, is named `model.sdf`, `robot.urdf` or `model.config`, by its root element. Throws
/// std::logic_error when marks do not pair: the text is part of the program.
ParsedExample parse_example(std::string_view text);

/// Where a file of an example lies in the in-memory disk: "demo/model.sdf".
std::string example_path(const ParsedExample::File& file);

}  // namespace rigor::rules
