// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The proof of a conversion to MJCF finds each number that is off.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <rigor/author/mjcf_proof.h>
#include <rigor/convert/mjcf/written_robot.h>
#include <rigor/convert/to_mjcf.h>
#include <rigor/robot/lookups.h>

#include "convert/converted.h"
#include "convert/mjcf_converted.h"

namespace rigor::test {
namespace {

constexpr const char* kArm = R"(<sdf version='1.9'><model name='arm'>
  <link name='base'><inertial><mass>4</mass><inertia><ixx>0.1</ixx><ixy>0.01</ixy><iyy>0.2</iyy><izz>0.15</izz></inertia></inertial>
    <collision name='c'><geometry><box><size>0.2 0.3 0.4</size></box></geometry></collision></link>
  <link name='upper'><pose>0.1 0.2 0.3 0.4 0.5 0.6</pose>
    <inertial><pose>0.01 0.02 0.03 0 0 0</pose><mass>2</mass><inertia><ixx>0.01</ixx><iyy>0.02</iyy><izz>0.015</izz></inertia></inertial>
    <collision name='d'><pose>0 0.1 0 0.7 0 0</pose><geometry><cylinder><radius>0.05</radius><length>0.3</length></cylinder></geometry></collision></link>
  <link name='hand'><pose relative_to='upper'>0 0 0.5 0 0 1</pose>
    <inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.02</iyy><izz>0.015</izz></inertia></inertial></link>
  <joint name='shoulder' type='revolute'><parent>base</parent><child>upper</child>
    <axis><xyz>0.6 0 0.8</xyz><limit><lower>-1</lower><upper>2</upper><effort>30</effort></limit>
    <dynamics><damping>0.5</damping><friction>0.25</friction></dynamics></axis></joint>
  <joint name='slide' type='prismatic'><parent>upper</parent><child>hand</child>
    <axis><xyz>0 1 0</xyz><limit><lower>-0.1</lower><upper>0.2</upper><effort>20</effort></limit></axis></joint>
</model></sdf>)";

/// The library's own call, so that its result can be held against another text.
struct Arm {
  Arm() : disk(std::map<std::string, std::string>{{"robot.sdf", kArm}}), robot(disk, "robot.sdf") {
    const robot::Lookups lookups =
        robot::lookups_in(robot.loaded.root, robot.workspace, robot.resolver);
    const convert::Source source{robot.loaded.root, robot.frames, robot.documents, robot.resolver,
                                 sdf_schema(),      workers(),    "robot.sdf"};
    result = convert::to_mjcf({source, lookups}, {});
    text = convert::mjcf_text(result.root.value());
  }
  std::size_t found_in(const std::string& other) const {
    return author::prove_mjcf(result, other, {}).size();
  }

  MemoryDisk disk;
  ReadRobot robot;
  convert::MjcfConversion result;
  std::string text;
};

TEST(MjcfProof, FindsNothingInWhatIsWritten) { EXPECT_EQ(Arm().found_in(Arm().text), 0U); }

TEST(MjcfProof, FindsEveryNumberThatIsOff) {
  const Arm arm;
  const xml::Document document = xml::parse(arm.text, {});
  const std::set<std::string> checked{"pos",  "quat",        "axis",    "range",       "mass",
                                      "size", "diaginertia", "damping", "frictionloss"};
  int numbers = 0;
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    const xml::Element element = document.element(i);
    const bool of_robot = element.name() == "body" || element.name() == "joint" ||
                          element.name() == "geom" || element.name() == "inertial";
    for (const xml::Attribute attribute : element.attributes()) {
      if (!of_robot || !checked.contains(std::string(attribute.name()))) continue;
      const auto values = write::numbers_in(attribute.value());
      ASSERT_TRUE(values);
      for (std::size_t k = 0; k < values->size(); ++k) {
        // A longer axis is the same axis.
        if (attribute.name() == "axis" && std::abs((*values)[k]) == 1) continue;
        std::vector<double> off = *values;
        off[k] += 1e-5;
        std::string text = arm.text;
        const Span where = attribute.value_span();
        text.replace(where.begin, where.size(), write::joined(off));
        EXPECT_GT(arm.found_in(text), 0U)
            << element.name() << ' ' << attribute.name() << ' ' << attribute.value() << " #" << k;
        ++numbers;
      }
    }
  }
  EXPECT_GE(numbers, 40);
}

TEST(MjcfProof, FindsAnActuatorRangeAndABodyThatAreOff) {
  const Arm arm;
  std::string text = arm.text;
  text.replace(text.find("-30 30"), 6, "-30 31");
  EXPECT_EQ(arm.found_in(text), 1U);
  text = arm.text;
  text.replace(text.find("name=\"hand\""), 11, "name=\"palm\"");
  EXPECT_GE(arm.found_in(text), 1U);
}

TEST(MjcfProof, AccountCoversEveryElementAndAttribute) {
  const Arm arm;
  const xml::Document document = xml::parse(kArm, {});
  std::size_t expected = 0;
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    const xml::Element element = document.element(i);
    if (element.name() == "sdf") continue;  // with its version
    ++expected;
    for (const xml::Attribute attribute : element.attributes()) {
      expected += attribute.name().empty() ? 0 : 1;
    }
  }
  const auto& counts = arm.result.account.counts;
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), expected);
  EXPECT_EQ(counts[static_cast<std::size_t>(convert::Outcome::kLost)], 0U);
}

}  // namespace
}  // namespace rigor::test
