// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev bench view`: how long `rigor view` takes for a model of the corpus, the whole command with pictures, and
// how large the pages are. Every file that is a
// robot model makes a page; one that does not ends in 1.
//
//   rigor_view_bench RIGOR_BINARY [SET]

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/core.h>

#include <rigor/read/discover.h>
#include <rigor/text/disk.h>
#include <rigor/text/path.h>

#include "measure.h"

namespace {

namespace fs = std::filesystem;

/// What one page cost. CPU time, since others may be at work on this machine.
struct PageCost {
  double elapsed = 0;  ///< s
  double cpu = 0;      ///< s
  std::uintmax_t bytes = 0;
  bool made = false;
  bool is_model = true;
};

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

PageCost page_cost(const char* rigor, const std::string& model, const std::string& out) {
  std::error_code ignored;
  fs::remove(out, ignored);
  const auto begin = std::chrono::steady_clock::now();
  const pid_t pid = ::fork();
  if (pid == 0) {
    if (std::freopen("/dev/null", "w", stderr) == nullptr) ::_exit(1);
    rigor::bench::run_program({rigor, "view", model, "-o", out});
  }
  int status = 0;
  rusage usage{};
  ::wait4(pid, &status, 0, &usage);
  PageCost cost;
  cost.elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  cost.cpu = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  cost.made = status == 0;
  cost.is_model = !WIFEXITED(status) || WEXITSTATUS(status) != 1;
  if (cost.made) cost.bytes = fs::file_size(out, ignored);
  return cost;
}

void print_row(const char* what, std::vector<double> values, const char* unit) {
  std::sort(values.begin(), values.end());
  fmt::print("{:12} median {:8.3f}  90 % {:8.3f}  most {:8.3f} {}\n", what,
             rigor::bench::median(values), values[values.size() * 9 / 10], values.back(), unit);
}

}  // namespace

int main(int argc, char** argv) {
  const char* corpus = std::getenv("RIGOR_CORPUS");
  if (corpus == nullptr || argc < 2) {
    fmt::print(stderr, "RIGOR_CORPUS is not set, or the program is not named\n");
    return 2;
  }
  const fs::path set = argc > 2 ? fs::path(corpus) / argv[2] : fs::path(corpus);
  const std::string out = fs::temp_directory_path() / "rigor_view_bench.html";
  const rigor::RealDisk disk;
  std::vector<double> elapsed;
  std::vector<double> cpu;
  std::vector<double> megabytes;
  int failures = 0;
  for (const std::string& model : rigor::read::discover(disk, {set.string()}).files) {
    if (rigor::file_name(model) == "model.config") continue;
    const PageCost cost = page_cost(argv[1], model, out);
    if (!cost.made) {
      fmt::print("{}: {}\n", model, cost.is_model ? "no page" : "no robot model");
      failures += cost.is_model ? 1 : 0;
      continue;
    }
    elapsed.push_back(cost.elapsed);
    cpu.push_back(cost.cpu);
    megabytes.push_back(static_cast<double>(cost.bytes) / 1e6);
  }
  fs::remove(out);
  if (elapsed.empty()) return 1;
  fmt::print("{} pages, {} models without one\n", elapsed.size(), failures);
  print_row("elapsed", elapsed, "s");
  print_row("CPU", cpu, "s");
  print_row("size", megabytes, "MB");
  return failures == 0 ? 0 : 1;
}
