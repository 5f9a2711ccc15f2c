// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Makes the scene's joints. ODE's hinge, slider, ball, universal and fixed are used as they are, with the
// child first, so that a position is the child's against the parent, as SDF has it. A revolute2 is a
// universal, whose axes stand at right angles. A screw is ODE's piston (it turns and slides along one
// axis), a gearbox no joint at all; their axes, like those that mimic, are held together by forces
// (axes.cc).

#include <algorithm>
#include <cmath>
#include <string>

#include <rigor/simulate/engine/ode/world.h>
#include <rigor/simulate/run.h>

namespace rigor::simulate {
namespace {

/// A point of W, from a body's center in its axes; for the world the point itself.
Vector3 point_in(dBodyID body, const Vector3& p_W) {
  if (body == nullptr) return p_W;
  return in_body(body, p_W - vector_of(dBodyGetPosition(body)));
}

/// How easily a body gives way to a torque about an axis, 1/(kg·m²).
double turning_ease(dBodyID body, const Vector3& axis_W) {
  if (body == nullptr || dBodyIsKinematic(body) != 0) return 0;
  dMass mass;
  dBodyGetMass(body, &mass);
  dMatrix3 inverse;
  const Vector3 a = in_body(body, axis_W);
  const dReal* I = mass.I;
  // aᵀ I⁻¹ a by the adjugate; the tensor is symmetric and positive (ODE has checked).
  inverse[0] = I[5] * I[10] - I[6] * I[6];
  inverse[1] = I[2] * I[6] - I[1] * I[10];
  inverse[2] = I[1] * I[6] - I[2] * I[5];
  inverse[5] = I[0] * I[10] - I[2] * I[2];
  inverse[6] = I[1] * I[2] - I[0] * I[6];
  inverse[10] = I[0] * I[5] - I[1] * I[1];
  const double det = I[0] * inverse[0] + I[1] * inverse[1] + I[2] * inverse[2];
  const double sum = a.x * a.x * inverse[0] + a.y * a.y * inverse[5] + a.z * a.z * inverse[10] +
                     2 * (a.x * a.y * inverse[1] + a.x * a.z * inverse[2] + a.y * a.z * inverse[6]);
  return sum / det;
}

/// … to a force along an axis at a point, 1/kg.
double sliding_ease(dBodyID body, const Vector3& axis_W, const Vector3& p_W) {
  if (body == nullptr || dBodyIsKinematic(body) != 0) return 0;
  dMass mass;
  dBodyGetMass(body, &mass);
  const Vector3 lever = cross(p_W - vector_of(dBodyGetPosition(body)), axis_W);
  const double arm = model::length(lever);
  if (!(arm > 0)) return 1 / mass.mass;
  return 1 / mass.mass + arm * arm * turning_ease(body, (1 / arm) * lever);
}

/// Sine of the angle between two axes below which they are taken for parallel.
constexpr double kMinAngle = 1e-3;

std::size_t engine_axes_of(model::JointType type) {
  using Type = model::JointType;
  switch (type) {
    case Type::kRevolute:
    case Type::kContinuous:
    case Type::kPrismatic:
    case Type::kScrew: return 1;
    case Type::kUniversal:
    case Type::kRevolute2:
    case Type::kGearbox: return 2;
    default: return 0;
  }
}

}  // namespace

EngineJoints::EngineJoints(const Scene& scene, const SolverSettings& settings, const OdeWorld& ode)
    : ode_(ode),
      step_(settings.step),
      cfm_(settings.cfm),
      first_(first_axes(scene)),
      feedback_(scene.joints.size()) {
  for (std::uint32_t i = 0; i < scene.joints.size(); ++i) {
    const SceneJoint& joint = scene.joints[i];
    const bool one_of_two = joint.type == model::JointType::kGearbox && joint.axes.size() == 1;
    if (joint.axes.size() != engine_axes_of(joint.type) && !one_of_two) {
      throw EngineError("a joint has another number of axes than its type: " + joint.name);
    }
    make(joint);
    add_anchors(joint);
  }
  coordinates_.insert(coordinates_.end(), hidden_.begin(), hidden_.end());
  make_mimics(scene);
  for (Coupling& coupling : couplings_) couple(coupling);
  for (Coordinate& c : coordinates_) {
    if (is_firm(c, step_)) c.firm = make_firm(ode.world(), c, step_);
    update(c);
  }
}

dJointID EngineJoints::attach(dJointID made, const SceneJoint& joint) const {
  dJointAttach(made, ode_.body(joint.child), ode_.body(joint.parent));
  return made;
}

Coordinate EngineJoints::coordinate(Coordinate::Kind kind, dJointID made, const SceneJoint& joint,
                                    const SceneAxis& axis) const {
  Coordinate c{.kind = kind,
               .joint = made,
               .plus = ode_.body(joint.child),
               .minus = ode_.body(joint.parent),
               .anchor_W = joint.anchor_W,
               .written = axis};
  // ODE counts from where the joint is made.
  c.written.lower -= axis.start;
  c.written.upper -= axis.start;
  c.written.spring_reference -= axis.start;
  const Vector3& a = axis.direction_W;
  c.carrier = kind == Coordinate::Kind::kUniversalSecond ? c.plus : c.minus;
  c.axis = in_body(c.carrier, a);
  c.inertia = is_angle(kind) ? 1 / (turning_ease(c.plus, a) + turning_ease(c.minus, a))
                             : 1 / (sliding_ease(c.plus, a, joint.anchor_W) +
                                    sliding_ease(c.minus, a, joint.anchor_W));
  return c;
}

void EngineJoints::make(const SceneJoint& joint) {
  using Type = model::JointType;
  const Vector3& p = joint.anchor_W;
  switch (joint.type) {
    case Type::kRevolute:
    case Type::kContinuous: make_hinge(joint); return;
    case Type::kPrismatic: make_slider(joint); return;
    case Type::kUniversal:
    case Type::kRevolute2: make_universal(joint); return;
    case Type::kScrew: make_screw(joint); return;
    case Type::kGearbox: make_gearbox(joint); return;
    case Type::kBall:
      dJointSetBallAnchor(attach(dJointCreateBall(ode_.world(), nullptr), joint), p.x, p.y, p.z);
      return;
    case Type::kFixed:
      dJointSetFixed(attach(dJointCreateFixed(ode_.world(), nullptr), joint));
      return;
    default: throw EngineError("a joint of a type that has no engine's: " + joint.name);
  }
}

void EngineJoints::make_hinge(const SceneJoint& joint) {
  const dJointID made = attach(dJointCreateHinge(ode_.world(), nullptr), joint);
  const Vector3& p = joint.anchor_W;
  const Vector3& a = joint.axes[0].direction_W;
  dJointSetHingeAnchor(made, p.x, p.y, p.z);
  dJointSetHingeAxis(made, a.x, a.y, a.z);
  coordinates_.push_back(coordinate(Coordinate::Kind::kHinge, made, joint, joint.axes[0]));
}

void EngineJoints::make_slider(const SceneJoint& joint) {
  const dJointID made = attach(dJointCreateSlider(ode_.world(), nullptr), joint);
  const Vector3& a = joint.axes[0].direction_W;
  dJointSetSliderAxis(made, a.x, a.y, a.z);
  coordinates_.push_back(coordinate(Coordinate::Kind::kSlider, made, joint, joint.axes[0]));
}

/// The first axis is the parent's, the second the child's. ODE has the first body's (the child's) first,
/// and turns them at right angles; so the second is made so.
void EngineJoints::make_universal(const SceneJoint& joint) {
  const Vector3& a = joint.axes[0].direction_W;
  const Vector3& written = joint.axes[1].direction_W;
  const Vector3 across = written - dot(written, a) * a;
  const double size = model::length(across);
  if (!(size > kMinAngle)) throw EngineError("a joint's two axes are parallel: " + joint.name);
  const Vector3 b = (1 / size) * across;
  const dJointID made = attach(dJointCreateUniversal(ode_.world(), nullptr), joint);
  const Vector3& p = joint.anchor_W;
  dJointSetUniversalAnchor(made, p.x, p.y, p.z);
  dJointSetUniversalAxis1(made, b.x, b.y, b.z);
  dJointSetUniversalAxis2(made, a.x, a.y, a.z);
  SceneAxis second = joint.axes[1];
  second.direction_W = b;
  using Kind = Coordinate::Kind;
  coordinates_.push_back(coordinate(Kind::kUniversalFirst, made, joint, joint.axes[0]));
  coordinates_.push_back(coordinate(Kind::kUniversalSecond, made, joint, second));
}

void EngineJoints::make_screw(const SceneJoint& joint) {
  const dJointID made = attach(dJointCreatePiston(ode_.world(), nullptr), joint);
  const Vector3& p = joint.anchor_W;
  const Vector3& a = joint.axes[0].direction_W;
  dJointSetPistonAnchor(made, p.x, p.y, p.z);
  dJointSetPistonAxis(made, a.x, a.y, a.z);
  couplings_.push_back({.follower = first_.back() + hidden_.size(),
                        .leader = coordinates_.size(),
                        .multiplier = joint.screw_pitch});
  SceneAxis slide;
  slide.direction_W = a;
  slide.start = joint.screw_pitch * joint.axes[0].start;
  using Kind = Coordinate::Kind;
  coordinates_.push_back(coordinate(Kind::kScrewTurn, made, joint, joint.axes[0]));
  hidden_.push_back(coordinate(Kind::kScrewSlide, made, joint, slide));
}

/// With one axis only, it is both sides'.
void EngineJoints::make_gearbox(const SceneJoint& joint) {
  const auto side = [&](std::uint32_t body, const SceneAxis& axis) {
    SceneJoint pair = joint;
    pair.parent = joint.gearbox_reference;
    pair.child = body;
    return coordinate(Coordinate::Kind::kFree, nullptr, pair, axis);
  };
  const bool both = joint.axes.size() > 1;
  const std::size_t parents = coordinates_.size();
  const std::size_t childs = both ? parents + 1 : first_.back() + hidden_.size();
  coordinates_.push_back(side(joint.parent, joint.axes[0]));
  (both ? coordinates_ : hidden_).push_back(side(joint.child, joint.axes.back()));
  couplings_.push_back({.follower = childs,
                        .leader = parents,
                        .multiplier = -joint.gearbox_ratio,
                        .offset = joint.axes.back().start,
                        .reference = joint.axes.front().start});
}

void EngineJoints::make_mimics(const Scene& scene) {
  for (std::uint32_t i = 0; i < scene.joints.size(); ++i) {
    const SceneJoint& joint = scene.joints[i];
    const std::size_t count = std::min(joint.mimics.size(), joint.axes.size());
    for (std::uint32_t axis = 0; axis < count; ++axis) {
      const SceneMimic& mimic = joint.mimics[axis];
      const std::size_t follower = first_[i] + axis;
      const std::size_t leader = first_.at(mimic.joint) + mimic.axis;
      if (leader == follower || leader >= first_.back()) continue;
      couplings_.push_back({.follower = follower,
                            .leader = leader,
                            .multiplier = mimic.multiplier,
                            .offset = mimic.offset,
                            .reference = mimic.reference});
    }
  }
}

void EngineJoints::add_anchors(const SceneJoint& joint) {
  using Type = model::JointType;
  Anchors anchors{.child = ode_.body(joint.child), .parent = ode_.body(joint.parent)};
  anchors.hold = joint.type != Type::kGearbox;
  anchors.p_child = point_in(anchors.child, joint.anchor_W);
  anchors.p_parent = point_in(anchors.parent, joint.anchor_W);
  anchors.slides = joint.type == Type::kPrismatic || joint.type == Type::kScrew;
  if (anchors.slides) anchors.axis_parent = in_body(anchors.parent, joint.axes[0].direction_W);
  anchors_.push_back(anchors);
}

}  // namespace rigor::simulate
