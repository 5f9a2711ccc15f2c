// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which fixes are offered, and which would do damage and are not.

#include <gtest/gtest.h>

#include <map>
#include <string>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

namespace rigor::rules {
namespace {

/// The rules that find something, with the title of their fix or nothing.
std::map<std::string, std::string> offered(const std::string& bytes) {
  MemoryDisk disk;
  disk.put("a.sdf", bytes);
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = {"a.sdf"}}, sources);
  std::map<std::string, std::string> titles;
  for (const Diagnostic& found : result.diagnostics.list()) {
    titles[std::string(found.rule)] = found.fixes.empty() ? "" : found.fixes.front().title;
  }
  return titles;
}

std::string box_with(const std::string& inertial) {
  return "<sdf version='1.9'><model name='m'><link name='l'><inertial>" + inertial +
         "</inertial><collision name='c'><geometry><box><size>0.3 0.2 0.1</size></box></geometry>"
         "</collision></link></model></sdf>";
}

std::string box_with(const std::string& mass, const std::string& izz) {
  return box_with("<mass>" + mass + "</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>" + izz +
                  "</izz></inertia>");
}

TEST(OfferedFix, CutsOffAUnitButNoPartOfANumber) {
  EXPECT_EQ(offered(box_with("1", "0.01kgm"))["value-trailing-text"], "remove it");
  for (const char* broken : {"3.137l2e-05", "1e", "3.1E", "0.01 .5x"}) {
    const auto titles = offered(box_with("1", broken));
    ASSERT_EQ(titles.count("value-trailing-text"), 1U) << broken;
    for (const auto& [rule, title] : titles) EXPECT_EQ(title, "") << broken << ": " << rule;
  }
}

// Of a box 0.3 m long no mass can have its center at an end and be spread as over the whole box: then half of the
// variance that (c - a)(b - c) allows is exceeded. A tenth of the length beside the middle it can. A finding about
// moments moves no center that an author wrote: where these cannot be about it, there is no fix.
TEST(OfferedFix, KeepsAWrittenCenterOfMass) {
  const auto title = [](const std::string& x) {
    return offered(box_with("<pose>" + x +
                            " 0 0 0 0 0</pose><mass>2</mass><inertia><ixx>3.7</ixx>"
                            "<iyy>3.7</iyy><izz>3.7</izz></inertia>"))["inertia-geometry-mismatch"];
  };
  EXPECT_NE(title("0.03").find("about the written center of mass"), std::string::npos);
  EXPECT_EQ(title("0.15"), "");
  EXPECT_EQ(title("0").find("center of mass"), std::string::npos);
}

TEST(OfferedFix, LeavesBallsThatSeveralLinksHave) {
  const auto ball = [](const std::string& link) {
    const auto shape = [](const std::string& kind, const std::string& radius) {
      return "<" + kind + " name='" + kind + "'><geometry><sphere><radius>" + radius +
             "</radius></sphere></geometry></" + kind + ">";
    };
    return "<link name='" + link + "'>" + shape("collision", "0.02") + shape("visual", "0.01") +
           "</link>";
  };
  const auto title = [](const std::string& links) {
    return offered("<sdf version='1.9'><model name='m'>" + links + "</model></sdf>");
  };
  EXPECT_EQ(title(ball("a"))["shape-size-slip"], "make them the same");
  EXPECT_EQ(title(ball("a") + ball("b")).at("shape-size-slip"), "");
}

TEST(OfferedFix, TakesASignAwayWhereTheMassIsThenPlausible) {
  EXPECT_EQ(offered(box_with("-5.67", "0.01"))["mass-negative"], "remove the minus sign");
  // 0.006 m³: a ton would have the density of no solid, and water 6 kg.
  EXPECT_NE(offered(box_with("-1000", "0.01"))["mass-negative"].find("6 kg"), std::string::npos);
}

TEST(OfferedFix, MakesNoModelStaticThatIsToBe) {
  const auto plane = [](const std::string& with) {
    return "<sdf version='1.9'><model name='m'>" + with +
           "<link name='l'><collision name='c'><geometry><plane><normal>0 0 1</normal></plane>"
           "</geometry></collision></link></model></sdf>";
  };
  EXPECT_EQ(offered(plane(""))["plane-on-moving-link"], "make the model static");
  EXPECT_EQ(offered(plane("<statik>true</statik>"))["plane-on-moving-link"], "");
  EXPECT_EQ(offered(plane("<static>yes</static>"))["plane-on-moving-link"], "");
}

TEST(OfferedFix, DeclaresNoVersionThatLacksAnElement) {
  const auto joint = [](const std::string& pose, const std::string& axis) {
    return "<sdf><model name='m'><link name='a'>" + pose +
           "</link><link name='b'/><joint name='j' type='revolute'><parent>a</parent>"
           "<child>b</child><axis><xyz>0 0 1</xyz>" +
           axis + "</axis></joint></model></sdf>";
  };
  const std::string old = "<use_parent_model_frame>1</use_parent_model_frame>";  // up to 1.6
  const std::string young = "<pose relative_to='b'/>";                           // from 1.7
  EXPECT_EQ(offered(joint("", ""))["sdf-version-missing"], "declare SDF 1.12");
  EXPECT_EQ(offered(joint("", old))["sdf-version-missing"], "declare SDF 1.6");
  EXPECT_EQ(offered(joint(young, old))["sdf-version-missing"], "");
}

TEST(OfferedFix, ConvertsALimitOnlyWhereTheOtherIsOfAKnownUnit) {
  const auto limits = [](const std::string& lower, const std::string& upper) {
    return "<sdf version='1.9'><model name='m'><link name='a'/><link name='b'/>"
           "<joint name='j' type='revolute'><parent>a</parent><child>b</child><axis>"
           "<xyz>0 0 1</xyz><limit><lower>" +
           lower + "</lower><upper>" + upper + "</upper></limit></axis></joint></model></sdf>";
  };
  EXPECT_EQ(offered(limits("-143", "69"))["limit-looks-like-degrees"], "write radians");
  EXPECT_EQ(offered(limits("0", "69"))["limit-looks-like-degrees"], "write radians");
  EXPECT_EQ(offered(limits("-3.14", "125"))["limit-looks-like-degrees"], "write radians");
  EXPECT_EQ(offered(limits("-5", "125"))["limit-looks-like-degrees"], "");
  // Turns and half turns, round numbers, and no limit at all are none.
  for (const auto& [lower, upper] : std::map<std::string, std::string>{
           {"-12.56", "12.56"}, {"-31.416", "31.416"}, {"-100", "100"}, {"-1e16", "1e16"}}) {
    EXPECT_EQ(offered(limits(lower, upper)).count("limit-looks-like-degrees"), 0U) << upper;
  }
}

TEST(OfferedFix, DoesNotRemoveAnEmptyMass) {
  const auto titles = offered(box_with("", "0.01"));
  EXPECT_EQ(titles.count("value-empty"), 0U);
  ASSERT_EQ(titles.count("mass-not-written"), 1U);
  EXPECT_EQ(titles.at("mass-not-written"), "");
}

}  // namespace
}  // namespace rigor::rules
