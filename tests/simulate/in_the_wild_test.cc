// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What real models taught (docs/simulate-in-the-wild.md).

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <rigor/simulate/engine/ode/ode_engine.h>
#include <rigor/simulate/reach.h>

#include "simulate/built.h"
#include "simulate/hand_scene.h"

namespace rigor {
namespace {

using simulate::FactKind;
using simulate::Scene;
using test::built;
using test::Built;

/// Gazebo's models write both limits as 0 for "effectively fixed": the axis is at both stops at once.
TEST(InTheWild, ALockedAxisThatIsHeldStaysWhereItIs) {
  for (const double range : {0.0, 1e-5, 1e-3}) {
    for (const auto solver : {simulate::Solver::kQuick, simulate::Solver::kDantzig}) {
      Scene scene = hand::scene();
      hand::add_body(scene, hand::box_mass(2, {1, 0.1, 0.1}), {0.5, 0, 1});
      hand::add_joint(scene, model::JointType::kRevolute, simulate::kWorld, 0, {0, 0, 1},
                      {{0, 1, 0}});
      scene.joints[0].axes[0].lower = 0;
      scene.joints[0].axes[0].upper = range;
      simulate::SolverSettings settings;
      settings.solver = solver;
      simulate::OdeEngine engine(scene, settings);
      for (const double told : {0.0, 1.0, -1.0}) {
        engine.set_motor(0, 0, told, simulate::kInfinity);
        for (int i = 0; i < 200; ++i) engine.step(simulate::Forces::kNone);
        const double at = engine.state().axes[0].position;
        EXPECT_GT(at, -0.01) << range << " told " << told;
        EXPECT_LT(at, range + 0.01) << range << " told " << told;
      }
    }
  }
}

std::string box_at(const std::string& height, const std::string& model_pose) {
  return "<sdf version=\"1.9\"><model name=\"m\">" + model_pose + "<link name=\"a\"><pose>0 0 " +
         height +
         " 0 0 0</pose><collision name=\"c\"><geometry><box><size>1 1 1</size></box></geometry>"
         "</collision></link></model></sdf>";
}

double lowest_of(const Built& b) { return simulate::lowest_of_model(b.scene, 0); }

/// Where a model without a height stands is up to who uses it.
TEST(InTheWild, AnSdfModelWithoutAHeightIsLiftedOutOfTheGround) {
  for (const char* pose : {"", "<pose>3 4 0 0 0 1</pose>"}) {
    const Built b = built(box_at("0.2", pose));
    EXPECT_NEAR(lowest_of(b), 0, 1e-12);
    ASSERT_EQ(b.places(FactKind::kSpawnedInGround), std::vector<std::string>{"box"});
    EXPECT_NEAR(b.facts[0].value, 0.3, 1e-12);
    EXPECT_FALSE(b.facts[0].severe);
    EXPECT_FALSE(b.blocked);
  }
  const Built above = built(box_at("0.8", ""));
  EXPECT_NEAR(lowest_of(above), 0.3, 1e-12);
  EXPECT_TRUE(above.facts.empty());
}

TEST(InTheWild, AHeightThatIsWrittenCounts) {
  const Built b = built(box_at("0.2", "<pose>0 0 0.1 0 0 0</pose>"));
  EXPECT_NEAR(lowest_of(b), -0.2, 1e-12);
  EXPECT_TRUE(b.facts.empty());
  const std::string text = box_at("0.2", "");
  const std::size_t begin = text.find("<model");
  const std::size_t end = text.find("</sdf>");
  const Built world = built("<sdf version=\"1.9\"><world name=\"w\">" +
                            text.substr(begin, end - begin) + "</world></sdf>");
  EXPECT_NEAR(lowest_of(world), -0.3, 1e-12);
}

std::string leg_under(const std::string& root, const std::string& length) {
  const std::string inertial =
      "<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" "
      "izz=\"1\"/></inertial>";
  return "<robot name=\"r\"><link name=\"" + root + "\">" + (root == "world" ? "" : inertial) +
         "</link><link name=\"leg\">" + inertial +
         "<collision><origin xyz=\"0 0 -0.5\"/><geometry><box size=\"0.1 0.1 " + length +
         "\"/></geometry></collision></link><joint name=\"hip\" type=\"revolute\"><parent link=\"" +
         root +
         "\"/><child link=\"leg\"/><axis xyz=\"0 1 0\"/>"
         "<limit lower=\"-1\" upper=\"1\" effort=\"9\" velocity=\"1\"/></joint></robot>";
}

/// The root of a legged robot is its hip.
TEST(InTheWild, AUrdfIsSetDownFromBelowAndFromAbove) {
  for (const char* length : {"1", "0.2"}) {  // down to -1 and to -0.6
    const Built b = built(leg_under("hip", length));
    EXPECT_NEAR(lowest_of(b), 0, 1e-12) << length;
    const double raised = 0.5 + std::stod(length) / 2;
    EXPECT_NEAR(b.body("r::leg").X_WB.translation.z, raised, 1e-12) << length;
    EXPECT_NEAR(b.scene.joints[0].anchor_W.z, raised, 1e-12) << length;
    EXPECT_TRUE(b.facts.empty());
  }
  // What hangs on the world stays there.
  EXPECT_NEAR(lowest_of(built(leg_under("world", "1"))), -1, 1e-12);
}

}  // namespace
}  // namespace rigor
