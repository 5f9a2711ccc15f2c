// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The text of a rule's example taken apart: its files, and where findings are expected.
//
//   ParsedExample bad = parse_example(rule.bad[0].text);
//   disk.put(example_path(bad.files[0]), bad.files[0].bytes);

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::rules {

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

/// The first file is named `model.sdf`, `robot.urdf` or `model.config`, by its root element. Throws
/// std::logic_error when marks do not pair: the text is part of the program.
ParsedExample parse_example(std::string_view text);

/// Where a file of an example lies in the in-memory disk: "demo/model.sdf".
std::string example_path(const ParsedExample::File& file);

}  // namespace rigor::rules
