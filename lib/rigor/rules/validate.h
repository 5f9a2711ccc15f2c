// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks files: reads each, runs the rules over it, and says what was and what was not looked at.
//
//   ValidateResult result = validate(environment, {.paths = {"my_robot"}}, sources);
//   std::fputs(report::concise(result.diagnostics, sources).c_str(), stdout);

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rigor/environment.h>
#include <rigor/model/model.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>

namespace rigor::rules {

/// Which rules run, and how severe they are.
struct Selection {
  std::vector<std::string> select;  ///< rule or category names; all when empty
  std::vector<std::string> ignore;
  std::vector<std::pair<std::string, Severity>> severity;  ///< overrides, by rule name
  /// Findings of one rule in one file that are listed; one more says how many were counted only.
  /// Nobody reads a thousand, and a hostile file turns each of its elements into one.
  std::size_t most_listed = 1000;
};

/// The first name in the selection that is no rule and no category; nothing when all are known.
std::optional<std::string> unknown_name(const Selection& selection, const Registry& registry);

enum class MeshPolicy : std::uint8_t { kOpen, kDoNotOpen };

struct ValidateOptions {
  /// Files and folders, as the user wrote them. A folder is walked for what it holds.
  std::vector<std::string> paths;
  Selection selection;
  MeshPolicy meshes = MeshPolicy::kOpen;
  /// Bytes to check instead of a file's, under the name given here: an editor's buffer, or stdin.
  struct Buffer {
    std::string path;
    std::string bytes;
  };
  std::optional<Buffer> buffer;
};

/// One file that was checked, and what it holds.
struct FileSummary {
  std::string path;
  model::Format format = model::Format::kUnknown;
  std::string version;  ///< as written; empty when there is none
  std::size_t models = 0;
  std::size_t links = 0;
  std::size_t joints = 0;
};

/// Something that was met and not looked at, and why: "include of https://… needs the network".
struct NotLookedAt {
  std::string path;
  std::string what;
};

struct ValidateResult {
  std::vector<FileSummary> files;  ///< in the order of their paths
  Diagnostics diagnostics;         ///< sorted by file, then place
  std::vector<NotLookedAt> not_looked_at;
  /// Arguments that could not be used at all: they do not exist, cannot be read, or hold nothing to
  /// check. The invocation is wrong then.
  std::vector<std::string> unusable;
};

ValidateResult validate(const Environment& environment, const ValidateOptions& options,
                        Sources& sources);

}  // namespace rigor::rules
