// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor srdf MODEL`: what MoveIt has to know of a robot beside its links and joints.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <rigor/author/srdf/srdf_text.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/mesh/collide/collider.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/robot/collision/self_collisions.h>
#include <rigor/robot/collision/surfaces.h>
#include <rigor/robot/semantic/soft_limits.h>
#include <rigor/rules/environment.h>
#include <rigor/text/diff.h>

#include "command/command.h"
#include "model/robot_file.h"
#include "option/search.h"
#include "output/atomic_file.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

/// More take minutes and find what no arm meets in its life.
constexpr std::size_t kMaxSrdfSamples = 100'000'000;

/// Of collisions that are not checked: a package that is not found is one reason for all.
constexpr std::size_t kMaxUnknownSaid = 5;

class SrdfCommand final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(
        program, "srdf",
        "Make an SRDF for MoveIt: groups, end effectors, states, and the links whose collisions "
        "need "
        "no check; or update one",
        {"rigor srdf arm.urdf -o config/arm.srdf", "rigor srdf robot.urdf.xacro --samples 100000",
         "rigor srdf arm.urdf --update config/arm.srdf --write"});
    app->add_option("path", model_, "A URDF, xacro or SDF file, or a folder with a model.config")
        ->required()
        ->type_name("MODEL");
    app->add_option("--model", name_, "Name of one of several models in a file")->type_name("NAME");
    auto* update = app->add_option("--update", update_,
                                   "An SRDF whose collision matrix is computed again; all else in "
                                   "it, and pairs with a reason of their own, stay as they are")
                       ->type_name("SRDF");
    auto* write = app->add_flag("--write", write_, "Change that SRDF in its place")->needs(update);
    app->add_flag("--diff", diff_, "Show what would change in that SRDF: the default")
        ->needs(update)
        ->excludes(write);
    app->add_option("-o,--out", out_, "Where the SRDF goes; to stdout when absent")
        ->type_name("FILE")
        ->excludes(write);
    app->add_option("--samples", samples_,
                    "Positions of all joints that are checked, default 10000")
        ->type_name("N")
        ->check(CLI::Range(std::size_t{1}, kMaxSrdfSamples));
    app->add_option("--seed", seed_, "Of the positions, default 1")->type_name("N");
    app->add_option("-j,--jobs", jobs_, "Threads; 0, the default: as many as there are cores")
        ->type_name("N")
        ->check(CLI::Range(0, 1024));
    search_.declare(*app);
    return app;
  }

  int run() override {
    if (const std::string problem = mesh::collider_problem(); !problem.empty())
      throw UsageError("rigor srdf needs FCL, in " + problem);
    std::vector<std::string> named{model_};
    if (!update_.empty()) named.push_back(update_);
    const GuardedDisk disk = search_.disk(named);
    Environment environment(disk, search_.paths());
    search_.allow(environment.workers);
    Sources sources;
    read::Workspace workspace(environment.resolver, sources);
    RobotFiles files(environment, sources, workspace);
    const read::Loaded loaded = files.load(model_);
    std::optional<robot::Robot> read_robot = files.robot(loaded, name_);
    if (!read_robot) return kFindings;
    const robot::Robot robot = within_soft_limits(*std::move(read_robot), loaded.root);
    author::Semantics semantics = author::semantics_of(robot);
    semantics.disabled = matrix(environment, disk, robot);
    if (!update_.empty()) return update(workspace, semantics);
    const std::string text = author::srdf_text(semantics);
    if (out_.empty())
      rigor::tool::write({0, {}}, text);
    else
      replace_file(out_, text);
    return kClean;
  }

 private:
  std::vector<author::DisabledPair> matrix(const Environment& environment, const Disk& disk,
                                           const robot::Robot& robot) const {
    mass::MeshReads reads(disk, environment.workers);
    const robot::CollisionBodies bodies(robot, robot::surface_finder(reads));
    say_unknown(robot, bodies.unknown());
    Turns turns(jobs_);
    const robot::SelfCollisions found =
        self_collisions(robot, bodies, {.samples = samples_, .seed = seed_}, turns);
    if (found.too_many_links) {
      throw InputError(model_ + " has over " + std::to_string(robot::kMaxCollisionLinks) +
                       " links with a collision");
    }
    say_counts(found.pairs);
    return author::disabled_pairs(robot, found.pairs);
  }

  static void say_unknown(const robot::Robot& robot,
                          const std::vector<robot::UnknownShape>& unknown) {
    for (std::size_t i = 0; i < std::min(unknown.size(), kMaxUnknownSaid); ++i) {
      say("rigor: collision of " + report::printable(robot.bodies[unknown[i].body].name) +
          " is not checked: " + report::printable(unknown[i].why));
    }
    if (unknown.size() > kMaxUnknownSaid) {
      say(fmt::format("rigor: {} more are not checked; pairs with their links stay enabled",
                      report::counted(unknown.size() - kMaxUnknownSaid, "collision")));
    }
  }

  void say_counts(const std::vector<robot::LinkPair>& pairs) const {
    const auto count = [&](robot::PairKind kind) {
      return std::count_if(pairs.begin(), pairs.end(),
                           [&](const robot::LinkPair& pair) { return pair.kind == kind; });
    };
    using robot::PairKind;
    say(
        fmt::format("rigor: {}: {} adjacent, {} in collision at rest, {} always, {} never in {}; "
                    "{} to check",
                    report::counted(pairs.size(), "pair"), count(PairKind::kAdjacent),
                    count(PairKind::kDefault), count(PairKind::kAlways), count(PairKind::kNever),
                    report::counted(samples_, "sample"), count(PairKind::kSometimes)));
  }

  int update(read::Workspace& workspace, const author::Semantics& semantics) const {
    const read::File& file = workspace.open(update_);
    if (!file.document) throw UsageError(update_ + ": " + file.problem);
    const xml::Document& document = *file.document;
    const author::MatrixUpdate update = author::updated_matrix(document, semantics.disabled);
    if (!update.refused.empty()) throw InputError(update_ + ' ' + update.refused);
    const auto text = apply_edits(document.bytes(), update.edits);
    if (!text) throw InputError(update_ + " has a layout that is not edited");
    if (write_)
      replace_found({update_}, update_, *text);
    else if (!out_.empty())
      replace_file(out_, *text);
    else
      rigor::tool::write({0, {}}, unified_diff(update_, document.bytes(), update.edits));
    say(fmt::format("rigor: {} added, {} removed, {} with another reason; {} by hand kept",
                    report::counted(update.added, "pair"), update.removed, update.changed,
                    update.by_hand));
    return kClean;
  }

  std::string model_;
  std::string name_;
  std::string update_;
  std::string out_;
  bool write_ = false;
  bool diff_ = false;
  std::size_t samples_ = 10'000;
  std::uint64_t seed_ = 1;
  unsigned jobs_ = 0;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> srdf_command() { return std::make_unique<SrdfCommand>(); }

}  // namespace rigor::tool
