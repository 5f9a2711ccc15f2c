// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/config.h>

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace rigor::config {
namespace {

std::vector<std::string> values(const std::vector<Name>& names) {
  std::vector<std::string> list;
  for (const Name& name : names) list.push_back(name.value);
  return list;
}

bool excluded(const Config& config, std::string_view path, PathKind kind) {
  return excluding(config, path, kind) != nullptr;
}

using Texts = std::vector<std::string>;

Config good_config(std::string_view text) {
  Config config = read_config("/p/rigor.toml", text);
  for (const Problem& problem : config.problems) {
    ADD_FAILURE() << problem.line << ": " << problem.message;
  }
  return config;
}

/// The lines of the problems, in order of the reader.
std::vector<unsigned> bad_lines(std::string_view text) {
  std::vector<unsigned> lines;
  for (const Problem& problem : read_config("rigor.toml", text).problems) {
    lines.push_back(problem.line);
    EXPECT_EQ(problem.path, "rigor.toml");
  }
  return lines;
}

using Lines = std::vector<unsigned>;

TEST(Config, EveryKey) {
  const Config config = good_config(R"(extend = "../rigor.toml"
root = true
select = ["inertia", "axis-zero"]
ignore = "mesh-unit"
fail-on = "never"
target = ["ros", "gz-sim"]
exclude = ["old/", "*.bak.sdf"]
baseline = "ci/rigor.baseline"
[severity]
axis-zero = "info"
[[per-file]]
files = ["worlds/**"]
ignore = ["plugin"]
severity = {axis-zero = "off"}
[resolve]
paths = ["models", "/opt/models"]
packages = {arm = "../arm"}
[materials]
our-foam = 42
ink = 1.1e3
)");
  EXPECT_EQ(config.extend->value, "../rigor.toml");
  EXPECT_TRUE(config.root->value);
  EXPECT_EQ(values(*config.rules.select), (Texts{"inertia", "axis-zero"}));
  EXPECT_EQ(values(config.rules.ignore), (Texts{"mesh-unit"}));
  EXPECT_EQ(config.fail_on->value, std::nullopt);
  EXPECT_EQ(values(*config.targets), (Texts{"ros", "gz-sim"}));
  EXPECT_EQ(config.baseline->value, "/p/ci/rigor.baseline");
  EXPECT_EQ(config.rules.severity.at("axis-zero").value, Severity::kInfo);
  EXPECT_EQ(values(config.resolve_paths), (Texts{"/p/models", "/opt/models"}));
  EXPECT_EQ(config.resolve_packages.at("arm").value, "/arm");
  EXPECT_EQ(config.materials.at("our-foam").value, 42);
  EXPECT_EQ(config.materials.at("ink").value, 1100);

  EXPECT_TRUE(excluded(config, "/p/a/old", PathKind::kFolder));
  EXPECT_TRUE(excluded(config, "/p/a/old/b.sdf", PathKind::kFile));
  EXPECT_TRUE(excluded(config, "/p/a/b.bak.sdf", PathKind::kFile));
  EXPECT_FALSE(excluded(config, "/p/a/b.sdf", PathKind::kFile));
  EXPECT_FALSE(excluded(config, "/q/old/b.sdf", PathKind::kFile)) << "not below the file";
  EXPECT_FALSE(excluded(config, "/pp/old/b.sdf", PathKind::kFile));

  const RuleChoice world = rules_for(config, "/p/worlds/a/lab.world");
  EXPECT_EQ(values(world.ignore), (Texts{"mesh-unit", "plugin"}));
  EXPECT_EQ(world.severity.at("axis-zero").value, std::nullopt);
  EXPECT_EQ(values(*world.select), (Texts{"inertia", "axis-zero"}));
  EXPECT_EQ(values(rules_for(config, "/p/lab.world").ignore), (Texts{"mesh-unit"}));
}

TEST(Config, EveryValueKnowsItsPlace) {
  const Config config = good_config(
      "ignore = [\n  'a',\n  'b'\n]\nfail-on = 'info'\n[severity]\nx = 'off'\n\n[materials]\nm = "
      "1\n"
      "[resolve]\npaths = ['q']\npackages.z = 'r'\n");
  EXPECT_EQ(config.rules.ignore.at(0).place.line, 2U);
  EXPECT_EQ(config.rules.ignore.at(1).place.line, 3U);
  EXPECT_EQ(config.rules.ignore.at(1).place.path, "/p/rigor.toml");
  EXPECT_EQ(config.fail_on->place.line, 5U);
  EXPECT_EQ(config.rules.severity.at("x").place.line, 7U);
  EXPECT_EQ(config.materials.at("m").place.line, 10U);
  EXPECT_EQ(config.resolve_paths.at(0).place.line, 12U);
  EXPECT_EQ(config.resolve_packages.at("z").place.line, 13U);
}

TEST(Config, WhatCannotStandThereHasALine) {
  EXPECT_EQ(bad_lines("[materials]\nfoam = -1\n"), (Lines{2}));
  EXPECT_EQ(bad_lines("[materials]\nfoam = 'light'\n"), (Lines{2}));
  EXPECT_EQ(bad_lines("[materials]\nfoam = true\n"), (Lines{2}));
  EXPECT_EQ(bad_lines("[materials]\n\nfoam = inf\n"), (Lines{3}));
  EXPECT_EQ(bad_lines("materials = 3\n"), (Lines{1}));
  EXPECT_EQ(bad_lines("\n\n[materials\n"), (Lines{3}));
  EXPECT_EQ(bad_lines("select = []\n"), (Lines{1}));
  EXPECT_EQ(bad_lines("select = 3\n"), (Lines{1}));
  EXPECT_EQ(bad_lines("ignore = ['a',\n 2,\n '']\n"), (Lines{2, 3}));
  EXPECT_EQ(bad_lines("root = 'yes'\n"), (Lines{1}));
  EXPECT_EQ(bad_lines("extend = ''\n"), (Lines{1}));
  EXPECT_EQ(bad_lines("fail-on = 'off'\n"), (Lines{1}));
  EXPECT_EQ(bad_lines("[severity]\na = 'never'\nb = 2\n"), (Lines{2, 3}));
  EXPECT_EQ(bad_lines("[[per-file]]\nignore = ['a']\n"), (Lines{1}));
  EXPECT_EQ(bad_lines("[[per-file]]\nfiles = 'a'\nfail-on = 'info'\n"), (Lines{3}));
  EXPECT_EQ(bad_lines("per-file = [1]\n"), (Lines{1}));
  EXPECT_EQ(bad_lines("exclude = ['[a', '../b', '', 'a\\']\n"), (Lines{1, 1, 1, 1}));
  EXPECT_EQ(bad_lines("[resolve]\npackages = ['a']\n"), (Lines{2}));
  EXPECT_EQ(bad_lines("[resolve]\npackages.a = 1\n"), (Lines{2}));
  EXPECT_EQ(bad_lines("ignore = []\nexclude = []\ntarget = []\n[severity]\n[resolve]\n"), Lines{});
  EXPECT_EQ(bad_lines(""), Lines{});
}

TEST(Config, AllProblemsAreTold) {
  EXPECT_EQ(
      bad_lines("selct = 1\nroot = 2\n[materials]\nm = 0\n[resolve]\npath = 'a'\n[x]\n").size(),
      5U);
}

TEST(Config, AnUnknownKeyComesWithThoseThatAreKnown) {
  const Config config = read_config("rigor.toml", "\nselct = ['a']\n");
  ASSERT_EQ(config.problems.size(), 1U);
  const Problem& problem = config.problems.front();
  EXPECT_EQ(problem.line, 2U);
  EXPECT_EQ(problem.name, "selct");
  EXPECT_NE(std::find(problem.known.begin(), problem.known.end(), "select"), problem.known.end());
}

TEST(Config, OneThatExtendsAddsToItsBase) {
  const Config base = read_config("/rigor.toml",
                                  "select = ['a']\nignore = ['b']\nfail-on = 'info'\n"
                                  "target = ['ros']\nbaseline = 'x'\nexclude = ['w']\n"
                                  "[severity]\nr = 'off'\ns = 'error'\n"
                                  "[[per-file]]\nfiles = ['p/q']\nignore = ['c']\nselect = ['d']\n"
                                  "[resolve]\npaths = ['m']\npackages = {x = 'x', y = 'y'}\n"
                                  "[materials]\nfoam = 1\nink = 2\n");
  const Config own = good_config(
      "select = ['e']\nignore = ['f']\nexclude = ['v']\n[severity]\nr = 'info'\n"
      "[[per-file]]\nfiles = ['q']\nignore = ['g']\n[resolve]\npaths = ['n']\npackages.x = 'z'\n"
      "[materials]\nfoam = 3\n");
  const Config both = extended(own, base);
  EXPECT_EQ(both.files, (Texts{"/p/rigor.toml", "/rigor.toml"}));
  EXPECT_EQ(values(*both.rules.select), (Texts{"e"})) << "replaces";
  EXPECT_EQ(values(both.rules.ignore), (Texts{"b", "f"}));
  EXPECT_EQ(both.rules.severity.at("r").value, Severity::kInfo);
  EXPECT_EQ(both.rules.severity.at("s").value, Severity::kError);
  EXPECT_EQ(both.fail_on->place.path, "/rigor.toml");
  EXPECT_EQ(values(*both.targets), (Texts{"ros"}));
  EXPECT_EQ(both.baseline->value, "/x");
  EXPECT_EQ(values(both.resolve_paths), (Texts{"/p/n", "/m"})) << "its own are searched first";
  EXPECT_EQ(both.resolve_packages.at("x").value, "/p/z");
  EXPECT_EQ(both.resolve_packages.at("y").value, "/y");
  EXPECT_EQ(both.materials.at("foam").value, 3);
  EXPECT_EQ(both.materials.at("ink").value, 2);
  // Patterns belong to the folder of the file that has them.
  EXPECT_TRUE(excluded(both, "/w/a.sdf", PathKind::kFile));
  EXPECT_TRUE(excluded(both, "/p/v/a.sdf", PathKind::kFile));
  EXPECT_FALSE(excluded(both, "/v/a.sdf", PathKind::kFile));
  const RuleChoice choice = rules_for(both, "/p/q");
  EXPECT_EQ(values(choice.ignore), (Texts{"b", "f", "c", "g"}));
  EXPECT_EQ(values(*choice.select), (Texts{"d"}));
}

TEST(Config, TheLastPatternDecides) {
  const Config config = good_config("exclude = ['./worlds/*', '!lab.sdf', '/old', '\\#a']\n");
  EXPECT_TRUE(excluded(config, "/p/worlds/yard.sdf", PathKind::kFile));
  EXPECT_FALSE(excluded(config, "/p/worlds/lab.sdf", PathKind::kFile));
  EXPECT_TRUE(excluded(config, "/p/old/a.sdf", PathKind::kFile));
  EXPECT_FALSE(excluded(config, "/p/a/old/a.sdf", PathKind::kFile));
  EXPECT_FALSE(excluded(config, "/p", PathKind::kFolder)) << "its own folder is outside";
}

TEST(Config, AnythingCanStandInAFile) {
  // None of these may take the stack, or time without end.
  const auto problems = [](const std::string& text) {
    return read_config("rigor.toml", text).problems.size();
  };
  const auto repeated = [](const std::string& part) {
    std::string text;
    while (text.size() + part.size() <= kMaxConfigBytes - 100) text += part;
    return text;
  };
  EXPECT_EQ(problems(repeated("a.") + "a = 1"), 1U);
  EXPECT_EQ(problems(repeated("a . ") + "a = 1"), 1U);
  EXPECT_EQ(problems(repeated("'a'.") + "a = 1"), 1U);
  EXPECT_EQ(problems("[" + repeated("a.") + "a]"), 1U);
  EXPECT_EQ(problems("x = {" + repeated("a.") + "a = 1}"), 1U);
  EXPECT_GE(problems("x = " + repeated("[")), 1U);
  EXPECT_GE(problems("x = " + repeated("{a=")), 1U);
  EXPECT_GE(problems("materials = " + repeated("[[")), 1U);
  EXPECT_GE(problems(repeated("[[per-file]]\n")), 1U);
  EXPECT_GE(problems("exclude = [" + repeated("'*',") + "'a']"), 0U);
  EXPECT_EQ(problems("# " + repeated("a.") + "\nroot = true\n"), 0U) << "a comment";
  EXPECT_EQ(problems("baseline = '../../../../../../../../x'\n[ =\n"), 1U);
  std::mt19937 random(3);
  const std::string letters = "[]{}='\".,\n#ab1 \\\xC3\xA4";
  for (int i = 0; i < 3000; ++i) {
    std::string junk;
    for (int n = 0; n < 60; ++n) junk += letters[random() % letters.size()];
    problems(junk);
  }
  std::string junk(kMaxConfigBytes, ' ');
  for (char& c : junk) c = static_cast<char>(random());
  EXPECT_GE(problems(junk), 1U);
}

}  // namespace
}  // namespace rigor::config
