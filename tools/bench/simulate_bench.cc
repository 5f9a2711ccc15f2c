// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev bench simulate`: steps per second of `simulate::run`, with all that is measured and recorded,
// as a ratio to a loop written by hand that only steps ODE, with the same scene and settings; and the same of
// MuJoCo, whose loop by hand is `mj_step` alone on the model that rigor compiles.
//
//   rigor_simulate_bench

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <fmt/core.h>
#include <ode/ode.h>

#include <rigor/simulate/engine/mujoco/model_text.h>
#include <rigor/simulate/engine/mujoco/mujoco_engine.h>
#include <rigor/simulate/engine/mujoco/session.h>
#include <rigor/simulate/run.h>

#include "measure.h"

namespace {

using rigor::bench::median;
using rigor::simulate::kWorld;
using rigor::simulate::Scenario;
using rigor::simulate::Scene;
using rigor::simulate::SolverSettings;
using rigor::simulate::Vector3;

constexpr int kRounds = 9;
constexpr double kQuarterTurn = 1.5707963267948966;

/// One body with one shape, for both sides.
struct Part {
  double mass;
  Vector3 p;
  Vector3 size;  // of a box; of a cylinder: radius, length
  bool wheel;    // a cylinder along y, else a box
};

const std::array<Part, 3> kRobot{{{5, {0, 0, 0.1}, {0.4, 0.2, 0.1}, false},
                                  {0.5, {0.1, 0.13, 0.1}, {0.1, 0.05, 0}, true},
                                  {0.5, {0.1, -0.13, 0.1}, {0.1, 0.05, 0}, true}}};
constexpr Vector3 kCaster{-0.15, 0, -0.05};
constexpr double kCasterRadius = 0.05;
constexpr double kWheelSpeed = 10;
constexpr double kTorque = 5;

std::vector<Part> falling_boxes() {
  std::vector<Part> boxes;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      for (int k = 0; k < 4; ++k) {
        boxes.push_back({1, {0.5 * i, 0.5 * j, 0.12 + 0.22 * k}, {0.2, 0.2, 0.2}, false});
      }
    }
  }
  return boxes;
}

dMass mass_of(const Part& part) {
  dMass mass;
  if (part.wheel) {
    dMassSetCylinderTotal(&mass, part.mass, 3, part.size.x, part.size.y);
  } else {
    dMassSetBoxTotal(&mass, part.mass, part.size.x, part.size.y, part.size.z);
  }
  return mass;
}

// The hand-written side: no more than ODE's own examples do.

struct Hand {
  dWorldID world;
  dSpaceID space;
  dJointGroupID contacts;
  dGeomID slippery = nullptr;
};

void near(void* data, dGeomID a, dGeomID b) {
  const Hand& hand = *static_cast<Hand*>(data);
  const dBodyID one = dGeomGetBody(a);
  const dBodyID two = dGeomGetBody(b);
  if (one != nullptr && two != nullptr && dAreConnectedExcluding(one, two, dJointTypeContact) != 0)
    return;
  std::array<dContact, 20> contacts{};
  const int count = dCollide(a, b, 10, &contacts[0].geom, sizeof(dContact));
  for (int i = 0; i < count; ++i) {
    dContact& contact = contacts[static_cast<std::size_t>(i)];
    contact.surface.mode = dContactApprox1 | dContactMu2;
    contact.surface.mu = a == hand.slippery || b == hand.slippery ? 0 : 1;
    contact.surface.mu2 = contact.surface.mu;
    dJointAttach(dJointCreateContact(hand.world, hand.contacts, &contact), one, two);
  }
}

Hand make_hand_world(const SolverSettings& settings, std::size_t shapes) {
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  dRandSetSeed(static_cast<unsigned long>(settings.seed));
  Hand hand{
      dWorldCreate(),
      shapes > 50 ? dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ) : dSimpleSpaceCreate(nullptr),
      dJointGroupCreate(0)};
  dWorldSetGravity(hand.world, 0, 0, -9.8);
  dWorldSetERP(hand.world, settings.erp);
  dWorldSetCFM(hand.world, settings.cfm);
  dWorldSetQuickStepNumIterations(hand.world, settings.iterations);
  dWorldSetQuickStepW(hand.world, settings.sor);
  dWorldSetContactMaxCorrectingVel(hand.world, settings.max_correcting_velocity);
  dWorldSetContactSurfaceLayer(hand.world, settings.surface_layer);
  dCreatePlane(hand.space, 0, 0, 1, 0);
  return hand;
}

dBodyID add_by_hand(const Hand& hand, const Part& part) {
  const dBodyID body = dBodyCreate(hand.world);
  const dMass mass = mass_of(part);
  dBodySetMass(body, &mass);
  dBodySetPosition(body, part.p.x, part.p.y, part.p.z);
  dGeomID geom = nullptr;
  if (part.wheel) {
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 0, 0, -kQuarterTurn);
    dBodySetRotation(body, R);
    geom = dCreateCylinder(hand.space, part.size.x, part.size.y);
  } else {
    geom = dCreateBox(hand.space, part.size.x, part.size.y, part.size.z);
  }
  dGeomSetBody(geom, body);
  return body;
}

void step_by_hand(Hand& hand, const SolverSettings& settings) {
  dSpaceCollide(hand.space, &hand, near);
  dWorldQuickStep(hand.world, settings.step);
  dJointGroupEmpty(hand.contacts);
}

void close_by_hand(const Hand& hand) {
  dJointGroupDestroy(hand.contacts);
  dSpaceDestroy(hand.space);
  dWorldDestroy(hand.world);
  dCloseODE();
}

double drive_by_hand(const SolverSettings& settings, int steps) {
  Hand hand = make_hand_world(settings, 5);
  std::vector<dBodyID> bodies;
  for (const Part& part : kRobot) bodies.push_back(add_by_hand(hand, part));
  hand.slippery = dCreateSphere(hand.space, kCasterRadius);
  dGeomSetBody(hand.slippery, bodies[0]);
  dGeomSetOffsetPosition(hand.slippery, kCaster.x, kCaster.y, kCaster.z);
  std::array<dJointID, 2> motors{};
  for (std::size_t i = 0; i < 2; ++i) {
    motors[i] = dJointCreateHinge(hand.world, nullptr);
    const Vector3& p = kRobot[i + 1].p;
    dJointAttach(motors[i], bodies[i + 1], bodies[0]);
    dJointSetHingeAnchor(motors[i], p.x, p.y, p.z);
    dJointSetHingeAxis(motors[i], 0, 1, 0);
    dJointSetHingeParam(motors[i], dParamFMax, kTorque);
  }
  for (int i = 0; i < steps; ++i) {
    const double ramp = std::min(1.0, i * settings.step);
    for (const dJointID motor : motors) dJointSetHingeParam(motor, dParamVel, kWheelSpeed * ramp);
    step_by_hand(hand, settings);
  }
  const double x = dBodyGetPosition(bodies[0])[0];
  close_by_hand(hand);
  return x;
}

double drop_by_hand(const std::vector<Part>& boxes, const SolverSettings& settings, int steps) {
  Hand hand = make_hand_world(settings, boxes.size() + 1);
  dBodyID last = nullptr;
  for (const Part& box : boxes) last = add_by_hand(hand, box);
  for (int i = 0; i < steps; ++i) step_by_hand(hand, settings);
  const double z = dBodyGetPosition(last)[2];
  close_by_hand(hand);
  return z;
}

// MuJoCo by hand: the same model, and no commands.

double step_mujoco_by_hand(const Scene& scene, const SolverSettings& settings, int steps) {
  const rigor::simulate::MujocoSession session(mujoco_model_text(scene, settings).xml, {});
  void* handle = ::dlopen("libmujoco.so.2.2.2", RTLD_NOW);
  const auto mj_step_function =
      handle == nullptr ? nullptr
                        : reinterpret_cast<decltype(&mj_step)>(::dlsym(handle, "mj_step"));
  if (mj_step_function == nullptr) return 0;
  for (int i = 0; i < steps; ++i) mj_step_function(session.model(), session.data());
  return session.data()->xpos[3 * (session.model()->nbody - 1)];
}

// The same for us.

void add_part(Scene& scene, const Part& part, std::uint32_t model) {
  const auto index = static_cast<std::uint32_t>(scene.bodies.size());
  const dMass mass = mass_of(part);
  rigor::simulate::SceneBody body{.name = fmt::format("robot::part{}", index), .links = {index}};
  body.mass = {part.mass, {}, {.ixx = mass.I[0], .iyy = mass.I[5], .izz = mass.I[10]}};
  body.X_WB = {part.p, part.wheel ? rigor::model::from_rpy(-kQuarterTurn, 0, 0)
                                  : rigor::model::Quaternion{}};
  body.model = model;
  scene.links.push_back({.name = body.name, .body = index, .model = model});
  scene.bodies.push_back(body);
  rigor::simulate::SceneShape shape{.name = body.name, .body = index, .link = index};
  if (part.wheel) {
    shape.kind = rigor::mesh::Cylinder{part.size.x, part.size.y};
  } else {
    shape.kind = rigor::mesh::Box{part.size};
  }
  scene.shapes.push_back(shape);
}

Scene with_ground() {
  Scene scene;
  scene.shapes.push_back({.name = "ground", .kind = rigor::simulate::HalfSpace{}});
  return scene;
}

Scene robot_scene() {
  Scene scene = with_ground();
  scene.models.push_back({.name = "robot", .base = 0});
  for (const Part& part : kRobot) add_part(scene, part, 0);
  for (std::uint32_t i = 1; i < 3; ++i) {
    scene.joints.push_back({.name = "robot::joint",
                            .type = rigor::model::JointType::kRevolute,
                            .parent = 0,
                            .child = i,
                            .anchor_W = kRobot[i].p,
                            .axes = {{.direction_W = {0, 1, 0}, .effort = kTorque}},
                            .model = 0});
  }
  rigor::simulate::SceneShape caster{.name = "caster", .body = 0, .link = 0};
  caster.X_BS.translation = kCaster;
  caster.kind = rigor::mesh::Sphere{kCasterRadius};
  caster.surface.mu = 0;
  caster.surface.mu2 = 0;
  scene.shapes.push_back(caster);
  return scene;
}

Scene box_scene(const std::vector<Part>& boxes) {
  Scene scene = with_ground();
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    scene.models.push_back({.name = fmt::format("box{}", i), .base = i});
    add_part(scene, boxes[i], i);
  }
  scene.size = 3;
  return scene;
}

Scenario drive_for(double seconds) {
  Scenario scenario{.name = "drive", .duration = seconds, .phases = {{"drive", 0, seconds}}};
  for (std::uint32_t i = 0; i < 2; ++i) {
    scenario.commands.push_back({.joint = i, .value = kWheelSpeed, .end = seconds, .ramp = 1});
  }
  return scenario;
}

Scenario rest_for(double seconds) {
  return {.name = "rest", .duration = seconds, .phases = {{"rest", 0, seconds}}};
}

/// Of the processor, so that what else the machine does counts for neither side.
double seconds_of(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Rounds alternate, so that a machine that slows down slows both.
void compare(const std::string& name, int steps, const std::function<double()>& hand,
             const std::function<double()>& ours) {
  std::vector<double> hands;
  std::vector<double> runs;
  std::vector<double> ratios;
  double hand_end = 0;
  double our_end = 0;
  for (int round = 0; round < kRounds; ++round) {
    hands.push_back(seconds_of([&] { hand_end = hand(); }));
    runs.push_back(seconds_of([&] { our_end = ours(); }));
    ratios.push_back(hands.back() / runs.back());
  }
  fmt::print("{}\n  hand-written  {:10.0f} steps/s   ends at {:.6f} m\n", name,
             steps / median(hands), hand_end);
  fmt::print("  rigor         {:10.0f} steps/s   ends at {:.6f} m\n", steps / median(runs),
             our_end);
  fmt::print("  ratio         {:10.3f}\n", median(ratios));
}

}  // namespace

int main() {
  SolverSettings settings;
  const int drive_steps = 3000;
  const Scene robot = robot_scene();
  const Scenario drive = drive_for(drive_steps * settings.step);
  for (const int iterations : {200, 50}) {
    settings.iterations = iterations;
    compare(
        fmt::format("robot, {} iterations", iterations), drive_steps,
        [&] { return drive_by_hand(settings, drive_steps); },
        [&] { return run(robot, drive, settings).final.bodies[0].p_WBcm.x; });
  }
  const int drop_steps = 500;
  const std::vector<Part> boxes = falling_boxes();
  const Scene pile = box_scene(boxes);
  const double drop = drop_steps * settings.step;
  const Scenario fall{.name = "drop", .duration = drop, .phases = {{"drop", 0, drop}}};
  compare(
      "100 boxes, 50 iterations", drop_steps,
      [&] { return drop_by_hand(boxes, settings, drop_steps); },
      [&] { return run(pile, fall, settings).final.bodies.back().p_WBcm.z; });
  const std::string problem = rigor::simulate::mujoco_problem({});
  if (!problem.empty()) {
    fmt::print("{}\n", problem);
    return 0;
  }
  settings.engine = rigor::simulate::EngineKind::kMujoco;
  const int rest_steps = 20'000;
  const Scenario rest = rest_for(rest_steps * settings.step);
  compare(
      "robot, MuJoCo", rest_steps, [&] { return step_mujoco_by_hand(robot, settings, rest_steps); },
      [&] { return run(robot, rest, settings).final.bodies[2].p_WBcm.x; });
}
