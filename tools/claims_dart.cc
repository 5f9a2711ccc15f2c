// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What DART does with a URDF, for tools/claims.py, which compiles it:
//
//   claims_dart mass FILE     whether the last body has mass
//   claims_dart moves FILE    whether the first joint moves in a second of gravity along -x, its root
//                             welded and its limits enforced
//
// The last line of its output is the answer.

#include <cmath>
#include <cstdio>
#include <cstring>

#include <dart/dart.hpp>
#include <dart/utils/urdf/DartLoader.hpp>

int main(int, char** arguments) {
  dart::utils::DartLoader loader;
  const auto robot = loader.parseSkeleton(arguments[2]);
  if (!robot) return 1;
  if (std::strcmp(arguments[1], "mass") == 0) {
    const double mass = robot->getBodyNode(robot->getNumBodyNodes() - 1)->getMass();
    std::fprintf(stderr, "%g kg\n", mass);
    std::puts(mass > 0 ? "sets a mass of its own" : "keeps the mass, with a warning");
    return 0;
  }
  const auto world = dart::simulation::World::create();
  world->setGravity({-9.81, 0, 0});
  robot->getRootBodyNode()->changeParentJointType<dart::dynamics::WeldJoint>();
  for (auto* joint : robot->getJoints()) joint->setLimitEnforcement(true);
  world->addSkeleton(robot);
  for (int i = 0; i < 1000; ++i) world->step();
  const double position = robot->getDof(0)->getPosition();
  std::fprintf(stderr, "%g rad\n", position);
  std::puts(std::abs(position) > 1e-3 ? "lets it move" : "holds it still");
  return 0;
}
