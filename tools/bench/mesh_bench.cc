// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev bench mesh`: a closed binary STL of a million triangles read and examined for all that
// can be wrong with its topology, as a ratio to admesh's check of the same file; and the search for
// self-intersections in one of 100,000, to be held beside cgal_self_intersection.cc.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <unistd.h>

#include <fmt/core.h>

#include <rigor/mesh/read.h>
#include <rigor/mesh/spatial/self_intersection.h>
#include <rigor/mesh/topology/topology.h>
#include <rigor/text/disk.h>

#include "measure.h"

namespace {

using rigor::bench::child;
using rigor::bench::Cost;
using rigor::bench::median;

constexpr int kRounds = 9;

void check(const std::string& path) {
  const rigor::RealDisk disk;
  if (!rigor::mesh::topology_of(rigor::mesh::read_mesh(disk, path).mesh).closed()) ::_exit(1);
}

void check_topology(const std::string& path) {
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
  const bool has_admesh = std::system("command -v admesh >/dev/null") == 0;
  std::vector<double> ours;
  std::vector<double> admesh;
  long memory = 0;
  for (int round = 0; round < kRounds; ++round) {
    const Cost cost = child([&] { check(path); });
    ours.push_back(cost.seconds);
    memory = std::max(memory, cost.kilobytes);
    if (has_admesh) {
      admesh.push_back(child([&] { rigor::bench::run_program({"admesh", path}); }).seconds);
    }
  }
  fmt::print("1,000,000 triangles, {:.1f} MB\n", megabytes);
  fmt::print("rigor topology  {:8.2f} ms\n", median(ours) * 1e3);
  fmt::print("peak memory     {:8.2f} of the file's size\n",
             static_cast<double>(memory) / 1e3 / megabytes);
  if (!has_admesh) return fmt::print("admesh is not installed\n");
  fmt::print("admesh          {:8.2f} ms\n", median(admesh) * 1e3);
  fmt::print("admesh / rigor  {:8.2f}\n", median(admesh) / median(ours));
}

void check_self_intersection(const std::string& path, const char* yardstick) {
  const rigor::RealDisk disk;
  const rigor::mesh::LoadedMesh loaded = rigor::mesh::read_mesh(disk, path);
  std::vector<double> ours;
  std::uint64_t pairs = 0;
  for (int round = 0; round < kRounds; ++round) {
    const auto begin = std::chrono::steady_clock::now();
    pairs = rigor::mesh::self_intersections(loaded.mesh).pairs;
    ours.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  fmt::print("100,000 triangles, self-intersections\n");
  fmt::print("rigor           {:8.2f} ms, {} pairs\n",
             *std::min_element(ours.begin(), ours.end()) * 1e3, pairs);
  if (yardstick == nullptr) return fmt::print("CGAL is not installed\n");
  fmt::print("CGAL            ");
  std::fflush(stdout);
  if (std::system((std::string(yardstick) + " " + path).c_str()) != 0) std::exit(1);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string path = std::filesystem::temp_directory_path() / "rigor_mesh_bench.stl";
  rigor::bench::write_torus(path, 1000, 500);
  check_topology(path);
  rigor::bench::write_torus(path, 400, 125);
  check_self_intersection(path, argc > 1 ? argv[1] : nullptr);
  std::filesystem::remove(path);
}
