// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene/build.h>

#include <cmath>
#include <numbers>

#include <simulate/built.h>
#include <support/meshes.h>

namespace rigor::test {
namespace {

using simulate::ConvexHull;
using simulate::FactKind;
using simulate::HalfSpace;
using simulate::kWorld;
using simulate::TriangleSoup;

constexpr double kExact = 1e-12;

std::string model_of(const std::string& inside) {
  return "<sdf version=\"1.9\"><model name=\"m\">" + inside + "</model></sdf>";
}

const std::string kKilogram =
    "<inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></"
    "inertial>";

std::string link_text(const std::string& name, const std::string& inside) {
  return "<link name=\"" + name + "\">" + inside + "</link>";
}

std::string box_of_link(const std::string& inside = {}) {
  return "<collision name=\"c\"><geometry>" +
         (inside.empty() ? "<box><size>1 2 3</size></box>" : inside) + "</geometry></collision>";
}

constexpr const char* kCartUrdf = R"(<robot name="cart">
  <link name="wheel"><inertial><mass value="9"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
    <collision><geometry><sphere radius="0.1"/></geometry></collision>
    <collision><geometry><sphere radius="0.2"/></geometry></collision></link>
  <link name="body"><inertial><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <joint name="axle" type="continuous"><parent link="body"/><child link="wheel"/><axis xyz="0 1 0"/>
  </joint></robot>)";

/// Tilt and creep are the base's: a wheel that comes first in the file turns over as it rolls.
TEST(Build, TheBaseIsTheRootOfTheTreeAndNotTheFirstLink) {
  const Built b = built(kCartUrdf);
  ASSERT_LT(b.scene.models[0].base, b.scene.bodies.size());
  EXPECT_EQ(b.scene.bodies[b.scene.models[0].base].name, "cart::body");
}

/// Of two that no joint carries the one with more on it.
TEST(Build, OfSeveralRootsTheHeaviestTreeIsTheBase) {
  const Built b = built(model_of(link_text("lid", kKilogram) + link_text("pot", kKilogram) +
                                 link_text("handle", kKilogram) +
                                 "<joint name=\"j\" type=\"revolute\"><parent>pot</parent>"
                                 "<child>handle</child><axis><xyz>0 0 1</xyz></axis></joint>"));
  EXPECT_EQ(b.scene.bodies[b.scene.models[0].base].name, "m::pot");
}

TEST(Build, CollisionsWithoutANameAreCounted) {
  const Built b = built(kCartUrdf);
  ASSERT_EQ(b.scene.shapes.size(), 2U);
  EXPECT_EQ(b.scene.shapes[0].name, "cart::wheel::#1");
  EXPECT_EQ(b.scene.shapes[1].name, "cart::wheel::#2");
}

TEST(BuildWorld, IsTheSameWithoutWhatWouldHaveToBeDownloaded) {
  const std::string uri = "https://fuel.gazebosim.org/1.0/openrobotics/models/tree";
  const std::string include = "<include><uri>" + uri + "</uri></include>";
  const std::string model =
      "<model name=\"m\">" + link_text("a", kKilogram + box_of_link()) + "</model>";
  const Built whole =
      built("<sdf version=\"1.9\"><world name=\"w\">" + include + model + "</world></sdf>");
  EXPECT_FALSE(whole.blocked);
  EXPECT_EQ(whole.scene.bodies.size(), 1U);
  EXPECT_EQ(whole.places(FactKind::kElementIgnored), std::vector<std::string>{uri});
  // A part of a model is another matter: without it the model is another one.
  const Built part = built(model_of(include + link_text("a", kKilogram + box_of_link())));
  EXPECT_TRUE(part.blocked);
  EXPECT_EQ(part.places(FactKind::kUnreadable), std::vector<std::string>{uri});
}

TEST(BuildBody, ARootWithoutMassIsTakenWhereItIsHeld) {
  const std::string cart =
      "<robot name=\"cart\"><link name=\"rail\"/><link name=\"cart\"><inertial><mass value=\"1\"/>"
      "<inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link>"
      "<joint name=\"x\" type=\"prismatic\"><parent link=\"rail\"/><child link=\"cart\"/>"
      "<limit effort=\"1\" velocity=\"1\" lower=\"-1\" upper=\"1\"/></joint></robot>";
  const Built free = built(cart);
  EXPECT_TRUE(free.blocked);
  ASSERT_EQ(free.facts.size(), 1U);
  EXPECT_NE(free.facts[0].help.find("--base fixed"), std::string::npos);
  const Built held = built(cart, {}, {.root = simulate::SceneOptions::Root::kHeld});
  EXPECT_FALSE(held.blocked);
  EXPECT_EQ(held.scene.bodies.size(), 2U);
  // What moves needs a mass all the same.
  const std::string link = "<link name=\"rail\"/>";
  const Built tip =
      built(replaced(replaced(cart, link, ""), "</robot>",
                     link + "<link name=\"tip\"/><joint name=\"y\" type=\"continuous\">"
                            "<parent link=\"cart\"/><child link=\"tip\"/></joint></robot>"),
            {}, {.root = simulate::SceneOptions::Root::kHeld});
  EXPECT_TRUE(tip.blocked);
}

/// By hand: two point-like kilograms a meter apart about their middle: 0.1 + 2 · 0.5² about y and z.
TEST(BuildBody, FixedJointsMerge) {
  const Built b = built(
      model_of(link_text("a", kKilogram) +
               link_text("b", "<pose>1 0 0 0 0 0</pose>" + kKilogram + box_of_link()) +
               "<joint name=\"j\" type=\"fixed\"><parent>a</parent><child>b</child></joint>"));
  ASSERT_FALSE(b.blocked);
  ASSERT_EQ(b.scene.bodies.size(), 1U);
  EXPECT_TRUE(b.scene.joints.empty());
  const auto& body = b.scene.bodies[0];
  EXPECT_EQ(body.name, "m::a");
  EXPECT_EQ(body.links.size(), 2U);
  EXPECT_NEAR(body.mass.mass, 2, kExact);
  EXPECT_NEAR(body.mass.com.x, 0.5, kExact);
  EXPECT_NEAR(body.mass.about_com.ixx, 0.2, kExact);
  EXPECT_NEAR(body.mass.about_com.iyy, 0.2 + 0.5, kExact);
  EXPECT_NEAR(body.mass.about_com.izz, 0.2 + 0.5, kExact);
  ASSERT_EQ(b.scene.shapes.size(), 1U);
  EXPECT_EQ(b.scene.shapes[0].body, 0U);
  EXPECT_EQ(b.scene.shapes[0].X_BS.translation, (model::Vector3{1, 0, 0}));
  EXPECT_EQ(b.scene.shapes[0].extent, 3);
}

TEST(BuildBody, ALoopOfFixedJointsIsOneBody) {
  std::string text =
      link_text("a", kKilogram) + link_text("b", kKilogram) + link_text("c", kKilogram);
  for (const char* ends : {"ab", "bc", "ca"}) {
    text += std::string("<joint name=\"") + ends + "\" type=\"fixed\"><parent>" + ends[0] +
            "</parent><child>" + ends[1] + "</child></joint>";
  }
  const Built b = built(model_of(text));
  EXPECT_FALSE(b.blocked);
  EXPECT_EQ(b.scene.bodies.size(), 1U);
  EXPECT_TRUE(b.scene.joints.empty());
}

/// A kinematic part and one that falls cannot be one body.
TEST(BuildBody, DifferentFlagsStayTwoBodies) {
  const Built b = built(
      model_of(link_text("a", kKilogram) + link_text("b", "<gravity>false</gravity>" + kKilogram) +
               "<joint name=\"j\" type=\"fixed\"><parent>a</parent><child>b</child></joint>"));
  ASSERT_EQ(b.scene.bodies.size(), 2U);
  EXPECT_TRUE(b.scene.bodies[0].gravity);
  EXPECT_FALSE(b.scene.bodies[1].gravity);
  ASSERT_EQ(b.scene.joints.size(), 1U);
  EXPECT_EQ(b.scene.joints[0].type, model::JointType::kFixed);
}

TEST(BuildBody, WhatIsFixedToTheWorldIsTheWorlds) {
  const Built b = built(model_of(
      "<pose>0 0 5 0 0 0</pose>" + link_text("post", box_of_link()) + link_text("arm", kKilogram) +
      "<joint name=\"j\" type=\"fixed\"><parent>world</parent><child>post</child></joint>"
      "<joint name=\"k\" type=\"revolute\"><parent>post</parent><child>arm</child>"
      "<axis><xyz>0 0 2</xyz></axis></joint>"));
  ASSERT_FALSE(b.blocked);
  ASSERT_EQ(b.scene.bodies.size(), 1U);
  EXPECT_EQ(b.scene.shapes[0].body, kWorld);
  EXPECT_EQ(b.scene.shapes[0].X_BS.translation.z, 5);
  EXPECT_EQ(b.scene.links[0].body, kWorld);
  EXPECT_EQ(b.scene.joints[0].parent, kWorld);
  EXPECT_EQ(b.scene.joints[0].axes[0].direction_W, (model::Vector3{0, 0, 1}));
}

TEST(BuildBody, DefaultsOfSdf) {
  const Built b = built(model_of("<pose>0 0 9 0 0 0</pose>" + link_text("a", box_of_link())));
  ASSERT_EQ(b.scene.bodies.size(), 1U);
  EXPECT_EQ(b.scene.bodies[0].mass.mass, 1);
  EXPECT_EQ(b.scene.bodies[0].mass.about_com.ixx, 1);
  EXPECT_TRUE(b.scene.alone);
  EXPECT_EQ(b.scene.gravity.z, -9.8);
  EXPECT_TRUE(b.facts.empty());
  EXPECT_NEAR(b.scene.size, std::sqrt(14.0), kExact);
}

TEST(BuildBody, FlagsOfLinksAndModels) {
  const Built b = built(model_of(
      "<self_collide>true</self_collide>" + link_text("a", kKilogram) +
      link_text("b",
                "<self_collide>false</self_collide><kinematic>true</kinematic>"
                "<velocity_decay><linear>0.01</linear><angular>0.02</angular></velocity_decay>")));
  EXPECT_TRUE(b.body("m::a").self_collide);
  EXPECT_FALSE(b.body("m::b").self_collide);
  EXPECT_TRUE(b.body("m::b").kinematic);
  EXPECT_EQ(b.body("m::b").linear_damping, 0.01);
  EXPECT_EQ(b.body("m::b").angular_damping, 0.02);
}

const std::string kUrdfInertial =
    "<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" "
    "izz=\"1\"/></inertial>";

/// As every second ROS robot begins.
TEST(BuildBody, AUrdfFootprintIsMergedIntoWhatItCarries) {
  const std::string text =
      "<robot name=\"r\"><link name=\"footprint\"/><link name=\"base\">" + kUrdfInertial +
      "</link><joint name=\"j\" type=\"fixed\"><parent link=\"footprint\"/><child link=\"base\"/>"
      "<origin xyz=\"0 0 0.5\"/></joint></robot>";
  const Built b = built(text);
  ASSERT_FALSE(b.blocked);
  ASSERT_EQ(b.scene.bodies.size(), 1U);
  EXPECT_EQ(b.scene.bodies[0].mass.mass, 1);
  EXPECT_EQ(b.scene.bodies[0].mass.com.z, 0.5);
  const Built moving = built(replaced(text, "type=\"fixed\"", "type=\"continuous\""));
  EXPECT_TRUE(moving.blocked);
  EXPECT_EQ(moving.places(FactKind::kNoMass), std::vector<std::string>{"footprint"});
}

/// What has no mass is a frame of what it is fixed to, also where that floats.
TEST(BuildBody, AUrdfLinkWithoutMassFollowsWhatItIsFixedTo) {
  const auto fixed = [](const std::string& name, const std::string& parent,
                        const std::string& child) {
    return "<joint name=\"" + name + "\" type=\"fixed\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/></joint>";
  };
  // The joints stand in an order in which no parent is known before its child.
  const Built b = built(
      "<robot name=\"r\"><link name=\"base\">" + kUrdfInertial + "</link><link name=\"camera\">" +
      kUrdfInertial + "</link><link name=\"mount\"/><link name=\"optical\"/>" +
      fixed("c", "camera", "optical") + fixed("b", "mount", "camera") +
      fixed("a", "base", "mount") +
      "<gazebo reference=\"camera\"><turnGravityOff>true</turnGravityOff></gazebo></robot>");
  ASSERT_FALSE(b.blocked);
  ASSERT_EQ(b.scene.bodies.size(), 2U);
  EXPECT_TRUE(b.body("r::base").gravity);
  EXPECT_EQ(b.body("r::base").links.size(), 2U);  // with its mount
  EXPECT_FALSE(b.body("r::camera").gravity);
  EXPECT_EQ(b.body("r::camera").links.size(), 2U);
}

/// The camera's tensor is none, but it is riveted to what makes up for it: the engine sees only the sum.
TEST(BuildBody, ABodyIsJudgedAsAWhole) {
  const std::string camera =
      "<inertial><mass>0.1</mass><inertia><ixx>0.001</ixx><iyy>0.001</iyy>"
      "<izz>0.003</izz></inertia></inertial>";
  const std::string links = link_text("a", kKilogram) + link_text("b", camera);
  const Built b = built(model_of(
      links + "<joint name=\"j\" type=\"fixed\"><parent>a</parent><child>b</child></joint>"));
  EXPECT_FALSE(b.blocked);
  EXPECT_NEAR(moving_mass(b.scene), 1.1, kExact);
  EXPECT_NEAR(b.scene.bodies[0].mass.about_com.izz, 0.103, kExact);
  EXPECT_EQ(built(model_of(links)).places(FactKind::kInertiaImpossible).size(), 1U);
}

/// A pose that cannot be read must not become the origin, wherever it stands.
TEST(BuildBody, NumbersOfFramesCount) {
  const Built b = built(model_of("<frame name=\"f\"><pose>0 0 one 0 0 0</pose></frame>" +
                                 link_text("a", "<pose relative_to=\"f\"/>" + kKilogram)));
  EXPECT_TRUE(b.blocked);
  EXPECT_EQ(b.places(FactKind::kNotFinite), std::vector<std::string>{"one"});
}

TEST(BuildBody, AUrdfRootNamedWorldIsTheWorld) {
  const Built b =
      built("<robot name=\"r\"><link name=\"world\"/><link name=\"arm\">" + kUrdfInertial +
            "</link><joint name=\"j\" type=\"continuous\"><parent link=\"world\"/>"
            "<child link=\"arm\"/><axis xyz=\"0 1 0\"/></joint></robot>");
  ASSERT_FALSE(b.blocked);
  ASSERT_EQ(b.scene.bodies.size(), 1U);
  EXPECT_EQ(b.scene.joints[0].parent, kWorld);
}

TEST(BuildWorld, ModelsGroundAndPhysics) {
  const Built b = built(
      "<sdf version=\"1.6\"><world name=\"w\"><gravity>0 0 -1.6</gravity>"
      "<physics "
      "type=\"ode\"><max_step_size>0.002</max_step_size><max_contacts>7</max_contacts><ode>"
      "<solver><type>world</type><iters>80</iters><sor>1.1</sor></solver>"
      "<constraints><cfm>0</cfm><erp>0.3</erp><contact_max_correcting_vel>100</"
      "contact_max_correcting_vel>"
      "<contact_surface_layer>0.002</contact_surface_layer></constraints></ode></physics>"
      "<model name=\"ground\"><static>true</static>" +
      link_text("l", box_of_link("<plane><normal>0 0 2</normal><size>9 9</size></plane>")) +
      "</model>" + "<model name=\"a\"><pose>1 2 3 0 0 0</pose>" + link_text("l", kKilogram) +
      "<model name=\"in\">" + link_text("l", kKilogram) + "</model></model></world></sdf>");
  ASSERT_FALSE(b.blocked);
  EXPECT_FALSE(b.scene.alone);
  EXPECT_EQ(b.scene.name, "w");
  EXPECT_EQ(b.scene.gravity.z, -1.6);
  ASSERT_EQ(b.scene.models.size(), 2U);
  EXPECT_TRUE(b.scene.models[0].is_static);
  EXPECT_EQ(b.scene.models[0].base, kWorld);
  ASSERT_EQ(b.scene.bodies.size(), 2U);
  EXPECT_EQ(b.scene.bodies[1].name, "a::in::l");
  EXPECT_EQ(b.scene.bodies[1].model, 1U);
  EXPECT_EQ(b.scene.bodies[0].X_WB.translation, (model::Vector3{1, 2, 3}));
  const auto* plane = std::get_if<HalfSpace>(&b.scene.shapes[0].kind);
  ASSERT_NE(plane, nullptr);
  EXPECT_EQ(plane->normal.z, 1);
  EXPECT_TRUE(std::isinf(b.scene.shapes[0].extent));
  const simulate::SolverSettings& s = b.scene.solver;
  EXPECT_EQ(s.step, 0.002);
  EXPECT_EQ(s.solver, simulate::Solver::kDantzig);
  EXPECT_EQ(s.iterations, 80);
  EXPECT_EQ(s.sor, 1.1);
  EXPECT_EQ(s.erp, 0.3);
  EXPECT_GT(s.cfm, 0);  // with zero the exact solver ends the process
  EXPECT_EQ(s.max_correcting_velocity, 0.1);
  EXPECT_EQ(s.surface_layer, 0.002);
  EXPECT_EQ(s.max_contacts, 7);
}

/// A world writes SDF's default of 100 m/s; both profiles have their own most.
TEST(BuildWorld, GazebosSettings) {
  const std::string text =
      "<sdf version=\"1.6\"><world name=\"w\"><physics type=\"ode\"><ode><constraints>"
      "<contact_max_correcting_vel>100</contact_max_correcting_vel></constraints></ode></physics>"
      "<model name=\"a\">" +
      link_text("l", kKilogram) + "</model></world></sdf>";
  const Built b = built(text, {}, {.profile = simulate::SceneOptions::Profile::kGazebo});
  EXPECT_EQ(b.scene.solver.iterations, 50);
  EXPECT_EQ(b.scene.solver.cfm, 0);
  EXPECT_TRUE(b.scene.solver.stiffness);
  EXPECT_EQ(b.scene.solver.max_correcting_velocity, 0.01);
  EXPECT_EQ(built(text).scene.solver.max_correcting_velocity, 0.1);
  EXPECT_EQ(built(replaced(text, "100", "0.05")).scene.solver.max_correcting_velocity, 0.05);
}

/// A light has no effect, and the ground of Gazebo's database is a plane.
TEST(BuildWorld, SunAndGroundPlaneOfTheDatabaseNeedNotBeInstalled) {
  const std::string model =
      "<model name=\"m\">" + link_text("a", kKilogram + box_of_link()) + "</model>";
  for (const auto& [sun, ground] : std::vector<std::pair<std::string, std::string>>{
           {"model://sun", "model://ground_plane"},
           {"https://fuel.gazebosim.org/1.0/OpenRobotics/models/Sun",
            "https://fuel.gazebosim.org/1.0/OpenRobotics/models/Ground Plane"}}) {
    const Built b = built("<sdf version=\"1.6\"><world name=\"w\"><include><uri>" + sun +
                          "</uri></include><include><uri>" + ground +
                          "</uri><pose>0 0 2 0 0 0</pose></include>" + model + "</world></sdf>");
    EXPECT_FALSE(b.blocked);
    EXPECT_TRUE(b.places(FactKind::kElementIgnored).empty());
    ASSERT_EQ(b.scene.shapes.size(), 2U);
    EXPECT_TRUE(std::holds_alternative<simulate::HalfSpace>(b.scene.shapes[0].kind));
    EXPECT_EQ(b.scene.shapes[0].body, simulate::kWorld);
    EXPECT_EQ(b.scene.shapes[0].X_BS.translation.z, 2);
  }
  // A model lacks what it includes, whatever its name.
  EXPECT_TRUE(built(model_of("<include><uri>model://ground_plane</uri></include>" +
                             link_text("a", kKilogram + box_of_link())))
                  .blocked);
}

TEST(BuildWorld, OneModelOfSeveral) {
  const std::string text = "<sdf version=\"1.6\"><world name=\"w\"><model name=\"a\">" +
                           link_text("l", kKilogram) + "</model><model name=\"b\">" +
                           link_text("l", kKilogram) + "</model></world></sdf>";
  const Built b = built(text, {}, {.model = "b"});
  ASSERT_EQ(b.scene.bodies.size(), 1U);
  EXPECT_EQ(b.scene.bodies[0].name, "b::l");
  EXPECT_TRUE(b.scene.alone);
  EXPECT_TRUE(built(text, {}, {.model = "c"}).blocked);
}

TEST(BuildWorld, WhatIsMissingIsSaid) {
  const Built b = built(
      "<sdf version=\"1.6\"><world name=\"w\"><include><uri>model://gone</uri>"
      "</include></world></sdf>");
  EXPECT_TRUE(b.blocked);
  EXPECT_EQ(b.places(FactKind::kUnreadable), std::vector<std::string>{"model://gone"});
  const Built still = built(model_of("<static>true</static>" + link_text("a", box_of_link())));
  EXPECT_FALSE(still.blocked) << "there is only nothing to run";
  EXPECT_EQ(still.places(FactKind::kNothingMoves), std::vector<std::string>{"m"});
}

TEST(BuildWorld, ConstraintsAreAsStiffAsTheMassAsks) {
  const auto cfm_of = [](const std::string& mass) {
    return built(replaced(model_of(link_text("a", kKilogram)), "<mass>1<", "<mass>" + mass + "<"))
        .scene.solver.cfm;
  };
  EXPECT_EQ(cfm_of("1"), 1e-5);
  EXPECT_EQ(cfm_of("100"), 1e-5);
  EXPECT_NEAR(cfm_of("20000"), 5e-8, 1e-12);
}

// ---- shapes ----

TEST(BuildShape, Primitives) {
  const Built b = built(model_of(
      "<pose>0 0 9 0 0 0</pose>" +
      link_text(
          "a",
          "<collision "
          "name=\"s\"><geometry><sphere><radius>0.5</radius></sphere></geometry></collision>"
          "<collision "
          "name=\"c\"><geometry><cylinder><radius>0.1</radius><length>2</length></cylinder>"
          "</geometry></collision>"
          "<collision "
          "name=\"p\"><geometry><capsule><radius>0.1</radius><length>1</length></capsule>"
          "</geometry></collision>"
          "<collision name=\"e\"><geometry><ellipsoid><radii>2 2 2</radii></ellipsoid></geometry>"
          "</collision>")));
  ASSERT_EQ(b.scene.shapes.size(), 4U);
  EXPECT_EQ(std::get<mesh::Sphere>(b.scene.shapes[0].kind).radius, 0.5);
  EXPECT_EQ(std::get<mesh::Cylinder>(b.scene.shapes[1].kind).length, 2);
  EXPECT_NEAR(b.scene.shapes[2].extent, 1.2, kExact);
  EXPECT_EQ(std::get<mesh::Sphere>(b.scene.shapes[3].kind).radius, 2);
  EXPECT_TRUE(b.facts.empty());
}

TEST(BuildShape, EllipsoidConeAndPolylineAreHulls) {
  for (const auto& [geometry, x, z] :
       {std::tuple{"<ellipsoid><radii>1 2 3</radii></ellipsoid>", 2.0, 6.0},
        std::tuple{"<cone><radius>1</radius><length>4</length></cone>", 2.0, 4.0},
        std::tuple{"<polyline><point>0 0</point><point>2 0</point><point>0 1</point>"
                   "<height>3</height></polyline>",
                   2.0, 3.0}}) {
    const Built b = built(model_of(link_text("a", box_of_link(geometry))));
    ASSERT_EQ(b.scene.shapes.size(), 1U) << geometry;
    const auto* hull = std::get_if<ConvexHull>(&b.scene.shapes[0].kind);
    ASSERT_NE(hull, nullptr) << geometry;
    const auto bounds = mesh::bounds_of(b.scene.meshes[hull->mesh].positions);
    EXPECT_NEAR(bounds.max.x - bounds.min.x, x, 1e-9) << geometry;
    EXPECT_NEAR(bounds.max.z - bounds.min.z, z, 1e-9) << geometry;
    EXPECT_EQ(b.places(FactKind::kShapeAsHull).size(), 1U);
    EXPECT_FALSE(b.blocked);
  }
}

/// A prism of `sides` about z, of radius 0.1 and length 0.05.
TriangleMesh wheel_mesh(unsigned sides) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, -0.025}, {0, 0, 0.025}};
  for (unsigned i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (const double z : {-0.025, 0.025}) {
      mesh.positions.push_back({0.1 * std::cos(angle), 0.1 * std::sin(angle), z});
    }
  }
  for (unsigned i = 0; i < sides; ++i) {
    const unsigned a = 2 + 2 * i;
    const unsigned b = 2 + 2 * ((i + 1) % sides);
    mesh.triangles.insert(mesh.triangles.end(),
                          {{0, b, a}, {1, a + 1, b + 1}, {a, b, b + 1}, {a, b + 1, a + 1}});
  }
  return mesh;
}

std::string mesh_link(const std::string& more = {}) {
  return model_of(
      link_text("a", kKilogram + box_of_link("<mesh><uri>w.stl</uri>" + more + "</mesh>")));
}

TEST(BuildMesh, AWheelOf32SegmentsIsACylinder) {
  const Built b = built(mesh_link(), {{"w.stl", binary_stl(wheel_mesh(32))}});
  ASSERT_EQ(b.scene.shapes.size(), 1U);
  const auto* cylinder = std::get_if<mesh::Cylinder>(&b.scene.shapes[0].kind);
  ASSERT_NE(cylinder, nullptr);
  EXPECT_NEAR(cylinder->radius, 0.1, 1e-6);
  EXPECT_NEAR(cylinder->length, 0.05, 1e-6);
  EXPECT_EQ(b.places(FactKind::kMeshAsPrimitive).size(), 1U);
  // The prism's share of its cylinder: n sin(2π/n) / 2π.
  EXPECT_NEAR(b.facts[0].value, 32 * std::sin(std::numbers::pi / 16) / (2 * std::numbers::pi),
              1e-4);
  EXPECT_EQ(b.facts[0].name, "cylinder");
}

TEST(BuildMesh, EightSidesAreNoCylinder) {
  const Built b = built(mesh_link(), {{"w.stl", binary_stl(wheel_mesh(8))}});
  ASSERT_EQ(b.scene.shapes.size(), 1U);
  EXPECT_TRUE(
      std::holds_alternative<ConvexHull>(b.scene.shapes[0].kind));  // it moves and is convex
  EXPECT_EQ(b.places(FactKind::kMeshAsHull).size(), 1U);
  const Built as = built(mesh_link(), {{"w.stl", binary_stl(wheel_mesh(32))}},
                         {.meshes = simulate::MeshAs::kTriangles});
  const auto* soup = std::get_if<TriangleSoup>(&as.scene.shapes[0].kind);
  ASSERT_NE(soup, nullptr);
  EXPECT_EQ(as.scene.meshes[soup->mesh].triangles.size(), 128U);
}

/// A rim without ends is hollow, but rolls like a wheel: only where it turns about itself.
TEST(BuildMesh, AHollowRimThatTurnsIsACylinder) {
  TriangleMesh rim = wheel_mesh(32);
  std::erase_if(rim.triangles, [](const Triangle& t) { return t[0] < 2; });
  const TextFiles files{{"w.stl", binary_stl(rim)}};
  const Built loose = built(mesh_link(), files);
  EXPECT_TRUE(std::holds_alternative<TriangleSoup>(loose.scene.shapes[0].kind));
  const std::string turning =
      replaced(mesh_link(), "</model>",
               link_text("base", kKilogram) +
                   "<joint name=\"j\" type=\"continuous\"><parent>base</parent>"
                   "<child>a</child><axis><xyz>0 0 1</xyz></axis></joint></model>");
  const Built wheel = built(turning, files);
  EXPECT_TRUE(std::holds_alternative<mesh::Cylinder>(wheel.scene.shapes[0].kind));
  const Built across = built(replaced(turning, "0 0 1</xyz>", "1 0 0</xyz>"), files);
  EXPECT_TRUE(std::holds_alternative<TriangleSoup>(across.scene.shapes[0].kind));
}

TEST(BuildMesh, BoxMeshIsABoxWhereverItStands) {
  const Built b = built(mesh_link("<scale>2 1 -1</scale>"),
                        {{"w.stl", binary_stl(box_mesh({1, 2, 3}, {10, 0, 5}))}});
  ASSERT_EQ(b.scene.shapes.size(), 1U);
  const auto* box = std::get_if<mesh::Box>(&b.scene.shapes[0].kind);
  ASSERT_NE(box, nullptr);
  const model::Pose& X = b.scene.shapes[0].X_BS;
  EXPECT_NEAR(X.translation.x, 20, 1e-5);
  EXPECT_NEAR(X.translation.z, -5, 1e-5);
  EXPECT_NEAR(box->size.x * box->size.y * box->size.z, 12, 1e-4);
}

TEST(BuildMesh, MissingMeshesAreLeftOut) {
  const Built b = built(mesh_link());
  EXPECT_TRUE(b.scene.shapes.empty());
  EXPECT_FALSE(b.blocked);
  EXPECT_EQ(b.places(FactKind::kMeshMissing), std::vector<std::string>{"w.stl"});
  EXPECT_EQ(b.scene.models[0].missing_shapes, 1U);
}

TEST(BuildShape, APlaneThatMovesIsNone) {
  const Built b =
      built(model_of(link_text("a", box_of_link("<plane><normal>0 0 1</normal></plane>"))));
  EXPECT_TRUE(b.scene.shapes.empty());
  EXPECT_EQ(b.places(FactKind::kShapeIgnored), std::vector<std::string>{"plane"});
}

}  // namespace
}  // namespace rigor::test
