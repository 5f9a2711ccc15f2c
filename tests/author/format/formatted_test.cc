// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/format/formatted.h>

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/format/same_content.h>
#include <rigor/rules/environment.h>
#include <rigor/text/disk.h>
#include <rigor/xml/document.h>

#include "support/corpus.h"

namespace rigor::author {
namespace {

Formatted formatted_of(std::string_view bytes, const FormatStyle& style = {}) {
  return formatted(xml::parse(bytes, SourceId{0}), style);
}

std::string text_of(std::string_view bytes, const FormatStyle& style = {}) {
  const Formatted result = formatted_of(bytes, style);
  EXPECT_EQ(result.refused, "");
  return result.text;
}

TEST(Formatted, AFileIsIndentedByItsNesting) {
  EXPECT_EQ(
      text_of("<?xml version='1.0'?><robot name='a'><link name='b'/>\n"
              "\t<link\n name = 'c' ><inertial>\n<mass value='1' /></inertial></link ></robot>"),
      "<?xml version='1.0'?>\n"
      "<robot name=\"a\">\n"
      "  <link name=\"b\"/>\n"
      "  <link name=\"c\">\n"
      "    <inertial>\n"
      "      <mass value=\"1\"/>\n"
      "    </inertial>\n"
      "  </link>\n"
      "</robot>\n");
}

TEST(Formatted, NumbersAreKeptAndRowsOfThemTakeOneLine) {
  EXPECT_EQ(text_of("<sdf>\n  <pose>\n    0 0  1e-3\n    +.5 0 1.50\n  </pose>\n"
                    "  <origin xyz=\" 0  0 1\" name=\"x  y\"/>\n</sdf>\n"),
            "<sdf>\n  <pose>0 0 1e-3 +.5 0 1.50</pose>\n"
            "  <origin xyz=\"0 0 1\" name=\"x  y\"/>\n</sdf>\n");
}

TEST(Formatted, TextThatIsNoRowOfNumbersKeepsItsBytes) {
  const std::string text = "<sdf>\n  <uri> model://x </uri>\n  <b>1 ${two}\n 3</b>\n</sdf>\n";
  EXPECT_EQ(text_of(text), text);
}

TEST(Formatted, CommentsStayWhereTheyAre) {
  EXPECT_EQ(text_of("<sdf> <!-- of a -->\n<!-- of b,\n   two lines -->\n <b/>   <!-- behind b -->\n"
                    "<!-- rigor: ignore[x] --><c/></sdf><!-- end -->"),
            "<sdf> <!-- of a -->\n  <!-- of b,\n   two lines -->\n  <b/> <!-- behind b -->\n"
            "  <!-- rigor: ignore[x] -->\n  <c/>\n</sdf> <!-- end -->\n");
}

TEST(Formatted, OneBlankLineOfARunStays) {
  EXPECT_EQ(text_of("<sdf>\n\n\n  <b/>\n  \n\n\n  <c/>\n  <d/>\n\n</sdf>\n\n\n"),
            "<sdf>\n  <b/>\n\n  <c/>\n  <d/>\n</sdf>\n");
}

TEST(Formatted, APluginKeepsItsContent) {
  EXPECT_EQ(text_of("<sdf>\n<plugin  name='p'>\n   <x>1   2</x> odd </plugin>\n</sdf>\n"),
            "<sdf>\n  <plugin name=\"p\">\n   <x>1   2</x> odd </plugin>\n</sdf>\n");
}

TEST(Formatted, SoDoesOneOfWhiteSpace) {
  const std::string text = "<sdf>\n  <plugin name=\"p\">\n \n  </plugin>\n</sdf>\n";
  EXPECT_EQ(text_of(text), text);
}

TEST(Formatted, TextAmongElementsKeepsTheContentOfItsElement) {
  const std::string text = "<sdf>\n  <b>one <c  x='1'/>\n two</b>\n</sdf>\n";
  EXPECT_EQ(text_of(text), text);
}

TEST(Formatted, CharacterDataKeepsItsBytes) {
  const std::string text = "<sdf>\n  <b><![CDATA[ 1  2 ]]></b>\n</sdf>\n";
  EXPECT_EQ(text_of(text), text);
}

TEST(Formatted, ALongTagGetsALineForEachAttribute) {
  FormatStyle style;
  style.width = 31;
  EXPECT_EQ(text_of("<sdf><limit lower=\"-1.57\" upper=\"1.57\" effort=\"10\"/></sdf>", style),
            "<sdf>\n  <limit\n      lower=\"-1.57\"\n      upper=\"1.57\"\n      "
            "effort=\"10\"/>\n</sdf>\n");
  EXPECT_EQ(text_of("<sdf>\n<limit\n   lower=\"-1\"\n   upper=\"1\"/></sdf>", style),
            "<sdf>\n  <limit lower=\"-1\" upper=\"1\"/>\n</sdf>\n");
}

TEST(Formatted, AValueKeepsItsQuotesWhereItHoldsTheOther) {
  EXPECT_EQ(text_of("<sdf b='say \"no\"' c='1'/>\n"), "<sdf b='say \"no\"' c=\"1\"/>\n");
  FormatStyle single;
  single.quotes = FormatQuotes::kSingle;
  EXPECT_EQ(text_of("<sdf b=\"${'x'}\" c=\"1\"/>\n", single), "<sdf b=\"${'x'}\" c='1'/>\n");
  FormatStyle keep;
  keep.quotes = FormatQuotes::kKeep;
  EXPECT_EQ(text_of("<sdf  b='1' c=\"1\"/>\n", keep), "<sdf b='1' c=\"1\"/>\n");
}

TEST(Formatted, LineEndsAreTheFilesOwn) {
  EXPECT_EQ(text_of("<sdf>\r\n<b/><c/></sdf>"), "<sdf>\r\n  <b/>\r\n  <c/>\r\n</sdf>\r\n");
}

TEST(Formatted, AnEmptyElementStaysAsItIsWritten) {
  EXPECT_EQ(text_of("<sdf><b>\n</b><c /><d></d></sdf>"),
            "<sdf>\n  <b></b>\n  <c/>\n  <d></d>\n</sdf>\n");
}

TEST(Formatted, WhatIsNotWellFormedIsRefused) {
  for (const std::string_view bytes : {"<sdf><b></sdf>", "<sdf", "", "<sdf/>text", "text<sdf/>"}) {
    const Formatted result = formatted_of(bytes);
    EXPECT_EQ(result.outcome, FormatOutcome::kUnreadable) << bytes;
    EXPECT_EQ(result.text, "") << bytes;
  }
}

TEST(Formatted, WhatIsNoRobotModelIsRefused) {
  EXPECT_EQ(formatted_of("<launch><node pkg='a'/></launch>").refused,
            "<launch> is no robot model's root element");
  EXPECT_EQ(text_of("<x xmlns:xacro='u'/>"), "<x xmlns:xacro=\"u\"/>\n") << "a file of macros";
}

TEST(Formatted, OnlyTheLinesThatAreAskedForChange) {
  const std::string text = "<sdf>\n<b/>\n<c/>\n<d/>\n</sdf>\n";
  const Formatted result = formatted_in_lines(xml::parse(text, SourceId{0}), {}, 3, 3);
  EXPECT_EQ(result.text, "<sdf>\n<b/>\n  <c/>\n<d/>\n</sdf>\n");
}

TEST(Formatted, ChildrenAreInTheOrderOfTheSchemaWhereThatIsAskedFor) {
  const RealDisk disk;
  const Environment environment(disk, {});
  const ChildOrder order(environment.sdf, environment.urdf);
  FormatStyle style;
  style.order = FormatOrder::kCanonical;
  const std::string text =
      "<robot name=\"r\">\n"
      "  <joint name=\"j\" type=\"revolute\">\n"
      "    <!-- of the motor -->\n"
      "    <limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/> <!-- checked -->\n"
      "    <child link=\"b\"/>\n"
      "    <parent link=\"a\"/>\n"
      "    <!-- last -->\n"
      "  </joint>\n"
      "  <link name=\"a\"/>\n"
      "  <link name=\"b\">\n    <unknown/>\n    <inertial/>\n  </link>\n"
      "</robot>\n";
  const Formatted result = formatted(xml::parse(text, SourceId{0}), style, order);
  EXPECT_EQ(result.text,
            "<robot name=\"r\">\n"
            "  <joint name=\"j\" type=\"revolute\">\n"
            "    <parent link=\"a\"/>\n"
            "    <child link=\"b\"/>\n"
            "    <!-- of the motor -->\n"
            "    <limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/> <!-- checked -->\n"
            "    <!-- last -->\n"
            "  </joint>\n"
            "  <link name=\"a\"/>\n"
            "  <link name=\"b\">\n    <unknown/>\n    <inertial/>\n  </link>\n"
            "</robot>\n");
  EXPECT_EQ(apply_edits(text, result.edits), result.text);
  EXPECT_TRUE(formatted(xml::parse(result.text, SourceId{0}), style, order).edits.empty());
  style.order = FormatOrder::kKeep;
  EXPECT_TRUE(formatted(xml::parse(text, SourceId{0}), style, order).edits.empty());
}

TEST(Formatted, AnotherOrderIsNoOtherFileButForTheOrder) {
  const auto same = [](std::string_view a, std::string_view b) {
    return same_but_for_order(xml::parse(a, SourceId{0}), xml::parse(b, SourceId{1}));
  };
  EXPECT_TRUE(same("<sdf><b x='1'/><c>2</c></sdf>", "<sdf><c>2</c><b x='1'/></sdf>"));
  EXPECT_FALSE(same("<sdf><b x='1'/><b x='2'/></sdf>", "<sdf><b x='2'/><b x='1'/></sdf>"));
  EXPECT_FALSE(same("<sdf><b><d/></b><c/></sdf>", "<sdf><b/><c><d/></c></sdf>"));
  EXPECT_FALSE(same("<sdf><!--1--><b/></sdf>", "<sdf><!--2--><b/></sdf>"));
}

TEST(SameContent, SeesWhatAReaderSees) {
  const auto same = [](std::string_view a, std::string_view b) {
    return same_content(xml::parse(a, SourceId{0}), xml::parse(b, SourceId{1}));
  };
  EXPECT_TRUE(same("<sdf><b x='1'>1  2</b></sdf>", "<sdf>\n<b x=\"1\">1 2</b>\n</sdf>"));
  EXPECT_FALSE(same("<sdf><b/></sdf>", "<sdf><c/></sdf>"));
  EXPECT_FALSE(same("<sdf><b/></sdf>", "<sdf><b/><b/></sdf>"));
  EXPECT_FALSE(same("<sdf x='1'/>", "<sdf x='2'/>"));
  EXPECT_FALSE(same("<sdf x='1' y='2'/>", "<sdf x='1'/>"));
  EXPECT_FALSE(same("<sdf>1 2</sdf>", "<sdf>12</sdf>"));
  EXPECT_FALSE(same("<sdf>x  y</sdf>", "<sdf>x y</sdf>"));
  EXPECT_FALSE(same("<sdf><!-- b --></sdf>", "<sdf><!--b--></sdf>"));
  EXPECT_FALSE(same("<sdf><plugin><b/></plugin></sdf>", "<sdf><plugin> <b/></plugin></sdf>"));
  EXPECT_FALSE(same("<sdf><b/></sdf>", "<sdf><b></b></sdf>"));
}

/// What a formatter may not touch: all that is neither white space nor a quote.
std::string ink(std::string_view bytes) {
  std::string kept;
  for (const char c : bytes) {
    if (std::isspace(static_cast<unsigned char>(c)) == 0 && c != '\'' && c != '"') kept += c;
  }
  return kept;
}

/// With those of the xacro corpus that lies beside.
std::vector<std::string> files_as_written() {
  std::vector<std::string> paths = test::corpus_models();
  const std::string templates = test::corpus() + "/../corpus-xacro";
  if (std::filesystem::exists(templates)) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(templates)) {
      if (entry.path().extension() == ".xacro") paths.push_back(entry.path().string());
    }
  }
  return paths;
}

TEST(FormattedCorpus, EveryFileReadsAsBeforeAndIsLaidOutOnce) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  const Environment environment(disk, {});
  const ChildOrder order(environment.sdf, environment.urdf);
  FormatStyle canonical;
  canonical.order = FormatOrder::kCanonical;
  std::size_t files = 0;
  std::size_t changed = 0;
  std::size_t reordered = 0;
  for (const std::string& path : files_as_written()) {
    const std::string bytes = test::read_file(path);
    const Formatted once = formatted_of(bytes);
    const Formatted in_order = formatted(xml::parse(bytes, SourceId{0}), canonical, order);
    EXPECT_EQ(in_order.outcome, once.outcome) << path;
    if (in_order.text != once.text) {
      ++reordered;
      EXPECT_TRUE(formatted(xml::parse(in_order.text, SourceId{0}), canonical, order).edits.empty())
          << path;
    }
    EXPECT_NE(once.outcome, FormatOutcome::kWouldDiffer) << path;
    if (once.outcome != FormatOutcome::kDone) continue;
    ++files;
    changed += once.edits.empty() ? 0 : 1;
    EXPECT_EQ(ink(once.text), ink(bytes)) << path;
    EXPECT_TRUE(formatted_of(once.text).edits.empty()) << path;
  }
  EXPECT_GT(changed, files / 2);
  EXPECT_GT(reordered, files / 10);
}

}  // namespace
}  // namespace rigor::author
