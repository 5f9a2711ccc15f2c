// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <set>

#include <rigor/lsp/document/xml_cursor.h>
#include <rigor/text/disk.h>

#include "lsp/editor.h"

namespace rigor::lsp {
namespace {

using test::Editor;

/// Labels that are offered at `|` in a text.
std::set<std::string> offered(Editor& editor, const std::string& path, std::string text) {
  const std::size_t at = text.find('|');
  text.erase(at, 1);
  editor.open(path, text);
  const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  const std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  Json params = editor.document(path);
  params["position"] = {{"line", line}, {"character", at - begin}};
  std::set<std::string> labels;
  for (const Json& item : editor.request("textDocument/completion", params))
    labels.insert(item["label"]);
  return labels;
}

TEST(LspCompletion, ElementsAreThoseOfThePlaceAndVersion) {
  MemoryDisk disk;
  Editor editor(disk);
  const auto model =
      offered(editor, "/ws/a.sdf", "<sdf version='1.6'><model name='m'><|</model></sdf>");
  EXPECT_TRUE(model.contains("link"));
  EXPECT_FALSE(model.contains("axis"));
  const std::string world = "'><world name='w'><|";  // which has joints since 1.10
  EXPECT_FALSE(offered(editor, "/ws/b.sdf", "<sdf version='1.9" + world).contains("joint"));
  EXPECT_TRUE(offered(editor, "/ws/d.sdf", "<sdf version='1.10" + world).contains("joint"));
  const auto joint =
      offered(editor, "/ws/c.urdf",
              "<robot name='r'><joint name='j' type='fixed'>\n  <|\n</joint></robot>");
  EXPECT_TRUE(joint.contains("parent"));
  EXPECT_TRUE(joint.contains("/joint>"));
}

/// What is offered for the parent of a joint in a robot of 300 links, l0 to l299, behind what was typed.
Json offered_of_many(const std::string& typed) {
  MemoryDisk disk;
  Editor editor(disk);
  std::string text = "<robot name='r'>";
  for (int i = 0; i < 300; ++i) text += "<link name='l" + std::to_string(i) + "'/>";
  text += "<joint name='j' type='fixed'><parent link='" + typed + "'/></joint></robot>";
  editor.open("/ws/a.urdf", text);
  return editor.request("textDocument/completion",
                        editor.at("/ws/a.urdf", "parent link='", 13 + typed.size()));
}

TEST(LspCompletion, OfManyNamesThoseThatFitComeWithAWordThatThereIsMore) {
  const Json all = offered_of_many("");
  EXPECT_EQ(all["isIncomplete"], true);
  EXPECT_EQ(all["items"].size(), 200U);
  const Json some = offered_of_many("L7");
  std::set<std::string> labels;
  for (const Json& item : some["items"]) labels.insert(item["label"]);
  std::set<std::string> expected;
  for (int i = 0; i < 300; ++i) {
    const std::string number = std::to_string(i);
    if (number.find('7') != std::string::npos) expected.insert("l" + number);
  }
  EXPECT_EQ(labels, expected);
  const Json exact = offered_of_many("l29");
  EXPECT_EQ(exact["items"][0]["label"], "l29");
}

TEST(LspCompletion, AttributesAndTheirValues) {
  MemoryDisk disk;
  Editor editor(disk);
  const auto attributes =
      offered(editor, "/ws/a.urdf", "<robot name='r'><joint name='j' |></joint></robot>");
  EXPECT_TRUE(attributes.contains("type"));
  EXPECT_FALSE(attributes.contains("name"));
  const auto types =
      offered(editor, "/ws/b.urdf", "<robot name='r'><joint name='j' type='|'></joint></robot>");
  EXPECT_TRUE(types.contains("revolute"));
  EXPECT_TRUE(types.contains("prismatic"));
  const auto flags = offered(editor, "/ws/c.sdf",
                             "<sdf version='1.9'><model name='m'><static>|</static></model></sdf>");
  EXPECT_TRUE(flags.contains("true") && flags.contains("false"));
}

TEST(LspCompletion, NamesInScope) {
  MemoryDisk disk(test::Files{
      {"/ws/arm.sdf", "<sdf version='1.9'><model name='arm'><link name='hand'/></model></sdf>"}});
  Editor editor(disk);
  const auto links = offered(
      editor, "/ws/a.urdf",
      "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='fixed'><parent "
      "link='|'/></joint></robot>");
  EXPECT_EQ(links, (std::set<std::string>{"a", "b"}));
  const auto frames = offered(
      editor, "/ws/b.sdf",
      "<sdf version='1.9'><world name='w'><include><uri>arm.sdf</uri><name>left</name></include>"
      "<frame name='f' attached_to='|'/></world></sdf>");
  EXPECT_TRUE(frames.contains("left::hand"));
  EXPECT_TRUE(frames.contains("left"));
}

TEST(LspCompletion, NamesThatAReferenceCannotHaveAreLeftOut) {
  MemoryDisk disk;
  Editor editor(disk);
  const std::string head =
      "<sdf version='1.9'><model name='m'><link name='a'/><frame name='f'/><model name='n'>"
      "<link name='c'/></model><link name='b'>";
  const std::string joint = head + "</link><joint name='j' type='fixed'>";
  const std::string end = "</joint></model></sdf>";
  using Names = std::set<std::string>;
  EXPECT_EQ(offered(editor, "/ws/a.sdf", joint + "<child>|</child>" + end),
            (Names{"a", "b", "f", "n::c"}));
  EXPECT_EQ(offered(editor, "/ws/b.sdf", joint + "<parent>|</parent>" + end),
            (Names{"a", "b", "f", "n::c", "world"}));
  EXPECT_EQ(offered(editor, "/ws/c.sdf", head + "<pose relative_to='|'/></link></model></sdf>"),
            (Names{"a", "f", "n", "n::c", "__model__"}));
  EXPECT_EQ(offered(editor, "/ws/d.sdf",
                    "<sdf version='1.9'><world name='w'><model name='o'/><model name='m'><pose "
                    "relative_to='|'/><link name='a'/></model></world></sdf>"),
            (Names{"o", "world"}));
  EXPECT_EQ(offered(editor, "/ws/e.urdf",
                    "<robot name='r'><link name='a'/><joint name='j'/><joint name='a'>"
                    "<parent link='|'/></joint></robot>"),
            (Names{"a"}));
  EXPECT_EQ(offered(editor, "/ws/f.urdf",
                    "<robot name='r'><joint name='j'/><joint name='k'><mimic joint='|'/></joint>"
                    "</robot>"),
            (Names{"j"}));
}

TEST(LspCompletion, ASemanticDescriptionHasItsOwnElements) {
  MemoryDisk disk(test::Files{
      {"/ws/r.urdf",
       "<robot name='r'><link name='base'/><link name='tip'/><joint name='j' type='fixed'>"
       "<parent link='base'/><child link='tip'/></joint></robot>"},
      {"/ws/o.urdf", "<robot name='other'><link name='elsewhere'/></robot>"}});
  Editor editor(disk);
  using Names = std::set<std::string>;
  const auto at = [&](const std::string& text) {
    return offered(
        editor, "/ws/r.srdf",
        "<robot name='r'>\n<group name='arm'/>\n<group name='hand'/>\n" + text + "\n</robot>");
  };
  EXPECT_EQ(at("<|"),
            (Names{"group", "group_state", "end_effector", "virtual_joint", "passive_joint",
                   "joint_property", "disable_collisions", "enable_collisions",
                   "disable_default_collisions", "link_sphere_approximation", "/robot>"}));
  EXPECT_EQ(at("<group name='x'><|</group>"),
            (Names{"link", "joint", "chain", "group", "/group>"}));
  EXPECT_EQ(at("<disable_collisions link1='a' |/>"), (Names{"link2", "reason"}));
  EXPECT_EQ(at("<disable_collisions link1='|'/>"), (Names{"base", "tip"}));
  EXPECT_EQ(at("<group name='x'><chain base_link='|'/></group>"), (Names{"base", "tip"}));
  EXPECT_EQ(at("<group_state name='s' group='arm'><joint name='|'/></group_state>"), (Names{"j"}));
  EXPECT_EQ(at("<group_state name='s' group='|'/>"), (Names{"arm", "hand"}));
  EXPECT_EQ(at("<virtual_joint type='|'/>"), (Names{"fixed", "planar", "floating"}));
}

TEST(LspCompletion, ACallIsOfferedWhatItLacks) {
  MemoryDisk disk;
  Editor editor(disk);
  const std::string head =
      "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:macro name='leg' "
      "params='pre size *origin **shapes'><link name='${pre}'/></xacro:macro>";
  EXPECT_EQ(offered(editor, "/ws/a.urdf.xacro",
                    head + "<xacro:leg pre='a' |><origin/><link/></xacro:leg></robot>"),
            (std::set<std::string>{"size"}));
  editor.open("/ws/b.urdf.xacro", head + "<\n</robot>");
  const Json items =
      editor.request("textDocument/completion", editor.at("/ws/b.urdf.xacro", "<\n</robot>", 1));
  const auto leg = std::find_if(items.begin(), items.end(),
                                [](const Json& item) { return item["label"] == "xacro:leg"; });
  ASSERT_NE(leg, items.end());
  EXPECT_EQ((*leg)["textEdit"]["newText"], "xacro:leg pre=\"${1}\" size=\"${2}\">$0</xacro:leg>");
}

TEST(LspCompletion, TemplatesOfferTheirOwnNames) {
  MemoryDisk disk;
  Editor editor(disk);
  const std::string head =
      "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:arg name='side' "
      "default='l'/><xacro:property "
      "name='size' value='1'/><xacro:macro name='leg' params='a b'><link "
      "name='${a}'/></xacro:macro>";
  EXPECT_TRUE(offered(editor, "/ws/a.urdf.xacro", head + "<xac|\n</robot>").contains("xacro:leg"));
  EXPECT_EQ(offered(editor, "/ws/b.urdf.xacro", head + "<link name='x${si|}'/></robot>"),
            (std::set<std::string>{"size"}));
  EXPECT_EQ(offered(editor, "/ws/c.urdf.xacro", head + "<link name='$(arg |)'/></robot>"),
            (std::set<std::string>{"side"}));
  const auto parameters = offered(editor, "/ws/d.urdf.xacro", head + "<xacro:leg |/></robot>");
  EXPECT_EQ(parameters, (std::set<std::string>{"a", "b"}));
}

TEST(LspCompletion, UrisAreOfferedStepByStep) {
  MemoryDisk disk(test::Files{{"/ws/robot/meshes/a.stl", ""},
                              {"/ws/robot/meshes/b.dae", ""},
                              {"/ws/other/model.config", ""}});
  Editor editor(disk);
  const std::string head = "<robot name='r'><link name='a'><visual><geometry><mesh filename='";
  EXPECT_TRUE(offered(editor, "/ws/robot/r.urdf", head + "|'/>").contains("meshes/"));
  EXPECT_EQ(offered(editor, "/ws/robot/s.urdf", head + "meshes/|'/>"),
            (std::set<std::string>{"a.stl", "b.dae"}));
  EXPECT_TRUE(offered(editor, "/ws/robot/t.urdf", head + "model://|'/>").contains("other/"));
}

TEST(LspCursor, HalfWrittenTagsDoNotMatter) {
  const std::string text = "<a x='>'><b><!-- <c> --><d/><e y=\"1\" z='2";
  const XmlCursor value = xml_cursor(text, static_cast<std::uint32_t>(text.size()));
  EXPECT_EQ(value.at, XmlCursor::At::kAttributeValue);
  EXPECT_EQ(value.attribute, "z");
  EXPECT_EQ(value.typed, "2");
  ASSERT_EQ(value.open.size(), 3U);
  EXPECT_EQ(value.open[2].name, "e");
  EXPECT_EQ(attribute_in(value.open[2].tag, "y"), "1");
  const std::string broken = "<a><b <c>te";
  const XmlCursor at = xml_cursor(broken, static_cast<std::uint32_t>(broken.size()));
  EXPECT_EQ(at.at, XmlCursor::At::kText);
  EXPECT_EQ(at.typed, "te");
  // Every prefix of anything is some place.
  for (std::uint32_t i = 0; i <= text.size(); ++i) EXPECT_LE(xml_cursor(text, i).begin, i);
}

}  // namespace
}  // namespace rigor::lsp
