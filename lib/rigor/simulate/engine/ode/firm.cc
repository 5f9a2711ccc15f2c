// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Springs and dampers that are too stiff for a force: a row of the solver, whose effort is that of the position and the
// speed that the step ends with. With stiffness k, damping d and a step h, k (e - h v) + d (0 - v) of an error e: the
// row pulls to the speed k e/(d + h k) and gives way by 1/(d + h k) (ODE's manual, "ERP and CFM").
//
// It is a joint of its own beside the one that has the axis, so that motor, friction and stop keep theirs. Of what
// turns ODE's angular motor. Its linear motor pulls at the bodies' centers, which would turn what is off the axis; so of
// what slides it is a rod that is far longer than the way, along the axis through the anchor.

#include <rigor/simulate/engine/ode/world.h>

namespace rigor::simulate {
namespace {

/// m: a slider that is off its axis by a millimeter turns the rod by a millionth.
constexpr double kRod = 1000;

double firmness_of(const SceneAxis& axis, double step) {
  return axis.damping + step * axis.spring_stiffness;
}

dJointID make_firm_hinge(dWorldID world, const Coordinate& c, double step) {
  const dJointID made = dJointCreateAMotor(world, nullptr);
  const dBodyID first = c.plus != nullptr ? c.plus : c.minus;
  dJointAttach(made, first, first == c.plus ? c.minus : nullptr);
  dJointSetAMotorNumAxes(made, 1);
  dJointSetAMotorParam(made, dParamFMax, dInfinity);
  dJointSetAMotorParam(made, dParamCFM, 1 / firmness_of(c.written, step));
  return made;
}

/// A rod's length at rest is that when its ends are set: they are, with the spring at rest.
dJointID make_firm_slider(dWorldID world, const Coordinate& c, double step) {
  const dJointID made = dJointCreateDBall(world, nullptr);
  dJointAttach(made, c.plus, c.minus);
  const Vector3 axis_W = in_world(c.carrier, c.axis);
  const Vector3 far = c.anchor_W - kRod * axis_W;
  const Vector3 near = c.anchor_W;
  const dBodyID moved = c.plus != nullptr ? c.plus : c.minus;
  const Vector3 by = (c.plus != nullptr ? 1 : -1) * c.written.spring_reference * axis_W;
  const Vector3 at = vector_of(dBodyGetPosition(moved));
  dBodySetPosition(moved, at.x + by.x, at.y + by.y, at.z + by.z);
  const Vector3 near_at = c.plus != nullptr ? near + by : near;
  const Vector3 far_at = c.plus != nullptr ? far : far + by;
  dJointSetDBallAnchor1(made, near_at.x, near_at.y, near_at.z);
  dJointSetDBallAnchor2(made, far_at.x, far_at.y, far_at.z);
  dBodySetPosition(moved, at.x, at.y, at.z);
  const double firmness = firmness_of(c.written, step);
  dJointSetDBallParam(made, dParamERP, step * c.written.spring_stiffness / firmness);
  dJointSetDBallParam(made, dParamCFM, 1 / firmness);
  return made;
}

}  // namespace

bool is_firm(const Coordinate& c, double step) {
  if (!(c.inertia < kInfinity)) return false;  // nothing gives way
  return c.written.damping > c.inertia / step ||
         c.written.spring_stiffness > c.inertia / (step * step);
}

dJointID make_firm(dWorldID world, const Coordinate& c, double step) {
  return is_angle(c.kind) ? make_firm_hinge(world, c, step) : make_firm_slider(world, c, step);
}

void set_firm(const Coordinate& c, double step, Row row) {
  if (row == Row::kOff) return dJointDisable(c.firm);
  dJointEnable(c.firm);
  if (!is_angle(c.kind)) return;
  const SceneAxis& axis = c.written;
  const double speed =
      axis.spring_stiffness * (axis.spring_reference - c.state.position) / firmness_of(axis, step);
  const double sign = c.plus != nullptr ? 1 : -1;
  dJointSetAMotorAxis(c.firm, 0, 0, sign * c.axis_W.x, sign * c.axis_W.y, sign * c.axis_W.z);
  dJointSetAMotorParam(c.firm, dParamVel, speed);
}

}  // namespace rigor::simulate
