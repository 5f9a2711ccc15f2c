// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks files: reads each, runs the rules over it, and says what was and what was not examined.
//
//   ValidateResult result = validate(environment, {.paths = {"my_robot"}}, sources);
//   std::fputs(report::concise(result.diagnostics, sources).c_str(), stdout);

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/mass/mesh/opened_mesh.h>
#include <rigor/model/model.h>
#include <rigor/read/discover.h>
#include <rigor/read/resolver.h>
#include <rigor/rules/compat.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/meshes.h>
#include <rigor/rules/target.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/shard.h>
#include <rigor/text/sources.h>

namespace rigor::rules {

/// Which rules run, and how severe they are.
struct Selection {
  std::vector<std::string> select;  ///< rule or category names; all when empty
  std::vector<std::string> ignore;
  std::vector<std::pair<std::string, Severity>> severity;  ///< overrides, by rule or category
  Targets targets;                                         ///< consumers whose rules run as well
  /// Whose judgment decides what is an error; an override in `severity` goes before it.
  Compat compat = Compat::kNone;
  /// Findings of one rule in one file that are listed; one more says how many were counted only.
  /// Nobody reads a thousand, and a hostile file turns each of its elements into one.
  std::size_t max_listed = 1000;

  bool operator==(const Selection&) const = default;
};

/// The first name in the selection that is no rule and no category; nothing when all are known.
std::optional<std::string> unknown_name(const Selection& selection, const Registry& registry);

enum class MeshPolicy : std::uint8_t {
  kOpen,
  kDoNotOpen,  ///< of an assembled robot only the shapes are seen that are no meshes
  kLeaveOut,  ///< nor is a robot assembled that has meshes: rules of the category assembly leave it out
};

/// Whether a file's summary lists the meshes that its shapes use. Their digests take a read of each.
enum class MeshListing : std::uint8_t { kNone, kListed };

/// With which arguments templates are expanded: those that are given; or every value, of those that
/// conditionals depend on, at least once as well.
enum class ArgumentSets : std::uint8_t { kGiven, kAll };

/// Of templates the model that they make is checked, or only that they can be expanded.
enum class TemplateDepth : std::uint8_t { kModel, kExpansion };

struct ValidateOptions {
  /// Files and folders, as the user wrote them. A folder is walked for what it holds.
  std::vector<std::string> paths;
  read::DiscoverOptions discover;  ///< of which files
  /// The sets of arguments (`name:=value`) that the template at a path is expanded with, besides those that
  /// the resolver's paths have; none means these alone. Asked once a template, from one thread.
  std::function<std::vector<read::TemplateArguments>(const std::string& path)> arguments_for;
  ArgumentSets argument_sets = ArgumentSets::kGiven;
  TemplateDepth template_depth = TemplateDepth::kModel;
  Selection selection;
  /// The selection for the file at a path, where files differ; `selection` is for all when empty. Called
  /// once a file, from one thread.
  std::function<Selection(const std::string& path)> selection_for;
  MeshPolicy meshes = MeshPolicy::kOpen;
  MeshListing mesh_listing = MeshListing::kNone;
  /// What an earlier run over the same files knows of their meshes, and this one adds to; with turns, they say
  /// how many threads there are.
  Meshes known;
  unsigned threads = 1;  ///< 0: as many as there are cores; the result is the same for any number
  /// Only its part of the files is checked. What a file says of others is as if all were.
  Shard shard;
  /// Bytes to check instead of a file's, under the name given here: an editor's buffer, or stdin.
  struct Buffer {
    std::string path;
    std::string bytes;
  };
  std::optional<Buffer> buffer;
  /// Bytes that templates read instead of a file's, which is not checked by itself: what a fix would make of a
  /// file that they include.
  std::vector<Buffer> included;
};

/// One file that was checked, and what it holds.
struct FileSummary {
  std::string path;
  model::Format format = model::Format::kUnknown;
  std::string version;  ///< as written; empty when there is none
  std::size_t models = 0;
  std::size_t links = 0;
  std::size_t joints = 0;
  std::string part_of =
      {};                 ///< the template that includes this one, and through which it is checked
  std::size_t index = 0;  ///< among all files that the paths mean, those of other shards too
  /// Its findings: those from `first_finding` up to `end_finding` of all.
  std::size_t first_finding = 0;
  std::size_t end_finding = 0;
  /// With `MeshListing::kListed`: the files of its shapes' meshes that are there, sorted by path.
  std::vector<mass::OpenedMesh> meshes = {};
  /// Of a template: all files that its expansions read, itself among them, sorted; seen from the working
  /// folder of the resolver's paths.
  std::vector<std::string> reads = {};
};

/// Something that was met and not looked at, and why: "include of https://… needs the network".
struct NotLookedAt {
  std::string path;
  std::string what;
  /// Of a whole file that was left out: its number among all, behind those that are checked.
  std::optional<std::size_t> index = std::nullopt;
};

struct ValidateResult {
  std::vector<FileSummary> files;  ///< in the order of their paths
  Diagnostics diagnostics;         ///< file by file as `files`, sorted by place
  /// That the paths mean, those of other shards and those that are left out too.
  std::size_t all_files = 0;
  std::vector<NotLookedAt> not_looked_at;
  /// Arguments that could not be used at all: they do not exist, cannot be read, or hold nothing to
  /// check. The invocation is wrong then.
  std::vector<std::string> unusable;
};

ValidateResult validate(const Environment& environment, const ValidateOptions& options,
                        Sources& sources);

}  // namespace rigor::rules
