// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How readily axes move, against mass matrices that were inverted by hand.

#include <string>
#include <vector>

#include <rigor/robot/rest_inertia.h>

#include <robot/robots.h>

namespace rigor::test {
namespace {

using robot::AxisValues;
using robot::Robot;

/// `moment` about all three axes.
std::string mass_at(const std::string& name, double mass, const std::string& com, double moment) {
  const std::string i = std::to_string(moment);
  return "<link name='" + name + "'><inertial><origin xyz='" + com + "'/><mass value='" +
         std::to_string(mass) + "'/><inertia ixx='" + i + "' iyy='" + i + "' izz='" + i +
         "' ixy='0' ixz='0' iyz='0'/></inertial></link>";
}

std::string hung(const std::string& name, const std::string& parent, const std::string& child,
                 const std::string& type, const std::string& origin = "0 0 0") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/><origin xyz='" + origin +
         "'/><axis xyz='0 1 0'/><limit effort='1' velocity='1' lower='-1' upper='1'/></joint>";
}

AxisValues inverse(const std::string& parts, const std::vector<double>& armature) {
  return inverse_inertias(robot_from("<robot name='r'>" + parts + "</robot>"), armature);
}

const std::string kPendulum = "<link name='world'/>" + mass_at("arm", 2, "0.5 0 0", 1) +
                              hung("j", "world", "arm", "revolute");

TEST(RestInertia, OfAPendulumIsThatAboutItsAxis) {
  EXPECT_NEAR(inverse(kPendulum, {0})[0][0], 1 / 1.5, 1e-12);
  EXPECT_NEAR(inverse(kPendulum, {0.5})[0][0], 1 / 2.0, 1e-12);
}

TEST(RestInertia, OfADoublePendulumIsLessThanThatOfItsParts) {
  // Points of 1 kg at the ends of arms of 1 m, stretched: M = (5 2; 2 1), M⁻¹ = (1 -2; -2 5).
  const AxisValues found =
      inverse("<link name='world'/>" + mass_at("a", 1, "1 0 0", 0) + mass_at("b", 1, "1 0 0", 0) +
                  hung("i", "world", "a", "revolute") + hung("j", "a", "b", "revolute", "1 0 0"),
              {0, 0});
  EXPECT_NEAR(found[0][0], 1, 1e-12);
  EXPECT_NEAR(found[1][0], 5, 1e-12);
}

TEST(RestInertia, OfAFreeRobotBothSidesMove) {
  // Along the line of both centers of mass, or about it, nothing else turns: 1/a + 1/b.
  const std::string parts = mass_at("a", 1, "0 0 0", 3) + mass_at("b", 2, "0 0.5 0", 4);
  EXPECT_NEAR(inverse(parts + hung("j", "a", "b", "prismatic"), {0})[0][0], 1.5, 1e-12);
  EXPECT_NEAR(inverse(parts + hung("j", "a", "b", "continuous"), {0})[0][0], 1.0 / 3 + 1.0 / 4,
              1e-12);
}

TEST(RestInertia, OfWhatHasNoMassIsNotSaid) {
  const std::string parts = "<link name='world'/>" + mass_at("a", 0, "0 0 0", 0);
  EXPECT_EQ(inverse(parts + hung("j", "world", "a", "revolute"), {0})[0][0], 0);
}

}  // namespace
}  // namespace rigor::test
