// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "command/edit/edit_version.h"

#include <fmt/core.h>

#include <rigor/read/load.h>
#include <rigor/read/template/template_expander.h>
#include <rigor/read/workspace.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/rules/environment.h>
#include <rigor/text/diff.h>

#include "command/command.h"
#include "output/atomic_file.h"
#include "output/moved_file.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

schema::Version version_of(const Environment& environment, const VersionRequest& request) {
  constexpr schema::Version kFirst{author::kOldestDowngrade};
  const auto version = schema::parse_version(request.version);
  if (!version || !environment.sdf.knows(*version) || *version < kFirst) {
    throw UsageError(fmt::format("VERSION {}: versions from {} to {} can be asked for",
                                 request.version, to_string(kFirst),
                                 to_string(environment.sdf.latest())));
  }
  return *version;
}

void tell_notes(const read::File& file, const author::Upgrade& result) {
  const LineTable lines(file.document ? file.document->bytes() : std::string_view());
  for (const author::UpgradeNote& note : result.notes) {
    if (note.severity == Severity::kInfo) continue;
    const std::string place =
        note.where.nowhere() ? "" : ':' + std::to_string(lines.position(note.where.begin).line);
    say(fmt::format("{}{}: {}: {}", report::printable(file.path), place, to_string(note.severity),
                    report::printable(note.message)));
  }
}

/// Whether it was done, and no diff is a finding.
bool change_version(const Environment& environment, const VersionRequest& request,
                    const std::string& path, schema::Version to) {
  Sources sources;
  read::Workspace workspace(environment.resolver, sources);
  const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
  const read::Loaded loaded = read::load(reader, workspace.open(path));
  if (!loaded.file->document) throw UsageError(path + ": " + loaded.file->problem);
  const author::Upgrade result = request.verb == VersionVerb::kUpgrade
                                     ? author::upgrade(environment, loaded, to)
                                     : author::downgrade(environment, loaded, to, request.losses);
  tell_notes(*loaded.file, result);
  if (result.refused()) {
    say("rigor: " + report::printable(path) + " is not changed");
    return false;
  }
  const bool is_checked = request.target == EditTarget::kCheckedDiff;
  const bool writes = request.target != EditTarget::kDiff && !is_checked;
  if (request.target == EditTarget::kOut) {
    write_moved(request.out, path, result.text);
  } else if (!result.edits.empty() && writes) {
    std::vector<FileReplacement> files{{path, loaded.file->document->bytes(), result.text}};
    if (const auto& config = result.config)
      files.push_back({config->path, config->before, config->text});
    replace_all_found(request.named, files);
  } else if (!writes) {
    std::string diff = unified_diff(path, loaded.file->document->bytes(), result.edits);
    if (const auto& config = result.config)
      diff += unified_diff(config->path, config->before, config->edits);
    write({0, {}}, diff);
  }
  const std::string& result_path = request.target == EditTarget::kOut ? request.out : path;
  say(fmt::format("rigor: {} {} SDF {}, from {}: {}, the same model",
                  report::printable(result_path), writes ? "is" : "would be", to_string(to),
                  to_string(result.from), report::counted(result.edits.size(), "change")));
  return !is_checked || (result.edits.empty() && !result.config);
}

}  // namespace

int change_version(const Environment& environment, const VersionRequest& request) {
  const schema::Version to = version_of(environment, request);
  if (request.target == EditTarget::kOut && request.files.size() > 1)
    throw UsageError("--out takes one file");
  bool done = true;
  for (const std::string& path : request.files) {
    if (read::is_template(path)) throw UsageError(path + " is a template: expand it first");
    done = change_version(environment, request, path, to) && done;
  }
  return done ? kClean : kFindings;
}

}  // namespace rigor::tool
