// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The xacro files of public repositories, as `corpus-xacro` beside the corpus holds them, against what the
// reference prints for each: `oracle/xacro.jsonl.gz`.

#include <gtest/gtest.h>
#include <zlib.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include <rigor/text/disk.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/expand.h>
#include <rigor/xacro/print.h>

#include "support/corpus.h"

namespace rigor {
namespace {

namespace fs = std::filesystem;
using XacroJson = nlohmann::json;

std::vector<XacroJson> xacro_answers(const fs::path& path) {
  std::string text;
  if (gzFile file = gzopen(path.c_str(), "rb")) {
    std::string block(1U << 16U, '\0');
    for (int got = 0;
         (got = gzread(file, block.data(), static_cast<unsigned>(block.size()))) > 0;) {
      text.append(block, 0, static_cast<std::size_t>(got));
    }
    gzclose(file);
  }
  std::vector<XacroJson> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) rows.push_back(XacroJson::parse(line));
  return rows;
}

/// Folders of packages, by repository.
using XacroPackages = std::map<std::string, std::map<std::string, std::string>>;

XacroPackages xacro_packages(const fs::path& root) {
  XacroPackages packages;
  const std::regex name("<name>\\s*([^<\\s]+)\\s*</name>");
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().filename() != "package.xml") continue;
    const std::string text = test::read_file(entry.path());
    std::smatch found;
    if (!std::regex_search(text, found, name)) continue;
    const std::string repository = fs::relative(entry.path(), root).begin()->string();
    std::string& folder = packages[repository][found[1]];
    const std::string here = entry.path().parent_path().string();
    if (folder.empty() || here > folder) folder = here;
  }
  return packages;
}

/// In the same repository first, else in the first that has it.
std::optional<std::string> find_xacro_package(const XacroPackages& packages,
                                              const std::string& repository,
                                              const std::string& name) {
  if (const auto own = packages.find(repository); own != packages.end()) {
    if (const auto found = own->second.find(name); found != own->second.end()) return found->second;
  }
  for (const auto& [other, folders] : packages) {
    if (const auto found = folders.find(name); found != folders.end()) return found->second;
  }
  return std::nullopt;
}

std::string with_root(std::string text, const std::string& root) {
  for (std::size_t at = 0; (at = text.find("@ROOT@", at)) != std::string::npos;) {
    text.replace(at, 6, root);
    at += root.size();
  }
  return text;
}

TEST(CorpusXacro, EveryExpansionIsTheReferences) {
  RIGOR_NEEDS_CORPUS();
  const fs::path beside = fs::path(test::corpus()) / "..";
  const std::string root = fs::weakly_canonical(beside / "corpus-xacro").string();
  const std::vector<XacroJson> rows = xacro_answers(beside / "oracle" / "xacro.jsonl.gz");
  if (rows.empty() || !fs::exists(root))
    GTEST_SKIP() << "there is no corpus-xacro beside the corpus";
  const XacroPackages packages = xacro_packages(root);
  const RealDisk disk;
  for (const XacroJson& row : rows) {
    const std::string path = row["path"];
    xacro::World world{disk};
    world.find_package = [&](std::string_view name, std::string_view) {
      return find_xacro_package(packages, path.substr(0, path.find('/')), std::string(name));
    };
    xacro::Options options;
    for (const std::string argument : row["args"]) {
      const std::size_t assign = argument.find(":=");
      if (assign + 2 == argument.size()) continue;
      options.arguments.emplace_back(argument.substr(0, assign), argument.substr(assign + 2));
    }
    Sources sources;
    const std::string file = root + '/' + path;
    const xacro::Expansion expansion = xacro::expand(file, world, options, sources);
    if (row["rc"] != 0) {
      EXPECT_FALSE(expansion.ok()) << path << ' ' << row["args"];
      for (const xacro::Fact& fact : expansion.facts) {
        EXPECT_FALSE(xacro::is_error(fact.kind) && fact.where.nowhere()) << path;
      }
      continue;
    }
    ASSERT_NE(expansion.document, nullptr) << path;
    EXPECT_EQ(xacro::print(*expansion.document, file), with_root(row["text"], root))
        << path << ' ' << row["args"];
    EXPECT_TRUE(expansion.ok()) << path << ' ' << row["args"];
  }
}

}  // namespace
}  // namespace rigor
