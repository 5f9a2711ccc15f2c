// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor expand FILE.xacro [name:=value ...]`: what xacro prints, or where each part of it came from.

#include <rigor/xacro/expand.h>

#include <string>
#include <string_view>
#include <vector>

#include <rigor/read/resolver.h>
#include <rigor/read/template/template_expander.h>
#include <rigor/report/json/expansion.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/xacro/print.h>

#include "command/command.h"
#include "model/expansion_map.h"
#include "option/search.h"
#include "output/atomic_file.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

constexpr std::string_view kMapFormats[] = {"json"};

class ExpandCommand final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(
        program, "expand", "Print a xacro file as plain XML, as xacro does",
        {"rigor expand robot.urdf.xacro prefix:=left_ -o robot.urdf",
         "rigor expand robot.urdf.xacro --trace 'robot/link[base]/inertial/mass@value'"});
    app->add_option("path", path_, "A xacro file")->required()->type_name("FILE");
    app->add_option("arguments", arguments_, "Arguments of the file")->type_name("name:=value");
    app->add_option("-o,--out", out_, "Where the result goes; to stdout when absent")
        ->type_name("FILE");
    auto* deps = app->add_flag("--deps", deps_, "List the files that were read, one a line");
    auto* trace_option =
        app->add_option("--trace", trace_, "Tell where an element or attribute came from")
            ->type_name("PATH")
            ->excludes(deps);
    app->add_option("--map", map_, "Print where all elements came from: json")
        ->type_name("FORMAT")
        ->excludes(deps)
        ->excludes(trace_option);
    app->add_flag("-v,--verbose", verbose_, "Tell what is worth knowing as well");
    search_.declare(*app);
    return app;
  }

  int run() override {
    const GuardedDisk disk = search_.disk({path_});
    if (!map_.empty()) choice("--map format", map_, kMapFormats);
    if (disk.kind(path_) != PathKind::kFile) throw UsageError(path_ + ": no such file");
    Sources sources;
    for (const std::string& word : arguments_)
      throw UsageError("\"" + word + "\" is no argument: write name:=value");
    const read::Resolver resolver(disk, search_.paths());
    read::TemplateExpander expander(resolver);
    const xacro::Expansion expansion =
        expander.expansion(path_, resolver.paths().templates.arguments, sources);
    tell(expansion, sources, disk.reach());
    const bool ok = expansion.ok();
    if (deps_) {
      std::string list;
      for (const xacro::FileUse& file : expansion.files) list += file.path + '\n';
      put(list);
    } else if (!trace_.empty()) {
      const auto found = trace(expansion, sources, trace_);
      if (!found) throw UsageError("--trace " + trace_ + ": no such element or attribute");
      put(*found);
    } else if (!map_.empty()) {
      put(report::expansion_json(expansion, sources));
    } else if (ok) {
      put(xacro::print(*expansion.document, path_));
    }
    return ok ? kClean : kFindings;
  }

 private:
  void put(std::string_view text) const { rigor::tool::write({0, out_}, text); }

  void tell(const xacro::Expansion& expansion, const Sources& sources, const Reach& reach) const {
    std::size_t remarks = 0;
    for (const xacro::Fact& fact : expansion.facts) {
      const bool error = xacro::is_error(fact.kind);
      if (!error && !verbose_ && fact.kind != xacro::FactKind::kMessage) {
        ++remarks;
        continue;
      }
      const std::string place =
          fact.where.nowhere() ? report::printable(path_) : shown_place(sources, fact.where);
      std::string text = place + ": " + (error ? "error: " : "info: ") +
                         report::printable(described(fact, sources, reach));
      if (fact.count > 1) text += " (" + std::to_string(fact.count) + " instances)";
      if (!fact.related.nowhere()) text += "\n  see " + shown_place(sources, fact.related);
      text += '\n' + shown_stack(sources, fact.stack);
      text.pop_back();
      say(text);
    }
    if (expansion.facts_left_out > 0) {
      say("rigor: " + report::counted(expansion.facts_left_out, "more finding"));
    }
    if (remarks > 0) say("rigor: " + report::counted(remarks, "remark") + " with --verbose");
  }

  std::string path_;
  std::vector<std::string> arguments_;
  std::string out_;
  bool deps_ = false;
  std::string trace_;
  std::string map_;
  bool verbose_ = false;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> expand_command() { return std::make_unique<ExpandCommand>(); }

}  // namespace rigor::tool
