// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Primitives fitted to meshes that are such primitives, somewhere and turned somehow, and to others.

#include <rigor/mesh/primitive/fit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mesh/topology/topology.h>

#include "mesh/bodies.h"

namespace rigor::mesh {
namespace {

using model::Pose;
using std::numbers::pi;

constexpr std::array kKinds = {FitKind::kBox, FitKind::kSphere, FitKind::kCylinder,
                               FitKind::kCapsule, FitKind::kBest};

Pose random_pose(std::mt19937& random) {
  std::normal_distribution<double> n(0, 1);
  const model::Quaternion q =
      normalized(model::Quaternion{n(random), n(random), n(random), n(random)});
  return {{3 * n(random), 3 * n(random), 3 * n(random)}, q};
}

TriangleMesh placed(TriangleMesh mesh, const Pose& pose) {
  for (Vector3& p : mesh.positions) p = transform(pose, p);
  return mesh;
}

/// How far outside the primitive a point lies, by its plain definition.
double outside(const Fit& fit, const Vector3& point) {
  const Vector3 p = transform(inverse(fit.pose), point);
  const double rho = std::hypot(p.x, p.y);
  if (const auto* box = std::get_if<Box>(&fit.shape)) {
    return std::max({std::abs(p.x) - box->size.x / 2, std::abs(p.y) - box->size.y / 2,
                     std::abs(p.z) - box->size.z / 2});
  }
  if (const auto* sphere = std::get_if<Sphere>(&fit.shape)) return length(p) - sphere->radius;
  if (const auto* cylinder = std::get_if<Cylinder>(&fit.shape)) {
    return std::max(rho - cylinder->radius, std::abs(p.z) - cylinder->length / 2);
  }
  const Capsule& capsule = std::get<Capsule>(fit.shape);
  return std::hypot(rho, std::max(0.0, std::abs(p.z) - capsule.length / 2)) - capsule.radius;
}

void expect_near(const Vector3& a, const Vector3& b, double tolerance) {
  EXPECT_LE(length(a - b), tolerance)
      << a.x << ' ' << a.y << ' ' << a.z << " and " << b.x << ' ' << b.y << ' ' << b.z;
}

/// An axis and its opposite are the same.
void expect_axis(const Fit& fit, const Vector3& axis) {
  EXPECT_LE(length(cross(rotate(fit.pose.rotation, {0, 0, 1}), axis)), 1e-6);
}

TEST(Fit, RecoversABoxWhereverItIs) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const Pose pose = random_pose(random);
    for (const FitKind kind : {FitKind::kBox, FitKind::kBest}) {
      const auto fit = fit_primitive(placed(box_mesh({1, 0.3, 2.5}), pose), kind);
      ASSERT_TRUE(fit);
      expect_near(fit->pose.translation, pose.translation, 1e-6);
      const Vector3 size = std::get<Box>(fit->shape).size;
      std::array<double, 3> sides = {size.x, size.y, size.z};
      const auto shortest = std::min_element(sides.begin(), sides.end()) - sides.begin();
      const std::array<Vector3, 3> axes = {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
      const Vector3 thin = rotate(fit->pose.rotation, axes[static_cast<std::size_t>(shortest)]);
      EXPECT_LE(length(cross(thin, rotate(pose.rotation, {0, 1, 0}))), 1e-6);
      std::sort(sides.begin(), sides.end());
      expect_near({sides[0], sides[1], sides[2]}, {0.3, 1, 2.5}, 1e-6);
      EXPECT_NEAR(fit->fill(), 1, 1e-9);
      EXPECT_NEAR(fit->mesh_volume.value(), 0.75, 1e-9);
      EXPECT_LE(fit->deepest, 1e-3);
    }
  }
}

TEST(Fit, RecoversATessellatedCylinder) {
  std::mt19937 random(2);
  for (int i = 0; i < 20; ++i) {
    const Pose pose = random_pose(random);
    for (const FitKind kind : {FitKind::kCylinder, FitKind::kBest}) {
      const auto fit =
          fit_primitive(placed(mesh_of(Cylinder{0.4, i % 2 == 0 ? 0.1 : 3}), pose), kind);
      ASSERT_TRUE(fit);
      const Cylinder& found = std::get<Cylinder>(fit->shape);
      EXPECT_NEAR(found.radius, 0.4, 1e-6);
      EXPECT_NEAR(found.length, i % 2 == 0 ? 0.1 : 3, 1e-6);
      expect_near(fit->pose.translation, pose.translation, 1e-6);
      expect_axis(*fit, rotate(pose.rotation, {0, 0, 1}));
      // The sagitta of a flat side.
      EXPECT_NEAR(fit->deepest, 0.4 * (1 - std::cos(pi / kCircleSegments)), 1e-4);
    }
  }
}

TEST(Fit, RecoversATessellatedSphere) {
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const Pose pose = random_pose(random);
    for (const FitKind kind : {FitKind::kSphere, FitKind::kBest}) {
      const auto fit = fit_primitive(placed(ball_mesh(0.7, 24, 12), pose), kind);
      ASSERT_TRUE(fit);
      EXPECT_NEAR(std::get<Sphere>(fit->shape).radius, 0.7, 1e-9);
      expect_near(fit->pose.translation, pose.translation, 1e-9);
      EXPECT_EQ(fit->pose.rotation, model::Quaternion{});
    }
  }
}

TEST(Fit, RecoversATessellatedCapsule) {
  std::mt19937 random(4);
  for (int i = 0; i < 6; ++i) {
    const Pose pose = random_pose(random);
    const double long_one = i % 2 == 0 ? 2 : 0.3;
    for (const FitKind kind : {FitKind::kCapsule, FitKind::kBest}) {
      const auto fit = fit_primitive(placed(mesh_of(Capsule{0.25, long_one}), pose), kind);
      ASSERT_TRUE(fit);
      const Capsule& found = std::get<Capsule>(fit->shape);
      EXPECT_NEAR(found.radius, 0.25, 1e-6);
      EXPECT_NEAR(found.length, long_one, 1e-6);
      expect_near(fit->pose.translation, pose.translation, 1e-6);
      expect_axis(*fit, rotate(pose.rotation, {0, 0, 1}));
    }
  }
}

TEST(Fit, HoldsEveryVertexAndSavesNothingByOtherMeans) {
  std::mt19937 random(5);
  std::normal_distribution<double> n(0, 1);
  for (int i = 0; i < 10; ++i) {
    TriangleMesh cloud;
    const Vector3 size{std::exp(n(random)), std::exp(n(random)), std::exp(n(random))};
    for (std::uint32_t v = 0; v < 300; ++v) {
      cloud.positions.push_back({size.x * n(random), size.y * n(random), size.z * n(random)});
      if (v >= 2) cloud.triangles.push_back({v - 2, v - 1, v});
    }
    cloud = placed(cloud, random_pose(random));
    double least = 1e300;
    double best = 0;
    for (const FitKind kind : kKinds) {
      const auto fit = fit_primitive(cloud, kind);
      ASSERT_TRUE(fit);
      const double scale = diagonal(bounds_of(cloud.positions));
      for (const Vector3& p : cloud.positions) EXPECT_LE(outside(*fit, p), 1e-9 * scale);
      EXPECT_LE(fit->fill(), 1 + 1e-12);
      EXPECT_GE(fit->deepest, 0);
      EXPECT_FALSE(fit->mesh_volume);
      EXPECT_DOUBLE_EQ(fit->volume, volume_of(fit->shape));
      if (kind == FitKind::kBest) {
        best = fit->volume;
      } else {
        least = std::min(least, fit->volume);
      }
    }
    EXPECT_LE(least, best);
    EXPECT_LE(best * (1 - 4 * kSimplerVolume), least);
  }
}

TEST(Fit, SmallestBallOfATetrahedronAndOfAnObtuseOne) {
  const TriangleMesh regular{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                             {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}},
                             {}};
  const auto all_four = fit_primitive(regular, FitKind::kSphere);
  EXPECT_NEAR(std::get<Sphere>(all_four->shape).radius, std::sqrt(3.0), 1e-12);
  // Two far corners carry the ball alone.
  TriangleMesh obtuse = regular;
  obtuse.positions = {{-5, 0, 0}, {5, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto two = fit_primitive(obtuse, FitKind::kSphere);
  EXPECT_NEAR(std::get<Sphere>(two->shape).radius, 5, 1e-12);
  expect_near(two->pose.translation, {0, 0, 0}, 1e-12);
}

TEST(Fit, PrefersTheCoordinateAxes) {
  const auto box = fit_primitive(box_mesh({1, 2, 3}, {4, 5, 6}), FitKind::kBest);
  EXPECT_EQ(std::get<Box>(box->shape).size, (Vector3{1, 2, 3}));
  EXPECT_EQ(box->pose, (Pose{{4, 5, 6}, {}}));
  // Half a milliradian off: it would cost 0.07 % of the volume.
  const Pose hardly{{}, model::from_axis_angle({1, 0, 0}, 0.0003)};
  const auto tilted = fit_primitive(placed(box_mesh({1, 2, 3}), hardly), FitKind::kBox);
  EXPECT_EQ(tilted->pose.rotation, model::Quaternion{});
  // A disk's axis is z whichever way its edges run.
  const auto disk = fit_primitive(mesh_of(Cylinder{1, 0.01}), FitKind::kBest);
  EXPECT_EQ(disk->pose.rotation, model::Quaternion{});
  EXPECT_NEAR(std::get<Cylinder>(disk->shape).length, 0.01, 1e-15);
}

TEST(Fit, TurnsABoxNoMoreThanNeeded) {
  for (const double degrees : {10.0, 30.0, 44.0, 50.0, 100.0, 170.0}) {
    const Pose pose{{}, model::from_axis_angle({0, 0, 1}, degrees * pi / 180)};
    const auto fit = fit_primitive(placed(box_mesh({1, 2, 3}), pose), FitKind::kBox);
    const double rest = std::abs(std::remainder(degrees, 90));
    EXPECT_NEAR(2 * std::acos(fit->pose.rotation.w), rest * pi / 180, 1e-9);
    EXPECT_EQ(fit->pose.rotation.x, 0);
    EXPECT_EQ(fit->pose.rotation.y, 0);
  }
}

TEST(Fit, DeepestIsOfTheSurfaceAndNotOfTheVertices) {
  // The ball around a cube: a face's middle is half a side from the center.
  const auto ball = fit_primitive(box_mesh({2, 2, 2}), FitKind::kSphere);
  EXPECT_NEAR(ball->deepest, std::sqrt(3.0) - 1, 1e-3);
  EXPECT_NEAR(ball->fill(), 8 / (4 * pi * std::sqrt(3.0)), 1e-12);
  // The box around the L: the corner of its notch is one from a side, the ridge's deepest place too.
  const auto box = fit_primitive(bracket_mesh(), FitKind::kBox);
  EXPECT_NEAR(box->deepest, 1, 1e-3);
  EXPECT_NEAR(box->hull_volume, 14, 1e-9);
  EXPECT_NEAR(box->mesh_volume.value(), 10, 1e-9);
  EXPECT_NEAR(box->volume, 18, 1e-9);
}

TEST(Fit, OfWhatIsFlatIsNothing) {
  TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}};
  for (const FitKind kind : kKinds) EXPECT_FALSE(fit_primitive(flat, kind));
  EXPECT_FALSE(fit_primitive({}, FitKind::kBest));
  // A position that no triangle uses does not count.
  flat.positions.push_back({0, 0, 1});
  EXPECT_FALSE(fit_primitive(flat, FitKind::kBest));
}

TEST(Fit, IsTheSameEveryTime) {
  const TriangleMesh torus = torus_mesh(2, 0.6, 40, 20);
  const auto once = fit_primitive(torus, FitKind::kBest);
  const auto again = fit_primitive(torus, FitKind::kBest);
  EXPECT_EQ(once->pose, again->pose);
  EXPECT_EQ(once->volume, again->volume);
  EXPECT_EQ(once->deepest, again->deepest);
}

TEST(PrimitiveMesh, IsClosedOutwardAndOfTheRightSize) {
  struct Case {
    Primitive shape;
    double share;  // of the primitive's volume that the mesh has
  };
  constexpr double kGon = kCircleSegments / (2 * pi);
  const double gon = kGon * std::sin(1 / kGon);  // area of the polygon in a cycle
  for (const auto& [shape, share] :
       {Case{Box{{1, 2, 3}}, 1}, Case{Cylinder{2, 0.5}, gon}, Case{Sphere{1.5}, gon * gon},
        Case{Capsule{0.5, 4}, gon}, Case{Capsule{1, 0}, gon * gon}}) {
    const TriangleMesh mesh = mesh_of(shape);
    const Topology topology = topology_of(mesh);
    EXPECT_TRUE(topology.closed());
    EXPECT_EQ(topology.euler(), 2);
    EXPECT_EQ(topology.components, 1U);
    EXPECT_EQ(topology.degenerate + topology.zero_area + topology.duplicates, 0U);
    EXPECT_NEAR(topology.component_list.at(0).volume / volume_of(shape), share, 1e-3);
    EXPECT_EQ(mesh.parts.at(0).count, mesh.triangles.size());
  }
}

}  // namespace
}  // namespace rigor::mesh
