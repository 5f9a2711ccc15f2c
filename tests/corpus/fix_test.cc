// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `--fix` and `--unsafe-fixes` over every model of the corpus, in memory: what is changed is XML still,
// has less found in it and nothing new, is not changed by a second run, and with safe fixes is the same
// robot. Then real files are damaged in ways that a safe fix mends, and have to come out as they were.

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/author/fix.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/read/load.h>
#include <rigor/report/inspect/inspect.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/diff.h>
#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

#include "support/corpus.h"

namespace rigor {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t kEachFixed = 8;
constexpr std::size_t kEachDamaged = 80;
#else
constexpr std::size_t kEachFixed = 1;
constexpr std::size_t kEachDamaged = 8;
#endif

rules::ValidateOptions buffer_of(const std::string& path, const std::string& bytes) {
  rules::ValidateOptions options;
  options.buffer = {path, bytes};
  return options;
}

std::string inspected(const Environment& environment, const std::string& path,
                      const std::string& bytes) {
  Sources sources;
  read::Workspace workspace(environment.disk, sources);
  const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
  const read::Loaded loaded = read::load(reader, workspace.put(path, bytes));
  const model::Frames frames(loaded.root);
  return report::inspect_tsv({path, loaded.root, frames});
}

/// Word by word, numbers to 1e-12 (relative above 1).
bool same_robot(const std::string& a, const std::string& b) {
  std::istringstream left(a);
  std::istringstream right(b);
  std::string x;
  std::string y;
  while (left >> x) {
    if (!(right >> y)) return false;
    if (x == y) continue;
    char* x_end = nullptr;
    char* y_end = nullptr;
    const double p = std::strtod(x.c_str(), &x_end);
    const double q = std::strtod(y.c_str(), &y_end);
    if (*x_end != 0 || *y_end != 0) return false;
    if (!(std::abs(p - q) <= 1e-12 * std::max(1.0, std::abs(p)))) return false;
  }
  return !(right >> y);
}

/// What is found in some bytes, and what more `--fix` would do about it.
struct Rechecked {
  std::map<std::string, std::size_t> counts;
  std::vector<author::FixedFile> more;
};

/// The corpus, and what is found in it: every file; with sanitizers, which are slow, some.
class FixedCorpus {
 public:
  FixedCorpus()
      : environment_(disk_, {}), surveys_(disk_), mesh_files_(disk_), options_{.threads = 0} {
    const auto all = test::corpus_models();
    for (std::size_t i = 0; i < all.size(); i += kEachFixed) options_.paths.push_back(all[i]);
    options_.known = {&surveys_, &mesh_files_};
    result_ = rules::validate(environment_, options_, sources_);
  }

  void fix(Applicability most) {
    std::map<std::string_view, std::size_t> applied;
    std::map<std::string, std::size_t> held_back;
    std::size_t changed = 0;
    for (const author::FixedFile& file :
         author::fix_files(environment_, options_, result_, sources_, most)) {
      SCOPED_TRACE(file.path);
      EXPECT_TRUE(file.settled);
      for (const auto& [rule, count] : file.applied) applied[rule] += count;
      for (const author::HeldBackFix& held : file.held_back) {
        ++held_back[std::string(held.rule) + ": " + std::string(held.brings)];
      }
      if (!file.changed()) continue;
      ++changed;
      expect_better(file, most);
    }
    std::printf("%zu files changed\n", changed);
    for (const auto& [rule, count] : applied) {
      std::printf("  %5zu fixed %s\n", count, std::string(rule).c_str());
    }
    for (const auto& [rule, count] : held_back) {
      std::printf("  %5zu held back %s\n", count, rule.c_str());
    }
    EXPECT_GT(changed, 0U);
  }

 private:
  Rechecked recheck(const std::string& path, const std::string& bytes, Applicability most) {
    rules::ValidateOptions options = buffer_of(path, bytes);
    options.known = options_.known;
    Sources sources;
    const auto result = rules::validate(environment_, options, sources);
    return {counts_of(result), author::fix_files(environment_, options, result, sources, most)};
  }

  void expect_better(const author::FixedFile& file, Applicability most) {
    EXPECT_EQ(file.before, test::read_file(file.path));
    EXPECT_EQ(apply_edits(file.before, file.edits), file.after);
    EXPECT_FALSE(unified_diff(file.path, file.before, file.edits).empty());
    EXPECT_FALSE(file.applied.empty());
    const xml::Document after_xml = xml::parse(file.after, kNoSource);
    EXPECT_TRUE(after_xml.complete());
    const Rechecked after = recheck(file.path, file.after, most);
    for (const author::FixedFile& more : after.more) {
      EXPECT_FALSE(more.changed()) << "a second run changes it";
    }
    // What is behind a place that ended the reading was never examined.
    if (!xml::parse(file.before, kNoSource).complete()) return;
    const auto before = counts_of(file);
    EXPECT_LT(totals(after.counts), totals(before));
    const bool fewer_errors = totals(after.counts).front() < totals(before).front();
    for (const auto& [rule, count] : after.counts) {
      // What an error hid may show when it is gone: an element that was not read, a file that was not found.
      if (rule.ends_with(" info") || (fewer_errors && rule.ends_with(" warning"))) continue;
      const auto known = before.find(rule);
      EXPECT_TRUE(known != before.end() && count <= known->second) << rule;
    }
    if (most != Applicability::kSafe) return;
    EXPECT_TRUE(same_robot(inspected(environment_, file.path, file.before),
                           inspected(environment_, file.path, file.after)));
  }

  /// Of the file when it is checked by itself: among others, it may tell of fewer that it includes.
  std::map<std::string, std::size_t> counts_of(const author::FixedFile& file) {
    rules::ValidateOptions options = buffer_of(file.path, file.before);
    options.known = options_.known;
    Sources sources;
    return counts_of(rules::validate(environment_, options, sources));
  }

  /// Findings by rule and severity.
  static std::map<std::string, std::size_t> counts_of(const rules::ValidateResult& result) {
    std::map<std::string, std::size_t> counts;
    for (const Diagnostic& finding : result.diagnostics.list()) {
      counts[std::string(finding.rule) + " " + std::string(to_string(finding.severity))] +=
          finding.count;
    }
    return counts;
  }

  /// Errors, warnings and infos: less severe ones may come where severe ones go.
  static std::array<std::size_t, 3> totals(const std::map<std::string, std::size_t>& counts) {
    std::array<std::size_t, 3> sums{};
    for (const auto& [rule, count] : counts)
      sums[rule.ends_with(" error") ? 0 : rule.ends_with(" warning") ? 1 : 2] += count;
    return sums;
  }

  RealDisk disk_;
  Environment environment_;
  mass::MeshSurveys surveys_;
  mass::MeshFiles mesh_files_;
  rules::ValidateOptions options_;
  Sources sources_;
  rules::ValidateResult result_;
};

TEST(CorpusFix, MakesNothingWorseAndSafeFixesLeaveTheRobotAsItIs) {
  RIGOR_NEEDS_CORPUS();
  FixedCorpus corpus;
  for (const Applicability most : {Applicability::kSafe, Applicability::kUnsafe}) {
    SCOPED_TRACE(to_string(most));
    std::printf("%s:\n", std::string(to_string(most)).c_str());
    corpus.fix(most);
  }
}

/// What a safe fix puts back, at some places of the text.
std::string damaged(const std::string& text, const xml::Document& document, std::mt19937& random) {
  std::vector<Edit> edits;
  if (text.starts_with("<?xml")) edits.push_back({{kNoSource, 0, 0}, "\n"});
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    std::uint32_t end = 0;  // of the attribute before
    for (const xml::Attribute attribute : document.element(i).attributes()) {
      const Span whole = attribute.span();
      if (end + 1 == whole.begin && random() % 4 == 0) {
        edits.push_back({{kNoSource, end, whole.begin}, ""});
      } else if (end != 0 && edits.size() < 4 && random() % 8 == 0) {
        // Each ends the reading, and takes a pass.
        const std::string twice = " " + text.substr(whole.begin, whole.size());
        edits.push_back({{kNoSource, whole.end, whole.end}, twice});
        break;
      }
      end = whole.end;
    }
  }
  return *apply_edits(text, edits);
}

TEST(CorpusFix, WhatWasDamagedComesOutAsItWas) {
  RIGOR_NEEDS_CORPUS();
  constexpr std::size_t kLargest = 100'000;  // a few worlds would take most of the time
  const MemoryDisk disk;
  const Environment environment(disk, {});
  const auto paths = test::corpus_models();
  std::mt19937 random(7);
  std::size_t mended = 0;
  for (std::size_t i = 0; i < paths.size(); i += kEachDamaged) {
    SCOPED_TRACE(paths[i]);
    const std::string text = test::read_file(paths[i]);
    const xml::Document document = xml::parse(text, kNoSource);
    // A file with such faults of its own comes out better than it was.
    if (text.size() > kLargest || !document.complete() || !document.faults().empty()) continue;
    const std::string broken = damaged(text, document, random);
    if (broken == text) continue;
    const auto options = buffer_of("damaged.sdf", broken);
    Sources sources;
    const auto result = rules::validate(environment, options, sources);
    const auto files =
        author::fix_files(environment, options, result, sources, Applicability::kSafe);
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(files.front().after, text);
    EXPECT_TRUE(files.front().settled);
    ++mended;
  }
  std::printf("%zu damaged files came out as they were\n", mended);
  EXPECT_GT(mended, paths.size() / kEachDamaged / 4);
}

}  // namespace
}  // namespace rigor
