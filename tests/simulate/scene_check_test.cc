// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What ODE aborts on, or takes silently and spoils (measured with ODE 0.16.2): each is blocked before it
// gets there, at the place of the value.

#include <rigor/simulate/scene/check.h>

#include <cmath>
#include <functional>
#include <limits>

#include <simulate/built.h>

namespace rigor::test {
namespace {

using simulate::FactKind;
using simulate::Facts;
using simulate::Scene;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const std::string kSound = R"(<sdf version="1.9"><world name="w">
<physics type="ode"><max_step_size>0.001</max_step_size><ode><solver><iters>50</iters><sor>1.3</sor></solver>
<constraints><cfm>0.001</cfm><erp>0.2</erp></constraints></ode></physics>
<model name="ground"><static>true</static><link name="g"><collision name="p"><geometry><plane>
<normal>0 0 1</normal></plane></geometry></collision></link></model>
<model name="m"><link name="a"><pose>0 0 1 0 0 0</pose>
<inertial><pose>0.01 0 0 0 0 0</pose><mass>2</mass><inertia><ixx>0.11</ixx><ixy>0.003</ixy><iyy>0.12</iyy>
<izz>0.13</izz></inertia></inertial>
<collision name="c"><geometry><box><size>1 2 3</size></box></geometry></collision>
<collision name="s"><geometry><sphere><radius>0.7</radius></sphere></geometry></collision>
<collision name="y"><geometry><cylinder><radius>0.8</radius><length>0.9</length></cylinder></geometry></collision>
<collision name="k"><geometry><capsule><radius>0.4</radius><length>0.6</length></capsule></geometry></collision>
</link><link name="b"/>
<joint name="j" type="revolute"><pose>0 0 0.25 0 0 0</pose><parent>a</parent><child>b</child>
<axis><xyz>0 1 0</xyz><limit><lower>-1.5</lower><upper>1.5</upper></limit></axis></joint>
</model></world></sdf>)";

TEST(BadInput, TheSoundOneIsTaken) {
  const Built b = built(kSound);
  EXPECT_FALSE(b.blocked);
  EXPECT_TRUE(b.facts.empty());
  EXPECT_TRUE(check_scene(b.scene).empty());
}

struct BadValue {
  const char* from;
  const char* to;
  FactKind kind;
  const char* place;  ///< the bytes that the fact points at
};

class BadInput : public testing::TestWithParam<BadValue> {};

TEST_P(BadInput, IsBlockedWhereItStands) {
  const BadValue& bad = GetParam();
  const Built b = built(replaced(kSound, bad.from, bad.to));
  EXPECT_TRUE(b.blocked) << bad.to;
  EXPECT_EQ(b.places(bad.kind), std::vector<std::string>{bad.place}) << bad.to;
  EXPECT_EQ(b.facts.size(), 1U) << bad.to;
}

INSTANTIATE_TEST_SUITE_P(
    Ode, BadInput,
    testing::Values(
        // Masses and tensors.
        BadValue{"<ixx>0.11", "<ixx>-0.11", FactKind::kInertiaImpossible, "-0.11"},
        BadValue{"<ixx>0.11", "<ixx>0", FactKind::kInertiaImpossible, "0"},
        BadValue{"<ixy>0.003", "<ixy>9", FactKind::kInertiaImpossible,
                 "<inertia><ixx>0.11</ixx><ixy>9</ixy><iyy>0.12</iyy>\n<izz>0.13</izz></inertia>"},
        BadValue{
            "<izz>0.13", "<izz>1.3", FactKind::kInertiaImpossible,
            "<inertia><ixx>0.11</ixx><ixy>0.003</ixy><iyy>0.12</iyy>\n<izz>1.3</izz></inertia>"},
        BadValue{"<ixx>0.11</ixx><ixy>0.003</ixy><iyy>0.12</iyy>\n<izz>0.13",
                 "<ixx>1e-30</ixx><iyy>1e-30</iyy><izz>1e-30", FactKind::kInertiaImpossible,
                 "<inertia><ixx>1e-30</ixx><iyy>1e-30</iyy><izz>1e-30</izz></inertia>"},
        BadValue{"<mass>2", "<mass>0", FactKind::kNoMass, "0"},
        BadValue{"<mass>2", "<mass>-2", FactKind::kNoMass, "-2"},
        BadValue{"<mass>2", "<mass>nan", FactKind::kNotFinite, "nan"},
        BadValue{"<mass>2", "<mass>inf", FactKind::kNotFinite, "inf"},
        BadValue{"<iyy>0.12", "<iyy>nan", FactKind::kNotFinite, "nan"},
        BadValue{"<pose>0.01 0 0 0 0 0", "<pose>0.01 0 nan 0 0 0", FactKind::kNotFinite, "nan"},
        // Sizes.
        BadValue{"0.7</radius>", "nan</radius>", FactKind::kNotFinite, "nan"},
        BadValue{"0.7</radius>", "0</radius>", FactKind::kShapeSize, "0"},
        BadValue{"1 2 3</size>", "1 -2 3</size>", FactKind::kShapeSize, "1 -2 3"},
        BadValue{"1 2 3</size>", "0 0 0</size>", FactKind::kShapeSize, "0 0 0"},
        BadValue{"1 2 3</size>", "1 wide 3</size>", FactKind::kNotFinite, "wide"},
        BadValue{"0.8</radius>", "0</radius>", FactKind::kShapeSize, "0"},
        BadValue{"0.9</length>", "0</length>", FactKind::kShapeSize, "0"},
        BadValue{"0.6</length>", "-0.6</length>", FactKind::kShapeSize, "-0.6"},
        BadValue{"<normal>0 0 1", "<normal>0 0 0", FactKind::kAxisZero, "0 0 0"},
        // Places.
        BadValue{"<pose>0 0 1 0 0 0", "<pose>0 nan 1 0 0 0", FactKind::kNotFinite, "nan"},
        BadValue{"<pose>0 0 1 0 0 0", "<pose>0 0 1e12 0 0 0", FactKind::kTooLarge, "1e12"},
        BadValue{"<pose>0 0 0.25 0 0 0", "<pose>0 0 0.25 inf 0 0", FactKind::kNotFinite, "inf"},
        // Joints.
        BadValue{"<xyz>0 1 0", "<xyz>0 0 0", FactKind::kAxisZero, "0 0 0"},
        BadValue{"<xyz>0 1 0", "<xyz>0 nan 0", FactKind::kNotFinite, "nan"},
        BadValue{"<lower>-1.5", "<lower>2", FactKind::kLimitsCrossed, "2"},
        BadValue{"<upper>1.5", "<upper>nan", FactKind::kNotFinite, "nan"},
        BadValue{"<parent>a", "<parent>nobody", FactKind::kUnreadable, "nobody"},
        // How time goes on.
        BadValue{"<max_step_size>0.001", "<max_step_size>0", FactKind::kStep, "0"},
        BadValue{"<max_step_size>0.001", "<max_step_size>-1", FactKind::kStep, "-1"},
        BadValue{"<max_step_size>0.001", "<max_step_size>nan", FactKind::kNotFinite, "nan"},
        BadValue{"<erp>0.2", "<erp>5", FactKind::kStep, "5"},
        BadValue{"<cfm>0.001", "<cfm>-1", FactKind::kStep, "-1"},
        BadValue{"<iters>50", "<iters>0", FactKind::kStep, "0"},
        BadValue{"<sor>1.3", "<sor>0", FactKind::kStep, "0"}));

/// What no file can say, and a hand-made scene can.
struct Spoiled {
  const char* what;
  FactKind kind;
  std::function<void(Scene&)> spoil;
};

TEST(SceneCheck, HandMadeScenes) {
  const Scene sound = built(kSound).scene;
  ASSERT_EQ(sound.bodies.size(), 2U);
  ASSERT_EQ(sound.shapes.size(), 5U);
  const auto triangle = [](std::uint32_t last) {
    return mesh::TriangleMesh{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                              .triangles = {{0, 1, last}}};
  };
  const auto soup = [&](mesh::TriangleMesh mesh) {
    return [mesh](Scene& s) {
      s.meshes = {mesh};
      s.shapes[1].kind = simulate::TriangleSoup{0};
    };
  };
  mesh::TriangleMesh with_nan = triangle(2);
  with_nan.positions[1].y = kNan;
  const Spoiled cases[] = {
      {"joint to itself", FactKind::kUnreadable,
       [](Scene& s) { s.joints[0].parent = s.joints[0].child; }},
      {"anchor", FactKind::kNotFinite, [](Scene& s) { s.joints[0].anchor_W.x = kNan; }},
      {"axis not of length 1", FactKind::kAxisZero,
       [](Scene& s) { s.joints[0].axes[0].direction_W = {}; }},
      {"no axis", FactKind::kAxisZero, [](Scene& s) { s.joints[0].axes.clear(); }},
      {"negative friction", FactKind::kNotFinite,
       [](Scene& s) { s.joints[0].axes[0].friction = -1; }},
      {"body index", FactKind::kTooLarge, [](Scene& s) { s.shapes[1].body = 7; }},
      {"mimic index", FactKind::kTooLarge, [](Scene& s) { s.joints[0].mimics.push_back({5}); }},
      {"mesh index", FactKind::kTooLarge,
       [](Scene& s) { s.shapes[1].kind = simulate::ConvexHull{3}; }},
      {"vertex index", FactKind::kTooLarge, soup(triangle(3))},
      {"flat triangle", FactKind::kShapeSize, soup(triangle(1))},
      {"vertex", FactKind::kNotFinite, soup(with_nan)},
      {"no triangles", FactKind::kShapeSize, soup({})},
      {"zero quaternion", FactKind::kNotFinite,
       [](Scene& s) {
         s.bodies[0].X_WB.rotation = {0, 0, 0, 0};
       }},
      {"moving plane", FactKind::kShapeSize, [](Scene& s) { s.shapes[0].body = 0; }},
      {"heights", FactKind::kTooLarge,
       [](Scene& s) {
         s.shapes[1].kind = simulate::HeightGrid{2, 2, 1, 1, {0, 0, 0}};
       }},
      {"mu", FactKind::kNotFinite, [](Scene& s) { s.shapes[1].surface.mu = kNan; }},
      {"gravity", FactKind::kNotFinite, [](Scene& s) { s.gravity.z = kNan; }},
      {"step", FactKind::kStep, [](Scene& s) { s.solver.step = kNan; }},
      {"too many", FactKind::kTooLarge,
       [](Scene& s) { s.bodies.resize(simulate::kMaxBodies + 1, s.bodies[0]); }},
  };
  for (const Spoiled& spoiled : cases) {
    Scene scene = sound;
    spoiled.spoil(scene);
    const Facts facts = check_scene(scene);
    ASSERT_EQ(facts.size(), 1U) << spoiled.what;
    EXPECT_EQ(facts[0].kind, spoiled.kind) << spoiled.what;
    EXPECT_TRUE(facts[0].severe) << spoiled.what;
  }
}

}  // namespace
}  // namespace rigor::test
