// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Results that are kept line by line while a long run goes on, so that one that was cut short can be
// resumed: each line is written in one piece, and a last one that is torn is thrown away.
//
//   ResultsFile results("runs.jsonl");
//   results.read([&](const KeptResult& kept, const std::string& where) { … });  // of --resume
//   results.open();                                                            // nothing refuses any more
//   results.add(index, line);
//   results.finish();

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/process/descriptor.h>
#include <rigor/results/record.h>
#include <rigor/text/diagnostic.h>

namespace rigor::tool {

/// What the line of a simulation says it is about, and how severe what it found is.
struct KeptResult {
  results::Case one;
  std::string model;
  std::vector<std::string> tests;
  std::optional<Severity> worst;
};

class ResultsFile {
 public:
  /// Nothing is kept when `path` is empty.
  explicit ResultsFile(std::string path) : path_(std::move(path)) {}
  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  /// What the file holds is to stay; nothing is changed yet. `each` is called with every line's result
  /// and where it is ("runs.jsonl:3"), and may throw. A UsageError when the file holds anything else.
  void read(const std::function<void(const KeptResult&, const std::string&)>& each);

  bool has(std::size_t index) const { return kept_.contains(index); }
  std::size_t kept() const { return kept_.size(); }

  /// From here on what was not read is gone. A UsageError when the file cannot be written; the same of
  /// the next two.
  void open();

  /// A line with its end.
  void add(std::size_t index, std::string_view line);

  /// Puts the lines in the order of their cases, if they are not: several jobs end in any order.
  void finish();

 private:
  /// Zero, or the error's number.
  int close();
  [[noreturn]] void fail(int error) const;

  std::string path_;
  bool keeps_ = false;
  std::uintmax_t whole_ = 0;  // bytes of the lines that were read
  std::set<std::size_t> kept_;
  std::vector<std::size_t> order_;  // the case of each line of the file
  process::Descriptor descriptor_{-1};
};

}  // namespace rigor::tool
