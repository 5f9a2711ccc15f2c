// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The corpus of real model files that some tests run over, when it is there.

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace rigor::test {

/// The folder of real files, empty when there is none.
inline std::string corpus() {
  const char* folder = std::getenv("RIGOR_CORPUS");
  return folder == nullptr ? "" : folder;
}

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Every SDF, world, URDF and model.config file of the corpus, sorted.
inline std::vector<std::string> corpus_models() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus())) {
    std::string ending = entry.path().extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".sdf" || ending == ".world" || ending == ".urdf" ||
        entry.path().filename() == "model.config") {
      paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace rigor::test

/// Ends a test that needs the corpus where there is none, and says so.
#define RIGOR_NEEDS_CORPUS()                                                       \
  if (rigor::test::corpus().empty()) {                                             \
    GTEST_SKIP() << "RIGOR_CORPUS is not set: real model files are not looked at"; \
  }
