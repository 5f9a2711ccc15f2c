// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The lines of several files of results, put back into the order of the run that they are parts of. Only where each
// line is stays in memory (32 bytes a line): the lines themselves are read again, one at a time.
//
//   Parts parts(disk);
//   for (const std::string& path : paths) if (const auto problem = parts.add(path)) return refuse(*problem);
//   const Completeness whole = parts.sort();
//   if (whole.missing == 0 && whole.doubled.empty()) parts.each([&](const Record& record) { writer.add(record); });

#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <rigor/results/record.h>
#include <rigor/text/disk.h>

namespace rigor::results {

/// A line that is larger is no result: the most that a file may have of findings takes some megabytes.
inline constexpr std::uint64_t kMaxLineBytes = std::uint64_t{256} << 20U;

/// Gaps and doubles are listed up to this many; all are counted.
inline constexpr std::size_t kMaxListedCases = 20;

struct Completeness {
  struct Doubled {
    ResultKind kind;
    std::uint64_t index;
    std::string first;  ///< "a.jsonl:3"
    std::string second;
  };
  struct Missing {
    ResultKind kind;
    std::uint64_t index;
  };
  std::uint64_t missing = 0;  ///< of all
  std::uint64_t doubled = 0;
  std::vector<Missing> first_missing;
  std::vector<Doubled> first_doubled;
};

class Parts {
 public:
  /// `disk` outlives this.
  explicit Parts(const Disk& disk) : disk_(disk) {}

  /// Why the file is no part, with its place: "a.jsonl:3: is not a result of a run"; nothing when it is one.
  std::optional<std::string> add(const std::string& path);

  /// By kind, those of `validate` first, then by case.
  Completeness sort();

  /// Every record in that order. Why one cannot be read; nothing when all were.
  std::optional<std::string> each(const std::function<void(const Record&)>& record) const;

  /// Of the whole run; 0 when there are none of that kind.
  std::uint64_t cases(ResultKind kind) const { return totals_[static_cast<std::size_t>(kind)]; }

 private:
  struct Line {
    std::uint64_t index;
    std::uint64_t begin;
    std::uint32_t size;
    std::uint32_t file;
    std::uint32_t number;
    ResultKind kind;
  };

  std::optional<std::string> add_line(std::string_view text, Line line);
  std::string where(const Line& line) const;

  const Disk& disk_;
  std::vector<std::string> files_;
  std::vector<Line> lines_;
  std::array<std::uint64_t, 2> totals_{};
};

}  // namespace rigor::results
