// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/inspect.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include <rigor/environment.h>
#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/report/printable.h>
#include <rigor/report/summary.h>
#include <rigor/schema/value.h>
#include <rigor/text/path.h>

#include "command.h"
#include "output.h"
#include "search.h"

namespace rigor::tool {
namespace {

struct InspectFormat {
  std::string_view name;
  std::string (*emit)(const report::Inspection&);
};

constexpr InspectFormat kInspectFormats[] = {{"text", report::inspect_text},
                               {"json", report::inspect_json},
                               {"tsv", report::inspect_tsv},
                               {"dot", report::inspect_dot}};

/// What keeps the model from being whole; empty when nothing does.
std::string problem(const read::Loaded& loaded, const model::Frames& frames) {
  const std::string path = report::printable(loaded.file->path);
  if (!loaded.file->document->complete()) return path + " is not well-formed: this is a part of it";
  if (loaded.root.format == model::Format::kUnknown) return path + " is no robot model";
  const auto missing = [](const read::Fact& fact) {
    return fact.kind == read::FactKind::kIncludeNotFound ||
           fact.kind == read::FactKind::kIncludeUnreadable ||
           fact.kind == read::FactKind::kIncludeCycle;
  };
  const auto lost = std::count_if(loaded.facts.begin(), loaded.facts.end(), missing);
  if (lost > 0) {
    return report::counted(static_cast<std::size_t>(lost), "include") + " could not be followed";
  }
  if (frames.problems().empty()) return {};
  return report::counted(frames.problems().size(), "frame problem");
}

class Inspect final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "inspect", "Show what a model is once it is resolved",
                                {"rigor inspect robot.urdf",
                                 "rigor inspect arm/model.sdf --format tsv --joint elbow=1.57"});
    app->add_option("path", path_, "A model file, or a folder with a model.config")
        ->required()
        ->type_name("PATH");
    output_.declare(*app, {"text", "json", "tsv", "dot"});
    app->add_option("--joint", joints_, "Position of a joint, rad or m; VALUE,VALUE for two axes")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    search_.declare(*app);
    return app;
  }

  int run() override {
    const std::vector<Target> targets = output_.targets();
    const RealDisk disk;
    const Environment environment(disk, search_.paths());
    Sources sources;
    read::Workspace workspace(disk, sources);
    const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
    const read::Loaded loaded = load(reader, open(workspace));

    const model::Frames frames(loaded.root, positions(loaded.root));
    const report::Inspection inspection{loaded.file->path, loaded.root, frames};
    for (const Target& target : targets) write(target, kInspectFormats[target.format].emit(inspection));
    const std::string why = problem(loaded, frames);
    if (why.empty()) return kClean;
    say("rigor: " + why + "; `rigor validate` says more");
    return kFindings;
  }

 private:
  const read::File& open(read::Workspace& workspace) const {
    const Disk& disk = workspace.disk();
    std::string path = path_;
    if (disk.kind(path) == PathKind::kFolder) path = join_path(path, "model.config");
    if (disk.kind(path) == PathKind::kFile && file_name(path) == "model.config") {
      const read::File& config = workspace.open(path);
      if (config.document) path = model_of(path, read::read_model_config(*config.document));
    }
    const read::File& file = workspace.open(path);
    if (!file.document) throw UsageError(path + ": " + file.problem);
    return file;
  }

  static std::string model_of(const std::string& config, const read::ModelConfig& read) {
    const read::SdfEntry* entry = choose(read);
    if (entry == nullptr) throw UsageError(config + ": names no SDF file");
    return join_path(parent_path(config), entry->file.value);
  }

  /// By scoped name; a name without its scope will do when only one joint has it.
  model::JointPositions positions(const model::Root& root) const {
    model::JointPositions positions;
    for (const std::string& text : joints_) {
      const auto [name, value] = split_assignment("--joint", text);
      positions[joint_named(root, name)] = position(text, value);
    }
    return positions;
  }

  static std::string joint_named(const model::Root& root, const std::string& name) {
    std::vector<std::string> names;
    std::vector<std::string> matching;
    for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
      names.push_back(scoped_name(root, model::Id<model::Joint>{i}));
      if (names.back() == name) return name;
      if (root.joints[i].name.value == name) matching.push_back(names.back());
    }
    if (matching.size() == 1) return matching.front();
    std::vector<std::string_view> known(names.begin(), names.end());
    if (matching.empty()) {
      for (const model::Joint& joint : root.joints) known.push_back(joint.name.value);
      throw UsageError("--joint " + name + ": no such joint" + did_you_mean(name, known));
    }
    throw UsageError("--joint " + name + ": " + report::counted(matching.size(), "joint") +
                     " have this name; write " + matching[0] + " or " + matching[1]);
  }

  static std::array<double, 2> position(const std::string& option, const std::string& value) {
    std::array<double, 2> result{};
    const std::size_t comma = value.find(',');
    result[0] = one(option, value.substr(0, comma));
    if (comma != std::string::npos) result[1] = one(option, value.substr(comma + 1));
    return result;
  }

  static double one(const std::string& option, const std::string& text) {
    const auto parsed = schema::parse_double(text);
    const double* value = std::get_if<double>(&parsed);
    if (value != nullptr && std::isfinite(*value)) return *value;
    throw UsageError("--joint " + option + ": \"" + text + "\" is no finite number");
  }

  std::string path_;
  OutputOptions output_;
  std::vector<std::string> joints_;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> inspect_command() { return std::make_unique<Inspect>(); }

}  // namespace rigor::tool
