// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The xacro files of public repositories, as `corpus-xacro` beside the corpus holds them, against what the
// reference prints for each: `oracle/xacro.jsonl.gz`.

#include <gtest/gtest.h>
#include <zlib.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <rigor/author/fix.h>
#include <rigor/read/resolver.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/disk.h>
#include <rigor/text/path.h>
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

/// What lies beside the corpus of models; without rows where it does not.
struct XacroCorpus {
  std::string root =
      fs::weakly_canonical(fs::path(test::corpus()) / ".." / "corpus-xacro").string();
  std::vector<XacroJson> rows =
      fs::exists(root) ? xacro_answers(fs::path(root) / ".." / "oracle" / "xacro.jsonl.gz")
                       : std::vector<XacroJson>();
  XacroPackages packages = rows.empty() ? XacroPackages() : xacro_packages(root);
};

TEST(CorpusXacro, EveryExpansionIsTheReferences) {
  RIGOR_NEEDS_CORPUS();
  const XacroCorpus corpus;
  if (corpus.rows.empty()) GTEST_SKIP() << "there is no corpus-xacro beside the corpus";
  const auto& [root, rows, packages] = corpus;
  const RealDisk disk;
  for (const XacroJson& row : rows) {
    const std::string path = row["path"];
    xacro::World world{disk};
    world.find_package = [&path, &packages = packages](std::string_view name, std::string_view) {
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

/// Real files, one of them with other bytes.
class DiskWithOneFix final : public Disk {
 public:
  DiskWithOneFix(std::string path, std::string bytes)
      : path_(std::move(path)), bytes_(std::move(bytes)) {}

  std::unique_ptr<OpenFile> open(const std::string& path) const override {
    return disk_.open(path);
  }
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override {
    if (normalize_path(path) == path_) return {bytes_, {}};
    return disk_.read(path, max_bytes);
  }
  PathKind kind(const std::string& path) const override { return disk_.kind(path); }
  std::vector<std::string> list(const std::string& folder) const override {
    return disk_.list(folder);
  }

 private:
  RealDisk disk_;
  std::string path_;
  std::string bytes_;
};

/// With the defaults of its arguments.
xacro::Expansion expansion_of(const std::string& file, const std::string& repository,
                              const XacroPackages& packages, const Disk& disk, Sources& sources) {
  xacro::World world{disk};
  world.find_package = [&](std::string_view name, std::string_view) {
    return find_xacro_package(packages, repository, std::string(name));
  };
  return xacro::expand(file, world, {}, sources);
}

/// The name of the first link of a robot; empty where there is none.
std::string first_link(const xacro::Node& root) {
  for (const xacro::Node* child = root.first_element(); child != nullptr;
       child = child->next_element()) {
    const xacro::NodeAttribute* name = child->attribute("name");
    if (child->name == "link" && name != nullptr) return std::string(name->value);
  }
  return {};
}

/// A link on a continuous joint, as a template has it and as xacro prints it.
std::string planted_joint(const std::string& parent, const std::string& axis) {
  return "  <link name=\"planted_link\"/>\n"
         "  <joint name=\"planted_joint\" type=\"continuous\">\n"
         "    <parent link=\"" +
         parent +
         "\"/>\n"
         "    <child link=\"planted_link\"/>\n"
         "    <axis xyz=\"" +
         axis +
         "\"/>\n"
         "  </joint>\n";
}

/// Into copies of real robots a joint is planted whose axis has the length 2, which has a safe fix. With
/// `--fix` the axis is a unit vector, no other byte of the file differs, and neither does any other of the
/// expansion.
TEST(CorpusXacro, FixesChangeNothingElseInAnyExpansion) {
  RIGOR_NEEDS_CORPUS();
  const XacroCorpus corpus;
  if (corpus.rows.empty()) GTEST_SKIP() << "there is no corpus-xacro beside the corpus";
  const auto& [root, rows, packages] = corpus;
  const RealDisk real;
  constexpr std::size_t kMaxRobots = 45;
  std::size_t fixed = 0;
  std::set<std::string> done;
  for (const XacroJson& row : rows) {
    const std::string path = row["path"];
    if (fixed == kMaxRobots) break;
    if (row["rc"] != 0 || row["links"] == 0 || !row["args"].empty() || !done.insert(path).second)
      continue;
    const std::string file = root + '/' + path;
    const std::string repository = path.substr(0, path.find('/'));
    Sources sources;
    const xacro::Expansion before = expansion_of(file, repository, packages, real, sources);
    ASSERT_TRUE(before.ok()) << path;
    const std::string parent = first_link(*before.root);
    std::string planted = test::read_file(file);
    const std::size_t end = planted.rfind("</robot>");
    if (parent.empty() || end == std::string::npos) continue;
    planted.insert(end, planted_joint(parent, "0 0 2"));
    std::string mended = planted;
    mended.replace(mended.find("0 0 2", end), 5, "0 0 1");

    const DiskWithOneFix disk(normalize_path(file), planted);
    read::SearchPaths paths;
    if (const auto own = packages.find(repository); own != packages.end())
      paths.packages = own->second;
    for (const auto& [other, folders] : packages)
      paths.packages.insert(folders.begin(), folders.end());
    const Environment environment(disk, paths);
    const rules::ValidateOptions options{.paths = {file}, .meshes = rules::MeshPolicy::kDoNotOpen};
    Sources found_in;
    const rules::ValidateResult result = rules::validate(environment, options, found_in);
    const auto fixes =
        author::fix_files(environment, options, result, found_in, Applicability::kSafe);
    ASSERT_EQ(fixes.size(), 1U) << path;
    EXPECT_EQ(fixes.front().after, mended) << path;

    const DiskWithOneFix fixed_disk(normalize_path(file), fixes.front().after);
    const xacro::Expansion after = expansion_of(file, repository, packages, fixed_disk, sources);
    ASSERT_TRUE(after.ok()) << path;
    std::string text = xacro::print(*after.document, file);
    const std::string shown = planted_joint(parent, "0 0 1");
    const std::size_t at = text.find(shown);
    ASSERT_NE(at, std::string::npos) << path;
    EXPECT_EQ(text.erase(at, shown.size()), xacro::print(*before.document, file)) << path;
    ++fixed;
  }
  EXPECT_GE(fixed, 30U);
  std::printf("%zu templates fixed\n", fixed);
}

/// An axis that an included file writes as one of the unit vectors: of the first movable joint of a robot
/// that has such a one.
std::optional<Span> included_axis(const xacro::Expansion& expansion, const Sources& sources) {
  const SourceId own = expansion.files.front().source;
  for (const xacro::Node* joint = expansion.root->first_element(); joint != nullptr;
       joint = joint->next_element()) {
    const xacro::NodeAttribute* type = joint->attribute("type");
    if (joint->name != "joint" || type == nullptr || type->value == "fixed") continue;
    for (const xacro::Node* child = joint->first_element(); child != nullptr;
         child = child->next_element()) {
      const xacro::NodeAttribute* xyz = child->attribute("xyz");
      if (child->name != "axis" || xyz == nullptr || !xyz->where.verbatim) continue;
      const Span where = xyz->where.span;
      const std::string_view written = sources.bytes(where);
      const bool is_unit = written == "1 0 0" || written == "0 1 0" || written == "0 0 1";
      if (is_unit && where.source != own) return where;
    }
  }
  return std::nullopt;
}

/// In files that robots include an axis becomes twice as long. `--fix` of the folder gives the file's former
/// bytes back, and leaves all others alone.
TEST(CorpusXacro, FixesOfIncludedFilesGiveTheirBytesBack) {
  RIGOR_NEEDS_CORPUS();
  const XacroCorpus corpus;
  if (corpus.rows.empty()) GTEST_SKIP() << "there is no corpus-xacro beside the corpus";
  const auto& [root, rows, packages] = corpus;
  const RealDisk real;
  std::set<std::string> done;
  for (const XacroJson& row : rows) {
    const std::string path = row["path"];
    const std::string repository = path.substr(0, path.find('/'));
    if (row["rc"] != 0 || row["links"] == 0 || !row["args"].empty() || done.contains(repository))
      continue;
    Sources sources;
    const xacro::Expansion made =
        expansion_of(root + '/' + path, repository, packages, real, sources);
    const auto axis = made.ok() ? included_axis(made, sources) : std::nullopt;
    if (!axis) continue;
    // What another repository holds is not among the files that are named.
    const std::string included = normalize_path(sources.path(axis->source));
    if (!included.starts_with(root + '/' + repository + '/')) continue;
    done.insert(repository);
    const std::string before(sources.bytes(axis->source));
    std::string planted = before;
    planted[planted.find('1', axis->begin)] = '2';

    const DiskWithOneFix disk(included, planted);
    read::SearchPaths paths;
    if (const auto own = packages.find(repository); own != packages.end())
      paths.packages = own->second;
    for (const auto& [other, folders] : packages)
      paths.packages.insert(folders.begin(), folders.end());
    const Environment environment(disk, paths);
    const rules::ValidateOptions options{.paths = {root + '/' + repository},
                                         .selection = {.select = {"axis-not-unit"}},
                                         .meshes = rules::MeshPolicy::kDoNotOpen};
    Sources found_in;
    const rules::ValidateResult result = rules::validate(environment, options, found_in);
    const auto fixes =
        author::fix_files(environment, options, result, found_in, Applicability::kSafe);
    ASSERT_EQ(fixes.size(), 1U) << included << " of " << path;
    EXPECT_EQ(normalize_path(fixes.front().path), included);
    EXPECT_EQ(fixes.front().after, before) << included;
  }
  EXPECT_GE(done.size(), 8U);
  std::printf("%zu included files fixed\n", done.size());
}

}  // namespace
}  // namespace rigor
