// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor simulate` and `rigor merge` as their users script them.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <tinyxml2.h>
#include <nlohmann/json.hpp>

#include <cli/program.h>

namespace rigor::test {
namespace {

using nlohmann::json;

constexpr const char* kCrate = R"(<sdf version='1.9'>
  <model name='crate'>
    <link name='body'>
      <pose>0 0 0.1 0 0 0</pose>
      <inertial>
        <mass>6</mass>
        <inertia><ixx>0.04</ixx><iyy>0.04</iyy><izz>0.04</izz></inertia>
      </inertial>
      <collision name='c'><geometry><box><size>0.2 0.2 0.2</size></box></geometry></collision>
    </link>
  </model>
</sdf>
)";

/// A slider on the world's side: 2 kg that a command moves along x.
constexpr const char* kSlider = R"(<sdf version='1.9'>
  <model name='slide'>
    <link name='cart'>
      <pose>0 0 1 0 0 0</pose>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia>
      </inertial>
    </link>
    <joint name='rail' type='prismatic'>
      <parent>world</parent>
      <child>cart</child>
      <axis><xyz>1 0 0</xyz><limit><lower>-5</lower><upper>5</upper></limit></axis>
    </joint>
  </model>
</sdf>
)";

std::ptrdiff_t times_found(const json& result, const std::string& rule) {
  const json& found = result["diagnostics"];
  return std::count_if(found.begin(), found.end(),
                       [&](const json& each) { return each["rule"] == rule; });
}

/// Arms on a base, each of 1 kg, 0.1 m from its joint.
std::string arms(int count, const std::string& limit) {
  std::string urdf = R"(<robot name="arms">
  <link name="base">
    <inertial><mass value="5"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><geometry><box size="0.4 0.4 0.1"/></geometry></collision>
  </link>
)";
  for (int i = 0; i < count; ++i) {
    const std::string n = std::to_string(i);
    urdf += "  <link name='arm" + n + R"('><inertial><origin xyz="0.1 0 0"/><mass value="1"/>
    <inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name='joint)" +
            n + "' type='revolute'><parent link='base'/><child link='arm" + n +
            "'/><origin xyz='0.3 " + n + R"( 0.5'/><axis xyz="0 1 0"/>
    <limit velocity='1' )" +
            limit + "/></joint>\n";
  }
  return urdf + "</robot>\n";
}

class SimulateCli : public testing::Test {
 protected:
  SimulateCli() {
    folder_.put("crate.sdf", kCrate);
    folder_.put("slide.sdf", kSlider);
  }

  Ran simulate(const std::string& arguments) const {
    return folder_.rigor("simulate " + arguments);
  }
  json simulated(const std::string& arguments) const {
    return json::parse(simulate(arguments + " --format json").out);
  }

  Folder folder_;
};

TEST_F(SimulateCli, ASaneModelPasses) {
  const Ran ran = simulate("crate.sdf");
  EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("crate.sdf: pass"), std::string::npos) << ran.out;
  EXPECT_EQ(ran.err, "1 model: 1 pass\n");
}

/// Two crates in one that overlap in every test.
TEST_F(SimulateCli, AFaultOfSeveralTestsIsSaidOnce) {
  std::string text = kCrate;
  const std::string pose = "<pose>0 0 0.1 0 0 0</pose>";
  text.replace(text.find(pose), pose.size(), "<pose>0 0 0.05 0 0 0</pose>");
  folder_.put("sunk.sdf", text);
  const json found = simulated("sunk.sdf --test settle,drop,push,settle");
  EXPECT_EQ(times_found(found, "simulate-spawned-in-ground"), 1) << found;
}

/// An arm of 1 kg at 0.1 m, which takes 0.98 N·m: it stops short, needs more than there is, and sinks.
TEST_F(SimulateCli, AJointThatIsTooWeakIsSaidOnce) {
  folder_.put("weak.urdf", arms(1, "lower='-1' upper='1' effort='0.5'"));
  const json found = simulated("weak.urdf --test hold,joint-sweep");
  EXPECT_EQ(times_found(found, "simulate-joint-overloaded"), 1) << found;
}

TEST_F(SimulateCli, LimitsThatLeaveZeroOutAreOneFinding) {
  folder_.put("three.urdf", arms(3, "lower='0.3' upper='1' effort='9'"));
  const std::string out = simulate("three.urdf").out;
  const std::size_t first = out.find("simulate-start-moved");
  ASSERT_NE(first, std::string::npos) << out;
  EXPECT_EQ(out.find("simulate-start-moved", first + 1), std::string::npos) << out;
  EXPECT_NE(out.find("2 more"), std::string::npos) << out;
}

/// `settle` watches it for 1 s and `drop` for 2 s, each with a limit of its own.
TEST_F(SimulateCli, WhatNeverSettlesIsSaidOnce) {
  std::string text = kCrate;
  const std::string box = "<box><size>0.2 0.2 0.2</size></box>";
  text.replace(text.find(box), box.size(), "<sphere><radius>0.1</radius></sphere>");
  text.insert(text.find("<mass>"), "<pose>0.02 0 0 0 0 0</pose>");
  folder_.put("restless.sdf", text);
  const json found = simulated("restless.sdf --test settle,drop,push");
  EXPECT_EQ(times_found(found, "simulate-never-settles"), 1) << found;
}

TEST_F(SimulateCli, ABaseIsHeldAsAsked) {
  const json run = simulated("crate.sdf --base fixed")["runs"][0];
  EXPECT_EQ(run["base"], "fixed");
  EXPECT_EQ(simulate("crate.sdf --base nailed").exit, 2);
  const json left = simulated("crate.sdf --base hang --test push")["left_out"];
  EXPECT_EQ(left, json({"push: its base is held, as --base says"}));
}

TEST_F(SimulateCli, ASliderIsToldInMeters) {
  std::string text = kSlider;
  text.replace(text.find("<lower>-5"), 9, "<lower>0.5");
  folder_.put("off.sdf", text);
  const json result = simulated("off.sdf");
  EXPECT_NE(result.dump().find("begins 0.5 m outside its limits"), std::string::npos) << result;
  for (const json& metric : result["runs"][0]["metrics"]) {
    if (metric["id"] == "joint.limit_violation") {
      EXPECT_EQ(metric["unit"], "m");
    }
    if (metric["id"] == "tilt.max") {
      EXPECT_EQ(metric["unit"], "rad");
    }
  }
}

TEST_F(SimulateCli, JsonIsAsTheContractSays) {
  const json result = simulated("crate.sdf");
  EXPECT_EQ(result["model"], "crate.sdf");
  EXPECT_EQ(result["verdict"], "pass");
  EXPECT_TRUE(result["diagnostics"].is_array());
  ASSERT_EQ(result["runs"].size(), 1U);
  const json& run = result["runs"][0];
  EXPECT_EQ(run["test"], "settle");
  EXPECT_EQ(run["verdict"], "pass");
  EXPECT_TRUE(run["commands"].is_array());
  EXPECT_FALSE(run["state_hash"].get<std::string>().empty());
  ASSERT_FALSE(run["metrics"].empty());
  for (const json& metric : run["metrics"]) {
    for (const char* key : {"id", "value", "unit", "warn", "fail", "verdict"}) {
      EXPECT_TRUE(metric.contains(key)) << metric;
    }
  }
  const json& pose = run["final"]["pose"]["crate::body"];
  ASSERT_EQ(pose.size(), 7U);
  EXPECT_NEAR(pose[2].get<double>(), 0.1, 2e-3);
  EXPECT_NEAR(pose[3].get<double>(), 1, 1e-3);
}

TEST_F(SimulateCli, CasesOfOneModelAreItsRuns) {
  const json result = simulated("crate.sdf --grid friction=0.2:1:3 --seeds 2");
  EXPECT_EQ(result["model"], "crate.sdf");
  EXPECT_EQ(result["verdict"], "pass");
  ASSERT_EQ(result["runs"].size(), 6U);
  EXPECT_EQ(result["runs"][0]["case"], "friction=0.2 seed=0");
  EXPECT_EQ(result["runs"][5]["case"], "friction=1 seed=1");
  const Ran table = simulate("crate.sdf --grid friction=0.2:1:3");
  EXPECT_NE(table.out.find("crate.sdf [friction=0.6 seed=0]"), std::string::npos) << table.out;
  EXPECT_EQ(table.err, "1 model in 3 cases: 3 pass\n");
}

TEST_F(SimulateCli, WheelsThatDoNotTurnDoNotTurnTheModel) {
  ASSERT_EQ(folder_.rigor("new bot --template diff-drive").exit, 0);
  EXPECT_EQ(simulate("bot --test turn").exit, 0);
  std::string text = folder_.get("bot/model.sdf");
  const std::string effort = "<effort>5</effort>";
  for (std::size_t at = text.find(effort); at != std::string::npos; at = text.find(effort)) {
    text.replace(at, effort.size(), "<effort>0.0001</effort>");
  }
  folder_.put("bot/model.sdf", text);
  const Ran ran = simulate("bot --test turn");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.out.find("turn.arc"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("turn.spin"), std::string::npos) << ran.out;
}

TEST_F(SimulateCli, TheSameCommandGivesTheSameBytes) {
  const std::string all = "crate.sdf --test settle,drop,push --seeds 2 --format json";
  const Ran once = simulate(all);
  EXPECT_EQ(once.out, simulate(all).out);
  EXPECT_EQ(once.out, simulate(all + " -j 2").out);
  EXPECT_EQ(once.out, simulate(all + " -j 7").out);
}

TEST_F(SimulateCli, ACommandMovesWhatItNames) {
  // 2 m/s, reached after 1 s of ramp: 1 m, and then 2 m/s for 1.5 s.
  const json fast = simulated("slide.sdf --command rail=velocity:2 --duration 2.5");
  EXPECT_NEAR(fast["runs"][0]["final"]["pose"]["slide::cart"][0].get<double>(), 4, 0.02);
  // 4 N on 2 kg for 1 s without a ramp: 1 m. The same in either direction.
  for (const int sign : {1, -1}) {
    const json pushed = simulated("slide.sdf --command rail=effort:" + std::to_string(4 * sign) +
                                  " --duration 1 --ramp 0");
    EXPECT_NEAR(pushed["runs"][0]["final"]["pose"]["slide::cart"][0].get<double>(), sign, 2e-3);
  }
  const json placed = simulated("slide.sdf --command rail=position:1.5 --duration 3");
  EXPECT_NEAR(placed["runs"][0]["final"]["pose"]["slide::cart"][0].get<double>(), 1.5, 5e-3);
}

TEST_F(SimulateCli, AScenarioDemands) {
  folder_.put("go.scenario.toml", R"(model = "slide.sdf"
[[step]]
until = 2.5
commands = [{joint = "rail", velocity = 2, ramp = 1}]
[[assert]]
name = "arrives"
position = "cart"
axis = "x"
min = 3.9
max = 4.1
)");
  EXPECT_EQ(simulate("--scenario go.scenario.toml").exit, 0);
  folder_.put("far.scenario.toml", R"(model = "slide.sdf"
[[step]]
until = 2.5
commands = [{joint = "rail", velocity = 2, ramp = 1}]
[[assert]]
name = "arrives"
position = "cart"
axis = "x"
min = 4.5
)");
  const Ran failed = simulate("--scenario far.scenario.toml");
  EXPECT_EQ(failed.exit, 1);
  EXPECT_NE(failed.out.find("simulate-assertion"), std::string::npos) << failed.out;
  EXPECT_NE(failed.out.find("arrives"), std::string::npos) << failed.out;
}

TEST_F(SimulateCli, AScenarioSaysHowItIsRun) {
  // Free fall from 0.1 m above: t²g/2 at the moon's gravity, and so many steps as the step allows.
  folder_.put("fall.toml", R"(model = "crate.sdf"
[world]
gravity = [0, 0, -1.62]
ground = false
[run]
time-step = 0.01
solver = "dantzig"
[[step]]
until = 1
)");
  const json moon = simulated("--scenario fall.toml");
  EXPECT_EQ(moon["runs"][0]["steps"], 100);
  // Semi-implicit Euler: g t (t + h) / 2.
  const double fallen = 0.1 - moon["runs"][0]["final"]["pose"]["crate::body"][2].get<double>();
  EXPECT_NEAR(fallen, 1.62 * 1 * 1.01 / 2, 1e-9);
  const json finer = simulated("--scenario fall.toml --time-step 0.005 --gravity 0 0 -9.8");
  EXPECT_EQ(finer["runs"][0]["steps"], 200) << "the command line goes before the file";
  const double faster = 0.1 - finer["runs"][0]["final"]["pose"]["crate::body"][2].get<double>();
  EXPECT_NEAR(faster, 9.8 * 1 * 1.005 / 2, 1e-9);
}

TEST_F(SimulateCli, WhatCannotMovePasses) {
  std::string text = kCrate;
  folder_.put("still.sdf", text.insert(text.find("<link"), "<static>true</static>"));
  const Ran ran = simulate("still.sdf --test settle,drive");
  EXPECT_EQ(ran.exit, 0) << ran.out;
  EXPECT_NE(ran.out.find("simulate-nothing-moves"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("drive: nothing moves"), std::string::npos) << ran.out;
}

/// `pass` is no praise of what nobody tried.
TEST_F(SimulateCli, ThatNothingWasTestedIsSaid) {
  const Ran ran = simulate("crate.sdf --test drive");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_TRUE(ran.out.starts_with("crate.sdf: pass, but nothing was tested\n")) << ran.out;
  EXPECT_EQ(ran.err, "1 model: 1 pass; 1 untested\n");
  const Ran named = simulate("slide.sdf --test drive --wheels rail");
  EXPECT_NE(named.out.find("named as wheels"), std::string::npos) << named.out;
  EXPECT_EQ(simulate("crate.sdf --test settle,drive").err, "1 model: 1 pass\n");
}

/// 1 kg, 0.5 m from its hinge, and 0.01 kg·m² of its own; 1 rad/s in a quarter of a second. It begins level:
/// 1 · 9.8 · 0.5 N·m of weight and (0.01 + 0.25) · 4 N·m to start.
TEST_F(SimulateCli, ASweepTellsWhatTheJointNeeds) {
  for (const double limit : {1.0, 4.0, 50.0}) {
    folder_.put(
        "lever.sdf",
        "<sdf version='1.9'><model name='lever'><link name='l'><pose>0 0 2 0 0 0</pose>"
        "<inertial><pose>0.5 0 0 0 0 0</pose><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01"
        "</iyy><izz>0.01</izz></inertia></inertial></link><joint name='h' type='revolute'>"
        "<parent>world</parent><child>l</child><axis><xyz>0 1 0</xyz><limit><lower>-2</lower>"
        "<upper>2</upper><velocity>1</velocity><effort>" +
            std::to_string(limit) + "</effort></limit></axis></joint></model></sdf>");
    const json result = simulated("lever.sdf --test joint-sweep");
    double share = 0;
    for (const json& metric : result["runs"][0]["metrics"]) {
      if (metric["id"] == "joint.effort") share = metric["value"];
    }
    EXPECT_NEAR(share * limit, 4.9 + 0.26 * 4, 0.06) << limit;
    EXPECT_EQ(result["verdict"], limit < 5 ? "fail" : "pass");
  }
}

/// Verdicts stand beside names of any length.
TEST_F(SimulateCli, ATableHasSpacesBetweenItsColumns) {
  const Ran ran = simulate("slide.sdf --test joint-sweep,settle");
  EXPECT_NE(ran.out.find("  joint-sweep "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("  settle      "), std::string::npos) << ran.out;
}

/// 20 s unless another is given, which is a number.
TEST_F(SimulateCli, ABudgetIsANumberOfSeconds) {
  EXPECT_NE(folder_.rigor("simulate --help").out.find("CPU time for each model, s (20)"),
            std::string::npos);
  EXPECT_EQ(simulate("crate.sdf --budget 0").exit, 0);
  for (const char* wrong : {"much", "-1", "nan"}) {
    const Ran ran = simulate(std::string("crate.sdf --budget ") + wrong);
    EXPECT_EQ(ran.exit, 2) << wrong;
    EXPECT_NE(ran.err.find("--budget"), std::string::npos) << ran.err;
  }
}

/// A crate with 36 times the inertia of its shape.
std::string heavy_crate(const std::string& mass, const std::string& size,
                        const std::string& inertia, const std::string& height) {
  return "<model name='crate'><link name='body'><pose>0 0 " + height +
         " 0 0 0</pose><inertial><mass>" + mass + "</mass><inertia><ixx>" + inertia +
         "</ixx><iyy>" + inertia + "</iyy><izz>" + inertia +
         "</izz></inertia></inertial><collision name='c'><geometry><box><size>" + size + " " +
         size + " " + size + "</size></box></geometry></collision></link></model>";
}

/// Advice is what the command that it names would do.
TEST_F(SimulateCli, AdviceOfAnInertiaIsTriedBeforeItIsGiven) {
  constexpr const char* kWrite = "rigor inertia MODEL --write";
  // 5 kg·m² of its shape: 30 · 1² / 6.
  folder_.put("wrong.sdf", "<sdf version='1.9'>" + heavy_crate("30", "1", "180", "0.5") + "</sdf>");
  EXPECT_NE(simulate("wrong.sdf").out.find(kWrite), std::string::npos);
  EXPECT_NE(folder_.rigor("inertia wrong.sdf --diff").out.find("<ixx>5</ixx>"), std::string::npos);
  // A tonne in a cube of 0.1 m: the shape is a stand-in, and no inertia is taken from it.
  folder_.put("crude.sdf",
              "<sdf version='1.9'>" + heavy_crate("1000", "0.1", "60", "0.05") + "</sdf>");
  const Ran crude = simulate("crude.sdf");
  EXPECT_NE(crude.out.find("36 times the inertia of its shape"), std::string::npos) << crude.out;
  EXPECT_EQ(crude.out.find(kWrite), std::string::npos) << crude.out;
  EXPECT_NE(crude.out.find("from its CAD model"), std::string::npos) << crude.out;
  EXPECT_EQ(folder_.rigor("inertia crude.sdf --diff").out, "");
  // Of a template the model is not what is edited.
  folder_.put("wrong.sdf.xacro", "<sdf version='1.9' xmlns:xacro='http://www.ros.org/wiki/xacro'>" +
                                     heavy_crate("30", "1", "180", "0.5") + "</sdf>");
  const Ran expanded = simulate("wrong.sdf.xacro");
  EXPECT_EQ(expanded.out.find(kWrite), std::string::npos) << expanded.out;
  EXPECT_NE(expanded.out.find("in the template"), std::string::npos) << expanded.out;
}

/// The inertia of an included link is written in the included file, and `rigor inertia` is told that.
TEST_F(SimulateCli, AdviceOfAnIncludedInertiaNamesTheIncludedFile) {
  folder_.put("models/crate/model.config",
              "<model><name>crate</name><sdf version='1.9'>model.sdf</sdf></model>");
  folder_.put("models/crate/model.sdf",
              "<sdf version='1.9'>" + heavy_crate("30", "1", "180", "0.5") + "</sdf>");
  folder_.put("cell.sdf",
              "<sdf version='1.9'><model name='cell'><include><uri>model://crate</uri></include>"
              "</model></sdf>");
  const Ran ran = simulate("cell.sdf --model-path models");
  EXPECT_NE(ran.out.find("models/crate/model.sdf --write`"), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find("CAD"), std::string::npos) << ran.out;
  EXPECT_NE(folder_.rigor("inertia models/crate/model.sdf --diff").out.find("<ixx>5</ixx>"),
            std::string::npos);
}

TEST_F(SimulateCli, AWrongInvocationIsTold) {
  const auto usage = [this](const std::string& arguments, const std::string& says) {
    const Ran ran = simulate(arguments);
    EXPECT_EQ(ran.exit, 2) << arguments;
    EXPECT_EQ(ran.out, "") << arguments;
    EXPECT_NE(ran.err.find(says), std::string::npos) << arguments << ": " << ran.err;
  };
  usage("", "needs a model");
  usage("nothing.sdf", "nothing.sdf");
  usage("crate.sdf --test sttle", "settle");
  usage("slide.sdf --command rial=velocity:1", "did you mean");
  usage("slide.sdf --test drive --wheels rial", "there is no joint rial; did you mean");
  usage("slide.sdf --command rail=velocty:1", "velocity");
  usage("slide.sdf --command rail=velocity:fast", "no finite number");
  usage("crate.sdf --grid fricton=0:1:3", "friction");
  usage("crate.sdf --grid mass=0:1:3", "above zero");
  usage("crate.sdf --shard 3/2", "I/N");
  usage("crate.sdf --time-step 0", "above 0");
  usage("crate.sdf --resume", "jsonl");
  usage("crate.sdf --model crat", "did you mean \"crate\"");
  usage("crate.sdf --duration 3", "--command");
  folder_.put("bad.toml", "[[step]]\nuntil = 1\nunitl = 2\n");
  usage("crate.sdf --scenario bad.toml", "bad.toml:3: [step] unknown key unitl");
}

TEST_F(SimulateCli, WhatAnEngineCannotTakeIsADiagnosis) {
  std::string text = kCrate;
  folder_.put("bad.sdf", text.replace(text.find(">6<"), 3, ">nan<"));
  const Ran ran = simulate("bad.sdf --format json");
  EXPECT_EQ(ran.exit, 1);
  const json result = json::parse(ran.out);
  EXPECT_EQ(result["verdict"], "invalid");
  ASSERT_FALSE(result["diagnostics"].empty());
  EXPECT_EQ(result["diagnostics"][0]["line"], 6);
}

TEST_F(SimulateCli, AFolderGivesATable) {
  folder_.put("models/a.sdf", kCrate);
  folder_.put("models/deep/b.sdf", kCrate);
  const Ran ran = simulate("models");
  EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("models/a.sdf"), std::string::npos);
  EXPECT_NE(ran.out.find("models/deep/b.sdf"), std::string::npos);
  EXPECT_EQ(ran.err, "2 models: 2 pass\n");
}

TEST_F(SimulateCli, ABrokenFileAmongOthersIsNotPassedOver) {
  folder_.put("models/a.sdf", kCrate);
  folder_.put("models/b.sdf", "<sdf version='1.9'><model name='m'");
  const Ran ran = simulate("models");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.out.find("invalid models/b.sdf"), std::string::npos) << ran.out;
  EXPECT_EQ(ran.err, "2 models: 1 pass, 1 invalid\n");
}

TEST_F(SimulateCli, JunitIsWellFormedAndCounts) {
  const Ran ran = simulate("crate.sdf --test settle,drive --format junit");
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(ran.out.c_str()), tinyxml2::XML_SUCCESS) << ran.out;
  const tinyxml2::XMLElement* suite = document.RootElement()->FirstChildElement("testsuite");
  ASSERT_NE(suite, nullptr);
  EXPECT_EQ(suite->IntAttribute("tests"), 2);
  EXPECT_EQ(suite->IntAttribute("failures"), 0);
  EXPECT_EQ(suite->IntAttribute("skipped"), 1);
}

TEST_F(SimulateCli, CsvHasTheTrajectory) {
  const Ran ran = simulate("slide.sdf --command rail=velocity:2 --duration 2.5 --format csv");
  EXPECT_EQ(ran.out.substr(0, 21), "model,test,seed,time,");
  EXPECT_NE(ran.out.find("slide::rail.position"), std::string::npos);
  // A row each hundredth of a second, the first and last moments among them.
  const auto lines = std::count(ran.out.begin(), ran.out.end(), '\n');
  EXPECT_GE(lines, 251);
  EXPECT_LE(lines, 253);
}

TEST_F(SimulateCli, HtmlLoadsNothingAndNamesAreHarmless) {
  std::string text = kCrate;
  const std::string hostile = "&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;";
  for (const char* name : {"crate", "body"}) {
    const std::string quoted = std::string("'") + name + "'";
    text.replace(text.find(quoted), quoted.size(), "'" + hostile + name + "'");
  }
  folder_.put("hostile.sdf", text);
  const Ran ran = simulate("hostile.sdf --format html");
  EXPECT_NE(ran.out.find("default-src 'none'"), std::string::npos);
  EXPECT_NE(ran.out.find("<svg"), std::string::npos);
  EXPECT_EQ(ran.out.find("<img src=x"), std::string::npos);
  EXPECT_EQ(ran.out.find("<script"), std::string::npos);
  EXPECT_EQ(ran.out.find("http"), ran.out.find("http-equiv")) << "nothing is loaded";
}

/// What a reader wants to know stands first: the image, the path, the verdict, the causes. The rest is folded.
TEST_F(SimulateCli, HtmlBeginsWithTheImageTheVerdictAndTheCauses) {
  // A pole that stands askew.
  folder_.put(
      "top.sdf",
      "<sdf version='1.9'><model name='top'><link name='l'><pose>0 0 0 0.4 0 0</pose><inertial>"
      "<pose>0 0 0.5 0 0 "
      "0</pose><mass>1</mass><inertia><ixx>0.0835</ixx><iyy>0.0835</iyy><izz>0.0005</izz>"
      "</inertia></inertial><collision name='c'><pose>0 0 0.5 0 0 0</pose><geometry><box>"
      "<size>0.05 0.05 1</size></box></geometry></collision></link></model></sdf>");
  const std::string page = simulate("top.sdf --format html").out;
  const std::size_t path = page.find("<h2>top.sdf</h2>");
  const std::size_t verdict = page.find("<span class=\"verdict fail\">fail</span>");
  const std::size_t causes = page.find("<ol class=\"causes\">");
  const std::size_t folded = page.find("<details");
  const std::size_t plot = page.find("<svg");
  ASSERT_NE(causes, std::string::npos) << page;
  EXPECT_LT(path, verdict);
  EXPECT_LT(verdict, causes);
  EXPECT_LT(causes, folded);
  EXPECT_LT(folded, plot);
  EXPECT_NE(plot, std::string::npos);
  EXPECT_EQ(page.find("<details open"), std::string::npos);
  const std::string list = page.substr(causes, page.find("</ol>") - causes);
  std::size_t items = 0;
  for (std::size_t at = list.find("<li>"); at != std::string::npos; at = list.find("<li>", at + 1))
    ++items;
  EXPECT_GE(items, 1U);
  EXPECT_LE(items, 3U);
  const std::size_t picture = page.find("<img src=\"data:image/png");
  EXPECT_TRUE(picture == std::string::npos || picture < path);
}

class SweepCli : public SimulateCli {
 protected:
  static constexpr const char* kSweep = "crate.sdf --grid friction=0.2:1:3 --seeds 2 ";
};

TEST_F(SweepCli, ShardsMergeIntoTheWhole) {
  ASSERT_EQ(simulate(kSweep + std::string("--output jsonl:whole.jsonl")).exit, 0);
  const std::string whole = folder_.get("whole.jsonl");
  EXPECT_EQ(std::count(whole.begin(), whole.end(), '\n'), 6);
  for (const int parts : {2, 3, 7}) {
    std::string names;
    for (int part = 1; part <= parts; ++part) {
      const std::string name = "part" + std::to_string(part) + ".jsonl";
      ASSERT_EQ(
          simulate(kSweep + ("--shard " + std::to_string(part) + '/' + std::to_string(parts)) +
                   " -j 2 --output jsonl:" + name)
              .exit,
          0);
      names += ' ' + name;
    }
    const Ran merged = folder_.rigor("merge" + names);
    EXPECT_EQ(merged.exit, 0) << merged.err;
    EXPECT_EQ(merged.out, whole) << parts;
  }
}

TEST_F(SweepCli, MergeNamesWhatIsMissingOrDoubled) {
  ASSERT_EQ(simulate(kSweep + std::string("--output jsonl:whole.jsonl")).exit, 0);
  const std::string whole = folder_.get("whole.jsonl");
  const std::size_t second = whole.find('\n') + 1;
  folder_.put("gap.jsonl", whole.substr(second));
  const Ran gap = folder_.rigor("merge gap.jsonl -o out.jsonl");
  EXPECT_EQ(gap.exit, 1);
  EXPECT_NE(gap.err.find("case 0 of 6 is missing"), std::string::npos) << gap.err;
  EXPECT_EQ(folder_.get("out.jsonl"), "");
  const Ran doubled = folder_.rigor("merge whole.jsonl gap.jsonl");
  EXPECT_EQ(doubled.exit, 1);
  EXPECT_NE(doubled.err.find("case 1 (friction=0.2 seed=1) is in whole.jsonl:2 and in gap.jsonl:1"),
            std::string::npos)
      << doubled.err;
  folder_.put("other.jsonl", "{}\n");
  EXPECT_EQ(folder_.rigor("merge other.jsonl").exit, 2);
  folder_.put("name.jsonl", "{\"case\":{\"index\":0,\"of\":1,\"id\":5}}\n");
  EXPECT_EQ(folder_.rigor("merge name.jsonl").exit, 2);
  folder_.put("many.jsonl", "{\"case\":{\"index\":0,\"of\":18446744073709551615}}\n");
  EXPECT_EQ(folder_.rigor("merge many.jsonl").exit, 1);
}

TEST_F(SweepCli, ResumesAfterATornLine) {
  const std::string to_file = kSweep + std::string("--output jsonl:runs.jsonl");
  ASSERT_EQ(simulate(to_file).exit, 0);
  const std::string whole = folder_.get("runs.jsonl");
  std::size_t third = 0;
  for (int line = 0; line < 3; ++line) third = whole.find('\n', third) + 1;
  folder_.put("runs.jsonl", whole.substr(0, third + 40));
  const Ran resumed = simulate(to_file + " --resume");
  EXPECT_EQ(resumed.exit, 0) << resumed.err;
  EXPECT_EQ(folder_.get("runs.jsonl"), whole);
}

/// The first lines of a text.
std::string first_lines(const std::string& text, int count) {
  std::size_t end = 0;
  for (int line = 0; line < count; ++line) end = text.find('\n', end) + 1;
  return text.substr(0, end);
}

TEST_F(SweepCli, ResumesWhateverOrderLinesAreIn) {
  const std::string to_file = kSweep + std::string("--output jsonl:runs.jsonl");
  ASSERT_EQ(simulate(to_file).exit, 0);
  const std::string whole = folder_.get("runs.jsonl");
  const std::string first = first_lines(whole, 1);
  const std::string second = first_lines(whole, 2).substr(first.size());
  folder_.put("runs.jsonl", second + first);
  const Ran resumed = simulate(to_file + " --resume -j 3");
  EXPECT_EQ(resumed.exit, 0) << resumed.err;
  EXPECT_EQ(resumed.err, "1 model in 4 cases: 4 pass; 2 cases kept\n");
  EXPECT_EQ(folder_.get("runs.jsonl"), whole);
}

TEST_F(SweepCli, JobsDoNotChangeTheFile) {
  // The first takes a hundred times as many steps as the others.
  const std::string sweep = "crate.sdf --grid time-step=0.00005:0.005:3 --output jsonl:";
  ASSERT_EQ(simulate(sweep + "one.jsonl").exit, 0);
  ASSERT_EQ(simulate(sweep + "three.jsonl -j 3").exit, 0);
  const std::string one = folder_.get("one.jsonl");
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 3);
  EXPECT_EQ(folder_.get("three.jsonl"), one);
}

TEST_F(SweepCli, LinesOfAnotherRunAreRefused) {
  const std::string to_file = "--output jsonl:runs.jsonl";
  ASSERT_EQ(simulate(kSweep + to_file).exit, 0);
  const std::string torn = first_lines(folder_.get("runs.jsonl"), 2) + "{\"case\":";
  folder_.put("runs.jsonl", torn);
  for (const std::string other : {"slide.sdf --grid friction=0.2:1:3 --seeds 2 ",  // another model
                                  "crate.sdf --grid friction=0.3:1:3 --seeds 2 ",  // other values
                                  "crate.sdf --grid friction=0.2:1:3 ",            // fewer
                                  "crate.sdf --grid friction=0.2:1:3 --seeds 2 --test drop "}) {
    const Ran ran = simulate(other + to_file + " --resume");
    EXPECT_EQ(ran.exit, 2) << other << ran.err;
    EXPECT_NE(ran.err.find("runs.jsonl:1: is of another run"), std::string::npos) << ran.err;
    EXPECT_EQ(folder_.get("runs.jsonl"), torn) << other;
  }
  const Ran model =
      simulate("slide.sdf --grid friction=0.2:1:3 --seeds 2 " + to_file + " --resume");
  EXPECT_NE(model.err.find("crate.sdf"), std::string::npos) << model.err;
  EXPECT_NE(model.err.find("slide.sdf"), std::string::npos) << model.err;
  EXPECT_EQ(simulate(kSweep + to_file + " --resume").exit, 0);
}

TEST_F(SweepCli, LinesOfNoSimulationAreRefused) {
  const std::string line = "{\"case\":{\"index\":0,\"of\":1,\"id\":\"seed=0\"}}\n";
  folder_.put("runs.jsonl", line);
  const Ran ran = simulate("crate.sdf --output jsonl:runs.jsonl --resume");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_NE(ran.err.find("runs.jsonl:1: is no result"), std::string::npos) << ran.err;
  EXPECT_EQ(folder_.get("runs.jsonl"), line);
}

TEST_F(SweepCli, FailuresThatAreKeptCount) {
  folder_.put("far.toml", R"(model = "slide.sdf"
[[step]]
until = 0.1
commands = [{joint = "rail", velocity = 2, ramp = 1}]
[[assert]]
name = "arrives"
position = "cart"
axis = "x"
min = 4.5
)");
  const std::string sweep = "--scenario far.toml --seeds 3 --output jsonl:runs.jsonl";
  ASSERT_EQ(simulate(sweep).exit, 1);
  const std::string whole = folder_.get("runs.jsonl");
  const Ran resumed = simulate(sweep + " --resume");
  EXPECT_EQ(resumed.exit, 1);
  EXPECT_NE(resumed.err.find("3 cases kept, 3 failing"), std::string::npos) << resumed.err;
  EXPECT_EQ(simulate(sweep + " --resume --fail-on never").exit, 0);
  EXPECT_EQ(folder_.get("runs.jsonl"), whole);
}

TEST_F(SweepCli, ARefusedRunLeavesTheFile) {
  folder_.put("runs.jsonl", "what was there\n");
  for (const std::string wrong :
       {"slide.sdf --command rial=velocity:1", "crate.sdf slide.sdf --test drive --wheels rial",
        "crate.sdf --shard 3/2", "crate.sdf --format pretty --color mauve",
        "crate.sdf --output jsonl:more.jsonl"}) {
    const Ran ran = simulate(wrong + " --output jsonl:runs.jsonl");
    EXPECT_EQ(ran.exit, 2) << wrong << ran.err;
    EXPECT_EQ(folder_.get("runs.jsonl"), "what was there\n") << wrong;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_.path("more.jsonl")));
}

TEST_F(SweepCli, OneFileOfLinesIsWritten) {
  const Ran two = simulate("crate.sdf --output jsonl:a.jsonl --output jsonl:b.jsonl");
  EXPECT_EQ(two.exit, 2);
  EXPECT_NE(two.err.find("a.jsonl"), std::string::npos) << two.err;
  EXPECT_NE(two.err.find("b.jsonl"), std::string::npos) << two.err;
  const Ran both = simulate(kSweep + std::string("-j 2 --format jsonl --output jsonl:a.jsonl"));
  EXPECT_EQ(both.exit, 0) << both.err;
  EXPECT_EQ(both.out, folder_.get("a.jsonl"));
}

}  // namespace
}  // namespace rigor::test
