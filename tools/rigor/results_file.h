// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Results that are kept line by line while a long run goes on, so that one that was cut short can be
// resumed: each line is written in one piece, and a last one that is torn is thrown away.

#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace rigor::tool {

/// The number of a result's case among all of them, and how many there are; from its line.
struct CaseNumber {
  std::size_t index = 0;
  std::size_t of = 0;
  std::string id;
};

/// Nothing when the line is no result.
std::optional<CaseNumber> case_of(std::string_view line);

class ResultsFile {
 public:
  /// Nothing is kept when `path` is empty. What stands in the file stays when `resume`; a UsageError
  /// when it holds anything but results.
  ResultsFile(std::string path, bool resume);
  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  bool has(std::size_t index) const { return done_.contains(index); }

  /// A line with its end. A UsageError when it cannot be written.
  void add(std::string_view line);

 private:
  void read_what_is_there();

  std::string path_;
  std::set<std::size_t> done_;
  int descriptor_ = -1;
};

}  // namespace rigor::tool
