// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Against pairs written by hand; write_inertial_property_test.cc has what holds for any body and file.

#include <rigor/write/write_inertial.h>

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

namespace rigor::write {
namespace {

using mass::MassProperties;
using xml::Document;
using xml::Element;

/// What most cases write: 2 kg, half a meter up.
const MassProperties kBody{2, {0, 0, 0.5}, {1, 0, 0, 1.5, 0, 0.75}};
const MassProperties kCentred{2, {}, kBody.about_com};

std::optional<Element> first_link(const Document& document) {
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    if (document.element(i).name() == "link") return document.element(i);
  }
  return std::nullopt;
}

/// The text with the body written; and nothing is left to write then.
std::string written(std::string_view text, const MassProperties& body, BlockFormat format) {
  const Document document = xml::parse(text, {});
  EXPECT_TRUE(document.complete()) << text;
  const auto result =
      apply_edits(text, write_inertial(document, *first_link(document), body, format));
  EXPECT_TRUE(result) << text;
  const std::string changed = result.value_or("");
  const Document again = xml::parse(changed, {});
  EXPECT_TRUE(again.complete()) << changed;
  EXPECT_TRUE(write_inertial(again, *first_link(again), body, format).empty()) << changed;
  return changed;
}

/// Around a link's content in a file.
std::string sdf(std::string_view content, std::string_view version = "1.9") {
  return "<sdf version=\"" + std::string(version) + "\">\n  <link name=\"l\">\n" +
         std::string(content) + "  </link>\n</sdf>\n";
}

void expect_sdf(std::string_view before, std::string_view after, const MassProperties& body = kBody,
                std::string_view version = "1.9") {
  EXPECT_EQ(written(sdf(before, version), body, BlockFormat::kSdf), sdf(after, version));
}

std::string urdf(std::string_view content) {
  return "<robot name='r'>\n    <link name='l'>\n" + std::string(content) +
         "    </link>\n</robot>\n";
}

void expect_urdf(std::string_view before, std::string_view after,
                 const MassProperties& body = kBody) {
  EXPECT_EQ(written(urdf(before), body, BlockFormat::kUrdf), urdf(after));
}

constexpr std::string_view kSdfBlock =
    "    <inertial>\n"
    "      <pose>0 0 0.5 0 0 0</pose>\n"
    "      <mass>2</mass>\n"
    "      <inertia>\n"
    "        <ixx>1</ixx>\n"
    "        <ixy>0</ixy>\n"
    "        <ixz>0</ixz>\n"
    "        <iyy>1.5</iyy>\n"
    "        <iyz>0</iyz>\n"
    "        <izz>0.75</izz>\n"
    "      </inertia>\n"
    "    </inertial>\n";

TEST(WriteInertial, AddsOneToALinkOfSdf) {
  const std::string block(kSdfBlock);
  expect_sdf("    <visual/>\n", block + "    <visual/>\n");
  expect_sdf("    <pose>1 2 3 0 0 0</pose>\n    <visual/>\n",
             "    <pose>1 2 3 0 0 0</pose>\n" + block + "    <visual/>\n");
  EXPECT_EQ(written("<sdf version='1.9'>\n  <link name='l'/>\n</sdf>\n", kBody, BlockFormat::kSdf),
            "<sdf version='1.9'>\n  <link name='l'>\n" + block + "  </link>\n</sdf>\n");
}

TEST(WriteInertial, AddsOneToALinkOfUrdf) {
  expect_urdf("        <visual />\n",
              "        <inertial>\n"
              "            <origin xyz='0 0 0.5' rpy='0 0 0' />\n"
              "            <mass value='2' />\n"
              "            <inertia ixx='1' ixy='0' ixz='0' iyy='1.5' iyz='0' izz='0.75' />\n"
              "        </inertial>\n"
              "        <visual />\n");
}

TEST(WriteInertial, AddsOneToALinkOfOldSdf) {
  expect_sdf("    <origin pose=\"1 2 3 0 0 0\"/>\n",
             "    <origin pose=\"1 2 3 0 0 0\"/>\n"
             "    <inertial mass=\"2\">\n"
             "      <origin pose=\"0 0 0.5 0 0 0\"/>\n"
             "      <inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1.5\" iyz=\"0\" izz=\"0.75\"/>\n"
             "    </inertial>\n",
             kBody, "1.0");
}

TEST(WriteInertial, ReplacesNumbersInPlace) {
  // As in gz-sim's worlds: the tensor first, comments between, the pose last.
  expect_sdf(
      "    <inertial>\n"
      "      <inertia>\n"
      "        <!-- (mass / 12) * (y*y + z*z) -->\n"
      "        <ixx> 0.1 </ixx>\n"
      "        <ixy>0.0</ixy><ixz>0</ixz>\n"
      "        <iyy>1.50</iyy> <!-- measured -->\n"
      "        <iyz>-0</iyz>\n"
      "        <izz>nan</izz>\n"
      "      </inertia>\n"
      "      <mass>2.0</mass>\n"
      "      <pose>0  0  .1   0 0.7 0</pose>\n"
      "    </inertial>\n",
      "    <inertial>\n"
      "      <inertia>\n"
      "        <!-- (mass / 12) * (y*y + z*z) -->\n"
      "        <ixx> 1 </ixx>\n"
      "        <ixy>0.0</ixy><ixz>0</ixz>\n"
      "        <iyy>1.50</iyy> <!-- measured -->\n"
      "        <iyz>-0</iyz>\n"
      "        <izz>0.75</izz>\n"
      "      </inertia>\n"
      "      <mass>2.0</mass>\n"
      "      <pose>0  0  0.5   0 0 0</pose>\n"
      "    </inertial>\n");
}

TEST(WriteInertial, ReplacesAttributesOfUrdf) {
  // As the SolidWorks exporter lays it out.
  expect_urdf(
      "        <inertial>\n"
      "            <origin\n"
      "                xyz='0 0 0.25'\n"
      "                rpy='0 0 1.57' />\n"
      "            <mass\n"
      "                value='1' /><!-- kg -->\n"
      "            <inertia\n"
      "                izz='3'\n"
      "                ixx='1.0'\n"
      "                iyy='0.2' />\n"
      "        </inertial>\n",
      "        <inertial>\n"
      "            <origin\n"
      "                xyz='0 0 0.5'\n"
      "                rpy='0 0 0' />\n"
      "            <mass\n"
      "                value='2' /><!-- kg -->\n"
      "            <inertia\n"
      "                izz='0.75'\n"
      "                ixx='1.0'\n"
      "                iyy='1.5'\n"
      "                ixy='0'\n"
      "                ixz='0'\n"
      "                iyz='0' />\n"
      "        </inertial>\n");
}

TEST(WriteInertial, ReplacesAttributesOfOldSdf) {
  expect_sdf(
      "    <inertial mass='5.0'>\n"
      "      <origin pose='0 0 0 0 0 0'/>\n"
      "      <damping linear='0.01'/>\n"
      "      <inertia ixx='1' ixy='0' ixz='0'\n"
      "               iyy='1' iyz='0'\n"
      "               izz='1'/>\n"
      "    </inertial>\n",
      "    <inertial mass='2'>\n"
      "      <origin pose='0 0 0.5 0 0 0'/>\n"
      "      <damping linear='0.01'/>\n"
      "      <inertia ixx='1' ixy='0' ixz='0'\n"
      "               iyy='1.5' iyz='0'\n"
      "               izz='0.75'/>\n"
      "    </inertial>\n",
      kBody, "1.0");
  expect_sdf("    <inertial/>\n",
             "    <inertial mass=\"2\">\n"
             "      <inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1.5\" iyz=\"0\" izz=\"0.75\"/>\n"
             "    </inertial>\n",
             kCentred, "1.0");
}

TEST(WriteInertial, AddsWhatIsMissing) {
  expect_sdf("    <inertial>\n      <mass>1</mass>\n    </inertial>\n", std::string(kSdfBlock));
  expect_sdf("    <inertial/>\n", std::string(kSdfBlock));
  expect_sdf("    <inertial>\n      <mass>2</mass>\n      <inertia/>\n    </inertial>\n",
             "    <inertial>\n      <mass>2</mass>\n      <inertia>\n"
             "        <ixx>1</ixx>\n        <iyy>1.5</iyy>\n        <izz>0.75</izz>\n"
             "      </inertia>\n    </inertial>\n",
             kCentred);
  expect_urdf("        <inertial>\n            <mass/>\n        </inertial>\n",
              "        <inertial>\n"
              "            <origin xyz='0 0 0.5' rpy='0 0 0'/>\n"
              "            <mass value='2'/>\n"
              "            <inertia ixx='1' ixy='0' ixz='0' iyy='1.5' iyz='0' izz='0.75'/>\n"
              "        </inertial>\n");
}

TEST(WriteInertial, AddsAProductThatIsNotZero) {
  expect_sdf(
      "    <inertial>\n"
      "      <mass>2</mass>\n"
      "      <inertia>\n"
      "        <ixx>1</ixx>\n"
      "        <iyy>1</iyy>\n"
      "        <izz>1</izz>\n"
      "      </inertia>\n"
      "    </inertial>\n",
      "    <inertial>\n"
      "      <mass>2</mass>\n"
      "      <inertia>\n"
      "        <ixx>1</ixx>\n"
      "        <ixy>0.1</ixy>\n"
      "        <ixz>0.2</ixz>\n"
      "        <iyy>1</iyy>\n"
      "        <izz>1</izz>\n"
      "      </inertia>\n"
      "    </inertial>\n",
      {2, {}, {1, 0.1, 0.2, 1, 0, 1}});
}

/// An inertial of SDF that differs in its pose only.
std::string with_pose(std::string_view pose) {
  return "    <inertial>\n      " + std::string(pose) +
         "\n      <mass>2</mass>\n      <inertia>\n        <ixx>1</ixx>\n"
         "        <iyy>1.5</iyy>\n        <izz>0.75</izz>\n      </inertia>\n    </inertial>\n";
}

TEST(WriteInertial, PutsThePoseInTheLinkFrame) {
  const auto expect = [](std::string_view before, std::string_view after,
                         const MassProperties& body = kBody) {
    expect_sdf(with_pose(before), with_pose(after), body);
  };
  expect("<pose relative_to=\"other\">1 0 0 0 0 0</pose>", "<pose>0 0 0.5 0 0 0</pose>");
  expect("<pose frame=''>0 0 0.5 3.14 0 0</pose>", "<pose frame=''>0 0 0.5 0 0 0</pose>");
  expect("<pose degrees='true'>0 0 0.5 90 0 0</pose>", "<pose degrees='true'>0 0 0.5 0 0 0</pose>");
  expect("<pose rotation_format='quat_xyzw'>0 0 0  0 0 1 0</pose>",
         "<pose rotation_format='quat_xyzw'>0 0 0.5  0 0 0 1</pose>");
  expect("<pose>1 2 3</pose>", "<pose>0 0 0.5 0 0 0</pose>");
  expect("<pose/>", "<pose>0 0 0.5 0 0 0</pose>");
  expect("<pose/>", "<pose/>", kCentred);
  expect("<pose>0 0 1 0 0 0</pose>", "<pose>0 0 0 0 0 0</pose>", kCentred);
}

TEST(WriteInertial, TurnsNothingInUrdf) {
  constexpr std::string_view kRest =
      "<mass value='2'/><inertia ixx='1' ixy='0' ixz='0' iyy='1.5' iyz='0' izz='0.75'/>"
      "</inertial>\n";
  const auto expect = [&](std::string_view before, std::string_view after,
                          const MassProperties& body) {
    expect_urdf("        <inertial>" + std::string(before) + std::string(kRest),
                "        <inertial>" + std::string(after) + std::string(kRest), body);
  };
  expect("", "<origin xyz='0 0 0.5' rpy='0 0 0'/>", kBody);
  expect("", "", kCentred);
  expect("<origin rpy='0 1 0'/>", "<origin rpy='0 0 0' xyz='0 0 0.5'/>", kBody);
  expect("<origin/>", "<origin/>", kCentred);
  expect("<origin xyz='0 0 .5' quat_xyzw='1 0 0 0'/>", "<origin xyz='0 0 .5' quat_xyzw='0 0 0 1'/>",
         kBody);
}

TEST(WriteInertial, BakesAnAutomaticOne) {
  const std::string block(kSdfBlock);
  expect_sdf("    <inertial auto=\"true\"/>\n", block, kBody, "1.11");
  expect_sdf("    <inertial auto='true'>\n      <density>1240</density>\n    </inertial>\n", block,
             kBody, "1.11");
  expect_sdf(
      "    <inertial auto='1'>\n      <mass>3</mass>\n      <!-- of PLA -->\n"
      "      <density>1240</density>\n    </inertial>\n",
      "    <inertial>\n      <mass>2</mass>\n      <!-- of PLA -->\n"
      "      <inertia>\n        <ixx>1</ixx>\n        <ixy>0</ixy>\n        <ixz>0</ixz>\n"
      "        <iyy>1.5</iyy>\n        <iyz>0</iyz>\n        <izz>0.75</izz>\n"
      "      </inertia>\n    </inertial>\n",
      kCentred, "1.11");
  const std::string manual = with_pose("<pose>0 0 0.5 0 0 0</pose>");
  expect_sdf("    <inertial auto='false'>" + manual.substr(14),
             "    <inertial auto='false'>" + manual.substr(14), kBody, "1.11");
}

TEST(WriteInertial, LeavesWhatReadsTheSame) {
  // More digits than would be written, of the very same body.
  const MassProperties third{1.0 / 3, {1.0 / 3, 0, 0}, {1.0 / 3, 1e-20, 0, 1.0 / 3, 0, 1.0 / 3}};
  constexpr std::string_view kExact =
      "    <inertial>\n"
      "      <pose>0.3333333333333333 0 0 0 0 0</pose>\n"
      "      <mass>0.333333333333333333333</mass>\n"
      "      <inertia>\n"
      "        <ixx>0.3333333333333333</ixx>\n"
      "        <iyy>0.3333333333333333</iyy>\n"
      "        <izz>3333333333333333e-16</izz>\n"
      "      </inertia>\n"
      "    </inertial>\n";
  expect_sdf(kExact, kExact, third);
}

TEST(WriteInertial, StaysInOneLine) {
  EXPECT_EQ(written("<sdf version='1.6'><link name='l'><inertial><mass>1</mass></inertial></link>"
                    "</sdf>",
                    kCentred, BlockFormat::kSdf),
            "<sdf version='1.6'><link name='l'><inertial><mass>2</mass><inertia><ixx>1</ixx>"
            "<ixy>0</ixy><ixz>0</ixz><iyy>1.5</iyy><iyz>0</iyz><izz>0.75</izz></inertia></inertial>"
            "</link></sdf>");
}

TEST(WriteInertial, WritesNothingToMjcfAndCutDocuments) {
  const std::string text = "<robot><link name='l'></link>";
  const Document cut = xml::parse(text, {});
  EXPECT_TRUE(write_inertial(cut, *first_link(cut), kBody, BlockFormat::kUrdf).empty());
  const std::string whole = text + "</robot>";
  const Document document = xml::parse(whole, {});
  EXPECT_TRUE(write_inertial(document, *first_link(document), kBody, BlockFormat::kMjcf).empty());
}

}  // namespace
}  // namespace rigor::write
