// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The verbs of `rigor edit` over the corpus, judged by the formats' own parsers: libsdformat, and urdfdom of a URDF.
// They must accept what a verb writes where they accepted the file before. Prints a table of all verbs. Built where
// libsdformat is installed.

#include <console_bridge/console.h>
#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>
#include <sdf/sdf.hh>

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <rigor/text/path.h>

#include "author/verbs/corpus_verbs.h"
#include "author/verbs/verb_bench.h"
#include "support/part.h"

namespace rigor::author {
namespace {

namespace fs = std::filesystem;

/// As `ign sdf -k` and check_urdf decide.
bool is_accepted(const std::string& text, bool is_urdf) {
  if (is_urdf) return urdf::parseURDF(text) != nullptr;
  sdf::Root root;
  sdf::Errors errors = root.LoadSdfString(text);
  sdf::checkJointParentChildNames(&root, errors);
  return errors.empty() && sdf::checkCanonicalLinkNames(&root) &&
         sdf::checkFrameAttachedToGraph(&root) && sdf::checkPoseRelativeToGraph(&root) &&
         sdf::recursiveSiblingUniqueNames(root.Element()) &&
         sdf::recursiveSiblingNoDoubleColonInNames(root.Element());
}

/// Where what `model://` names is: in a folder above the file, or in the largest collection.
std::string found_from(const std::string& file, const std::string& uri) {
  const std::size_t scheme = uri.find("://");
  const std::string path = scheme == std::string::npos ? uri : uri.substr(scheme + 3);
  fs::path folder = fs::path(file).parent_path();
  for (; folder.string().size() >= test::corpus().size() && folder.has_relative_path();
       folder = folder.parent_path()) {
    if (fs::exists(folder / path)) return (folder / path).string();
  }
  const fs::path collected = fs::path(test::corpus()) / "gazebo_models" / path;
  return fs::exists(collected) ? collected.string() : std::string();
}

struct VerbCounts {
  std::size_t applied = 0, proven = 0;
  std::size_t accepted_before = 0, accepted_after = 0;  ///< of the proven ones
  std::size_t taken_back = 0, same = 0;
};

class VerbJudge {
 public:
  void judge(const std::string& path) {
    sdf::setFindCallback([&](const std::string& uri) { return found_from(path, uri); });
    VerbBench bench(disk_);
    const EditedModel* before = bench.try_open(path);
    if (before == nullptr || before->robot.bodies.empty() ||
        !differences_at_rounding(before->robot, before->robot).empty())
      return;
    const bool accepted = is_accepted(std::string(before->document().bytes()), before->is_urdf());
    for (const CorpusVerb& verb : verbs_) {
      const Change change = verb.change(*before);
      if (!change.refused.empty()) continue;
      VerbCounts& counts = counts_[verb.name];
      ++counts.applied;
      const ProvenChange proven = bench.prove(*before, change);
      if (!proven.holds() || proven.files.empty()) continue;
      ++counts.proven;
      if (accepted) {
        ++counts.accepted_before;
        const bool still = is_accepted(proven.files.front().text, before->is_urdf());
        if (still) ++counts.accepted_after;
        EXPECT_TRUE(still) << verb.name << ' ' << path;
      }
      take_back(bench, verb, *before, *proven.after, counts);
    }
  }

  void print() const {
    std::printf(
        "| verb | applies | proven | accepted before | after | taken back | same |\n"
        "|---|---|---|---|---|---|---|\n");
    for (const CorpusVerb& verb : verbs_) {
      const auto found = counts_.find(verb.name);
      const VerbCounts c = found == counts_.end() ? VerbCounts{} : found->second;
      std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %zu |\n", verb.name.c_str(), c.applied,
                  c.proven, c.accepted_before, c.accepted_after, c.taken_back, c.same);
    }
  }

 private:
  static void take_back(VerbBench& bench, const CorpusVerb& verb, const EditedModel& before,
                        const EditedModel& after, VerbCounts& counts) {
    if (!verb.inverse) return;
    ++counts.taken_back;
    const ProvenChange restored = bench.prove(after, verb.inverse(before, after));
    if (!restored.after) return;
    const robot::Robot expected = verb.restored ? verb.restored(before) : before.robot;
    if (differences_at_rounding(expected, restored.after->robot).empty()) ++counts.same;
  }

  RealDisk disk_;
  std::vector<CorpusVerb> verbs_ = corpus_verbs(2'000'000);
  std::map<std::string, VerbCounts> counts_;
};

TEST(VerbsJudge, ParsersAcceptWhatTheyAccepted) {
  RIGOR_NEEDS_CORPUS();
  sdf::Console::Instance()->SetQuiet(true);
  console_bridge::noOutputHandler();
  VerbJudge judge;
  constexpr std::uintmax_t kLargest = 400'000;
  for (const std::string& path : test::corpus_part()) {
    if (file_name(path) != "model.config" && fs::file_size(path) <= kLargest) judge.judge(path);
  }
  judge.print();
}

}  // namespace
}  // namespace rigor::author
