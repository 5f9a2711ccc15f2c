// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine/ode/ode_engine.h>

#include <array>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <string>

#include <rigor/simulate/engine/ode/world.h>

namespace rigor::simulate {
namespace {

// ODE's handlers get no pointer of ours, so what they count has to stand here. An engine only speaks
// of the difference since it was made.
std::uint64_t ode_messages = 0;

[[noreturn]] void throw_ode_error(int, const char* format, va_list arguments) {
  std::array<char, 512> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  throw EngineError(text.data());
}

void count_ode_message(int, const char*, va_list) { ++ode_messages; }

dMass ode_mass(const mass::MassProperties& body) {
  const mass::Inertia& I = body.about_com;
  dMass mass;
  // Entries of the matrix, as ours are: xx, yy, zz, xy, xz, yz.
  dMassSetParameters(&mass, body.mass, 0, 0, 0, I.ixx, I.iyy, I.izz, I.ixy, I.ixz, I.iyz);
  return mass;
}

dBodyID make_ode_body(dWorldID world, const SceneBody& body) {
  dBodyID made = dBodyCreate(world);
  const Vector3 p = model::transform(body.X_WB, body.mass.com);
  const Quaternion& R = body.X_WB.rotation;
  dBodySetPosition(made, p.x, p.y, p.z);
  const dQuaternion q{R.w, R.x, R.y, R.z};
  dBodySetQuaternion(made, q);
  if (body.kinematic) {
    dBodySetKinematic(made);
  } else {
    const dMass mass = ode_mass(body.mass);
    dBodySetMass(made, &mass);
  }
  dBodySetGravityMode(made, body.gravity ? 1 : 0);
  dBodySetGyroscopicMode(made, 1);
  dBodySetAutoDisableFlag(made, 0);
  dBodySetLinearDamping(made, body.linear_damping);
  dBodySetAngularDamping(made, body.angular_damping);
  return made;
}

/// Above so many shapes the sweep is faster than trying all pairs (measured). ODE's hash space is not
/// used: it ends the process when something is far away.
constexpr std::size_t kSimpleSpace = 50;

dSpaceID make_ode_space(std::size_t shapes) {
  if (shapes <= kSimpleSpace) return dSimpleSpaceCreate(nullptr);
  return dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
}

dWorldID make_ode_world(const Scene& scene, const SolverSettings& settings) {
  dWorldID world = dWorldCreate();
  dWorldSetGravity(world, scene.gravity.x, scene.gravity.y, scene.gravity.z);
  dWorldSetERP(world, settings.erp);
  dWorldSetCFM(world, settings.cfm);
  dWorldSetQuickStepNumIterations(world, settings.iterations);
  dWorldSetQuickStepW(world, settings.sor);
  dWorldSetContactMaxCorrectingVel(world, settings.max_correcting_velocity);
  dWorldSetContactSurfaceLayer(world, settings.surface_layer);
  dWorldSetDamping(world, 0, 0);
  dWorldSetAutoDisableFlag(world, 0);
  return world;
}

}  // namespace

OdeSession::OdeSession(std::uint64_t seed) {
  dInitODE2(0);
  dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
  dSetErrorHandler(throw_ode_error);
  dSetDebugHandler(throw_ode_error);
  dSetMessageHandler(count_ode_message);
  dRandSetSeed(static_cast<unsigned long>(seed));
}

OdeSession::~OdeSession() {
  dSetErrorHandler(nullptr);
  dSetDebugHandler(nullptr);
  dSetMessageHandler(nullptr);
  dCloseODE();
}

OdeWorld::OdeWorld(const Scene& scene, const SolverSettings& settings, std::nullptr_t)
    : session_(settings.seed),
      world_(make_ode_world(scene, settings)),
      space_(make_ode_space(scene.shapes.size())),
      contacts_(dJointGroupCreate(0)) {}

OdeWorld::OdeWorld(const Scene& scene, const SolverSettings& settings)
    : OdeWorld(scene, settings, nullptr) {
  bodies_.reserve(scene.bodies.size());
  for (const SceneBody& body : scene.bodies) bodies_.push_back(make_ode_body(world_, body));
}

OdeWorld::~OdeWorld() {
  dJointGroupDestroy(contacts_);
  dSpaceDestroy(space_);
  dWorldDestroy(world_);
}

struct OdeEngine::World {
  World(const Scene& scene, const SolverSettings& settings)
      : step(settings.step),
        solver(settings.solver),
        messages_before(ode_messages),
        ode(scene, settings),
        shapes(scene, ode),
        joints(scene, settings, ode),
        contacts(scene, settings, ode) {
    for (const SceneBody& body : scene.bodies) coms.push_back(body.mass.com);
    state.bodies.resize(scene.bodies.size());
    read();
  }

  void read();
  void read_bodies();
  void advance(Forces forces);

  double step;
  Solver solver;
  std::uint64_t messages_before;
  OdeWorld ode;
  EngineShapes shapes;
  EngineJoints joints;
  EngineContacts contacts;
  std::vector<Vector3> coms;  ///< in B
  std::uint64_t steps = 0;
  bool broken = false;  ///< ODE was left in the middle of a step
  State state;
};

void OdeEngine::World::read_bodies() {
  for (std::uint32_t i = 0; i < state.bodies.size(); ++i) {
    const dBodyID body = ode.body(i);
    const dReal* q = dBodyGetQuaternion(body);
    state.bodies[i] = {vector_of(dBodyGetPosition(body)),
                       {q[0], q[1], q[2], q[3]},
                       vector_of(dBodyGetLinearVel(body)),
                       vector_of(dBodyGetAngularVel(body))};
  }
}

void OdeEngine::World::read() {
  read_bodies();
  joints.read(state);
  state.time = static_cast<double>(steps) * step;
}

void OdeEngine::World::advance(Forces forces) {
  joints.apply();
  contacts.find(EngineContacts::Join::kYes, forces, state.contacts);
  if (solver == Solver::kQuick) {
    dWorldQuickStep(ode.world(), step);
  } else {
    dWorldStep(ode.world(), step);
  }
  if (forces == Forces::kAsked) contacts.read_forces(state.contacts);
  dJointGroupEmpty(ode.contacts());
  ++steps;
  read();
}

OdeEngine::OdeEngine(const Scene& scene, const SolverSettings& settings)
    : world_(std::make_unique<World>(scene, settings)) {}

// ODE ends the process when what it was in the middle of is taken away. It is left to the process.
OdeEngine::~OdeEngine() {
  if (world_->broken) static_cast<void>(world_.release());
}

void OdeEngine::set_effort(std::uint32_t joint, std::uint32_t axis, double effort) {
  world_->joints.set_effort(joint, axis, effort);
}

void OdeEngine::set_servo(std::uint32_t joint, std::uint32_t axis, const Servo& servo) {
  world_->joints.set_servo(joint, axis, servo);
}

void OdeEngine::set_motor(std::uint32_t joint, std::uint32_t axis, double velocity, double effort) {
  world_->joints.set_motor(joint, axis, velocity, effort);
}

void OdeEngine::release(std::uint32_t joint, std::uint32_t axis) {
  world_->joints.release(joint, axis);
}

void OdeEngine::push(std::uint32_t body, const Vector3& impulse_W, const Vector3& p_BP) {
  const Vector3 force = (1 / world_->step) * impulse_W;
  const Vector3 p = p_BP - world_->coms[body];
  dBodyAddForceAtRelPos(world_->ode.body(body), force.x, force.y, force.z, p.x, p.y, p.z);
}

void OdeEngine::set_gravity(const Vector3& gravity_W) {
  dWorldSetGravity(world_->ode.world(), gravity_W.x, gravity_W.y, gravity_W.z);
}

void OdeEngine::set_velocity(std::uint32_t body, const Vector3& v_WBcm, const Vector3& w_WB) {
  dBodySetLinearVel(world_->ode.body(body), v_WBcm.x, v_WBcm.y, v_WBcm.z);
  dBodySetAngularVel(world_->ode.body(body), w_WB.x, w_WB.y, w_WB.z);
  world_->read();
}

void OdeEngine::touch() {
  world_->contacts.find(EngineContacts::Join::kNo, Forces::kNone, world_->state.contacts);
}

void OdeEngine::step(Forces forces) {
  try {
    world_->advance(forces);
  } catch (const EngineError&) {
    world_->broken = true;
    world_->read_bodies();
    throw;
  }
}

const State& OdeEngine::state() const { return world_->state; }

std::uint64_t OdeEngine::solver_messages() const { return ode_messages - world_->messages_before; }

}  // namespace rigor::simulate
