// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev bench inertia`: the whole command on a closed binary STL of a million triangles, as a
// ratio to a process that only reads the file into memory, and the peak memory of both.
//
//   rigor_inertia_bench RIGOR_BINARY

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/core.h>

#include "measure.h"

namespace {

using rigor::bench::child;
using rigor::bench::Cost;
using rigor::bench::median;

constexpr int kRounds = 15;

void read_whole(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY);
  struct stat status {};
  ::fstat(file, &status);
  const auto size = static_cast<std::size_t>(status.st_size);
  char* bytes = static_cast<char*>(std::malloc(size));
  for (std::size_t done = 0; done < size;) {
    const ssize_t got = ::read(file, bytes + done, size - done);
    if (got <= 0) ::_exit(1);
    done += static_cast<std::size_t>(got);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string path = std::filesystem::temp_directory_path() / "rigor_inertia_bench.stl";
  rigor::bench::write_torus(path, 1000, 500);
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
  std::vector<double> plain;
  std::vector<double> ours;
  long memory = 0;
  for (int round = 0; round < kRounds; ++round) {
    plain.push_back(child([&] { read_whole(path); }).seconds);
    const Cost cost = child([&] {
      rigor::bench::run_program({argv[1], "inertia", "mesh", path, "--mass", "1"});
    });
    ours.push_back(cost.seconds);
    memory = std::max(memory, cost.kilobytes);
  }
  std::filesystem::remove(path);
  fmt::print("1,000,000 triangles, {:.1f} MB\n", megabytes);
  fmt::print("plain read      {:8.2f} ms\n", median(plain) * 1e3);
  fmt::print("rigor inertia   {:8.2f} ms\n", median(ours) * 1e3);
  fmt::print("ratio           {:8.2f}\n", median(ours) / median(plain));
  fmt::print("peak memory     {:8.2f} of the file's size\n", double(memory) / 1e3 / megabytes);
}
