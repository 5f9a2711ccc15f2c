// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The quick reader of YAML against yaml-cpp: a file that it reads, and the same with a line behind it that
// only yaml-cpp reads, must give the same values at the same places.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <rigor/xacro/plain_yaml.h>

#include "xacro/expanded.h"

namespace rigor::test {
namespace {

constexpr const char* kPlainFile =
    "# limits of the arm, in °\n"
    "---\n"
    "arm:\n"
    "  # the first joint\n"
    "  mass: 1.50   # kg\n"
    "  reach: !millimeters  250*2\n"
    "  max: !degrees -360.0\n"
    "  name: left arm #1\n"
    "  file: \"package://arm/meshes/a b.dae\"   # quoted\n"
    "  color: '0.7 0.7 0.7 1.0'\n"
    "\n"
    "  link:\n"
    "      frame: $(arg prefix)base\n"
    "      octal: 010\n"
    "      flag: yes\n"
    "      # nothing here\n"
    "      none:   # nor here\n"
    "      nothing:\n"
    "\n"
    "  finger: &finger  # of both hands\n"
    "    length: 0.1\n"
    "  other: *finger\n"
    "  third: &finger\n"
    "    length: 0.3\n"
    "  fourth: *finger   # the last one\n"
    "count: 0x1f\n"
    "empty_text: \"\"\n";

TEST(XacroPlainYaml, ReadsWhatYamlCppReads) {
  const std::string plain = kPlainFile;
  ASSERT_TRUE(xacro::read_plain_yaml(plain));
  EXPECT_FALSE(xacro::read_plain_yaml(plain + "last: [1]\n"));
  const std::string use = robot(
      "<xacro:property name=\"cfg\" value=\"${xacro.load_yaml('arm.yaml')}\"/>\n"
      "<v all=\"${cfg['arm']}\" mass=\"${cfg.arm.mass}\" reach=\"${cfg.arm.reach}\" "
      "file=\"${cfg.arm.file}\" color=\"${cfg.arm.color}\" max=\"${cfg.arm.max}\" "
      "frame=\"${cfg.arm.link.frame}\" octal=\"${cfg.arm.link.octal}\" count=\"${cfg.count}\" "
      "empty=\"${cfg.empty_text}\" link=\"${cfg.arm.link}\" none=\"${cfg.arm.link.none}\" "
      "nothing=\"${cfg.arm.link.nothing}\" length=\"${cfg.arm.fourth.length}\" "
      "other=\"${cfg.arm.other}\" fourth=\"${cfg.arm.fourth}\"/>");
  const Expanded own(use, {{"arm.yaml", plain}});
  const Expanded theirs(use, {{"arm.yaml", plain + "last: [1]\n"}});
  ASSERT_TRUE(own.expansion.ok() && theirs.expansion.ok());
  EXPECT_EQ(own.text(), theirs.text());
  const auto& mine = own.expansion.root->first_element()->attributes;
  const auto& other = theirs.expansion.root->first_element()->attributes;
  ASSERT_EQ(mine.size(), other.size());
  for (std::size_t i = 0; i < mine.size(); ++i) {
    EXPECT_EQ(mine[i].from.begin, other[i].from.begin) << mine[i].name;
    EXPECT_EQ(mine[i].from.end, other[i].from.end) << mine[i].name;
  }
}

TEST(XacroPlainYaml, LeavesTheRestToYamlCpp) {
  for (const char* text : {"",
                           "# nothing\n",
                           "a:\n",
                           "a: 1\n b: 2\n",
                           "a: b\n  c\n",
                           "- a\n",
                           "a: [1]\n",
                           "a: {b: 1}\n",
                           "a: &x 1\n",
                           "a: *x\n",
                           "a: &x\nb: 1\n",
                           "a: &x b\n",
                           "a: &\n  b: 1\n",
                           "a: &x!\n  b: 1\n",
                           "a: &x\n  b: 1\nc: *x d\n",
                           "a: &x\n  b: 1\nc: *x*\n",
                           "a: &x\n  b: 1\nc: *\n",
                           "a: |\n  b\n",
                           "a: \"b\\n\"\n",
                           "a: 'it''s'\n",
                           "a: b: c\n",
                           "a: ~\n",
                           "a: \tb\n",
                           "a:b\n",
                           "? a\n",
                           "a: 1\n---\nb: 2\n",
                           "a: 1\r\n",
                           "<<: 1\n",
                           "a: \"b\" c\n",
                           "a:\n  b: 1\n c: 2\n",
                           "%YAML 1.1\n",
                           "null: 1\n",
                           "a: - b\n",
                           "a: ? b\n",
                           "a: !x\n",
                           "a: é\n"}) {
    EXPECT_FALSE(xacro::read_plain_yaml(text)) << text;
  }
}

TEST(XacroPlainYaml, GivesTheEventsOfNestedDictionaries) {
  const auto events = xacro::read_plain_yaml("a:\n  b: 1\nc: x");
  ASSERT_TRUE(events);
  using Kind = xacro::PlainYamlEvent::Kind;
  std::vector<Kind> kinds;
  for (const auto& event : *events) kinds.push_back(event.kind);
  EXPECT_EQ(kinds, (std::vector<Kind>{Kind::kMapStart, Kind::kScalar, Kind::kMapStart,
                                      Kind::kScalar, Kind::kScalar, Kind::kMapEnd, Kind::kScalar,
                                      Kind::kScalar, Kind::kMapEnd}));
}

}  // namespace
}  // namespace rigor::test
