// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/answers.h>

#include <gtest/gtest.h>

#include <rigor/author/format/formatted.h>
#include <rigor/text/disk.h>
#include <rigor/xml/document.h>

#include "lsp/editor.h"

namespace rigor::lsp {
namespace {

using test::Editor;

/// The first action whose title begins so; null when there is none.
Json action(const Json& actions, const std::string& title) {
  for (const Json& each : actions) {
    if (each["title"].get<std::string>().starts_with(title)) return each;
  }
  return nullptr;
}

Json actions_at(Editor& editor, const std::string& path, const std::string& mark,
                std::vector<std::string> only = {}) {
  const Json position = editor.position(path, mark, 1);
  Json params = editor.document(path);
  params["range"] = {{"start", position}, {"end", position}};
  params["context"] = {{"diagnostics", Json::array()}};
  if (!only.empty()) params["context"]["only"] = only;
  return editor.request("textDocument/codeAction", params);
}

constexpr const char* kInverted =
    "<robot name=\"r\">\n"
    "  <link name=\"a\"/>\n"
    "  <link name=\"b\"/>\n"
    "  <joint name=\"j\" type=\"revolute\">\n"
    "    <parent link=\"a\"/>\n"
    "    <child link=\"b\"/>\n"
    "    <axis xyz=\"0 0 1\"/>\n"
    "    <limit lower=\"1\" upper=\"-1\" effort=\"1\" velocity=\"1\"/>\n"
    "  </joint>\n"
    "</robot>\n";

TEST(LspCodeActions, AFixIsThatOfTheFinding) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf", kInverted);
  const Json fix = action(actions_at(editor, "/ws/r.urdf", "<limit lower=\"1\""), "swap");
  Json at_value = actions_at(editor, "/ws/r.urdf", "1\" upper");
  const Json swap = fix.is_null() ? action(at_value, "swap") : fix;
  ASSERT_FALSE(swap.is_null()) << at_value.dump(1);
  EXPECT_NE(editor.edited("/ws/r.urdf", swap["edit"]).find("lower=\"-1\" upper=\"1\""),
            std::string::npos);
}

TEST(LspCodeActions, ASuppressedFindingIsGone) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf", kInverted);
  for (const char* where : {" here", " in this file"}) {
    const Json actions = actions_at(editor, "/ws/r.urdf", "1\" upper");
    const Json suppress = action(actions, std::string("suppress joint-limit-inverted") + where);
    ASSERT_FALSE(suppress.is_null()) << actions.dump(1);
    const std::string before = kInverted;
    editor.change("/ws/r.urdf", editor.edited("/ws/r.urdf", suppress["edit"]));
    for (const std::string& rule : editor.rules("/ws/r.urdf"))
      EXPECT_NE(rule, "joint-limit-inverted");
    for (const std::string& rule : editor.rules("/ws/r.urdf"))
      EXPECT_NE(rule, "unused-suppression");
    editor.change("/ws/r.urdf", before);
  }
}

TEST(LspCodeActions, AllSafeFixesAreOneSourceAction) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/m.sdf",
              "<sdf version=\"1.9\">\n  <model name=\"m\">\n    <link name=\"a\">\n      <Pose>0 0 "
              "1 0 0 0</Pose>\n    "
              "</link>\n  </model>\n</sdf>\n");
  const Json actions = actions_at(editor, "/ws/m.sdf", "<sdf", {"source.fixAll"});
  for (const Json& each : actions) EXPECT_EQ(each["kind"], "source.fixAll.rigor");
  EXPECT_TRUE(actions_at(editor, "/ws/m.sdf", "<sdf", {"source.organizeImports"}).empty());
}

TEST(LspCodeActions, AnInertialAndALimitAreWritten) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf",
              "<robot name=\"r\">\n  <link name=\"a\">\n    <collision>\n      <geometry>\n        "
              "<box size=\"1 1 "
              "1\"/>\n      </geometry>\n    </collision>\n  </link>\n  <link name=\"b\"/>\n  "
              "<joint name=\"j\" "
              "type=\"revolute\">\n    <parent link=\"a\"/>\n    <child link=\"b\"/>\n    <axis "
              "xyz=\"0 0 1\"/>\n  "
              "</joint>\n</robot>\n");
  Json inertial = action(actions_at(editor, "/ws/r.urdf", "<collision"), "compute this inertial");
  ASSERT_FALSE(inertial.is_null());
  inertial = editor.request("codeAction/resolve", inertial);
  ASSERT_TRUE(inertial.contains("edit")) << editor.error().dump();
  // Water, 1 m³: 1000 kg, and m/6 for a cube.
  const std::string with_mass = editor.edited("/ws/r.urdf", inertial["edit"]);
  EXPECT_NE(with_mass.find("<mass value=\"1000\"/>"), std::string::npos) << with_mass;
  EXPECT_NE(with_mass.find("ixx=\"166.6"), std::string::npos) << with_mass;
  Json limit = action(actions_at(editor, "/ws/r.urdf", "<axis"), "add the missing limit");
  ASSERT_FALSE(limit.is_null());
  limit = editor.request("codeAction/resolve", limit);
  EXPECT_NE(
      editor.edited("/ws/r.urdf", limit["edit"]).find("<axis xyz=\"0 0 1\"/>\n    <limit lower="),
      std::string::npos);
}

TEST(LspCodeActions, FindingsAreAddedToTheBaseline) {
  MemoryDisk disk(test::Files{{"/ws/rigor.toml", "baseline = \"known\"\n"},
                              {"/ws/known", "2 axis-zero other.urdf\n"}});
  Editor editor(disk);
  editor.open("/ws/r.urdf", kInverted);
  editor.open("/ws/known", "2 axis-zero other.urdf\n");
  const Json add = action(actions_at(editor, "/ws/r.urdf", "1\" upper"),
                          "add the finding of joint-limit-inverted in this file to known");
  ASSERT_FALSE(add.is_null());
  const std::string baseline = editor.edited("/ws/known", add["edit"]);
  EXPECT_NE(baseline.find("\n1 joint-limit-inverted r.urdf\n"), std::string::npos) << baseline;
  EXPECT_NE(baseline.find("\n2 axis-zero other.urdf\n"), std::string::npos) << baseline;
  editor.change("/ws/known", baseline);
  for (const std::string& rule : editor.rules("/ws/r.urdf"))
    EXPECT_NE(rule, "joint-limit-inverted");
}

TEST(LspCodeActions, ABaselineThatIsNotThereIsMadeWhereTheClientCan) {
  MemoryDisk disk(test::Files{{"/ws/rigor.toml", "baseline = \"known\"\n"}});
  Editor simple(disk);
  simple.open("/ws/r.urdf", kInverted);
  EXPECT_TRUE(action(actions_at(simple, "/ws/r.urdf", "1\" upper"), "add the finding").is_null());
  Json capabilities = Editor::default_capabilities();
  capabilities["workspace"]["workspaceEdit"] = {{"documentChanges", true},
                                                {"resourceOperations", {"create"}}};
  Editor editor(disk, capabilities);
  editor.open("/ws/r.urdf", kInverted);
  const Json add = action(actions_at(editor, "/ws/r.urdf", "1\" upper"), "add the finding");
  ASSERT_FALSE(add.is_null());
  EXPECT_EQ(add["edit"]["documentChanges"][0]["kind"], "create");
  EXPECT_EQ(add["edit"]["documentChanges"][0]["uri"], "file:///ws/known");
}

TEST(LspCodeActions, AValueBecomesAPropertyAndAValueAgain) {
  const std::string head = "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n";
  const std::string text =
      head + "  <link name='a'><inertial><mass value='2.5'/></inertial></link>\n</robot>\n";
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf.xacro", text);
  const Json extract =
      action(actions_at(editor, "/ws/r.urdf.xacro", "2.5", {"refactor"}), "extract to property");
  ASSERT_FALSE(extract.is_null());
  const std::string extracted =
      editor.edited("/ws/r.urdf.xacro", editor.request("codeAction/resolve", extract)["edit"]);
  EXPECT_EQ(extracted,
            head +
                "  <xacro:property name=\"mass_value\" value=\"2.5\"/>\n"
                "  <link name='a'><inertial><mass value='${mass_value}'/></inertial></link>\n"
                "</robot>\n");
  editor.change("/ws/r.urdf.xacro", extracted);
  const Json inlined = action(actions_at(editor, "/ws/r.urdf.xacro", "mass_value\"", {"refactor"}),
                              "inline property 'mass_value'");
  ASSERT_FALSE(inlined.is_null());
  EXPECT_EQ(
      editor.edited("/ws/r.urdf.xacro", editor.request("codeAction/resolve", inlined)["edit"]),
      text);
}

TEST(LspFormatting, IsThatOfTheFormatter) {
  MemoryDisk disk(test::Files{{"/ws/rigor.toml", "[format]\nindent = 4\n"}});
  Editor editor(disk);
  const std::string text = "<robot name='r'><link name='a'/>\n<link   name='b'/></robot>";
  editor.open("/ws/r.urdf", text);
  Json params = editor.document("/ws/r.urdf");
  const Json edits = editor.request("textDocument/formatting", params);
  EXPECT_EQ(Editor::applied(text, edits),
            "<robot name=\"r\">\n    <link name=\"a\"/>\n    <link name=\"b\"/>\n</robot>\n");
  params["range"] = {{"start", {{"line", 1}, {"character", 0}}},
                     {"end", {{"line", 1}, {"character", 5}}}};
  const author::FormatStyle style{.indent = "    "};
  const author::Formatted lines =
      author::formatted_in_lines(xml::parse(text, SourceId{0}), style, 2, 2);
  EXPECT_EQ(Editor::applied(text, editor.request("textDocument/rangeFormatting", params)),
            lines.text);
  editor.change("/ws/r.urdf", "<robot");
  EXPECT_TRUE(editor.request("textDocument/formatting", editor.document("/ws/r.urdf")).is_null());
  EXPECT_EQ(editor.error()["code"], -32803);
}

TEST(LspHover, SaysWhatALinkWeighsAndHowAJointMoves) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf",
              "<robot name='r'>\n<link name='a'><inertial><mass value='6'/><inertia ixx='1' "
              "ixy='0' ixz='0' iyy='1' "
              "iyz='0' izz='1'/></inertial><collision><geometry><box size='1 1 "
              "1'/></geometry></collision></link>\n"
              "<link name='b'/>\n<joint name='j' type='revolute'><parent link='a'/><child "
              "link='b'/><axis xyz='0 0 1'/>"
              "<limit lower='0' upper='3.14159265' effort='1' velocity='1'/></joint>\n</robot>");
  const auto text = [&](const std::string& mark, std::size_t moved) {
    const Json hover = editor.request("textDocument/hover", editor.at("/ws/r.urdf", mark, moved));
    return hover.is_null() ? std::string() : hover["contents"]["value"].get<std::string>();
  };
  const std::string link = text("name='a'", 6);
  EXPECT_NE(link.find("6 kg"), std::string::npos) << link;
  EXPECT_NE(link.find("density 6 kg/m³"), std::string::npos) << link;  // of a cube of 1 m³
  EXPECT_NE(link.find("moments here are 1 times"), std::string::npos) << link;  // 6/6 = 1
  const std::string joint = text("name='j'", 6);
  EXPECT_NE(joint.find("0° to 180°"), std::string::npos) << joint;
  EXPECT_NE(text("<limit lower", 2).find("**limit**"), std::string::npos);
}

TEST(LspHover, ShowsAMesh) {
  // A tetrahedron: four triangles, of which each edge is in two.
  const std::string obj =
      "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  MemoryDisk disk(test::Files{{"/ws/t.obj", obj}});
  Editor editor(disk);
  editor.open("/ws/m.sdf",
              "<sdf version='1.9'><model name='m'><link name='l'><visual name='v'><geometry><mesh>"
              "<uri>t.obj</uri></mesh></geometry></visual></link></model></sdf>");
  const Json hover = editor.request("textDocument/hover", editor.at("/ws/m.sdf", "t.obj", 2));
  const std::string text = text_at(hover, "contents", "value");
  EXPECT_NE(text.find("4 triangles, closed; extents (2 3 4)"), std::string::npos) << text;
  EXPECT_EQ(text.find("data:image"), std::string::npos);
}

TEST(LspHover, ShowsWhatAnExpressionGives) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf.xacro",
              "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n<xacro:macro name='m' "
              "params='n'>"
              "<link name='${n}_link'/></xacro:macro>\n<xacro:m n='a'/><xacro:m n='b'/>\n</robot>");
  const Json hover =
      editor.request("textDocument/hover", editor.at("/ws/r.urdf.xacro", "}_link", 3));
  ASSERT_FALSE(hover.is_null());
  const std::string text = hover["contents"]["value"];
  EXPECT_NE(text.find("`a_link`"), std::string::npos) << text;
  EXPECT_NE(text.find("`b_link`"), std::string::npos) << text;
}

TEST(LspHover, TagsOfXacroAreNotTheElementAroundThem) {
  MemoryDisk disk(
      test::Files{{"/ws/m.xacro",
                   "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:macro name='wheel' "
                   "params='side *origin'><link name='${side}_wheel'/></xacro:macro></robot>"}});
  Editor editor(disk);
  const std::string path = "/ws/r.urdf.xacro";
  editor.open(path,
              "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n<xacro:include "
              "filename='m.xacro'/>\n<xacro:if value='1'><link name='a'/></xacro:if>\n"
              "<xacro:wheel side='l'>\n<origin/>\n</xacro:wheel>\n</robot>");
  const auto text = [&](const std::string& mark, std::size_t moved) {
    const Json hover = editor.request("textDocument/hover", editor.at(path, mark, moved));
    return hover.is_null() ? std::string() : hover["contents"]["value"].get<std::string>();
  };
  EXPECT_NE(text("<xacro:include", 8).find("another file"), std::string::npos);
  EXPECT_NE(text("<xacro:if", 2).find("if `value` is true"), std::string::npos);
  EXPECT_EQ(text("filename='m.xacro'", 3).find("robot"), std::string::npos);
  // On the prefix, on the name, and on that in the end tag.
  const std::string macro = text("<xacro:wheel", 8);
  EXPECT_NE(macro.find("params='side *origin'"), std::string::npos) << macro;
  EXPECT_NE(macro.find("m.xacro"), std::string::npos) << macro;
  EXPECT_EQ(text("<xacro:wheel", 2), macro);
  EXPECT_EQ(text("</xacro:wheel", 9), macro);
  EXPECT_NE(text("<link", 2).find("**link**"), std::string::npos);
}

TEST(LspAnswers, BrokenXmlKeepsTheLastModel) {
  MemoryDisk disk;
  Editor editor(disk);
  const std::string whole =
      "<robot name='r'>\n<link name='a'/>\n<link name='b'/>\n<joint name='j' type='fixed'><parent "
      "link='a'/><child "
      "link='b'/></joint>\n</robot>";
  editor.open("/ws/r.urdf", whole);
  editor.request("textDocument/documentHighlight", editor.at("/ws/r.urdf", "link='b'", 6));
  std::string broken = whole;
  broken.insert(broken.find("<link name='b'"), "<li ");
  editor.change("/ws/r.urdf", broken);
  const Json highlights =
      editor.request("textDocument/documentHighlight", editor.at("/ws/r.urdf", "link='b'", 6));
  EXPECT_EQ(highlights.size(), 2U);
}

TEST(LspAnswers, HoverDoesNotWaitForTheModelOfTheLastKey) {
  const std::string text =
      std::string(
          "<robot name='r'>\n<link name='a'><inertial><mass value='2'/><inertia ixx='1' "
          "ixy='0' ") +
      "ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link>\n<!--" + std::string(70'000, ' ') +
      "--></robot>\n";  // too long to be read at once
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf", text);
  const auto hover = [&] {
    return editor.request("textDocument/hover", editor.at("/ws/r.urdf", "name='a'", 7));
  };
  std::string longer(text);
  longer.insert(longer.find("<link"), "<!-- a line -->\n");
  editor.type("/ws/r.urdf", longer);  // no time to prepare anything
  EXPECT_NE(text_at(hover(), "contents", "value").find("2 kg"), std::string::npos);
  EXPECT_EQ(hover()["range"]["start"]["line"], 2);
  EXPECT_EQ(editor.request("textDocument/definition",
                           editor.at("/ws/r.urdf", "name='a'", 7))["range"]["start"]["line"],
            2);
  std::string heavier(longer);
  heavier.replace(heavier.find("'2'"), 3, "'3'");
  editor.type("/ws/r.urdf", heavier);
  EXPECT_NE(text_at(hover(), "contents", "value").find("2 kg"), std::string::npos);
  editor.work();
  EXPECT_NE(text_at(hover(), "contents", "value").find("3 kg"), std::string::npos);
}

TEST(LspAnswers, TheStructureOfADocument) {
  MemoryDisk disk(test::Files{{"/ws/m.stl", "solid"}});
  Editor editor(disk);
  editor.open("/ws/r.urdf",
              std::string(kInverted).insert(
                  std::string(kInverted).find("  <link name=\"b\""),
                  "  <material name=\"red\"><color rgba=\"1 0 0 0.5\"/></material>\n"));
  const Json symbols = editor.request("textDocument/documentSymbol", editor.document("/ws/r.urdf"));
  ASSERT_EQ(symbols.size(), 1U);
  EXPECT_EQ(symbols[0]["children"].size(), 4U);
  const Json found = editor.request("workspace/symbol", {{"query", "j"}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]["name"], "j");
  const Json folds = editor.request("textDocument/foldingRange", editor.document("/ws/r.urdf"));
  EXPECT_EQ(folds.size(), 2U);
  Json params = editor.document("/ws/r.urdf");
  params["positions"] = {editor.position("/ws/r.urdf", "0 0 1", 1)};
  const Json selection = editor.request("textDocument/selectionRange", params);
  EXPECT_EQ(selection[0]["range"]["start"], editor.position("/ws/r.urdf", "0 0 1"));
  const Json colors = editor.request("textDocument/documentColor", editor.document("/ws/r.urdf"));
  ASSERT_EQ(colors.size(), 1U);
  EXPECT_EQ(colors[0]["color"],
            (Json{{"red", 1.0}, {"green", 0.0}, {"blue", 0.0}, {"alpha", 0.5}}));
  const Json lenses = editor.request("textDocument/codeLens", editor.document("/ws/r.urdf"));
  ASSERT_EQ(lenses.size(), 1U);
  EXPECT_TRUE(lenses[0]["command"]["title"].get<std::string>().starts_with("2 links, 1 joint, "));
}

TEST(LspAnswers, TagsAreClosedAndEditedTogether) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf", "<robot name='r'>\n<link name='a'>\n</robot>");
  Json params = editor.at("/ws/r.urdf", "'a'>", 4);
  params["ch"] = ">";
  const Json closed = editor.request("textDocument/onTypeFormatting", params);
  ASSERT_EQ(closed.size(), 1U);
  EXPECT_EQ(closed[0]["newText"], "</link>");
  editor.change("/ws/r.urdf", "<robot name='r'>\n<link name='a'></\n</robot>");
  params = editor.at("/ws/r.urdf", "></", 3);
  params["ch"] = "/";
  const Json named = editor.request("textDocument/onTypeFormatting", params);
  ASSERT_EQ(named.size(), 1U);
  EXPECT_EQ(named[0]["newText"], "link>");
  editor.change("/ws/r.urdf", "<robot name='r'>\n<link name='a'></link>\n</robot>");
  const Json linked =
      editor.request("textDocument/linkedEditingRange", editor.at("/ws/r.urdf", "<link", 2));
  EXPECT_EQ(linked["ranges"].size(), 2U);
}

TEST(LspAnswers, TheExpandedTemplateIsADocument) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf.xacro",
              "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'><link name='${1 + "
              "1}'/></robot>");
  const Json expanded = editor.request("rigor/expanded", editor.document("/ws/r.urdf.xacro"));
  EXPECT_NE(expanded["text"].get<std::string>().find("<link name=\"2\"/>"), std::string::npos);
  EXPECT_NE(
      editor.request("rigor/explain", {{"rule", "axis-zero"}})["text"].get<std::string>().find(
          "axis"),
      std::string::npos);
}

/// Whatever a client asks of whatever text, there is an answer.
TEST(LspAnswers, EveryRequestAtEveryPlaceIsAnswered) {
  MemoryDisk disk;
  Editor editor(disk);
  const std::string text =
      "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:macro name='m' params='a "
      "b:=${1}'><link "
      "name='${a}'/></xacro:macro><xacro:m a='x'/><joint name='j'><parent "
      "link='x'/></joint></robot>";
  const std::vector<std::string> methods{"textDocument/hover",
                                         "textDocument/completion",
                                         "textDocument/definition",
                                         "textDocument/references",
                                         "textDocument/documentHighlight",
                                         "textDocument/prepareRename",
                                         "textDocument/codeLens",
                                         "textDocument/linkedEditingRange",
                                         "textDocument/onTypeFormatting",
                                         "textDocument/documentSymbol",
                                         "textDocument/foldingRange",
                                         "textDocument/prepareCallHierarchy",
                                         "textDocument/documentLink",
                                         "textDocument/semanticTokens/full",
                                         "textDocument/documentColor"};
  for (const std::string path : {"/ws/r.urdf.xacro", "/ws/r.urdf"}) {
    for (std::size_t end = 0; end <= text.size(); end += 3) {
      editor.open(path, text.substr(0, end));
      Json params = editor.document(path);
      params["position"] = {{"line", 0}, {"character", end}};
      params["ch"] = ">";
      for (const std::string& method : methods) {
        editor.request(method, params);
        EXPECT_TRUE(editor.error().is_null())
            << method << " " << end << " " << editor.error().dump();
      }
    }
  }
}

}  // namespace
}  // namespace rigor::lsp
