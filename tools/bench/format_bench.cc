// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev bench format`: how many files a second are formatted and compared with what they were, by one thread, of
// the models and templates of the corpus and of corpus-xacro beside it; and the same time as a ratio to bare
// tinyxml2's parse of these bytes. Files are held in memory.
//
//   rigor_format_bench

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <tinyxml2.h>

#include <rigor/author/format/formatted.h>
#include <rigor/schema/embedded.h>
#include <rigor/xml/document.h>

#include "measure.h"

namespace {

namespace fs = std::filesystem;
using rigor::bench::seconds;

constexpr int kRounds = 15;

void add_files(const fs::path& folder, std::vector<std::string>& files) {
  if (!fs::is_directory(folder)) return;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".sdf" && ending != ".world" && ending != ".urdf" && ending != ".xacro") continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    files.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
}

}  // namespace

int main() {
  const char* const corpus = std::getenv("RIGOR_CORPUS");
  if (corpus == nullptr) {
    fmt::print(stderr, "set RIGOR_CORPUS to a folder of model files\n");
    return 2;
  }
  std::vector<std::string> files;
  add_files(corpus, files);
  add_files(fs::path(corpus).parent_path() / "corpus-xacro", files);
  std::vector<double> bare;
  std::vector<double> ours;
  std::vector<double> ratios;
  std::size_t changed = 0;
  for (int round = 0; round < kRounds; ++round) {
    bare.push_back(seconds([&] {
      for (const std::string& bytes : files) {
        tinyxml2::XMLDocument document;
        document.Parse(bytes.data(), bytes.size());
      }
    }));
    changed = 0;
    ours.push_back(seconds([&] {
      for (const std::string& bytes : files) {
        const auto document = rigor::xml::parse(bytes, rigor::SourceId{0});
        changed += rigor::author::formatted(document, {}).edits.empty() ? 0 : 1;
      }
    }));
    ratios.push_back(ours.back() / bare.back());
  }
  const double median = rigor::bench::median(ours);
  fmt::print("{} files, {} would be formatted\n", files.size(), changed);
  fmt::print("bare tinyxml2   {:8.2f} ms\n", rigor::bench::median(bare) * 1e3);
  fmt::print("rigor fmt       {:8.2f} ms, {:.0f} files/s\n", median * 1e3,
             static_cast<double>(files.size()) / median);
  fmt::print("ratio           {:8.2f} of bare tinyxml2\n", rigor::bench::median(ratios));
}
