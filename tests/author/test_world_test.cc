// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What `validate` and the reader make of the world.

#include <rigor/author/test_world.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <variant>

#include <rigor/mass/resolve.h>
#include <rigor/model/frames.h>
#include <rigor/rules/validate.h>

#include "author/model_text.h"
#include "support/meshes.h"

namespace rigor::author {
namespace {

using mesh::TriangleMesh;
using mesh::Vector3;
using test::ModelText;

struct World {
  World(const TriangleMesh& mesh, const Vector3& scale)
      : bytes(test::binary_stl(mesh)),
        survey(mass::survey_mesh(MemoryDisk({{"w/a.stl", bytes}}), {"w/a.stl"})),
        text(test_world({"part", "a.stl", scale}, survey)),
        model({{"w/a.stl", bytes}, {"w/test.sdf", text}}, "w/test.sdf", text) {}

  /// Of the mesh's corners in the world.
  mesh::Bounds placed(const TriangleMesh& mesh) const {
    const model::Root& root = model.loaded.root;
    const auto X = model::Frames(root).pose(model::Id<model::Visual>{1});
    const auto& s = std::get<model::Mesh>(root.visuals.at(1).geometry.shape).scale.value;
    std::vector<Vector3> places;
    for (const Vector3& p : mesh.positions) {
      places.push_back(transform(X.value(), {s.x * p.x, s.y * p.y, s.z * p.z}));
    }
    return mesh::bounds_of(places);
  }

  void expect_clean() const {
    Sources sources;
    const auto result = rules::validate(model.environment, {.paths = {"w/test.sdf"}}, sources);
    EXPECT_EQ(result.files.size(), 1U);
    EXPECT_TRUE(result.not_looked_at.empty());
    for (const Diagnostic& finding : result.diagnostics.list()) {
      if (finding.category == "mesh") continue;  // of the mesh, whatever the world around it
      ADD_FAILURE() << finding.rule << ": " << finding.message << '\n' << text;
    }
  }

  const model::Inertial& inertial() const { return model.loaded.root.links.at(1).inertial; }

  std::string bytes;
  mass::MeshSurvey survey;
  std::string text;
  ModelText model;
};

TEST(TestWorld, ABoxStandsOnTheGroundAndHasItsMass) {
  const TriangleMesh box = test::box_mesh({200, 300, 400}, {5000, 0, -7000});
  const World world(box, {0.001, 0.001, 0.001});
  world.expect_clean();
  const mesh::Bounds placed = world.placed(box);
  EXPECT_NEAR(placed.min.z, 0, 1e-12);
  EXPECT_NEAR(placed.min.x, -0.1, 1e-12);
  EXPECT_NEAR(placed.max.x, 0.1, 1e-12);
  EXPECT_NEAR(placed.max.y, 0.15, 1e-12);
  EXPECT_NEAR(world.inertial().mass.value, 24, 1e-6);
  EXPECT_NEAR(world.inertial().pose.pose.value.translation.z, -7, 1e-6);
  EXPECT_NEAR(world.inertial().ixx.value, 24 * (0.09 + 0.16) / 12, 1e-6);
}

TEST(TestWorld, AMirroringScaleKeepsItOnTheGround) {
  const TriangleMesh box = test::box_mesh({1, 1, 1}, {0, 0, 3});
  EXPECT_NEAR(World(box, {1, 1, -2}).placed(box).min.z, 0, 1e-12);
}

TEST(TestWorld, AnOpenMeshHasTheMassOfItsHull) {
  TriangleMesh box = test::box_mesh({1, 1, 1});
  box.triangles.pop_back();
  const World world(box, {1, 1, 1});
  world.expect_clean();
  EXPECT_NEAR(world.inertial().mass.value, 1000, 1e-6);
  EXPECT_EQ(world.text.find("<scale>"), std::string::npos);
}

TEST(TestWorld, AFlatMeshIsTakenForASheet) {
  TriangleMesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const World world(square, {1, 1, 1});
  world.expect_clean();
  EXPECT_NEAR(world.inertial().mass.value, 1, 1e-9);  // a square meter of a millimeter of water
}

}  // namespace
}  // namespace rigor::author
