// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/terminal/excerpt.h>

#include <string>

#include <gtest/gtest.h>

#include <rigor/report/terminal/printable.h>

namespace rigor::report {
namespace {

/// One source, and marks on the n-th place where a text stands in it.
class Excerpt : public testing::Test {
 protected:
  Span find(const std::string& text) const {
    const auto begin = static_cast<std::uint32_t>(bytes_.find(text));
    EXPECT_NE(begin, static_cast<std::uint32_t>(std::string::npos));
    return {source_, begin, begin + static_cast<std::uint32_t>(text.size())};
  }

  void source(std::string bytes) {
    bytes_ = std::move(bytes);
    source_ = sources_.add("arm.sdf", bytes_);
  }

  std::string draw(const std::vector<Mark>& marks) {
    Places places(sources_);
    return excerpt(marks, places, {gutter_width(marks, places)});
  }

  std::string bytes_;
  Sources sources_;
  SourceId source_ = kNoSource;
};

TEST_F(Excerpt, UnderlinesTheSpan) {
  source("<a>\n  <lower>1.5</lower>\n</a>\n");
  EXPECT_EQ(draw({{find("1.5")}}),
            "  |\n"
            "2 |   <lower>1.5</lower>\n"
            "  |          ^^^\n"
            "  |\n");
}

TEST_F(Excerpt, SecondMarkHasDashesAndAMessage) {
  source("<lower>1</lower>\n<upper>-1</upper>\n");
  EXPECT_EQ(draw({{find("1")}, {find("-1"), '-', "the upper limit"}}),
            "  |\n"
            "1 | <lower>1</lower>\n"
            "  |        ^\n"
            "2 | <upper>-1</upper>\n"
            "  |        -- the upper limit\n"
            "  |\n");
}

TEST_F(Excerpt, MarksOnOneLineShareIt) {
  source("<a x='1' x='2'/>");
  EXPECT_EQ(draw({{find("x='2'")}, {find("x='1'"), '-', "first"}}),
            "  |\n"
            "1 | <a x='1' x='2'/>\n"
            "  |    ----- first\n"
            "  |          ^^^^^\n"
            "  |\n");
}

TEST_F(Excerpt, LeavesOutLinesBetween) {
  source("a\nb\nc\nd\ne\nf\ng\nh\ni\nj\n");
  EXPECT_EQ(draw({{find("a")}, {find("j"), '-', {}}}),
            "   |\n"
            " 1 | a\n"
            "   | ^\n"
            "...\n"
            "10 | j\n"
            "   | -\n"
            "   |\n");
}

TEST_F(Excerpt, ExpandsTabsToTheNextStop) {
  source("\tab\tcd\n");
  EXPECT_EQ(draw({{find("cd")}}),
            "  |\n"
            "1 |     ab  cd\n"
            "  |         ^^\n"
            "  |\n");
}

TEST_F(Excerpt, CountsCodePointsNotBytes) {
  source("<äöü name='x'/>");
  EXPECT_EQ(draw({{find("name")}}),
            "  |\n"
            "1 | <äöü name='x'/>\n"
            "  |      ^^^^\n"
            "  |\n");
}

TEST_F(Excerpt, SeveralLinesAreCutToTheFirst) {
  source("<link>\n</link>\n");
  EXPECT_EQ(draw({{find("<link>\n</link>")}}),
            "  |\n"
            "1 | <link>\n"
            "  | ^^^^^^…\n"
            "  |\n");
}

TEST_F(Excerpt, EmptySpanGetsOneSign) {
  source("<a></a>\n");
  EXPECT_EQ(draw({{{source_, 3, 3}}}),
            "  |\n"
            "1 | <a></a>\n"
            "  |    ^\n"
            "  |\n");
  EXPECT_EQ(draw({{{source_, 7, 7}}}),
            "  |\n"
            "1 | <a></a>\n"
            "  |        ^\n"
            "  |\n");
}

TEST_F(Excerpt, ByteOrderMarkHasNoColumn) {
  source("\xEF\xBB\xBF<a/>");
  EXPECT_EQ(draw({{find("<a/>")}}),
            "  |\n"
            "1 | <a/>\n"
            "  | ^^^^\n"
            "  |\n");
}

TEST_F(Excerpt, CutsALongLineAroundTheMark) {
  source(std::string(1000, 'a') + "XYZ" + std::string(1000, 'b'));
  // 40 columns before the mark, 120 in all, and an ellipsis on either side.
  EXPECT_EQ(draw({{find("XYZ")}}),
            "  |\n"
            "1 | …" +
                std::string(40, 'a') + "XYZ" + std::string(77, 'b') +
                "…\n"
                "  |  " +
                std::string(40, ' ') +
                "^^^\n"
                "  |\n");
}

TEST_F(Excerpt, MarksOnALongLineShareItToo) {
  source("<a x='1'" + std::string(10, ' ') + "x='2'" + std::string(200, ' ') + "y='3'/>");
  EXPECT_EQ(draw({{find("x='2'")}, {find("x='1'"), '-', "first"}}),
            "  |\n"
            "1 | <a x='1'          x='2'" +
                std::string(97, ' ') +
                "…\n"
                "  |    ----- first\n"
                "  |                   ^^^^^\n"
                "  |\n");
}

TEST_F(Excerpt, LongSpanEndsWithTheWindow) {
  source(std::string(5000, 'a'));
  EXPECT_EQ(draw({{{source_, 0, 5000}}}),
            "  |\n"
            "1 | " +
                std::string(120, 'a') +
                "…\n"
                "  | " +
                std::string(120, '^') +
                "…\n"
                "  |\n");
}

TEST_F(Excerpt, AFileCannotDriveTheTerminal) {
  source("<a b='\x1b[2J\x07'>\xC2\x9B\xFF\xE2\x80\xAE</a>");
  EXPECT_EQ(draw({{find("b=")}}),
            "  |\n"
            "1 | <a b='␛[2J␇'>\uFFFD\uFFFD\uFFFD</a>\n"
            "  |    ^^\n"
            "  |\n");
}

TEST_F(Excerpt, PastTheEndOfTheFile) {
  source("<a>\n");
  EXPECT_EQ(draw({{{source_, 4, 4}}}),
            "  |\n"
            "2 |\n"
            "  | ^\n"
            "  |\n");
}

TEST(Printable, FoldsLinesAndShowsControls) {
  EXPECT_EQ(printable("a\n   b\tc\r\n"), "a b c");
  EXPECT_EQ(printable("\x1b]0;title\x07"), "␛]0;title␇");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "␀");
  EXPECT_EQ(printable("\x7f"), "␡");
  EXPECT_EQ(printable("kg·m²"), "kg·m²");
  EXPECT_EQ(printable("\xE2\x82"), "\uFFFD\uFFFD");
}

TEST(Printable, SaysHowMuchIsLeftOut) {
  EXPECT_EQ(printable("abcdef", 4), "abcd… (2 more bytes)");
  EXPECT_EQ(printable("abcd", 4), "abcd");
}

}  // namespace
}  // namespace rigor::report
