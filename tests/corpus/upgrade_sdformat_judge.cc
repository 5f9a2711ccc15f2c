// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Upgrades over the corpus, judged by libsdformat alone: what it makes of the old file, which it converts
// itself, against what it makes of the new one. It must accept what it accepted, and hold the same elements
// with the same values but for what stands in docs/upgrade.md. Built where libsdformat is installed.

#include <gtest/gtest.h>
#include <sdf/sdf.hh>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <rigor/author/upgrade/upgrade.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>

#include "support/corpus.h"

namespace rigor::judge {
namespace {

namespace fs = std::filesystem;

/// What libsdformat 12 converts to.
constexpr schema::Version kTarget{9};

/// Folders of a corpus set's models; under the empty name, of sets that name none. What is not there is
/// taken from the largest collection.
std::map<std::string, std::vector<std::string>> upgrade_model_paths() {
  std::map<std::string, std::vector<std::string>> paths;
  std::ifstream stream(fs::path(test::corpus()) / "../oracle/model-paths.tsv");
  for (std::string line; std::getline(stream, line);) {
    const std::size_t tab = line.find('\t');
    if (tab == std::string::npos || line.starts_with("set\t")) continue;
    paths[line.substr(0, tab)].push_back(test::corpus() + "/" + line.substr(tab + 1));
  }
  paths[{}];
  for (auto& [set, folders] : paths) folders.push_back(test::corpus() + "/gazebo_models");
  return paths;
}

struct Verdict {
  bool valid = false;
  std::string why;
  std::vector<std::string> elements;  ///< path, value and attributes of each, sorted
};

/// What an upgrade writes otherwise on purpose (docs/upgrade.md), in one way for both.
std::string as_upgraded(std::string line, bool zero_is_none) {
  const std::string feedback = "/physics/ode/provide_feedback";
  if (const std::size_t at = line.find(feedback); at != std::string::npos) {
    line.replace(at, feedback.size(), "/physics/provide_feedback");
  }
  for (const std::string limit : {"/limit/effort = 0", "/limit/velocity = 0"}) {
    if (zero_is_none && line.ends_with(limit)) line.replace(line.size() - 1, 1, "-1");
  }
  return line;
}

/// Of all elements that say something: a value, or attributes.
void collect_elements(const sdf::ElementPtr& element, const std::string& above, bool zero_is_none,
                      std::vector<std::string>& out) {
  if (element->GetName() == "plugin") return;
  std::string path = above + "/" + element->GetName();
  if (element->HasAttribute("name")) path += ":" + element->Get<std::string>("name");
  std::vector<std::string> attributes;
  for (std::size_t i = 0; i < element->GetAttributeCount(); ++i) {
    const sdf::ParamPtr attribute = element->GetAttribute(static_cast<unsigned int>(i));
    if (!attribute->GetSet() || attribute->GetKey() == "version") continue;
    if (attribute->GetAsString().empty()) continue;
    attributes.push_back(" " + attribute->GetKey() + "=" + attribute->GetAsString());
  }
  std::sort(attributes.begin(), attributes.end());
  std::string line = path;
  for (const std::string& attribute : attributes) line += attribute;
  if (element->GetValue()) line += " = " + element->GetValue()->GetAsString();
  if (element->GetValue() || !attributes.empty()) out.push_back(as_upgraded(line, zero_is_none));
  for (sdf::ElementPtr child = element->GetFirstElement(); child; child = child->GetNextElement()) {
    collect_elements(child, path, zero_is_none, out);
  }
}

/// As `ign sdf -k` decides.
Verdict judge_text(const std::string& text, bool zero_is_none) {
  Verdict verdict;
  sdf::Root root;
  const sdf::Errors errors = root.LoadSdfString(text);
  for (const sdf::Error& error : errors) verdict.why += error.Message() + '\n';
  sdf::Errors of_joints;
  sdf::checkJointParentChildNames(&root, of_joints);
  for (const sdf::Error& error : of_joints) verdict.why += error.Message() + '\n';
  verdict.valid = errors.empty() && of_joints.empty() && sdf::checkCanonicalLinkNames(&root) &&
                  sdf::checkFrameAttachedToGraph(&root) && sdf::checkPoseRelativeToGraph(&root) &&
                  sdf::recursiveSiblingUniqueNames(root.Element()) &&
                  sdf::recursiveSiblingNoDoubleColonInNames(root.Element());
  if (root.Element()) collect_elements(root.Element(), {}, zero_is_none, verdict.elements);
  std::sort(verdict.elements.begin(), verdict.elements.end());
  return verdict;
}

/// What stands in one list and not in the other.
std::vector<std::string> only_in(const std::vector<std::string>& a,
                                 const std::vector<std::string>& b) {
  std::vector<std::string> result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

TEST(UpgradeJudge, LibsdformatAcceptsWhatItAcceptedAndReadsTheSame) {
  RIGOR_NEEDS_CORPUS();
  sdf::Console::Instance()->SetQuiet(true);
  const RealDisk disk;
  const auto folders = upgrade_model_paths();
  const std::vector<std::string>* searched = nullptr;  // of the file's set
  sdf::setFindCallback([&](const std::string& uri) -> std::string {
    const std::size_t scheme = uri.find("://");
    const std::string path = scheme == std::string::npos ? uri : uri.substr(scheme + 3);
    for (const std::string& folder : *searched) {
      if (fs::exists(folder + "/" + path)) return folder + "/" + path;
    }
    return {};
  });
  const char* only = std::getenv("RIGOR_UPGRADE_ONLY");  // a part of the paths to look at
  int upgraded = 0, valid = 0, now_valid = 0, same = 0;
  for (const std::string& path : test::corpus_models()) {
    if (path.ends_with(".urdf") || path.ends_with(".config")) continue;
    if (only != nullptr && path.find(only) == std::string::npos) continue;
    const std::string relative = path.substr(test::corpus().size() + 1);
    const auto found = folders.find(relative.substr(0, relative.find('/')));
    searched = &(found == folders.end() ? folders.at({}) : found->second);
    read::SearchPaths search;
    for (const std::string& folder : *searched) search.given.push_back({folder, "the corpus"});
    const Environment environment(disk, search);
    Sources sources;
    read::Workspace workspace(disk, sources);
    const read::Loaded loaded = read::load(
        {workspace, environment.resolver, environment.sdf, environment.urdf}, workspace.open(path));
    const author::Upgrade result = author::upgrade(environment, loaded, kTarget);
    if (result.refused() || result.edits.empty()) continue;
    ++upgraded;
    const Verdict before =
        judge_text(std::string(loaded.file->document->bytes()), result.from.minor <= 3);
    const Verdict after = judge_text(result.text, false);
    valid += before.valid ? 1 : 0;
    now_valid += !before.valid && after.valid ? 1 : 0;
    EXPECT_TRUE(after.valid || !before.valid) << relative << ": " << after.why;
    if (!before.valid || !after.valid) continue;
    same += before.elements == after.elements ? 1 : 0;
    for (const std::string& line : only_in(before.elements, after.elements)) {
      ADD_FAILURE() << relative << " had " << line;
    }
    for (const std::string& line : only_in(after.elements, before.elements)) {
      ADD_FAILURE() << relative << " has " << line;
    }
  }
  EXPECT_TRUE(only != nullptr || valid > 900);
  std::printf(
      "%d upgraded; of %d that it called valid all are; %d others are valid now; %d of those "
      "valid read the same, element by element\n",
      upgraded, valid, now_valid, same);
}

}  // namespace
}  // namespace rigor::judge
