// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the tests of the mesh readers share: files of random triangles, and damage to files.

#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mesh/read.h>

namespace rigor::test {

using mesh::Fault;
using mesh::FaultKind;
using mesh::LoadedMesh;
using mesh::Part;
using mesh::Triangle;
using mesh::TriangleMesh;
using model::Vector3;

inline const Fault* find_fault(const LoadedMesh& loaded, FaultKind kind) {
  for (const Fault& fault : loaded.faults) {
    if (fault.kind == kind) return &fault;
  }
  return nullptr;
}

/// The one fault that there must be.
inline Fault only_fault(const LoadedMesh& loaded) {
  EXPECT_EQ(loaded.faults.size(), 1U);
  return loaded.faults.empty() ? Fault{} : loaded.faults.front();
}

inline void expect_no_mesh(const LoadedMesh& loaded) {
  EXPECT_FALSE(loaded.usable());
  // Of vertices without faces MuJoCo takes the hull.
  const bool lacks_faces =
      loaded.faults.size() == 1 && loaded.faults.front().kind == FaultKind::kEmpty;
  EXPECT_TRUE(lacks_faces || loaded.mesh.positions.empty());
  EXPECT_TRUE(loaded.mesh.triangles.empty());
  EXPECT_TRUE(loaded.mesh.parts.empty());
}

/// The shortest text that reads back as the same number.
template <class Number>
std::string text_of(Number value) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

inline std::string text_of(const Vector3& p) {
  return text_of(p.x) + ' ' + text_of(p.y) + ' ' + text_of(p.z);
}

/// Any finite float of any exponent.
inline double random_float(std::mt19937& random) {
  for (;;) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isfinite(value)) return double{value};
  }
}

/// As an STL has them: three vertices a triangle.
inline TriangleMesh random_soup(std::mt19937& random, std::uint32_t triangles) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      mesh.positions.push_back({random_float(random), random_float(random), random_float(random)});
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// What holds of anything read from a file of this size, however damaged.
inline void expect_sound(const LoadedMesh& loaded, std::size_t file_size) {
  const TriangleMesh& mesh = loaded.mesh;
  if (!loaded.usable()) expect_no_mesh(loaded);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) ASSERT_LT(corner, mesh.positions.size());
  }
  for (const Vector3& p : mesh.positions) {
    ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
  std::size_t covered = 0;
  for (const Part& part : mesh.parts) {
    ASSERT_EQ(part.first, covered);
    covered += part.count;
  }
  ASSERT_EQ(covered, mesh.triangles.size());
  // A part of an OBJ takes 16 bytes of the file at least, a vertex or triangle 2.
  ASSERT_LE(mesh.positions.capacity() * sizeof(Vector3) +
                mesh.triangles.capacity() * sizeof(Triangle) + mesh.parts.capacity() * sizeof(Part),
            64 * file_size + 1024);
}

/// Reads the file cut short, with bits flipped, or both, 10,000 times.
template <class Read>
void expect_survives_damage(const std::string& file, Read read) {
  std::mt19937 random(20260);
  for (int round = 0; round < 10'000; ++round) {
    // Without the zero that a string has behind its end, so that a sanitizer sees one byte too far.
    std::vector<char> bytes(file.begin(), file.end());
    if (round % 3 != 0) bytes.resize(random() % bytes.size());
    bytes.shrink_to_fit();
    for (int flips = round % 3 == 1 || bytes.empty() ? 0 : 1 + round % 4; flips > 0; --flips) {
      char& byte = bytes[random() % bytes.size()];
      byte = static_cast<char>(byte ^ (1 << random() % 8));
    }
    expect_sound(read(std::string_view(bytes.data(), bytes.size())), bytes.size());
    ASSERT_FALSE(testing::Test::HasFatalFailure()) << "round " << round;
  }
}

}  // namespace rigor::test
