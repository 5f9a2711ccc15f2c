// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Held against the intersection itself, worked out in fractions of integers: one triangle is clipped
// by the plane and by the edges of the other, and what is left is a polygon with known corners.

#include <rigor/mesh/spatial/self_intersection.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <rigor/mesh/read.h>
#include <rigor/mesh/spatial/bvh.h>
#include <rigor/mesh/spatial/predicate.h>
#include <rigor/text/disk.h>

#include "mesh/bodies.h"
#include "support/corpus.h"
#include "support/meshes.h"
#include "support/part.h"
#include "support/workers.h"

namespace rigor::mesh {
namespace {

__extension__ using Wide = __int128;

/// Fractions whose terms fit for coordinates of a few dozen: every corner of an intersection is where
/// three planes with small coefficients meet.
class Fraction {
 public:
  Fraction(Wide n = 0, Wide d = 1) : n_(n), d_(d) {  // NOLINT: integers are fractions
    Wide a = n < 0 ? -n : n;
    Wide b = d < 0 ? -d : d;
    while (b != 0) a = std::exchange(b, a % b);
    n_ /= d < 0 ? -a : a;
    d_ /= d < 0 ? -a : a;
  }

  friend Fraction operator+(Fraction a, Fraction b) {
    return {a.n_ * b.d_ + b.n_ * a.d_, a.d_ * b.d_};
  }
  friend Fraction operator-(Fraction a, Fraction b) {
    return {a.n_ * b.d_ - b.n_ * a.d_, a.d_ * b.d_};
  }
  friend Fraction operator*(Fraction a, Fraction b) { return {a.n_ * b.n_, a.d_ * b.d_}; }
  friend Fraction operator/(Fraction a, Fraction b) { return {a.n_ * b.d_, a.d_ * b.n_}; }
  bool operator==(const Fraction&) const = default;
  int sign() const { return (n_ > 0) - (n_ < 0); }

 private:
  Wide n_;
  Wide d_;
};

using ExactPoint = std::array<Fraction, 3>;
using Polygon = std::vector<ExactPoint>;

ExactPoint minus(const ExactPoint& a, const ExactPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Fraction product(const ExactPoint& a, const ExactPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

ExactPoint normal_to(const ExactPoint& a, const ExactPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// What of the polygon lies where normal · (x - origin) >= 0 (I. Sutherland, G. Hodgman, 1974).
Polygon clipped(const Polygon& polygon, const ExactPoint& normal, const ExactPoint& origin) {
  Polygon left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactPoint& a = polygon[i];
    const ExactPoint& b = polygon[(i + 1) % polygon.size()];
    const Fraction at_a = product(normal, minus(a, origin));
    const Fraction at_b = product(normal, minus(b, origin));
    if (at_a.sign() >= 0) left.push_back(a);
    if (at_a.sign() * at_b.sign() >= 0) continue;
    const Fraction t = at_a / (at_a - at_b);
    ExactPoint crossing = a;
    for (std::size_t k = 0; k < 3; ++k) crossing[k] = a[k] + t * (b[k] - a[k]);
    left.push_back(crossing);
  }
  return left;
}

Polygon exact(const Facet& f) {
  Polygon result;
  for (const Vector3& p : f) result.push_back({Wide(p.x), Wide(p.y), Wide(p.z)});
  return result;
}

/// Corners of what the triangles have in common.
Polygon intersection(const Polygon& f, const Polygon& g) {
  const ExactPoint normal = normal_to(minus(f[1], f[0]), minus(f[2], f[0]));
  Polygon rest = clipped(g, normal, f[0]);
  rest = clipped(rest, minus({}, normal), f[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    rest = clipped(rest, normal_to(normal, minus(f[(i + 1) % 3], f[i])), f[i]);
  }
  return rest;
}

bool on_line(const ExactPoint& a, const ExactPoint& b, const ExactPoint& p) {
  return normal_to(minus(b, a), minus(p, a)) == ExactPoint{};
}

/// Whether all corners of the intersection lie in what is shared.
bool explained(const Polygon& common, const std::vector<ExactPoint>& shared) {
  return std::all_of(common.begin(), common.end(), [&](const ExactPoint& p) {
    if (shared.empty()) return false;
    return shared.size() == 1 ? p == shared[0] : on_line(shared[0], shared[1], p);
  });
}

using Pairs = std::set<std::pair<std::uint64_t, std::uint64_t>>;

Pairs by_clipping(const TriangleMesh& mesh) {
  Pairs pairs;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t j = i + 1; j < mesh.triangles.size(); ++j) {
      const Polygon f = exact(facet(mesh, mesh.triangles[i]));
      const Polygon g = exact(facet(mesh, mesh.triangles[j]));
      if (on_line(f[0], f[1], f[2]) || on_line(g[0], g[1], g[2])) continue;
      std::vector<ExactPoint> shared;
      for (const ExactPoint& p : f) {
        if (std::find(g.begin(), g.end(), p) != g.end()) shared.push_back(p);
      }
      if (shared.size() < 3 && !explained(intersection(f, g), shared)) pairs.emplace(i, j);
    }
  }
  return pairs;
}

/// Ten to twenty triangles between a few places of a small grid, which share many.
TriangleMesh tangle(std::mt19937& random, bool flat) {
  const auto below = [&random](unsigned n) { return static_cast<unsigned>(random() % n); };
  TriangleMesh mesh;
  const unsigned places = 6 + below(12);
  for (unsigned i = 0; i < places; ++i) {
    const double z = flat && below(4) != 0 ? 1 : below(4);
    mesh.positions.push_back({double(below(4)), double(below(4)), z});
  }
  for (unsigned count = 10 + below(11); count > 0; --count) {
    mesh.triangles.push_back({below(places), below(places), below(places)});
  }
  return mesh;
}

/// By integers, so that no coordinate is rounded: planes along no axis.
TriangleMesh sheared(TriangleMesh mesh) {
  for (Vector3& p : mesh.positions) {
    p = {p.x + 2 * p.y - p.z, 3 * p.y + p.z - p.x, 5 * p.z - 2 * p.x + p.y};
  }
  return mesh;
}

void expect_found(const TriangleMesh& mesh, const Pairs& pairs) {
  const SelfIntersections found = self_intersections(mesh);
  EXPECT_TRUE(found.complete);
  ASSERT_EQ(found.pairs, pairs.size());
  ASSERT_EQ(found.examples.size(), std::min(pairs.size(), kMaxIntersectionExamples));
  auto expected = pairs.begin();
  for (const Intersection& example : found.examples) {
    EXPECT_EQ(example.triangles, (std::array{expected->first, expected->second}));
    ++expected;
  }
}

std::uint64_t pairs_of(const std::vector<Facet>& facets) {
  TriangleMesh mesh;
  for (const Facet& f : facets) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), f.begin(), f.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return self_intersections(mesh).pairs;
}

constexpr Facet kFloor{Vector3{0, 0, 0}, Vector3{4, 0, 0}, Vector3{0, 4, 0}};

TEST(SelfIntersectionTest, TanglesAgreeWithClippingInFractions) {
  std::mt19937 random(20260102);
  std::size_t pairs = 0;
  for (int round = 0; round < 400; ++round) {
    const TriangleMesh mesh = tangle(random, round % 2 == 0);
    const Pairs expected = by_clipping(mesh);
    pairs += expected.size();
    expect_found(mesh, expected);
    expect_found(sheared(mesh), expected);
  }
  EXPECT_GT(pairs, 1000U);  // or the tangles say nothing
}

TEST(SelfIntersectionTest, ScaleByPowersOfTwoChangesNothing) {
  std::mt19937 random(7);
  for (const double scale : {0x1p-250, 0x1p-30, 0x1p90}) {
    TriangleMesh mesh = sheared(tangle(random, true));
    const Pairs expected = by_clipping(mesh);
    for (Vector3& p : mesh.positions) p = scale * p;
    expect_found(mesh, expected);
  }
}

TEST(SelfIntersectionTest, SoundBodiesHaveNone) {
  for (const Body& body : bodies()) {
    const SelfIntersections found = self_intersections(body.mesh);
    EXPECT_EQ(found.pairs, 0U) << body.name;
    EXPECT_EQ(found.left_out, 0U) << body.name;
    EXPECT_TRUE(found.complete) << body.name;
  }
}

TEST(SelfIntersectionTest, WithoutASharedPlaceTouchingIsEnough) {
  EXPECT_EQ(pairs_of({kFloor, {Vector3{1, 1, 0}, Vector3{1, 1, 2}, Vector3{2, 1, 2}}}),
            1U);  // corner in face
  EXPECT_EQ(pairs_of({kFloor, {Vector3{2, 0, 0}, Vector3{2, 0, 2}, Vector3{3, 0, 2}}}),
            1U);  // on edge
  EXPECT_EQ(pairs_of({kFloor, {Vector3{2, -1, 0}, Vector3{2, 1, 0}, Vector3{2, 0, 2}}}), 1U);
  EXPECT_EQ(pairs_of({kFloor, {Vector3{1, 1, 0x1p-60}, Vector3{1, 1, 2}, Vector3{2, 1, 2}}}), 0U);
}

TEST(SelfIntersectionTest, TrianglesAtATJunctionTouch) {
  // The upper side's edge is split in its middle on one side only.
  EXPECT_EQ(pairs_of({kFloor, {Vector3{2, 0, 0}, Vector3{2, -3, 0}, Vector3{4, -3, 0}}}), 1U);
  EXPECT_EQ(pairs_of({kFloor, {Vector3{0, 0, 0}, Vector3{2, 0, 0}, Vector3{0, -3, 0}}}), 1U);
}

TEST(SelfIntersectionTest, AtASharedCornerTheyMeetAgain) {
  EXPECT_EQ(pairs_of({kFloor, {Vector3{0, 0, 0}, Vector3{1, 1, 1}, Vector3{1, 1, -1}}}), 1U);
  EXPECT_EQ(pairs_of({kFloor, {Vector3{0, 0, 0}, Vector3{1, 1, 0}, Vector3{1, 1, -1}}}), 1U);
  EXPECT_EQ(pairs_of({kFloor, {Vector3{0, 0, 0}, Vector3{-1, 1, 1}, Vector3{-1, 1, -1}}}), 0U);
  EXPECT_EQ(pairs_of({kFloor, {Vector3{0, 0, 0}, Vector3{-1, 0, 0}, Vector3{0, -1, 0}}}), 0U);
}

TEST(SelfIntersectionTest, AtASharedEdgeTheyFoldOver) {
  EXPECT_EQ(pairs_of({kFloor, {Vector3{0, 0, 0}, Vector3{4, 0, 0}, Vector3{9, 1, 0}}}), 1U);
  EXPECT_EQ(pairs_of({kFloor, {Vector3{0, 0, 0}, Vector3{4, 0, 0}, Vector3{9, -1, 0}}}), 0U);
  EXPECT_EQ(pairs_of({kFloor, {Vector3{4, 0, 0}, Vector3{0, 0, 0}, Vector3{1, 1, 0x1p-90}}}), 0U);
}

TEST(SelfIntersectionTest, DuplicatesAndDegenerateTrianglesAreNone) {
  EXPECT_EQ(pairs_of({kFloor, {kFloor[1], kFloor[0], kFloor[2]}}), 0U);
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {1, 1, 3}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {3, 3, 5}};
  const SelfIntersections found = self_intersections(mesh);
  EXPECT_EQ(found.pairs, 0U);
  EXPECT_EQ(found.left_out, 2U);
}

TEST(SelfIntersectionTest, PlacesOutOfRangeAreLeftOutAndSaid) {
  TriangleMesh mesh = box_mesh({1, 1, 1});
  mesh.positions.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  mesh.positions.push_back({0, std::numeric_limits<double>::infinity(), 0});
  mesh.positions.push_back({0, 0, 1e200});
  mesh.positions.push_back({0, 0, std::numeric_limits<double>::denorm_min()});
  for (std::uint32_t i = 8; i < 12; ++i) mesh.triangles.push_back({0, 1, i});
  const SelfIntersections found = self_intersections(mesh);
  EXPECT_EQ(found.left_out, 4U);
  EXPECT_EQ(found.pairs, 0U);
}

TEST(SelfIntersectionTest, ExamplesLieInBothTriangles) {
  const TriangleMesh ball = ball_mesh(1, 40, 20);
  const TriangleMesh mesh = joined(ball, moved(ball, {1.1, 0.2, 0.1}));
  const SelfIntersections found = self_intersections(mesh);
  ASSERT_EQ(found.examples.size(), kMaxIntersectionExamples);
  for (const Intersection& example : found.examples) {
    EXPECT_LT(example.triangles[0], ball.triangles.size());
    EXPECT_GE(example.triangles[1], ball.triangles.size());
    EXPECT_NEAR(length(example.at), 1, 0.02);
    EXPECT_NEAR(length(example.at - Vector3{1.1, 0.2, 0.1}), 1, 0.02);
  }
}

TEST(SelfIntersectionTest, CountingStopsAtTheMost) {
  TriangleMesh mesh;  // a fan of blades through one line
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const double a = 0.001 * i;
    mesh.positions.insert(
        mesh.positions.end(),
        {{-std::cos(a), -std::sin(a), 0}, {std::cos(a), std::sin(a), 1e-3 * i}, {0, 0, 9}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  for (std::uint32_t i = 0; i < 2000; ++i) mesh.positions[3 * i + 2].x = 1e-3 * i;
  const SelfIntersections found = self_intersections(mesh);
  EXPECT_EQ(found.pairs, kMaxIntersectingPairs);
  EXPECT_FALSE(found.complete);
}

TEST(SelfIntersectionTest, AllMeshesOfTheCorpusAreLookedAtWhole) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  std::size_t meshes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::corpus())) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".stl" && ending != ".STL" && ending != ".obj") continue;
    if (!test::in_part(entry.path().string())) continue;
    const LoadedMesh loaded = read_mesh(disk, entry.path().string(), test::workers());
    if (!loaded.usable()) continue;
    ++meshes;
    const SelfIntersections found = self_intersections(loaded.mesh);
    EXPECT_TRUE(found.complete) << entry.path();
    const double reach = 1e-2 * diagonal(bounds_of(loaded.mesh.positions));
    for (const Intersection& example : found.examples) {
      for (const std::uint64_t t : example.triangles) {
        const Facet f = facet(loaded.mesh, loaded.mesh.triangles[t]);
        EXPECT_LE(length(closest_point(f, example.at) - example.at), reach) << entry.path();
      }
    }
  }
  EXPECT_GT(meshes, test::part_of(300));
}

using Rational = boost::multiprecision::cpp_rational;

/// The determinant itself; a double is a fraction.
int exact_side(const std::array<Vector3, 4>& p) {
  std::array<std::array<Rational, 3>, 4> d;
  for (std::size_t i = 0; i < 4; ++i) {
    d[i] = {Rational(p[i].x) - Rational(p[0].x), Rational(p[i].y) - Rational(p[0].y),
            Rational(p[i].z) - Rational(p[0].z)};
  }
  const Rational det = d[1][0] * (d[2][1] * d[3][2] - d[2][2] * d[3][1]) +
                       d[1][1] * (d[2][2] * d[3][0] - d[2][0] * d[3][2]) +
                       d[1][2] * (d[2][0] * d[3][1] - d[2][1] * d[3][0]);
  return det.sign();
}

TEST(PredicateTest, SideIsExactInAPlaneAndARoundingAwayFromIt) {
  std::mt19937_64 random(11);
  // Integers of so many bits: with 30, places in a plane are exact; with 52, they are rounded.
  const auto coordinate = [&random](int bits) {
    return static_cast<double>(random() >> (64 - bits)) - std::ldexp(1, bits - 1);
  };
  std::array<int, 3> seen{};
  for (int round = 0; round < 6000; ++round) {
    const int bits = round % 2 == 0 ? 30 : 52;
    const Vector3 a{coordinate(36), coordinate(36), coordinate(36)};
    const Vector3 u{coordinate(bits), coordinate(bits), coordinate(bits)};
    const Vector3 v{coordinate(bits), coordinate(bits), coordinate(bits)};
    std::array<Vector3, 4> p{a, a + 3 * u, a + 5 * v, a + 7 * u - 4 * v};
    if (round % 3 != 0) p[3].x = std::nextafter(p[3].x, round % 3 == 1 ? 1e300 : -1e300);
    for (Vector3& q : p) q = std::ldexp(1, round % 560 - 320) * q;
    const int expected = exact_side(p);
    ++seen[static_cast<std::size_t>(expected + 1)];
    ASSERT_EQ(side(p[0], p[1], p[2], p[3]), expected) << round;
    ASSERT_EQ(side(p[1], p[0], p[2], p[3]), -expected) << round;
    ASSERT_EQ(side(p[3], p[0], p[1], p[2]), -expected) << round;
  }
  EXPECT_GT(*std::min_element(seen.begin(), seen.end()), 900);
}

TEST(PredicateTest, SideIsExactWhenDifferencesRound) {
  // Far below the digits of x and y there is still a side.
  const Vector3 a{1e17, 1, 0};
  const Vector3 b{0.1, 1e-17, 0};
  const Vector3 c{-3, 1e16, 0};
  const int above = turn({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
  EXPECT_NE(above, 0);
  EXPECT_EQ(side(a, b, c, {0.3, 0.7, 1e-40}), above);
  EXPECT_EQ(side(a, b, c, {0.3, 0.7, 0}), 0);
  EXPECT_EQ(side(a, b, c, {0.3, 0.7, -1e-40}), -above);
  // Of x + y = 1, to which 1e30 and -1e30 don't add up: the determinant is -1/4, by hand.
  EXPECT_EQ(turn({0.5, 0.5}, {1e30, -1e30}, {0.25, 0.75}), -1);
  EXPECT_EQ(turn({0.5, 0.5}, {0x1p50, 1 - 0x1p50}, {0.25, 0.75}), 0);
}

TEST(PredicateTest, TurnOnALineIsZero) {
  EXPECT_EQ(axis_of_view({Vector3{0, 0, 0}, {0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}}), 3);
  EXPECT_EQ(axis_of_view({Vector3{0, 0, 0}, {0.1, 0.2, 0.3}, {0.2, 0.4, std::nextafter(0.6, 1)}}),
            0);
  EXPECT_EQ(axis_of_view({Vector3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 2);
}

}  // namespace
}  // namespace rigor::mesh
