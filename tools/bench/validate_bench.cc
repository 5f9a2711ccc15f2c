// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev bench`: how long `validate` takes for real files, as a ratio to bare tinyxml2's parse of
// the same bytes in the same process, and to reading them into models without a rule. Files are held in
// memory and meshes are left out (`--no-mesh`); one thread.
//
//   rigor_bench [SET]     a folder of RIGOR_CORPUS, default gazebo_models

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <tinyxml2.h>

#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

#include "measure.h"

namespace {

namespace fs = std::filesystem;
using rigor::bench::median;
using rigor::bench::seconds;

/// Repetitions of each side, in turn. A ratio is taken of each turn, as a drift of the machine's speed
/// meets all sides of one.
constexpr int kRounds = 41;

void parse_bare(const std::map<std::string, std::string>& files,
                const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    const std::string& bytes = files.at(path);
    tinyxml2::XMLDocument document;
    document.Parse(bytes.data(), bytes.size());
  }
}

/// What the reader finds of the schema, without words.
void check_schema(const rigor::Environment& environment, const rigor::read::Loaded& loaded) {
  const auto& document = loaded.file->document;
  if (!document || !document->root()) return;
  const bool urdf = loaded.root.format == rigor::model::Format::kUrdf;
  const auto node = (urdf ? environment.urdf : environment.sdf)
                        .root(document->root()->name(), {loaded.root.version});
  if (node) rigor::read::check_conformance(*document, *node, [](const rigor::read::SchemaFact&) {});
}

void read_only(const rigor::Environment& environment, const std::vector<std::string>& paths,
               bool schema) {
  rigor::Sources sources;
  rigor::read::Workspace workspace(environment.disk, sources);
  const rigor::read::Reader reader{workspace, environment.resolver, environment.sdf,
                                   environment.urdf};
  for (const std::string& path : paths) {
    const rigor::read::Loaded loaded = rigor::read::load(reader, workspace.open(path));
    const rigor::model::Frames frames(loaded.root);
    if (schema) check_schema(environment, loaded);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const char* corpus = std::getenv("RIGOR_CORPUS");
  if (corpus == nullptr) {
    fmt::print(stderr, "set RIGOR_CORPUS to a folder of model files\n");
    return 2;
  }
  const fs::path set = fs::path(corpus) / (argc > 1 ? argv[1] : "gazebo_models");
  std::map<std::string, std::string> files;
  std::vector<std::string> paths;
  std::size_t bytes = 0;
  const auto add = [&](const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    const std::string name = fs::relative(path, set.parent_path()).generic_string();
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    const std::string ending = path.extension().string();
    const bool checked = ending == ".sdf" || ending == ".world" || ending == ".urdf";
    if (checked) {
      paths.push_back(name);
      bytes += text.size();
    }
    // Meshes are there to be found, not to be read.
    files[name] = checked || path.filename() == "model.config" ? std::move(text) : std::string();
  };
  if (fs::is_directory(set)) {
    for (const auto& entry : fs::recursive_directory_iterator(set)) {
      if (entry.is_regular_file()) add(entry.path());
    }
  } else {
    add(set);
  }
  std::sort(paths.begin(), paths.end());

  const rigor::MemoryDisk disk(files);
  rigor::read::SearchPaths search;
  search.given.push_back({set.filename().string(), "--model-path"});
  const rigor::Environment environment(disk, search);
  std::vector<double> bare;
  std::vector<double> read;
  std::vector<double> checked;
  std::vector<double> ours;
  std::size_t found = 0;
  for (int round = 0; round < kRounds; ++round) {
    bare.push_back(seconds([&] { parse_bare(files, paths); }));
    read.push_back(seconds([&] { read_only(environment, paths, false); }));
    checked.push_back(seconds([&] { read_only(environment, paths, true); }));
    ours.push_back(seconds([&] {
      rigor::Sources sources;
      const auto result = rigor::rules::validate(
          environment, {.paths = paths, .meshes = rigor::rules::MeshPolicy::kLeaveOut}, sources);
      found = result.diagnostics.list().size();
    }));
  }
  const auto ratio = [&ours](const std::vector<double>& to) {
    std::vector<double> ratios;
    std::transform(ours.begin(), ours.end(), to.begin(), std::back_inserter(ratios),
                   std::divides<>());
    return median(std::move(ratios));
  };
  fmt::print("{} files, {:.2f} MB, {} findings\n", paths.size(), double(bytes) / 1e6, found);
  fmt::print("bare tinyxml2   {:8.2f} ms\n", median(bare) * 1e3);
  fmt::print("reading alone   {:8.2f} ms, with the schema {:.2f} ms\n", median(read) * 1e3,
             median(checked) * 1e3);
  fmt::print("rigor validate  {:8.2f} ms\n", median(ours) * 1e3);
  fmt::print(
      "ratio           {:8.2f} of bare tinyxml2, {:.2f} of reading alone, {:.2f} with schema\n",
      ratio(bare), ratio(read), ratio(checked));
}
