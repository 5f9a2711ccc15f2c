// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What one line of a run's results says, as data: of `rigor validate --output jsonl:FILE` a file that was checked, of
// `rigor simulate --output jsonl:FILE` a case that was simulated.
//
//   if (const auto record = record_of(line)) {
//     if (const auto* file = std::get_if<CheckedFile>(&*record)) count += file->findings.size();
//   }
//
// Numbers that a line leaves out are nothing here; a number that is not finite is nothing, too.

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace rigor::results {

/// A database that cannot be written or read, in the words of SQLite or of the system: the disk is full, the file is no
/// database of results.
class DatabaseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Which command wrote a line.
enum class ResultKind : std::uint8_t { kValidate, kSimulate };

/// Of all cases of a run; "validate" counts files.
struct Case {
  std::uint64_t index = 0;  ///< from 0
  std::uint64_t of = 0;
  std::string id;
};

/// Where a finding is; without lines where it is in no text.
struct Place {
  std::string path;
  std::optional<std::int64_t> line;    ///< from 1
  std::optional<std::int64_t> column;  ///< from 1, in code points
  std::optional<std::int64_t> end_line;
  std::optional<std::int64_t> end_column;
  std::string subject;  ///< "arm/link elbow"
  std::string message;
};

struct Finding {
  std::string rule;
  std::string category;
  std::string severity;  ///< "error", "warning" or "info"
  Place place;
  std::vector<Place> others;  ///< with the same rule and cause
};

/// A mesh file that was opened.
struct MeshFile {
  std::string path;
  std::string digest;  ///< of its bytes: 128 bits of XXH3 as 32 hexadecimal digits
  std::uint64_t bytes = 0;
  std::optional<std::uint64_t> triangles;  ///< nothing when it could not be read
  /// Corners of its bounds, in the file's own unit (meters where the format has one).
  std::optional<std::array<double, 3>> min;
  std::optional<std::array<double, 3>> max;
};

struct CheckedFile {
  Case one;
  std::string path;
  std::string kind;     ///< "sdf", "urdf", "model-config" or "unknown"
  std::string version;  ///< as written; empty when there is none
  std::uint64_t models = 0;
  std::uint64_t links = 0;
  std::uint64_t joints = 0;
  std::vector<std::string> skipped;  ///< what of it was not checked, and why
  std::vector<MeshFile> meshes;
  std::vector<Finding> findings;
};

struct Metric {
  std::string id;               ///< "tilt.max"
  std::optional<double> value;  ///< in `unit`
  std::string unit;             ///< empty for a ratio or a count
  std::optional<double> warn;   ///< limits, in `unit`
  std::optional<double> fail;
  std::string verdict;
};

struct Run {
  std::string test;
  std::int64_t seed = 0;
  std::string verdict;
  std::optional<double> duration;  ///< s, simulated
  std::uint64_t steps = 0;
  std::string state_hash;
  std::vector<Metric> metrics;
};

struct SimulatedCase {
  Case one;
  std::string model;    ///< path of its file
  std::string verdict;  ///< "pass", "warn", "solver", "fail" or "invalid"
  std::vector<std::string> skipped;
  std::vector<Run> runs;
  std::vector<Finding> findings;
};

using Record = std::variant<CheckedFile, SimulatedCase>;

}  // namespace rigor::results
