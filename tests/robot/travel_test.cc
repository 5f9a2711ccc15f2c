// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/assembled/travel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include <robot/loaded_text.h>

namespace rigor::test::travel {
namespace {

constexpr double kRounding = 1e-9;

std::string bar(const std::string& name, const std::string& size, const std::string& at) {
  return "<link name='" + name + "'><collision><origin xyz='" + at + "'/><geometry><box size='" +
         size + "'/></geometry></collision></link>";
}

std::string joint(const std::string& type, const std::string& child, const std::string& parent,
                  const std::string& at, const std::string& axis, const std::string& limit = "") {
  return "<joint name='" + child + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/><origin xyz='" + at + "'/><axis xyz='" + axis + "'/>" +
         limit + "</joint>";
}

/// A robot and its joints' sides.
class Travel {
 public:
  explicit Travel(const std::string& inside)
      : loaded_("<robot name='r'>" + inside + "</robot>"),
        frames_(loaded_.root()),
        robot_(robot::assemble(loaded_.root(), frames_, {})),
        rigid_(loaded_.root(), frames_, robot_) {}

  std::optional<robot::JointSides> sides(std::uint32_t joint) const {
    return robot::sides_of({joint}, loaded_.root(), frames_, robot_, rigid_);
  }
  std::optional<robot::Range> range(std::uint32_t joint) const {
    return robot::limited_range(loaded_.root().joints[joint]);
  }
  const robot::RigidGroups& rigid() const { return rigid_; }

 private:
  LoadedText loaded_;
  model::Frames frames_;
  robot::Assembled robot_;
  robot::RigidGroups rigid_;
};

/// Two bars of a meter that form a line at zero, with a hinge between them.
const std::string kBars =
    bar("upper", "1 0.2 0.2", "0.5 0 0") + bar("lower", "1 0.1 0.1", "0.5 0 0");

TEST(JointTravel, AFoldedBarIsInsideTheOther) {
  const Travel travel(kBars + joint("revolute", "lower", "upper", "1 0 0", "0 1 0"));
  const auto sides = travel.sides(0);
  ASSERT_TRUE(sides);
  EXPECT_NEAR(sides->at(0).inside, 0, kRounding);
  EXPECT_EQ(sides->at(0).gap, 0);
  EXPECT_NEAR(sides->at(std::numbers::pi).inside, 1, kRounding);
  EXPECT_NEAR(sides->at(-std::numbers::pi).inside, 1, kRounding);
}

/// A hinge beyond the end of the bar, so that the other swings about it at a distance.
TEST(JointTravel, TheGapIsThatOfTheTurnedBoxes) {
  const Travel travel(kBars + joint("revolute", "lower", "upper", "1.3 0 0", "0 0 1"));
  const auto sides = travel.sides(0);
  ASSERT_TRUE(sides);
  EXPECT_NEAR(sides->at(0).gap, 0.3, kRounding);
  // Across the first, 0.05 m of its width is on this side of the hinge.
  EXPECT_NEAR(sides->at(std::numbers::pi / 2).gap, 0.25, kRounding);
  EXPECT_EQ(sides->at(std::numbers::pi).gap, 0);
  EXPECT_NEAR(sides->at(std::numbers::pi).inside, 0.75, kRounding);  // 0.7 of it, by quarters
}

TEST(JointTravel, ASliderMovesByItsPosition) {
  const Travel travel(kBars + joint("prismatic", "lower", "upper", "1.2 0 0", "-2 0 0"));
  const auto sides = travel.sides(0);
  ASSERT_TRUE(sides);
  EXPECT_NEAR(sides->at(0).gap, 0.2, kRounding);
  EXPECT_NEAR(sides->at(-0.1).gap, 0.3, kRounding);
  EXPECT_NEAR(sides->at(0.7).inside, 0.5, kRounding);
}

/// At zero, at the middle and at both ends, in order, and nowhere beyond them.
TEST(JointTravel, PositionsAreWithinTheLimits) {
  const Travel travel(kBars + joint("revolute", "lower", "upper", "1 0 0", "0 1 0"));
  for (const robot::Range range : {robot::Range{-1, 2}, robot::Range{0.5, 3}, robot::Range{0, 1}}) {
    const auto stands = travel.sides(0)->between(range);
    const auto has = [&stands](double position) {
      return std::any_of(stands.begin(), stands.end(), [position](const robot::Stand& stand) {
        return std::abs(stand.position - position) < kRounding;
      });
    };
    EXPECT_EQ(stands.front().position, range.lower);
    EXPECT_NEAR(stands.back().position, range.upper, kRounding);
    EXPECT_TRUE(has((range.lower + range.upper) / 2));
    EXPECT_EQ(has(0), range.lower <= 0);
    for (std::size_t i = 1; i < stands.size(); ++i)
      EXPECT_LT(stands[i - 1].position, stands[i].position);
  }
}

/// What is fixed to a link moves with it, on both sides.
TEST(JointTravel, FixedLinksBelongToTheirSide) {
  const Travel travel(kBars + bar("plate", "0.1 1 1", "0 0 0") +
                      bar("tip", "0.1 0.1 0.1", "0 0 0") +
                      joint("revolute", "lower", "upper", "1 0 0", "0 1 0") +
                      joint("fixed", "plate", "upper", "3 0 0", "1 0 0") +
                      joint("fixed", "tip", "lower", "1.5 0 0", "1 0 0"));
  const auto sides = travel.sides(0);
  ASSERT_TRUE(sides);
  EXPECT_EQ(sides->child.size(), 2U);
  EXPECT_EQ(sides->parent.size(), 2U);
  EXPECT_TRUE(travel.rigid().is_fixed_to(3, 1));
  EXPECT_FALSE(travel.rigid().is_fixed_to(3, 0));
  EXPECT_EQ(travel.rigid().leaders, (robot::Links{0, 1, 0, 1}));
  EXPECT_EQ(travel.rigid().members[0], (robot::Links{0, 2}));
  EXPECT_EQ(travel.rigid().members[1], (robot::Links{1, 3}));
  EXPECT_FALSE(travel.sides(1)) << "a fixed joint has one position";
}

/// However the file orders the links of a chain, and where fixed joints form a cycle.
TEST(JointTravel, AChainOfFixedLinksHasOneLeader) {
  const auto fixed = [](const std::string& child, const std::string& parent) {
    return joint("fixed", child, parent, "0 0 0", "1 0 0");
  };
  std::string links;
  for (const char* name : {"c", "a", "d", "b", "p", "q"}) links += bar(name, "1 1 1", "0 0 0");
  const Travel chain(links + fixed("b", "a") + fixed("c", "b") + fixed("d", "c") +
                     joint("revolute", "p", "d", "0 0 0", "0 1 0") + fixed("q", "p"));
  EXPECT_EQ(chain.rigid().leaders, (robot::Links{1, 1, 1, 1, 4, 4}));
  const Travel cycle(links + fixed("b", "a") + fixed("a", "b"));
  EXPECT_EQ(cycle.rigid().leaders[1], cycle.rigid().leaders[3]);
}

TEST(JointTravel, NothingIsKnownOfALinkWithAMeshThatIsNot) {
  const Travel travel(bar("upper", "1 0.2 0.2", "0.5 0 0") +
                      "<link name='lower'><visual><geometry><mesh filename='no.stl'/></geometry>"
                      "</visual></link>" +
                      joint("revolute", "lower", "upper", "1 0 0", "0 1 0"));
  EXPECT_FALSE(travel.sides(0));
  const Travel comma(bar("upper", "1 0,2 0.2", "0.5 0 0") + bar("lower", "1 0.1 0.1", "0.5 0 0") +
                     joint("revolute", "lower", "upper", "1 0 0", "0 1 0"));
  EXPECT_FALSE(comma.sides(0)) << "a size that cannot be read";
}

TEST(JointTravel, ARangeHasTwoLimitsThatAreMeant) {
  const auto range = [](const std::string& limit) {
    return Travel(kBars + joint("revolute", "lower", "upper", "1 0 0", "0 1 0",
                                "<limit effort='1' velocity='1' " + limit + "/>"))
        .range(0);
  };
  ASSERT_TRUE(range("lower='-1' upper='2'"));
  EXPECT_EQ(range("lower='-1' upper='2'")->upper, 2);
  EXPECT_FALSE(range("lower='2' upper='-1'"));
  EXPECT_FALSE(range("lower='1' upper='1'"));
  EXPECT_FALSE(range("lower='-1e9' upper='1e9'"));
  EXPECT_FALSE(range("lower='-1' upper='inf'"));
}

}  // namespace
}  // namespace rigor::test::travel
