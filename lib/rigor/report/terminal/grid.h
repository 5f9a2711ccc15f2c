// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Rows of cells for a terminal, padded to the width of their column.
//
//   Grid grid;
//   grid.row({"link", "mass, kg"});
//   grid.row({"wheel", "0.4"});
//   out += grid.text();

#pragma once

#include <string>
#include <vector>

namespace rigor::report {

class Grid {
 public:
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  /// A line under the last row, as it is.
  void note(std::string text) { rows_.push_back({"    " + std::move(text)}); }

  /// Two spaces between columns, none at a line's end.
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace rigor::report
