// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/page/bytes.h>

#include <dlfcn.h>
#include <zlib.h>

#include <cmath>
#include <new>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "report/page_decoding.h"

/// Whether zlib is to find no memory.
static bool zlib_fails = false;

/// Stands before the library's own, for the whole program.
extern "C" int compress2(Bytef* to, uLongf* size, const Bytef* from, uLong bytes, int level) {
  if (zlib_fails) return Z_MEM_ERROR;
  static const auto own = reinterpret_cast<decltype(&compress2)>(dlsym(RTLD_NEXT, "compress2"));
  return own(to, size, from, bytes, level);
}

namespace rigor::report {
namespace {

using mesh::TriangleMesh;
using mesh::Vector3;
using test::from_base64;
using test::inflated;
using test::numbers_at;

/// So many triangles anywhere, with all that corners can carry.
TriangleMesh scattered(std::size_t triangles) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-3, 5);
  std::uniform_real_distribution<float> share(0, 1);
  TriangleMesh mesh;
  for (std::uint32_t t = 0; t < triangles; ++t) {
    for (int k = 0; k < 3; ++k)
      mesh.positions.push_back({place(random), 10 * place(random), place(random) / 1000});
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    auto& normals = mesh.corners.normals.emplace_back();
    auto& texture = mesh.corners.texture.emplace_back();
    auto& colors = mesh.corners.colors.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const float angle = 6 * share(random);
      normals[k] = {std::cos(angle), 0, std::sin(angle)};
      texture[k] = {share(random) * 4 - 2, share(random)};
      colors[k] = {share(random), share(random), share(random), 1};
    }
  }
  return mesh;
}

std::vector<std::uint32_t> indices_of(const PageMesh& mesh, const std::string& bytes) {
  const auto& [at, size] = mesh.indices;
  if (mesh.vertices > 65535) return numbers_at<std::uint32_t>(bytes, at, size);
  const auto narrow = numbers_at<std::uint16_t>(bytes, at, size);
  return {narrow.begin(), narrow.end()};
}

void expect_same(const TriangleMesh& mesh, const PageMesh& page, const std::string& bytes) {
  ASSERT_EQ(page.triangles, mesh.triangles.size());
  const auto indices = indices_of(page, bytes);
  ASSERT_EQ(indices.size(), 3 * mesh.triangles.size());
  const auto positions = numbers_at<std::uint16_t>(bytes, page.positions.at, page.positions.bytes);
  ASSERT_EQ(positions.size(), 3 * page.vertices);
  const auto normals = numbers_at<std::int8_t>(bytes, page.normals->at, page.normals->bytes);
  const auto uvs = numbers_at<float>(bytes, page.uvs->at, page.uvs->bytes);
  const auto colors = numbers_at<std::uint8_t>(bytes, page.colors->at, page.colors->bytes);
  const double slack = 0.5 + 1e-9;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = indices[3 * t + k];
      ASSERT_LT(v, page.vertices);
      const Vector3& p = mesh.positions[mesh.triangles[t][k]];
      EXPECT_LE(std::abs(page.low.x + page.step.x * positions[3 * v] - p.x), slack * page.step.x);
      EXPECT_LE(std::abs(page.low.y + page.step.y * positions[3 * v + 1] - p.y),
                slack * page.step.y);
      EXPECT_LE(std::abs(page.low.z + page.step.z * positions[3 * v + 2] - p.z),
                slack * page.step.z);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(normals[3 * v + i] / 127.0, mesh.corners.normals[t][k][i], 0.5 / 127 + 1e-6);
      }
      for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(uvs[2 * v + i], mesh.corners.texture[t][k][i]);
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(colors[4 * v + i] / 255.0, mesh.corners.colors[t][k][i], 0.5 / 255 + 1e-6);
      }
    }
  }
}

TEST(PageBytes, EveryCornerIsWhereItWasWithinHalfAStep) {
  const TriangleMesh few = scattered(500);
  const TriangleMesh many = scattered(30'000);  // 90,000 vertices: wide indices
  PageBytes bytes;
  const PageMesh first = bytes.add(few, Textured::kYes);
  const PageMesh second = bytes.add(many, Textured::kYes);
  EXPECT_GT(second.vertices, 65535U);
  const std::string numbers = inflated(from_base64(bytes.text()));
  expect_same(few, first, numbers);
  expect_same(many, second, numbers);
}

/// Two triangles for each side of a cube, each with corners of its own, as an STL has them.
TriangleMesh loose_cube() {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      const auto corner = [&](int u, int v) {
        std::array<double, 3> p{};
        p[static_cast<std::size_t>(axis)] = side;
        p[static_cast<std::size_t>((axis + 1) % 3)] = u;
        p[static_cast<std::size_t>((axis + 2) % 3)] = v;
        mesh.positions.push_back({p[0], p[1], p[2]});
      };
      const auto base = static_cast<std::uint32_t>(mesh.positions.size());
      corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 0), corner(1, 1), corner(0, 1);
      mesh.triangles.push_back({base, base + 1, base + 2});
      mesh.triangles.push_back({base + 3, base + 4, base + 5});
      mesh::Corners::Normal normal{};
      normal[static_cast<std::size_t>(axis)] = side == 1 ? 1.F : -1.F;
      mesh.corners.normals.push_back({normal, normal, normal});
      mesh.corners.normals.push_back({normal, normal, normal});
    }
  }
  return mesh;
}

TEST(PageBytes, CornersThatAreTheSameAreOneVertex) {
  TriangleMesh cube = loose_cube();
  PageBytes bytes;
  EXPECT_EQ(bytes.add(cube, Textured::kNo).vertices, 24U);  // four for each side: normals differ
  cube.corners.normals.clear();
  const PageMesh bare = bytes.add(cube, Textured::kNo);
  EXPECT_EQ(bare.vertices, 8U);
  EXPECT_EQ(bare.triangles, 12U);
  EXPECT_FALSE(bare.normals || bare.uvs || bare.colors);
}

TEST(PageBytes, WhatIsFlatStaysFlat) {
  PageBytes bytes;
  const PageMesh flat = bytes.add(
      {.positions = {{0, 0, 3}, {1, 0, 3}, {0, 2, 3}}, .triangles = {{0, 1, 2}}}, Textured::kNo);
  EXPECT_EQ(flat.low.z, 3);
  EXPECT_EQ(flat.step.z, 0);
  EXPECT_EQ(flat.vertices, 3U);
}

TEST(PageBytes, PlacesInAPictureAreLeftOutWhereThereIsNone) {
  PageBytes bytes;
  EXPECT_FALSE(bytes.add(scattered(3), Textured::kNo).uvs);
}

TEST(PageBytes, NothingIsNothing) {
  PageBytes bytes;
  EXPECT_EQ(bytes.text(), "");
  const PageMesh empty = bytes.add({}, Textured::kYes);
  EXPECT_EQ(empty.vertices + empty.triangles, 0U);
}

TEST(PageBytes, AreNotCutWhereZlibFails) {
  PageBytes bytes;
  bytes.add(scattered(5), Textured::kNo);
  zlib_fails = true;
  EXPECT_THROW(bytes.text(), std::bad_alloc);
  zlib_fails = false;
  EXPECT_FALSE(bytes.text().empty());
}

}  // namespace
}  // namespace rigor::report
