// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the benchmarks share: a mesh to measure with, and what a piece of work or a child process costs.

#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/core.h>

namespace rigor::bench {

/// A torus of `around` by `across` cells, of two triangles each, as a binary STL.
inline void write_torus(const std::string& path, std::uint32_t around, std::uint32_t across) {
  constexpr double kTau = 6.283185307179586;
  const auto corner = [around, across](std::uint32_t i, std::uint32_t j) {
    const double u = kTau * (i % around) / around;
    const double v = kTau * (j % across) / across;
    const double r = 0.2 + 0.06 * std::cos(v);
    return std::array<float, 3>{static_cast<float>(r * std::cos(u)),
                                static_cast<float>(r * std::sin(u)),
                                static_cast<float>(0.06 * std::sin(v))};
  };
  std::FILE* file = std::fopen(path.c_str(), "wb");
  const std::array<char, 80> header{};
  const std::uint32_t count = 2 * around * across;
  std::fwrite(header.data(), 1, header.size(), file);
  std::fwrite(&count, 4, 1, file);
  const auto facet = [file](std::array<std::array<float, 3>, 4> normal_and_corners) {
    const std::uint16_t attribute = 0;
    std::fwrite(normal_and_corners.data(), 12, 4, file);
    std::fwrite(&attribute, 2, 1, file);
  };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
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
inline Cost child(const std::function<void()>& work) {
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

/// Does not come back. What the program prints is thrown away.
inline void run_program(const std::vector<std::string>& words) {
  ::close(STDOUT_FILENO);
  ::open("/dev/null", O_WRONLY);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ::execvp(arguments.front(), arguments.data());
  ::_exit(1);
}

inline double seconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

inline double median(std::vector<double> values) {
  const std::size_t half = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(half),
                   values.end());
  return values[half];
}

}  // namespace rigor::bench
