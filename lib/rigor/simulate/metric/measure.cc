// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Called at each of some 50,000 steps a second: no square root or angle more
// than a peak needs, and no memory beyond what the first steps took.

#include <rigor/simulate/metric/measure.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include <rigor/simulate/footing.h>

namespace rigor::simulate {

struct Watch::StepPeaks {
  Peak speed, residual, acceleration, energy, tilt, limit_violation, penetration, self_contact;
  std::uint32_t self_contact_with = kWorld;
  bool contacts_changed = false;
  Vector3 ground_force;
};

namespace {

double kinetic_energy(const mass::MassProperties& body, const BodyState& state) {
  const Vector3 w = model::rotate(model::conjugate(state.R_WB), state.w_WB);
  const double turning = mass::moment_about(w, body.about_com);
  return (body.mass * dot(state.v_WBcm, state.v_WBcm) + turning) / 2;
}

double tilt_of(const Vector3& up) { return std::atan2(std::hypot(up.x, up.y), up.z); }

/// Share of the last value that a first-order high-pass keeps: RC/(RC + h).
double jitter_filter(double step) {
  const double rc = 1 / (2 * std::numbers::pi * kJitterFrequency);
  return rc / (rc + step);
}

/// m: how far a shape may reach from its body's center of mass; no more than all of the scene.
double reach_from_center(const SceneBody& body, const SceneShape& shape, double most) {
  const double reach = length(shape.X_BS.translation - body.mass.com) + shape.extent / 2;
  return reach < most ? reach : most;
}

/// A ball has no upright: it rolls.
bool is_ball(const Scene& scene, std::uint32_t model) {
  std::size_t balls = 0, shapes = 0;
  for (const SceneShape& shape : scene.shapes) {
    if (shape.body >= scene.bodies.size() || scene.bodies[shape.body].model != model) continue;
    ++shapes;
    balls += std::holds_alternative<mesh::Sphere>(shape.kind) ? 1 : 0;
  }
  return shapes == 1 && balls == 1;
}

void merge_peak(Peak& into, const Peak& from) { into.see(from.value, from.of, from.at); }

void begin_phase(PhaseMeasures& phase, const std::vector<BodyState>& bodies,
                 const std::vector<AxisState>& axes, std::size_t models) {
  phase.begin = phase.end = bodies;
  phase.axis_begin.clear();
  for (const AxisState& axis : axes) phase.axis_begin.push_back(axis.position);
  phase.axis_min = phase.axis_max = phase.axis_end = phase.axis_begin;
  phase.axis_path.assign(axes.size(), 0);
  phase.axis_effort.assign(axes.size(), 0);
  phase.jitter_square.assign(axes.size(), 0);
  phase.vertical_square.assign(models, 0);
  phase.yaw_path.assign(models, 0);
}

}  // namespace

Watch::Watch(const Scene& scene, const Scenario& scenario, const SolverSettings& settings)
    : scenario_(scenario),
      step_(settings.step),
      filter_(jitter_filter(settings.step)),
      gravity_(scenario.gravity ? scene.gravity : Vector3{}) {
  const std::vector<bool> free = moving_freely(scene, scenario);
  const std::vector<Footing> footings = footings_of(scene);
  const auto kind_of = [&](std::uint32_t model) {
    return model < footings.size() ? footings[model].kind : Footing::Kind::kStands;
  };
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    const bool falls = kind_of(body.model) == Footing::Kind::kInTheAir;
    bodies_.push_back(
        {body.mass, body.gravity ? body.mass.mass : 0, !body.kinematic, falls, !free[i], 0});
    conserves_ = conserves_ && !body.kinematic;
  }
  for (const SceneJoint& joint : scene.joints) {
    for (const SceneAxis& axis : joint.axes) {
      axes_.push_back(
          {axis.lower, axis.upper, axis.effort, axis.spring_stiffness, axis.spring_reference});
    }
  }
  for (const SceneShape& shape : scene.shapes) {
    const bool of_world = shape.body >= scene.bodies.size();
    if (!of_world) {
      double& radius = bodies_[shape.body].radius;
      radius = std::max(radius, reach_from_center(scene.bodies[shape.body], shape, scene.size));
    }
    shapes_.push_back(
        {of_world ? kWorld : shape.body, of_world ? kWorld : scene.bodies[shape.body].model});
  }
  for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
    const SceneModel& model = scene.models[m];
    if (model.is_static || model.base >= scene.bodies.size()) {
      bases_.push_back({});
      continue;
    }
    const Quaternion R_BW = model::conjugate(scene.bodies[model.base].X_WB.rotation);
    bases_.push_back({model.base, model::rotate(R_BW, {0, 0, 1}),
                      kind_of(m) == Footing::Kind::kStands && !is_ball(scene, m)});
  }
  measures_.phases.resize(scenario.phases.size());
}

void Watch::see(const State& state) {
  if (!started_) return start(state);
  if (state.time > next_change_) change_phases(state.time);
  StepPeaks peaks;
  see_bodies(state, peaks);
  see_energy(state, peaks);
  see_axes(state, peaks);
  see_contacts(state, peaks);
  for (const std::uint32_t i : active_) add_to(measures_.phases[i], state, peaks);
  before_ = state.bodies;
  axes_before_ = state.axes;
}

void Watch::start(const State& state) {
  started_ = true;
  before_ = state.bodies;
  axes_before_ = state.axes;
  energy_base_ = energy_before_ = energy(state);
  for (std::size_t i = 0; i < axes_.size() && i < state.axes.size(); ++i) {
    axes_[i].seen = state.axes[i].velocity;
  }
  for (const ContactState& contact : state.contacts) {
    const WatchedShape& a = shapes_[contact.shape_a];
    const WatchedShape& b = shapes_[contact.shape_b];
    if (a.body == kWorld || b.body == kWorld) {
      const std::uint32_t mover = a.body == kWorld ? contact.shape_b : contact.shape_a;
      measures_.spawn_penetration.see(contact.depth, mover, state.time);
      ++ground_contacts_before_;
    } else if (contact.depth > measures_.spawn_overlap.value) {
      measures_.spawn_overlap = {contact.depth, contact.shape_a, state.time};
      measures_.spawn_overlap_with = contact.shape_b;
    }
  }
  contacts_before_ = state.contacts.size();
  change_phases(state.time);
}

// A phase has the steps that end after its begin. Half a step is added to its
// bounds, so that the rounding of summed steps makes no difference.
void Watch::change_phases(double time) {
  active_.clear();
  next_change_ = kInfinity;
  for (std::uint32_t i = 0; i < scenario_.phases.size(); ++i) {
    const double begin = scenario_.phases[i].begin + step_ / 2;
    const double end = scenario_.phases[i].end + step_ / 2;
    if (time > end) continue;
    next_change_ = std::min(next_change_, time > begin ? end : begin);
    PhaseMeasures& phase = measures_.phases[i];
    if (phase.steps == 0) begin_phase(phase, before_, axes_before_, bases_.size());
    if (time > begin) active_.push_back(i);
  }
}

void Watch::see_bodies(const State& state, StepPeaks& peaks) {
  // A new contact stops what moves within one step; that is an impact, and no
  // chatter.
  const bool impact = state.contacts.size() > contacts_before_;
  contacts_before_ = state.contacts.size();
  double fastest = 0;  // squares
  double hardest = 0;
  bool slow = true;
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].moves) continue;
    const BodyState& body = state.bodies[i];
    const double v_square = dot(body.v_WBcm, body.v_WBcm);
    const double w_square = dot(body.w_WB, body.w_WB);
    const Vector3 change = body.v_WBcm - before_[i].v_WBcm;
    const double change_square = dot(change, change);
    if (bodies_[i].rests) {
      slow = slow && v_square < kSettledSpeed * kSettledSpeed &&
             w_square < kSettledTurn * kSettledTurn;
      peaks.residual.see(std::sqrt(v_square) + bodies_[i].radius * std::sqrt(w_square), i,
                         state.time);
    }
    if (v_square > fastest && !bodies_[i].falls) {
      fastest = v_square;
      peaks.speed = {0, i, state.time};
    }
    if (!impact && change_square > hardest) {
      hardest = change_square;
      peaks.acceleration = {0, i, state.time};
    }
  }
  peaks.speed.value = std::sqrt(fastest);
  peaks.acceleration.value = std::sqrt(hardest) / step_;
  for (std::uint32_t m = 0; m < bases_.size(); ++m) {
    if (!bases_[m].stands) continue;
    const Vector3 up = model::rotate(state.bodies[bases_[m].body].R_WB, bases_[m].up_B);
    peaks.tilt.see(tilt_of(up), m, state.time);
  }
  see_settling(state.time, slow);
}

void Watch::see_settling(double time, bool slow) {
  if (measures_.settle_time < kInfinity) return;
  if (!slow) {
    slow_since_ = kInfinity;
  } else if (slow_since_ == kInfinity) {
    slow_since_ = time - step_;
  } else if (time - slow_since_ >= kSettleHold) {
    measures_.settle_time = slow_since_;
  }
}

double Watch::energy(const State& state) const {
  double sum = -state.motor_work;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyState& body = state.bodies[i];
    sum += kinetic_energy(bodies_[i].mass, body) - bodies_[i].weight * dot(gravity_, body.p_WBcm);
  }
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (axes_[i].spring_stiffness == 0) continue;
    const double off = state.axes[i].position - axes_[i].spring_reference;
    sum += axes_[i].spring_stiffness * off * off / 2;
  }
  return sum;
}

bool Watch::work_from_outside(double time) const {
  const auto tilting = [&](const Tilt& tilt) { return time >= tilt.begin; };
  // Whether a push belongs to the step before or after its moment is the run's
  // to decide.
  const auto pushed = [&](const Push& push) { return std::abs(time - push.at) < 1.5 * step_; };
  return std::any_of(scenario_.tilts.begin(), scenario_.tilts.end(), tilting) ||
         std::any_of(scenario_.pushes.begin(), scenario_.pushes.end(), pushed);
}

void Watch::see_energy(const State& state, StepPeaks& peaks) {
  if (!conserves_) return;
  const double now = energy(state);
  if (work_from_outside(state.time)) energy_base_ += now - energy_before_;
  energy_before_ = now;
  peaks.energy.see(now - energy_base_, kWorld, state.time);
}

void Watch::see_axes(const State& state, StepPeaks& peaks) {
  for (std::uint32_t i = 0; i < axes_.size(); ++i) {
    const AxisState& now = state.axes[i];
    WatchedAxis& axis = axes_[i];
    const double first = filter_ * (axis.first + now.velocity - axis.seen);
    axis.second = filter_ * (axis.second + first - axis.first);
    axis.first = first;
    axis.seen = now.velocity;
    axis.given += step_ / (kBlow + step_) * (now.effort - axis.given);
    const double beyond = std::max(now.position - axis.upper, axis.lower - now.position);
    peaks.limit_violation.see(beyond, i, state.time);
  }
}

void Watch::see_contacts(const State& state, StepPeaks& peaks) {
  const bool supports = !scenario_.phases.empty() &&
                        state.time <= scenario_.phases[0].end + step_ / 2 &&
                        state.time > scenario_.phases[0].end - kSupportWindow;
  std::size_t with_ground = 0;
  for (const ContactState& contact : state.contacts) {
    const WatchedShape& a = shapes_[contact.shape_a];
    const WatchedShape& b = shapes_[contact.shape_b];
    if (a.body == kWorld || b.body == kWorld) {
      const bool a_moves = a.body != kWorld;
      ++with_ground;
      peaks.penetration.see(contact.depth, a_moves ? contact.shape_a : contact.shape_b, state.time);
      peaks.ground_force = peaks.ground_force + (a_moves ? 1.0 : -1.0) * contact.force;
      if (supports) measures_.support.push_back({a_moves ? a.model : b.model, contact.point});
    } else if (a.model == b.model && contact.depth > peaks.self_contact.value) {
      peaks.self_contact = {contact.depth, contact.shape_a, state.time};
      peaks.self_contact_with = contact.shape_b;
    }
  }
  peaks.contacts_changed = with_ground != ground_contacts_before_;
  ground_contacts_before_ = with_ground;
}

void Watch::add_to(PhaseMeasures& phase, const State& state, const StepPeaks& peaks) const {
  ++phase.steps;
  merge_peak(phase.speed, peaks.speed);
  merge_peak(phase.residual, peaks.residual);
  merge_peak(phase.acceleration, peaks.acceleration);
  merge_peak(phase.energy, peaks.energy);
  merge_peak(phase.tilt, peaks.tilt);
  merge_peak(phase.limit_violation, peaks.limit_violation);
  merge_peak(phase.penetration, peaks.penetration);
  phase.anchor_error.see(state.anchor_error, state.anchor_joint, state.time);
  phase.sunk = peaks.penetration;
  if (peaks.self_contact.value > phase.self_contact.value) {
    phase.self_contact = peaks.self_contact;
    phase.self_contact_with = peaks.self_contact_with;
  }
  if (peaks.tilt.value > kTipped) phase.tipped = std::min(phase.tipped, state.time);
  phase.contact_changes += peaks.contacts_changed ? 1 : 0;
  phase.ground_force = phase.ground_force + peaks.ground_force;
  for (std::size_t m = 0; m < bases_.size(); ++m) {
    if (bases_[m].body == kWorld) continue;
    const BodyState& base = state.bodies[bases_[m].body];
    phase.vertical_square[m] += base.v_WBcm.z * base.v_WBcm.z;
    phase.yaw_path[m] += base.w_WB.z * step_;
  }
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const AxisState& axis = state.axes[i];
    phase.jitter_square[i] += axes_[i].second * axes_[i].second;
    phase.axis_min[i] = std::min(phase.axis_min[i], axis.position);
    phase.axis_max[i] = std::max(phase.axis_max[i], axis.position);
    phase.axis_path[i] += axis.velocity * step_;
    phase.axis_end[i] = axis.position;
    if (axes_[i].effort > 0) {
      const double share = std::abs(axes_[i].given) / axes_[i].effort;
      phase.axis_effort[i] = std::max(phase.axis_effort[i], share);
    }
  }
  phase.end = state.bodies;
}

}  // namespace rigor::simulate
