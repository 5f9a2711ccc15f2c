// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/sweep.h>

#include <gtest/gtest.h>

#include <set>

namespace rigor::simulate {
namespace {

TEST(Sweep, NamesEveryPointOfTheGridOnce) {
  const auto cases =
      cases_of({{"friction", 0.2, 1.0, 3}, {"mass", 1, 2, 2}}, {.first = 5, .count = 2});
  ASSERT_EQ(cases.size(), 12U);
  std::set<std::string> ids;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_EQ(cases[i].index, i);
    ids.insert(cases[i].id);
  }
  EXPECT_EQ(ids.size(), 12U);
  EXPECT_EQ(cases[0].id, "friction=0.2 mass=1 seed=5");
  EXPECT_EQ(cases[1].id, "friction=0.2 mass=1 seed=6");
  EXPECT_EQ(cases[2].id, "friction=0.2 mass=2 seed=5");
  EXPECT_EQ(cases[4].id, "friction=0.6 mass=1 seed=5");
  EXPECT_EQ(cases[11].id, "friction=1 mass=2 seed=6");
}

TEST(Sweep, WithoutAGridItIsTheSeeds) {
  const auto cases = cases_of({}, {.first = 0, .count = 3});
  ASSERT_EQ(cases.size(), 3U);
  EXPECT_EQ(cases[2].id, "seed=2");
}

TEST(Sweep, RefusesMoreThanAnybodyCanRun) {
  EXPECT_TRUE(
      cases_of({{"friction", 0, 1, 4'000'000'000U}, {"mass", 1, 2, 4'000'000'000U}}, {}).empty());
}

TEST(Sweep, ChangesWhatItNames) {
  Scene scene;
  scene.shapes.resize(2);
  SceneBody body;
  body.mass = {.mass = 3, .com = {1, 2, 3}, .about_com = {1, 0.1, 0.2, 2, 0.3, 2.5}};
  scene.bodies.push_back(body);
  scene.gravity = {0, -3, -4};
  vary(scene, {.values = {{"friction", 0.25},
                          {"mass", 2},
                          {"inertia", 10},
                          {"gravity", 1.6},
                          {"time-step", 0.002}},
               .seed = 9});
  for (const SceneShape& shape : scene.shapes) {
    EXPECT_EQ(shape.surface.mu, 0.25);
    EXPECT_EQ(shape.surface.mu2, 0.25);
  }
  EXPECT_EQ(scene.bodies[0].mass.mass, 6);
  EXPECT_DOUBLE_EQ(scene.bodies[0].mass.about_com.iyy, 40);
  EXPECT_DOUBLE_EQ(scene.gravity.y, -0.96);
  EXPECT_DOUBLE_EQ(scene.gravity.z, -1.28);
  EXPECT_EQ(scene.solver.step, 0.002);
  EXPECT_EQ(scene.solver.seed, 9U);
}

TEST(Sweep, SaysWhatAValueCannotBe) {
  EXPECT_EQ(bad_value("friction", 0), "");
  EXPECT_EQ(bad_value("gravity", 0), "");
  EXPECT_NE(bad_value("mass", 0), "");
  EXPECT_NE(bad_value("time-step", -1), "");
  EXPECT_NE(bad_value("friction", kInfinity), "");
}

}  // namespace
}  // namespace rigor::simulate
