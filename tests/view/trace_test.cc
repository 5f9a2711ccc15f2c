// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Traced pictures against what projection and arithmetic say.

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/view/trace.h>

namespace rigor::view {
namespace {

constexpr Color kTracedRed{1, 0, 0, 1};
constexpr Color kTracedBlue{0, 0, 1, 1};
constexpr std::uint32_t kTracedWidth = 150;
constexpr std::uint32_t kTracedHeight = 100;
constexpr double kTracedAspect = 1.5;

class Trace : public ::testing::Test {
 protected:
  void SetUp() override {
    if (tracer().empty()) GTEST_SKIP() << "Embree is not installed: nothing is traced";
  }
};

Body body_of(const mesh::Primitive& shape, const model::Vector3& at, Color color) {
  Body body;
  body.mesh = std::make_shared<const mesh::TriangleMesh>(mesh_of(shape));
  body.pose.translation = at;
  body.surfaces = {{color}};
  return body;
}

Body cube(const model::Vector3& at, double side, Color color) {
  return body_of(mesh::Box{{side, side, side}}, at, color);
}

mesh::Bounds bounds_around(const model::Vector3& at, double half) {
  const model::Vector3 reach{half, half, half};
  return {at - reach, at + reach};
}

Picture traced(const Drawing& drawing, const Camera& camera, unsigned threads = 1) {
  Traced result =
      trace(drawing, camera, {.width = kTracedWidth, .height = kTracedHeight, .threads = threads});
  EXPECT_TRUE(result.picture) << result.problem;
  return result.picture ? *result.picture : Picture{};
}

Picture traced(const Drawing& drawing, View view) {
  return traced(drawing, framing(drawing.bounds, view, kTracedAspect));
}

bool is_background(const Pixel& pixel) { return pixel == Pixel{255, 255, 255, 255}; }
bool is_reddish(const Pixel& pixel) { return pixel[0] > pixel[2] + 60; }
bool is_bluish(const Pixel& pixel) { return pixel[2] > pixel[0] + 60; }

const Pixel& middle_pixel(const Picture& picture) {
  return picture.at(picture.width / 2, picture.height / 2);
}

struct PixelBox {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
};

/// Edges of what is no background, in pixels.
PixelBox silhouette(const Picture& picture) {
  PixelBox box;
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      if (is_background(picture.at(x, y))) continue;
      box = {std::min<double>(box.left, x), std::max<double>(box.right, x + 1),
             std::min<double>(box.top, y), std::max<double>(box.bottom, y + 1)};
    }
  }
  return box;
}

PixelBox projected_corners(const Camera& camera, const mesh::Bounds& bounds) {
  PixelBox box;
  for (const double x : {bounds.min.x, bounds.max.x}) {
    for (const double y : {bounds.min.y, bounds.max.y}) {
      for (const double z : {bounds.min.z, bounds.max.z}) {
        const auto p = project(camera, kTracedAspect, {x, y, z});
        EXPECT_TRUE(p);
        const double column = (p->x + 1) / 2 * kTracedWidth;
        const double row = (1 - p->y) / 2 * kTracedHeight;
        box = {std::min(box.left, column), std::max(box.right, column), std::min(box.top, row),
               std::max(box.bottom, row)};
      }
    }
  }
  return box;
}

void expect_same_box(const PixelBox& a, const PixelBox& b, const std::string& what) {
  EXPECT_NEAR(a.left, b.left, 1) << what;
  EXPECT_NEAR(a.right, b.right, 1) << what;
  EXPECT_NEAR(a.top, b.top, 1) << what;
  EXPECT_NEAR(a.bottom, b.bottom, 1) << what;
}

TEST_F(Trace, ABoxIsSeenWhereItsCornersAreProjected) {
  // Also a kilometer from the origin, and a tenth of a millimeter large.
  const std::pair<model::Vector3, double> cases[] = {
      {{0, 0, 0}, 1}, {{1000, -1000, 1000}, 0.2}, {{0, 0, 0}, 1e-4}, {{-3, 2, 1}, 500}};
  for (const auto& [at, side] : cases) {
    Drawing drawing;
    drawing.bodies = {cube(at, side, kTracedRed)};
    drawing.bounds = bounds_around(at, side / 2);
    for (const std::string_view name : view_names()) {
      const Camera camera = framing(drawing.bounds, *view_named(name), kTracedAspect);
      expect_same_box(silhouette(traced(drawing, camera)),
                      projected_corners(camera, drawing.bounds),
                      std::string(name) + " side " + std::to_string(side));
    }
  }
}

TEST_F(Trace, PoseAndScalePlaceAMesh) {
  Drawing drawing;
  Body body = cube({2, 3, 4}, 1, kTracedBlue);
  body.scale = {0.2, -3, 0.5};
  body.pose.rotation = model::from_rpy(0, 0, std::acos(0.0));  // its y along -x
  drawing.bodies = {body};
  drawing.bounds = {{0.5, 2.9, 3.75}, {3.5, 3.1, 4.25}};
  const Camera camera = framing(drawing.bounds, View::kSide, kTracedAspect);
  expect_same_box(silhouette(traced(drawing, camera)), projected_corners(camera, drawing.bounds),
                  "side");
}

TEST_F(Trace, WhatIsNearerHidesWhatIsFarther) {
  for (const bool turned : {false, true}) {
    Drawing drawing;
    drawing.bodies = {cube({0, 0, 0}, 1, kTracedRed), cube({2, 0, 0}, 1, kTracedBlue)};
    if (turned) std::swap(drawing.bodies[0], drawing.bodies[1]);
    drawing.bounds = {{-0.5, -0.5, -0.5}, {2.5, 0.5, 0.5}};
    EXPECT_TRUE(is_bluish(middle_pixel(traced(drawing, View::kFront))));
    EXPECT_TRUE(is_reddish(middle_pixel(traced(drawing, View::kBack))));
  }
}

TEST_F(Trace, GlassLetsThroughWhatLiesBehind) {
  Drawing drawing;
  drawing.bounds = {{-0.5, -0.5, -0.5}, {2.5, 0.5, 0.5}};
  const auto blue_with = [&](float opacity) {
    Color glass = kTracedRed;
    glass.a = opacity;
    drawing.bodies = {cube({0, 0, 0}, 1, kTracedBlue), cube({2, 0, 0}, 1, glass)};
    return int{middle_pixel(traced(drawing, View::kFront))[2]};
  };
  const int clear = blue_with(0);
  const int thin = blue_with(0.3F);
  const int thick = blue_with(0.7F);
  const int wall = blue_with(1);
  EXPECT_GT(clear, thin + 10);
  EXPECT_GT(thin, thick + 10);
  EXPECT_GT(thick, wall + 10);
}

TEST_F(Trace, ACollisionOnItsVisualIsSeenAsOneSheet) {
  Drawing drawing;
  Body collision = cube({0, 0, 0}, 1, {1, 0.5F, 0, 0.5F});
  collision.layer = Layer::kCollision;
  drawing.bodies = {cube({0, 0, 0}, 1, kTracedBlue), collision};
  drawing.bounds = bounds_around({0, 0, 0}, 0.5);
  const Picture picture = traced(drawing, View::kFront);
  const PixelBox box = silhouette(picture);
  const Pixel& middle = middle_pixel(picture);
  EXPECT_GT(middle[0], 80);  // orange over blue
  EXPECT_GT(middle[2], 80);
  for (auto y = static_cast<std::uint32_t>(box.top) + 2; y < box.bottom - 2; ++y) {
    for (auto x = static_cast<std::uint32_t>(box.left) + 2; x < box.right - 2; ++x) {
      for (std::size_t i = 0; i < 3; ++i) ASSERT_NEAR(picture.at(x, y)[i], middle[i], 12);
    }
  }
}

TEST_F(Trace, MarksShineThroughWhatTheyAreIn) {
  Drawing drawing;
  Body mark = body_of(mesh::Sphere{0.3}, {0, 0, 0}, kTracedRed);
  drawing.bodies = {cube({0, 0, 0}, 1, kTracedBlue), mark};
  drawing.bounds = bounds_around({0, 0, 0}, 0.5);
  const int hidden = middle_pixel(traced(drawing, View::kFront))[0];
  drawing.bodies[1].layer = Layer::kCom;
  EXPECT_GT(int{middle_pixel(traced(drawing, View::kFront))[0]}, hidden + 60);
}

TEST_F(Trace, LightComesFromAbove) {
  Drawing drawing;
  drawing.bodies = {cube({0, 0, 0}, 1, {0.5F, 0.5F, 0.5F, 1})};
  drawing.bounds = bounds_around({0, 0, 0}, 0.5);
  EXPECT_GT(middle_pixel(traced(drawing, View::kTop))[0],
            middle_pixel(traced(drawing, View::kFront))[0] + 15);
  // What is under a roof is in its shadow.
  Drawing roofed = drawing;
  roofed.bodies.push_back(body_of(mesh::Box{{5, 5, 0.1}}, {0, 0, 3}, kTracedRed));
  EXPECT_GT(
      middle_pixel(traced(drawing, View::kFront))[0],
      middle_pixel(traced(roofed, framing(drawing.bounds, View::kFront, kTracedAspect)))[0] + 15);
}

TEST_F(Trace, WindingMakesNoDifference) {
  Drawing drawing;
  drawing.bodies = {cube({0, 0, 0}, 1, kTracedRed)};
  drawing.bounds = bounds_around({0, 0, 0}, 0.5);
  const Picture outward = traced(drawing, View::kPerspective);
  mesh::TriangleMesh inverted = *drawing.bodies[0].mesh;
  for (mesh::Triangle& t : inverted.triangles) std::swap(t[1], t[2]);
  drawing.bodies[0].mesh = std::make_shared<const mesh::TriangleMesh>(inverted);
  EXPECT_EQ(traced(drawing, View::kPerspective).pixels, outward.pixels);
}

TEST_F(Trace, OfAWallsTwoSidesTheOneThatFacesTheEyeIsSeen) {
  mesh::TriangleMesh wall;
  wall.positions = {{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}};
  wall.triangles = {{0, 1, 2}, {0, 2, 3}, {3, 2, 1}, {1, 0, 3}};  // split along different diagonals
  wall.parts = {{"to +x", "", 0, 2}, {"to -x", "", 2, 2}};
  Body body;
  body.mesh = std::make_shared<const mesh::TriangleMesh>(wall);
  Drawing drawing;
  drawing.bounds = bounds_around({5, 0, 0}, 1);
  for (const double mirror : {1.0, -1.0}) {
    for (const float opacity : {1.0F, 0.9F}) {
      body.scale = {1, mirror, 1};
      body.pose = {{5, 0, 0}, {std::sqrt(0.5), std::sqrt(0.5), 0, 0}};  // a quarter turn about x
      body.surfaces = {{{1, 0, 0, opacity}}, {{0, 0, 1, opacity}}};
      drawing.bodies = {body};
      const Picture front = traced(drawing, View::kFront);
      const Picture back = traced(drawing, View::kBack);
      for (std::uint32_t x = 30; x < kTracedWidth - 30; ++x) {
        EXPECT_TRUE(is_reddish(front.at(x, kTracedHeight / 3))) << x;
        EXPECT_TRUE(is_bluish(back.at(x, kTracedHeight / 3))) << x;
      }
    }
  }
}

/// A square of two triangles, facing x, with texture coordinates from 0 to
/// `times`.
Body textured_square(float times, const Picture& picture) {
  mesh::TriangleMesh square;
  square.positions = {{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  square.parts = {{"", "", 0, 2}};
  square.corners.texture = {{{{0, 0}, {times, 0}, {times, times}}},
                            {{{0, 0}, {times, times}, {0, times}}}};
  Body body;
  body.mesh = std::make_shared<const mesh::TriangleMesh>(square);
  body.surfaces = {{{1, 1, 1, 1}, std::make_shared<const Picture>(picture)}};
  return body;
}

TEST_F(Trace, TexturesStandUprightAndRepeat) {
  // Red above, blue below; at the left green.
  Picture picture{8, 8, std::vector<Pixel>(64, Pixel{255, 0, 0, 255})};
  for (std::uint32_t y = 0; y < 8; ++y) {
    for (std::uint32_t x = 0; x < 8; ++x) {
      if (y >= 4) picture.at(x, y) = {0, 0, 255, 255};
      if (x < 2) picture.at(x, y) = {0, 255, 0, 255};
    }
  }
  Drawing drawing;
  drawing.bounds = {{0, -1, -1}, {0, 1, 1}};
  const Camera camera = framing(drawing.bounds, View::kFront, kTracedAspect);
  const auto pixel = [&](const Picture& of, double y, double z) {
    const auto p = project(camera, kTracedAspect, {0, y, z});
    return of.at(static_cast<std::uint32_t>((p->x + 1) / 2 * kTracedWidth),
                 static_cast<std::uint32_t>((1 - p->y) / 2 * kTracedHeight));
  };
  drawing.bodies = {textured_square(1, picture)};
  const Picture once = traced(drawing, camera);
  EXPECT_TRUE(is_reddish(pixel(once, 0.5, 0.5)));
  EXPECT_TRUE(is_bluish(pixel(once, 0.5, -0.5)));
  EXPECT_GT(pixel(once, -0.75, 0)[1], pixel(once, -0.75, 0)[0] + 60);
  drawing.bodies = {textured_square(2, picture)};
  const Picture twice = traced(drawing, camera);
  EXPECT_TRUE(is_reddish(pixel(twice, 0.75, 0.75)));
  EXPECT_TRUE(is_bluish(pixel(twice, 0.75, 0.25)));
  EXPECT_TRUE(is_reddish(pixel(twice, 0.75, -0.25)));
  EXPECT_TRUE(is_bluish(pixel(twice, 0.75, -0.75)));
}

TEST_F(Trace, HolesInATextureAreHoles) {
  Drawing drawing;
  drawing.bounds = {{0, -1, -1}, {0, 1, 1}};
  drawing.bodies = {textured_square(1, {1, 1, {Pixel{255, 0, 0, 0}}})};
  EXPECT_TRUE(is_background(middle_pixel(traced(drawing, View::kFront))));
  drawing.bodies[0].surfaces[0].texture_opacity = false;
  EXPECT_TRUE(is_reddish(middle_pixel(traced(drawing, View::kFront))));
}

TEST_F(Trace, PartsHaveSurfacesOfTheirOwn) {
  mesh::TriangleMesh squares;
  squares.positions = {{0, -1, -1}, {0, 0, -1}, {0, 0, 1}, {0, -1, 1}, {0, 1, -1}, {0, 1, 1}};
  squares.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  squares.parts = {{"left", "", 0, 2}, {"right", "", 2, 2}};
  Drawing drawing;
  drawing.bounds = {{0, -1, -1}, {0, 1, 1}};
  drawing.bodies.resize(1);
  drawing.bodies[0].mesh = std::make_shared<const mesh::TriangleMesh>(squares);
  drawing.bodies[0].surfaces = {{kTracedRed}, {kTracedBlue}};
  const Picture picture = traced(drawing, View::kFront);
  EXPECT_TRUE(is_reddish(picture.at(kTracedWidth / 2 - 10, kTracedHeight / 2)));
  EXPECT_TRUE(is_bluish(picture.at(kTracedWidth / 2 + 10, kTracedHeight / 2)));
}

Drawing still_life() {
  Drawing drawing;
  drawing.bodies = {cube({0, 0, 0.5}, 1, kTracedRed),
                    body_of(mesh::Sphere{0.4}, {1, 0.5, 0.4}, {0, 1, 0, 0.5F}),
                    body_of(mesh::Cylinder{0.2, 2}, {0, -1, 1}, kTracedBlue),
                    body_of(mesh::Box{{20, 20, 0.01}}, {0, 0, 0}, {0.8F, 0.8F, 0.8F, 1})};
  drawing.bodies[3].layer = Layer::kGround;
  drawing.bounds = {{-0.5, -1.2, 0}, {1.4, 0.9, 2}};
  return drawing;
}

TEST_F(Trace, ThreadsMakeNoDifference) {
  const Drawing drawing = still_life();
  const Camera camera = framing(drawing.bounds, View::kPerspective, kTracedAspect);
  const std::string once = to_png(traced(drawing, camera, 1));
  EXPECT_EQ(once, to_png(traced(drawing, camera, 1)));
  EXPECT_EQ(once, to_png(traced(drawing, camera, 2)));
  EXPECT_EQ(once, to_png(traced(drawing, camera, 3)));
}

TEST_F(Trace, EdgesAreSmooth) {
  Drawing drawing;
  drawing.bodies = {body_of(mesh::Sphere{1}, {}, kTracedRed)};
  drawing.bounds = bounds_around({}, 1);
  const Camera camera = framing(drawing.bounds, View::kFront, kTracedAspect);
  const auto between = [](const Picture& picture) {
    return std::count_if(picture.pixels.begin(), picture.pixels.end(), [](const Pixel& p) {
      return p[1] > 130 && p[1] < 250;  // neither the red ball nor the white behind it
    });
  };
  const Traced rough =
      trace(drawing, camera,
            {.width = kTracedWidth, .height = kTracedHeight, .samples = 1, .threads = 1});
  ASSERT_TRUE(rough.picture);
  EXPECT_EQ(between(*rough.picture), 0);
  EXPECT_GT(between(traced(drawing, camera)), 80);
}

TEST_F(Trace, LinesThinnerThanAPixelAreWhole) {
  Drawing drawing;
  drawing.bounds = bounds_around({}, 1);
  const Camera camera = framing(drawing.bounds, View::kFront, kTracedAspect);
  const double pixel = camera.height / kTracedHeight;
  // Between the middles of two rows of pixels, and of two columns.
  for (const bool upright : {false, true}) {
    const double at = pixel * 10;
    drawing.bodies = {upright
                          ? body_of(mesh::Box{{0.1, 0.4 * pixel, 1.6}}, {0, at, 0}, kTracedRed)
                          : body_of(mesh::Box{{0.1, 1.6, 0.4 * pixel}}, {0, 0, at}, kTracedRed)};
    const Picture picture = traced(drawing, camera);
    for (std::uint32_t i = 20; i < 80; ++i) {
      int inked = 0;
      for (std::uint32_t j = 20; j < 80; ++j) {
        inked += is_background(upright ? picture.at(j + 25, i) : picture.at(i + 25, j)) ? 0 : 1;
      }
      EXPECT_GE(inked, 1) << upright << ' ' << i;
    }
  }
}

/// Two bodies have a face in one place: which of them is seen is the same everywhere, or the image has speckles.
TEST_F(Trace, OfFacesInOnePlaceOneIsSeen) {
  for (const float opacity : {1.0F, 0.5F}) {
    Drawing drawing;
    drawing.bounds = bounds_around({}, 1);
    const auto add = [&](const model::Vector3& at, Color color) {
      color.a = opacity;
      drawing.bodies.push_back(body_of(mesh::Box{{1, 1.5, 1}}, at, color));
      // Other rotations round differently.
      drawing.bodies.back().pose.rotation = model::from_rpy(0, 0, 1e-9);
    };
    add({0, 0, 0}, kTracedRed);
    add({0.2, 0.1, 0}, kTracedBlue);
    // From above, a square in the middle of both.
    const Picture picture = traced(drawing, View::kTop);
    std::set<Pixel> colors;
    for (std::uint32_t y = 40; y < 60; ++y) {
      for (std::uint32_t x = 65; x < 85; ++x) colors.insert(picture.at(x, y));
    }
    EXPECT_EQ(colors.size(), 1U) << opacity;
  }
}

TEST_F(Trace, NothingIsBackground) {
  const Picture picture = traced(Drawing{}, View::kPerspective);
  EXPECT_TRUE(std::all_of(picture.pixels.begin(), picture.pixels.end(), is_background));
}

TEST_F(Trace, BodiesThatCannotBePlacedAreLeftOut) {
  const double nan = std::nan("");
  const double inf = HUGE_VAL;
  Drawing drawing;
  drawing.bounds = bounds_around({}, 1);
  const auto add = [&](const auto& change) {
    Body body = cube({0, 0, 0}, 1, kTracedBlue);
    change(body);
    drawing.bodies.push_back(body);
  };
  add([&](Body& b) { b.pose.translation.x = nan; });
  add([&](Body& b) { b.pose.translation.y = inf; });
  add([&](Body& b) { b.pose.rotation.w = nan; });
  add([](Body& b) { b.scale = {0, 0, 0}; });
  add([&](Body& b) { b.scale = {1, nan, 1}; });
  add([](Body& b) { b.scale = {1e300, 1e300, 1e300}; });
  add([](Body& b) { b.mesh = nullptr; });
  add([](Body& b) { b.mesh = std::make_shared<const mesh::TriangleMesh>(); });
  add([&](Body& b) {
    mesh::TriangleMesh broken = *b.mesh;
    for (mesh::Triangle& t : broken.triangles) t = {7, 4000000000U, 1};
    b.mesh = std::make_shared<const mesh::TriangleMesh>(broken);
  });
  add([&](Body& b) {
    mesh::TriangleMesh broken = *b.mesh;
    for (mesh::Vector3& p : broken.positions) p.z = nan;
    b.mesh = std::make_shared<const mesh::TriangleMesh>(broken);
  });
  EXPECT_TRUE(is_background(middle_pixel(traced(drawing, View::kFront))));
  // They take nothing from the others.
  add([](Body& b) { b.surfaces.clear(); });
  EXPECT_FALSE(is_background(middle_pixel(traced(drawing, View::kFront))));
}

TEST_F(Trace, NoPictureOfNoSize) {
  EXPECT_FALSE(trace({}, {}, {.width = 0}).picture);
  EXPECT_FALSE(trace({}, {}, {.width = 1U << 31U, .height = 1U << 31U}).picture);
}

}  // namespace
}  // namespace rigor::view
