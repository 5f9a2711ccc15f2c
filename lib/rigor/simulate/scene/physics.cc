// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A world's `<physics>` and `<gravity>`. What it writes goes before the profile's values, but for the
// speed that contacts are pushed apart with.

#include <algorithm>
#include <cmath>
#include <string>

#include <rigor/simulate/scene/draft.h>

namespace rigor::simulate {
namespace {

/// ODE takes its work from this number; Gazebo's own worlds have up to 1000.
constexpr double kMaxIterations = 10'000;

/// Longer steps have nothing to do with motion: a meter falls in 0.45 s.
constexpr double kLongestStep = 1;  // s

/// The exact solver ends in an assertion with less where contacts are redundant.
constexpr double kMinDantzigCfm = 1e-9;

class PhysicsReader {
 public:
  PhysicsReader(SceneDraft& draft, const model::World& world, xml::Element physics)
      : draft_(draft), world_(world), physics_(physics), out_(draft.scene.solver) {}

  void read() {
    const auto ode = physics_.child("ode");
    const auto solver = ode ? ode->child("solver") : std::nullopt;
    const auto constraints = ode ? ode->child("constraints") : std::nullopt;
    out_.step = within(solver, "dt", out_.step, 0, kLongestStep, Least::kExcluded);
    out_.step = within(physics_, "max_step_size", out_.step, 0, kLongestStep, Least::kExcluded);
    if (const auto type = text(solver, "type")) {
      const bool exact = read::trimmed(type->text) == "world";
      out_.solver = exact ? Solver::kDantzig : Solver::kQuick;
    }
    out_.iterations = static_cast<int>(
        std::min(within(solver, "iters", out_.iterations, 1, 1e9), kMaxIterations));
    out_.sor = within(solver, "sor", out_.sor, 0, 2, Least::kExcluded);
    out_.erp = within(constraints, "erp", out_.erp, 0, 1);
    out_.cfm = within(constraints, "cfm", out_.cfm, 0, kFarthest);
    if (out_.solver == Solver::kDantzig) out_.cfm = std::max(out_.cfm, kMinDantzigCfm);
    // What a world writes is nearly always SDF's default of 100 m/s. Gazebo's engine has a second limit,
    // of a body (`max_vel`, 0.01 m/s), which Debian's has not: the profile's value is the most.
    const double most = out_.max_correcting_velocity;
    const double written = within(constraints, "contact_max_correcting_vel", most, 0, kFarthest);
    out_.max_correcting_velocity = std::min(written, most);
    out_.surface_layer =
        within(constraints, "contact_surface_layer", out_.surface_layer, 0, kFarthest);
    out_.max_contacts =
        static_cast<int>(within(physics_, "max_contacts", out_.max_contacts, 1, 1e6));
    say_what_is_ignored(solver);
  }

 private:
  enum class Least : std::uint8_t { kIncluded, kExcluded };

  static std::optional<read::Text> text(std::optional<xml::Element> from, std::string_view name) {
    return from ? read::child_text(*from, name) : std::nullopt;
  }

  double within(std::optional<xml::Element> from, std::string_view name, double fallback,
                double least, double most, Least end = Least::kIncluded) {
    const auto written = text(from, name);
    const double value = draft_.number(written, fallback, name, world_);
    const bool fits = value <= most && (end == Least::kExcluded ? value > least : value >= least);
    if (fits) return value;
    draft_.say(FactKind::kStep, written->span, world_, std::string(name), value,
               value > most ? most : least);
    return fallback;
  }

  void say_what_is_ignored(std::optional<xml::Element> solver) {
    const auto ignored = [this](Span where, std::string name) {
      draft_.say(FactKind::kElementIgnored, where, world_, std::move(name));
    };
    const auto type = read::attribute_text(physics_, "type");
    if (type && type->text != "ode") ignored(type->span, "physics " + std::string(type->text));
    const auto moment = text(solver, "use_dynamic_moi_rescaling");
    if (moment && read::bool_field(moment, false).value) {
      ignored(moment->span, "use_dynamic_moi_rescaling");
    }
    const auto friction = text(solver, "friction_model");
    if (friction && read::trimmed(friction->text) != "pyramid_model") {
      ignored(friction->span, "friction_model");
    }
    const auto before = text(solver, "precon_iters");
    if (before && draft_.number(before, 0, "precon_iters", world_) != 0) {
      ignored(before->span, "precon_iters");
    }
  }

  SceneDraft& draft_;
  const model::World& world_;
  xml::Element physics_;
  SolverSettings& out_;
};

/// The one marked as default; else the first.
const model::Physics* physics_of(const model::Root& root, model::Id<model::World> world) {
  const model::Physics* found = nullptr;
  for (const model::Physics& physics : root.physics) {
    if (physics.world != world) continue;
    if (found == nullptr || (physics.is_default.value && !found->is_default.value)) {
      found = &physics;
    }
  }
  return found;
}

void add_gravity(SceneDraft& draft, const model::World& world, const model::Physics* physics) {
  draft.scene.gravity = world.gravity.value;
  if (world.gravity.written) return;
  const auto look = [&](xml::Element holder) {  // for what is no vector
    auto text = read::child_text(holder, "gravity");
    if (const auto element = holder.child("gravity")) {
      if (const auto old = read::value_attribute(*element, "xyz")) text = old;
    }
    if (!text || read::trimmed(text->text).empty()) return;
    if (!read::vector_field(text, {}).written) {
      draft.say(FactKind::kNotFinite, text->span, world, "gravity");
    }
  };
  if (physics != nullptr) look(draft.element(physics->site));
  look(draft.element(world.site));
}

}  // namespace

void add_physics(SceneDraft& draft) {
  SolverSettings& solver = draft.scene.solver;
  if (draft.options.profile == SceneOptions::Profile::kGazebo) {
    solver.iterations = 50;
    solver.cfm = 0;
    solver.max_correcting_velocity = 0.01;  // Gazebo's engine: `max_vel` of a body
    solver.stiffness = true;
  }
  if (draft.root.worlds.empty()) return;
  const model::World& world = draft.root.worlds.front();
  const model::Physics* physics = physics_of(draft.root, {0});
  add_gravity(draft, world, physics);
  if (physics != nullptr) PhysicsReader(draft, world, draft.element(physics->site)).read();
}

}  // namespace rigor::simulate
