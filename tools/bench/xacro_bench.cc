// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Expands and prints templates in this process, as `tools/bench/xacro_bench.py` asks on the standard
// input: lines of words between tabs, `package NAME FOLDER` and then `robot FILE name:=value …`. Answers
// each robot with the milliseconds of processor time of the fastest of its runs.

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <malloc.h>
#include <time.h>

#include <fmt/core.h>

#include <rigor/text/disk.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/expand.h>
#include <rigor/xacro/print.h>

namespace {

constexpr int kRuns = 7;

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  for (std::size_t tab = line.find('\t'); tab != std::string::npos; tab = line.find('\t', begin)) {
    words.push_back(line.substr(begin, tab - begin));
    begin = tab + 1;
  }
  words.push_back(line.substr(begin));
  return words;
}

/// Spent by this process so far: what else the machine does is no part of it.
double processor_milliseconds() {
  timespec spent{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &spent);
  return static_cast<double>(spent.tv_sec) * 1e3 + static_cast<double>(spent.tv_nsec) * 1e-6;
}

/// Reading the files, the expansion and its text; nothing when it fails.
std::optional<double> milliseconds(const std::string& file, const rigor::xacro::World& world,
                                   const rigor::xacro::Options& options) {
  const double begin = processor_milliseconds();
  rigor::Sources sources;
  const rigor::xacro::Expansion expansion = rigor::xacro::expand(file, world, options, sources);
  if (!expansion.ok()) return std::nullopt;
  const std::string text = rigor::xacro::print(*expansion.document, file);
  const double end = processor_milliseconds();
  if (text.empty()) return std::nullopt;
  return end - begin;
}

}  // namespace

int main() {
  // As `rigor lsp` has it: memory is kept from one expansion to the next, as Python keeps its own.
#ifdef __GLIBC__
  constexpr int kKeptBytes = 96 << 20;
  mallopt(M_MMAP_THRESHOLD, kKeptBytes);
  mallopt(M_TRIM_THRESHOLD, kKeptBytes);
#endif
  std::map<std::string, std::string, std::less<>> packages;
  const rigor::RealDisk disk;
  rigor::xacro::World world{disk};
  world.find_package = [&packages](std::string_view name,
                                   std::string_view) -> std::optional<std::string> {
    const auto found = packages.find(name);
    return found == packages.end() ? std::nullopt : std::optional(found->second);
  };
  for (std::string line; std::getline(std::cin, line);) {
    const std::vector<std::string> words = words_of(line);
    if (words.size() == 3 && words[0] == "package") packages[words[1]] = words[2];
    if (words.size() < 2 || words[0] != "robot") continue;
    rigor::xacro::Options options;
    for (std::size_t i = 2; i < words.size(); ++i) {
      const std::size_t assign = words[i].find(":=");
      if (assign == std::string::npos || assign + 2 == words[i].size()) continue;
      options.arguments.emplace_back(words[i].substr(0, assign), words[i].substr(assign + 2));
    }
    std::optional<double> fastest;
    for (int run = 0; run < kRuns; ++run) {
      const std::optional<double> time = milliseconds(words[1], world, options);
      if (!time) break;
      fastest = std::min(fastest.value_or(*time), *time);
    }
    fmt::print("{}\n", fastest ? fmt::format("{:.4f}", *fastest) : "failed");
    std::fflush(stdout);
  }
}
