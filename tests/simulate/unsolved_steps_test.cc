// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The exact solver gives up on some steps, and leaves all bodies as they are. What it was chosen for is run again with
// the iterative one.

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include <rigor/simulate/plan.h>
#include <rigor/simulate/simulate.h>

#include "simulate/built.h"
#include "support/workers.h"

namespace rigor {
namespace {

using namespace simulate;

/// A finger of 15 g that slides to a side, from its stop.
std::string finger(const std::string& name, const std::string& axis, const std::string& mimic) {
  return "<link name=\"" + name +
         "\"><pose>0 0 0.06 0 0 0</pose><inertial><mass>0.015</mass><inertia><ixx>2e-6</ixx>"
         "<iyy>2e-6</iyy><izz>7e-7</izz></inertia></inertial></link><joint name=\"" +
         name + "_slide\" type=\"prismatic\"><parent>palm</parent><child>" + name +
         "</child><axis><xyz>" + axis +
         "</xyz><limit><lower>0</lower><upper>0.04</upper><effort>100</effort>"
         "<velocity>0.2</velocity></limit>" +
         mimic + "</axis></joint>";
}

TEST(UnsolvedSteps, AGripperWhoseFingersBeginAtTheirStopsIsSwept) {
  const std::string mimic =
      "<mimic joint=\"left_slide\"><multiplier>1</multiplier><offset>0</offset>"
      "<reference>0</reference></mimic>";
  const test::Built b = test::built(
      "<sdf version=\"1.11\"><model name=\"gripper\"><link name=\"palm\"><inertial>"
      "<mass>0.7</mass><inertia><ixx>0.001</ixx><iyy>0.002</iyy><izz>0.002</izz></inertia>"
      "</inertial></link>" +
      finger("left", "0 1 0", "") + finger("right", "0 -1 0", mimic) + "</model></sdf>");
  ASSERT_FALSE(b.blocked);
  const DriveTrain wheels;
  const Facts causes;
  Planned planned = scenarios_of({.tests = {"joint-sweep"}}, b.scene, wheels);
  ASSERT_EQ(planned.scenarios.size(), 1U);
  EXPECT_EQ(planned.scenarios[0].solver, Solver::kDantzig);
  const Task task{b.scene, causes, std::move(planned.scenarios), wheels, b.scene.solver};
  const Simulation result = simulate::simulate({task}, {}, test::workers())[0];
  ASSERT_EQ(result.runs.size(), 1U);
  const PhaseMeasures& swept = result.runs[0].record.measures.phases.back();
  EXPECT_NEAR(swept.axis_max[0], 0.04, 0.001);
  EXPECT_NEAR(swept.axis_max[1], 0.04, 0.001);
  EXPECT_NE(result.verdict, Verdict::kFail);
}

}  // namespace
}  // namespace rigor
