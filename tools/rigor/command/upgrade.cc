// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor upgrade PATH... --to VERSION`: SDF files brought to a later version, their meaning kept.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/author/upgrade/upgrade.h>
#include <rigor/read/discover.h>
#include <rigor/read/load.h>
#include <rigor/read/template/template_expander.h>
#include <rigor/read/values.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/rules/environment.h>
#include <rigor/text/diff.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "option/search.h"
#include "output/atomic_file.h"
#include "output/moved_file.h"
#include "output/output.h"
#include "output/progress.h"

namespace rigor::tool {
namespace {

using author::UpgradeNote;
using author::UpgradeNoteKind;

class UpgradeCommand final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(
        program, "upgrade", "Convert SDF files to a later version without changing their meaning",
        {"rigor upgrade my_robot/model.sdf --to 1.9 --diff",
         "rigor upgrade models worlds --to 1.9 --write"});
    app->add_option("paths", paths_, "SDF files; folders, of which all SDF files are taken")
        ->required()
        ->type_name("PATH");
    app->add_option("--to", to_, "The version: 1.4 to 1.12")->required()->type_name("VERSION");
    auto* diff =
        app->add_flag("--diff", diff_, "Show what would change, and exit 1 when anything does");
    auto* write = app->add_flag("--write", write_, "Change the files in place");
    app->add_flag("-v,--verbose", verbose_, "Tell what is worth knowing as well");
    app->add_option("-o,--out", out_, "Where the result goes, of one file; to stdout when absent")
        ->type_name("FILE")
        ->excludes(diff)
        ->excludes(write);
    diff->excludes(write);
    search_.declare(*app);
    return app;
  }

  int run() override {
    const GuardedDisk real = search_.disk(paths_);
    const ProgressDisk disk(real);
    const Environment environment(disk, search_.paths());
    const schema::Version to = version_asked(environment);
    const std::vector<Named> files = files_of(disk);
    if (files.size() > 1 && !diff_ && !write_) {
      throw UsageError(report::counted(files.size(), "file") +
                       ": --diff shows and --write writes what changes");
    }
    for (const Named& file : files) {
      if (file.by_name) refuse_wrong_file(environment, file.path, to);
    }
    int result = kClean;
    std::size_t changed = 0;
    for (const Named& file : files) {
      const Outcome outcome = upgrade(environment, file, to);
      if (outcome == Outcome::kChanged) ++changed;
      if (outcome == Outcome::kRefused || (outcome == Outcome::kChanged && diff_)) {
        result = kFindings;
      }
    }
    if (files.size() > 1) {
      say(fmt::format("rigor: {} of {} {} {}", changed, report::counted(files.size(), "file"),
                      write_ ? "brought to" : "would be brought to", to_string(to)));
    }
    return result;
  }

 private:
  enum class Outcome : std::uint8_t { kUnchanged, kChanged, kRefused };

  struct Named {
    std::string path;
    bool by_name;  // not found in a folder: then what is no SDF of an older version is an error
  };

  schema::Version version_asked(const Environment& environment) const {
    // What older readers want, 1.2 and 1.3, nobody writes any more.
    constexpr schema::Version kFirst{4};
    const auto version = schema::parse_version(to_);
    if (!version || !environment.sdf.knows(*version) || *version < kFirst) {
      throw UsageError(fmt::format("--to {}: versions from {} to {} can be asked for", to_,
                                   to_string(kFirst), to_string(environment.sdf.latest())));
    }
    return *version;
  }

  std::vector<Named> files_of(const Disk& disk) const {
    std::vector<Named> files;
    for (const std::string& path : paths_) {
      const PathKind kind = disk.kind(path);
      if (kind == PathKind::kMissing) throw UsageError(path + ": no such file");
      if ((write_ || diff_) && read::is_template(path)) {
        throw UsageError(path + " is a template: name the result with --out, or expand it first");
      }
      if (kind != PathKind::kFolder) {
        files.push_back({path, true});
        continue;
      }
      read::DiscoverOptions options;
      options.excluded = [this](const std::string& inside, PathKind inside_kind) {
        return search_.config().why_excluded(inside, inside_kind);
      };
      for (const std::string& found : read::discover(disk, {path}, options).files) {
        const std::string ending = extension(found);
        if (ending == ".sdf" || ending == ".world") files.push_back({found, false});
      }
    }
    if (files.empty()) throw UsageError("no SDF file in " + paths_.front());
    return files;
  }

  Outcome upgrade(const Environment& environment, const Named& file, schema::Version to) const {
    Sources sources;
    read::Workspace workspace(environment.disk, sources);
    const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
    const read::Loaded loaded = read::load(reader, workspace.open(file.path));
    const author::Upgrade result = author::upgrade(environment, loaded, to);
    const bool newer = !file.by_name && is_newer(result);
    if (!newer) tell(*loaded.file, result);
    if (result.refused()) return newer ? Outcome::kUnchanged : Outcome::kRefused;
    if (diff_) {
      rigor::tool::write({0, {}},
                         unified_diff(file.path, loaded.file->document->bytes(), result.edits) +
                             diff_of(result.config));
    } else if (!out_.empty()) {
      write_moved(out_, file.path, result.text);
    } else if (!write_) {
      rigor::tool::write({0, {}}, result.text);
    } else if (!result.edits.empty()) {
      replace_both(file.path, *loaded.file->document, result);
    }
    if (result.edits.empty()) return Outcome::kUnchanged;
    if (write_ || !out_.empty()) {
      const bool both = write_ && result.config;
      say(fmt::format("rigor: {} is SDF {} now, from {}: {}{}{}",
                      report::printable(out_.empty() ? file.path : out_), to_string(to),
                      to_string(result.from), report::counted(result.edits.size(), "change"),
                      both ? " and its model.config" : "", remarks(result)));
    }
    return Outcome::kChanged;
  }

  static std::string diff_of(const std::optional<author::FileChange>& change) {
    return change ? unified_diff(change->path, change->before, change->edits) : "";
  }

  /// The model.config too, where it goes along.
  void replace_both(const std::string& path, const xml::Document& before,
                    const author::Upgrade& result) const {
    std::vector<FileReplacement> files{{path, before.bytes(), result.text}};
    if (const auto& config = result.config)
      files.push_back({config->path, config->before, config->text});
    replace_all_found(paths_, files);
  }

  /// How many notes were not reported.
  std::string remarks(const author::Upgrade& result) const {
    const auto count =
        std::count_if(result.notes.begin(), result.notes.end(),
                      [](const UpgradeNote& note) { return note.severity == Severity::kInfo; });
    if (verbose_ || count == 0) return {};
    return ", " + report::counted(static_cast<std::size_t>(count), "remark") + " with --verbose";
  }

  static bool is_newer(const author::Upgrade& result) {
    return !result.notes.empty() && result.notes.front().kind == UpgradeNoteKind::kNewer;
  }

  /// What is wrong with the invocation rather than with a file, before any file is changed.
  static void refuse_wrong_file(const Environment& environment, const std::string& path,
                                schema::Version to) {
    Sources sources;
    read::Workspace workspace(environment.disk, sources);
    const read::File& file = workspace.open(path);
    if (!file.document) throw UsageError(path + ": " + file.problem);
    const auto root = file.document->root();
    if (!root) return;
    const auto version = read::attribute_text(*root, "version");
    const auto parsed =
        version ? schema::parse_version(read::trimmed(version->text)) : std::nullopt;
    if (root->name() == "robot") {
      throw UsageError(path + ": is URDF; convert it with rigor urdf2sdf");
    }
    if (root->name() != "sdf" && root->name() != "gazebo") {
      throw UsageError(path + ": is not an SDF file");
    }
    if (parsed && *parsed > to) {
      throw UsageError(
          fmt::format("{}: is SDF {}; models are brought to later versions only, and {} "
                      "is older",
                      path, to_string(*parsed), to_string(to)));
    }
  }

  void tell(const read::File& file, const author::Upgrade& result) const {
    const std::string path = report::printable(file.path);
    const LineTable lines(file.document ? file.document->bytes() : std::string_view());
    for (const UpgradeNote& note : result.notes) {
      if (note.severity == Severity::kInfo && !verbose_) continue;
      std::string place;
      if (!note.where.nowhere()) {
        const Position at = lines.position(note.where.begin);
        place = fmt::format(":{}:{}", at.line, at.column);
      }
      say(fmt::format("{}{}: {}: {}", path, place, to_string(note.severity),
                      report::printable(note.message)));
    }
    if (result.refused()) say("rigor: " + path + " is unchanged");
  }

  std::vector<std::string> paths_;
  std::string to_;
  bool diff_ = false;
  bool write_ = false;
  bool verbose_ = false;
  std::string out_;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> upgrade_command() { return std::make_unique<UpgradeCommand>(); }

}  // namespace rigor::tool
