// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor inertia MODEL`: a model's inertials beside what its shapes say, and written into the file.

#include <map>
#include <string>
#include <utility>

#include <rigor/author/model_inertia.h>
#include <rigor/mass/total.h>
#include <rigor/mesh/read.h>
#include <rigor/read/load.h>
#include <rigor/report/inertia/inertia_report.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/mesh_finder.h>
#include <rigor/text/diff.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "command/inertia.h"
#include "model/model_file.h"
#include "option/numbers.h"
#include "output/atomic_file.h"
#include "output/progress.h"

namespace rigor::tool {
namespace {

using author::InertiaOptions;
using author::ModelInertia;
using model::Id;

void refuse_shape_options(const InertiaArguments& a) {
  const auto refuse = [](bool given, const char* option) {
    if (given) throw UsageError(std::string(option) + " belongs to a shape, not to a model");
  };
  if (!a.mesh.empty()) throw UsageError("one argument too many: " + a.mesh);
  refuse(!a.size.empty(), "--size");
  refuse(!a.radius.empty(), "--radius");
  refuse(!a.length.empty(), "--length");
  refuse(!a.radii.empty(), "--radii");
  refuse(!a.scale.empty(), "--scale");
  refuse(!a.hollow.empty(), "--hollow");
  refuse(!a.pose.empty(), "--pose");
  refuse(a.hull, "--hull");
  if (a.diff && a.write) throw UsageError("--diff and --write exclude each other");
}

InertiaOptions options_of(const InertiaArguments& a) {
  InertiaOptions options;
  options.density = density_of(a, a.what);
  options.bake = a.bake;
  if (!a.only.empty()) {
    constexpr author::Only kOnly[] = {author::Only::kMissing, author::Only::kImplausible,
                                      author::Only::kAll};
    options.only = kOnly[choice("--only value", a.only, kOnlyNames)];
  }
  if (!a.from.empty()) {
    const bool visual = choice("--from value", a.from, kFromNames) == 1;
    options.from = visual ? mass::From::kVisuals : mass::From::kCollisions;
  }
  for (const std::string& text : a.masses) {
    if (text.find('=') == std::string::npos) {
      throw UsageError("--mass " + text + ": of a model it is LINK=KG");
    }
    const auto [link, mass] = split_assignment("--mass", text);
    if (options.masses.contains(link)) throw UsageError("--mass " + link + " is given twice");
    options.masses[link] = positive_number("--mass " + link, mass, "kg");
  }
  return options;
}

/// A bare name that several links have.
void refuse_ambiguous_links(const model::Root& root, const InertiaOptions& options) {
  for (const auto& [name, mass] : options.masses) {
    std::vector<std::string> named;
    for (std::uint32_t i = 0; i < root.links.size(); ++i) {
      const std::string scoped = scoped_name(root, Id<model::Link>{i});
      if (scoped == name) return;
      if (root.links[i].name.value == name) named.push_back(scoped);
    }
    if (named.size() > 1) {
      throw UsageError("--mass " + name + ": " + report::counted(named.size(), "link") +
                       " have this name; write " + named[0] + " or " + named[1]);
    }
  }
}

/// What keeps the file from being examined as a whole; empty when nothing does.
std::string problem(const read::Loaded& loaded) {
  if (!loaded.file->document->complete()) return "is not well-formed";
  if (loaded.root.format == model::Format::kUnknown ||
      loaded.root.format == model::Format::kModelConfig) {
    return "is no robot model";
  }
  return unread_part(loaded);
}

/// The sums of each model at the top, as written and as computed.
class Totals {
 public:
  Totals(const model::Root& root, const model::Frames& frames, const mass::FindMesh& find_mesh,
         const ModelInertia& table)
      : root_(root), frames_(frames), find_mesh_(find_mesh) {
    for (const author::LinkInertia& link : table.links) {
      if (link.chosen) computed_[link.link.value] = link.computed->body;
    }
  }

  std::vector<report::RobotTotal> of_all() const {
    std::vector<report::RobotTotal> totals;
    for (std::uint32_t i = 0; i < root_.models.size(); ++i) {
      const Id<model::Model> id{i};
      if (!root_[id].parent && !root_[id].is_static.value) totals.push_back(of(id));
    }
    return totals;
  }

 private:
  report::RobotTotal of(Id<model::Model> id) const {
    report::RobotTotal result;
    result.model = scoped_name(root_, id);
    result.written = mass::total(root_, frames_, id, [this](Id<model::Link> link) {
                       return written(link);
                     }).body;
    result.computed = mass::total(root_, frames_, id, [this](Id<model::Link> link) {
                        const auto found = computed_.find(link.value);
                        return found == computed_.end() ? written(link) : found->second;
                      }).body;
    if (result.computed && result.computed->mass > 0) {
      result.stance = stance_of(root_, frames_, id, find_mesh_, result.computed->com);
    }
    return result;
  }

  mass::MassProperties written(Id<model::Link> link) const {
    return mass::resolve(root_, frames_, link, find_mesh_).body;
  }

  const model::Root& root_;
  const model::Frames& frames_;
  const mass::FindMesh& find_mesh_;
  std::map<std::uint32_t, mass::MassProperties> computed_;
};

/// Says why links stay as they are that ask for an inertial, or for which a mass is given. Whether a
/// given mass was of no use.
bool tell_left(const model::Root& root, const ModelInertia& table, const InertiaOptions& options) {
  bool unused = false;
  for (const author::LinkInertia& link : table.links) {
    const bool given =
        options.masses.contains(link.name) || options.masses.contains(root[link.link].name.value);
    if (link.chosen || link.reason.empty() || !(given || !link.findings.empty())) continue;
    unused = unused || given;
    say("rigor: link " + report::printable(link.name) +
        " stays as it is: " + report::printable(link.reason));
  }
  return unused;
}

void write_file(const std::string& named, const std::string& path, std::string_view bytes,
                const ModelInertia& table) {
  std::size_t links = 0;
  for (const author::LinkInertia& link : table.links) links += link.chosen ? 1 : 0;
  if (table.edits.empty()) {
    say("rigor: " + report::printable(path) + " is unchanged: " +
        (links > 0 ? "its inertials are what its shapes say" : "no link asks for it"));
    return;
  }
  const auto text = apply_edits(bytes, table.edits);
  if (!text) throw std::logic_error("the edits of " + path + " overlap");
  replace_found({named}, path, *text);
  say("rigor: " + report::counted(links, "inertial") + " written to " + report::printable(path));
}

}  // namespace

int run_model_inertia(const InertiaArguments& a) {
  const GuardedDisk real = a.search.disk({a.what});
  const ProgressDisk disk(real);
  if (disk.kind(a.what) == PathKind::kMissing) {
    throw UsageError(a.what + ": no such file, and no shape of that name" +
                     did_you_mean(a.what, {"box", "sphere", "cylinder", "capsule", "ellipsoid",
                                           "cone", "mesh"}));
  }
  if (disk.kind(a.what) == PathKind::kFile && mesh::has_mesh_ending(a.what)) {
    throw UsageError(a.what + " is a mesh; did you mean rigor inertia mesh " + a.what + "?");
  }
  const std::vector<Target> targets = a.output.targets_of({"text", "json"});
  if ((a.diff || a.write) && targets.front().format != 0) {
    throw UsageError("--diff and --write print no table: leave out --format json");
  }
  refuse_shape_options(a);
  const InertiaOptions options = options_of(a);
  Environment environment(disk, a.search.paths());
  a.search.allow(environment.workers);
  Sources sources;
  read::Workspace workspace(environment.resolver, sources);
  const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
  const read::Loaded loaded = load(reader, open_model(workspace, a.what));
  const std::string path = loaded.file->path;
  if (loaded.file->expanded && (a.write || a.diff)) {
    throw UsageError(path + " is a template: its table can be shown, its inertials not be written");
  }
  if (loaded.root.format == model::Format::kMjcf && (a.write || a.diff)) {
    throw UsageError(path + " is MJCF: its table can be shown, its inertials not be written");
  }
  if (const std::string why = problem(loaded); !why.empty()) {
    say("rigor: " + report::printable(path) + " " + why + "; run `rigor validate` for details");
    return kFindings;
  }
  tell_unfollowed(loaded);
  refuse_ambiguous_links(loaded.root, options);
  for (const std::string& name : unknown_links(loaded.root, options)) {
    std::vector<std::string_view> known;
    for (const model::Link& link : loaded.root.links) known.push_back(link.name.value);
    throw UsageError("--mass " + name + ": no such link" + did_you_mean(name, known));
  }

  mass::MeshSurveys surveys(disk, {.workers = &environment.workers});
  const ModelInertia table = model_inertia(environment, sources, loaded, surveys, options);
  const std::string_view bytes = sources.bytes(loaded.root.source);
  const bool unused = (a.write || a.diff) && tell_left(loaded.root, table, options);
  if (a.write) {
    write_file(a.what, path, bytes, table);
    return unused ? kFindings : kClean;
  }
  if (a.diff) {
    write({0, {}}, unified_diff(path, bytes, table.edits));
    return table.edits.empty() ? kClean : kFindings;
  }
  const mass::FindMesh find_mesh = rules::mesh_finder(environment.resolver, sources, surveys);
  const model::Frames frames(loaded.root, joint_positions(loaded.root, a.joints));
  const report::InertiaTable result{table, sources,
                                    Totals(loaded.root, frames, find_mesh, table).of_all()};
  for (const Target& target : targets) {
    write(target, target.format == 0 ? report::inertia_text(result) : report::inertia_json(result));
  }
  return kClean;
}

}  // namespace rigor::tool
