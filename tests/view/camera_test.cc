// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/view/camera.h>

namespace rigor::view {
namespace {

constexpr double kProjectionError = 1e-12;

std::vector<model::Vector3> box_corners(const mesh::Bounds& b) {
  std::vector<model::Vector3> corners;
  for (const double x : {b.min.x, b.max.x}) {
    for (const double y : {b.min.y, b.max.y}) {
      for (const double z : {b.min.z, b.max.z}) corners.push_back({x, y, z});
    }
  }
  return corners;
}

std::vector<View> all_views() {
  std::vector<View> views;
  for (const std::string_view name : view_names()) views.push_back(*view_named(name));
  return views;
}

TEST(Camera, NamesGoBothWays) {
  for (const std::string_view name : view_names()) EXPECT_EQ(to_string(*view_named(name)), name);
  EXPECT_FALSE(view_named("left"));
}

TEST(Camera, ParallelRaysKeepProportions) {
  // 2 m wide (y) and 1 m high: the width fills a square picture.
  const mesh::Bounds bounds{{0, -1, 0}, {3, 1, 1}};
  const Camera front = framing(bounds, View::kFront, 1);
  const auto left = project(front, 1, {3, -1, 0});
  const auto right = project(front, 1, {0, 1, 1});
  ASSERT_TRUE(left && right);
  EXPECT_NEAR(left->x, -right->x, kProjectionError);
  EXPECT_NEAR(right->x, 2 * right->y, kProjectionError);
  EXPECT_GT(right->x, 0.9);  // y is to the right, z up
  EXPECT_NEAR(right->depth - left->depth, 3, kProjectionError);
}

TEST(Camera, AxesPointWhereTheViewsSay) {
  const mesh::Bounds bounds{{-1, -1, -1}, {1, 1, 1}};
  const auto at = [&](View view, const model::Vector3& p) {
    return *project(framing(bounds, view, 1), 1, p);
  };
  EXPECT_GT(at(View::kFront, {0, 0.5, 0}).x, 0.1);
  EXPECT_LT(at(View::kBack, {0, 0.5, 0}).x, -0.1);
  EXPECT_LT(at(View::kSide, {0.5, 0, 0}).x, -0.1);
  EXPECT_GT(at(View::kTop, {0.5, 0, 0}).y, 0.1);
  EXPECT_LT(at(View::kTop, {0, 0.5, 0}).x, -0.1);
  for (const View view : {View::kFront, View::kSide, View::kBack, View::kPerspective}) {
    EXPECT_GT(at(view, {0, 0, 0.5}).y, 0.1) << to_string(view);
  }
  // From the front: what is ahead is nearer.
  EXPECT_LT(at(View::kPerspective, {0.5, 0, 0}).depth, at(View::kPerspective, {-0.5, 0, 0}).depth);
}

TEST(Camera, APinholeDividesByDepth) {
  Camera camera;
  camera.eye = {10, 0, 0};
  camera.forward = {-1, 0, 0};
  camera.right = {0, 1, 0};
  camera.up = {0, 0, 1};
  camera.field_of_view = 2 * std::atan(0.5);  // the picture is as high as it is far
  const auto point = project(camera, 2, {6, 1, -0.5});
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->depth, 4, kProjectionError);
  EXPECT_NEAR(point->x, 1 / (4 * 0.5 * 2), kProjectionError);
  EXPECT_NEAR(point->y, -0.5 / (4 * 0.5), kProjectionError);
  EXPECT_FALSE(project(camera, 2, {10, 1, 0}));
  EXPECT_FALSE(project(camera, 2, {11, 0, 0}));
}

TEST(Camera, EveryCornerIsInThePictureAndOneTouchesTheMargin) {
  const std::vector<mesh::Bounds> all{{{-1, -1, -1}, {1, 1, 1}},
                                      {{0, 0, 0}, {10, 0.1, 0.1}},
                                      {{-0.1, -5, 0}, {0.1, 5, 0.2}},
                                      {{1000, 2000, 5}, {1000.2, 2000.1, 7}},
                                      {{-1e-4, -1e-4, 0}, {1e-4, 1e-4, 3e-4}}};
  for (const mesh::Bounds& bounds : all) {
    for (const View view : all_views()) {
      for (const double aspect : {0.5, 1.0, 1.5, 3.0}) {
        const Camera camera = framing(bounds, view, aspect);
        double farthest = 0;
        for (const model::Vector3& corner : box_corners(bounds)) {
          const auto p = project(camera, aspect, corner);
          ASSERT_TRUE(p);
          farthest = std::max({farthest, std::abs(p->x), std::abs(p->y)});
        }
        EXPECT_NEAR(farthest, 0.92, 1e-6) << to_string(view) << ' ' << aspect;
      }
    }
  }
}

TEST(Camera, DirectionsAreARightHandedFrame) {
  for (const View view : all_views()) {
    const Camera c = framing({{0, 0, 0}, {1, 2, 3}}, view, 1.5);
    EXPECT_NEAR(model::length(cross(c.right, c.up) + c.forward), 0, kProjectionError);
    EXPECT_NEAR(model::length(c.right), 1, kProjectionError);
    EXPECT_NEAR(model::length(c.forward), 1, kProjectionError);
  }
}

TEST(Camera, WhatCannotBeFramedHasACameraAllTheSame) {
  const double nan = std::nan("");
  const double inf = HUGE_VAL;
  const std::vector<mesh::Bounds> all{{{inf, inf, inf}, {-inf, -inf, -inf}},
                                      {{nan, 0, 0}, {1, 1, 1}},
                                      {{-inf, 0, 0}, {inf, 1, 1}},
                                      {{2, 3, 4}, {2, 3, 4}},
                                      {{0, 0, 0}, {0, 0, 1}}};
  for (const mesh::Bounds& bounds : all) {
    for (const View view : all_views()) {
      const Camera c = framing(bounds, view, 1.5);
      EXPECT_TRUE(std::isfinite(c.eye.x) && std::isfinite(c.eye.y) && std::isfinite(c.eye.z));
      EXPECT_TRUE(std::isfinite(c.height) && c.height > 0);
    }
  }
}

}  // namespace
}  // namespace rigor::view
