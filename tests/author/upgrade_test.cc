// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Against texts written by hand from the published tables of what changed between versions
// (docs/upgrade.md), and against what the upgraded file is when read by itself.

#include <rigor/author/upgrade/upgrade.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/upgrade/step.h>
#include <rigor/model/frames.h>

#include "author/model_text.h"

namespace rigor::author {
namespace {

using test::ModelText;

Upgrade upgraded(const std::string& text, int to, std::map<std::string, std::string> files = {}) {
  const ModelText model(std::move(files), "w/m/model.sdf", text);
  Upgrade result = upgrade(model.environment, model.loaded, schema::Version{to});
  EXPECT_EQ(apply_edits(text, result.edits).value_or("overlap"), result.text);
  if (result.refused()) {
    EXPECT_TRUE(result.edits.empty());
    EXPECT_EQ(result.text, text);
  }
  return result;
}

/// After the upgrade, which a second one must leave as it is.
std::string upgraded_text(const std::string& text, int to) {
  const Upgrade result = upgraded(text, to);
  for (const UpgradeNote& note : result.notes) {
    EXPECT_NE(note.severity, Severity::kError) << note.message;
  }
  EXPECT_TRUE(upgraded(result.text, to).edits.empty());
  return result.text;
}

std::size_t notes_of(const Upgrade& result, UpgradeNoteKind kind) {
  std::size_t count = 0;
  for (const UpgradeNote& note : result.notes) count += note.kind == kind ? 1 : 0;
  return count;
}

std::string file(int version, const std::string& content) {
  const std::string root = version < 3 ? "gazebo" : "sdf";
  return '<' + root + " version=\"1." + std::to_string(version) + "\">\n" + content + "</" + root +
         ">\n";
}

std::string model_file(int version, const std::string& content) {
  return file(version,
              "  <model name=\"arm\">\n    <link name=\"a\"/>\n    <link name=\"b\">\n"
              "      <pose>0 0 1 1.5707963267948966 0 0</pose>\n    </link>\n" +
                  content + "  </model>\n");
}

std::string hinge(const std::string& axis) {
  return "    <joint name=\"hinge\" type=\"revolute\">\n"
         "      <parent>a</parent>\n      <child>b</child>\n      <axis>\n" +
         axis + "      </axis>\n    </joint>\n";
}

// --- Joints ---

TEST(Upgrade, AnAxisInTheModelFrameSaysSo) {
  for (const int version : {2, 3, 4}) {
    EXPECT_EQ(
        upgraded_text(model_file(version, hinge("        <xyz>0 1 0</xyz>  <!-- y -->\n")), 9),
        model_file(9, hinge("        <xyz expressed_in=\"__model__\">0 1 0</xyz>  <!-- y -->\n")));
  }
  EXPECT_EQ(upgraded_text(model_file(5, hinge("        <xyz>0 1 0</xyz>\n")), 9),
            model_file(9, hinge("        <xyz>0 1 0</xyz>\n")));
}

TEST(Upgrade, TheFlagOfOneFiveBecomesAnAttribute) {
  const auto flag = [](std::string_view value) {
    return "        <use_parent_model_frame>" + std::string(value) + "</use_parent_model_frame>\n";
  };
  EXPECT_EQ(upgraded_text(model_file(5, hinge("        <xyz>0 1 0</xyz>\n" + flag("1"))), 7),
            model_file(7, hinge("        <xyz expressed_in=\"__model__\">0 1 0</xyz>\n")));
  EXPECT_EQ(upgraded_text(model_file(6, hinge(flag("false") + "        <xyz>0 1 0</xyz>\n")), 7),
            model_file(7, hinge("        <xyz>0 1 0</xyz>\n")));
  EXPECT_EQ(upgraded_text(model_file(4, hinge("        <xyz>0 1 0</xyz>\n")), 6),
            model_file(6, hinge("        <xyz>0 1 0</xyz>\n" + flag("true"))));
  EXPECT_EQ(upgraded_text(model_file(5, hinge("        <xyz>0 1 0</xyz>\n" + flag("true"))), 6),
            model_file(6, hinge("        <xyz>0 1 0</xyz>\n" + flag("true"))));
}

TEST(Upgrade, AnAxisThatIsNotWrittenIsWritten) {
  EXPECT_EQ(upgraded_text(model_file(4, hinge("        <dynamics/>\n")), 8),
            model_file(8, hinge("        <xyz expressed_in=\"__model__\">0 0 1</xyz>\n"
                                "        <dynamics/>\n")));
}

TEST(Upgrade, TheAxisPointsWhereItPointed) {
  // The child, and with it the joint, is turned by a quarter about x: what is z in the model is y in
  // the joint frame.
  for (const int to : {6, 9, 12}) {
    const Upgrade result = upgraded(model_file(4, hinge("        <xyz>0 0 1</xyz>\n")), to);
    const ModelText model({}, "m.sdf", result.text);
    const model::Frames frames(model.loaded.root);
    const auto axis = frames.axis(model::Id<model::Joint>{0}, 0);
    ASSERT_TRUE(axis);
    EXPECT_NEAR(axis->x, 0, 1e-12);
    EXPECT_NEAR(axis->y, 0, 1e-12);
    EXPECT_NEAR(axis->z, 1, 1e-12);
  }
}

TEST(Upgrade, AZeroThatMeantNoLimitIsWrittenAsNone) {
  const auto limit = [](std::string_view effort, std::string_view velocity) {
    return hinge(
        "        <xyz expressed_in=\"__model__\">0 0 1</xyz>\n        <limit>\n"
        "          <lower>-1e16</lower>\n"
        "          <upper>2</upper>\n          <effort>" +
        std::string(effort) + "</effort>\n          <velocity>" + std::string(velocity) +
        "</velocity>\n        </limit>\n");
  };
  EXPECT_EQ(upgraded_text(model_file(3, limit("0", " 0.0 ")), 9),
            model_file(9, limit("-1", " -1 ")));
  EXPECT_EQ(upgraded_text(model_file(3, limit("5", "-1")), 12), model_file(12, limit("5", "-1")));
  // From 1.4 on a zero is meant.
  EXPECT_EQ(upgraded_text(model_file(4, limit("0", "0")), 9), model_file(9, limit("0", "0")));
}

TEST(Upgrade, AScrewKeepsThePitchThatItHadByDefault) {
  const auto screw = [](const std::string& pitch) {
    return "    <joint name=\"screw\" type=\"screw\">\n"
           "      <parent>a</parent>\n      <child>b</child>\n" +
           pitch + "    </joint>\n";
  };
  const std::string written = "      <thread_pitch>1.0</thread_pitch>\n";
  EXPECT_EQ(upgraded_text(model_file(9, screw("")), 10), model_file(10, screw(written)));
  EXPECT_EQ(upgraded_text(model_file(7, screw("")), 9), model_file(9, screw("")));
  EXPECT_EQ(upgraded_text(model_file(10, screw("")), 11), model_file(11, screw("")));
  const Upgrade deprecated = upgraded(model_file(9, screw(written)), 10);
  EXPECT_EQ(notes_of(deprecated, UpgradeNoteKind::kDeprecated), 1U);
}

TEST(Upgrade, FeedbackLeavesTheEngine) {
  const std::string before = model_file(
      4,
      "    <joint name=\"weld\" type=\"fixed\">\n      <parent>a</parent>\n      <child>b</child>\n"
      "      <physics>\n        <ode>\n          <provide_feedback>true</provide_feedback>\n"
      "          <cfm>0</cfm>\n        </ode>\n      </physics>\n    </joint>\n");
  const std::string after = model_file(
      7,
      "    <joint name=\"weld\" type=\"fixed\">\n      <parent>a</parent>\n      <child>b</child>\n"
      "      <physics>\n        <provide_feedback>true</provide_feedback>\n        <ode>\n"
      "          <cfm>0</cfm>\n        </ode>\n      </physics>\n    </joint>\n");
  EXPECT_EQ(upgraded_text(before, 7), after);
}

TEST(Upgrade, AJointIsCalledAsItsConsumersCallIt) {
  const auto joint = [](std::string_view name) {
    return "    <joint type='fixed' name='" + std::string(name) +
           "'>\n      <parent>a</parent>\n      <child>b</child>\n    </joint>\n";
  };
  const std::string text = model_file(6, joint("b"));
  EXPECT_EQ(upgraded_text(text, 7), model_file(7, joint("b_joint")));
  EXPECT_EQ(notes_of(upgraded(text, 7), UpgradeNoteKind::kRenamed), 1U);
  // A version that allows it leaves it.
  EXPECT_EQ(upgraded_text(model_file(4, joint("b")), 6), model_file(6, joint("b")));
}

// --- Poses and names ---

TEST(Upgrade, FrameBecomesRelativeTo) {
  const auto frames = [](const std::string& attribute, const std::string& empty) {
    return "    <frame name=\"f\">\n      <pose" + attribute +
           ">0 0 1 0 0 0</pose>\n    </frame>\n" + "    <link name=\"c\">\n      <pose" + empty +
           ">1 0 0 0 0 0</pose>\n    </link>\n";
  };
  EXPECT_EQ(upgraded_text(model_file(6, frames(" frame='a'", " frame=\"\"")), 9),
            model_file(9, frames(" relative_to='a'", "")));
}

TEST(Upgrade, AnInertialPoseLosesAnEmptyFrame) {
  const auto link = [](const std::string& attribute) {
    return "    <link name=\"c\">\n      <inertial>\n        <pose" + attribute +
           ">1 0 0 0 0 0</pose>\n        <mass>2</mass>\n      </inertial>\n    </link>\n";
  };
  EXPECT_EQ(upgraded_text(model_file(7, link(" relative_to=''")), 8), model_file(8, link("")));
}

TEST(Upgrade, NamesOfNestedModelsAreNotTakenApart) {
  const std::string text = model_file(7, "    <link name=\"hand::palm\"/>\n");
  const Upgrade result = upgraded(text, 8);
  EXPECT_TRUE(result.refused());
  ASSERT_EQ(notes_of(result, UpgradeNoteKind::kScopedName), 1U);
  EXPECT_EQ(text.substr(result.notes[0].where.begin, result.notes[0].where.size()), "hand::palm");
  EXPECT_EQ(upgraded_text(model_file(6, "    <link name=\"hand::palm\"/>\n"), 7), text);
}

// --- Worlds ---

TEST(Upgrade, EachEnginesStepSizeBecomesThatOfAll) {
  EXPECT_EQ(upgraded_text(file(3,
                               "  <world name=\"w\">\n"
                               "    <physics type=\"ode\">\n"
                               "      <update_rate>500</update_rate>\n"
                               "      <gravity>0 0 -1.6</gravity>\n"
                               "      <ode>\n"
                               "        <solver>\n"
                               "          <dt>0.002</dt>\n"
                               "          <iters>20</iters>\n"
                               "        </solver>\n"
                               "      </ode>\n"
                               "    </physics>\n"
                               "  </world>\n"),
                          9),
            file(9,
                 "  <world name=\"w\">\n"
                 "    <physics type=\"ode\">\n"
                 "      <max_step_size>0.002</max_step_size>\n"
                 "      <real_time_update_rate>500</real_time_update_rate>\n"
                 "      <ode>\n"
                 "        <solver>\n"
                 "          <iters>20</iters>\n"
                 "        </solver>\n"
                 "      </ode>\n"
                 "    </physics>\n"
                 "    <gravity>0 0 -1.6</gravity>\n"
                 "  </world>\n"));
}

TEST(Upgrade, GravityLeavesTheEngineOnlyOnce) {
  const std::string both =
      "  <world name=\"w\">\n    <gravity>0 0 -1</gravity>\n"
      "    <physics type=\"ode\">\n      <gravity>0 0 -2</gravity>\n"
      "    </physics>\n  </world>\n";
  const Upgrade result = upgraded(file(5, both), 6);
  EXPECT_EQ(result.text, file(6, both));
  EXPECT_EQ(notes_of(result, UpgradeNoteKind::kRemoved), 1U);
}

TEST(Upgrade, TheNoiseOfAnImuIsWrittenForEachAxis) {
  const std::string before = model_file(
      5,
      "    <link name=\"c\">\n      <sensor name=\"s\" type=\"imu\">\n        <imu>\n"
      "          <noise>\n            <type>gaussian</type>\n            <rate>\n"
      "              <mean>0</mean>\n              <stddev>2e-4</stddev>\n            </rate>\n"
      "            <accel>\n              <bias_mean>0.1</bias_mean>\n            </accel>\n"
      "          </noise>\n        </imu>\n      </sensor>\n    </link>\n");
  const auto axis = [](const std::string& name, const std::string& numbers) {
    return "            <" + name + ">\n              <noise type=\"gaussian\">\n" + numbers +
           "              </noise>\n            </" + name + ">\n";
  };
  const std::string rate =
      "                <mean>0</mean>\n                <stddev>2e-4</stddev>\n";
  const std::string bias = "                <bias_mean>0.1</bias_mean>\n";
  EXPECT_EQ(
      upgraded_text(before, 6),
      model_file(6,
                 "    <link name=\"c\">\n      <sensor name=\"s\" type=\"imu\">\n        <imu>\n"
                 "          <angular_velocity>\n" +
                     axis("x", rate) + axis("y", rate) + axis("z", rate) +
                     "          </angular_velocity>\n          <linear_acceleration>\n" +
                     axis("x", bias) + axis("y", bias) + axis("z", bias) +
                     "          </linear_acceleration>\n"
                     "        </imu>\n      </sensor>\n    </link>\n"));
}

TEST(Upgrade, StatesGetNamesOfTheirOwn) {
  const std::string insertion =
      "      <insertions>\n        <model name=\"new\">\n"
      "          <link name=\"l\"/>\n        </model>\n"
      "      </insertions>\n";
  EXPECT_EQ(
      upgraded_text(file(9, "  <world name=\"w\">\n    <state world_name=\"w\">\n" + insertion +
                                "      <model name=\"m\">\n        <link name=\"l\">\n"
                                "          <pose>1 0 0 0 0 0</pose>\n        </link>\n"
                                "      </model>\n    </state>\n  </world>\n"),
                    12),
      file(12, "  <world name=\"w\">\n    <state world_name=\"w\">\n" + insertion +
                   "      <model_state name=\"m\">\n        <link_state name=\"l\">\n"
                   "          <pose>1 0 0 0 0 0</pose>\n        </link_state>\n"
                   "      </model_state>\n    </state>\n  </world>\n"));
}

// --- SDF 1.0 ---

TEST(Upgrade, ValuesLeaveTheAttributesOfTheFirstVersion) {
  EXPECT_EQ(upgraded_text("<?xml version=\"1.0\"?>\n"
                          "<gazebo version=\"1.0\">\n"
                          "  <world name=\"w\">\n"
                          "    <scene>\n"
                          "      <ambient rgba=\"0.5 0.5 0.5 1\"/>\n"
                          "      <fog rgba=\"1 0 0 1\" density=\"0.5\" />\n"
                          "    </scene>\n"
                          "    <physics type=\"ode\" update_rate=\"100\">\n"
                          "      <gravity xyz=\"0 0 -9.8\"/>\n"
                          "    </physics>\n"
                          "    <model name=\"m\" static=\"true\"> <!-- fixed -->\n"
                          "      <origin pose=\"1 2 3 0 0 0\"/>\n"
                          "      <link name=\"a\" gravity=\"false\">\n"
                          "        <damping>\n"
                          "          <linear>0.1</linear>\n"
                          "        </damping>\n"
                          "        <inertial mass=\"2\">\n"
                          "          <origin pose=\"0 0 1 0 0 0\" ></origin>\n"
                          "          <inertia ixx=\"1\" izz=\"3\"/>\n"
                          "        </inertial>\n"
                          "        <visual name=\"v\">\n"
                          "          <geometry>\n"
                          "            <mesh filename=\"a.dae\" scale=\"2 2 2\"/>\n"
                          "          </geometry>\n"
                          "          <material script=\"Gazebo/Red\"/>\n"
                          "        </visual>\n"
                          "      </link>\n"
                          "      <link name=\"b\"/>\n"
                          "      <joint name=\"j\" type=\"revolute\">\n"
                          "        <parent link=\"a\"/>\n"
                          "        <child link=\"b\"/>\n"
                          "        <axis xyz=\"1 0 0\"/>\n"
                          "      </joint>\n"
                          "    </model>\n"
                          "  </world>\n"
                          "</gazebo>\n",
                          9),
            "<?xml version=\"1.0\"?>\n"
            "<sdf version=\"1.9\">\n"
            "  <world name=\"w\">\n"
            "    <scene>\n"
            "      <ambient>0.5 0.5 0.5 1</ambient>\n"
            "      <fog>\n"
            "        <color>1 0 0 1</color>\n"
            "        <density>0.5</density>\n"
            "      </fog>\n"
            "    </scene>\n"
            "    <physics type=\"ode\">\n"
            "      <real_time_update_rate>100</real_time_update_rate>\n"
            "    </physics>\n"
            "    <gravity>0 0 -9.8</gravity>\n"
            "    <model name=\"m\"> <!-- fixed -->\n"
            "      <static>true</static>\n"
            "      <pose>1 2 3 0 0 0</pose>\n"
            "      <link name=\"a\">\n"
            "        <gravity>false</gravity>\n"
            "        <velocity_decay>\n"
            "          <linear>0.1</linear>\n"
            "        </velocity_decay>\n"
            "        <inertial>\n"
            "          <mass>2</mass>\n"
            "          <pose >0 0 1 0 0 0</pose>\n"
            "          <inertia>\n"
            "            <ixx>1</ixx>\n"
            "            <izz>3</izz>\n"
            "          </inertia>\n"
            "        </inertial>\n"
            "        <visual name=\"v\">\n"
            "          <geometry>\n"
            "            <mesh>\n"
            "              <uri>a.dae</uri>\n"
            "              <scale>2 2 2</scale>\n"
            "            </mesh>\n"
            "          </geometry>\n"
            "          <material>\n"
            "            <script>\n"
            "              <uri>file://media/materials/scripts/gazebo.material</uri>\n"
            "              <name>Gazebo/Red</name>\n"
            "            </script>\n"
            "          </material>\n"
            "        </visual>\n"
            "      </link>\n"
            "      <link name=\"b\"/>\n"
            "      <joint name=\"j\" type=\"revolute\">\n"
            "        <parent>a</parent>\n"
            "        <child>b</child>\n"
            "        <axis>\n"
            "          <xyz expressed_in=\"__model__\">1 0 0</xyz>\n"
            "        </axis>\n"
            "      </joint>\n"
            "    </model>\n"
            "  </world>\n"
            "</sdf>\n");
}

TEST(Upgrade, AFileInOneLineStaysOne) {
  EXPECT_EQ(upgraded_text("<gazebo version='1.0'><model name='m'><link name='l' gravity='0'>"
                          "<origin pose='1 0 0 0 0 0'/></link></model></gazebo>",
                          9),
            "<sdf version='1.9'><model name='m'><link name='l'><gravity>0</gravity>"
            "<pose>1 0 0 0 0 0</pose></link></model></sdf>");
}

TEST(Upgrade, BytesOutsideStayAsTheyAre) {
  const std::string before =
      "\xEF\xBB\xBF<?xml version='1.0' ?>\r\n<!-- \xC3\xA4 -->\r\n<sdf\tversion = '1.4' >\r\n"
      "<model  name='m'><link name='a'/>\r\n\t<link name='b'/>\r\n\t<joint name='j' "
      "type='revolute'>\r\n\t\t<parent>a</parent><child>b</child>\r\n\t\t<axis>\r\n\t\t\t<xyz >1 0 "
      "0</xyz>\r\n\t\t</axis>\r\n\t</joint>\r\n\t<plugin name='p' filename='f'><pose frame='x'/>"
      "<joint><axis/></joint></plugin>\r\n</model></sdf>";
  std::string after = before;
  after.replace(after.find("1.4"), 3, "1.9");
  after.replace(after.find("<xyz >"), 6, "<xyz expressed_in='__model__' >");
  EXPECT_EQ(upgraded_text(before, 9), after);
}

// --- What cannot be kept is told ---

TEST(Upgrade, WhatIsGoneIsTold) {
  const std::string text = model_file(8, hinge("        <xyz>0 0 1</xyz>\n"
                                               "        <initial_position>1</initial_position>\n"));
  const Upgrade result = upgraded(text, 9);
  ASSERT_EQ(notes_of(result, UpgradeNoteKind::kRemoved), 1U);
  const Span where = result.notes[0].where;
  EXPECT_EQ(text.substr(where.begin, where.size()), "initial_position");
  EXPECT_EQ(result.notes[0].severity, Severity::kWarning);
}

TEST(Upgrade, ADefaultThatChangedIsTold) {
  const auto link = [](int version, const std::string& sampling) {
    return model_file(version,
                      "    <link name=\"c\">\n      <visual name=\"v\">\n"
                      "        <geometry>\n          <heightmap>\n"
                      "            <uri>h.png</uri>\n" +
                          sampling +
                          "          </heightmap>\n        </geometry>\n"
                          "      </visual>\n    </link>\n");
  };
  EXPECT_EQ(notes_of(upgraded(link(7, ""), 8), UpgradeNoteKind::kDefaultChanged), 1U);
  EXPECT_EQ(notes_of(upgraded(link(8, ""), 9), UpgradeNoteKind::kDefaultChanged), 0U);
  EXPECT_EQ(notes_of(upgraded(link(7, "            <sampling>2</sampling>\n"), 8),
                     UpgradeNoteKind::kDefaultChanged),
            0U);
}

TEST(Upgrade, AnIncludeThatIsTooNewIsTold) {
  const std::string text = file(6,
                                "  <world name=\"w\">\n    <include>\n"
                                "      <uri>other.sdf</uri>\n    </include>\n  </world>\n");
  for (const auto& [version, told] : {std::pair(4, 0U), {9, 0U}, {11, 1U}}) {
    const Upgrade result = upgraded(
        text, 9,
        {{"w/m/other.sdf", file(version, "<model name=\"o\"><link name=\"l\"/></model>")}});
    EXPECT_EQ(notes_of(result, UpgradeNoteKind::kIncludeNewer), told) << version;
    EXPECT_FALSE(result.refused());
  }
}

TEST(Upgrade, ItsModelConfigGoesAlong) {
  const std::string config =
      "<model><name>m</name>\n<sdf version='1.4'>model.sdf</sdf> <!-- 1.4 -->\n"
      "<sdf version=\"1.2\">old.sdf</sdf></model>";
  const Upgrade result = upgraded(model_file(4, ""), 9, {{"w/m/model.config", config}});
  EXPECT_EQ(notes_of(result, UpgradeNoteKind::kConfigEntry), 0U);
  ASSERT_TRUE(result.config.has_value());
  EXPECT_EQ(result.config->path, "w/m/model.config");
  EXPECT_EQ(result.config->before, config);
  EXPECT_EQ(result.config->text,
            "<model><name>m</name>\n<sdf version='1.9'>model.sdf</sdf> <!-- 1.4 -->\n"
            "<sdf version=\"1.2\">old.sdf</sdf></model>");
}

TEST(Upgrade, AModelConfigThatSaysNothingOldStays) {
  for (const char* config : {"<model><sdf version=\"1.9\">model.sdf</sdf></model>",
                             "<model><sdf>model.sdf</sdf></model>",
                             "<model><sdf version=\"1.4\">other.sdf</sdf></model>",
                             "<model><sdf version=\"1.4\">", ""}) {
    const Upgrade result = upgraded(model_file(4, ""), 9, {{"w/m/model.config", config}});
    EXPECT_FALSE(result.config.has_value()) << config;
    EXPECT_FALSE(result.refused()) << config;
  }
  // Where the file itself is not changed, neither is what goes with it.
  const std::string config = "<model><sdf version=\"1.4\">model.sdf</sdf></model>";
  EXPECT_FALSE(upgraded("<sdf version=\"1.4\"><model>", 9, {{"w/m/model.config", config}}).config);
}

// By the highest version that it states, the first of equals: old.sdf would go before new.sdf.
TEST(Upgrade, AModelConfigNeverMakesConsumersLoadAnotherFile) {
  const Upgrade result = upgraded(
      model_file(4, ""), 9,
      {{"w/m/model.config",
        "<model><sdf version=\"1.4\">model.sdf</sdf><sdf version=\"1.6\">new.sdf</sdf></model>"}});
  EXPECT_FALSE(result.config.has_value());
  EXPECT_EQ(notes_of(result, UpgradeNoteKind::kConfigEntry), 1U);
  EXPECT_FALSE(result.refused());
  EXPECT_FALSE(result.edits.empty());
}

TEST(Upgrade, WhatIsNoOlderModelIsRefused) {
  const auto kind = [](const std::string& text, int to) {
    const Upgrade result = upgraded(text, to);
    EXPECT_TRUE(result.refused());
    return result.notes.empty() ? UpgradeNoteKind::kDeprecated : result.notes[0].kind;
  };
  EXPECT_EQ(kind(model_file(9, ""), 8), UpgradeNoteKind::kNewer);
  EXPECT_EQ(kind("<robot name=\"r\"><link name=\"l\"/></robot>", 9), UpgradeNoteKind::kNotSdf);
  EXPECT_EQ(kind("<sdf><model name=\"m\"/></sdf>", 9), UpgradeNoteKind::kVersionUnknown);
  EXPECT_EQ(kind("<sdf version=\"1.1\"/>", 9), UpgradeNoteKind::kVersionUnknown);
  EXPECT_EQ(kind("<sdf version=\"1.4\"><model>", 9), UpgradeNoteKind::kNotReadable);
  EXPECT_EQ(kind("", 9), UpgradeNoteKind::kNotReadable);
  EXPECT_TRUE(upgraded(model_file(9, ""), 9).edits.empty());
}

TEST(Upgrade, AnotherModelIsNeverWritten) {
  // Nobody reads the density of a collision before 1.11; then it would make the link heavier.
  const std::string text = model_file(
      9,
      "    <link name=\"c\">\n      <inertial auto=\"true\"/>\n      <collision name=\"box\">\n"
      "        <density>2000</density>\n        <geometry>\n          <box>\n"
      "            <size>1 1 1</size>\n          </box>\n        </geometry>\n"
      "      </collision>\n    </link>\n");
  const Upgrade result = upgraded(text, 11);
  EXPECT_TRUE(result.refused());
  EXPECT_GE(notes_of(result, UpgradeNoteKind::kNotTheSame), 1U);
  EXPECT_FALSE(upgraded(text, 10).refused());
}

TEST(UpgradeProof, EveryChangeOfMeaningIsFound) {
  const std::string rest =
      "  <world name=\"w\">\n    <gravity>0 0 -9.8</gravity>\n"
      "    <physics type=\"ode\"><max_step_size>0.001</max_step_size></physics>\n"
      "    <model name=\"m\">\n      <static>0</static>\n      <pose>1 2 3 0 0 0.5</pose>\n"
      "      <frame name=\"f\"><pose>0 0 1 0 0 0</pose></frame>\n"
      "      <link name=\"a\">\n        <gravity>1</gravity>\n"
      "        <inertial><mass>2</mass><pose>0 0 0.5 0 0 0</pose>\n"
      "          <inertia><ixx>1</ixx><iyy>1.5</iyy><izz>1.25</izz></inertia></inertial>\n"
      "        <collision name=\"c\"><geometry><box><size>1 2 3</size></box></geometry>\n"
      "          <surface><friction><ode><mu>0.75</mu></ode></friction></surface></collision>\n"
      "        <sensor name=\"s\" type=\"camera\"><update_rate>30</update_rate></sensor>\n"
      "      </link>\n      <link name=\"b\"/>\n"
      "      <joint name=\"j\" type=\"revolute\">\n        <parent>a</parent>\n"
      "        <child>b</child>\n        <axis>\n          <xyz>0 0.6 0.8</xyz>\n"
      "          <limit><lower>-1e16</lower><upper>1.5</upper><effort>-1</effort></limit>\n"
      "          <dynamics><damping>0.25</damping></dynamics>\n        </axis>\n      </joint>\n"
      "      <plugin name=\"p\" filename=\"f.so\"><key>1</key></plugin>\n    </model>\n"
      "  </world>\n</sdf>\n";
  const ModelText before({}, "m.sdf", "<sdf version=\"1.6\">\n" + rest);
  const auto differences = [&](const std::string& from, const std::string& to) {
    std::string text = "<sdf version=\"1.9\">\n" + rest;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    const ModelText after({}, "m.sdf", text);
    return differences_after_upgrade(before.loaded, after.loaded).take_list().size();
  };
  EXPECT_EQ(differences("<effort>-1<", "<effort>-2<"), 0U);
  EXPECT_EQ(differences("-1e16", "-inf"), 0U);
  EXPECT_EQ(differences("0 0.6 0.8", "0 .6 .8000000000000001"), 0U);
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"<effort>-1<", "<effort>0<"},
           {"<effort>-1<", "<effort>1e15<"},
           {"-1e16", "-1e15"},
           {"<upper>1.5<", "<upper>1.500000000002<"},
           {"<upper>1.5<", "<upper>inf<"},
           {"0 0 -9.8<", "0 0 -9.81<"},
           {"0.001<", "0.002<"},
           {"1 2 3 0 0 0.5", "1 2 3 0 0 0.500000000003"},
           {"<static>0<", "<static>1<"},
           {"\"f\"><pose>0 0 1", "\"f\"><pose>0 0 1.5"},
           {"<gravity>1<", "<gravity>0<"},
           {"<mass>2<", "<mass>2.00000000001<"},
           {"0 0 0.5 0 0 0", "0 0 0.5 0 0.1 0"},
           {"<ixx>1<", "<ixx>1.1<"},
           {"1 2 3</size>", "1 2 3.1</size>"},
           {"<mu>0.75<", "<mu>0.5<"},
           {"<update_rate>30<", "<update_rate>31<"},
           {"0 0.6 0.8", "0 0.8 0.6"},
           {"0 0.6 0.8", "0 1.2 1.6"},
           {"<xyz>", "<xyz expressed_in=\"__model__\" >1 "},
           {"<damping>0.25<", "<damping>0.5<"},
           {"name=\"j\"", "name=\"k\""},
           {"<key>1<", "<key>2<"},
           {"<link name=\"b\"/>", "<link name=\"b\"/><link name=\"d\"/>"}}) {
    EXPECT_GE(differences(from, to), 1U) << from << " as " << to;
  }
}

}  // namespace
}  // namespace rigor::author
