// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the lines that `--output jsonl:FILE` writes.
//
//   const auto head = head_of(line);   // which case of which run; the rest of the line is not read
//   const auto record = record_of(line);

#pragma once

#include <optional>
#include <string_view>

#include <rigor/results/record.h>

namespace rigor::results {

struct LineHead {
  ResultKind kind = ResultKind::kValidate;
  Case one;
};

/// Nothing when the line is no result, as far as it was read.
std::optional<LineHead> head_of(std::string_view line);

/// Of a line that is whole, whatever else it says; nothing when it is torn or names no case.
std::optional<Case> case_of(std::string_view line);

/// Nothing when the line is no result. What it has beyond a record is ignored: lines may say more in later versions.
std::optional<Record> record_of(std::string_view line);

}  // namespace rigor::results
