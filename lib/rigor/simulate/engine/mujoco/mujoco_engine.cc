// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine/mujoco/mujoco_engine.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <rigor/simulate/engine/mujoco/geom_text.h>
#include <rigor/simulate/engine/mujoco/model_text.h>
#include <rigor/simulate/engine/mujoco/session.h>
#include <rigor/simulate/run.h>

namespace rigor::simulate {
namespace {

Vector3 vector_at(const mjtNum* values, int index) {
  const mjtNum* v = values + std::ptrdiff_t{3} * index;
  return {v[0], v[1], v[2]};
}

Quaternion quaternion_at(const mjtNum* values, int index) {
  const mjtNum* q = values + std::ptrdiff_t{4} * index;
  return {q[0], q[1], q[2], q[3]};
}

/// N·m, N: of a motor without a limit.
constexpr double kStrongest = 1e10;

/// fdir1 nearer than this to the normal gives no direction to slide along.
constexpr double kMinAlong = 1e-3;

}  // namespace

struct MujocoEngine::World {
  struct Drive {
    enum class Command : std::uint8_t { kNone, kEffort, kMotor };
    Command command = Command::kNone;
    double told = 0;  ///< effort, or velocity
    double most = 0;  ///< effort of the motor
    double give = 0;  ///< rad/s per N·m that a servo gives way by; 0 for a motor
  };

  World(const Scene& the_scene, const SolverSettings& settings)
      : scene(the_scene),
        step(settings.step),
        text(mujoco_model_text(the_scene, settings)),
        session(text.xml, settings.library),
        mujoco(session.mujoco),
        model(session.model()),
        data(session.data()),
        first(first_axes(the_scene)),
        drives(first.back()),
        gravity(the_scene.gravity) {
    if (model->nbody != text.body_count || model->njnt != text.joint_count ||
        model->nq != text.position_count || model->nv != text.dof_count ||
        model->ngeom != static_cast<int>(text.shape_of_geom.size())) {
      throw EngineError("MuJoCo has made another model of the scene");
    }
    fill_grids();
    for (const SceneBody& body : scene.bodies) {
      const bool slows = body.linear_damping > 0 || body.angular_damping > 0;
      if (!body.gravity || slows) has_body_forces = true;
    }
    for (const SceneShape& shape : scene.shapes) {
      if (dot(shape.surface.fdir1, shape.surface.fdir1) > 0) has_directions = true;
    }
    state.bodies.resize(scene.bodies.size());
    state.axes.resize(first.back());
    for (const MujocoAxis& axis : text.axes) {
      if (axis.dof >= 0 && model->dof_frictionloss[axis.dof] > 0) has_rows = true;
    }
    begin();
    read();
  }

  void fill_grids();
  std::size_t at(std::uint32_t joint, std::uint32_t axis) const;
  void take_slot(std::size_t axis);
  void begin();
  void direct_contacts();
  void apply();
  void apply_body_forces();
  void drive_rows();
  void read_efforts();
  void read_contacts(Forces forces);
  void read();
  void read_bodies();
  void read_axes();
  void read_loops();
  bool was_reset();
  void advance(Forces forces);

  const Scene& scene;
  double step;
  MujocoModelText text;
  MujocoSession session;
  const MujocoLibrary& mujoco;
  mjModel* model;
  mjData* data;
  std::vector<std::uint32_t> first;
  std::vector<Drive> drives;  ///< axis by axis
  Vector3 gravity;
  bool has_body_forces = false;
  bool has_directions = false;
  bool has_rows = false;    ///< of friction or motors
  bool stale = false;       ///< rows are to be made anew
  bool slow_stale = false;  ///< … only what depends on gravity and speeds
  bool pushed = false;
  std::uint64_t steps = 0;
  State state;
};

/// Which MuJoCo 2.2 does not read from its text.
void MujocoEngine::World::fill_grids() {
  for (std::size_t i = 0; i < text.grids.size(); ++i) {
    const auto& grid = std::get<HeightGrid>(scene.shapes[text.grids[i]].kind);
    const GridRange range = range_of(grid);
    float* heights = model->hfield_data + model->hfield_adr[i];
    for (std::size_t k = 0; k < grid.heights.size(); ++k) {
      heights[k] = static_cast<float>((grid.heights[k] - range.low) / range.range);
    }
  }
}

std::size_t MujocoEngine::World::at(std::uint32_t joint, std::uint32_t axis) const {
  if (joint + 1 >= first.size() || first[joint] + axis >= first[joint + 1] ||
      text.axes[first[joint] + axis].dof < 0) {
    throw EngineError("a command for an axis that is not there");
  }
  return first[joint] + axis;
}

/// The one row of joint friction that an axis has is its motor's, if it has one.
void MujocoEngine::World::take_slot(std::size_t axis) {
  const std::uint32_t joint = static_cast<std::uint32_t>(
      std::upper_bound(first.begin(), first.end(), axis) - first.begin() - 1);
  const SceneAxis& written = scene.joints[joint].axes[axis - first[joint]];
  const Drive& drive = drives[axis];
  const bool motor = drive.command == Drive::Command::kMotor;
  const double most = std::min(motor ? drive.most : written.friction, kStrongest);
  mjtNum& slot = model->dof_frictionloss[text.axes[axis].dof];
  if (slot == most) return;
  slot = most;
  stale = true;
}

/// What belongs to the present positions and speeds: kinematics, contacts, rows of constraints.
void MujocoEngine::World::begin() {
  mujoco.step1(model, data);
  if (has_directions) direct_contacts();
  stale = false;
  slow_stale = false;
}

/// Turns contacts' tangents to the first direction of the surface that has one, of two the one of the smaller mu.
void MujocoEngine::World::direct_contacts() {
  bool any = false;
  for (int i = 0; i < data->ncon; ++i) {
    mjContact& contact = data->contact[i];
    const SceneShape& a = scene.shapes[text.shape_of_geom[static_cast<std::size_t>(contact.geom1)]];
    const SceneShape& b = scene.shapes[text.shape_of_geom[static_cast<std::size_t>(contact.geom2)]];
    const auto written = [](const SceneShape& s) {
      return dot(s.surface.fdir1, s.surface.fdir1) > 0;
    };
    const SceneShape* chosen = written(a) ? &a : nullptr;
    if (written(b) && (chosen == nullptr || a.surface.mu > b.surface.mu)) chosen = &b;
    if (chosen == nullptr) continue;
    Vector3 along = chosen->surface.fdir1;
    if (chosen->link < scene.links.size()) {
      along = rotate(scene.links[chosen->link].X_BL.rotation, along);
    }
    if (chosen->body != kWorld) {
      along = rotate(quaternion_at(data->xquat, text.bodies[chosen->body]), along);
    }
    const Vector3 normal = vector_at(contact.frame, 0);
    const Vector3 across = along - dot(along, normal) * normal;
    const double size = length(across);
    if (!(size > kMinAlong * length(along))) continue;
    const Vector3 one = (1 / size) * across;
    const Vector3 two = cross(normal, one);
    const std::array<double, 6> tangents{one.x, one.y, one.z, two.x, two.y, two.z};
    std::copy(tangents.begin(), tangents.end(), contact.frame + 3);
    any = true;
  }
  if (!any) return;
  mujoco.make_constraint(model, data);
  mujoco.project_constraint(model, data);
  mujoco.forward_velocity(model, data);
}

void MujocoEngine::World::apply() {
  std::fill(data->qfrc_applied, data->qfrc_applied + model->nv, 0.0);
  for (std::size_t i = 0; i < drives.size(); ++i) {
    if (drives[i].command != Drive::Command::kEffort) continue;
    data->qfrc_applied[text.axes[i].dof] += text.axes[i].sign * drives[i].told;
  }
  if (has_body_forces) apply_body_forces();
}

/// What MuJoCo has no word for: bodies without gravity, and SDF's share of the speed that a step takes away.
void MujocoEngine::World::apply_body_forces() {
  const auto add = [&](int number, const SceneBody& body, const BodyState& now, double share) {
    mjtNum* force = data->xfrc_applied + std::ptrdiff_t{6} * number;
    const double mass = share * body.mass.mass;
    Vector3 f = (-body.linear_damping * mass / step) * now.v_WBcm;
    if (!body.gravity) f = f - mass * gravity;
    const mass::Inertia& I = body.mass.about_com;
    const Vector3 w = rotate(conjugate(now.R_WB), now.w_WB);
    const Vector3 L{I.ixx * w.x + I.ixy * w.y + I.ixz * w.z,
                    I.ixy * w.x + I.iyy * w.y + I.iyz * w.z,
                    I.ixz * w.x + I.iyz * w.y + I.izz * w.z};
    const Vector3 t = (-body.angular_damping * share / step) * rotate(now.R_WB, L);
    const std::array<double, 6> both{f.x, f.y, f.z, t.x, t.y, t.z};
    for (std::size_t i = 0; i < both.size(); ++i) force[i] += both[i];
  };
  std::vector<double> parts(scene.bodies.size(), 1);
  for (const int body : text.half_of) ++parts[static_cast<std::size_t>(body)];
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!scene.bodies[i].kinematic) {
      add(text.bodies[i], scene.bodies[i], state.bodies[i], 1 / parts[i]);
    }
  }
  for (std::size_t i = 0; i < text.halves.size(); ++i) {
    const auto body = static_cast<std::size_t>(text.half_of[i]);
    add(text.halves[i], scene.bodies[body], state.bodies[body], 1 / parts[body]);
  }
}

/// Rows of joint friction pull a speed to zero. These pull it to the commanded one, within the step:
/// f = (a_ref - a)/R, where a = (v_end - v)/h and a_ref = (v_told - v)/h (MuJoCo, "Computation", "Constraint model").
void MujocoEngine::World::drive_rows() {
  std::vector<const Drive*> of_dof(static_cast<std::size_t>(model->nv), nullptr);
  std::vector<double> sign(of_dof.size(), 1);
  for (std::size_t i = 0; i < drives.size(); ++i) {
    if (drives[i].command != Drive::Command::kMotor) continue;
    of_dof[static_cast<std::size_t>(text.axes[i].dof)] = &drives[i];
    sign[static_cast<std::size_t>(text.axes[i].dof)] = text.axes[i].sign;
  }
  for (int row = data->ne; row < data->ne + data->nf; ++row) {
    if (data->efc_type[row] != mjCNSTR_FRICTION_DOF) continue;
    const auto dof = static_cast<std::size_t>(data->efc_id[row]);
    const Drive* drive = of_dof[dof];
    const double wanted = drive == nullptr ? 0 : sign[dof] * drive->told;
    data->efc_aref[row] = (wanted - data->qvel[dof]) / step;
    if (drive == nullptr || !(drive->give > 0)) continue;
    data->efc_R[row] = std::max(data->efc_R[row], drive->give / step);
    data->efc_D[row] = 1 / data->efc_R[row];
  }
}

void MujocoEngine::World::read_efforts() {
  for (std::size_t i = 0; i < drives.size(); ++i) {
    const Drive& drive = drives[i];
    state.axes[i].effort = drive.command == Drive::Command::kEffort ? drive.told : 0;
  }
  for (int row = data->ne; row < data->ne + data->nf; ++row) {
    if (data->efc_type[row] != mjCNSTR_FRICTION_DOF) continue;
    for (std::size_t i = 0; i < drives.size(); ++i) {
      if (drives[i].command != Drive::Command::kMotor) continue;
      if (text.axes[i].dof != data->efc_id[row]) continue;
      state.axes[i].effort = text.axes[i].sign * data->efc_force[row];
    }
  }
}

void MujocoEngine::World::read_contacts(Forces forces) {
  state.contacts.clear();
  for (int i = 0; i < data->ncon; ++i) {
    const mjContact& contact = data->contact[i];
    if (contact.exclude != 0) continue;
    ContactState seen{.shape_a = text.shape_of_geom[static_cast<std::size_t>(contact.geom2)],
                      .shape_b = text.shape_of_geom[static_cast<std::size_t>(contact.geom1)],
                      .point = vector_at(contact.pos, 0),
                      .normal = vector_at(contact.frame, 0),
                      .depth = -contact.dist,
                      .force = {}};
    if (forces == Forces::kAsked) {
      std::array<mjtNum, 6> f{};
      mujoco.contact_force(model, data, i, f.data());
      for (int k = 0; k < 3; ++k) {
        seen.force = seen.force + f[static_cast<std::size_t>(k)] * vector_at(contact.frame, k);
      }
    }
    state.contacts.push_back(seen);
  }
}

void MujocoEngine::World::read_bodies() {
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    const int number = text.bodies[i];
    std::array<mjtNum, 6> speed{};  // rotation, then translation of the center of mass, in W
    mujoco.object_velocity(model, data, mjOBJ_BODY, number, speed.data(), 0);
    const Quaternion R = quaternion_at(data->xquat, number);
    const Vector3 com = scene.bodies[i].mass.com;
    state.bodies[i] = {vector_at(data->xpos, number) + rotate(R, com),
                       R,
                       {speed[3], speed[4], speed[5]},
                       {speed[0], speed[1], speed[2]}};
  }
}

void MujocoEngine::World::read_axes() {
  for (std::size_t i = 0; i < text.axes.size(); ++i) {
    const MujocoAxis& axis = text.axes[i];
    if (axis.dof < 0) continue;
    AxisState& now = state.axes[i];
    const double before = now.velocity;
    now.position = axis.start + axis.sign * (data->qpos[axis.position] - axis.begin);
    now.velocity = axis.sign * data->qvel[axis.dof];
    if (steps > 0) state.motor_work += now.effort * (before + now.velocity) / 2 * step;
  }
}

/// Joints of a tree have no gap; where a loop is closed there may be one.
void MujocoEngine::World::read_loops() {
  state.anchor_error = 0;
  state.anchor_joint = kWorld;
  for (const MujocoLoop& loop : text.loops) {
    const auto place = [&](int body) {
      return vector_at(data->xpos, body) + rotate(quaternion_at(data->xquat, body), loop.p_B);
    };
    const double error = length(place(loop.half) - place(loop.whole));
    if (error <= state.anchor_error) continue;
    state.anchor_error = error;
    state.anchor_joint = loop.joint;
  }
}

void MujocoEngine::World::read() {
  read_bodies();
  read_axes();
  read_loops();
  state.time = static_cast<double>(steps) * step;
}

/// MuJoCo sets everything back to the start when a number is none or huge. What was no number is said instead.
bool MujocoEngine::World::was_reset() {
  for (const int kind : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC}) {
    if (data->warning[kind].number == 0) continue;
    const auto dof = static_cast<std::size_t>(std::max(data->warning[kind].lastinfo, 0));
    const std::size_t body = dof < text.body_of_dof.size()
                                 ? static_cast<std::size_t>(text.body_of_dof[dof])
                                 : std::size_t{0};
    if (body < state.bodies.size()) {
      state.bodies[body].p_WBcm.x = std::numeric_limits<double>::quiet_NaN();
    }
    return true;
  }
  return false;
}

void MujocoEngine::World::advance(Forces forces) {
  if (stale) begin();
  if (slow_stale) {
    mujoco.forward_velocity(model, data);
    slow_stale = false;
  }
  apply();
  drive_rows();
  mujoco.step2(model, data);
  ++steps;
  state.time = static_cast<double>(steps) * step;
  if (was_reset()) return;
  read_efforts();
  read_contacts(forces);
  if (pushed || has_body_forces) {
    std::fill(data->xfrc_applied, data->xfrc_applied + std::ptrdiff_t{6} * model->nbody, 0.0);
    pushed = false;
  }
  begin();
  if (was_reset()) return;
  read();
}

MujocoEngine::MujocoEngine(const Scene& scene, const SolverSettings& settings)
    : world_(std::make_unique<World>(scene, settings)) {}

MujocoEngine::~MujocoEngine() = default;

void MujocoEngine::set_effort(std::uint32_t joint, std::uint32_t axis, double effort) {
  const std::size_t index = world_->at(joint, axis);
  const double most = world_->scene.joints[joint].axes[axis].effort;
  World::Drive& drive = world_->drives[index];
  drive = {.command = World::Drive::Command::kEffort, .told = std::clamp(effort, -most, most)};
  world_->take_slot(index);
}

void MujocoEngine::set_motor(std::uint32_t joint, std::uint32_t axis, double velocity,
                             double effort) {
  const std::size_t index = world_->at(joint, axis);
  world_->drives[index] = {.command = World::Drive::Command::kMotor,
                           .told = velocity,
                           .most = std::min(effort, world_->scene.joints[joint].axes[axis].effort)};
  world_->take_slot(index);
}

/// As in ODE (axes.cc): a motor of speed (k e + d r)/(d + h k) that gives way by 1/(d + h k).
void MujocoEngine::set_servo(std::uint32_t joint, std::uint32_t axis, const Servo& servo) {
  const std::size_t index = world_->at(joint, axis);
  const double firmness = servo.damping + world_->step * servo.stiffness;
  World::Drive drive{.command = World::Drive::Command::kMotor};
  if (firmness > 0) {
    drive.told = (servo.stiffness * servo.error + servo.damping * servo.rate) / firmness;
    drive.most = std::min(servo.effort, world_->scene.joints[joint].axes[axis].effort);
    drive.give = 1 / firmness;
  }
  world_->drives[index] = drive;
  world_->take_slot(index);
}

void MujocoEngine::release(std::uint32_t joint, std::uint32_t axis) {
  const std::size_t index = world_->at(joint, axis);
  world_->drives[index] = {};
  world_->take_slot(index);
}

void MujocoEngine::push(std::uint32_t body, const Vector3& impulse_W, const Vector3& p_BP) {
  const Vector3 f = (1 / world_->step) * impulse_W;
  const Vector3 lever = p_BP - world_->scene.bodies[body].mass.com;
  const Vector3 t = cross(rotate(world_->state.bodies[body].R_WB, lever), f);
  mjtNum* force = world_->data->xfrc_applied + std::ptrdiff_t{6} * world_->text.bodies[body];
  const std::array<double, 6> both{f.x, f.y, f.z, t.x, t.y, t.z};
  for (std::size_t i = 0; i < both.size(); ++i) force[i] += both[i];
  world_->pushed = true;
}

void MujocoEngine::set_gravity(const Vector3& gravity_W) {
  mjtNum* g = world_->model->opt.gravity;
  if (g[0] == gravity_W.x && g[1] == gravity_W.y && g[2] == gravity_W.z) return;
  g[0] = gravity_W.x;
  g[1] = gravity_W.y;
  g[2] = gravity_W.z;
  world_->gravity = gravity_W;
  world_->slow_stale = true;
}

void MujocoEngine::set_velocity(std::uint32_t body, const Vector3& v_WBcm, const Vector3& w_WB) {
  World& world = *world_;
  const int dof = world.text.free_dofs[body];
  if (dof < 0) throw EngineError("MuJoCo: a joint decides how fast a body that it carries is");
  const Quaternion& R = world.state.bodies[body].R_WB;
  // Of the body's origin in W, and about its own axes.
  const Vector3 v = v_WBcm - cross(w_WB, rotate(R, world.scene.bodies[body].mass.com));
  const Vector3 w = rotate(conjugate(R), w_WB);
  const std::array<double, 6> both{v.x, v.y, v.z, w.x, w.y, w.z};
  std::copy(both.begin(), both.end(), world.data->qvel + dof);
  world.begin();
  world.read();
}

void MujocoEngine::touch() {
  if (world_->stale) world_->begin();
  world_->read_contacts(Forces::kNone);
}

void MujocoEngine::step(Forces forces) { world_->advance(forces); }

const State& MujocoEngine::state() const { return world_->state; }

std::uint64_t MujocoEngine::solver_messages() const { return world_->session.messages(); }

}  // namespace rigor::simulate
