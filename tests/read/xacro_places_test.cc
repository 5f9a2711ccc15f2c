// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/xacro_places.h>

#include <gtest/gtest.h>

#include <rigor/text/sources.h>

namespace rigor::read {
namespace {

TEST(XacroPlaces, NamesFit) {
  EXPECT_TRUE(fits_xacro_name("${prefix}_link", "left_link"));
  EXPECT_TRUE(fits_xacro_name("a_${n}_b_$(arg m)", "a_1_b_2"));
  EXPECT_TRUE(fits_xacro_name("${name}", "any"));
  EXPECT_TRUE(fits_xacro_name("plain", "plain"));
  EXPECT_FALSE(fits_xacro_name("plain", "plainer"));
  EXPECT_FALSE(fits_xacro_name("${prefix}_link", "left_joint"));
  EXPECT_FALSE(fits_xacro_name("a_${n}", "b_1"));
  EXPECT_FALSE(fits_xacro_name("a${n}a", "a"));
  EXPECT_TRUE(fits_xacro_name("${open", "any"));
}

constexpr std::string_view kXacroSource =
    R"(<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="half" value="0.5"/>
  <xacro:macro name="wheel" params="side">
    <link name="${side}_wheel">
      <inertial><mass value="${half}"/></inertial>
    </link>
    <joint name="${side}_hinge" type="continuous">
      <axis xyz="0 0 0"/>
    </joint>
  </xacro:macro>
  <link name="base">
    <visual><geometry><box size="1 1 1"/></geometry></visual>
    <visual><geometry><box size="2 2 2"/></geometry></visual>
  </link>
  <xacro:wheel side="left"/>
  <xacro:wheel side="right"/>
</robot>
)";

constexpr std::string_view kXacroExpanded = R"(<?xml version="1.0" ?>
<robot name="r">
  <link name="base">
    <visual><geometry><box size="1 1 1"/></geometry></visual>
    <visual><geometry><box size="2 2 2"/></geometry></visual>
  </link>
  <link name="left_wheel"><inertial><mass value="0.5"/></inertial></link>
  <joint name="left_hinge" type="continuous"><axis xyz="0 0 0"/></joint>
  <link name="right_wheel"><inertial><mass value="0.5"/></inertial></link>
  <joint name="right_hinge" type="continuous"><axis xyz="0 0 0"/></joint>
</robot>
)";

class XacroPlacesOf : public testing::Test {
 protected:
  /// The bytes of the source that the n-th occurrence of `text` in the expanded one leads to.
  std::string of(std::string_view text, std::size_t occurrence = 1) const {
    std::size_t at = std::string_view::npos;
    for (std::size_t i = 0; i < occurrence; ++i) {
      at = kXacroExpanded.find(text, at == std::string_view::npos ? 0 : at + 1);
    }
    const auto begin = static_cast<std::uint32_t>(at);
    const Span where{expanded_.source(), begin, begin + static_cast<std::uint32_t>(text.size())};
    return std::string(sources_.bytes(places_.of(where)));
  }

  Sources sources_;
  SourceId expanded_id_ = sources_.add("r.xacro", std::string(kXacroExpanded));
  SourceId source_id_ = sources_.add("r.xacro", std::string(kXacroSource));
  xml::Document expanded_ = xml::parse(sources_.bytes(expanded_id_), expanded_id_);
  xml::Document source_ = xml::parse(sources_.bytes(source_id_), source_id_);
  XacroPlaces places_{expanded_, source_};
};

TEST_F(XacroPlacesOf, ANameThatStandsInBothOnce) {
  EXPECT_EQ(of("base"), "base");
  EXPECT_EQ(of("<link name=\"base\">"), "<link name=\"base\">");
}

TEST_F(XacroPlacesOf, AnElementOfAMacro) {
  EXPECT_EQ(of("0 0 0", 1), "0 0 0");
  EXPECT_EQ(of("0 0 0", 2), "0 0 0");
  EXPECT_EQ(of("0.5", 2), "${half}");
  EXPECT_EQ(of("right_wheel"), "${side}_wheel");
  EXPECT_EQ(of("continuous"), "continuous");
}

TEST_F(XacroPlacesOf, OneOfSeveralLeadsToWhatHoldsThem) {
  EXPECT_EQ(of("2 2 2"), "<link name=\"base\">");
}

TEST_F(XacroPlacesOf, WhatStandsInTheRootAloneHasNoPlace) {
  EXPECT_EQ(of("<robot name=\"r\">"), "");
  EXPECT_TRUE(places_.of({}).nowhere());
}

TEST_F(XacroPlacesOf, AFindingKeepsWhatItSays) {
  const auto at = static_cast<std::uint32_t>(kXacroExpanded.find("0 0 0"));
  Diagnostic finding{.rule = "axis-zero", .message = "m", .where = {expanded_id_, at, at + 5}};
  finding.related = {{{expanded_id_, at, at + 5}, "here"}, {{expanded_id_, 0, 5}, "lost"}};
  finding.fixes.emplace_back();
  const Diagnostic mapped = places_.in_source(finding, "r.xacro");
  EXPECT_EQ(mapped.where.source, source_id_);
  EXPECT_EQ(sources_.position(source_id_, mapped.where.begin).line, 8U);
  ASSERT_EQ(mapped.related.size(), 1U);
  EXPECT_EQ(mapped.related[0].where.source, source_id_);
  EXPECT_TRUE(mapped.fixes.empty());

  finding.where = {expanded_id_, 0, 5};
  const Diagnostic lost = places_.in_source(finding, "r.xacro");
  EXPECT_TRUE(lost.where.nowhere());
  EXPECT_EQ(lost.path, "r.xacro");
}

TEST(XacroPlaces, WhatAnIncludeMayHaveMadeIsNotGuessed) {
  const std::string_view source =
      "<robot name=\"r\"><xacro:include filename=\"b.xacro\"/><link name=\"${n}\"/></robot>";
  const std::string_view expanded = "<robot name=\"r\"><link name=\"a\"/></robot>";
  const xml::Document one = xml::parse(expanded, SourceId{0});
  const xml::Document two = xml::parse(source, SourceId{1});
  EXPECT_TRUE(XacroPlaces(one, two).of({SourceId{0}, 17, 22}).nowhere());
}

}  // namespace
}  // namespace rigor::read
