// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev bench inertia`: the whole command on a closed binary STL of a million triangles, as a
// ratio to a process that only reads the file into memory, and the peak memory of both.
//
//   rigor_inertia_bench RIGOR_BINARY

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/core.h>

namespace {

constexpr int kRounds = 15;

/// A torus of 1000 by 500 cells.
void write_torus(const std::string& path) {
  constexpr std::uint32_t kAround = 1000;
  constexpr std::uint32_t kAcross = 500;
  constexpr double kTau = 6.283185307179586;
  const auto corner = [](std::uint32_t i, std::uint32_t j) {
    const double u = kTau * (i % kAround) / kAround;
    const double v = kTau * (j % kAcross) / kAcross;
    const double r = 0.2 + 0.06 * std::cos(v);
    return std::array<float, 3>{static_cast<float>(r * std::cos(u)),
                                static_cast<float>(r * std::sin(u)),
                                static_cast<float>(0.06 * std::sin(v))};
  };
  std::FILE* file = std::fopen(path.c_str(), "wb");
  const std::array<char, 80> header{};
  const std::uint32_t count = 2 * kAround * kAcross;
  std::fwrite(header.data(), 1, header.size(), file);
  std::fwrite(&count, 4, 1, file);
  const auto facet = [file](std::array<std::array<float, 3>, 4> normal_and_corners) {
    const std::uint16_t attribute = 0;
    std::fwrite(normal_and_corners.data(), 12, 4, file);
    std::fwrite(&attribute, 2, 1, file);
  };
  for (std::uint32_t i = 0; i < kAround; ++i) {
    for (std::uint32_t j = 0; j < kAcross; ++j) {
      facet({{{}, corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)}});
      facet({{{}, corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)}});
    }
  }
  std::fclose(file);
}

struct Cost {
  double seconds;
  long kilobytes;
};

/// Of a child process that does `work` and is gone.
Cost child(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  const pid_t pid = ::fork();
  if (pid == 0) {
    work();
    ::_exit(0);
  }
  int status = 0;
  rusage usage{};
  ::wait4(pid, &status, 0, &usage);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (status != 0) {
    fmt::print(stderr, "the child failed\n");
    std::exit(1);
  }
  return {seconds, usage.ru_maxrss};
}

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

void run_rigor(const std::string& binary, const std::string& path) {
  ::close(STDOUT_FILENO);
  ::open("/dev/null", O_WRONLY);
  ::execl(binary.c_str(), "rigor", "inertia", "mesh", path.c_str(), "--mass", "1", nullptr);
  ::_exit(1);
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + kRounds / 2, values.end());
  return values[kRounds / 2];
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string path = std::filesystem::temp_directory_path() / "rigor_inertia_bench.stl";
  write_torus(path);
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
  std::vector<double> plain;
  std::vector<double> ours;
  long memory = 0;
  for (int round = 0; round < kRounds; ++round) {
    plain.push_back(child([&] { read_whole(path); }).seconds);
    const Cost cost = child([&] { run_rigor(argv[1], path); });
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
