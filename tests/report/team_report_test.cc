// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/team/report.h>

#include <cstdio>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <report/found.h>
#include <rigor/report/team/script.h>
#include <rigor/text/base64.h>

namespace rigor::report {
namespace {

using tinyxml2::XMLElement;

constexpr const char* kHostile = "</script><img src=x onerror='alert(1)'>\"&\x01";

void visit(const XMLElement& element, const std::function<void(const XMLElement&)>& with) {
  with(element);
  for (const auto* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    visit(*child, with);
  }
}

/// A page as another parser sees it.
class Page {
 public:
  explicit Page(const std::string& html) {
    EXPECT_EQ(document_.Parse(html.data(), html.size()), tinyxml2::XML_SUCCESS)
        << document_.ErrorStr();
    if (document_.RootElement() == nullptr) return;
    visit(*document_.RootElement(), [this](const XMLElement& element) {
      ++elements_[element.Name()];
      for (const auto* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
        const std::string name = a->Name();
        if (name == "id") {
          EXPECT_TRUE(ids_.insert(a->Value()).second) << a->Value();
        }
        if (name == "href" || name == "src") links_.insert(a->Value());
        EXPECT_FALSE(name.starts_with("on")) << name;
      }
      const char* kind = element.Attribute("class");
      if (kind != nullptr && std::string(kind).starts_with("finding ")) ++findings_;
    });
  }

  std::size_t count(const std::string& element) const {
    const auto found = elements_.find(element);
    return found == elements_.end() ? 0 : found->second;
  }
  std::size_t findings() const { return findings_; }
  const std::set<std::string>& ids() const { return ids_; }
  const std::set<std::string>& links() const { return links_; }

 private:
  tinyxml2::XMLDocument document_;
  std::map<std::string, std::size_t> elements_;
  std::set<std::string> ids_;
  std::set<std::string> links_;
  std::size_t findings_ = 0;
};

ReportedModel told(std::size_t file, const std::string& name) {
  ReportedModel model;
  model.file = file;
  model.name = name;
  model.picture = model.thumbnail = "no PNG, but bytes";
  return model;
}

std::string one_page(const Found& found, const std::vector<ReportedModel>& models,
                     TriangleBudget budget = {}) {
  TeamReport report(found.validation(), {TeamReportForm::kOneFile, {"robots"}, budget});
  for (const ReportedModel& model : models) report.add(model);
  const std::vector<ReportFile> files = std::move(report).files();
  EXPECT_EQ(files.size(), 1U);
  EXPECT_EQ(files.back().path, "");
  return files.back().bytes;
}

TEST(TeamReport, WhateverNamesHoldTheyStayText) {
  Found found;
  found.file(std::string("robots/") + kHostile + ".sdf", "<sdf>\n<a/></script><img src='y'/>\n")
      .at("<a/>", {.message = kHostile, .subject = kHostile, .help = kHostile});
  found.result.not_looked_at.push_back({found.result.files[0].path, kHostile});
  found.result.not_looked_at.push_back({kHostile, kHostile, 1});
  ReportedModel model = told(0, kHostile);
  model.models = {{kHostile, {}}, {kHostile, {}}};
  model.meshes = {{kHostile, false, 1, 12}};
  model.not_drawn = {kHostile};
  model.not_simulated = kHostile;
  const Page page(one_page(found, {model}));
  EXPECT_EQ(page.count("img"), 2U);
  EXPECT_EQ(page.count("script"), 1U);
  for (const std::string& link : page.links()) {
    EXPECT_TRUE(link.starts_with("#") || link.starts_with("data:image/png;base64,")) << link;
  }
}

TEST(TeamReport, EveryFindingIsThereAndItsRuleIsExplained) {
  Found found;
  found.file("a.sdf", "<sdf>\n<a/>\n");
  for (int i = 0; i < 30; ++i) found.at("<a/>", {.rule = "axis-zero", .message = "m"});
  found.at("<a/>", {.rule = "name-empty", .severity = Severity::kInfo, .message = "m"});
  found.file("model.config", "<model/>").add({.message = "of no model", .path = "model.config"});
  const Page page(one_page(found, {told(0, "a")}));
  EXPECT_EQ(page.findings(), 32U);
  for (const std::string& link : page.links()) {
    if (link.starts_with("#")) {
      EXPECT_TRUE(page.ids().contains(link.substr(1))) << link;
    }
  }
  EXPECT_TRUE(page.ids().contains("rule-axis-zero"));
}

TEST(TeamReport, MeshesAreHeldAgainstBudgets) {
  ReportedModel model = told(0, "a");
  model.meshes = {{"arm.dae", false, 4, 1000}, {"arm.stl", true, 1, 20'001}};
  EXPECT_EQ(triangles_of(model, false, {}).triangles, 4000U);
  EXPECT_FALSE(triangles_of(model, false, {}).over());
  EXPECT_FALSE(triangles_of(model, false, {.visual = 4000}).over());
  EXPECT_TRUE(triangles_of(model, false, {.visual = 3999}).over_model);
  EXPECT_FALSE(over_budget(model, {.visual = 4000}));
  EXPECT_TRUE(over_budget(model, {.visual = 3999}));
  // More than mesh-collision-triangles lets a mesh have; no budget of a model says so.
  EXPECT_TRUE(triangles_of(model, true, {}).over_mesh);
  EXPECT_FALSE(over_budget(model, {}));
  EXPECT_EQ(triangles_of(model, true, {}).unread, 0U);
  model.meshes.push_back({"gone.stl", true});
  EXPECT_EQ(triangles_of(model, true, {}).unread, 1U);
  Found found;
  found.file("a.sdf", "<sdf/>");
  const std::string page = one_page(found, {model});
  EXPECT_NE(page.find("over budget"), std::string::npos);
  EXPECT_NE(page.find("not read"), std::string::npos);
}

TEST(TeamReport, OfAFolderAllThatIsNamedIsThere) {
  Found found;
  found.file("robots/arm.sdf", "<sdf>\n<a/>\n").at("<a/>", {.message = "m"});
  found.file("robots-arm.sdf", "<sdf/>");  // would have the same name as a page
  found.file("../" + std::string(300, 'x') + "/Ä.sdf", "<sdf/>");
  TeamReport report(found.validation(), {TeamReportForm::kFolder, {"."}, {}});
  for (std::size_t i = 0; i < 3; ++i) report.add(told(i, "model"));
  std::map<std::string, std::string> files;
  for (const ReportFile& file : std::move(report).files()) {
    EXPECT_TRUE(files.emplace(file.path, file.bytes).second) << file.path;
    EXPECT_LT(file.path.size(), 200U);
  }
  EXPECT_EQ(files.size(), 1U + 3 * 3);
  const Page index(files.at("index.html"));
  std::size_t named = 0;
  for (const std::string& link : index.links()) {
    if (link.starts_with("#")) continue;
    EXPECT_TRUE(files.contains(link)) << link;
    ++named;
  }
  EXPECT_EQ(named, 6U);  // pages and thumbnails
  std::size_t findings = index.findings();
  for (const auto& [path, bytes] : files) {
    if (!path.starts_with("models/")) continue;
    const Page page(bytes);
    findings += page.findings();
    for (const std::string& link : page.links()) {
      ASSERT_TRUE(link.starts_with("../")) << link;
      const std::size_t hash = std::min(link.find('#'), link.size());
      EXPECT_TRUE(files.contains(link.substr(3, hash - 3))) << link;
      if (hash < link.size()) {
        EXPECT_TRUE(index.ids().contains(link.substr(hash + 1))) << link;
      }
    }
  }
  EXPECT_EQ(findings, 1U);
}

/// The browser computes the same, and runs nothing else.
TEST(TeamReport, TheScriptIsTheOneThatThePolicyNames) {
  const std::string script(team_report_script());
  const std::string name = testing::TempDir() + "rigor_report_script.js";
  std::FILE* file = std::fopen(name.c_str(), "wb");
  ASSERT_NE(file, nullptr);
  std::fwrite(script.data(), 1, script.size(), file);
  std::fclose(file);
  std::FILE* pipe = ::popen(("sha256sum '" + name + "'").c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string digest;
  for (unsigned byte = 0; digest.size() < 32 && std::fscanf(pipe, "%2x", &byte) == 1;) {
    digest += static_cast<char>(byte);
  }
  ::pclose(pipe);
  std::remove(name.c_str());
  EXPECT_EQ(team_report_script_hash(), "sha256-" + base64(digest));
  const std::string policy = "script-src '" + std::string(team_report_script_hash()) + "'";
  EXPECT_NE(one_page(Found(), {}).find(policy), std::string::npos);
}

}  // namespace
}  // namespace rigor::report
