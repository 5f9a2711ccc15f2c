// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/session/session.h>

#include <gtest/gtest.h>

#include <rigor/lsp/session/message_queue.h>

#include "lsp/editor.h"

namespace rigor::lsp {
namespace {

using test::Editor;

constexpr const char* kTwoLinks =
    "<robot name='r'>\n"
    "  <link name='a'/>\n"
    "  <link name='b'/>\n"
    "  <joint name='j' type='revolute'>\n"
    "    <parent link='a'/>\n"
    "    <child link='bb'/>\n"
    "    <axis xyz='0 0 1'/>\n"
    "    <limit lower='1' upper='-1' effort='1' velocity='1'/>\n"
    "  </joint>\n"
    "</robot>\n";

bool has(const std::vector<std::string>& list, const std::string& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

TEST(LspSession, ItsLifeIsThatOfTheProtocol) {
  MemoryDisk disk;
  std::vector<Json> sent;
  Session session(disk, {}, {.send = [&sent](const Json& message) { sent.push_back(message); }});
  session.receive({{"jsonrpc", "2.0"}, {"id", 1}, {"method", "textDocument/hover"}});
  EXPECT_EQ(sent.back()["error"]["code"], -32002);
  session.receive(
      {{"jsonrpc", "2.0"}, {"id", 2}, {"method", "initialize"}, {"params", Json::object()}});
  EXPECT_EQ(sent.back()["result"]["capabilities"]["positionEncoding"], "utf-16");
  session.receive({{"jsonrpc", "2.0"}, {"id", "x"}, {"method", "no/such"}});
  EXPECT_EQ(sent.back()["error"]["code"], -32601);
  EXPECT_EQ(sent.back()["id"], "x");
  const std::size_t answers = sent.size();
  session.receive({{"jsonrpc", "2.0"}, {"method", "$/unknown"}});
  EXPECT_EQ(sent.size(), answers);
  session.receive(parsed_json("{\"no json"));
  EXPECT_EQ(sent.back()["error"]["code"], -32700);
  session.receive(Json::array({1}));
  EXPECT_EQ(sent.back()["error"]["code"], -32600);
  session.receive({{"jsonrpc", "2.0"}, {"id", 3}, {"method", "initialize"}});
  EXPECT_EQ(sent.back()["error"]["code"], -32600);
  EXPECT_EQ(session.exit_code(), std::nullopt);
  session.receive({{"jsonrpc", "2.0"}, {"id", 4}, {"method", "shutdown"}});
  EXPECT_TRUE(sent.back()["result"].is_null());
  session.receive({{"jsonrpc", "2.0"}, {"id", 5}, {"method", "textDocument/hover"}});
  EXPECT_EQ(sent.back()["error"]["code"], -32600);
  session.receive({{"jsonrpc", "2.0"}, {"method", "exit"}});
  EXPECT_EQ(session.exit_code(), 0);

  Session abandoned(disk, {}, {.send = [](const Json&) {}});
  abandoned.receive({{"jsonrpc", "2.0"}, {"method", "exit"}});
  EXPECT_EQ(abandoned.exit_code(), 1);
}

TEST(LspSession, FindingsAreThoseOfTheCommandLine) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf", kTwoLinks);
  Sources sources;
  MemoryDisk same(test::Files{{"/ws/r.urdf", kTwoLinks}});
  const Environment environment(same, {});
  const auto result = rules::validate(
      environment, {.paths = {"/ws/r.urdf"}, .meshes = rules::MeshPolicy::kLeaveOut}, sources);
  std::vector<std::string> expected;
  for (const Diagnostic& each : result.diagnostics.list()) expected.emplace_back(each.rule);
  EXPECT_EQ(editor.rules("/ws/r.urdf"), expected);
  EXPECT_TRUE(has(expected, "joint-child-missing"));
  const Json& first = editor.diagnostics("/ws/r.urdf");
  const auto limit = std::find_if(first.begin(), first.end(), [](const Json& each) {
    return each["code"] == "joint-limit-inverted";
  });
  ASSERT_NE(limit, first.end());
  EXPECT_EQ((*limit)["range"]["start"]["line"], 7);
}

TEST(LspSession, ChangesAreAppliedInTheirOrderInUtf16) {
  MemoryDisk disk;
  Editor editor(disk, Json::object());  // UTF-16
  editor.open("/ws/r.urdf", "<robot name='\xF0\x9F\x98\x80'>\n<link name='a'/></robot>");
  const Json insert{
      {"range",
       {{"start", {{"line", 0}, {"character", 15}}}, {"end", {{"line", 0}, {"character", 15}}}}},
      {"text", "x"}};
  const Json remove{
      {"range",
       {{"start", {{"line", 1}, {"character", 0}}}, {"end", {{"line", 1}, {"character", 16}}}}},
      {"text", ""}};
  editor.notify("textDocument/didChange",
                {{"textDocument", {{"uri", "file:///ws/r.urdf"}, {"version", 2}}},
                 {"contentChanges", {insert, remove}}});
  editor.work();
  const Json symbols = editor.request("textDocument/documentSymbol", editor.document("/ws/r.urdf"));
  EXPECT_EQ(symbols[0]["name"], "\xF0\x9F\x98\x80x");
  EXPECT_FALSE(symbols[0].contains("children"));
}

TEST(LspSession, AClosedDocumentHasNoFindings) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf", kTwoLinks);
  EXPECT_FALSE(editor.diagnostics("/ws/r.urdf").empty());
  editor.notify("textDocument/didClose", editor.document("/ws/r.urdf"));
  EXPECT_TRUE(editor.diagnostics("/ws/r.urdf").empty());
}

TEST(LspSession, OpenFilesShadowTheDisk) {
  MemoryDisk disk(test::Files{
      {"/ws/arm.xacro",
       "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:macro name='arm' params=''>"
       "<link name='a'/></xacro:macro></robot>"}});
  Editor editor(disk);
  const std::string robot =
      "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n<xacro:include "
      "filename='arm.xacro'/>\n"
      "<xacro:arm/>\n</robot>";
  editor.open("/ws/r.urdf.xacro", robot);
  EXPECT_FALSE(has(editor.rules("/ws/r.urdf.xacro"), "xacro-undefined-macro"));
  editor.open(
      "/ws/arm.xacro",
      "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:macro name='leg' params=''>"
      "<link name='a'/></xacro:macro></robot>");
  EXPECT_TRUE(has(editor.rules("/ws/r.urdf.xacro"), "xacro-undefined-macro"))
      << editor.diagnostics("/ws/r.urdf.xacro").dump(1);
}

TEST(LspSession, AFileThatIsOnlyInTheEditorIsFound) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open(
      "/ws/w.sdf",
      "<sdf version='1.9'><world name='w'><include><uri>box.sdf</uri></include></world></sdf>");
  EXPECT_TRUE(has(editor.rules("/ws/w.sdf"), "include-not-found"));
  editor.open("/ws/box.sdf", "<sdf version='1.9'><model name='box'><link name='a'/></model></sdf>");
  EXPECT_FALSE(has(editor.rules("/ws/w.sdf"), "include-not-found"));
}

TEST(LspSession, SettingsAreThoseOfTheNearestConfiguration) {
  MemoryDisk disk(test::Files{{"/ws/rigor.toml", "ignore = [\"joint-limit-inverted\"]\n"}});
  Editor editor(disk);
  editor.open("/ws/r.urdf", kTwoLinks);
  EXPECT_FALSE(has(editor.rules("/ws/r.urdf"), "joint-limit-inverted"));
  EXPECT_TRUE(has(editor.rules("/ws/r.urdf"), "joint-child-missing"));
  editor.open("/ws/rigor.toml", "ignore = [\"joint-child-missing\"]\nno-such-key = 1\n");
  EXPECT_TRUE(has(editor.rules("/ws/r.urdf"), "joint-limit-inverted"));
  EXPECT_FALSE(has(editor.rules("/ws/r.urdf"), "joint-child-missing"));
  ASSERT_EQ(editor.diagnostics("/ws/rigor.toml").size(), 1U);
  EXPECT_EQ(editor.diagnostics("/ws/rigor.toml")[0]["range"]["start"]["line"], 1);
}

TEST(LspSession, StaleFindingsAreNotPublished) {
  MemoryDisk disk;
  std::vector<Json> sent;
  Session session(disk, {},
                  {.send = [&sent](const Json& message) { sent.push_back(message); },
                   .is_superseded = [](const std::string&) { return true; }});
  session.receive({{"id", 1}, {"method", "initialize"}, {"params", Json::object()}});
  session.receive(
      {{"method", "textDocument/didOpen"},
       {"params",
        {{"textDocument", {{"uri", "file:///r.urdf"}, {"version", 1}, {"text", kTwoLinks}}}}}});
  while (session.has_work()) session.work();
  EXPECT_EQ(sent.size(), 1U);
}

TEST(LspSession, OfManyPlacesOfOneCauseTheFirstHundredAreShown) {
  std::string text = "<robot name='r'>";
  for (int i = 0; i < 250; ++i) text += "<link name='l" + std::to_string(i) + "'/>";
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf", text + "</robot>");
  std::map<std::string, int> times;
  for (const std::string& rule : editor.rules("/ws/r.urdf")) ++times[rule];
  int most = 0;
  for (const auto& [rule, count] : times) most = std::max(most, count);
  EXPECT_EQ(most, 100);
  EXPECT_NE(editor.diagnostics("/ws/r.urdf").dump().find("and 149 more places like this one"),
            std::string::npos);
}

TEST(LspSession, WhatIsAsItWasIsNotPublishedAgain) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf", kTwoLinks);
  const std::size_t sent = editor.log().size();
  editor.notify("workspace/didChangeWatchedFiles", {{"changes", Json::array()}});
  editor.work();
  EXPECT_EQ(editor.log().size(), sent);
}

TEST(LspSession, DiagnosticsCanBePulled) {
  MemoryDisk disk;
  Editor editor(disk);
  editor.open("/ws/r.urdf", kTwoLinks);
  const Json report = editor.request("textDocument/diagnostic", editor.document("/ws/r.urdf"));
  EXPECT_EQ(report["kind"], "full");
  EXPECT_EQ(report["items"], editor.diagnostics("/ws/r.urdf"));
}

TEST(LspMessageQueue, CancelledRequestsAreMarkedAndChangesSeen) {
  MessageQueue queue;
  queue.put({{"id", 7}, {"method", "textDocument/hover"}});
  queue.put({{"method", "textDocument/didChange"}, {"params", {{"textDocument", {{"uri", "u"}}}}}});
  queue.put({{"method", "$/cancelRequest"}, {"params", {{"id", 7}}}});
  EXPECT_TRUE(queue.is_superseded("u"));
  EXPECT_FALSE(queue.is_superseded("v"));
  EXPECT_EQ((*queue.take())["id"], 7);
  EXPECT_TRUE(queue.is_cancelled(7));
  EXPECT_FALSE(queue.is_cancelled(7));
  EXPECT_TRUE(queue.take().has_value());
  EXPECT_FALSE(queue.is_superseded("u"));
  queue.close();
  EXPECT_EQ(queue.wait(), std::nullopt);
}

}  // namespace
}  // namespace rigor::lsp
