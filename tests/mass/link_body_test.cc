// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What links weigh, how shapes overlap, and whether robots stand: by hand.

#include <rigor/mass/link_body.h>

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rigor/mass/resolve.h>
#include <rigor/mass/stance.h>
#include <rigor/mass/total.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/mesh_finder.h>

#include "support/meshes.h"

namespace rigor::mass {
namespace {

constexpr double kTight = 1e-12;

/// A model read from text, with meshes beside it.
class Robot {
 public:
  explicit Robot(const std::string& links, const std::string& version = "1.11",
                 std::map<std::string, std::string> meshes = {})
      : disk_(std::move(meshes)),
        environment_(disk_, {}),
        workspace_(disk_, sources_),
        surveys_(disk_),
        loaded_(load({workspace_, environment_.resolver, environment_.sdf, environment_.urdf},
                     workspace_.put("r.sdf", "<sdf version='" + version + "'><model name='r'>" +
                                                 links + "</model></sdf>"))),
        frames_(loaded_.root),
        find_mesh_(rules::mesh_finder(environment_.resolver, sources_, surveys_)) {}

  LinkBody body(From from = From::kCollisions) const {
    return link_body(root(), frames_, {0}, from, find_mesh_);
  }
  Resolved resolved() const { return resolve(root(), frames_, {0}, find_mesh_); }
  PartOverlaps compared() const { return overlaps_in(root(), frames_, {0}, From::kCollisions); }
  std::vector<PartOverlap> overlaps() const { return compared().list; }
  std::optional<Stance> stance(const model::Vector3& com) const {
    return stance_of(root(), frames_, {0}, find_mesh_, com);
  }
  const model::Root& root() const { return loaded_.root; }
  const model::Frames& frames() const { return frames_; }

 private:
  MemoryDisk disk_;
  Environment environment_;
  Sources sources_;
  read::Workspace workspace_;
  MeshSurveys surveys_;
  read::Loaded loaded_;
  model::Frames frames_;
  FindMesh find_mesh_;
};

std::string collision(const std::string& name, const std::string& shape,
                      const std::string& more = "") {
  return "<collision name='" + name + "'>" + more + "<geometry>" + shape +
         "</geometry></collision>";
}

std::string box_shape(const std::string& size) { return "<box><size>" + size + "</size></box>"; }

TEST(LinkBody, TwoBoxesAreOneBody) {
  const Robot robot("<link name='l'>" + collision("a", box_shape("1 1 1")) +
                    collision("b", box_shape("1 1 1"), "<pose>2 0 0 0 0 0</pose>") + "</link>");
  const MassProperties whole = of_density(robot.body(), 6);
  EXPECT_TRUE(robot.body().complete());
  EXPECT_NEAR(whole.mass, 12, kTight);
  EXPECT_NEAR(whole.com.x, 1, kTight);
  // Each has 1 kg·m² about its own center, and lies 1 m from the whole's.
  EXPECT_NEAR(whole.about_com.ixx, 2, kTight);
  EXPECT_NEAR(whole.about_com.iyy, 2 + 12, kTight);
}

TEST(LinkBody, SaysWhyAShapeIsNoSolid) {
  const auto why = [](const std::string& shape) {
    return Robot("<link name='l'>" + collision("a", shape) + "</link>").body().parts.at(0).why;
  };
  EXPECT_EQ(why("<plane><normal>0 0 1</normal></plane>"), NoSolid::kUnbounded);
  EXPECT_EQ(why(box_shape("1 0 1")), NoSolid::kSize);
  EXPECT_EQ(why("<mesh><uri>none.stl</uri></mesh>"), NoSolid::kNoMesh);
  EXPECT_EQ(why(""), NoSolid::kNoShape);
  EXPECT_FALSE(Robot("<link name='l'/>").body().complete());
}

TEST(LinkBody, AMeshIsWhatItEncloses) {
  const Robot robot("<link name='l'>" +
                        collision("a", "<mesh><uri>m.stl</uri><scale>.1 .1 .1</scale></mesh>") +
                        "</link>",
                    "1.11", {{"m.stl", test::binary_stl(test::box_mesh({1, 1, 1}))}});
  EXPECT_NEAR(of_density(robot.body(), 1).mass, 1e-3, 1e-15);
}

TEST(LinkBody, APoseRelativeToAnotherFrameIsResolved) {
  const Robot robot("<link name='l'><pose>5 0 0 0 0 0</pose>" +
                    collision("a", box_shape("1 1 1"), "<pose relative_to='f'>0 0 1 0 0 0</pose>") +
                    "</link><frame name='f'><pose>7 0 0 0 0 0</pose></frame>");
  const MassProperties body = of_density(robot.body(), 1);
  EXPECT_NEAR(body.com.x, 2, kTight);
  EXPECT_NEAR(body.com.z, 1, kTight);
}

TEST(Overlap, HalfABallInABox) {
  const Robot robot(
      "<link name='l'>" + collision("a", box_shape("1 1 1")) +
      collision("b", "<sphere><radius>0.1</radius></sphere>", "<pose>0 0 0.5 0 0 0</pose>") +
      collision("c", "<sphere><radius>0.1</radius></sphere>", "<pose>0 0 5 0 0 0</pose>") +
      "</link>");
  ASSERT_EQ(robot.overlaps().size(), 1U);
  EXPECT_NEAR(robot.overlaps()[0].share, 0.5, 0.01);
}

TEST(Overlap, TouchingShapesDoNotOverlap) {
  const Robot robot("<link name='l'>" + collision("a", box_shape("1 1 1")) +
                    collision("b", box_shape("1 1 1"), "<pose>1 0 0 0 0 0</pose>") + "</link>");
  EXPECT_TRUE(robot.overlaps().empty());
}

std::string row_of_boxes(int count, double apart) {
  std::string collisions;
  for (int i = 0; i < count; ++i) {
    collisions += collision(fmt::format("c{}", i), box_shape("1 1 1"),
                            fmt::format("<pose>{} 0 0 0 0 0</pose>", i * apart));
  }
  return "<link name='l'>" + collisions + "</link>";
}

TEST(Overlap, OfARowEachWithTheNext) {
  const PartOverlaps compared = Robot(row_of_boxes(60, 0.75)).compared();
  EXPECT_TRUE(compared.complete);
  ASSERT_EQ(compared.list.size(), 59U);
  for (std::size_t i = 0; i < 59; ++i) {
    EXPECT_EQ(compared.list[i].first, i);
    EXPECT_EQ(compared.list[i].second, i + 1);
    EXPECT_NEAR(compared.list[i].share, 0.25, 0.01);
  }
}

/// Two million pairs, of which each would take a third of a millisecond.
TEST(Overlap, OfThousandsInOnePlaceSomeAreLeftOut) {
  const PartOverlaps compared = Robot(row_of_boxes(2000, 0)).compared();
  EXPECT_FALSE(compared.complete);
  EXPECT_EQ(compared.list.size(), kMaxCompared);
}

TEST(Overlap, TwoCylindersAcross) {
  // Steinmetz: two cylinders of radius r at right angles share 16 r³/3.
  const std::string cylinder = "<cylinder><radius>0.5</radius><length>3</length></cylinder>";
  const Robot robot("<link name='l'>" + collision("a", cylinder) +
                    collision("b", cylinder, "<pose>0 0 0 1.5707963267948966 0 0</pose>") +
                    "</link>");
  const double shared = 16 * 0.125 / 3;
  ASSERT_EQ(robot.overlaps().size(), 1U);
  EXPECT_NEAR(robot.overlaps()[0].share, shared / (M_PI * 0.25 * 3), 0.01);
}

TEST(ResolveAutomatic, DensityOfTheCollisionThenOfTheLinkThenWater) {
  const auto mass = [](const std::string& of_link, const std::string& of_collision) {
    return Robot("<link name='l'><inertial auto='true'>" + of_link + "</inertial>" +
                 collision("a", box_shape("1 1 1"), of_collision) + "</link>")
        .resolved();
  };
  EXPECT_NEAR(mass("", "").body.mass, 1000, kTight);
  EXPECT_NEAR(mass("<density>2</density>", "").body.mass, 2, kTight);
  EXPECT_NEAR(mass("<density>2</density>", "<density>3</density>").body.mass, 3, kTight);
  EXPECT_EQ(mass("", "").taken, Taken::kAutomatic);
  EXPECT_NEAR(mass("<density>6</density>", "").body.about_com.ixx, 1, kTight);
  // A written mass scales the whole (libsdformat 15.2).
  EXPECT_NEAR(mass("<mass>12</mass>", "").body.about_com.ixx, 2, kTight);
}

TEST(ResolveAutomatic, WithoutASolidItStaysAtTheDefaults) {
  const Resolved found = Robot("<link name='l'><inertial auto='true'/></link>").resolved();
  EXPECT_EQ(found.taken, Taken::kAutomaticUnknown);
  EXPECT_EQ(found.body.mass, 1);
}

TEST(Total, LinksAreAddedWhereTheyAre) {
  const std::string inertial =
      "<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>";
  const Robot robot("<link name='a'>" + inertial +
                    "</link><link name='b'><pose>0 2 0 0 0 0</pose>" + inertial + "</link>");
  const Total sum = total(robot.root(), robot.frames(), {0},
                          [&](model::Id<model::Link> link) { return resolve(robot.root(), link); });
  ASSERT_TRUE(sum.body);
  EXPECT_EQ(sum.mass, 2);
  EXPECT_NEAR(sum.body->com.y, 1, kTight);
  EXPECT_NEAR(sum.body->about_com.ixx, 4, kTight);
}

TEST(Stance, ABoxStandsOnItsFourCorners) {
  const Robot robot("<link name='l'><pose>0 0 0.5 0 0 0</pose>" +
                    collision("a", box_shape("2 4 1")) + "</link>");
  const auto stance = robot.stance({0.25, 0, 0.5});
  ASSERT_TRUE(stance && stance->margin);
  EXPECT_EQ(stance->points, 4U);
  EXPECT_NEAR(stance->height, 0, kTight);
  EXPECT_NEAR(*stance->margin, 0.75, kTight);
  EXPECT_NEAR(*robot.stance({1.5, 0, 0})->margin, -0.5, kTight);
}

TEST(Stance, AWheelStandsOnItsLine) {
  const auto wheel = [](const std::string& name, const std::string& place) {
    return "<collision name='" + name + "'><pose>" + place +
           " 1.5707963267948966 0 0</pose><geometry><cylinder><radius>0.1</radius>"
           "<length>0.05</length></cylinder></geometry></collision>";
  };
  const Robot robot("<link name='l'>" + wheel("a", "-0.2 -0.2 0.1") + wheel("b", "-0.2 0.2 0.1") +
                    wheel("c", "0.2 -0.2 0.1") + wheel("d", "0.2 0.2 0.1") + "</link>");
  EXPECT_NEAR(*robot.stance({0, 0, 0.2})->margin, 0.2, 1e-9);
  EXPECT_NEAR(*robot.stance({0.2042, 0, 0.2})->margin, -0.0042, 1e-9);
}

TEST(Stance, WhatTheWorldHoldsDoesNotStand) {
  const Robot robot("<link name='l'>" + collision("a", box_shape("1 1 1")) +
                    "</link><joint name='j' type='fixed'><parent>world</parent>"
                    "<child>l</child></joint>");
  EXPECT_FALSE(robot.stance({0, 0, 0}));
}

TEST(Stance, ABallStandsOnNothing) {
  const Robot robot("<link name='l'>" + collision("a", "<sphere><radius>1</radius></sphere>") +
                    "</link>");
  EXPECT_FALSE(robot.stance({0, 0, 0})->margin);
  EXPECT_NEAR(robot.stance({0, 0, 0})->height, -1, kTight);
}

TEST(Stance, ATurnedEllipsoidReachesAsFarAsItsSupport) {
  // Turned by 45° about y: √((a² + c²)/2) down.
  const Robot robot("<link name='l'><pose>0 0 0 0 0.7853981633974483 0</pose>" +
                    collision("a", "<ellipsoid><radii>3 1 1</radii></ellipsoid>") + "</link>");
  EXPECT_NEAR(robot.stance({0, 0, 0})->height, -std::sqrt(5), 1e-9);
}

}  // namespace
}  // namespace rigor::mass
