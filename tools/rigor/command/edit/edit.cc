// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor edit VERB …`: changes that a model's author asks for, as byte edits, with their proof. `rename` is here, the
// other verbs are in edit_verbs.cc.

#include "command/edit/edit.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <rigor/author/names/name_graph.h>
#include <rigor/author/names/parameter_names.h>
#include <rigor/author/names/rename.h>
#include <rigor/author/names/text_mentions.h>
#include <rigor/read/workspace.h>
#include <rigor/report/robot_diff/robot_diff.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/rules/environment.h>
#include <rigor/text/diff.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "command/edit/edit_version.h"
#include "command/edit/edit_workspace.h"
#include "command/edit/rename_target.h"
#include "model/expansion_map.h"
#include "model/model_file.h"
#include "option/search.h"
#include "output/atomic_file.h"
#include "output/moved_file.h"
#include "output/output.h"
#include "project/guarded_disk.h"

namespace rigor::tool {
namespace {

constexpr std::string_view kRename = "rename";
constexpr std::string_view kUpgrade = "upgrade";
constexpr std::string_view kDowngrade = "downgrade";

std::size_t count_of_words(std::string_view words) {
  if (words.empty()) return 0;
  return 1 + static_cast<std::size_t>(std::count(words.begin(), words.end(), ' '));
}

class EditCommand final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(
        program, "edit", "Change a model by byte edits, with a proof that nothing else changes",
        {"rigor edit rename wheel left_wheel robot.urdf",
         "rigor edit prefix left_ arm.urdf -o left_arm.urdf",
         "rigor edit attach arm.urdf gripper.urdf --to flange -o robot.urdf",
         "rigor edit remove camera_link robot.urdf --subtree --write",
         "rigor edit merge left.sdf right.sdf --pose '0 1 0 0 0 0' -o cell.sdf",
         "rigor edit simplify-collisions robot.urdf --max-error 0.01 --write",
         "rigor edit add diff-drive robot.urdf --target gz-sim"});
    for (const EditVerb& verb : edit_verbs()) names_.push_back(verb.name);
    names_.insert(names_.end(), {kRename, kUpgrade, kDowngrade});
    offer(
        app->add_option("verb", verb_, "What to do: " + fmt::format("{}", fmt::join(names_, ", ")))
            ->type_name("VERB")
            ->required(),
        names_);
    app->add_option(
           "words", words_,
           "What the verb takes, then the files: the model's first, or its folder, of attach "
           "the tool's, then others that refer to it by name, beside those of its "
           "repository or package, which are found")
        ->type_name("WORD");
    auto* write = app->add_flag("--write", write_, "Change the files");
    auto* diff = app->add_flag(
        "--diff", diff_, "Show what would change, as without it, and exit 1 where something would");
    app->add_option("-o,--out", out_, "Where the changed model goes, of a change of its file alone")
        ->type_name("FILE")
        ->excludes(write)
        ->excludes(diff);
    diff->excludes(write);
    app->add_option("--model", model_, "Name of one of several models in a file")
        ->type_name("NAME");
    declare_options(*app);
    search_.declare(*app);
    app->get_option("--isolated")
        ->description("Use no configuration, and change FILE alone: no other file is searched");
    return app;
  }

  int run() override {
    const std::size_t index = choice("verb of edit", verb_, names_);
    if (names_[index] == kRename) return rename();
    if (names_[index] == kUpgrade || names_[index] == kDowngrade) return change_version();
    const EditVerb& verb = edit_verbs()[index];
    const std::size_t count = count_of_words(verb.words);
    if (words_.size() <= count + (verb.takes_tool ? 1 : 0)) {
      throw UsageError("edit " + verb_ + " takes " + std::string(verb.words) +
                       (verb.words.empty() ? "" : " ") +
                       (verb.takes_tool ? "FILE TOOL..." : "FILE..."));
    }
    refuse_other_options(verb);
    EditRequest request;
    const auto first_file = words_.begin() + static_cast<std::ptrdiff_t>(count);
    request.words.assign(words_.begin(), first_file);
    request.files.assign(first_file, words_.end());
    if (verb.takes_tool) {
      request.tool = request.files[1];
      request.files.erase(request.files.begin() + 1);
    }
    request.out = out_;
    request.options = options_;
    return edit(verb, request);
  }

 private:
  void declare_options(CLI::App& app) {
    const auto text = [&app, this](const char* name, std::string& value, const char* what,
                                   const char* type) {
      given_.emplace_back(name, app.add_option(name, value, what)->type_name(type));
    };
    const auto flag = [&app, this](const char* name, bool& value, const char* what) {
      given_.emplace_back(name, app.add_flag(name, value, what));
    };
    flag("--subtree", options_.subtree, "Of remove: what the link carries, too");
    text("--to", options_.to,
         "Of attach and add: the link that carries it, or the joint; of move-frame: a pose, com or "
         "joint",
         "LINK");
    text("--pose", options_.pose,
         "Of attach and add: where it is in that link, in m and rad; at its frame when absent",
         "\"X Y Z R P Y\"");
    text("--target", options_.target,
         "Of add: gz-sim, gazebo-classic or ros; gz-sim when absent, of ros2_control and "
         "transmission ros",
         "NAME");
    text("--parameters", options_.parameters,
         "Of add ros2_control for a simulator: the controllers' YAML", "FILE");
    text("--joint", options_.joint, "Of attach: fixed, or revolute about the tool's z axis",
         "TYPE");
    text("--frame", options_.frame,
         "Of attach: a frame or link that the pose is relative to, and instead of --to", "FRAME");
    text("--tool-frame", options_.tool_frame,
         "Of attach: a frame or link of the tool that is put there rather than its own", "FRAME");
    flag("--include", options_.include,
         "Of attach in SDF and of merge: by <include> rather than by a copy");
    text("--macro", options_.macro,
         "Of attach, of a template: the macro of the tool's file that is called", "NAME");
    given_.emplace_back("--param",
                        app.add_option("--param", options_.macro_parameters,
                                       "Of attach: a parameter of that macro; may be repeated")
                            ->type_name("NAME=VALUE")
                            ->allow_extra_args(false));
    text("--prefix", options_.prefix, "Of attach: for the names of the tool", "PREFIX");
    text("--plane", options_.plane,
         "Of mirror: xz, yz or xy of the link that carries the part; xz when absent", "PLANE");
    text("--rename", options_.rename,
         "Of mirror: the image is a copy, with TO for FROM in its names", "FROM:TO");
    text("--take", options_.take,
         "Of split: what goes with the new link, as name,name or visual/2,collision/1", "NAMES");
    text("--mass", options_.mass,
         "Of split: of the new link, in kg, or shapes: as its shapes' volumes are", "KG");
    text("--name", options_.name, "Of split: of the new link; of merge: of the world", "NAME");
    text("--at", options_.frame,
         "Of split: where the new link is: a link, joint or frame, or a pose in the link", "FRAME");
    text("--max-error", options_.max_error,
         "Of simplify-collisions: two-sided distance, as a share of the link's size; default 0.02",
         "E");
    text("--from", options_.from,
         "Of simplify-collisions: visual gives links without a collision one", "PART");
    text("--kind", options_.kind,
         "Of rename: link, joint, frame or model, where several have the name", "KIND");
    flag("--allow-loss", options_.allow_loss,
         "Of downgrade: also what the older version has no word for");
    text("--lower", options_.lower, "Of a revolute joint: the lower limit, rad", "RAD");
    text("--upper", options_.upper, "Of a revolute joint: the upper limit, rad", "RAD");
    text("--effort", options_.effort, "Of a revolute joint: N·m", "N");
    text("--velocity", options_.velocity, "Of a revolute joint: rad/s", "V");
  }

  void refuse_other_options(const EditVerb& verb) const {
    for (const auto& [name, option] : given_) {
      if (option->count() > 0 &&
          (' ' + std::string(verb.options) + ' ').find(' ' + name + ' ') == std::string::npos)
        throw UsageError("edit " + verb_ + " has no option " + name);
    }
  }

  int edit(const EditVerb& verb, EditRequest& request) {
    search_.config().open();
    request.named = request.files;
    request.files = models_of(request.named);
    if (!request.tool.empty()) request.tool = models_of({request.tool}).front();
    const EditWorkspace workspace = workspace_of(request.files);
    const GuardedDisk disk = search_.disk(workspace.in_reach(words_));
    Environment environment(disk, search_.paths());
    search_.allow(environment.workers);
    Sources sources;
    author::ModelReader reader(environment, sources);
    const author::OpenedModel opened = reader.open(request.files.front(), model_);
    if (!opened.model) throw InputError(opened.problem);
    if (verb.searches)
      request.found = workspace.files_with(names_of(*opened.model), request.files, disk);
    const author::Change change = verb.change(request, reader, *opened.model);
    const author::ProvenChange proven = prove(reader, *opened.model, change);
    if (!proven.refused.empty())
      throw InputError(request.files.front() + " is not changed: " + proven.refused);
    for (const std::string& note : change.notes) say("rigor: " + report::printable(note));
    if (!change.product.empty()) return put_product(change.product);
    if (!proven.unasked.empty()) {
      tell(*opened.model, change.expected, proven, proven.unasked, sources);
      say("rigor: nothing is changed: " + report::counted(proven.unasked.size(), "difference") +
          " that nobody asked for");
      return kFindings;
    }
    refuse_other_files(request.files.front(), proven.files);
    emit_new(change.new_files, disk.reach());
    if (proven.files.empty()) {
      put_unchanged(request.files.front(), disk);
      return kClean;
    }
    emit(request.named, workspace, proven.files, sources);
    tell_others(request, proven);
    if (!verb.searches)
      tell_dangling(request, workspace, *opened.model, *proven.after, disk, sources);
    tell(*opened.model, opened.model->robot, proven, proven.asked, sources);
    std::size_t places = 0;
    for (const author::EditedFile& file : proven.files) places += file.edits.size();
    say("rigor: " + report::counted(places, "place") + " in " +
        report::counted(proven.files.size(), "file") +
        (write_ || !out_.empty() ? " changed: " : " would be changed: ") +
        report::counted(proven.asked.size(), "difference") + ", all as asked");
    return result_of_change();
  }

  /// Of a change that was made, or that --diff has shown.
  int result_of_change() const { return diff_ ? kFindings : kClean; }

  /// What is no edit of a file.
  int put_product(const std::string& text) const {
    if (write_) throw UsageError("edit " + verb_ + " makes a new file: name it with -o");
    if (out_.empty())
      write({0, {}}, text);
    else
      replace_file(out_, text);
    return kClean;
  }

  void emit_new(const std::vector<author::NewFile>& files, const Reach& reach) const {
    for (const author::NewFile& file : files) {
      if (!write_ && out_.empty()) {
        say("rigor: " + report::printable(file.path) + " would be written");
        continue;
      }
      if (!reach.holds(file.path)) {
        throw UsageError(file.path +
                         " is out of reach: name its package with --package or its folder "
                         "with --model-path");
      }
      put_file(std::string(parent_path(file.path)), file_name(file.path), file.bytes);
      say("rigor: " + report::printable(file.path) + " is written");
    }
  }

  int change_version() {
    if (words_.size() < 2) throw UsageError("edit " + verb_ + " takes VERSION FILE...");
    refuse_other_options({verb_, "", verb_ == kDowngrade ? "--allow-loss" : "", nullptr});
    VersionRequest request;
    request.verb = verb_ == kUpgrade ? VersionVerb::kUpgrade : VersionVerb::kDowngrade;
    request.version = words_.front();
    request.named.assign(words_.begin() + 1, words_.end());
    request.losses =
        options_.allow_loss ? author::VersionLosses::kAllowed : author::VersionLosses::kRefused;
    request.out = out_;
    request.target = !out_.empty() ? EditTarget::kOut
                     : write_      ? EditTarget::kFiles
                     : diff_       ? EditTarget::kCheckedDiff
                                   : EditTarget::kDiff;
    search_.config().open();
    request.files = models_of(request.named);
    const GuardedDisk disk = search_.disk(request.named);
    Environment environment(disk, search_.paths());
    search_.allow(environment.workers);
    return rigor::tool::change_version(environment, request);
  }

  /// A folder is the model in it, as for the commands that only read one, and so is the model's model.config.
  std::vector<std::string> models_of(std::vector<std::string> named) {
    const GuardedDisk disk = search_.disk(named);
    const Environment environment(disk, search_.paths());
    Sources sources;
    read::Workspace workspace(environment.resolver, sources);
    for (std::string& path : named) {
      if (&path == &named.front() || disk.kind(path) == PathKind::kFolder)
        path = model_path(workspace, path);
    }
    return named;
  }

  /// Where other files are: nowhere with --isolated, and with --out, where only the model is written.
  EditWorkspace workspace_of(const std::vector<std::string>& files) const {
    if (!search_.config().is_isolated())
      return out_.empty() ? EditWorkspace(files.front(), search_.config().disk()) : EditWorkspace();
    if (files.size() > 1)
      throw UsageError("--isolated changes " + files.front() + " alone: " + files[1] +
                       " is named, too");
    return {};
  }

  static std::set<std::string> names_of(const author::EditedModel& edited) {
    std::set<std::string> names{edited.robot.name};
    for (const auto& body : edited.robot.bodies) names.insert(body.name);
    for (const auto& joint : edited.robot.joints) names.insert(joint.name);
    for (const auto& frame : edited.robot.frames) names.insert(frame.name);
    return names;
  }

  /// Of a change of several files, which they are.
  static void tell_others(const EditRequest& request, const author::ProvenChange& proven) {
    if (proven.files.size() < 2) return;
    for (const author::EditedFile& file : proven.files) {
      if (normalize_path(file.path) == normalize_path(request.files.front())) continue;
      say("rigor: " + report::printable(file.path) + ": " +
          report::counted(file.edits.size(), "place"));
    }
  }

  /// What other files may still call by a name that the change has taken away.
  static void tell_dangling(const EditRequest& request, const EditWorkspace& workspace,
                            const author::EditedModel& before, const author::EditedModel& after,
                            const Disk& disk, Sources& sources) {
    std::set<std::string> gone = names_of(before);
    for (const std::string& name : names_of(after)) gone.erase(name);
    if (gone.empty()) return;
    std::vector<Span> places;
    for (const std::string& path : workspace.files_with(gone, request.files, disk)) {
      for (const Span where : author::names_in_text(disk, sources, path, gone))
        places.push_back(where);
    }
    for (const std::string& line : author::mention_lines(sources, places))
      say("rigor: " + report::printable(line) + ", which is gone");
  }

  /// What -o and --isolated leave as it is.
  void refuse_other_files(const std::string& model,
                          const std::vector<author::EditedFile>& files) const {
    const bool is_isolated = search_.config().is_isolated();
    if (out_.empty() && !is_isolated) return;
    for (const author::EditedFile& file : files) {
      if (normalize_path(file.path) == normalize_path(model)) continue;
      throw UsageError(file.path +
                       (out_.empty() ? " would change, and --isolated changes "
                                     : " would change, and -o writes ") +
                       model + " alone" +
                       (is_isolated ? std::string() : ": change the files with --write"));
    }
  }

  /// Nothing changes: then `-o` is the model as it is.
  void put_unchanged(const std::string& model, const Disk& disk) const {
    say("rigor: nothing changes");
    if (out_.empty()) return;
    const ReadResult read = disk.read(model, read::kMaxModelBytes);
    if (!read.bytes) throw UsageError(model + ": cannot be read again");
    write_moved(out_, model, *read.bytes);
  }

  void emit(const std::vector<std::string>& named, const EditWorkspace& workspace,
            const std::vector<author::EditedFile>& files, const Sources& sources) const {
    if (!out_.empty()) {
      for (const author::EditedFile& file : files) write_moved(out_, file.path, file.text);
    } else if (write_) {
      std::vector<FileReplacement> replaced;
      for (const author::EditedFile& file : files)
        replaced.push_back({file.path, sources.bytes(file.source), file.text});
      replace_all_found(workspace.in_reach(named), replaced);
    } else {
      for (const author::EditedFile& file : files)
        write({0, {}}, unified_diff(file.path, sources.bytes(file.source), file.edits));
    }
  }

  /// What differs between the robot and the one after the change.
  static void tell(const author::EditedModel& edited, const robot::Robot& robot,
                   const author::ProvenChange& proven, std::vector<robot::Difference> differences,
                   const Sources& sources) {
    place_in_source(differences, *edited.loaded.file, *proven.after->loaded.file, sources);
    std::string text = report::robot_diff_text(
        {{edited.path(), robot}, {edited.path(), proven.after->robot}, differences, sources, {}});
    while (text.ends_with('\n')) text.pop_back();
    if (!text.empty()) say(text);
  }

  /// In the order in which they were read. A file may have been read twice.
  static std::vector<author::EditedFile> by_file(const std::vector<Edit>& edits,
                                                 const Sources& sources) {
    std::vector<author::EditedFile> files;
    for (const Edit& edit : edits) {
      const std::string path(sources.path(edit.span.source));
      auto file = std::find_if(files.begin(), files.end(), [&](const author::EditedFile& each) {
        return normalize_path(each.path) == normalize_path(path);
      });
      if (file == files.end()) file = files.insert(file, {path, edit.span.source, {}, {}});
      file->edits.push_back({{file->source, edit.span.begin, edit.span.end}, edit.text});
    }
    for (author::EditedFile& file : files) {
      auto text = apply_edits(sources.bytes(file.source), file.edits);
      if (!text) throw InputError(file.path + " would be changed twice in one place");
      file.text = *std::move(text);
    }
    return files;
  }

  int rename() {
    if (words_.size() < 3) throw UsageError("edit rename takes OLD NEW FILE...");
    refuse_other_options({kRename, "", "--kind", nullptr});
    search_.config().open();
    const std::vector<std::string> named(words_.begin() + 2, words_.end());
    const std::vector<std::string> files = models_of(named);
    const EditWorkspace around = workspace_of(files);
    const GuardedDisk disk = search_.disk(around.in_reach(named));
    const Environment environment(disk, search_.paths());
    Sources sources;
    read::Workspace workspace(environment.resolver, sources);
    author::NameGraph graph(workspace, environment.resolver);
    for (const std::string& file : files) {
      if (author::parameter_format(file) || author::is_mentioning_text(file)) continue;
      if (!workspace.open(file).document)
        throw UsageError(file + ": " + workspace.open(file).problem);
      graph.add_robot(file);
    }
    const author::EntityId target =
        found_in(graph, sources, files.front(), {words_[0], model_, options_.kind});
    const author::Renaming renaming =
        author::renamed({graph, environment.resolver, sources}, target, words_[1],
                        {files, around.files_with({graph.entity(target).name}, files, disk)});
    if (!renaming.refused.empty())
      throw InputError('\'' + words_[0] + "' is not renamed: " + renaming.refused);
    const std::vector<author::EditedFile> changed = by_file(renaming.edits, sources);
    refuse_other_files(files.front(), changed);
    emit(named, around, changed, sources);
    if (changed.size() > 1) {
      for (const author::EditedFile& file : changed) {
        say("rigor: " + report::printable(file.path) + ": " +
            report::counted(file.edits.size(), "place"));
      }
    }
    for (const std::string& line : author::mention_lines(sources, renaming.suspected))
      say("rigor: " + report::printable(line) + "; not renamed");
    say("rigor: " + report::counted(renaming.edits.size(), "place") + " in " +
        report::counted(changed.size(), "file") +
        (write_ || !out_.empty() ? " renamed" : " would be renamed"));
    return changed.empty() ? kClean : result_of_change();
  }

  std::vector<std::string_view> names_;
  std::string verb_;
  std::vector<std::string> words_;
  bool write_ = false;
  bool diff_ = false;
  std::string out_;
  std::string model_;
  EditOptions options_;
  std::vector<std::pair<std::string, CLI::Option*>> given_;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> edit_command() { return std::make_unique<EditCommand>(); }

}  // namespace rigor::tool
