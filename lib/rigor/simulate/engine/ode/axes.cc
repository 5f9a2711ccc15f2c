// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Axes at work. ODE has one motor for each, with a velocity and a largest effort; what is in it:
//
//   a velocity command, else friction (velocity 0, as Gazebo does it), else damping (a motor of velocity
//   0 that gives way by 1/damping, which is the implicit damper and stable for any damping).
//
// Springs, efforts, and damping when the motor is taken, are forces. A force that grows with the speed or
// the way is stable only while damping·h/inertia and stiffness·h²/inertia are below 2 and 4 (E. Hairer,
// C. Lubich, G. Wanner, "Geometric Numerical Integration", 2006, §I.1). Where one is above 1, spring and damper are a
// row of their own (firm.cc).
//
// A motor and friction on one axis: two rows of the same axis would fight, and the iterative solver ends them
// anywhere. They are one row, whose limit depends on which way the friction works. What stands is held by the sum of
// both until the effort that this takes is one that the motor gives beyond the friction; what is driven has the
// difference, and what is braked the sum.
//
// A motor at a stop: ODE adds all of its effort as a force, which shoots the joint away. So what presses
// against a stop has no motor there, and what holds or leaves has no stop.

#include <algorithm>
#include <cmath>
#include <string>

#include <rigor/simulate/engine/ode/world.h>

namespace rigor::simulate {
namespace {

constexpr double kTurn = 6.283185307179586;

/// rad or m: a motor that leaves a stop is trusted up to here behind it. What it cannot move is held by
/// the stop beyond.
constexpr double kStopSlack = 1e-4;

/// Share of its velocity limit by which a motor falls behind at most, under all of its effort: a slow one would
/// stand still under the world's own constraint force mixing.
constexpr double kMotorLag = 0.02;

/// rad/s or m/s: a joint that is slower stands, and its friction holds it. A row of force mixing creeps by less.
constexpr double kStands = 1e-3;

/// Of a limit: a row that gives it all, but for rounding.
constexpr double kAllOfIt = 0.999;

/// Share of a coupling's error, of position and of speed, that a step takes away: the sum of the first
/// and twice the second may be 4, of which half is kept since two coordinates share bodies.
constexpr double kCouplingPosition = 0.4;
constexpr double kCouplingSpeed = 0.6;
/// rad/s or m/s: an error at the start is not closed faster.
constexpr double kCouplingHaste = 10;

void set_ode_param(const Coordinate& c, int parameter, double value) {
  using Kind = Coordinate::Kind;
  switch (c.kind) {
    case Kind::kHinge: dJointSetHingeParam(c.joint, parameter, value); return;
    case Kind::kSlider: dJointSetSliderParam(c.joint, parameter, value); return;
    case Kind::kUniversalFirst:
      dJointSetUniversalParam(c.joint, parameter + dParamGroup2, value);
      return;
    case Kind::kUniversalSecond: dJointSetUniversalParam(c.joint, parameter, value); return;
    case Kind::kScrewTurn: dJointSetPistonParam(c.joint, parameter + dParamGroup2, value); return;
    case Kind::kScrewSlide: dJointSetPistonParam(c.joint, parameter, value); return;
    case Kind::kFree: return;
  }
}

bool has_stops(const SceneAxis& axis) { return axis.lower > -kInfinity || axis.upper < kInfinity; }

/// Which stop the axis is at, as ODE will find: -1, 1, or 0; and how far beyond.
struct AtStop {
  int side = 0;
  double beyond = 0;
};

AtStop stop_of(const Coordinate& c) {
  if (!has_stops(c.written)) return {};
  const double around = is_angle(c.kind) ? kTurn * c.turns : 0;
  const double q = raw_position(c);
  if (q <= c.written.lower - around) return {-1, c.written.lower - around - q};
  if (q >= c.written.upper - around) return {1, q - (c.written.upper - around)};
  return {};
}

Vector3 speed_of_turning(dBodyID body) {
  return body == nullptr ? Vector3{} : vector_of(dBodyGetAngularVel(body));
}

/// How fast one side slides along the axis as seen from the other, which may turn: ODE's own rate leaves
/// the turning out.
double speed_of_sliding(const Coordinate& c) {
  const auto speed = [](dBodyID body) {
    return body == nullptr ? Vector3{} : vector_of(dBodyGetLinearVel(body));
  };
  Vector3 apart = speed(c.plus) - speed(c.minus);
  if (c.plus != nullptr && c.minus != nullptr) {
    const Vector3 between =
        vector_of(dBodyGetPosition(c.plus)) - vector_of(dBodyGetPosition(c.minus));
    apart = apart - cross(speed_of_turning(c.minus), between);
  }
  return dot(c.axis_W, apart);
}

double speed_of(const Coordinate& c) {
  if (!is_angle(c.kind)) return speed_of_sliding(c);
  return dot(c.axis_W, speed_of_turning(c.plus) - speed_of_turning(c.minus));
}

/// ODE knows angles up to half a turn. The stops of an axis that has gone round are moved along.
void set_ode_stops(const Coordinate& c, int without = 0) {
  const double around = is_angle(c.kind) ? kTurn * c.turns : 0;
  const double low = without < 0 ? -dInfinity : c.written.lower - around;
  double high = without > 0 ? dInfinity : c.written.upper - around;
  // ODE's hinge forgets no stop that it was at once neither is within half a turn: it would drive the motor
  // with all its effort from there on. Its angle is always below half a turn.
  if (is_angle(c.kind) && has_stops(c.written) && low < kTurn / 2) {
    high = std::min(high, kTurn / 2);
  }
  set_ode_param(c, dParamLoStop, low);
  set_ode_param(c, dParamHiStop, high);
}

void set_ode_motor(const Coordinate& c, double velocity, double effort, double cfm) {
  set_ode_param(c, dParamVel, velocity);
  set_ode_param(c, dParamFMax, effort);
  set_ode_param(c, dParamCFM, cfm);
}

}  // namespace

bool is_angle(Coordinate::Kind kind) {
  return kind != Coordinate::Kind::kSlider && kind != Coordinate::Kind::kScrewSlide;
}

void add_effort(const Coordinate& c, double effort) {
  if (c.kind == Coordinate::Kind::kSlider) {
    dJointAddSliderForce(c.joint, effort);
    return;
  }
  if (c.kind == Coordinate::Kind::kScrewSlide) {
    dJointAddPistonForce(c.joint, effort);
    return;
  }
  const Vector3 t = effort * c.axis_W;
  if (c.plus != nullptr) dBodyAddTorque(c.plus, t.x, t.y, t.z);
  if (c.minus != nullptr) dBodyAddTorque(c.minus, -t.x, -t.y, -t.z);
}

double raw_position(const Coordinate& c) {
  using Kind = Coordinate::Kind;
  switch (c.kind) {
    case Kind::kHinge: return dJointGetHingeAngle(c.joint);
    case Kind::kSlider: return dJointGetSliderPosition(c.joint);
    case Kind::kUniversalFirst: return dJointGetUniversalAngle2(c.joint);
    case Kind::kUniversalSecond: return dJointGetUniversalAngle1(c.joint);
    case Kind::kScrewTurn: return dJointGetPistonAngle(c.joint);
    case Kind::kScrewSlide: return dJointGetPistonPosition(c.joint);
    case Kind::kFree: return c.state.position;
  }
  return 0;
}

Coordinate& EngineJoints::at(std::uint32_t joint, std::uint32_t axis) {
  if (joint + 1 >= first_.size() || first_[joint] + axis >= first_[joint + 1]) {
    throw EngineError("a command for an axis that is not there");
  }
  return coordinates_[first_[joint] + axis];
}

void EngineJoints::set_effort(std::uint32_t joint, std::uint32_t axis, double effort) {
  Coordinate& c = at(joint, axis);
  const bool fresh = c.command != Coordinate::Command::kEffort;
  c.command = Coordinate::Command::kEffort;
  c.told = std::clamp(effort, -c.written.effort, c.written.effort);
  if (fresh) update(c);
}

void EngineJoints::set_motor(std::uint32_t joint, std::uint32_t axis, double velocity,
                             double effort) {
  Coordinate& c = at(joint, axis);
  c.command = Coordinate::Command::kMotor;
  c.told = velocity;
  c.yields = false;
  c.most = std::min(effort, c.written.effort);
  const double lag = kMotorLag * c.written.velocity / c.most;
  c.give = lag > 0 ? std::min(cfm_, lag) : cfm_;
  turn_on(c, joint);
}

/// With k and d of a step h, the effort k (e - h v) + d (r - v) of the speed v that the step ends with: a motor
/// of speed (k e + d r)/(d + h k) that gives way by 1/(d + h k).
void EngineJoints::set_servo(std::uint32_t joint, std::uint32_t axis, const Servo& servo) {
  Coordinate& c = at(joint, axis);
  const double firmness = servo.damping + step_ * servo.stiffness;
  c.command = Coordinate::Command::kMotor;
  c.told =
      firmness > 0 ? (servo.stiffness * servo.error + servo.damping * servo.rate) / firmness : 0;
  c.yields = true;
  c.most = firmness > 0 ? std::min(servo.effort, c.written.effort) : 0;
  c.give = std::max(cfm_, firmness > 0 ? 1 / firmness : 0);
  turn_on(c, joint);
}

void EngineJoints::turn_on(Coordinate& c, std::uint32_t joint) {
  update(c);
  if (c.joint == nullptr || feedback_[joint] != nullptr) return;
  feedback_[joint] = std::make_unique<dJointFeedback>();
  dJointSetFeedback(c.joint, feedback_[joint].get());
}

void EngineJoints::release(std::uint32_t joint, std::uint32_t axis) {
  Coordinate& c = at(joint, axis);
  c.command = Coordinate::Command::kNone;
  c.told = 0;
  update(c);
}

/// After a change of command: what the motor is used for, and whether each step has something to do.
void EngineJoints::update(Coordinate& c) const {
  const SceneAxis& axis = c.written;
  const bool motor = c.command == Coordinate::Command::kMotor;
  if (c.joint != nullptr) {
    set_ode_param(c, dParamStopERP, axis.stop_erp);
    set_ode_param(c, dParamStopCFM, axis.stop_cfm);
    set_ode_stops(c);
    use_slot(c);
  }
  c.busy = c.command == Coordinate::Command::kEffort || axis.spring_stiffness > 0 ||
           c.firm != nullptr || (axis.damping > 0 && (!c.damps || has_stops(axis))) ||
           (motor && (has_stops(axis) || axis.friction > 0)) ||
           (c.joint == nullptr && (motor || axis.friction > 0));
}

void EngineJoints::use_slot(Coordinate& c) const {
  const SceneAxis& axis = c.written;
  const AtStop stop = stop_of(c);
  c.damps = false;
  c.drives = false;
  if (c.command == Coordinate::Command::kMotor) {
    const bool locked = axis.upper - axis.lower <= 2 * kStopSlack;  // it is at the other stop too
    const bool presses =
        stop.side != 0 && (locked || c.told * stop.side > 0 || stop.beyond > kStopSlack);
    c.drives = !presses;
    if (presses) {
      set_ode_motor(c, c.told, 0, c.give);
    } else {
      drive_slot(c);
    }
    if (has_stops(axis)) set_ode_stops(c, presses ? 0 : stop.side);
  } else if (axis.friction > 0) {
    set_ode_motor(c, 0, axis.friction, cfm_);
  } else if (axis.damping > 0 && stop.side == 0 && c.firm == nullptr) {
    set_ode_motor(c, 0, dInfinity, 1 / axis.damping);
    c.damps = true;
  } else {
    set_ode_motor(c, 0, 0, cfm_);
  }
}

/// The motor with the joint's friction.
void EngineJoints::drive_slot(Coordinate& c) const {
  const double friction = c.written.friction;
  c.held = c.held && friction > 0;
  if (!(friction > 0) || !(c.most < kInfinity)) return set_ode_motor(c, c.told, c.most, c.give);
  if (c.yields) return set_ode_motor(c, c.told, c.most + friction, c.give);
  const double way = c.told < 0 ? -1 : 1;
  const double wanted = way * c.told;
  const double speed = way * c.state.velocity;
  const double beyond = c.most - friction;  // what the motor gives beyond it
  const bool stands = std::abs(speed) <= kStands;
  if (wanted <= kStands || speed < -kStands || (stands && c.held && way * c.row >= beyond)) {
    c.held = true;
    return set_ode_motor(c, 0, c.most + friction, c.give);
  }
  c.held = false;
  // Friction that the motor does not overcome brakes by itself, and only what is more is the motor's to brake.
  const bool brakes = beyond >= 0 ? speed > wanted || way * c.row < 0
                                  : speed > wanted && way * c.row <= kAllOfIt * beyond;
  if (brakes) {
    return set_ode_motor(c, c.told, c.most + friction, c.give);
  }
  set_ode_motor(c, beyond > 0 ? c.told : 0, std::abs(beyond), c.give);
}

void EngineJoints::apply(Coordinate& c) const {
  const SceneAxis& axis = c.written;
  const double q = c.state.position;
  const double v = c.state.velocity;
  const bool motor = c.command == Coordinate::Command::kMotor;
  if (c.joint != nullptr && (has_stops(axis) || (motor && axis.friction > 0))) use_slot(c);
  double effort = 0;
  if (c.firm != nullptr) {
    // Two stiff rows of one axis do not converge. At a stop nothing moves, and the spring is a force.
    const double spring = -axis.spring_stiffness * (q - axis.spring_reference);
    const bool presses = spring * stop_of(c).side > 0;
    if (presses) effort = spring;
    set_firm(c, step_, presses ? Row::kOff : Row::kOn);
  } else {
    effort = -axis.spring_stiffness * (q - axis.spring_reference);
    if (!c.damps) effort -= axis.damping * v;
  }
  if (c.joint == nullptr) {
    const double stopping = -v * c.inertia / step_;
    const double driving = c.told * c.inertia / step_ + stopping;
    effort += motor ? std::clamp(driving, -c.most, c.most)
                    : std::clamp(stopping, -axis.friction, axis.friction);
  }
  if (c.command == Coordinate::Command::kEffort) effort += c.told;
  add_effort(c, effort);
}

void EngineJoints::apply(const Coupling& coupling) const {
  const Coordinate& follower = coordinates_[coupling.follower];
  const Coordinate& leader = coordinates_[coupling.leader];
  const double leads = leader.state.position + leader.written.start - coupling.reference;
  const double follows = follower.state.position + follower.written.start - coupling.offset;
  const double error = follows - coupling.multiplier * leads;
  const double rate = follower.state.velocity - coupling.multiplier * leader.state.velocity;
  const double closing =
      std::clamp(kCouplingPosition * error / step_, -kCouplingHaste, kCouplingHaste);
  const double effort = -coupling.inertia / step_ * (closing + kCouplingSpeed * rate);
  add_effort(follower, effort);
  add_effort(leader, -coupling.multiplier * effort);
}

/// The inertia that the pair of forces meets at least.
void EngineJoints::couple(Coupling& coupling) const {
  const double m = coupling.multiplier;
  coupling.inertia = 1 / (1 / coordinates_[coupling.follower].inertia +
                          m * m / coordinates_[coupling.leader].inertia);
  if (!(coupling.inertia < kInfinity)) coupling.inertia = 0;  // nothing gives way
}

void EngineJoints::apply() {
  for (Coordinate& c : coordinates_) {
    if (c.busy) apply(c);
  }
  for (const Coupling& coupling : couplings_) apply(coupling);
}

void EngineJoints::read(Coordinate& c) const {
  c.axis_W = in_world(c.carrier, c.axis);
  c.state.velocity = speed_of(c);
  if (c.kind == Coordinate::Kind::kFree) {
    c.state.position += step_ * c.state.velocity;
    return;
  }
  const double raw = raw_position(c);
  if (!is_angle(c.kind)) {
    c.state.position = raw;
    return;
  }
  const int before = c.turns;
  c.turns = static_cast<int>(std::lround((c.state.position - raw) / kTurn));
  c.state.position = raw + kTurn * c.turns;
  if (c.turns != before && has_stops(c.written)) set_ode_stops(c);
}

/// What a command put in during the last step. A motor's is what the joint did along its axis: its force
/// and torque on its first body, about the anchor. Without the motor that is the stop's.
double EngineJoints::effort_of(Coordinate& c, std::size_t joint) const {
  c.row = 0;
  if (c.command == Coordinate::Command::kEffort) return c.told;
  const dJointFeedback* did = feedback_[joint].get();
  if (c.command != Coordinate::Command::kMotor || did == nullptr || !c.drives) return 0;
  const Anchors& anchors = anchors_[joint];
  const bool child = anchors.child != nullptr;
  const Vector3 force = vector_of(did->f1);
  const Vector3 lever =
      child ? in_world(anchors.child, anchors.p_child) : in_world(anchors.parent, anchors.p_parent);
  const Vector3 torque = vector_of(did->t1) - cross(lever, force);
  c.row = (child ? 1 : -1) * dot(c.axis_W, is_angle(c.kind) ? torque : force);
  if (!(c.most < kInfinity) || !(c.written.friction > 0)) return std::clamp(c.row, -c.most, c.most);
  // The friction bears what it can of what stands, and works against what moves.
  const double friction =
      std::clamp(c.held || c.yields ? c.row : std::copysign(c.written.friction, -c.told),
                 -c.written.friction, c.written.friction);
  return std::clamp(c.row - friction, -c.most, c.most);
}

void EngineJoints::read(State& state) {
  const std::size_t axes = first_.back();
  state.axes.resize(axes);
  for (std::size_t joint = 0; joint + 1 < first_.size(); ++joint) {
    for (std::size_t i = first_[joint]; i < first_[joint + 1]; ++i) {
      Coordinate& c = coordinates_[i];
      const double before = c.state.velocity;
      c.state.effort = effort_of(c, joint);
      read(c);
      state.motor_work += c.state.effort * (before + c.state.velocity) / 2 * step_;
      state.axes[i] = c.state;
      state.axes[i].position += c.written.start;
    }
  }
  for (std::size_t i = axes; i < coordinates_.size(); ++i) read(coordinates_[i]);
  read_anchors(state);
}

void EngineJoints::read_anchors(State& state) const {
  state.anchor_error = 0;
  state.anchor_joint = kWorld;
  const auto place = [](dBodyID body, const Vector3& p) {
    return body == nullptr ? p : vector_of(dBodyGetPosition(body)) + in_world(body, p);
  };
  for (std::uint32_t joint = 0; joint < anchors_.size(); ++joint) {
    const Anchors& anchors = anchors_[joint];
    if (!anchors.hold) continue;
    Vector3 gap = place(anchors.child, anchors.p_child) - place(anchors.parent, anchors.p_parent);
    if (anchors.slides) {
      const Vector3 axis = in_world(anchors.parent, anchors.axis_parent);
      gap = gap - dot(gap, axis) * axis;
    }
    const double error = model::length(gap);
    if (error <= state.anchor_error) continue;
    state.anchor_error = error;
    state.anchor_joint = joint;
  }
}

}  // namespace rigor::simulate
