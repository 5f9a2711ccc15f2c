// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev bench reduce`: bringing a mesh to a tenth of its triangles, as a ratio to the library's
// own call on the same mesh, which is given to it welded; as one to its call with the vertices told
// apart that keep parts and textures in their place; and as one to what a program needs that has the
// mesh as it was read and nothing but the library: its index of equal vertices first, then the call.
// The mesh is a file or, without one, a bumpy ball of a million triangles and then, where RIGOR_CORPUS
// names a folder, its ten largest.
//
//   rigor_reduce_bench [MESH]

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <meshoptimizer.h>

#include <rigor/mesh/read.h>
#include <rigor/mesh/reduce.h>
#include <rigor/mesh/topology/topology.h>
#include <rigor/mesh/topology/vertices.h>
#include <rigor/mesh/topology/weld.h>
#include <rigor/text/disk.h>

namespace {

using rigor::mesh::TriangleMesh;

// Of each mesh, at least; a small one is done again for so long.
constexpr std::size_t kRounds = 7;
constexpr double kSeconds = 2;

constexpr std::size_t kLargeMeshes = 10;

TriangleMesh bumpy_ball() {
  constexpr std::uint32_t kAround = 1000;
  constexpr std::uint32_t kDown = 501;
  constexpr double kPi = 3.141592653589793;
  TriangleMesh mesh;
  const auto add = [&mesh](double u, double v) {
    const double r = 1 + 0.1 * std::sin(8 * u) * std::sin(v) * std::sin(9 * v) +
                     0.02 * std::sin(40 * u) * std::pow(std::sin(v), 3) * std::cos(37 * v);
    mesh.positions.push_back(
        {r * std::sin(v) * std::cos(u), r * std::sin(v) * std::sin(u), r * std::cos(v)});
  };
  for (std::uint32_t j = 1; j < kDown; ++j) {
    for (std::uint32_t i = 0; i < kAround; ++i) add(2 * kPi * i / kAround, kPi * j / kDown);
  }
  add(0, 0);
  add(0, kPi);
  const std::uint32_t top = kAround * (kDown - 1);
  const auto at = [](std::uint32_t j, std::uint32_t i) { return (j - 1) * kAround + i % kAround; };
  for (std::uint32_t i = 0; i < kAround; ++i) {
    mesh.triangles.push_back({top, at(1, i), at(1, i + 1)});
    mesh.triangles.push_back({top + 1, at(kDown - 1, i + 1), at(kDown - 1, i)});
    for (std::uint32_t j = 1; j + 1 < kDown; ++j) {
      mesh.triangles.push_back({at(j, i), at(j + 1, i), at(j + 1, i + 1)});
      mesh.triangles.push_back({at(j, i), at(j + 1, i + 1), at(j, i + 1)});
    }
  }
  return mesh;
}

/// Of the processor: a machine that is not alone lets the shorter of two works through more often.
double seconds(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// What the library wants, made ready beforehand.
struct Bare {
  std::vector<std::uint32_t> index;
  std::vector<std::array<float, 3>> points;

  Bare(const TriangleMesh& mesh, std::vector<std::uint32_t> corners,
       const std::vector<std::uint32_t>& positions)
      : index(std::move(corners)) {
    for (const std::uint32_t position : positions) {
      const rigor::mesh::Vector3& p = mesh.positions[position];
      points.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    }
  }

  void run(std::size_t triangles) const {
    std::vector<std::uint32_t> result(index.size());
    meshopt_simplify(result.data(), index.data(), index.size(), points.front().data(),
                     points.size(), sizeof(points.front()), 3 * triangles, 1, 0, nullptr);
  }
};

Bare welded_of(const TriangleMesh& mesh) {
  const rigor::mesh::Weld welded = rigor::mesh::weld(mesh.positions);
  std::vector<std::uint32_t> corners;
  for (const rigor::mesh::Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) corners.push_back(welded.place[corner]);
  }
  return {mesh, std::move(corners), welded.first};
}

/// As the library must be given it if borders of parts and seams are to stay.
Bare with_seams_of(const TriangleMesh& mesh) {
  const rigor::mesh::Weld welded = rigor::mesh::weld(mesh.positions);
  rigor::mesh::Vertices vertices =
      rigor::mesh::vertices_of(mesh, welded, rigor::mesh::Seams::kKeep);
  std::vector<std::uint32_t> positions;
  for (const std::uint32_t place : vertices.place) positions.push_back(welded.first[place]);
  return {mesh, std::move(vertices.index), positions};
}

/// The corners of all triangles, of which the library finds those that are equal before it begins.
struct AsRead {
  std::vector<std::array<float, 3>> corners;

  explicit AsRead(const TriangleMesh& mesh) {
    for (const rigor::mesh::Triangle& t : mesh.triangles) {
      for (const std::uint32_t corner : t) {
        const rigor::mesh::Vector3& p = mesh.positions[corner];
        corners.push_back(
            {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
      }
    }
  }

  void run(std::size_t triangles) const {
    const std::size_t count = corners.size();
    constexpr std::size_t kSize = sizeof(corners.front());
    std::vector<std::uint32_t> remap(count);
    const std::size_t unique =
        meshopt_generateVertexRemap(remap.data(), nullptr, count, corners.data(), count, kSize);
    std::vector<std::uint32_t> index(count);
    meshopt_remapIndexBuffer(index.data(), nullptr, count, remap.data());
    std::vector<std::array<float, 3>> points(unique);
    meshopt_remapVertexBuffer(points.data(), corners.data(), count, kSize, remap.data());
    std::vector<std::uint32_t> result(count);
    meshopt_simplify(result.data(), index.data(), count, points.front().data(), unique, kSize,
                     3 * triangles, 1, 0, nullptr);
  }
};

struct Ratios {
  double call;
  double as_read;
};

/// Prints what it costs.
Ratios measure(const std::string& name, const TriangleMesh& mesh) {
  const std::size_t target = mesh.triangles.size() / 10;
  const Bare bare = welded_of(mesh);
  const Bare with_seams = with_seams_of(mesh);
  const AsRead as_read(mesh);
  rigor::mesh::Reduced reduced;
  std::vector<double> library;
  std::vector<double> whole;
  std::vector<double> ratio;
  std::vector<double> ratio_with_seams;
  std::vector<double> ratio_as_read;
  const auto begin = std::chrono::steady_clock::now();
  const auto enough = [&] {
    return library.size() >= kRounds &&
           std::chrono::steady_clock::now() - begin > std::chrono::duration<double>(kSeconds);
  };
  while (!enough()) {  // in turns, as its speed is not steady
    library.push_back(seconds([&] { bare.run(target); }));
    whole.push_back(seconds([&] { reduced = rigor::mesh::reduce(mesh, {.triangles = target}); }));
    ratio.push_back(whole.back() / library.back());
    ratio_with_seams.push_back(whole.back() / seconds([&] { with_seams.run(target); }));
    ratio_as_read.push_back(whole.back() / seconds([&] { as_read.run(target); }));
  }
  const rigor::mesh::Topology topology = rigor::mesh::topology_of(reduced.mesh);
  fmt::print(
      "{:<20} {:>8} to {:>6}: {:>6}  {:>7.1f} ms {:>7.1f} ms  ratio {:.2f}, with seams {:.2f}, as "
      "read {:.2f}\n",
      name, mesh.triangles.size(), target, reduced.mesh.triangles.size(), 1e3 * median(library),
      1e3 * median(whole), median(ratio), median(ratio_with_seams), median(ratio_as_read));
  fmt::print("    runs {}, open edges {}, of more than two triangles {}, error {:.3g}\n",
             reduced.runs, topology.boundary_edges, topology.nonmanifold_edges, reduced.error);
  return {median(ratio), median(ratio_as_read)};
}

/// The largest of the corpus, as in the test of reduction on real meshes.
std::vector<std::string> large_meshes(const char* corpus) {
  std::vector<std::pair<std::size_t, std::string>> large;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus)) {
    const std::string ending = entry.path().extension().string();
    const bool known = ending == ".stl" || ending == ".STL" || ending == ".dae";
    if (!known || entry.file_size() < 150'000) continue;
    const rigor::mesh::LoadedMesh loaded =
        rigor::mesh::read_mesh(rigor::RealDisk(), entry.path().string());
    if (loaded.usable()) large.emplace_back(loaded.mesh.triangles.size(), entry.path().string());
  }
  std::sort(large.rbegin(), large.rend());
  large.resize(std::min(large.size(), kLargeMeshes));
  std::vector<std::string> paths;
  for (const auto& [triangles, path] : large) paths.push_back(path);
  return paths;
}

void measure_corpus(const char* corpus) {
  std::vector<double> call;
  std::vector<double> as_read;
  for (const std::string& path : large_meshes(corpus)) {
    const Ratios of = measure(std::filesystem::path(path).filename().string(),
                              rigor::mesh::read_mesh(rigor::RealDisk(), path).mesh);
    call.push_back(of.call);
    as_read.push_back(of.as_read);
  }
  if (call.empty()) return;
  const auto worst = [](const std::vector<double>& list) {
    return *std::max_element(list.begin(), list.end());
  };
  fmt::print(
      "{} meshes of the corpus: median ratio {:.2f}, worst {:.2f}; as read {:.2f} and {:.2f}\n",
      call.size(), median(call), worst(call), median(as_read), worst(as_read));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) {
    const TriangleMesh mesh = rigor::mesh::read_mesh(rigor::RealDisk(), argv[1]).mesh;
    if (mesh.triangles.empty()) {
      fmt::print(stderr, "no triangles\n");
      return 1;
    }
    measure(std::filesystem::path(argv[1]).filename().string(), mesh);
    return 0;
  }
  measure("a bumpy ball", bumpy_ball());
  if (const char* corpus = std::getenv("RIGOR_CORPUS")) measure_corpus(corpus);
}
