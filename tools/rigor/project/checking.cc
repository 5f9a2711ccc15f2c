// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "project/checking.h"

#include <algorithm>
#include <cstdio>

#include <rigor/read/workspace.h>
#include <rigor/text/path.h>

#include "command/command.h"

namespace rigor::tool {
namespace {

/// All of stdin, and one byte more than a model may have at most: enough to tell.
std::string read_stdin() {
  std::string bytes;
  char buffer[65536];
  while (bytes.size() <= read::kMaxModelBytes) {
    const std::size_t count = std::fread(buffer, 1, sizeof(buffer), stdin);
    if (count == 0) break;
    bytes.append(buffer, count);
  }
  return bytes;
}

/// Whether an argument is a file that nobody can read: then the invocation is wrong.
bool names_unreadable(const std::vector<std::string>& paths, const rules::ValidateResult& result) {
  const auto& found = result.diagnostics.list();
  return std::any_of(found.begin(), found.end(), [&paths](const Diagnostic& diagnostic) {
    return diagnostic.rule == "file-unreadable" &&
           std::count(paths.begin(), paths.end(), diagnostic.path) > 0;
  });
}

}  // namespace

std::vector<std::string> CheckArguments::named() const {
  std::vector<std::string> all;
  for (const std::string& path : paths) {
    if (path != "-") all.push_back(path);
  }
  if (std::count(paths.begin(), paths.end(), "-") > 0) {
    all.push_back(stdin_filename.empty() ? "<stdin>" : stdin_filename);
  }
  if (all.empty()) all.emplace_back(".");
  return all;
}

Checking::Checking(const CheckArguments& a, const Disk& disk)
    : arguments_(a),
      environment_(disk, a.search.paths(a.named())),
      reach_(a.named(), environment_.resolver.paths()),
      settings_(a.selection, a.search.config(), environment_.registry),
      changed_(a.changed_since.changed(a.paths.empty() ? std::vector<std::string>{"."} : a.paths)),
      cache_(a.cache.cache(environment_.workers)),
      turns_(a.jobs),
      reads_(disk, environment_.workers, turns_),
      surveys_(disk, {cache_ ? &*cache_ : nullptr, &reads_}),
      mesh_files_(disk, mass::MeshDepth::kFile, {cache_ ? &*cache_ : nullptr, &reads_}) {
  a.search.allow(environment_.workers);
  choose_files(disk);
  options_.selection_for = [this, compat = a.compat.compat()](const std::string& path) {
    rules::Selection selection = settings_.selection(path);
    selection.compat = compat;
    return selection;
  };
  options_.shard = a.shard.shard();
  options_.meshes = a.no_mesh ? rules::MeshPolicy::kLeaveOut : rules::MeshPolicy::kOpen;
  options_.known = {&surveys_, &mesh_files_, &turns_};
}

void Checking::refuse_bad_settings() const {
  for (const std::string& path : options_.paths) settings_.selection(path);
}

rules::ValidateResult Checking::run(Sources& sources) const {
  rules::ValidateResult result = rules::validate(environment_, options_, sources);
  result.diagnostics = withheld(result.diagnostics, sources, reach_);
  return result;
}

int Checking::exit_code(const rules::ValidateResult& result) const {
  if (!result.unusable.empty() || names_unreadable(arguments_.paths, result)) return kUsage;
  return settings_.fails(result) ? kFindings : kClean;
}

std::optional<std::string> Checking::nothing_changed() const {
  return changed_ ? changed_->nothing() : std::nullopt;
}

void Checking::choose_files(const Disk& disk) {
  const CheckArguments& a = arguments_;
  options_.discover = a.files.discover();
  options_.discover.excluded = [&config = a.search.config()](const std::string& path,
                                                             PathKind kind) {
    return config.why_excluded(path, kind);
  };
  if (changed_) {
    options_.discover.wanted = [this, &disk](const std::string& path) {
      return changed_->concern(disk, environment_.resolver, path);
    };
  }
  options_.arguments_for = [&config = a.search.config()](const std::string& path) {
    std::vector<read::TemplateArguments> sets;
    const std::string absolute = config.absolute(path);
    for (const config::TemplateArguments& each : config.of(path).templates) {
      if (each.file.value == absolute) sets.insert(sets.end(), each.sets.begin(), each.sets.end());
    }
    return sets;
  };
  options_.argument_sets =
      a.all_arguments ? rules::ArgumentSets::kAll : rules::ArgumentSets::kGiven;
  for (const std::string& path : a.paths) {
    if (path != "-") {
      options_.paths.push_back(path);
    } else if (!options_.buffer) {
      options_.buffer = {a.stdin_filename.empty() ? "<stdin>" : a.stdin_filename, read_stdin()};
      if (options_.buffer->bytes.size() > read::kMaxModelBytes) {
        throw UsageError("stdin exceeds the limit of 64 MiB for a model");
      }
    }
  }
  if (!a.stdin_filename.empty() && !options_.buffer) {
    throw UsageError("--stdin-filename needs - among the paths");
  }
  if (options_.paths.empty() && !options_.buffer) options_.paths.push_back(".");
}

}  // namespace rigor::tool
