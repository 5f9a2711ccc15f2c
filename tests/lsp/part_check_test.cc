// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// In a large document a key shows at once what it changes in its part, and then what a fresh run over the text shows.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <rigor/lsp/project/part_check.h>

#include "lsp/editor.h"

namespace rigor::lsp {
namespace {

using test::Editor;

constexpr const char* kLargePath = "/ws/r.urdf";

/// A chain of links with boxes; the last joint has its limits the wrong way round.
std::string large_chain() {
  std::string text = "<robot name='r'>\n";
  for (int i = 0; i < 400; ++i) {
    const std::string n = std::to_string(i);
    text += "  <link name='l" + n +
            "'>\n    <inertial><mass value='600'/><inertia ixx='100' iyy='100' izz='100' ixy='0' "
            "ixz='0' "
            "iyz='0'/></inertial>\n    <collision><geometry><box size='1 1 "
            "1'/></geometry></collision>\n"
            "  </link>\n";
  }
  for (int i = 1; i < 400; ++i) {
    text += "  <joint name='j" + std::to_string(i) + "' type='revolute'><parent link='l" +
            std::to_string(i - 1) + "'/><child link='l" + std::to_string(i) +
            "'/><origin xyz='0 0 1'/><axis xyz='0 0 1'/><limit lower='" + (i == 399 ? "2" : "-1") +
            "' upper='1' effort='1e5' velocity='1'/></joint>\n";
  }
  return text + "</robot>\n";
}

std::string with_replaced(std::string text, const std::string& old, const std::string& now) {
  return text.replace(text.find(old), old.size(), now);
}

bool shows(const std::vector<std::string>& rules, const std::string& rule) {
  return std::find(rules.begin(), rules.end(), rule) != rules.end();
}

Json fresh_large(const Disk& disk, const std::string& text) {
  Editor editor(disk);
  editor.open(kLargePath, text);
  return editor.diagnostics(kLargePath);
}

class LspPartCheck : public ::testing::Test {
 protected:
  LspPartCheck() : editor(disk), text(large_chain()) {
    editor.open(kLargePath, text);
    EXPECT_GE(text.size(), PartCheck::kLargeBytes);
  }

  /// What is shown before the whole is checked.
  std::vector<std::string> type(const std::string& now) {
    text = now;
    editor.type(kLargePath, text);
    editor.work_on_keys();
    return editor.rules(kLargePath);
  }

  MemoryDisk disk{test::Files{}};
  Editor editor;
  std::string text;
};

TEST_F(LspPartCheck, AnElementIsCheckedAtOnceAndTheRestIsWhereItMovedTo) {
  const std::vector<std::string> before = editor.rules(kLargePath);
  ASSERT_TRUE(shows(before, "joint-limit-inverted"));
  const auto line_of = [&] {
    for (const Json& each : editor.diagnostics(kLargePath)) {
      if (text_at(each, "code") == "joint-limit-inverted")
        return each["range"]["start"]["line"].get<int>();
    }
    return -1;
  };
  const int line = line_of();
  const auto rules = type(with_replaced(text, "mass value='600'", "mass\n value='-600'"));
  EXPECT_TRUE(shows(rules, "mass-negative")) << editor.diagnostics(kLargePath).dump();
  EXPECT_TRUE(shows(rules, "joint-limit-inverted"));
  EXPECT_EQ(line_of(), line + 1);
  EXPECT_TRUE(editor.session().wants_whole_check());
  editor.work();
  EXPECT_EQ(editor.diagnostics(kLargePath), fresh_large(disk, text));
  EXPECT_FALSE(editor.session().wants_whole_check());
}

TEST_F(LspPartCheck, WhatTakesALookAtTheWholeWaitsForIt) {
  const std::vector<std::string> before = editor.rules(kLargePath);
  EXPECT_EQ(type(with_replaced(text, "parent link='l7'", "parent link='l7x'")), before);
  editor.work();
  const Json whole = fresh_large(disk, text);
  EXPECT_EQ(editor.diagnostics(kLargePath), whole);
  EXPECT_NE(whole.dump().find("l7x"), std::string::npos);
}

TEST_F(LspPartCheck, BrokenXmlIsShownAtOnceAndGoneWithTheKeyThatMendsIt) {
  const std::string whole = text;
  const auto broken = type(with_replaced(text, "<mass value='600'/>", "<mass value='600/>"));
  EXPECT_TRUE(std::any_of(broken.begin(), broken.end(),
                          [](const std::string& rule) { return rule.starts_with("xml-"); }));
  editor.work();
  EXPECT_EQ(editor.diagnostics(kLargePath), fresh_large(disk, text));
  EXPECT_TRUE(shows(type(whole), "joint-limit-inverted"));
  EXPECT_EQ(editor.diagnostics(kLargePath), fresh_large(disk, whole));
}

TEST_F(LspPartCheck, ACheckThatAKeyStoppedIsDoneAgain) {
  type(with_replaced(text, "mass value='600'", "mass value='-600'"));
  const auto check = editor.session().take_whole_check();
  ASSERT_NE(check, nullptr);
  check->stop();
  check->run();
  editor.session().finish(*check);
  editor.work_on_keys();
  EXPECT_TRUE(editor.session().wants_whole_check());
  // An answer that comes too late is of no use either.
  const auto late = editor.session().take_whole_check();
  late->run();
  type(with_replaced(text, "mass value='-600'", "mass value='601'"));
  editor.session().finish(*late);
  editor.work();
  EXPECT_EQ(editor.diagnostics(kLargePath), fresh_large(disk, text));
}

TEST_F(LspPartCheck, AChangeOfTwoPartsIsCheckedAsAWhole) {
  const std::string both = with_replaced(
      with_replaced(text, "mass value='600'", "mass value='-600'"), "name='j399'", "name='last'");
  type(both);
  EXPECT_FALSE(editor.session().wants_whole_check());
  EXPECT_EQ(editor.diagnostics(kLargePath), fresh_large(disk, text));
}

TEST_F(LspPartCheck, AKeyElsewhereIsSeenAgainstTheCheckBeforeIt) {
  const std::string first = with_replaced(text, "mass value='600'", "mass value='-600'");
  type(first);
  const auto rules =
      type(with_replaced(first, "name='j399' type='revolute'", "name='j399' type='turning'"));
  EXPECT_TRUE(editor.session().wants_whole_check());
  EXPECT_TRUE(shows(rules, "mass-negative"));
  EXPECT_TRUE(shows(rules, "joint-limit-inverted")) << editor.diagnostics(kLargePath).dump();
  editor.work();
  EXPECT_EQ(editor.diagnostics(kLargePath), fresh_large(disk, text));
}

class LspTemplateCheck : public ::testing::Test {
 protected:
  static constexpr const char* kPath = "/ws/r.urdf.xacro";

  LspTemplateCheck() : editor(disk) {
    editor.session().set_large(1);
    type(
        "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n"
        "<xacro:property name='low' value='2'/>\n"
        "<link name='a'/>\n<link name='b'/>\n"
        "<joint name='j' type='revolute'><parent link='a'/><child link='b'/>\n"
        "<axis xyz='0 0 1'/>\n"
        "<limit lower='${low}' upper='1' effort='1' velocity='1'/></joint>\n</robot>\n");
    editor.work();
  }

  std::vector<std::string> type(const std::string& now) {
    const bool is_open = !text.empty();
    text = now;
    if (!is_open) editor.open(kPath, text);
    editor.type(kPath, text);
    editor.work_on_keys();
    return editor.rules(kPath);
  }
  Json fresh() {
    Editor other(disk);
    other.open(kPath, text);
    return other.diagnostics(kPath);
  }

  MemoryDisk disk{test::Files{}};
  Editor editor;
  std::string text;
};

TEST_F(LspTemplateCheck, WhatExpandingShowsIsNewAndTheModelsFindingsMove) {
  ASSERT_TRUE(shows(editor.rules(kPath), "joint-limit-inverted"));
  const auto moved =
      type(with_replaced(text, "<link name='a'/>", "<!-- two\nlines -->\n<link name='a'/>"));
  EXPECT_TRUE(shows(moved, "joint-limit-inverted"));
  EXPECT_EQ(editor.diagnostics(kPath), fresh());
  EXPECT_TRUE(editor.session().wants_whole_check());
  editor.work();
  EXPECT_EQ(editor.diagnostics(kPath), fresh());
}

TEST_F(LspTemplateCheck, WhatTheModelShowsComesWithTheWhole) {
  const auto at_once = type(with_replaced(text, "child link='b'", "child link='c'"));
  EXPECT_FALSE(shows(at_once, "undefined-reference"));
  editor.work();
  EXPECT_EQ(editor.diagnostics(kPath), fresh());
  EXPECT_NE(fresh().dump().find("'c'"), std::string::npos);
}

TEST_F(LspTemplateCheck, ATemplateThatCannotBeExpandedIsShownAtOnce) {
  const std::string whole = text;
  type(with_replaced(text, "${low}", "${lw}"));
  EXPECT_EQ(editor.diagnostics(kPath), fresh());
  EXPECT_NE(fresh().dump().find("lw"), std::string::npos);
  EXPECT_TRUE(shows(type(whole), "joint-limit-inverted"));
  editor.work();
  EXPECT_EQ(editor.diagnostics(kPath), fresh());
}

TEST_F(LspPartCheck, AClientThatOnlyPullsGetsTheWhole) {
  Json capabilities = Editor::default_capabilities();
  capabilities["textDocument"]["diagnostic"] = Json::object();
  Editor pulling(disk, capabilities);
  pulling.open(kLargePath, large_chain());
  const std::string now = with_replaced(large_chain(), "parent link='l7'", "parent link='l7x'");
  pulling.type(kLargePath, now);
  const Json report = pulling.request("textDocument/diagnostic", pulling.document(kLargePath));
  EXPECT_EQ(report["items"], fresh_large(disk, now));
}

}  // namespace
}  // namespace rigor::lsp
