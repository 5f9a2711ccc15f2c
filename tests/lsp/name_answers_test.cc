// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <set>

#include <rigor/text/disk.h>

#include "lsp/editor.h"

namespace rigor::lsp {
namespace {

using test::Editor;

constexpr const char* kArm = R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <link name="hand"><pose relative_to="elbow"/></link>
    <joint name="elbow" type="revolute"><parent>base</parent><child>hand</child><axis><xyz>0 0 1</xyz></axis></joint>
    <plugin name="p" filename="x"><joint_name>elbow</joint_name><topic>elbow</topic></plugin>
  </model>
</sdf>
)";
constexpr const char* kWorld = R"(<sdf version="1.9">
  <world name="w">
    <include><uri>arm.sdf</uri><name>left</name></include>
    <include><uri>arm.sdf</uri></include>
    <frame name="f" attached_to="left::hand"/>
    <frame name="g" attached_to="arm::hand"/>
  </world>
</sdf>
)";

TEST(LspNames, ADefinitionIsFoundThroughIncludes) {
  MemoryDisk disk(test::Files{{"/ws/arm.sdf", kArm}});
  Editor editor(disk);
  editor.open("/ws/w.sdf", kWorld);
  const Json hand =
      editor.request("textDocument/definition", editor.at("/ws/w.sdf", "left::hand", 7));
  EXPECT_EQ(hand["uri"], "file:///ws/arm.sdf");
  EXPECT_EQ(hand["range"]["start"], (Json{{"line", 3}, {"character", 16}}));
  const Json left =
      editor.request("textDocument/definition", editor.at("/ws/w.sdf", "left::hand", 1));
  EXPECT_EQ(left["uri"], "file:///ws/w.sdf");
  EXPECT_EQ(left["range"]["start"]["line"], 2);
  const Json file = editor.request("textDocument/definition", editor.at("/ws/w.sdf", "arm.sdf", 1));
  EXPECT_EQ(file["uri"], "file:///ws/arm.sdf");
}

TEST(LspNames, ReferencesAreThoseOfTheWorkspace) {
  MemoryDisk disk(test::Files{{"/ws/arm.sdf", kArm}, {"/ws/w.sdf", kWorld}});
  Editor editor(disk);
  editor.open("/ws/arm.sdf", kArm);
  Json params = editor.at("/ws/arm.sdf", "\"hand\"", 2);
  params["context"] = {{"includeDeclaration", true}};
  EXPECT_EQ(editor.request("textDocument/references", params).size(), 4U);
  params["context"] = {{"includeDeclaration", false}};
  EXPECT_EQ(editor.request("textDocument/references", params).size(), 3U);
  const Json highlights =
      editor.request("textDocument/documentHighlight", editor.at("/ws/arm.sdf", "\"hand\"", 2));
  EXPECT_EQ(highlights.size(), 2U);
}

TEST(LspNames, RenamingReachesPluginsAndOtherFiles) {
  MemoryDisk disk(test::Files{{"/ws/arm.sdf", kArm}, {"/ws/w.sdf", kWorld}});
  Editor editor(disk);
  editor.open("/ws/arm.sdf", kArm);
  editor.open("/ws/w.sdf", kWorld);
  Json params = editor.at("/ws/arm.sdf", "name=\"elbow\"", 7);
  EXPECT_EQ(editor.request("textDocument/prepareRename", params)["placeholder"], "elbow");
  params["newName"] = "bend";
  std::string arm = editor.edited("/ws/arm.sdf", editor.request("textDocument/rename", params));
  EXPECT_EQ(arm,
            std::string(kArm)
                .replace(std::string(kArm).find("relative_to=\"elbow"), 18, "relative_to=\"bend")
                .replace(std::string(kArm).find("joint name=\"elbow") - 1, 17, "joint name=\"bend")
                .replace(std::string(kArm).find("joint_name>elbow") - 2, 16, "joint_name>bend"));
  params = editor.at("/ws/arm.sdf", "name=\"hand\"", 7);
  params["newName"] = "palm";
  const Json edit = editor.request("textDocument/rename", params);
  const std::string world = editor.edited("/ws/w.sdf", edit);
  EXPECT_NE(world.find("left::palm"), std::string::npos);
  EXPECT_NE(world.find("arm::palm"), std::string::npos);
  EXPECT_EQ(world.find("hand"), std::string::npos);
}

TEST(LspNames, WhatCannotBeRenamedIsRefusedWithTheReason) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/arm.sdf", kArm);
  Json params = editor.at("/ws/arm.sdf", "name=\"hand\"", 7);
  for (const std::string name : {"base", "a::b", "", "__x__", "world"}) {
    params["newName"] = name;
    EXPECT_TRUE(editor.request("textDocument/rename", params).is_null());
    EXPECT_EQ(editor.error()["code"], -32803) << name;
  }
  const std::string composed =
      "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n<xacro:property name='p' "
      "value='left'/>\n"
      "<link name='${p}_a'/>\n<link name='b'/>\n<joint name='j' type='fixed'><parent "
      "link='left_a'/><child "
      "link='b'/></joint>\n</robot>";
  editor.open("/ws/r.urdf.xacro", composed);
  params = editor.at("/ws/r.urdf.xacro", "'left_a'", 2);
  params["newName"] = "c";
  EXPECT_TRUE(editor.request("textDocument/rename", params).is_null());
  EXPECT_NE(editor.error()["message"].get<std::string>().find(
                "an expression composes the name at /ws/r.urdf.xacro:3"),
            std::string::npos)
      << editor.error().dump();
}

TEST(LspNames, ANameThatAnExpressionComposesIsRenamedWhole) {
  const std::string once =
      "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n"
      "<xacro:macro name='m' params='side'><link name='${side}_wheel'/></xacro:macro>\n"
      "<xacro:m side='left'/>\n</robot>";
  MemoryDisk disk;
  Editor editor(disk);
  const std::string path = "/ws/r.urdf.xacro";
  editor.open(path, once);
  Json params = editor.at(path, "_wheel", 2);
  const Json prepared = editor.request("textDocument/prepareRename", params);
  EXPECT_EQ(prepared["placeholder"], "left_wheel");
  params["newName"] = "left_tyre";
  const std::string after = editor.edited(path, editor.request("textDocument/rename", params));
  EXPECT_NE(after.find("'${side}_tyre'"), std::string::npos) << after;
  // Of two calls it is the name of two links.
  std::string twice = once;
  twice.insert(twice.find("</robot>"), "<xacro:m side='right'/>");
  const std::string other = "/ws/s.urdf.xacro";
  editor.open(other, twice);
  params = editor.at(other, "_wheel", 2);
  params["newName"] = "left_tyre";
  EXPECT_TRUE(editor.request("textDocument/rename", params).is_null());
  EXPECT_NE(editor.error()["message"].get<std::string>().find("the name of several"),
            std::string::npos)
      << editor.error().dump();
}

constexpr const char* kTemplate =
    "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n"
    "<xacro:arg name='scale' default='1'/>\n"
    "<xacro:property name='radius' value='${2 * 0.1}'/>\n"
    "<xacro:macro name='wheel' params='side parent radius:=1'>\n"
    "<link name='${side}_wheel'><visual><geometry><sphere "
    "radius='${radius}'/></geometry></visual></link>\n"
    "<joint name='${side}_joint' type='fixed'><parent link='${parent}'/><child "
    "link='${side}_wheel'/></joint>\n"
    "</xacro:macro>\n"
    "<link name='base'><visual><geometry><sphere radius='${radius * $(arg "
    "scale)}'/></geometry></visual></link>\n"
    "<xacro:wheel side='left' parent='base'></xacro:wheel>\n"
    "<xacro:wheel side='right' parent='base'/>\n"
    "</robot>\n";

TEST(LspNames, NamesOfTemplatesAreRenamedWhereTheyMeanTheSame) {
  MemoryDisk disk;
  Editor editor(disk);
  const std::string path = "/ws/r.urdf.xacro";
  editor.open(path, kTemplate);
  const auto renamed = [&](const std::string& mark, std::size_t moved, const std::string& name) {
    Json params = editor.at(path, mark, moved);
    params["newName"] = name;
    const Json edit = editor.request("textDocument/rename", params);
    return edit.is_null() ? editor.error().dump() : editor.edited(path, edit);
  };
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
    return text;
  };
  // A parameter hides the property of its name.
  std::string expected = replaced(kTemplate, "property name='radius'", "property name='r_big'");
  expected = replaced(expected, "${radius *", "${r_big *");
  EXPECT_EQ(renamed("property name='radius'", 16, "r_big"), expected);
  expected =
      replaced(replaced(kTemplate, "name='wheel'", "name='roll'"), "xacro:wheel", "xacro:roll");
  EXPECT_EQ(renamed("<xacro:wheel", 8, "roll"), expected);
  expected = replaced(replaced(kTemplate, "side parent", "hand parent"), "${side}", "${hand}");
  EXPECT_EQ(renamed("params='side", 9, "hand"), replaced(expected, " side='", " hand='"));
  expected = replaced(replaced(kTemplate, "arg name='scale'", "arg name='size'"), "$(arg scale)",
                      "$(arg size)");
  EXPECT_EQ(renamed("arg name='scale'", 10, "size"), expected);
  // A link, through the argument of a macro that names it.
  expected = replaced(replaced(kTemplate, "name='base'", "name='torso'"), "parent='base'",
                      "parent='torso'");
  EXPECT_EQ(renamed("link name='base'", 11, "torso"), expected);
  EXPECT_NE(renamed("property name='radius'", 16, "2x").find("-32803"), std::string::npos);
}

TEST(LspNames, ANameThatAMacroComposesIsDefinedInTheMacro) {
  const std::string macros =
      "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'>\n"
      "<xacro:macro name='leg' params='side'>\n"
      "<link name='${side}_foot'/>\n"
      "<joint name='${side}_ankle' type='fixed'>\n"
      "<parent link='base'/>\n"
      "<child link='${side}_foot'/>\n"
      "</joint>\n</xacro:macro>\n</robot>\n";
  const std::string robot =
      "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n"
      "<xacro:include filename='macros.xacro'/>\n<link name='base'/>\n"
      "<xacro:leg side='l'/>\n<xacro:leg side='r'/>\n"
      "<gazebo reference='l_foot'/>\n</robot>\n";
  MemoryDisk disk(test::Files{{"/ws/macros.xacro", macros}, {"/ws/r.urdf.xacro", robot}});
  Editor editor(disk);
  editor.open("/ws/r.urdf.xacro", robot);
  editor.open("/ws/macros.xacro", macros);
  const Json link = {
      {"uri", "file:///ws/macros.xacro"},
      {"range",
       {{"start", {{"line", 2}, {"character", 12}}}, {"end", {{"line", 2}, {"character", 24}}}}}};
  const auto definition = [&](const std::string& path, const std::string& mark, std::size_t moved) {
    return editor.request("textDocument/definition", editor.at(path, mark, moved));
  };
  EXPECT_EQ(definition("/ws/r.urdf.xacro", "'l_foot'", 3), link);
  EXPECT_EQ(definition("/ws/macros.xacro", "child link='${side}_foot'", 21), Json::array({link}));
  EXPECT_EQ(definition("/ws/macros.xacro", "link name='${side}_foot'", 20), Json::array({link}));
  // Itself, the child of the joint, and the reference to one of the two links.
  const auto lines = [](const Json& places) {
    std::set<std::string> found;
    for (const Json& place : places)
      found.insert(place["uri"].get<std::string>().substr(11) + ":" +
                   place["range"]["start"]["line"].dump());
    return found;
  };
  Json params = editor.at("/ws/macros.xacro", "link name='${side}_foot'", 20);
  params["context"] = {{"includeDeclaration", true}};
  EXPECT_EQ(lines(editor.request("textDocument/references", params)),
            (std::set<std::string>{"macros.xacro:2", "macros.xacro:5", "r.urdf.xacro:5"}));
  params["newName"] = "paw";
  EXPECT_TRUE(editor.request("textDocument/rename", params).is_null());
}

TEST(LspNames, ARenameReachesControllersAndAsksForWhatMayBeTheName) {
  const std::string robot =
      "<robot name='r'><link name='a'/><link name='b'/><joint name='elbow' type='fixed'>"
      "<parent link='a'/><child link='b'/></joint></robot>";
  MemoryDisk disk(test::Files{{"/ws/config/c.yaml", "joints: [elbow]\nnote: elbow\n"}});
  Json capabilities = Editor::default_capabilities();
  capabilities["workspace"]["workspaceEdit"] = {{"documentChanges", true},
                                                {"changeAnnotationSupport", Json::object()}};
  for (const bool asks : {true, false}) {
    Editor editor(disk, asks ? capabilities : Editor::default_capabilities());
    editor.open("/ws/r.urdf", robot);
    Json params = editor.at("/ws/r.urdf", "'elbow'", 2);
    params["newName"] = "knee";
    const Json edit = editor.request("textDocument/rename", params);
    ASSERT_FALSE(edit.is_null()) << editor.error().dump();
    if (!asks) {
      EXPECT_EQ(edit["changes"]["file:///ws/config/c.yaml"].size(), 1U);
      continue;
    }
    const Json& of_yaml = edit["documentChanges"][0];
    EXPECT_EQ(of_yaml["textDocument"]["uri"], "file:///ws/config/c.yaml");
    ASSERT_EQ(of_yaml["edits"].size(), 2U);
    EXPECT_FALSE(of_yaml["edits"][0].contains("annotationId"));
    const std::string annotation = of_yaml["edits"][1]["annotationId"];
    EXPECT_TRUE(edit["changeAnnotations"][annotation]["needsConfirmation"]);
  }
}

TEST(LspNames, ASemanticDescriptionFollowsItsRobot) {
  const std::string robot =
      "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='fixed'><parent "
      "link='a'/><child "
      "link='b'/></joint></robot>";
  const std::string srdf =
      "<robot name='r'><group name='g'><chain base_link='a' "
      "tip_link='b'/></group><disable_collisions link1='a' "
      "link2='b' reason='Adjacent'/></robot>";
  MemoryDisk disk(test::Files{{"/ws/r.urdf", robot}, {"/ws/r.srdf", srdf}});
  Editor editor(disk);
  editor.open("/ws/r.urdf", robot);
  editor.open("/ws/r.srdf", srdf);
  Json params = editor.at("/ws/r.urdf", "link name='b'", 11);
  params["newName"] = "tip";
  const std::string after =
      editor.edited("/ws/r.srdf", editor.request("textDocument/rename", params));
  EXPECT_NE(after.find("tip_link='tip'"), std::string::npos) << after;
  EXPECT_NE(after.find("link2='tip'"), std::string::npos) << after;
  EXPECT_EQ(editor.request("textDocument/definition",
                           editor.at("/ws/r.srdf", "base_link='a'", 11))["uri"],
            "file:///ws/r.urdf");
}

TEST(LspNames, SrdfThatIsNotOpenIsRenamedAsWell) {
  const std::string robot = "<robot name='r'><link name='a'/></robot>";
  const std::string srdf =
      "<robot name='r'><virtual_joint name='v' type='fixed' parent_frame='world' "
      "child_link='a'/></robot>";
  MemoryDisk disk(test::Files{{"/ws/r.urdf", robot}, {"/ws/config/r.srdf", srdf}});
  Editor editor(disk);
  editor.open("/ws/r.urdf", robot);
  Json params = editor.at("/ws/r.urdf", "link name='a'", 11);
  params["newName"] = "tip";
  const Json edit = editor.request("textDocument/rename", params);
  const std::string after = Editor::applied(srdf, edit["changes"]["file:///ws/config/r.srdf"]);
  EXPECT_NE(after.find("child_link='tip'"), std::string::npos) << after;
}

TEST(LspNames, MacrosHaveAHierarchyOfCalls) {
  MemoryDisk disk;
  Editor editor(disk);
  const std::string path = "/ws/r.urdf.xacro";
  editor.open(
      path,
      "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n"
      "<xacro:macro name='leaf' params='n'><link name='${n}'/></xacro:macro>\n"
      "<xacro:macro name='pair' params=''><xacro:leaf n='a'/><xacro:leaf n='b'/></xacro:macro>\n"
      "<xacro:pair/>\n</robot>\n");
  const Json items =
      editor.request("textDocument/prepareCallHierarchy", editor.at(path, "<xacro:leaf", 8));
  ASSERT_EQ(items.size(), 1U);
  const Json incoming = editor.request("callHierarchy/incomingCalls", {{"item", items[0]}});
  ASSERT_EQ(incoming.size(), 1U);
  EXPECT_EQ(incoming[0]["from"]["name"], "pair");
  EXPECT_EQ(incoming[0]["fromRanges"].size(), 2U);
  const Json outgoing =
      editor.request("callHierarchy/outgoingCalls", {{"item", incoming[0]["from"]}});
  ASSERT_EQ(outgoing.size(), 1U);
  EXPECT_EQ(outgoing[0]["to"]["name"], "leaf");
  const Json of_robot =
      editor.request("callHierarchy/incomingCalls", {{"item", incoming[0]["from"]}});
  ASSERT_EQ(of_robot.size(), 1U) << "the robot itself calls it";
  EXPECT_EQ(of_robot[0]["from"]["name"], "r.urdf.xacro");
}

}  // namespace
}  // namespace rigor::lsp
