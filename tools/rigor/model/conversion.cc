// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "model/conversion.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include <rigor/read/load.h>
#include <rigor/report/conversion.h>
#include <rigor/report/robot_diff/robot_diff.h>
#include <rigor/report/terminal/concise.h>
#include <rigor/report/terminal/pretty.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/robot/compare.h>
#include <rigor/text/grouping.h>
#include <rigor/text/path.h>

#include "model/model_file.h"
#include "model/robot_file.h"
#include "option/rule_settings.h"
#include "output/atomic_file.h"

namespace rigor::tool {
namespace {

constexpr std::string_view kMjcfEnding = ".xml";
constexpr std::string_view kSceneFile = "scene.xml";

/// Without what a reader of the pretty report needs not be told: infos on what is not lost.
Diagnostics without_infos(const author::Conversion& result) {
  const convert::Notes& notes = result.account.notes;
  const auto tells_loss = [&notes](const Diagnostic& diagnostic) {
    return std::any_of(notes.begin(), notes.end(), [&](const convert::Note& note) {
      return note.outcome == convert::Outcome::kLost && note.where == diagnostic.where;
    });
  };
  Diagnostics list;
  for (const Diagnostic& diagnostic : result.diagnostics.list()) {
    if (diagnostic.severity != Severity::kInfo || tells_loss(diagnostic)) list.add(diagnostic);
  }
  return list;
}

/// Whether `--allow-loss` would write it: what the proof says against a result it does not excuse.
bool loss_alone_keeps_from_writing(const author::Conversion& result) {
  const auto& list = result.diagnostics.list();
  return result.text && std::none_of(list.begin(), list.end(), [](const Diagnostic& found) {
           return found.severity == Severity::kError &&
                  (found.rule == "convert-not-the-same" || found.rule == "convert-rejected");
         });
}

std::string format_word(model::Format format) {
  return format == model::Format::kSdf ? "SDF" : format == model::Format::kUrdf ? "URDF" : "MJCF";
}

/// One finding for one cause.
author::Conversion grouped_result(author::Conversion result) {
  result.diagnostics = grouped(result.diagnostics);
  return result;
}

}  // namespace

void ConversionCommand::declare(CLI::App& app) {
  app_ = &app;
  app.add_option("in", in_, "The model: a file, or a folder with a model.config")
      ->type_name("IN")
      ->required();
  app.add_option("-o,--out", out_, "Write the result there; to stdout when absent")
      ->type_name("FILE");
  app.add_flag("--allow-loss", allow_loss_, "Write the result even if a loss is an error");
  app.add_flag("--header", header_,
               "Begin the result with a comment: its source, and what was lost");
  app.add_flag("--verify", verify_, "Read the result again and compare (the default)");
  app.add_flag("--no-verify", no_verify_, "Do not");
  app.add_option("--check", check_, "Compare the result with this file instead of writing it")
      ->type_name("FILE");
  app.add_flag("-v,--verbose", verbose_, "Report what is exact, too");
  output_.declare(app, {"pretty", "concise", "json"}, "--report,--output");
  color_.declare(app);
  selection_.declare(app);
  search_.declare(app);
}

std::string ConversionCommand::result_name() const {
  return out_.empty() ? std::string("robot") + ending_ : std::string(file_name(out_));
}

std::string ConversionCommand::stem() const {
  const std::string name = result_name();
  return name.substr(0, name.rfind('.'));
}

void ConversionCommand::refuse_stdout_twice() const {
  if (!out_.empty() || !check_.empty()) return;
  const bool said = app_->count("--format") + app_->count("--report") > 0;
  const std::vector<Target> targets = output_.targets();
  const auto to_stdout = [](const Target& target) { return target.file.empty(); };
  if (said && std::any_of(targets.begin(), targets.end(), to_stdout)) {
    throw UsageError(
        "the model goes to stdout: write it with -o FILE, or the report with --report json:FILE");
  }
}

int ConversionCommand::run(const Convert& convert) const {
  refuse_stdout_twice();
  if (verify_ && no_verify_) throw UsageError("--verify and --no-verify exclude each other");
  if (!out_.empty() && !check_.empty())
    throw UsageError("--check and -o exclude each other: one compares, the other writes");

  const GuardedDisk disk = search_.disk({in_, check_});
  Environment environment(disk, search_.paths());
  search_.allow(environment.workers);
  Sources sources;
  read::Workspace workspace(environment.resolver, sources);
  const read::File& file = open_model(workspace, in_);
  const read::Loaded loaded =
      read::load({workspace, environment.resolver, environment.sdf, environment.urdf}, file);
  if (loaded.root.format != from_ || !file.document->complete()) {
    say("rigor: " + report::printable(file.path) +
        (file.document->complete() ? ": holds no " : ": is not well-formed ") + format_word(from_) +
        "; run `rigor validate` for details");
    return kFindings;
  }
  author::ConversionOptions options;
  const RuleSettings settings(selection_, search_.config(), environment.registry);
  options.selection = settings.selection_of_command(file.path);
  options.proof = no_verify_ || !check_.empty() ? author::Proof::kNone : author::Proof::kVerify;
  options.losses = allow_loss_ ? author::Losses::kAllowed : author::Losses::kRefused;
  if (header_) options.header = author::AccountHeader::kComment;
  options.out = !out_.empty() ? out_ : file.path + ending_;
  std::error_code error;
  options.working_folder = std::filesystem::current_path(error).string();
  author::Conversion result =
      grouped_result(convert(environment, sources, workspace, loaded, options));
  result.diagnostics = withheld(result.diagnostics, sources, disk.reach());
  if (!check_.empty()) return check(environment, sources, workspace, loaded, result);
  tell(result, sources);
  if (!result.text || result.diagnostics.count(Severity::kError) > 0) {
    const bool may_be_allowed = !allow_loss_ && loss_alone_keeps_from_writing(result);
    say(std::string("rigor: nothing is written") +
        (may_be_allowed ? "; --allow-loss writes it all the same" : ""));
    return kFindings;
  }
  write_result(result);
  return settings.fails(file.path, result.diagnostics) ? kFindings : kClean;
}

void ConversionCommand::tell(const author::Conversion& result, const Sources& sources) const {
  const Diagnostics shown = verbose_ ? result.diagnostics : without_infos(result);
  const bool to_stderr = out_.empty() && check_.empty();
  if (to_stderr) {
    std::string text = report::pretty(shown, sources, report::Color::kPlain);
    if (!text.empty()) text.pop_back();
    if (!text.empty()) say(text);
  }
  for (const Target& target : output_.targets()) {
    if (to_stderr && target.file.empty()) continue;
    switch (target.format) {
      case 0: write(target, report::pretty(shown, sources, color_.of(target))); break;
      case 1: write(target, report::concise(result.diagnostics, sources)); break;
      default: write(target, report::conversion_json({result, sources, in_}));
    }
  }
  const std::string summary = report::conversion_summary(result);
  if (!summary.empty()) say(summary);
}

/// The side files first: a result that names a file is never there without it.
void ConversionCommand::write_result(const author::Conversion& result) const {
  if (out_.empty() && !result.files.empty()) {
    throw UsageError("some of it goes into files next to the result: write it with -o FILE");
  }
  std::vector<std::string> places;
  for (const convert::SideFile& file : result.files) places.push_back(place_of(file));
  for (std::size_t i = 0; i < places.size(); ++i) {
    put_file(std::string(parent_path(out_)), places[i], result.files[i].bytes);
  }
  write({0, out_}, *result.text);
}

/// Its name, but for the scene of another robot in the same folder. Another file is not replaced while the result is new
/// there: it is another robot's mesh, or somebody's controllers.
std::string ConversionCommand::place_of(const convert::SideFile& file) const {
  const std::string folder(parent_path(out_));
  const std::string path = join_path(folder, file.name);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return file.name;
  std::ifstream stream(path, std::ios::binary);
  const std::string there((std::istreambuf_iterator<char>(stream)), {});
  if (there == file.bytes) return file.name;
  if (file.name == kSceneFile) {
    const bool own = there.find("<include file=\"" + result_name() + "\"/>") != std::string::npos;
    return own ? file.name : stem() + '_' + file.name;
  }
  if (std::filesystem::exists(out_, error)) return file.name;
  throw UsageError(path + " exists and is another file: write the result to another folder");
}

/// As robots, with the names that the conversion would have given, and what they tell simulators with what
/// the result would tell. What a format has no place for is no difference: a hand-kept file need not
/// hold it.
int ConversionCommand::check(const Environment& environment, Sources& sources,
                             read::Workspace& workspace, const read::Loaded& loaded,
                             const author::Conversion& result) const {
  RobotFiles files(environment, sources, workspace);
  const read::Loaded kept = files.load(check_);
  // Of MJCF the robot that the conversion makes of it: choices are no differences.
  const bool made = from_ == model::Format::kMjcf && result.text;
  const read::Loaded as_made =
      made ? read::load({workspace, environment.resolver, environment.sdf, environment.urdf},
                        workspace.put(loaded.file->path + ending_, *result.text))
           : read::Loaded{};
  const auto a =
      made ? files.robot(as_made, {}) : files.robot(loaded, loaded.root[result.model].name.value);
  const auto b = files.robot(kept, {});
  if (!a || !b) return kFindings;
  robot::Correspondence names = made ? robot::Correspondence{} : result.names;
  names.placement = robot::Placement::kReported;
  std::vector<robot::Difference> differences = robot::compare(*a, *b, names);
  bool settings_left_out = true;
  const bool has_settings =
      ending_ != kMjcfEnding;  // of a simulator whose words another format has
  if (result.text && has_settings) {
    const read::File& file =
        workspace.put(loaded.file->path + ".converted" + ending_, *result.text);
    const read::Loaded converted =
        read::load({workspace, environment.resolver, environment.sdf, environment.urdf}, file);
    auto settings = files.settings(converted, {}, kept, {});
    settings_left_out = !settings;
    for (robot::Difference& d : settings.value_or(std::vector<robot::Difference>{})) {
      d.span_a = {};  // in a text that nobody has
      differences.push_back(std::move(d));
    }
  }
  if (made) {
    for (robot::Difference& d : differences) d.span_a = {};  // in a text that nobody has
  }
  const report::RobotDiff diff{{loaded.file->path, *a},
                               {kept.file->path, *b},
                               differences,
                               sources,
                               settings_left_out ? report::kSettingsInWords : std::string_view()};
  for (const Target& target : output_.targets()) {
    write(target,
          target.format == 2 ? report::robot_diff_json(diff) : report::robot_diff_text(diff));
  }
  if (settings_left_out) say(std::string("not compared: ") + report::kSettingsInWords);
  say(differences.empty() ? "the same robot" : report::counted(differences.size(), "difference"));
  return differences.empty() ? kClean : kFindings;
}

NamedMeshes mesh_naming(const std::string& text, const std::vector<std::string>& schemes) {
  if (text.empty()) return {MeshNaming::kDefault, {}};
  if (text == "file") return {MeshNaming::kFile, {}};
  if (text == "keep") return {MeshNaming::kKeep, {}};
  std::string known;
  for (const std::string& scheme : schemes) {
    const std::string start = scheme + "://";
    if (text.starts_with(start) && text.size() > start.size()) {
      return {MeshNaming::kScheme, text.substr(start.size())};
    }
    known += start + "NAME, ";
  }
  throw UsageError("--mesh-uri " + text + ": it is " + known + "file or keep");
}

}  // namespace rigor::tool
