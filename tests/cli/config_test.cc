// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a `rigor.toml` does to the commands.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cli/program.h>

namespace rigor::test {
namespace {

/// One error, joint-limit-inverted, and one info, axis-not-unit.
constexpr const char* kTwoFindings = R"(<sdf version="1.9">
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
      <axis><xyz>0 0 2</xyz><limit><lower>1</lower><upper>-1</upper></limit></axis>
    </joint>
  </model>
</sdf>
)";
constexpr const char* kInverted = "joint-limit-inverted";
constexpr const char* kNotUnit = "axis-not-unit";

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A repository of its own, so that nothing above it counts.
class ConfigFile : public testing::Test {
 protected:
  ConfigFile() {
    folder_.put(".git/HEAD", "");
    folder_.put("a/arm.sdf", kTwoFindings);
    folder_.put("b/arm.sdf", kTwoFindings);
  }

  Ran validate(const std::string& arguments = "a b") const {
    return folder_.rigor("validate --show info --format concise " + arguments);
  }

  void config(const std::string& text) const { folder_.put("rigor.toml", text); }

  Folder folder_;
};

TEST_F(ConfigFile, WithoutOneBothAreFound) {
  const Ran ran = validate();
  EXPECT_EQ(ran.exit, 1);
  EXPECT_TRUE(says(ran.out, "a/arm.sdf:16:") && says(ran.out, kInverted) && says(ran.out, kNotUnit))
      << ran.out;
}

TEST_F(ConfigFile, IgnoreSelectAndSeverity) {
  config("ignore = ['joint-limit-inverted']\n");
  EXPECT_EQ(validate().exit, 0);
  EXPECT_FALSE(says(validate().out, kInverted));
  config("select = ['axis-not-unit']\n");
  EXPECT_FALSE(says(validate().out, kInverted));
  EXPECT_TRUE(says(validate().out, kNotUnit));
  config("[severity]\njoint-limit-inverted = 'info'\naxis-not-unit = 'off'\n");
  EXPECT_EQ(validate().exit, 0);
  EXPECT_TRUE(says(validate().out, std::string("info: "))) << validate().out;
  EXPECT_FALSE(says(validate().out, kNotUnit));
}

TEST_F(ConfigFile, TheCommandLineGoesBefore) {
  config("select = ['axis-not-unit']\nfail-on = 'never'\n[severity]\naxis-not-unit = 'warning'\n");
  EXPECT_EQ(validate().exit, 0);
  EXPECT_EQ(validate("a --select joint-limit-inverted").exit, 0) << "fail-on is never";
  EXPECT_TRUE(says(validate("a --select joint-limit-inverted").out, kInverted));
  EXPECT_EQ(validate("a --fail-on warning").exit, 1);
  EXPECT_EQ(validate("a --fail-on warning --severity axis-not-unit=info").exit, 0);
  EXPECT_EQ(validate("a --ignore axis-not-unit").out, "");
  EXPECT_EQ(validate("a --isolated").exit, 1);
  EXPECT_EQ(validate("a --target gz-sim,ros --target mujoco").exit, 0);
  EXPECT_TRUE(says(validate("a --target gz-sym").err, "did you mean \"gz-sim\"?"));
  config("ignore = ['joint-limit-inverted']\n");
  EXPECT_EQ(validate("a --select joint-limit-inverted").exit, 1) << "who asks for a rule gets it";
}

TEST_F(ConfigFile, EachFileHasItsOwn) {
  folder_.put("b/rigor.toml",
              "fail-on = 'never'\n[[per-file]]\nfiles = ['arm.*']\nignore = ['kinematics']\n");
  config("ignore = ['axis-not-unit']\n");
  const Ran both = validate();
  EXPECT_EQ(both.exit, 1);
  EXPECT_TRUE(says(both.out, "a/arm.sdf"));
  EXPECT_FALSE(says(both.out, kNotUnit));
  EXPECT_FALSE(says(both.out, "b/arm.sdf"));
  EXPECT_EQ(validate("b").exit, 0);
  // fail-on is of each file's own configuration.
  folder_.put("b/rigor.toml", "fail-on = 'never'\n");
  EXPECT_TRUE(says(validate("b").out, kInverted));
  EXPECT_EQ(validate("b").exit, 0);
  EXPECT_EQ(validate("a b").exit, 1);
  folder_.put("b/rigor.toml", "extend = '../rigor.toml'\n");
  EXPECT_FALSE(says(validate("b").out, kNotUnit));
}

TEST_F(ConfigFile, AnotherMayBeNamed) {
  config("ignore = ['joint-limit-inverted']\n");
  folder_.put("ci/strict.toml", "fail-on = 'info'\n");
  EXPECT_EQ(validate("a --config ci/strict.toml").exit, 1);
  EXPECT_TRUE(says(validate("a --config ci/strict.toml").out, kInverted));
  const Ran missing = validate("a --config no.toml");
  EXPECT_EQ(missing.exit, 2);
  EXPECT_TRUE(says(missing.err, "no.toml: no such file")) << missing.err;
  EXPECT_EQ(validate("a --config ci/strict.toml --isolated").exit, 2);
}

TEST_F(ConfigFile, AllThatIsWrongIsTold) {
  config("selct = ['a']\nignore = ['axis-not-unt']\nfail-on = 'eror'\ntarget = 'gz-sym'\n");
  const Ran ran = validate();
  EXPECT_EQ(ran.exit, 2);
  EXPECT_EQ(ran.out, "");
  for (const char* part :
       {"rigor.toml:1: unknown key selct", "did you mean \"select\"?", "rigor.toml:2: unknown rule",
        "did you mean \"axis-not-unit\"?", "rigor.toml:3: fail-on", "did you mean \"error\"?",
        "rigor.toml:4: unknown target", "did you mean \"gz-sim\"?"}) {
    EXPECT_TRUE(says(ran.err, part)) << part << "\n" << ran.err;
  }
  config("[resolve]\npath = 'a'\n");
  EXPECT_EQ(validate().exit, 2);
}

TEST_F(ConfigFile, Exclude) {
  config("exclude = ['/b/']\n");
  EXPECT_FALSE(says(validate(".").out, "b/arm.sdf"));
  EXPECT_TRUE(says(validate(".").out, "a/arm.sdf"));
  EXPECT_TRUE(says(validate("b/arm.sdf").out, "b/arm.sdf")) << "a named file is always checked";
}

TEST_F(ConfigFile, Resolve) {
  folder_.put("store/wheel/mesh.stl", "x");
  EXPECT_EQ(folder_.rigor("resolve model://wheel/mesh.stl --from a/arm.sdf").exit, 1);
  config("[resolve]\npaths = ['store']\npackages = {tyre = 'store/wheel'}\n");
  const Ran model = folder_.rigor("resolve model://wheel/mesh.stl --from a/arm.sdf");
  EXPECT_EQ(model.exit, 0);
  EXPECT_TRUE(says(model.out, "(rigor.toml)")) << model.out;
  EXPECT_EQ(folder_.rigor("resolve package://tyre/mesh.stl --from a/arm.sdf").exit, 0);
  EXPECT_EQ(folder_.rigor("resolve package://tyre/mesh.stl --from a/arm.sdf --isolated").exit, 1);
}

/// A tensor that no body has, a mesh without triangles, and a warning of a conversion.
TEST_F(ConfigFile, HoldsForCommandsWithRulesOfTheirOwn) {
  folder_.put("hull.stl", "solid nothing\nendsolid nothing\n");
  folder_.put("loss.sdf", R"(<sdf version="1.9"><model name="m">
    <link name="a"><gravity>false</gravity></link></model></sdf>)");
  folder_.put("bad.sdf", R"(<sdf version="1.9"><model name="m"><link name="a"><inertial>
    <inertia><ixx>1</ixx><iyy>1</iyy><izz>9</izz></inertia></inertial></link></model></sdf>)");
  const std::string all[] = {"simulate bad.sdf", "mesh-check hull.stl"};
  for (const std::string& command : all) {
    config("");
    EXPECT_EQ(folder_.rigor(command).exit, 1) << command;
    config("fail-on = \"never\"\n");
    EXPECT_EQ(folder_.rigor(command).exit, 0) << command;
    EXPECT_EQ(folder_.rigor(command + " --fail-on error").exit, 1) << command;
  }
  const std::string convert = "sdf2urdf loss.sdf -o loss.urdf";
  config("");
  EXPECT_EQ(folder_.rigor(convert).exit, 0);
  config("fail-on = \"warning\"\nselect = [\"naming\"]\n");
  EXPECT_EQ(folder_.rigor(convert).exit, 1) << "what is selected is for validate";
}

TEST_F(ConfigFile, EachCommandRefusesABrokenOne) {
  config("a = = 3\n");
  const std::string all[] = {
      "inspect a/arm.sdf",
      "inertia a/arm.sdf",
      "diff a/arm.sdf b/arm.sdf",
      "sdf2urdf a/arm.sdf",
      "simulate a/arm.sdf",
      "upgrade a/arm.sdf --to 1.10",
      "edit rename hand paw a/arm.sdf",
      "expand a/arm.sdf",
  };
  for (const std::string& command : all) {
    const Ran ran = folder_.rigor(command);
    EXPECT_EQ(ran.exit, 2) << command;
    EXPECT_TRUE(says(ran.err, "rigor.toml:1: ")) << ran.err;
  }
}

TEST_F(ConfigFile, ShowConfigTellsWhoSaysIt) {
  config("ignore = ['axis-not-unit']\n[[per-file]]\nfiles = ['a/**']\nignore = ['plugin']\n");
  folder_.put("b/rigor.toml", "extend = '../rigor.toml'\nfail-on = 'warning'\n");
  const auto shown = [this](const std::string& arguments) {
    const Ran ran = folder_.rigor("validate --format json --show-config " + arguments);
    EXPECT_EQ(ran.exit, 0) << ran.err;
    return nlohmann::json::parse(ran.out);
  };
  const auto row = [](const nlohmann::json& all, const std::string& key, const std::string& value) {
    for (const auto& each : all["settings"]) {
      if (each["key"] == key && each["value"] == value) return each;
    }
    return nlohmann::json();
  };
  const auto a = shown("a/arm.sdf --severity axis-missing=error");
  EXPECT_EQ(a["configurations"], nlohmann::json({"rigor.toml"}));
  EXPECT_EQ(row(a, "ignore", "axis-not-unit")["line"], 1);
  EXPECT_EQ(row(a, "ignore", "plugin")["line"], 4);
  EXPECT_EQ(row(a, "severity.axis-missing", "error")["option"], "--severity");
  EXPECT_EQ(row(a, "fail-on", "error")["path"], nullptr);
  const auto b = shown("b/arm.sdf");
  EXPECT_EQ(b["configurations"], nlohmann::json({"b/rigor.toml", "rigor.toml"}));
  EXPECT_EQ(row(b, "fail-on", "warning")["path"], "b/rigor.toml");
  EXPECT_TRUE(row(b, "ignore", "plugin").is_null());
  const Ran text = folder_.rigor("validate --show-config b/arm.sdf");
  EXPECT_TRUE(says(text.out, "b/rigor.toml, which extends rigor.toml")) << text.out;
  EXPECT_TRUE(says(text.out, "(rigor.toml:1)")) << text.out;
}

// It was meant as one; to go on without it would check by other rules.
TEST(ConfigLink, ThatLeadsNowhereIsNoMissingConfiguration) {
  const Folder folder;
  folder.put(".git/HEAD", "");
  folder.put("sub/arm.sdf", kTwoFindings);
  std::filesystem::create_symlink("shared/rigor.toml", folder.path("rigor.toml"));
  const Ran ran = folder.rigor("validate sub/arm.sdf");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_TRUE(says(ran.err, "rigor.toml: is a link to a file that does not exist")) << ran.err;
}

TEST(InitCommand, WritesOnceAndNeverOver) {
  const Folder folder;
  folder.put(".git/HEAD", "");
  folder.put("arm.sdf", kTwoFindings);
  const Ran before = folder.rigor("validate --format json arm.sdf");
  const Ran first = folder.rigor("init");
  EXPECT_EQ(first.exit, 0);
  EXPECT_EQ(first.out, "");
  EXPECT_TRUE(says(first.err, "wrote rigor.toml")) << first.err;
  EXPECT_EQ(folder.rigor("validate --format json arm.sdf").out, before.out) << "it changes nothing";
  folder.put("rigor.toml", "# mine\n");
  EXPECT_EQ(folder.rigor("init").exit, 2);
  EXPECT_EQ(folder.get("rigor.toml"), "# mine\n");
  EXPECT_EQ(folder.rigor("init nowhere").exit, 2);
  folder.put("sub/x", "");
  EXPECT_EQ(folder.rigor("init sub").exit, 0);
  EXPECT_NE(folder.get("sub/rigor.toml"), "");
}

}  // namespace
}  // namespace rigor::test
