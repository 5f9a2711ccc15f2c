// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A yardstick for the search for self-intersections: CGAL's, timed, on a binary STL. It prints the
// milliseconds of the fastest of five rounds, and the number of pairs.
//
// Its half-edges need a manifold, so corners where the surface is none are taken apart first. There, as
// at faces that are doubled or degenerate, it counts pairs that rigor does not: see
// rigor/mesh/spatial/self_intersection.h.
//
// A program of its own. It uses CGAL, whose mesh packages are under the GPL; nothing of rigor is linked
// to it or to CGAL, and the benchmarks build it only where CGAL is installed.
//
//   g++ -std=c++17 -O3 -DNDEBUG -frounding-math cgal_self_intersection.cc -lgmp -lmpfr
//   cgal_self_intersection MESH.stl

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Pair = std::pair<Mesh::Face_index, Mesh::Face_index>;

constexpr int kRounds = 5;
constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kFacetBytes = 50;
constexpr std::size_t kNormalBytes = 12;

/// Corners of the same coordinates are one; triangles with fewer than three are left out.
Mesh read(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  std::map<std::array<float, 3>, std::size_t> numbers;
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t at = kHeaderBytes; at + kFacetBytes <= bytes.size(); at += kFacetBytes) {
    std::array<std::array<float, 3>, 3> corners;
    std::memcpy(corners.data(), bytes.data() + at + kNormalBytes, sizeof corners);
    std::array<std::size_t, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      for (float& x : corners[i]) x += 0.0F;  // -0 is 0
      const auto [entry, added] = numbers.emplace(corners[i], points.size());
      if (added) points.emplace_back(corners[i][0], corners[i][1], corners[i][2]);
      triangle[i] = entry->second;
    }
    const auto& t = triangle;
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
  }
  namespace pmp = CGAL::Polygon_mesh_processing;
  pmp::orient_polygon_soup(points, triangles);
  Mesh mesh;
  pmp::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: cgal_self_intersection MESH.stl\n");
    return 2;
  }
  const Mesh mesh = read(argv[1]);
  double least = std::numeric_limits<double>::infinity();
  std::size_t pairs = 0;
  for (int round = 0; round < kRounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<Pair> found;
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(
        mesh, std::back_inserter(found));
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    least = std::min(least, took.count());
    pairs = found.size();
  }
  std::printf("%.2f ms, %zu pairs\n", least, pairs);
  return 0;
}
