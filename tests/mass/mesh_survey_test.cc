// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mesh/survey.h>

#include <cmath>

#include <gtest/gtest.h>

#include <rigor/mass/mesh/facet_stream.h>

#include "support/meshes.h"

namespace rigor::mass {
namespace {

using test::binary_stl;
using test::box_mesh;
using test::joined;
using test::torus_mesh;
using test::turned;

MeshSurvey survey(const mesh::TriangleMesh& mesh) {
  MemoryDisk disk;
  disk.put("m.stl", binary_stl(mesh));
  return survey_mesh(disk, {"m.stl"});
}

TEST(MeshSurvey, AClosedMeshIsASolid) {
  const MeshSurvey found = survey(box_mesh({2, 1, 0.5}, {4, 0, 0}));
  EXPECT_TRUE(found.closed);
  EXPECT_EQ(found.triangles, 12U);
  EXPECT_EQ(found.bounds.max.x, 5);
  const MeshBody body = body_of(found, {1, 1, 1});
  EXPECT_EQ(body.state, MeshState::kSolid);
  EXPECT_NEAR(body.solid->volume, 1, 1e-15);
  EXPECT_NEAR(body.solid->com.x, 4, 1e-15);
  EXPECT_NEAR(body.solid->unit_inertia.izz, (4 + 1) / 12.0, 1e-14);
}

TEST(MeshSurvey, ScaleMultipliesLengths) {
  const MeshBody body = body_of(survey(box_mesh({1, 1, 1})), {2, 3, -4});
  EXPECT_EQ(body.state, MeshState::kSolid) << "a mirrored mesh is not inside out";
  EXPECT_NEAR(body.solid->volume, 24, 1e-13);
  EXPECT_NEAR(body.solid->unit_inertia.ixx, (9 + 16) / 12.0, 1e-14);
}

TEST(MeshSurvey, WhatIsNoSolidHasItsHull) {
  mesh::TriangleMesh open = box_mesh({1, 1, 1});
  open.triangles.pop_back();
  const MeshSurvey found = survey(open);
  ASSERT_TRUE(found.topology);
  EXPECT_EQ(found.topology->boundary_edges, 3U);
  const MeshBody body = body_of(found, {1, 1, 1});
  EXPECT_EQ(body.state, MeshState::kOpen);
  EXPECT_EQ(body.from, BodyFrom::kHull);
  EXPECT_NEAR(body.solid->volume, 1, 1e-14);
}

/// MuJoCo weighs such a file so; to others it holds nothing.
TEST(MeshSurvey, VerticesWithoutFacesHaveTheirHullAlone) {
  MemoryDisk disk;
  disk.put("m.obj",
           "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 2 1 0\nv 0 0 3\nv 2 0 3\nv 0 1 3\nv 2 1 3\nv 1 .5 1\n");
  const MeshSurvey found = survey_mesh(disk, {"m.obj"});
  EXPECT_FALSE(found.usable());
  ASSERT_TRUE(found.hull);
  EXPECT_NEAR(std::abs(found.hull->volume), 6, 1e-14);
  EXPECT_FALSE(body_of(found, {1, 1, 1}).solid);
}

TEST(MeshSurvey, States) {
  const auto state = [](const mesh::TriangleMesh& mesh) {
    return body_of(survey(mesh), {1, 1, 1}).state;
  };
  const mesh::TriangleMesh box = box_mesh({1, 1, 1});
  EXPECT_EQ(state(turned(box)), MeshState::kInverted);
  EXPECT_EQ(state(joined(box, box)), MeshState::kOverlapping);
  EXPECT_EQ(state(joined(box, turned(box_mesh({0.5, 0.5, 0.5}, {3, 0.1, 0.1})))),
            MeshState::kMixed);
  EXPECT_EQ(state(joined(box_mesh({4, 4, 4}), turned(box))), MeshState::kSolid) << "a cavity";
  EXPECT_EQ(state(box_mesh({1, 1, 0})), MeshState::kFlat);
  MemoryDisk disk;
  disk.put("m.stl", "no mesh");
  EXPECT_EQ(body_of(survey_mesh(disk, {"m.stl"}), {1, 1, 1}).state, MeshState::kUnusable);
  EXPECT_EQ(body_of(survey_mesh(disk, {"none.stl"}), {1, 1, 1}).state, MeshState::kUnusable);
}

TEST(MeshSurvey, ACoordinateThatIsNoNumberIsAFault) {
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    mesh::TriangleMesh box = box_mesh({1, 1, 1});
    box.positions[3].y = bad;
    const MeshSurvey found = survey(box);
    ASSERT_EQ(found.faults.size(), 1U);
    EXPECT_EQ(found.faults.front().kind, mesh::FaultKind::kNotFinite);
    EXPECT_EQ(body_of(found, {1, 1, 1}).state, MeshState::kUnusable);
  }
}

TEST(MeshSurvey, AnInsideOutMeshIsTakenTheOtherWayRound) {
  const MeshBody body = body_of(survey(turned(box_mesh({2, 1, 1}))), {1, 1, 1});
  EXPECT_EQ(body.from, BodyFrom::kTurnedMesh);
  EXPECT_NEAR(body.solid->volume, 2, 1e-14);
  EXPECT_NEAR(body.solid->unit_inertia.ixx, 2 / 12.0, 1e-14);
}

TEST(MeshSurvey, TheSameToTheBitForAnyNumberOfThreads) {
  // Some 30,000 triangles: eight blocks, the last of them not full.
  MemoryDisk disk;
  disk.put("m.stl", binary_stl(torus_mesh(0.2, 0.06, 150, 101)));
  const MeshSurvey one = survey_mesh(disk, {"m.stl"}, 1);
  for (const unsigned threads : {2U, 3U, 8U, 0U}) {
    const MeshSurvey many = survey_mesh(disk, {"m.stl"}, threads);
    EXPECT_EQ(many.moments.volume, one.moments.volume);
    EXPECT_EQ(many.moments.first, one.moments.first);
    EXPECT_EQ(many.moments.second, one.moments.second);
    EXPECT_EQ(many.moments.area, one.moments.area);
    EXPECT_EQ(many.winding.lines, one.winding.lines);
    EXPECT_TRUE(many.closed);
  }
}

TEST(MeshSurvey, StreamedIsAsRead) {
  const mesh::TriangleMesh torus = torus_mesh(0.2, 0.06, 150, 101);
  MemoryDisk disk;
  disk.put("m.stl", binary_stl(torus));
  const MeshSurvey streamed = survey_mesh(disk, {"m.stl"});
  const MeshSurvey read = survey_mesh(disk, {"m.stl", "", true});  // centered: read whole
  EXPECT_NEAR(streamed.moments.volume, read.moments.volume, 1e-12 * read.moments.volume);
  EXPECT_EQ(streamed.triangles, read.triangles);
  EXPECT_TRUE(read.closed);
}

TEST(MeshSurvey, EachFileIsSurveyedOnce) {
  MemoryDisk disk;
  disk.put("m.stl", binary_stl(box_mesh({1, 1, 1})));
  MeshSurveys surveys(disk);
  EXPECT_EQ(&surveys.find({"m.stl"}), &surveys.find({"m.stl"}));
  EXPECT_NE(&surveys.find({"m.stl"}), &surveys.find({"m.stl", "", true}));
}

}  // namespace
}  // namespace rigor::mass
