// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/scaffold.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace rigor::author {
namespace {

std::string scaffolded(std::string_view model_template, const std::string& path) {
  for (const ScaffoldFile& file : scaffold(model_template, "it")) {
    if (file.path == path) return file.bytes;
  }
  return {};
}

TEST(Scaffold, HasTheTemplatesThatWerePromised) {
  const std::vector<std::string_view> promised{"arm",   "box",     "diff-drive",
                                               "drone", "gripper", "mesh"};
  EXPECT_EQ(template_names(), promised);
}

TEST(Scaffold, EachTemplateIsWhole) {
  for (const std::string_view each : template_names()) {
    std::set<std::string> paths;
    for (const ScaffoldFile& file : scaffold(each, "it-2_x")) {
      EXPECT_TRUE(paths.insert(file.path).second) << file.path << " twice";
      EXPECT_EQ(file.bytes.find("@NAME@"), std::string::npos) << file.path;
      EXPECT_EQ(file.path.find("@NAME@"), std::string::npos);
      EXPECT_TRUE(file.bytes.ends_with("\n")) << file.path;
    }
    for (const std::string path : {"model.config", "model.sdf", "scenario.toml"}) {
      EXPECT_TRUE(paths.contains(path)) << each << ' ' << path;
    }
    EXPECT_TRUE(paths.contains("worlds/it-2_x.sdf")) << each;
  }
}

TEST(Scaffold, PutsTheNameWhereNamesStand) {
  EXPECT_NE(scaffolded("arm", "model.sdf").find("<model name=\"it\">"), std::string::npos);
  EXPECT_NE(scaffolded("arm", "model.config").find("<name>it</name>"), std::string::npos);
  EXPECT_NE(scaffolded("arm", "worlds/it.sdf").find("<uri>model://it</uri>"), std::string::npos);
  EXPECT_NE(scaffolded("mesh", "model.sdf").find("<uri>model://it/meshes/bollard.obj</uri>"),
            std::string::npos);
}

// m (b² + c²) / 12 of the chassis, m r² / 2 of a wheel, 2/5 m r² of the caster: by hand.
TEST(Scaffold, HasTheMomentsOfItsShapes) {
  const std::string text = scaffolded("diff-drive", "model.sdf");
  EXPECT_NE(text.find("<ixx>0.0166666667</ixx>"), std::string::npos);
  EXPECT_NE(text.find("<izz>0.0666666667</izz>"), std::string::npos);
  EXPECT_NE(text.find("<izz>0.005</izz>"), std::string::npos);
  EXPECT_NE(text.find("<izz>2.5e-05</izz>"), std::string::npos);
}

TEST(Scaffold, KnowsNoOtherTemplate) {
  EXPECT_TRUE(scaffold("common", "it").empty());
  EXPECT_TRUE(scaffold("", "it").empty());
  EXPECT_TRUE(scaffold("arm/..", "it").empty());
}

TEST(ScaffoldName, TakesWhatAllTake) {
  for (const std::string name :
       {"a", "my_robot", "My-Robot2", "a-", "b_", "worlds", "com", "com0"}) {
    EXPECT_FALSE(name_problem(name)) << name;
  }
  EXPECT_FALSE(name_problem(std::string(kMaxNameLength, 'a')));
}

TEST(ScaffoldName, SaysWhatIsWrongAndWhatWouldBeRight) {
  const auto suggestion = [](std::string_view name) {
    const auto problem = name_problem(name);
    return problem ? problem->suggestion : "taken: " + std::string(name);
  };
  EXPECT_EQ(suggestion("my robot"), "my_robot");
  EXPECT_EQ(suggestion("2wheels"), "model_2wheels");
  EXPECT_EQ(suggestion("a--b"), "a-b");
  EXPECT_EQ(suggestion("a::b"), "a_b");
  EXPECT_EQ(suggestion("_a"), "a");
  EXPECT_EQ(suggestion("World"), "World_model");
  EXPECT_EQ(suggestion("nul"), "nul_model");
  EXPECT_EQ(suggestion("COM1"), "COM1_model");
  EXPECT_EQ(suggestion(".."), "my_robot");
  EXPECT_EQ(suggestion(""), "my_robot");
  EXPECT_EQ(suggestion("r\xc3\xb6"
                       "bot"),
            "r_bot");
  EXPECT_EQ(name_problem("a\tb")->what, "has a control character");
  EXPECT_EQ(name_problem("<script>")->what, "has a '<'");
}

TEST(ScaffoldName, EverySuggestionCanBeTaken) {
  // Each byte alone, doubled, before and behind something, and too long.
  for (int byte = 0; byte < 256; ++byte) {
    const std::string c(1, static_cast<char>(byte));
    for (const std::string& name :
         {c, c + c, c + "a", "a" + c, c + "world", c + "nul" + c, "9" + c,
          std::string(kMaxNameLength, 'a') + c, std::string(kMaxNameLength - 2, '1') + c + "--"}) {
      const auto problem = name_problem(name);
      if (!problem) continue;
      EXPECT_FALSE(name_problem(problem->suggestion)) << problem->suggestion;
    }
  }
}

}  // namespace
}  // namespace rigor::author
