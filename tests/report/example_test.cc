// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/example.h>

#include <stdexcept>

#include <gtest/gtest.h>

#include <rigor/report/rules/explain.h>

namespace rigor::rules {
namespace {

using Marked = std::vector<ParsedExample::Marked>;

TEST(ParseExample, TakesMarksOut) {
  const ParsedExample example = parse_example("<sdf><a>«0 0 0»</a><b>«»</b></sdf>\n");
  ASSERT_EQ(example.files.size(), 1U);
  EXPECT_EQ(example.files[0].path, "model.sdf");
  EXPECT_EQ(example.files[0].bytes, "<sdf><a>0 0 0</a><b></b></sdf>\n");
  EXPECT_EQ(example.marked, (Marked{{8, 13}, {20, 20}}));
  EXPECT_EQ(example_path(example.files[0]), "demo/model.sdf");
}

TEST(ParseExample, MarksMayNest) {
  const ParsedExample example = parse_example("«a«b»c»");
  EXPECT_EQ(example.files[0].bytes, "abc");
  EXPECT_EQ(example.marked, (Marked{{0, 3}, {1, 2}}));
}

TEST(ParseExample, NamesTheFileByItsRoot) {
  const auto name = [](std::string_view text) { return parse_example(text).files[0].path; };
  EXPECT_EQ(name("<?xml version=\"1.0\"?>\n<!-- <sdf> --><robot name=\"r\"/>"), "robot.urdf");
  EXPECT_EQ(name("<model><sdf>a</sdf></model>"), "model.config");
  EXPECT_EQ(name("<sdf version=\"1.9\"><model/></sdf>"), "model.sdf");
  EXPECT_EQ(name("«<robot»>"), "robot.urdf");
  EXPECT_EQ(name("no markup"), "model.sdf");
}

TEST(ParseExample, FurtherFiles) {
  const ParsedExample example =
      parse_example("<sdf/>\n=== meshes/wheel.stl\nsolid w\nendsolid\n=== empty.txt\n");
  ASSERT_EQ(example.files.size(), 3U);
  EXPECT_EQ(example.files[0].bytes, "<sdf/>\n");
  EXPECT_EQ(example.files[1].path, "meshes/wheel.stl");
  EXPECT_EQ(example.files[1].bytes, "solid w\nendsolid\n");
  EXPECT_EQ(example.files[2].path, "empty.txt");
  EXPECT_EQ(example.files[2].bytes, "");
}

TEST(ParseExample, MarksMustPair) {
  EXPECT_THROW(parse_example("«a"), std::logic_error);
  EXPECT_THROW(parse_example("a»"), std::logic_error);
}

TEST(Explain, ShowsTheWholePage) {
  Rule rule;
  rule.name = "axis-zero";
  rule.category = Category::kKinematics;
  rule.severity = Severity::kError;
  rule.formats = Formats::kSdf;
  rule.fix = FixGrade::kUnsafe;
  rule.summary = "a joint axis is the zero vector";
  rule.why = "It has no\ndirection.";
  rule.what_to_do = "Give it one.";
  const Examples examples{
      .bad = {{"<sdf>\n  <xyz>«0 0 0»</xyz>\n</sdf>\n", "<sdf>\n  <xyz>0 0 1</xyz>\n</sdf>\n"}},
      .good = {{"<robot/>\n=== a.txt\ntext\n"}}};
  EXPECT_EQ(report::explain(rule, examples),
            "axis-zero: a joint axis is the zero vector\n"
            "\n"
            "  severity error, category kinematics, formats sdf, fix unsafe, since 0.1.0\n"
            "\n"
            "Why\n"
            "  It has no direction.\n"
            "\n"
            "What to do\n"
            "  Give it one.\n"
            "\n"
            "Bad: model.sdf\n"
            "\n"
            "    <sdf>\n"
            "      <xyz>0 0 0</xyz>\n"
            "           ^^^^^\n"
            "    </sdf>\n"
            "\n"
            "Fixed: model.sdf\n"
            "\n"
            "    <sdf>\n"
            "      <xyz>0 0 1</xyz>\n"
            "    </sdf>\n"
            "\n"
            "Good: robot.urdf\n"
            "\n"
            "    <robot/>\n"
            "\n"
            "  with a.txt\n"
            "\n"
            "    text\n");
}

}  // namespace
}  // namespace rigor::rules
