// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/plan.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <rigor/simulate/metric/parts.h>
#include <rigor/simulate/mount.h>
#include <rigor/simulate/test/tests.h>

namespace rigor::simulate {
namespace {

/// The file's name without folder and ending: "drive" of "tests/drive.scenario.toml".
std::string title_of(const config::ScenarioFile& file) {
  if (file.path.empty()) return "command";
  std::string_view name = file.path;
  name.remove_prefix(name.find_last_of('/') + 1);
  const std::size_t ending = name.find('.', 1);
  return std::string(name.substr(0, ending));
}

class Planner {
 public:
  Planner(const Scene& scene, Planned& planned) : scene_(scene), planned_(planned) {}

  /// A problem when no joint has the name; more than one may.
  void need_joint(const std::string& name) {
    const auto& joints = scene_.joints;
    const auto is = [&](const SceneJoint& joint) { return is_named(joint.name, name); };
    if (std::none_of(joints.begin(), joints.end(), is)) add_problem("joint", name, joints, {});
  }

  void add(const config::ScenarioFile& file) {
    scenario_ = {};
    scenario_.name = title_of(file);
    scenario_.spawn = file.on_ground ? Spawn::kOnGround : Spawn::kAsWritten;
    scenario_.ground = file.ground;
    scenario_.ground_mu = file.ground_mu.value_or(1.0);
    scenario_.step = file.time_step;
    if (file.solver) {
      scenario_.solver = *file.solver == "dantzig" ? Solver::kDantzig : Solver::kQuick;
    }
    if (file.gravity) {
      const auto& [x, y, z] = *file.gravity;
      scenario_.gravity_W = Vector3{x, y, z};
    }
    double begin = 0;
    for (const config::ScenarioStep& step : file.steps) {
      scenario_.phases.push_back({step.name, begin, step.until});
      for (const auto& command : step.commands) add(command, begin, step.until);
      for (const auto& push : step.pushes) add(push);
      if (step.tilt) {
        const auto& [x, y, z] = step.tilt->axis;
        scenario_.tilts.push_back({begin, step.until, step.tilt->angle, {x, y, z}});
      }
      begin = step.until;
    }
    scenario_.duration = begin;
    for (const auto& demand : file.asserts) add(demand);
    planned_.scenarios.push_back(scenario_);
  }

 private:
  void add(const config::ScenarioCommand& command, double begin, double end) {
    constexpr std::array kKinds{CommandKind::kEffort, CommandKind::kVelocity,
                                CommandKind::kPosition};
    for (const std::string& name : command.joints) {
      const std::uint32_t joint = find("joint", name, scene_.joints);
      if (joint == kWorld) continue;
      if (command.axis >= scene_.joints[joint].axes.size()) {
        planned_.problems.push_back(
            {"axis " + std::to_string(command.axis) + " of joint " + name, {}, {}});
        continue;
      }
      Command made{.joint = joint,
                   .axis = command.axis,
                   .kind = kKinds[static_cast<std::size_t>(command.kind)],
                   .value = command.value,
                   .begin = begin,
                   .end = end,
                   .ramp = command.ramp,
                   .effort = command.effort.value_or(kInfinity)};
      if (command.gains) {
        const auto& [p, i, d] = *command.gains;
        made.gains = Gains{p, i, d};
      }
      scenario_.commands.push_back(made);
    }
  }

  void add(const config::ScenarioPush& push) {
    const std::uint32_t link = find("link", push.link, scene_.links);
    if (link == kWorld || scene_.links[link].body == kWorld) return;
    const auto& [x, y, z] = push.impulse;
    const auto& [px, py, pz] = push.point;
    scenario_.pushes.push_back({.body = scene_.links[link].body,
                                .impulse_W = {x, y, z},
                                .p_BP = transform(scene_.links[link].X_BL, {px, py, pz}),
                                .at = push.at});
  }

  void add(const config::ScenarioAssert& demand) {
    using Of = config::ScenarioAssert::Of;
    constexpr std::array<const char*, 3> kAlong{"x", "y", "z"};
    constexpr std::array<const char*, 3> kAbout{"roll", "pitch", "yaw"};
    Assertion made{.name = demand.name,
                   .at = demand.at.value_or(kInfinity),
                   .least = demand.min.value_or(-kInfinity),
                   .most = demand.max.value_or(kInfinity)};
    if (demand.of == Of::kMetric) {
      made.metric = demand.name_of;
    } else if (demand.of == Of::kPosition || demand.of == Of::kOrientation) {
      const std::uint32_t link = find("link", demand.name_of, scene_.links);
      if (link == kWorld) return;
      const char* axis = demand.of == Of::kPosition ? kAlong[demand.axis] : kAbout[demand.axis];
      made.quantity = std::string(axis) + " of " + scene_.links[link].name;
    } else {
      const std::uint32_t joint = find("joint", demand.name_of, scene_.joints);
      if (joint == kWorld) return;
      made.quantity = (demand.of == Of::kJointPosition ? "position of " : "velocity of ") +
                      scene_.joints[joint].name;
    }
    scenario_.assertions.push_back(std::move(made));
  }

  /// kWorld, and a problem, when no or more than one thing has the name.
  template <class Thing>
  std::uint32_t find(const char* kind, const std::string& name, const std::vector<Thing>& things) {
    std::vector<std::uint32_t> matching;
    for (std::uint32_t i = 0; i < things.size(); ++i) {
      if (things[i].name == name) return i;
      if (is_named(things[i].name, name)) matching.push_back(i);
    }
    if (matching.size() == 1) return matching.front();
    add_problem(kind, name, things, matching);
    return kWorld;
  }

  template <class Thing>
  void add_problem(const char* kind, const std::string& name, const std::vector<Thing>& things,
                   const std::vector<std::uint32_t>& matching) {
    PlanProblem problem{std::string(kind) + ' ' + name, name, {}};
    for (const std::uint32_t i : matching) problem.candidates.push_back(things[i].name);
    if (matching.empty()) {
      for (const Thing& thing : things) {
        problem.candidates.push_back(thing.name);
        problem.candidates.push_back(thing.name.substr(thing.name.rfind(':') + 1));
      }
    }
    planned_.problems.push_back(std::move(problem));
  }

  const Scene& scene_;
  Planned& planned_;
  Scenario scenario_;
};

/// The tests that a base is held in, by why.
class MountNotes {
 public:
  void add(const std::string& test, const std::string& why) {
    const auto same = [&](const auto& known) { return known.first == why; };
    const auto known = std::find_if(tests_.begin(), tests_.end(), same);
    if (known == tests_.end()) {
      tests_.emplace_back(why, test);
    } else {
      known->second += ", " + test;
    }
  }

  std::vector<std::string> in_words() const {
    std::vector<std::string> notes;
    for (const auto& [why, tests] : tests_) {
      notes.push_back(tests + ": the base is fixed in place and there is no ground, since " + why +
                      " (--base free changes that)");
    }
    return notes;
  }

 private:
  std::vector<std::pair<std::string, std::string>> tests_;
};

/// The exact solver's time grows with the cube of the rows, the iterative one's in proportion: without contacts
/// they meet at some 200 (measured on robots of 6 to 40 joints), and below the exact one is faster.
constexpr std::size_t kExactRows = 200;
constexpr std::size_t kRowsOfJoint = 6;  // of a hinge 5, and its motor

bool is_better_solved_exactly(const Scene& scene) {
  return kRowsOfJoint * (scene.joints.size() + 1) <= kExactRows &&
         std::none_of(scene.bodies.begin(), scene.bodies.end(),
                      [](const SceneBody& body) { return body.self_collide; });
}

/// The base for a test as it was asked for, or chosen.
MountChoice mount_of(const Plan& plan, std::string_view test, const Scene& scene,
                     const DriveTrain& wheels) {
  switch (plan.base) {
    case BaseOption::kFixed: return {Base::kFixed, {}, false};
    case BaseOption::kHang: return {Base::kHang, {}, false};
    case BaseOption::kFree: return {};
    case BaseOption::kAuto: break;
  }
  return choose_mount(test, scene, wheels);
}

/// Why a test of how a model stands makes no sense; nothing where it does.
std::string why_not_free(const std::string& test, const MountChoice& mount) {
  if (!needs_free_base(test) || mount.base == Base::kFree) return {};
  return mount.why.empty() ? "its base is held, as --base says" : mount.why;
}

/// Once, whichever tests find it.
void add_fact(Fact fact, Planned& planned) {
  const auto same = [&](const Fact& known) { return known.kind == fact.kind; };
  if (std::none_of(planned.facts.begin(), planned.facts.end(), same)) {
    fact.severe = false;
    planned.facts.push_back(std::move(fact));
  }
}

void add_tipping(const Scene& scene, Planned& planned) {
  Fact fact = about_scene(scene);
  fact.kind = FactKind::kHeldUp;
  add_fact(std::move(fact), planned);
}

std::string own_name_of(const SceneJoint& joint) {
  const std::size_t colon = joint.name.rfind("::");
  return joint.name.substr(colon == std::string::npos ? 0 : colon + 2);
}

/// Of wheels that cannot drive: which, and why.
void add_idle_wheels(const Scene& scene, const DriveTrain& wheels, Planned& planned) {
  const std::vector<IdleWheel> idle = idle_wheels(scene, wheels);
  if (idle.empty()) return;
  Fact fact = about_joint(scene, idle.front().joint);
  fact.kind = FactKind::kWheelsMiss;
  fact.name.clear();
  for (const IdleWheel& wheel : idle) {
    fact.name += (fact.name.empty() ? "" : ", ") + own_name_of(scene.joints[wheel.joint]);
  }
  fact.value = idle.front().above;
  fact.limit = idle.front().travel;
  add_fact(std::move(fact), planned);
}

void add_test(const Plan& plan, const std::string& test, const Scene& scene,
              const DriveTrain& wheels, MountNotes& notes, Planned& planned) {
  const MountChoice mount = mount_of(plan, test, scene, wheels);
  const std::string why_not = why_not_free(test, mount);
  MadeTest made =
      why_not.empty() ? make_test(test, mounted(scene, mount.base), wheels) : MadeTest{{}, why_not};
  if (mount.tips_over) add_tipping(scene, planned);
  if (!made.scenario) {
    planned.left_out.push_back(test + ": " + made.why_not);
    return;
  }
  made.scenario->base = mount.base;
  if (mount.base == Base::kHang && is_better_solved_exactly(scene)) {
    made.scenario->solver = Solver::kDantzig;
  }
  if (!mount.why.empty()) notes.add(test, mount.why);
  if (!made.note.empty()) planned.notes.push_back(test + ": " + made.note);
  planned.scenarios.push_back(std::move(*made.scenario));
}

}  // namespace

Planned scenarios_of(const Plan& plan, const Scene& scene, const DriveTrain& wheels) {
  Planned planned;
  MountNotes notes;
  if (!plan.tests.empty()) add_idle_wheels(scene, wheels, planned);
  for (const std::string& test : plan.tests) {
    add_test(plan, test, scene, wheels, notes, planned);
  }
  for (std::string& note : notes.in_words()) planned.notes.push_back(std::move(note));
  Planner planner(scene, planned);
  for (const std::string& name : plan.wheels) planner.need_joint(name);
  for (const config::ScenarioFile& file : plan.scenarios) planner.add(file);
  for (Scenario& scenario : planned.scenarios) {
    if (plan.base == BaseOption::kFixed) scenario.base = Base::kFixed;
    if (plan.base == BaseOption::kHang) scenario.base = Base::kHang;
  }
  return planned;
}

}  // namespace rigor::simulate
