// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rigor/read/template/argument_sets.h>
#include <rigor/read/template/expanded_file.h>
#include <rigor/read/template/installed_path.h>
#include <rigor/read/workspace.h>
#include <rigor/xml/document.h>

namespace rigor::read {
namespace {

constexpr const char* kHead = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n";

/// What of the template is the origin of the first place of `part` in its expansion.
std::string origin_of(const std::string& body, const std::string& part) {
  MemoryDisk disk({{"r.xacro", kHead + body + "</robot>\n"}});
  Sources sources;
  const Resolver resolver(disk, {});
  Workspace workspace(resolver, sources);
  const File& file = workspace.open("r.xacro");
  if (!file.expanded || !file.document) return "not expanded";
  const std::size_t at = sources.bytes(file.source).find(part);
  if (at == std::string_view::npos) return "not there";
  const Span where{file.source, static_cast<std::uint32_t>(at),
                   static_cast<std::uint32_t>(at + part.size())};
  return std::string(sources.bytes(file.expanded->origin(*file.document, where, sources).where));
}

TEST(ExpandedFile, KnowsWherePartsAreWritten) {
  const std::string body =
      "<xacro:property name=\"a\" value=\"1\"/>\n"
      "<xacro:macro name=\"leg\" params=\"side\"><link name=\"${side}_leg\" kind=\"long leg\"/>"
      "</xacro:macro>\n"
      "<xacro:leg side=\"left\"/>\n<size>${a + 1} 7 ${a}</size>\n<box size=\"0.5 ${a + 2} "
      "${a}\"/>\n";
  EXPECT_EQ(origin_of(body, "left_leg"), "${side}_leg");
  EXPECT_EQ(origin_of(body, "long leg"), "long leg");
  EXPECT_EQ(origin_of(body, "leg\" name"), "<link name=\"${side}_leg\" kind=\"long leg\"/>");
  EXPECT_EQ(origin_of(body, "kind"), "kind");
  EXPECT_EQ(origin_of(body, "kind=\"long leg\""), "kind=\"long leg\"");
  EXPECT_EQ(origin_of(body, "link"), "link");
  EXPECT_EQ(origin_of(body, "2 7 1"), "${a + 1} 7 ${a}");
  EXPECT_EQ(origin_of(body, "3"), "${a + 2}");
  EXPECT_EQ(origin_of(body, "0.5"), "0.5");
  // Behind a child, where no element has its value.
  EXPECT_EQ(
      origin_of("<xacro:macro name=\"m\"><link name=\"l\"/> lost </xacro:macro>\n<xacro:m/>\n",
                "lost"),
      "lost");
}

/// Pieces of templates that are hard to print, in any order and place.
TEST(ExpandedFile, IsReadAsIfTinyxml2HadBeenAsked) {
  const std::vector<std::string> pieces{
      "<",         ">",    "&",          "&amp;",      "&#9;",      "\"",
      "'",         "--",   "<!-- -->",   "<![CDATA[<", "]]>",       "<?pi?>",
      "\xC3\xA4",  "\x01", "${'<'}",     "${'&'}",     "${chr(7)}", "${'\"'}",
      "$(arg a)",  "${a}", "<a x='1'/>", "</robot>",   "<b>",       "</b>",
      " y='${a}'", "=",    "/",          "\t",         "\r\n",      "\xEF\xBB\xBF"};
  const std::string text =
      std::string(kHead) +
      "<xacro:arg name=\"a\" default=\"1\"/><xacro:property name=\"a\" value=\"2\"/>\n"
      "<link name=\"l\"><!-- c --><v>text</v></link>\n</robot>\n";
  std::mt19937 random(5);
  std::size_t without_faults = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string written = text;
    for (std::size_t count = 1 + random() % 2; count > 0; --count)
      written.insert(random() % (written.size() + 1), pieces[random() % pieces.size()]);
    MemoryDisk disk({{"r.xacro", written}});
    Sources sources;
    const Resolver resolver(disk, {});
    Workspace workspace(resolver, sources);
    const File& file = workspace.open("r.xacro");
    if (!file.document) continue;
    const xml::Document judged = xml::parse(file.document->bytes(), file.source);
    EXPECT_EQ(judged.complete(), file.document->complete()) << file.document->bytes();
    EXPECT_EQ(judged.faults().size(), file.document->faults().size()) << file.document->bytes();
    without_faults += judged.faults().empty() && file.document->root() ? 1 : 0;
  }
  EXPECT_GT(without_faults, 400U);
}

TEST(InstalledPath, ReadsFoldersOfInstall) {
  const std::vector<InstalledFolder> expected{
      {"description/urdf", "urdf"}, {"config", "config"}, {"description", "robot"}};
  EXPECT_EQ(installed_folders("project(demo)  # install(DIRECTORY no DESTINATION share/x\n"
                              "install(DIRECTORY description/urdf config\n"
                              "  DESTINATION share/${PROJECT_NAME})\n"
                              "install(DIRECTORY description/ DESTINATION "
                              "\"share/${PROJECT_NAME}/robot\" PATTERN \"*.md\" EXCLUDE)\n"
                              "install(TARGETS demo DESTINATION lib)\n"
                              "install(DIRECTORY include/ DESTINATION include)\n"),
            expected);
}

TEST(InstalledPath, FindsAFileWhereItComesFrom) {
  const MemoryDisk disk(
      {{"/ws/demo/package.xml", "<package/>"},
       {"/ws/demo/CMakeLists.txt", "install(DIRECTORY description/urdf DESTINATION share/demo)"},
       {"/ws/demo/description/urdf/arm/a.xacro", "<robot/>"}});
  EXPECT_EQ(source_of_installed(disk, "/ws/demo/urdf/arm/a.xacro"),
            "/ws/demo/description/urdf/arm/a.xacro");
  EXPECT_EQ(source_of_installed(disk, "/ws/demo/urdf/arm/b.xacro"), std::nullopt);
  EXPECT_EQ(source_of_installed(disk, "/elsewhere/a.xacro"), std::nullopt);
}

TEST(ArgumentSets, HaveEveryValueThatAConditionNames) {
  MemoryDisk disk(
      {{"r.xacro", std::string(kHead) + "<xacro:arg name=\"sim\" default=\"false\"/>\n"
                                        "<xacro:arg name=\"tool\" default=\"none\"/>\n"
                                        "<xacro:property name=\"tool\" value=\"$(arg tool)\"/>\n"
                                        "<xacro:if value=\"$(arg sim)\"/>\n"
                                        "<xacro:if value=\"${tool == 'hand'}\"/>\n"
                                        "<xacro:if value=\"${tool in ['none', 'saw']}\"/>\n"
                                        "</robot>\n"}});
  Sources sources;
  const Resolver resolver(disk, {});
  Workspace workspace(resolver, sources);
  const ArgumentPlan plan =
      all_arguments(workspace.open("r.xacro").expanded->expansion(), sources, disk, {});
  const std::vector<TemplateArguments> expected{
      {{"sim", "true"}}, {{"tool", "hand"}}, {{"tool", "saw"}}};
  EXPECT_EQ(plan.sets, expected);
  EXPECT_EQ(shown_arguments({{"a", "1"}, {"b", "x"}}), "a:=1 b:=x");
}

TEST(ArgumentSets, FollowArgumentsThroughParametersOfMacros) {
  MemoryDisk disk(
      {{"r.xacro",
        std::string(kHead) +
            "<xacro:arg name=\"hand\" default=\"none\"/>\n"
            "<xacro:arg name=\"sim\" default=\"0\"/>\n"
            "<xacro:arg name=\"label\" default=\"arm\"/>\n"
            "<xacro:arg name=\"other\" default=\"x\"/>\n"
            "<xacro:property name=\"chosen\" value=\"$(arg hand)\"/>\n"
            "<xacro:property name=\"is_saw\" value=\"${chosen == 'saw'}\"/>\n"
            "<xacro:macro name=\"tool\" params=\"type simulated label\">\n"
            "<xacro:if value=\"${type == 'claw'}\"/><xacro:if value=\"${simulated}\"/>\n"
            "<xacro:if value=\"${label}\"/></xacro:macro>\n"
            "<xacro:macro name=\"arm\" params=\"kind simulated:=$(arg sim) label:=^\">\n"
            "<xacro:tool type=\"${kind}\" simulated=\"${simulated}\" label=\"${label}\"/>\n"
            "</xacro:macro>\n"
            "<xacro:macro name=\"leg\" params=\"type\"><xacro:if value=\"${type == 'long'}\"/>\n"
            "</xacro:macro>\n"
            "<xacro:property name=\"label\" value=\"$(arg label)\"/>\n"
            "<xacro:arm kind=\"${ chosen }\"/><xacro:leg type=\"short\"/>\n"
            "<link name=\"$(arg other)${is_saw}\"/></robot>\n"}});
  Sources sources;
  const Resolver resolver(disk, {});
  Workspace workspace(resolver, sources);
  const ArgumentPlan plan =
      all_arguments(workspace.open("r.xacro").expanded->expansion(), sources, disk, {});
  // The leg's own parameter of the same name has no argument; a label is no truth value.
  const std::vector<TemplateArguments> expected{
      {{"hand", "claw"}}, {{"hand", "saw"}}, {{"sim", "false"}}, {{"sim", "true"}}};
  EXPECT_EQ(plan.sets, expected);
}

TEST(ArgumentSets, HaveTheEntriesOfAFolderThatAnArgumentNames) {
  MemoryDisk disk(
      {{"arm/r.xacro",
        std::string(kHead) +
            "<xacro:arg name=\"model\" default=\"a3\"/>\n"
            "<xacro:arg name=\"tool\" default=\"hand\"/>\n"
            "<xacro:property name=\"tool\" value=\"$(arg tool)\"/>\n"
            "<xacro:property name=\"limits\" value=\"config/$(arg model)/limits.yaml\"/>\n"
            "<xacro:property name=\"cfg\" value=\"${xacro.load_yaml(limits)}\"/>\n"
            "<xacro:include filename=\"tools/${tool}.xacro\"/>\n"
            "<link name=\"l${cfg['m']}\"/></robot>\n"},
       {"arm/config/a3/limits.yaml", "m: 1\n"},
       {"arm/config/a5/limits.yaml", "m: 2\n"},
       {"arm/config/old/notes.txt", ""},
       {"arm/tools/hand.xacro", std::string(kHead) + "</robot>"},
       {"arm/tools/saw.xacro", std::string(kHead) + "</robot>"},
       {"arm/tools/README.md", ""}});
  Sources sources;
  const Resolver resolver(disk, {});
  Workspace workspace(resolver, sources);
  const ArgumentPlan plan =
      all_arguments(workspace.open("arm/r.xacro").expanded->expansion(), sources, disk, {});
  const std::vector<TemplateArguments> expected{{{"model", "a5"}}, {{"tool", "saw"}}};
  EXPECT_EQ(plan.sets, expected);
  EXPECT_TRUE(plan.left_out.empty());
}

TEST(ArgumentSets, ArePairedWhereTheyWouldBeTooMany) {
  std::string text = kHead;
  for (int argument = 0; argument < 3; ++argument) {
    const std::string name = "a" + std::to_string(argument);
    text += "<xacro:arg name=\"" + name + "\" default=\"none\"/>\n<xacro:property name=\"" + name +
            "\" value=\"$(arg " + name + ")\"/>\n";
    for (int value = 0; value < 20; ++value)
      text += "<xacro:if value=\"${" + name + " == 'v" + std::to_string(value) + "'}\"/>\n";
  }
  MemoryDisk disk({{"r.xacro", text + "</robot>\n"}});
  Sources sources;
  const Resolver resolver(disk, {});
  Workspace workspace(resolver, sources);
  const ArgumentPlan plan =
      all_arguments(workspace.open("r.xacro").expanded->expansion(), sources, disk, {});
  ASSERT_EQ(plan.sets.size(), 20);
  std::set<std::pair<std::string, std::string>> seen;
  for (const TemplateArguments& set : plan.sets) seen.insert(set.begin(), set.end());
  EXPECT_EQ(seen.size(), 60) << "every value of every argument";
  EXPECT_TRUE(plan.left_out.empty());
}

}  // namespace
}  // namespace rigor::read
