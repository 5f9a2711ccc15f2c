// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes against the bodies they represent, and against the same integrals in whole numbers, where
// nothing is rounded until the end.

#include <rigor/mass/polyhedron.h>

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <rigor/mass/polyline.h>

#include "mass/quadrature.h"

namespace rigor::mass {
namespace {

using mesh::Facet;
using mesh::TriangleMesh;
using model::Vector3;
using test::expect_close;
using test::kPi;

constexpr double kExactly = 2e-14;

/// `profile` holds (radius, 0, z), the body on its left going up; turned about z in `count` steps.
TriangleMesh revolved(const std::vector<Vector3>& profile, int count) {
  TriangleMesh mesh;
  for (int j = 0; j < count; ++j) {
    const double angle = 2 * kPi * j / count;
    for (const Vector3& p : profile) {
      mesh.positions.push_back({p.x * std::cos(angle), p.x * std::sin(angle), p.z});
    }
  }
  const auto rows = static_cast<std::uint32_t>(profile.size());
  const auto all = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t at = 0; at < all; at += rows) {
    for (std::uint32_t i = 0; i + 1 < rows; ++i) {
      const std::uint32_t a = at + i;
      const std::uint32_t b = (a + rows) % all;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  }
  return mesh;
}

TriangleMesh sphere_mesh(double radius, int count) {
  std::vector<Vector3> profile;
  for (int i = 0; i <= count / 2; ++i) {
    const double angle = kPi * i / (count / 2);
    profile.push_back({radius * std::sin(angle), 0, -radius * std::cos(angle)});
  }
  return revolved(profile, count);
}

TriangleMesh torus_mesh(double ring, double tube, int count) {
  std::vector<Vector3> profile;
  for (int i = 0; i <= count / 2; ++i) {
    const double angle = 2 * kPi * i / (count / 2);
    profile.push_back({ring + tube * std::cos(angle), 0, tube * std::sin(angle)});
  }
  profile.back() = profile.front();
  return revolved(profile, count);
}

TriangleMesh cone_mesh(double radius, double length, int count) {
  return revolved({{0, 0, -length / 2}, {radius, 0, -length / 2}, {0, 0, length / 2}}, count);
}

TriangleMesh box_surface(const Vector3& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back({(i & 1) != 0 ? size.x / 2 : -size.x / 2,
                              (i & 2) != 0 ? size.y / 2 : -size.y / 2,
                              (i & 4) != 0 ? size.z / 2 : -size.z / 2});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

template <class Change>
TriangleMesh changed(TriangleMesh mesh, const Change& change) {
  for (Vector3& p : mesh.positions) p = change(p);
  return mesh;
}

TriangleMesh moved(const TriangleMesh& mesh, const Vector3& by) {
  return changed(mesh, [&](const Vector3& p) { return p + by; });
}

/// As an STL file holds it: 24 bits of each coordinate. (By hand, because at -O2 gcc 12 drops the two
/// casts to float and back where it takes two coordinates at once.)
TriangleMesh in_floats(const TriangleMesh& mesh) {
  const auto rounded = [](double v) {
    if (std::abs(v) < 1e-9) return 0.0;  // so that 2^-60 divides what is left
    int exponent = 0;
    const double mantissa = std::frexp(v, &exponent);
    return std::ldexp(std::nearbyint(std::ldexp(mantissa, 24)), exponent - 24);
  };
  return changed(mesh, [&](const Vector3& p) {
    return Vector3{rounded(p.x), rounded(p.y), rounded(p.z)};
  });
}

/// A torus pulled out of every symmetry.
TriangleMesh odd_mesh(int count) {
  return changed(torus_mesh(0.2, 0.06, count), [](const Vector3& p) {
    const double swell = 1 + 0.3 * p.x + 0.2 * std::sin(9 * p.y);
    return Vector3{p.x * swell, p.y + 0.2 * p.z, p.z * swell + 0.5 * p.x * p.x};
  });
}

Solid solid_torus(double ring, double tube) {
  const double across = ring * ring / 2 + 5 * tube * tube / 8;
  return {2 * kPi * kPi * ring * tube * tube,
          {},
          {across, 0, 0, across, 0, ring * ring + 3 * tube * tube / 4}};
}

TEST(Polyhedron, BoxesAreExact) {
  const PolyhedronMoments moments = moments_of(moved(box_surface({1, 2, 3}), {4, 5, 6}));
  const Solid solid = solid_of(moments);
  EXPECT_DOUBLE_EQ(solid.volume, 6);
  EXPECT_EQ(solid.com, (Vector3{4, 5, 6}));
  EXPECT_DOUBLE_EQ(solid.unit_inertia.ixx, 13.0 / 12);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.iyy, 10.0 / 12);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.izz, 5.0 / 12);
  EXPECT_EQ(solid.unit_inertia.ixy, 0);
  EXPECT_DOUBLE_EQ(moments.area, 22);
  EXPECT_EQ(moments.area_vector, Vector3{});
}

TEST(Polyhedron, TetrahedronByHand) {
  // Corner at the origin, legs a, b, c: volume abc/6, center at a quarter, ∫x²/V about it 3a²/80,
  // ∫xy/V -ab/80.
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 4}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const Solid solid = solid_of(moments_of(mesh));
  EXPECT_DOUBLE_EQ(solid.volume, 8.0 / 6);
  EXPECT_NEAR(model::length(solid.com - Vector3{0.25, 0.5, 1}), 0, 1e-15);
  EXPECT_NEAR(solid.unit_inertia.ixx, 3.0 / 80 * (4 + 16), 1e-15);
  EXPECT_NEAR(solid.unit_inertia.iyy, 3.0 / 80 * (1 + 16), 1e-15);
  EXPECT_NEAR(solid.unit_inertia.izz, 3.0 / 80 * (1 + 4), 1e-15);
  EXPECT_NEAR(solid.unit_inertia.ixy, 2.0 / 80, 1e-15);
  EXPECT_NEAR(solid.unit_inertia.ixz, 4.0 / 80, 1e-15);
  EXPECT_NEAR(solid.unit_inertia.iyz, 8.0 / 80, 1e-15);
}

/// How far a mesh is from its body, relative to it: volume, moments across and along z.
std::array<double, 3> errors(const TriangleMesh& mesh, const Solid& body) {
  const Solid solid = solid_of(moments_of(mesh));
  return {1 - solid.volume / body.volume, 1 - solid.unit_inertia.ixx / body.unit_inertia.ixx,
          1 - solid.unit_inertia.izz / body.unit_inertia.izz};
}

TEST(Polyhedron, TwiceTheResolutionIsAQuarterOfTheError) {
  const auto expect_second_order = [](const auto& mesh, const Solid& body) {
    const auto coarse = errors(mesh(64), body);
    const auto fine = errors(mesh(128), body);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_GT(coarse[i] / fine[i], 3.7) << i;
      EXPECT_LT(coarse[i] / fine[i], 4.3) << i;
      EXPECT_LT(std::abs(fine[i]), 1e-2) << i;
    }
  };
  expect_second_order([](int n) { return sphere_mesh(0.3, n); }, sphere(0.3));
  expect_second_order([](int n) { return torus_mesh(0.2, 0.06, n); }, solid_torus(0.2, 0.06));
  expect_second_order([](int n) { return cone_mesh(0.2, 0.3, n); }, cone(0.2, 0.3));
}

TEST(Polyhedron, ConesCenterIsExact) {
  EXPECT_NEAR(solid_of(moments_of(cone_mesh(0.2, 0.3, 7))).com.z, -0.075, 1e-16);
}

/// In whole numbers: coordinates times 2^60 are, for floats above 2^-37.
Solid exact(const TriangleMesh& mesh) {
  using Whole = boost::multiprecision::cpp_int;
  using Ratio = boost::multiprecision::cpp_rational;
  using Point = std::array<Whole, 3>;
  const auto whole = [](double v) {
    const double grown = std::ldexp(v, 60);
    EXPECT_EQ(grown, std::nearbyint(grown));
    return Whole(grown);
  };
  std::vector<Point> points;
  for (const Vector3& p : mesh.positions) points.push_back({whole(p.x), whole(p.y), whole(p.z)});
  Whole volume = 0;
  Point first{};
  std::array<Point, 3> second{};
  for (const mesh::Triangle& t : mesh.triangles) {
    const Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const Whole D = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                    a[2] * (b[0] * c[1] - b[1] * c[0]);
    volume += D;
    for (std::size_t i = 0; i < 3; ++i) {
      const Whole si = a[i] + b[i] + c[i];
      first[i] += D * si;
      for (std::size_t j = i; j < 3; ++j) {
        second[i][j] += D * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + si * (a[j] + b[j] + c[j]));
      }
    }
  }
  const auto number = [](const Ratio& ratio, int power) {
    return std::ldexp(static_cast<double>(ratio), -60 * power);
  };
  const auto com = [&](std::size_t i) { return Ratio(first[i], 4 * volume); };
  const auto spread = [&](std::size_t i, std::size_t j) {
    return number(Ratio(second[i][j], 20 * volume) - com(i) * com(j), 2);
  };
  return {number(Ratio(volume, 6), 3),
          {number(com(0), 1), number(com(1), 1), number(com(2), 1)},
          {spread(1, 1) + spread(2, 2), -spread(0, 1), -spread(0, 2), spread(0, 0) + spread(2, 2),
           -spread(1, 2), spread(0, 0) + spread(1, 1)}};
}

TEST(Polyhedron, AgreesWithWholeNumbers) {
  const Vector3 far{1000, -1000, 1000};
  // The center is reported as one vector from the origin, whose own rounding far away is 1e-13 m.
  constexpr double kFar = 1e-13;
  for (const TriangleMesh& mesh :
       {sphere_mesh(0.1, 64), torus_mesh(0.2, 0.06, 64), cone_mesh(0.2, 0.3, 100), odd_mesh(64),
        box_surface({0.1, 0.2, 0.3})}) {
    const TriangleMesh near_floats = in_floats(mesh);
    expect_close(solid_of(moments_of(near_floats)), exact(near_floats), kExactly);
    const TriangleMesh far_floats = in_floats(moved(mesh, far));
    expect_close(solid_of(moments_of(far_floats)), exact(far_floats), kFar);
  }
}

TEST(Polyhedron, AKilometerFromItsOrigin) {
  const Vector3 far{1000, 1000, 1000};
  const TriangleMesh mesh = odd_mesh(96);
  Solid expected = solid_of(moments_of(mesh));
  expected.com = expected.com + far;
  expect_close(solid_of(moments_of(moved(mesh, far))), expected, 2e-12);
}

TEST(Polyhedron, JoinedRunsAreOnePass) {
  const TriangleMesh mesh = odd_mesh(128);
  ASSERT_GT(mesh.triangles.size(), 7 * PolyhedronSum::kRun);
  const Vector3 reference{0.1, 0.2, 0.3};
  PolyhedronSum whole(reference);
  for (const mesh::Triangle& t : mesh.triangles) whole.add(facet(mesh, t));
  for (std::size_t trial = 0; trial < 20; ++trial) {
    PolyhedronSum joined(reference);
    for (std::size_t i = 0; i < mesh.triangles.size();) {
      const std::size_t end =
          std::min(mesh.triangles.size(), i + (1 + (trial + i / 777) % 4) * PolyhedronSum::kRun);
      PolyhedronSum part(reference);
      for (; i < end; ++i) part.add(facet(mesh, mesh.triangles[i]));
      joined.join(part);
    }
    EXPECT_EQ(joined.moments(), whole.moments());
  }
}

TEST(Polyhedron, OddSplitsDifferByRoundingOnly) {
  const TriangleMesh mesh = odd_mesh(64);
  std::array<PolyhedronSum, 3> parts{PolyhedronSum({}), PolyhedronSum({}), PolyhedronSum({})};
  PolyhedronSum whole({});
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    parts[i < 777 ? 0 : i < 1000 ? 1 : 2].add(facet(mesh, mesh.triangles[i]));
    whole.add(facet(mesh, mesh.triangles[i]));
  }
  PolyhedronSum joined({});
  for (const PolyhedronSum& part : parts) joined.join(part);
  expect_close(solid_of(joined.moments()), solid_of(whole.moments()), kExactly);
}

TEST(Polyhedron, WhatCancelsTakesNothingWithIt) {
  // A body of a milliard cubic meters, a cubic decimeter, and the large body inside out.
  const TriangleMesh large = box_surface({1000, 1000, 1001});
  const TriangleMesh small = box_surface({0.1, 0.1, 0.1});
  const auto sum_of = [](const TriangleMesh& mesh, std::size_t second, std::size_t third) {
    PolyhedronSum sum({});
    for (const mesh::Triangle& t : mesh.triangles) {
      sum.add({mesh.positions[t[0]], mesh.positions[t[second]], mesh.positions[t[third]]});
    }
    return sum;
  };
  PolyhedronSum sum = sum_of(large, 1, 2);
  sum.join(sum_of(small, 1, 2));
  sum.join(sum_of(large, 2, 1));
  EXPECT_DOUBLE_EQ(sum.moments().volume, 1e-3);
}

TEST(Polyhedron, ScaledIsTheScaledMeshs) {
  const TriangleMesh mesh = moved(odd_mesh(32), {0.5, 0.1, -0.2});
  for (const Vector3& scale : {Vector3{2, 2, 2}, Vector3{0.001, 0.002, 0.003}, Vector3{-1, 1, 1},
                               Vector3{2, -3, -0.5}, Vector3{-1, -2, -3}}) {
    TriangleMesh expected = changed(mesh, [&](const Vector3& p) {
      return Vector3{scale.x * p.x, scale.y * p.y, scale.z * p.z};
    });
    if (scale.x * scale.y * scale.z < 0) {
      for (mesh::Triangle& t : expected.triangles) std::swap(t[1], t[2]);
    }
    expect_close(solid_of(scaled(moments_of(mesh), scale)), solid_of(moments_of(expected)),
                 kExactly);
  }
}

TEST(Polyhedron, ScaledAreas) {
  TriangleMesh open = odd_mesh(32);
  open.triangles.resize(300);
  const PolyhedronMoments moments = moments_of(open);
  const PolyhedronMoments even = scaled(moments, {-2, 2, 2});
  EXPECT_DOUBLE_EQ(even.area, 4 * moments.area);
  EXPECT_TRUE(std::isnan(scaled(moments, {1, 2, 3}).area));
  TriangleMesh grown = changed(open, [](const Vector3& p) {
    return Vector3{p.x, -2 * p.y, 3 * p.z};
  });
  for (mesh::Triangle& t : grown.triangles) std::swap(t[1], t[2]);
  const Vector3 expected = moments_of(grown).area_vector;
  ASSERT_GT(model::length(expected), 1e-3);
  EXPECT_NEAR(model::length(scaled(moments, {1, -2, 3}).area_vector - expected), 0, 1e-14);
}

TEST(Polyhedron, InvertedIsTheTurnedMeshs) {
  TriangleMesh mesh = odd_mesh(32);
  const Solid solid = solid_of(moments_of(mesh));
  for (mesh::Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  const PolyhedronMoments inside_out = moments_of(mesh);
  EXPECT_LT(inside_out.volume, 0);
  expect_close(solid_of(inverted(inside_out)), solid, kExactly);
  EXPECT_EQ(inverted(inside_out).area, inside_out.area);
}

TEST(Polyhedron, CavitiesAreSubtracted) {
  TriangleMesh mesh = box_surface({1, 2, 3});
  TriangleMesh cavity = moved(box_surface({0.5, 0.5, 0.5}), {0.125, 0.25, 0.5});
  for (const mesh::Triangle& t : cavity.triangles)
    mesh.triangles.push_back({t[0] + 8, t[2] + 8, t[1] + 8});
  mesh.positions.insert(mesh.positions.end(), cavity.positions.begin(), cavity.positions.end());
  const MassProperties expected =
      subtract(of_density(box({1, 2, 3}), 1),
               translated({0.125, 0.25, 0.5}, of_density(box({0.5, 0.5, 0.5}), 1)));
  expect_close(solid_of(moments_of(mesh)),
               {expected.mass, expected.com, (1 / expected.mass) * expected.about_com}, kExactly);
}

TEST(Polyhedron, NothingIsNothing) { EXPECT_EQ(moments_of({}), PolyhedronMoments{}); }

/// Whether a ray along z from p upward leaves the mesh.
bool inside(const TriangleMesh& mesh, const Vector3& p) {
  bool result = false;
  for (const mesh::Triangle& t : mesh.triangles) {
    const auto [a, b, c] = facet(mesh, t);
    const auto side = [&](const Vector3& u, const Vector3& v) {
      return (v.x - u.x) * (p.y - u.y) - (v.y - u.y) * (p.x - u.x) > 0;
    };
    const bool left = side(a, b);
    if (side(b, c) != left || side(c, a) != left) continue;
    const Vector3 n = model::cross(b - a, c - a);
    if (n.z != 0 && model::dot(n, p - a) / n.z < 0) result = !result;
  }
  return result;
}

TEST(Polyhedron, PointsInsideAnOddShape) {
  const TriangleMesh mesh = odd_mesh(24);
  const Solid solid = solid_of(moments_of(mesh));
  // A lattice of 30 x 30 x 12 cells over the bounds, none of its lines on a corner.
  const Vector3 low{-0.3001, -0.3001, -0.1001}, high{0.3503, 0.3003, 0.1603};
  constexpr int kAcross = 30, kUp = 12;
  int count = 0;
  Vector3 sum;
  double xx = 0;
  for (int i = 0; i < kAcross * kAcross * kUp; ++i) {
    const auto at = [](double from, double to, int k, int n) {
      return from + (to - from) * (k + 0.5) / n;
    };
    const Vector3 p{at(low.x, high.x, i % kAcross, kAcross),
                    at(low.y, high.y, i / kAcross % kAcross, kAcross),
                    at(low.z, high.z, i / (kAcross * kAcross), kUp)};
    if (!inside(mesh, p)) continue;
    ++count;
    sum = sum + p;
    xx += p.x * p.x;
  }
  const Vector3 com = (1.0 / count) * sum;
  const Vector3 size = high - low;
  const double cell = size.x * size.y * size.z / (kAcross * kAcross * kUp);
  constexpr double kLattice = 7e-3;  // what half-filled cells leave is less
  const Inertia& unit = solid.unit_inertia;
  EXPECT_NEAR(count * cell, solid.volume, kLattice * solid.volume);
  EXPECT_NEAR(model::length(com - solid.com), 0, kLattice * 0.2);
  const double expected = (unit.iyy + unit.izz - unit.ixx) / 2;
  EXPECT_NEAR(xx / count - com.x * com.x, expected, kLattice * expected);
}

}  // namespace
}  // namespace rigor::mass
