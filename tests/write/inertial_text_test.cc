// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/write/inertial_text.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>

#include "write/bodies.h"

namespace rigor::write {
namespace {

using mass::MassProperties;

/// 1 m × 2 m × 3 m at 1 kg: (b² + c²)/12 and so on.
const MassProperties kBox{1, {}, {13.0 / 12, 0, 0, 10.0 / 12, 0, 5.0 / 12}};

/// A square meter without thickness: ixx + iyy is izz, to the last bit.
const MassProperties kPlate{1, {}, {1.0 / 12, 0, 0, 1.0 / 12, 0, 1.0 / 6}};

/// What another reader makes of the numbers: strtod, not rigor's own.
MassProperties read_back(const InertialNumbers& numbers) {
  const auto value = [](const std::string& text) { return std::strtod(text.c_str(), nullptr); };
  const auto& i = numbers.inertia;
  return {value(numbers.mass),
          {value(numbers.com[0]), value(numbers.com[1]), value(numbers.com[2])},
          {value(i[0]), value(i[1]), value(i[2]), value(i[3]), value(i[4]), value(i[5])}};
}

TEST(InertialNumbers, AreShort) {
  const InertialNumbers numbers =
      inertial_numbers({0.1, {1.0 / 3, -2.5, 1e-5}, {1.0 / 6, 0, 0, 0.25, 0, 0.2}});
  EXPECT_EQ(numbers.mass, "0.1");
  EXPECT_EQ(numbers.com[0], "0.333333333");
  EXPECT_EQ(numbers.com[1], "-2.5");
  EXPECT_EQ(numbers.com[2], "1e-05");
  EXPECT_EQ(numbers.inertia[0], "0.166666667");
  EXPECT_EQ(numbers.inertia[3], "0.25");
  EXPECT_EQ(inertial_numbers({123456789012.0, {}, {}}).mass, "123456789000");
  EXPECT_EQ(inertial_numbers({0.0001, {}, {}}).mass, "1e-04");
}

TEST(InertialNumbers, HaveNoNoise) {
  const InertialNumbers numbers =
      inertial_numbers({1, {1e-17, -0.0, -2e-17}, {1, -1e-17, 3e-16, 1, -0.0, 1}});
  EXPECT_EQ(numbers.com, (std::array<std::string, 3>{"0", "0", "0"}));
  EXPECT_EQ(numbers.inertia, (std::array<std::string, 6>{"1", "0", "0", "1", "0", "1"}));
  // A small body's small numbers are no noise.
  EXPECT_EQ(inertial_numbers({1e-18, {1e-18, 0, 0}, {}}).com[0], "1e-18");
  EXPECT_EQ(inertial_numbers({1, {}, {1e-18, 1e-19, 0, 1e-18, 0, 1e-18}}).inertia[1], "1e-19");
  // Of a rod along x, noise may have left less than nothing.
  EXPECT_EQ(inertial_numbers({1, {}, {-1e-17, 0, 0, 1, 0, 1}}).inertia[0], "0");
  EXPECT_EQ(inertial_numbers({1, {}, {-0.0, 0, 0, 1, 0, 1}}).inertia[0], "0");
  EXPECT_EQ(inertial_numbers({-0.0, {-0.0, 0, 0}, {}}).mass, "0");
}

TEST(InertialNumbers, TakeMoreDigitsForAPlate) {
  const InertialNumbers numbers = inertial_numbers(kPlate);
  EXPECT_EQ(numbers.inertia[0], "0.08333333333333333");
  EXPECT_EQ(numbers.inertia[5], "0.16666666666666666");
  EXPECT_EQ(numbers.mass, "1");
  // Rounding that leaves a body a body costs no digits: 2/9 rounds down, 1/9 + 1/9 to the same.
  const InertialNumbers lucky = inertial_numbers({1, {}, {1.0 / 9, 0, 0, 1.0 / 9, 0, 2.0 / 9}});
  EXPECT_EQ(lucky.inertia[5], "0.222222222");
}

TEST(InertialNumbers, SayWhatAnImpossibleBodyHas) {
  const InertialNumbers numbers = inertial_numbers({-1, {}, {1, 0, 0, 1, 0, 1.0 / 3 + 2}});
  EXPECT_EQ(numbers.mass, "-1");
  EXPECT_EQ(numbers.inertia[0], "1");
  EXPECT_EQ(std::strtod(numbers.inertia[5].c_str(), nullptr) > 2.3333, true);
}

TEST(InertialNumbers, StayPossibleForAnyBody) {
  std::mt19937 random(7);
  for (int i = 0; i < 10'000; ++i) {
    const MassProperties body = test::random_body(random);
    ASSERT_TRUE(judge(body).possible());
    const MassProperties back = read_back(inertial_numbers(body));
    EXPECT_TRUE(judge(back).possible()) << i;
    test::expect_near(back, body);
    // libsdformat allows ten machine epsilons; rounding takes none of it.
    const auto margin = [](const std::array<double, 3>& m) { return m[0] + m[1] - m[2]; };
    EXPECT_GE(margin(judge(back).principal), std::min(0.0, margin(judge(body).principal)));
  }
}

TEST(InertialText, IsSdf) {
  EXPECT_EQ(inertial_text({2, {0, 0, 0.5}, kBox.about_com}, BlockFormat::kSdf),
            "<inertial>\n"
            "  <pose>0 0 0.5 0 0 0</pose>\n"
            "  <mass>2</mass>\n"
            "  <inertia>\n"
            "    <ixx>1.08333333</ixx>\n"
            "    <ixy>0</ixy>\n"
            "    <ixz>0</ixz>\n"
            "    <iyy>0.833333333</iyy>\n"
            "    <iyz>0</iyz>\n"
            "    <izz>0.416666667</izz>\n"
            "  </inertia>\n"
            "</inertial>");
}

TEST(InertialText, IsUrdf) {
  EXPECT_EQ(inertial_text({2, {0, 0, 0.5}, kBox.about_com}, BlockFormat::kUrdf),
            "<inertial>\n"
            "  <origin xyz=\"0 0 0.5\" rpy=\"0 0 0\"/>\n"
            "  <mass value=\"2\"/>\n"
            "  <inertia ixx=\"1.08333333\" ixy=\"0\" ixz=\"0\" iyy=\"0.833333333\" iyz=\"0\" "
            "izz=\"0.416666667\"/>\n"
            "</inertial>");
}

TEST(InertialText, IsMjcf) {
  EXPECT_EQ(inertial_text({2, {}, {3, 0.1, 0.2, 4, 0.3, 5}}, BlockFormat::kMjcf),
            "<inertial pos=\"0 0 0\" mass=\"2\" fullinertia=\"3 4 5 0.1 0.2 0.3\"/>");
}

TEST(InertialText, LeavesOutThePoseOfTheLink) {
  EXPECT_EQ(inertial_text({2, {}, {1, 0, 0, 1, 0, 1}}, BlockFormat::kUrdf),
            "<inertial>\n"
            "  <mass value=\"2\"/>\n"
            "  <inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/>\n"
            "</inertial>");
  EXPECT_EQ(inertial_text(kBox, BlockFormat::kSdf).find("pose"), std::string::npos);
}

TEST(InertialText, TakesARotation) {
  EXPECT_NE(inertial_text(kBox, BlockFormat::kSdf, "0 0 1.57").find("<pose>0 0 0 0 0 1.57</pose>"),
            std::string::npos);
  EXPECT_NE(inertial_text(kBox, BlockFormat::kUrdf, "0 0 1.57").find("rpy=\"0 0 1.57\"/>"),
            std::string::npos);
}

}  // namespace
}  // namespace rigor::write
