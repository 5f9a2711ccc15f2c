// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The command line as its users script it: one test for each promise.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cli/program.h>

#include "support/part.h"

namespace rigor::test {
namespace {

using nlohmann::json;

constexpr const char* kGood = R"(<sdf version="1.9">
  <model name="arm">
    <link name="base">
      <inertial><mass>2</mass><inertia>
        <ixx>0.1</ixx><ixy>0</ixy><ixz>0</ixz><iyy>0.1</iyy><iyz>0</iyz><izz>0.1</izz>
      </inertia></inertial>
    </link>
    <link name="fore arm">
      <pose>0 0 1 0 0 0</pose>
      <inertial><mass>1</mass><inertia>
        <ixx>0.1</ixx><ixy>0</ixy><ixz>0</ixz><iyy>0.1</iyy><iyz>0</iyz><izz>0.1</izz>
      </inertia></inertial>
    </link>
    <joint name="elbow" type="revolute">
      <parent>base</parent>
      <child>fore arm</child>
      <axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper></limit></axis>
    </joint>
  </model>
</sdf>
)";

/// One error: joint-limit-inverted.
constexpr const char* kBad = R"(<sdf version="1.9">
  <model name="arm">
    <link name="base">
      <inertial><mass>2</mass><inertia>
        <ixx>0.1</ixx><ixy>0</ixy><ixz>0</ixz><iyy>0.1</iyy><iyz>0</iyz><izz>0.1</izz>
      </inertia></inertial>
    </link>
    <link name="hand">
      <inertial><mass>1</mass><inertia>
        <ixx>0.1</ixx><ixy>0</ixy><ixz>0</ixz><iyy>0.1</iyy><iyz>0</iyz><izz>0.1</izz>
      </inertia></inertial>
    </link>
    <joint name="elbow" type="revolute">
      <parent>base</parent>
      <child>hand</child>
      <axis><xyz>0 0 1</xyz><limit><lower>1</lower><upper>-1</upper></limit></axis>
    </joint>
  </model>
</sdf>
)";

constexpr const char* kDamaged = "<sdf version=\"1.9\">\n  <model name=\"arm\">\n</sdf>\n";

class Cli : public testing::Test {
 protected:
  void SetUp() override {
    folder_.put("good.sdf", kGood);
    folder_.put("bad.sdf", kBad);
  }

  Ran rigor(const std::string& arguments, const std::string& before = "") const {
    return folder_.rigor(arguments, before);
  }

  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  Folder folder_;
};

TEST_F(Cli, SchemaKnowsEveryVersion) {
  for (const char* version : {"1.0", "1.2", "1.3", "1.12", "urdf"}) {
    for (const char* form : {"", " --xsd"}) {
      const Ran ran = rigor(std::string("schema ") + version + form);
      EXPECT_EQ(ran.exit, 0) << version << form;
      EXPECT_TRUE(has(ran.out, "joint")) << version << form;
    }
  }
}

TEST_F(Cli, AlonePrintsADozenLines) {
  const Ran ran = rigor("");
  EXPECT_EQ(ran.exit, 0);
  const auto lines = std::count(ran.out.begin(), ran.out.end(), '\n');
  EXPECT_GE(lines, 8);
  EXPECT_LE(lines, 14);
  EXPECT_TRUE(has(ran.out, "rigor validate"));
  EXPECT_EQ(ran.err, "");
}

TEST_F(Cli, WritesNothingOverWhatItReads) {
  const std::string before = folder_.get("good.sdf");
  for (const char* command :
       {"render good.sdf -o good.sdf", "view good.sdf -o ./good.sdf",
        "sdf2urdf good.sdf -o good.sdf --allow-loss", "validate good.sdf --output json:good.sdf",
        "inspect good.sdf --output json:good.sdf", "diff good.sdf good.sdf --output json:good.sdf",
        "sdf2urdf good.sdf -o a.urdf --report json:good.sdf",
        "simulate good.sdf --output csv:good.sdf", "sdf2urdf good.sdf -o x --report json:./x",
        "validate good.sdf --output json:x --output sarif:x"}) {
    const Ran ran = rigor(command);
    EXPECT_EQ(ran.exit, 2) << command << ran.err;
    EXPECT_EQ(folder_.get("good.sdf"), before) << command;
  }
  EXPECT_EQ(rigor("validate good.sdf --output json:/dev/null --output sarif:/dev/null").exit, 0);
}

TEST_F(Cli, AMisspeltElementIsToldOnce) {
  const std::string text =
      "<sdf version='1.9'><model name='m'><link name='a'><inertial><mass>600</mass><inertia>"
      "<ixx>100</ixx><iyy>100</iyy><izz>100</izz></inertia></inertial><collision "
      "name='c'><geometry>"
      "<box><size>1 1 1</size></box></geometry></collision><visual name='v'><geometry><box>"
      "<size>1 1 1</size></box></geometry></visual></link></model></sdf>";
  for (const std::string name : {"inertial", "mass", "inertia", "size"}) {
    std::string misspelt = text;
    for (const std::string& tag : {"<" + name + ">", "</" + name + ">"}) {
      misspelt.insert(misspelt.find(tag) + tag.size() - 1, "q");
    }
    folder_.put("slip.sdf", misspelt);
    const json found = json::parse(rigor("validate slip.sdf --format json").out)["diagnostics"];
    ASSERT_EQ(found.size(), 1U) << name << found.dump(1);
    EXPECT_EQ(found[0]["rule"], "unknown-element");
  }
}

TEST_F(Cli, OldVersionsThatBeginWithSdfAreChecked) {
  for (const char* version : {"1.0", "1.2"}) {
    folder_.put("old.sdf", "<sdf version='" + std::string(version) +
                               "'><model name='m'><link name='a'><self_collide>maybe"
                               "</self_collide></link></model></sdf>");
    EXPECT_EQ(rigor("validate old.sdf").exit, 1) << version;
  }
}

TEST_F(Cli, AClosedStderrIsNoResult) {
  const std::string closed = "sh -c 'exec \"$@\" 2>&-' sh";
  EXPECT_EQ(folder_.rigor("inspect good.sdf --output json:out.json", closed).exit, 0);
  EXPECT_TRUE(json::accept(folder_.get("out.json")));
  folder_.rigor("simulate good.sdf --output jsonl:out.jsonl", closed);
  EXPECT_FALSE(has(folder_.get("out.jsonl"), "1 model:"));
}

TEST_F(Cli, ALinkToNoFileIsToldOf) {
  folder_.put("w/a.sdf", folder_.get("good.sdf"));
  std::filesystem::create_symlink("nowhere", folder_.path("w/b.sdf"));
  EXPECT_TRUE(has(rigor("validate w").err, "b.sdf"));
}

TEST_F(Cli, EveryCommandTakesColor) {
  for (const char* command : {"inspect good.sdf", "diff good.sdf good.sdf", "rules", "resolve .",
                              "validate good.sdf", "inertia good.sdf"}) {
    const std::string with = std::string(command) + " --color ";
    EXPECT_EQ(rigor(with + "never").exit, 0) << command;
    EXPECT_EQ(rigor(with + "sometimes").exit, 2) << command;
  }
}

TEST_F(Cli, AnIncludePointsToTheFirstErrorInItsFile) {
  folder_.put("inc/model.sdf", kBad);
  folder_.put("inc/model.config",
              "<model><name>inc</name><sdf version='1.9'>model.sdf</sdf></model>");
  folder_.put("world.sdf",
              "<sdf version='1.9'><world name='w'><include><uri>model://inc</uri></include>"
              "</world></sdf>");
  const json found =
      json::parse(rigor("validate world.sdf --format json --select include-has-errors,"
                        "joint-limit-inverted --model-path .")
                      .out)["diagnostics"];
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0]["related"].size(), 1U);
  EXPECT_EQ(found[0]["related"][0]["path"], "inc/model.sdf");
  const json inside =
      json::parse(rigor("validate inc/model.sdf --format json --select joint-limit-inverted").out);
  EXPECT_EQ(found[0]["related"][0]["line"], inside["diagnostics"][0]["line"]);
}

TEST_F(Cli, HelpOpensWithAnExample) {
  for (const char* command : {"", "validate", "inspect", "rules", "explain", "schema", "resolve"}) {
    const Ran ran = rigor(std::string(command) + " --help");
    EXPECT_EQ(ran.exit, 0) << command;
    EXPECT_TRUE(ran.out.starts_with("Example")) << ran.out;
    EXPECT_TRUE(has(ran.out, "Usage:")) << command;
    EXPECT_EQ(ran.err, "") << command;
  }
}

TEST_F(Cli, VersionNamesTheEngines) {
  const Ran text = rigor("--version");
  EXPECT_EQ(text.exit, 0);
  EXPECT_TRUE(text.out.starts_with("rigor "));
  EXPECT_TRUE(has(text.out, "tinyxml2 "));
  const Ran machine = rigor("--version --format json");
  EXPECT_EQ(machine.exit, 0);
  const json document = json::parse(machine.out);
  EXPECT_EQ(document["tool"]["name"], "rigor");
  for (const char* engine :
       {"Eigen", "fmt", "meshoptimizer", "MuJoCo", "ODE", "Qhull", "tinyxml2"}) {
    ASSERT_TRUE(document["engines"].contains(engine)) << engine;
    const std::string version = document["engines"][engine];
    EXPECT_TRUE(std::isdigit(static_cast<unsigned char>(version.at(0)))) << version;
    EXPECT_TRUE(has(version, ".")) << version;
  }
}

TEST_F(Cli, CleanIsZero) {
  const Ran ran = rigor("validate good.sdf");
  EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
  EXPECT_TRUE(has(ran.err, "1 file checked")) << ran.err;
}

TEST_F(Cli, FindingsAreOneAndDataIsOnStdout) {
  const Ran ran = rigor("validate --format concise bad.sdf");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_TRUE(ran.out.starts_with("bad.sdf:")) << ran.out;
  EXPECT_TRUE(has(ran.out, ": error: ")) << ran.out;
  EXPECT_FALSE(has(ran.out, "checked"));
  EXPECT_TRUE(has(ran.err, "1 file checked: 1 error")) << ran.err;
}

TEST_F(Cli, PrettyIsTheDefault) {
  const Ran ran = rigor("validate bad.sdf");
  EXPECT_TRUE(ran.out.starts_with("error[")) << ran.out;
  EXPECT_TRUE(has(ran.out, "--> bad.sdf:")) << ran.out;
}

TEST_F(Cli, FailOnDecidesTheExitCode) {
  EXPECT_EQ(rigor("validate --fail-on never bad.sdf").exit, 0);
  EXPECT_EQ(rigor("validate --fail-on error bad.sdf").exit, 1);
  const std::string as =
      "validate bad.sdf --select joint-limit-inverted --severity joint-limit-inverted";
  EXPECT_EQ(rigor(as + "=warning").exit, 0);
  EXPECT_EQ(rigor(as + "=warning --fail-on warning").exit, 1);
  EXPECT_EQ(rigor(as + "=info --fail-on warning").exit, 0);
  EXPECT_EQ(rigor(as + "=info --fail-on info").exit, 1);
}

TEST_F(Cli, SelectAndIgnoreTakeRulesAndCategories) {
  EXPECT_EQ(rigor("validate --select joint-limit-inverted bad.sdf").exit, 1);
  EXPECT_EQ(rigor("validate --select kinematics bad.sdf").exit, 1);
  EXPECT_EQ(rigor("validate --select inertia --select frame bad.sdf").exit, 0);
  EXPECT_EQ(rigor("validate --select inertia,kinematics bad.sdf").exit, 1);
  EXPECT_EQ(rigor("validate --ignore joint-limit-inverted bad.sdf").exit, 0);
}

TEST_F(Cli, NoPathMeansThisFolder) {
  const Ran ran = rigor("validate --format json");
  EXPECT_EQ(ran.exit, 1);
  const json document = json::parse(ran.out);
  ASSERT_EQ(document["files"].size(), 2U);
  EXPECT_EQ(document["files"][0]["path"], "bad.sdf");
  EXPECT_EQ(document["files"][1]["path"], "good.sdf");
}

TEST_F(Cli, AFolderMayBeCalledLikeACommand) {
  folder_.put("rules/good.sdf", kGood);
  EXPECT_EQ(rigor("validate rules").exit, 0);
}

TEST_F(Cli, WrongInvocationsAreTwo) {
  for (const char* arguments : {"validate --no-such-option",
                                "validate --format nonsense good.sdf",
                                "validate missing.sdf",
                                "validate --select no-such-rule good.sdf",
                                "validate --ignore no-such-rule good.sdf",
                                "validate --severity no-such-rule=error good.sdf",
                                "validate --severity oops good.sdf",
                                "validate --fail-on sometimes good.sdf",
                                "validate --color sometimes good.sdf",
                                "validate --model-path missing good.sdf",
                                "validate --package arm=missing good.sdf",
                                "validate --package arm good.sdf",
                                "validate --format",
                                "validate --stdin-filename a.sdf good.sdf",
                                "no-such-command",
                                "inspect",
                                "inspect missing.sdf",
                                "inspect good.sdf --format nonsense",
                                "inspect good.sdf --joint no-such-joint=1",
                                "inspect good.sdf --joint elbow=wide",
                                "explain no-such-rule",
                                "schema 1.99",
                                "resolve a --from missing.sdf",
                                "rules --format nonsense",
                                "rules extra"}) {
    const Ran ran = rigor(arguments);
    EXPECT_EQ(ran.exit, 2) << arguments << '\n' << ran.out << ran.err;
    EXPECT_TRUE(has(ran.err, "rigor: ")) << arguments << '\n' << ran.err;
  }
}

TEST_F(Cli, WrongNamesGetSuggestions) {
  EXPECT_TRUE(has(rigor("validat good.sdf").err, "did you mean \"validate\"?"));
  EXPECT_TRUE(has(rigor("validate --formt json").err, "did you mean \"--format\"?"));
  EXPECT_TRUE(has(rigor("validate --format jsn").err, "did you mean \"json\"?"));
  EXPECT_TRUE(has(rigor("inspect good.sdf --joint elbw=1").err, "elbow"));
  const json rules = json::parse(rigor("rules --format json").out);
  const std::string rule = rules["rules"][0]["name"];
  const std::string typo = rule.substr(0, rule.size() - 1);
  EXPECT_TRUE(has(rigor("explain " + typo).err, "\"" + rule + "\"")) << rule;
  EXPECT_TRUE(has(rigor("validate --select " + typo).err, "\"" + rule + "\"")) << rule;
}

TEST_F(Cli, WhatCouldBeCheckedIsReportedBesideWhatIsMissing) {
  const Ran ran = rigor("validate --format concise missing.sdf bad.sdf");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_TRUE(has(ran.out, "bad.sdf:")) << ran.out;
  EXPECT_TRUE(has(ran.err, "missing.sdf: ")) << ran.err;
}

TEST_F(Cli, AFolderWithoutModelsIsTwo) {
  folder_.put("empty/readme.txt", "nothing");
  EXPECT_EQ(rigor("validate empty").exit, 2);
}

TEST_F(Cli, OutputMayBeGivenSeveralTimes) {
  const Ran ran = rigor(
      "validate bad.sdf --output json:out.json --output concise:out.txt "
      "--output concise");
  EXPECT_EQ(ran.exit, 1) << ran.err;
  EXPECT_EQ(json::parse(folder_.get("out.json"))["summary"]["errors"], 1);
  EXPECT_EQ(folder_.get("out.txt"), ran.out);
  EXPECT_TRUE(ran.out.starts_with("bad.sdf:"));
}

TEST_F(Cli, OnlyOneOutputMayLeaveOutItsFile) {
  EXPECT_EQ(rigor("validate good.sdf --output json --output concise").exit, 2);
  EXPECT_EQ(rigor("validate good.sdf --format json --output concise").exit, 2);
  const Ran ran = rigor("validate good.sdf --format json --output concise:out.txt");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_EQ(json::parse(ran.out)["summary"]["files"], 1);
}

TEST_F(Cli, OutputNextToAFileThatExistsReplacesIt) {
  folder_.put("out.json", "old");
  EXPECT_EQ(rigor("validate good.sdf --output json:out.json").exit, 0);
  EXPECT_EQ(json::parse(folder_.get("out.json"))["summary"]["files"], 1);
  EXPECT_EQ(rigor("validate good.sdf --output json:missing/out.json").exit, 2);
}

TEST_F(Cli, OutputOfAFileNameIsAnsweredWithDashO) {
  const Ran ran = rigor("validate good.sdf --output robot.urdf");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_TRUE(has(ran.err, "did you mean -o")) << ran.err;
}

/// Commands without reports have only -o, and some of them need it.
TEST_F(Cli, OutputOfACommandWithoutReportsIsAnsweredWithDashO) {
  for (const char* arguments :
       {"edit rename a b good.sdf", "upgrade good.sdf", "expand good.sdf", "srdf good.sdf",
        "view good.sdf", "render good.sdf", "report good.sdf"}) {
    const Ran ran = rigor(std::string(arguments) + " --output robot.urdf");
    EXPECT_EQ(ran.exit, 2) << arguments;
    EXPECT_EQ(ran.err, "rigor: unknown option --output; did you mean \"-o\"?\n") << arguments;
  }
  EXPECT_EQ(rigor("render good.sdf").err, "rigor: --out is required\n");
}

TEST_F(Cli, DashIsStdin) {
  const Ran unnamed = rigor("validate - --format json", "cat bad.sdf |");
  EXPECT_EQ(unnamed.exit, 1) << unnamed.err;
  EXPECT_EQ(json::parse(unnamed.out)["files"][0]["path"], "<stdin>");
  const Ran named = rigor("validate - --stdin-filename arm/arm.sdf --format json", "cat bad.sdf |");
  EXPECT_EQ(named.exit, 1) << named.err;
  EXPECT_EQ(json::parse(named.out)["diagnostics"][0]["path"], "arm/arm.sdf");
  EXPECT_EQ(rigor("validate -", "cat good.sdf |").exit, 0);
}

TEST_F(Cli, ColorIsForPeopleOnly) {
  const auto colored = [&](const std::string& arguments, const std::string& variables = "") {
    return has(rigor("validate bad.sdf " + arguments, variables).out, "\x1b[");
  };
  EXPECT_FALSE(colored(""));  // stdout is no terminal
  EXPECT_TRUE(colored("--color always"));
  EXPECT_TRUE(colored("", "CLICOLOR_FORCE=1"));
  EXPECT_FALSE(colored("", "CLICOLOR_FORCE=0"));
  EXPECT_FALSE(colored("", "NO_COLOR=1 CLICOLOR_FORCE=1"));
  EXPECT_TRUE(colored("--color always", "NO_COLOR=1"));
  EXPECT_FALSE(colored("--color never", "CLICOLOR_FORCE=1"));
  EXPECT_FALSE(colored("--color always --format json"));
  EXPECT_FALSE(colored("--color always --format concise"));
}

TEST_F(Cli, SameBytesInSameBytesOut) {
  EXPECT_EQ(rigor("validate --format json").out, rigor("validate --format json").out);
}

TEST_F(Cli, InspectTsv) {
  const Ran ran = rigor("inspect good.sdf --format tsv");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ(ran.out,
            "model\tarm\t0\t0\t0\t1\t0\t0\t0\t\n"
            "link\tarm::base\t0\t0\t0\t1\t0\t0\t0\t2 0 0 0 0.1 0 0 0.1 0 0.1\n"
            "link\tarm::fore\\sarm\t0\t0\t1\t1\t0\t0\t0\t1 0 0 0 0.1 0 0 0.1 0 0.1\n"
            "joint\tarm::elbow\t0\t0\t1\t1\t0\t0\t0\tbase fore\\sarm revolute 0 0 1\n");
}

TEST_F(Cli, InspectTsvIsInTheOrderOfTheFile) {
  folder_.put("mixed.sdf",
              R"(<sdf version='1.9'><world name='w'><frame name='first'/><model name='m'>
  <joint name='j' type='fixed'><parent>b</parent><child>a</child></joint>
  <frame name='f'/>
  <link name='b'><visual name='v'><geometry><empty/></geometry></visual>
    <collision name='c'><geometry><empty/></geometry></collision></link>
  <model name='n'><link name='l'/></model>
  <link name='a'/></model></world></sdf>)");
  const std::string out = rigor("inspect mixed.sdf --format tsv").out;
  std::string names;
  for (std::size_t at = 0; at < out.size(); at = out.find('\n', at) + 1) {
    const std::size_t name = out.find('\t', at) + 1;
    names += out.substr(name, out.find('\t', name) - name) + ' ';
  }
  EXPECT_EQ(names, "first m m::j m::f m::b m::b::v m::b::c m::n m::n::l m::a ");
}

TEST_F(Cli, InspectMovesJoints) {
  const Ran ran = rigor("inspect good.sdf --format json --joint elbow=3.141592653589793");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  const json link = json::parse(ran.out)["models"][0]["links"][1];
  EXPECT_NEAR(link["pose"]["quaternion_wxyz"][3].get<double>(), 1, 1e-12);
}

TEST_F(Cli, InspectText) {
  const Ran ran = rigor("inspect good.sdf");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_TRUE(has(ran.out, "model \"arm\"")) << ran.out;
  EXPECT_TRUE(has(ran.out, "total: 2 links, 1 joint, 3 kg")) << ran.out;
  EXPECT_TRUE(has(ran.out, "(default)")) << ran.out;
}

TEST_F(Cli, InspectDot) {
  const Ran ran = rigor("inspect good.sdf --format dot");
  EXPECT_TRUE(ran.out.starts_with("digraph \"good.sdf\" {\n")) << ran.out;
  EXPECT_TRUE(has(ran.out, "link0 -> link1 [label=\"arm::elbow (revolute)\"];")) << ran.out;
}

TEST_F(Cli, InspectOfADamagedFileIsOne) {
  folder_.put("damaged.sdf", kDamaged);
  const Ran ran = rigor("inspect damaged.sdf");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_TRUE(has(ran.out, "model \"arm\"")) << ran.out;
  EXPECT_TRUE(has(ran.err, "not well-formed")) << ran.err;
}

TEST_F(Cli, InspectTakesAFolder) {
  folder_.put("arm/model.sdf", kGood);
  folder_.put("arm/model.config",
              "<model><name>arm</name><sdf version=\"1.9\">model.sdf</sdf></model>");
  EXPECT_EQ(rigor("inspect arm --format tsv").out, rigor("inspect good.sdf --format tsv").out);
}

TEST_F(Cli, RulesAreListed) {
  EXPECT_TRUE(rigor("rules").out.starts_with("rule "));
  EXPECT_TRUE(rigor("rules --format markdown").out.starts_with("# Rules\n"));
  const json rules = json::parse(rigor("rules --format json").out)["rules"];
  ASSERT_FALSE(rules.empty());
  for (const json& rule : rules) {
    const std::string name = rule["name"];
    if (!test::in_part(name)) continue;
    const Ran page = rigor("explain " + name);
    EXPECT_EQ(page.exit, 0) << name << page.err;
    EXPECT_TRUE(page.out.starts_with(name + ": ")) << name;
    EXPECT_FALSE(has(page.out, "«")) << name;
  }
}

TEST_F(Cli, SchemaPrintsAFormat) {
  EXPECT_EQ(rigor("schema 1.9").exit, 0);
  EXPECT_EQ(rigor("schema 1.9 --docs").out, rigor("schema 1.9").out);
  EXPECT_TRUE(has(rigor("schema 1.9 --xsd").out, "schema"));
  EXPECT_EQ(rigor("schema urdf --xsd").exit, 0);
  EXPECT_EQ(rigor("schema 1.9 --xsd --docs").exit, 2);
}

TEST_F(Cli, ResolvePrintsTheAnswerAndTheSearch) {
  folder_.put("models/arm/mesh.stl", "solid");
  const Ran found = rigor("resolve model://arm/mesh.stl --model-path models");
  EXPECT_EQ(found.exit, 0) << found.out;
  EXPECT_TRUE(found.out.starts_with("models/arm/mesh.stl\n")) << found.out;
  EXPECT_TRUE(has(found.out, "--model-path")) << found.out;
  const Ran variable = rigor("resolve model://arm/mesh.stl", "GZ_SIM_RESOURCE_PATH=models");
  EXPECT_EQ(variable.exit, 0) << variable.out;
  const Ran missing = rigor("resolve model://hand/mesh.stl --model-path models");
  EXPECT_EQ(missing.exit, 1);
  EXPECT_TRUE(has(missing.out, "tried models/hand/mesh.stl")) << missing.out;
  EXPECT_TRUE(has(missing.out, "GZ_SIM_RESOURCE_PATH")) << missing.out;
  const Ran package = rigor("resolve package://arm/mesh.stl --package arm=models/arm");
  EXPECT_EQ(package.exit, 0) << package.out;
  const Ran relative = rigor("resolve mesh.stl --from good.sdf");
  EXPECT_EQ(relative.exit, 1);
  folder_.put("mesh.stl", "solid");
  EXPECT_EQ(rigor("resolve mesh.stl --from good.sdf").exit, 0);
}

}  // namespace
}  // namespace rigor::test
