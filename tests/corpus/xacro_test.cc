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

using XacroRanges = std::vector<std::pair<std::size_t, std::size_t>>;

/// Where the bytes of edits are, before and after they are done.
std::pair<XacroRanges, XacroRanges> ranges_of(std::vector<Edit> edits) {
  std::sort(edits.begin(), edits.end(),
            [](const Edit& a, const Edit& b) { return a.span.begin < b.span.begin; });
  XacroRanges before;
  XacroRanges after;
  std::ptrdiff_t shift = 0;
  for (const Edit& edit : edits) {
    before.emplace_back(edit.span.begin, edit.span.end);
    const auto begin = static_cast<std::size_t>(edit.span.begin + shift);
    after.emplace_back(begin, begin + edit.text.size());
    shift += static_cast<std::ptrdiff_t>(edit.text.size()) - edit.span.size();
  }
  return {before, after};
}

/// The elements and texts of an expansion that no edit of `file` touches, one a line.
void print_untouched(const xacro::Node& node, std::string_view file, const XacroRanges& edited,
                     const Sources& sources, std::string& out) {
  const Span where = node.where.span;
  const bool is_there = !where.nowhere() && sources.path(where.source) == file;
  const bool touched =
      is_there && std::any_of(edited.begin(), edited.end(), [where](const auto& range) {
        return range.first <= where.end && where.begin <= range.second;
      });
  const bool blank = node.kind == xacro::NodeKind::kText &&
                     node.text.find_first_not_of(" \t\r\n") == std::string_view::npos;
  if (!touched && !blank) {
    out += std::string(node.name) + ' ' + std::string(node.text);
    for (const xacro::NodeAttribute& attribute : node.attributes)
      out += ' ' + std::string(attribute.name) + '=' + std::string(attribute.value);
    out += '\n';
  }
  for (const xacro::Node* child = node.first; child != nullptr; child = child->next)
    print_untouched(*child, file, edited, sources, out);
}

/// `--fix` over the robots, and every expansion that reads a file which it changed.
TEST(CorpusXacro, FixesChangeNothingElseInAnyExpansion) {
  RIGOR_NEEDS_CORPUS();
  const XacroCorpus corpus;
  if (corpus.rows.empty()) GTEST_SKIP() << "there is no corpus-xacro beside the corpus";
  const auto& [root, rows, packages] = corpus;
  const RealDisk disk;
  std::set<std::string> robots;
  for (const XacroJson& row : rows) {
    if (row["links"] > 0) robots.insert(root + '/' + row["path"].get<std::string>());
  }
  const Environment environment(disk, {});
  Sources found_in;
  const rules::ValidateOptions options{.paths = {robots.begin(), robots.end()}, .threads = 0};
  const rules::ValidateResult result = rules::validate(environment, options, found_in);
  std::size_t fixed = 0;
  std::size_t expansions = 0;
  for (const author::FixedFile& file :
       author::fix_files(environment, options, result, found_in, Applicability::kUnsafe)) {
    if (!file.changed()) continue;
    ++fixed;
    const auto [before, after] = ranges_of(file.edits);
    const DiskWithOneFix fixed_disk(normalize_path(file.path), file.after);
    const std::string repository = file.path.substr(root.size() + 1);
    for (const XacroJson& row : rows) {
      const std::string path = row["path"];
      const std::string own = path.substr(0, path.find('/'));
      if (row["rc"] != 0 || !repository.starts_with(own + '/')) continue;
      std::string texts[2];
      bool reads_it = false;
      for (const bool is_fixed : {false, true}) {
        xacro::World world{is_fixed ? static_cast<const Disk&>(fixed_disk) : disk};
        world.find_package = [&](std::string_view name, std::string_view) {
          return find_xacro_package(packages, own, std::string(name));
        };
        xacro::Options arguments;
        for (const std::string argument : row["args"]) {
          const std::size_t assign = argument.find(":=");
          if (assign + 2 == argument.size()) continue;
          arguments.arguments.emplace_back(argument.substr(0, assign), argument.substr(assign + 2));
        }
        Sources sources;
        const xacro::Expansion made = xacro::expand(root + '/' + path, world, arguments, sources);
        ASSERT_TRUE(made.ok()) << path;
        for (const xacro::FileUse& use : made.files)
          reads_it = reads_it || normalize_path(use.path) == normalize_path(file.path);
        print_untouched(*made.document, file.path, is_fixed ? after : before, sources,
                        texts[is_fixed ? 1 : 0]);
      }
      if (reads_it) ++expansions;
      EXPECT_EQ(texts[0], texts[1]) << file.path << " in " << path;
    }
  }
  if (expansions == 0) GTEST_SKIP() << "no template of the corpus has a fix: nothing is compared";
  std::printf("%zu templates fixed, %zu expansions compared\n", fixed, expansions);
}

}  // namespace
}  // namespace rigor
