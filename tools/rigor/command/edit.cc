// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor edit VERB …`: changes that a model's author asks for, as byte edits. The verb is `rename`.

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/author/names/name_graph.h>
#include <rigor/author/names/parameter_names.h>
#include <rigor/author/names/rename.h>
#include <rigor/read/workspace.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/rules/environment.h>
#include <rigor/text/diff.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "option/search.h"
#include "output/atomic_file.h"
#include "output/output.h"
#include "project/guarded_disk.h"

namespace rigor::tool {
namespace {

class EditCommand final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app =
        add_command(program, "edit", "Change a model: another name for a link, joint or frame",
                    {"rigor edit rename wheel left_wheel robot.urdf robot.srdf controllers.yaml",
                     "rigor edit rename arm::hand palm worlds/*.sdf --write"});
    app->add_option("verb", verb_, "rename")->type_name("VERB")->required();
    app->add_option(
           "words", words_,
           "Of rename: OLD NEW FILE..., where the first file defines the name or refers to it")
        ->type_name("WORD");
    auto* write = app->add_flag("--write", write_, "Change the files");
    app->add_flag("--diff", diff_, "Show what would change: the default")->excludes(write);
    search_.declare(*app);
    return app;
  }

  int run() override {
    if (verb_ != "rename") throw UsageError("edit has no verb \"" + verb_ + "\"; it has rename");
    if (words_.size() < 3) throw UsageError("edit rename takes OLD NEW FILE...");
    search_.config().open();
    const std::vector<std::string> files(words_.begin() + 2, words_.end());
    const GuardedDisk disk = search_.disk(files);
    const Environment environment(disk, search_.paths());
    Sources sources;
    read::Workspace workspace(environment.resolver, sources);
    author::NameGraph graph(workspace, environment.resolver);
    for (const std::string& file : files) {
      if (author::parameter_format(file)) continue;
      if (!workspace.open(file).document)
        throw UsageError(file + ": " + workspace.open(file).problem);
      graph.add_robot(file);
    }
    const auto target = graph.find(files.front(), words_[0]);
    if (!target) throw InputError(files.front() + ": nothing is named '" + words_[0] + '\'');
    const author::Renaming renaming =
        author::renamed({graph, environment.resolver, sources}, *target, words_[1], files);
    if (!renaming.refused.empty())
      throw InputError('\'' + words_[0] + "' is not renamed: " + renaming.refused);
    std::map<SourceId, std::vector<Edit>> by_source;
    for (const Edit& edit : renaming.edits) by_source[edit.span.source].push_back(edit);
    for (const auto& [source, edits] : by_source) {
      const std::string path(sources.path(source));
      if (!write_) {
        write({0, {}}, unified_diff(path, sources.bytes(source), edits));
      } else if (const auto text = apply_edits(sources.bytes(source), edits)) {
        replace_found(files, path, *text);
      }
    }
    for (const Span where : renaming.suspected) {
      const std::string path(sources.path(where.source));
      say("rigor: " + report::printable(path) + ':' +
          std::to_string(sources.position(where.source, where.begin).line) +
          ": may be the name; not renamed");
    }
    say("rigor: " + report::counted(renaming.edits.size(), "place") + " in " +
        report::counted(by_source.size(), "file") + (write_ ? " renamed" : " would be renamed"));
    return kClean;
  }

 private:
  std::string verb_;
  std::vector<std::string> words_;
  bool write_ = false;
  bool diff_ = false;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> edit_command() { return std::make_unique<EditCommand>(); }

}  // namespace rigor::tool
