// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// prefix, remove and extract: what becomes of each name.

#include <gtest/gtest.h>

#include <rigor/author/verbs/prefix.h>
#include <rigor/author/verbs/remove.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

constexpr const char* kNamedArm = R"(<robot name="arm">
  <!-- the base -->
  <link name="base"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/> <child link="upper"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
  <link name="upper"/>
  <joint name="elbow" type="revolute">
    <parent link="upper"/> <child link="lower"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
    <mimic joint="shoulder"/>
  </joint>
  <link name="lower"/>
  <gazebo reference="lower"><mu1>0.5</mu1></gazebo>
  <transmission name="t"><joint name="elbow"/></transmission>
</robot>
)";

std::string with_replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

TEST(Prefix, EveryNameAndWhatRefersToIt) {
  VerbBench bench({{"arm.urdf", kNamedArm}});
  const EditedModel& arm = bench.open("arm.urdf");
  std::string expected = kNamedArm;
  for (const char* name : {"base", "shoulder", "upper", "elbow", "lower"})
    expected =
        with_replaced(expected, std::string("\"") + name + '"', std::string("\"l_") + name + '"');
  const std::string text = bench.text(arm, prefixed(arm, "l_", {"arm.urdf"}));
  EXPECT_EQ(text, expected);
  const EditedModel& changed = bench.open_text("arm.urdf", text);
  EXPECT_EQ(bench.text(changed, unprefixed(changed, "l_", {"arm.urdf"})), kNamedArm);
}

TEST(Prefix, FilesThatReferToTheRobot) {
  VerbBench bench({{"arm.urdf", kNamedArm},
                   {"arm.srdf", R"(<robot name="arm"><passive_joint name="elbow"/></robot>)"},
                   {"c.yaml", "controller:\n  joints: [shoulder, elbow]\n  label: elbow\n"}});
  const EditedModel& arm = bench.open("arm.urdf");
  const Change change = prefixed(arm, "l_", {"arm.urdf", "arm.srdf", "c.yaml"});
  const ProvenChange proven = bench.prove(arm, change);
  ASSERT_TRUE(proven.holds()) << proven.refused << VerbBench::words(proven.unasked);
  ASSERT_EQ(proven.files.size(), 3U);
  EXPECT_EQ(proven.files[0].text, R"(<robot name="arm"><passive_joint name="l_elbow"/></robot>)");
  EXPECT_EQ(proven.files[2].text, "controller:\n  joints: [l_shoulder, l_elbow]\n  label: elbow\n");
  ASSERT_EQ(change.notes.size(), 1U);
  EXPECT_EQ(change.notes[0], "c.yaml:3: may be the name 'elbow'; not renamed");
}

TEST(Prefix, TheWorldAndNestedModels) {
  constexpr const char* kNested = R"(<sdf version="1.9"><model name="m">
  <link name="base"/>
  <model name="hand"><link name="palm"/></model>
  <joint name="fix" type="fixed"><parent>world</parent><child>base</child></joint>
  <joint name="wrist" type="fixed"><parent>base</parent><child>hand::palm</child></joint>
  <frame name="tip" attached_to="hand::palm"/>
</model></sdf>
)";
  VerbBench bench({{"m.sdf", kNested}});
  const EditedModel& model = bench.open("m.sdf");
  const std::string text = bench.text(model, prefixed(model, "l_", {"m.sdf"}));
  EXPECT_NE(text.find("<parent>world</parent><child>l_base</child>"), std::string::npos);
  EXPECT_NE(text.find("<parent>l_base</parent><child>l_hand::palm</child>"), std::string::npos);
  EXPECT_NE(text.find(R"(<model name="l_hand"><link name="palm"/>)"), std::string::npos);
  EXPECT_NE(text.find(R"(<frame name="l_tip" attached_to="l_hand::palm"/>)"), std::string::npos);
}

TEST(Prefix, IsRefusedWhereNothingHasIt) {
  VerbBench bench({{"arm.urdf", kNamedArm}});
  const EditedModel& arm = bench.open("arm.urdf");
  EXPECT_EQ(unprefixed(arm, "x_", {}).refused, "no name of the model would change");
  EXPECT_NE(prefixed(arm, "a b", {}).refused, "");
}

TEST(Remove, ALeafWithAllThatNamesIt) {
  VerbBench bench({{"arm.urdf", kNamedArm}});
  const EditedModel& arm = bench.open("arm.urdf");
  const std::string text = bench.text(arm, removed(arm, "lower", Subtree::kRefused, {}));
  const std::string source = kNamedArm;
  EXPECT_EQ(text, source.substr(0, source.find("  <joint name=\"elbow\"")) + "</robot>\n");
}

TEST(Remove, ALinkThatCarriesOthersOnlyWithThem) {
  VerbBench bench({{"arm.urdf", kNamedArm}});
  const EditedModel& arm = bench.open("arm.urdf");
  EXPECT_NE(removed(arm, "upper", Subtree::kRefused, {}).refused.find("--subtree"),
            std::string::npos);
  const std::string text = bench.text(arm, removed(arm, "upper", Subtree::kRemoved, {}));
  EXPECT_EQ(text, "<robot name=\"arm\">\n  <!-- the base -->\n  <link name=\"base\"/>\n</robot>\n");
  EXPECT_EQ(removed(arm, "base", Subtree::kRemoved, {}).refused, "no link would be left");
}

TEST(Remove, TheLastLinkOfAModelThatTheWorldHolds) {
  VerbBench bench({{"valve.sdf",
                    "<sdf version='1.6'><model name='valve'><link name='wheel'/>"
                    "<joint name='axle' type='revolute'><parent>world</parent><child>wheel</child>"
                    "<axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"}});
  const EditedModel& valve = bench.open("valve.sdf");
  EXPECT_EQ(removed(valve, "wheel", Subtree::kRefused, {}).refused, "no link would be left");
}

TEST(Remove, AMimicOfWhatIsRemovedRefusesIt) {
  VerbBench bench({{"arm.urdf", kNamedArm}});
  const EditedModel& arm = bench.open("arm.urdf");
  EXPECT_EQ(extracted(arm, "upper", {}).refused,
            "a joint mimics 'shoulder', which would be removed");
}

TEST(Extract, APartIsARobot) {
  const std::string source = with_replaced(kNamedArm, "    <mimic joint=\"shoulder\"/>\n", "");
  VerbBench bench({{"arm.urdf", source}});
  const EditedModel& arm = bench.open("arm.urdf");
  const std::string text = bench.text(arm, extracted(arm, "upper", {}));
  const std::string begin = "<robot name=\"arm\">\n  <!-- the base -->\n";
  EXPECT_EQ(text, begin + source.substr(source.find("  <link name=\"upper\"")));
}

TEST(Extract, PosesRelativeToWhatIsGone) {
  constexpr const char* kSdf = R"(<sdf version="1.9"><model name="m">
  <link name="base"><pose>0 0 1 0 0 0</pose></link>
  <link name="arm"><pose relative_to="base">0.5 0 0 0 0 0</pose></link>
  <joint name="j" type="fixed"><parent>base</parent><child>arm</child></joint>
</model></sdf>
)";
  VerbBench bench({{"m.sdf", kSdf}});
  const EditedModel& model = bench.open("m.sdf");
  EXPECT_EQ(bench.text(model, extracted(model, "arm", {})), R"(<sdf version="1.9"><model name="m">
  <link name="arm"><pose relative_to="__model__">0.5 0 1 0 0 0</pose></link>
</model></sdf>
)");
}

}  // namespace
}  // namespace rigor::author
