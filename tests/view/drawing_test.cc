// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/drawing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <rigor/view/drawing/shapes.h>
#include <rigor/view/image/picture.h>

#include "drawing_fixture.h"

namespace rigor::view {
namespace {

using model::Vector3;

void expect_place(const Vector3& actual, const Vector3& expected, double within = 1e-12) {
  EXPECT_NEAR(actual.x, expected.x, within);
  EXPECT_NEAR(actual.y, expected.y, within);
  EXPECT_NEAR(actual.z, expected.z, within);
}

/// Two links; the second is turned by 90° about z, and its joint turns about its x.
const std::string kTwoLinks =
    "<sdf version='1.9'><model name='arm'><pose>1 0 0 0 0 0</pose>"
    "<link name='base'><visual name='plate'><pose>0 0 0.5 0 0 0</pose><geometry><box><size>2 4 "
    "1</size>"
    "</box></geometry></visual></link>"
    "<link name='tip'><pose>0 3 0 0 0 1.5707963267948966</pose><collision name='rod'>"
    "<pose>0.5 0 0 0 0 "
    "0</pose><geometry><cylinder><radius>0.1</radius><length>2</length></cylinder>"
    "</geometry></collision><visual><geometry><sphere><radius>0.2</radius></sphere></geometry></"
    "visual>"
    "</link><joint name='hinge' type='revolute'><parent>base</parent><child>tip</child><axis>"
    "<xyz>1 0 0</xyz><limit><lower>-2</lower><upper>2</upper></limit></axis></joint></model></sdf>";

TEST(Drawing, HasTheShapesWhereTheirPosesPutThem) {
  const Drawing drawing =
      DrawnModel("arm.sdf", {{"arm.sdf", kTwoLinks}}).draw({Layer::kVisual, Layer::kCollision});
  ASSERT_EQ(drawing.bodies.size(), 3U);
  EXPECT_TRUE(drawing.not_drawn.empty());
  EXPECT_EQ(drawing.bodies[0].name, "arm/link base/visual plate");
  EXPECT_EQ(drawing.bodies[1].name, "arm/link tip/visual 1");
  EXPECT_EQ(drawing.bodies[2].name, "arm/link tip/collision rod");
  EXPECT_EQ(drawing.bodies[2].layer, Layer::kCollision);
  expect_place(drawing.bodies[0].pose.translation, {1, 0, 0.5});
  expect_place(place_of(drawing.bodies[0], {0.5, 0.5, 0.5}), {2, 2, 1});
  // The link's x is the model's y.
  expect_place(drawing.bodies[2].pose.translation, {1, 3.5, 0});
  // From the box's left rear lower corner; the ball's right is beyond nothing, the rod's ends are highest.
  expect_place(drawing.bounds.min, {0, -2, -1});
  expect_place(drawing.bounds.max, {2, 3.6, 1}, 1e-9);
}

TEST(Drawing, MovesWithTheJoints) {
  DrawnModel arm("arm.sdf", {{"arm.sdf", kTwoLinks}});
  // Turned by 90° about the link's x, which is the world's y: the link's z points along the world's x.
  const Drawing drawing =
      arm.draw({Layer::kCollision}, {{"arm::hinge", {std::numbers::pi / 2, 0}}});
  ASSERT_EQ(drawing.bodies.size(), 1U);
  expect_place(place_of(drawing.bodies[0], {0, 0, 0.5}), {2, 3.5, 0});
}

TEST(Drawing, DrawsAnAxisAsAnArrowAlongIt) {
  const Drawing drawing =
      DrawnModel("arm.sdf", {{"arm.sdf", kTwoLinks}}).draw({Layer::kVisual, Layer::kAxes});
  ASSERT_EQ(drawing.bodies.size(), 3U);
  const Body& axis = drawing.bodies[2];
  EXPECT_EQ(axis.name, "arm/joint hinge/axis");
  EXPECT_EQ(axis.joint.value, 0U);
  EXPECT_EQ(axis.link.value, 1U);
  expect_place(axis.pose.translation, {1, 3, 0});
  const Vector3 tip = place_of(axis, {0, 0, 1});
  EXPECT_GT(tip.y, 3.1);
  expect_place(tip, {1, tip.y, 0});
}

TEST(Drawing, DrawsFramesAlongTheLinksAxes) {
  const Drawing drawing = DrawnModel("arm.sdf", {{"arm.sdf", kTwoLinks}}).draw({Layer::kFrames});
  ASSERT_EQ(drawing.bodies.size(), 2U);
  const Body& frame = drawing.bodies[1];
  ASSERT_EQ(frame.mesh->parts.size(), 3U);
  ASSERT_EQ(frame.surfaces.size(), 3U);
  const std::array<Vector3, 3> tips{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::array<Vector3, 3> along{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}};  // in the world
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 tip = place_of(frame, tips[i]) - frame.pose.translation;
    expect_place((1 / length(tip)) * tip, along[i]);
    double farthest = 0;
    const mesh::Part& part = frame.mesh->parts[i];
    for (std::size_t t = part.first; t < part.first + part.count; ++t) {
      for (const Vector3& p : mesh::facet(*frame.mesh, frame.mesh->triangles[t])) {
        farthest = std::max(farthest, dot(p, tips[i]));
        EXPECT_LE(length(p - dot(p, tips[i]) * tips[i]), 0.1) << "an arrow is thin";
      }
    }
    EXPECT_DOUBLE_EQ(farthest, 1);
  }
}

TEST(Drawing, DrawsTheBoxThatAnInertiaIsThatOf) {
  // A box of 0.2 × 0.3 × 0.5, 4 kg, its moments by the closed form: m (b² + c²) / 12.
  const std::string inertial =
      "<inertial><mass>4</mass><pose>1 2 3 0 0 0.6</pose><inertia>"
      "<ixx>0.11333333333333333</ixx><iyy>0.09666666666666667</iyy><izz>0.043333333333333335</izz>"
      "<ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial>";
  const Drawing drawing = drawn_sdf(inertial, {Layer::kInertia, Layer::kCom});
  ASSERT_EQ(drawing.bodies.size(), 2U);
  expect_place(drawing.bodies[0].pose.translation, {1, 2, 3});
  expect_place(drawing.bodies[1].pose.translation, {1, 2, 3});
  EXPECT_LT(drawing.bodies[0].surfaces.at(0).color.a, 1);
  // The eight corners are those of the written box, whichever way its axes are named.
  for (const double x : {-0.1, 0.1}) {
    for (const double y : {-0.15, 0.15}) {
      for (const double z : {-0.25, 0.25}) {
        const Vector3 corner{1 + x * std::cos(0.6) - y * std::sin(0.6),
                             2 + x * std::sin(0.6) + y * std::cos(0.6), 3 + z};
        double nearest = 1;
        for (const Vector3& p : drawing.bodies[0].mesh->positions) {
          nearest = std::min(nearest, length(place_of(drawing.bodies[0], p) - corner));
        }
        EXPECT_LT(nearest, 1e-9);
      }
    }
  }
}

TEST(Drawing, SaysWhatNoBodyCanHave) {
  const Drawing drawing = drawn_sdf(
      "<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>5</izz></inertia></inertial>",
      {Layer::kInertia, Layer::kCom});
  ASSERT_EQ(drawing.not_drawn.size(), 1U);
  EXPECT_EQ(drawing.not_drawn[0].name, "m/link body/inertia");
  ASSERT_EQ(drawing.bodies.size(), 1U);
  EXPECT_EQ(drawing.bodies[0].layer, Layer::kCom);
}

TEST(Drawing, ShowsNoMassWhereAUrdfHasNone) {
  const Drawing drawing =
      DrawnModel("r.urdf", {{"r.urdf", "<robot name='r'><link name='a'/></robot>"}})
          .draw({Layer::kInertia, Layer::kCom});
  EXPECT_TRUE(drawing.bodies.empty());
  EXPECT_GT(drawing.bounds.min.x, drawing.bounds.max.x);
}

TEST(Drawing, SharesTheMeshesOfEqualShapes) {
  const Drawing drawing = drawn_sdf(
      visual_of("<box><size>1 2 3</size></box>") + visual_of("<box><size>4 5 6</size></box>") +
          visual_of("<capsule><radius>1</radius><length>3</length></capsule>") +
          visual_of("<capsule><radius>2</radius><length>6</length></capsule>"),
      {Layer::kVisual});
  ASSERT_EQ(drawing.bodies.size(), 4U);
  EXPECT_EQ(drawing.bodies[0].mesh, drawing.bodies[1].mesh);
  EXPECT_EQ(drawing.bodies[2].mesh, drawing.bodies[3].mesh);
  expect_place(drawing.bounds.max, {2, 2.5, 5});
}

TEST(Drawing, ClipsAPlaneToWhatStandsOnIt) {
  const std::string plane = "<plane><normal>0 0 1</normal><size>1000 1000</size></plane>";
  const Drawing drawing = drawn_sdf(
      visual_of(plane) + visual_of("<box><size>2 2 2</size></box>", "<pose>100 0 1 0 0 0</pose>"),
      {Layer::kVisual, Layer::kGround});
  ASSERT_EQ(drawing.bodies.size(), 3U);
  expect_place(drawing.bounds.min, {99, -1, 0});
  const Body& drawn = drawing.bodies[0];
  EXPECT_NEAR(drawn.pose.translation.x, 100, 1e-9);
  EXPECT_LT(drawn.scale.x, 50);
  EXPECT_GT(drawn.scale.x, 4);
  EXPECT_GT(drawing.bodies[2].pose.translation.z, 0) << "two planes in one place flicker";
}

TEST(Drawing, KeepsASmallPlaneAsItIs) {
  const Drawing drawing =
      drawn_sdf(visual_of("<plane><normal>1 0 0</normal><size>2 3</size></plane>") +
                    visual_of("<box><size>9 9 9</size></box>"),
                {Layer::kVisual});
  ASSERT_EQ(drawing.bodies.size(), 2U);
  const Body& plane = drawing.bodies[0];
  expect_place(plane.scale, {2, 3, 1});
  expect_place(rotate(plane.pose.rotation, {0, 0, 1}), {1, 0, 0});
}

TEST(Drawing, BoundsAPlaneThatIsAlone) {
  const Drawing drawing = drawn_sdf(
      visual_of("<plane><normal>0 0 1</normal><size>2 3</size></plane>"), {Layer::kVisual});
  expect_place(drawing.bounds.min, {-1, -1.5, 0});
  expect_place(drawing.bounds.max, {1, 1.5, 0});
}

TEST(Drawing, LaysTheGroundUnderTheModel) {
  for (const double size : {0.01, 0.3, 2.0, 40.0}) {
    const std::string s = std::to_string(size);
    const Drawing drawing =
        drawn_sdf(visual_of("<box><size>" + s + ' ' + s + ' ' + s + "</size></box>"),
                  {Layer::kVisual, Layer::kGround});
    ASSERT_EQ(drawing.bodies.size(), 2U);
    const Body& ground = drawing.bodies[1];
    EXPECT_EQ(ground.layer, Layer::kGround);
    EXPECT_NEAR(drawing.bounds.max.x, size / 2, 1e-9) << "the ground counts in no bounds";
    double area = 0;
    double reach = 0;
    for (const mesh::Triangle& t : ground.mesh->triangles) {
      area += mesh::area(mesh::facet(*ground.mesh, t));
      for (const Vector3& p : mesh::facet(*ground.mesh, t)) {
        EXPECT_EQ(p.z, 0);
        reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
      }
    }
    EXPECT_NEAR(area, 4 * reach * reach, 1e-9 * area) << "each place is covered once";
    EXPECT_GE(reach, size);
    EXPECT_LE(reach, 30 * size);
    EXPECT_LE(ground.mesh->triangles.size(), 10'000U);
  }
}

TEST(Drawing, SetsAModelDownOnItsLowestPoint) {
  const std::string box = "<box><size>1 1 1</size></box>";
  const auto level = [&](const std::string& parts) {
    return drawn_sdf(parts, {Layer::kVisual, Layer::kGround}).bodies.back().pose.translation.z;
  };
  EXPECT_NEAR(level(visual_of(box, "<pose>0 0 -2 0 0 0</pose>")), -2.5, 1e-9);
  // What floats is drawn floating.
  EXPECT_EQ(level(visual_of(box, "<pose>0 0 2 0 0 0</pose>")), 0);
  // A floor of its own says where the ground is.
  const double with_floor =
      level(visual_of("<plane><normal>0 0 1</normal><size>9 9</size></plane>") +
            visual_of(box, "<pose>0 0 -2 0 0 0</pose>"));
  EXPECT_GE(with_floor, 0);
  EXPECT_LT(with_floor, 0.01);
  const Drawing world =
      DrawnModel("w.sdf",
                 {{"w.sdf", "<sdf version='1.9'><world name='w'><model name='m'><link name='l'>" +
                                visual_of(box, "<pose>0 0 -2 0 0 0</pose>") +
                                "</link></model></world></sdf>"}})
          .draw({Layer::kVisual, Layer::kGround});
  EXPECT_EQ(world.bodies.back().pose.translation.z, 0);
}

TEST(Drawing, SaysWhyAShapeIsNotDrawn) {
  const Drawing drawing = drawn_sdf(
      visual_of("<box><size>1 -1 1</size></box>") +
          visual_of("<sphere><radius>0</radius></sphere>") +
          visual_of("<sphere><radius>1</radius></sphere>", "<pose>1e300 0 0 0 0 0</pose>") +
          visual_of("<mesh><uri>meshes/arm.stl</uri></mesh>") + visual_of("") +
          visual_of("<sphere><radius>1</radius></sphere>", "<pose relative_to='none'/>") +
          visual_of("<plane><normal>0 0 0</normal></plane>") +
          visual_of("<polyline><point>0 0</point><point>1 0</point></polyline>") +
          visual_of("<heightmap><uri>land.png</uri></heightmap>") + visual_of("<empty/>"),
      {Layer::kVisual});
  EXPECT_TRUE(drawing.bodies.empty());
  ASSERT_EQ(drawing.not_drawn.size(), 9U);
  EXPECT_EQ(drawing.not_drawn[3].reason, "meshes/arm.stl is not found");
  EXPECT_EQ(drawing.not_drawn[3].name, "m/link body/visual v");
  EXPECT_EQ(drawing.not_drawn[8].reason, "land.png is not found");
  for (const NotDrawn& each : drawing.not_drawn) EXPECT_FALSE(each.reason.empty());
}

TEST(Drawing, DrawsSoManyTrianglesAndNoMore) {
  constexpr std::size_t kLands = 21;  // of 524,288 triangles each
  const Picture flat{kMaxHeights, kMaxHeights,
                     std::vector<Pixel>(kMaxHeights * kMaxHeights, Pixel{9, 9, 9, 255})};
  std::string lands;
  for (std::size_t i = 1; i <= kLands; ++i) {
    const std::string size = "<size>1 1 " + std::to_string(i) + "</size>";
    lands += visual_of("<heightmap><uri>land.png</uri>" + size + "</heightmap>");
  }
  const Drawing drawing = drawn_sdf(lands, {Layer::kVisual}, {{"land.png", to_png(flat)}});
  ASSERT_FALSE(drawing.bodies.empty());
  EXPECT_EQ(drawing.bodies.size(), kMaxDrawnTriangles / drawing.bodies[0].mesh->triangles.size());
  EXPECT_EQ(drawing.bodies.size() + drawing.not_drawn.size(), kLands);
}

TEST(Drawing, CountsAMeshThatBodiesShareOnce) {
  constexpr std::size_t kBalls = 3000;  // of 4,096 triangles each
  std::string balls;
  for (std::size_t i = 0; i < kBalls; ++i) balls += visual_of("<sphere/>");
  EXPECT_EQ(drawn_sdf(balls, {Layer::kVisual}).bodies.size(), kBalls);
}

TEST(Drawing, NamesItsLayers) {
  EXPECT_EQ(layer_names().size(), 8U);
  for (const std::string_view name : layer_names()) {
    ASSERT_TRUE(layer_named(name));
    EXPECT_EQ(to_string(*layer_named(name)), name);
  }
  EXPECT_FALSE(layer_named("visuals"));
}

}  // namespace
}  // namespace rigor::view
