// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/inertia/tensor_mistake.h>

#include <cmath>

#include <gtest/gtest.h>

#include <rigor/rules/inertia/written_digits.h>

namespace rigor::rules {
namespace {

// A brick of 3 kg, 0.4 × 0.2 × 0.1 m, turned and off the link's origin: m/12 (y² + z²) and so on.
mass::MassProperties turned_brick() {
  const mass::Inertia along_edges{0.0125, 0, 0, 0.0425, 0, 0.05};
  return {3, {0.2, -0.1, 0.3}, mass::rotated(model::from_axis_angle({1, 2, -1}, 0.7), along_edges)};
}

model::Inertial written_as(const mass::Inertia& tensor, const model::Pose& X_LC) {
  model::Inertial inertial;
  inertial.ixx.value = tensor.ixx;
  inertial.ixy.value = tensor.ixy;
  inertial.ixz.value = tensor.ixz;
  inertial.iyy.value = tensor.iyy;
  inertial.iyz.value = tensor.iyz;
  inertial.izz.value = tensor.izz;
  inertial.pose.pose.value = X_LC;
  return inertial;
}

TEST(TensorMistake, FindsNoneInARightTensor) {
  const auto brick = turned_brick();
  const auto right = written_as(brick.about_com, {brick.com, {}});
  EXPECT_EQ(tensor_mistake::find(right, brick).mistake, TensorMistake::kNone);
}

TEST(TensorMistake, FindsNoneInATensorThatIsTurnedByItsPose) {
  const auto brick = turned_brick();
  const model::Quaternion R_LC = model::from_rpy(0.3, -0.8, 1.1);
  const auto in_C = mass::rotated(model::conjugate(R_LC), brick.about_com);
  EXPECT_EQ(tensor_mistake::find(written_as(in_C, {brick.com, R_LC}), brick).mistake,
            TensorMistake::kNone);
}

TEST(TensorMistake, FindsNoneInAHollowBody) {
  const auto brick = turned_brick();
  const auto hollow = written_as(1.7 * brick.about_com, {brick.com, {}});
  EXPECT_EQ(tensor_mistake::find(hollow, brick).mistake, TensorMistake::kNone);
}

TEST(TensorMistake, NamesProductsOfTheOtherSign) {
  const auto brick = turned_brick();
  mass::Inertia tensor = brick.about_com;
  tensor.ixy *= -1;
  tensor.ixz *= -1;
  tensor.iyz *= -1;
  EXPECT_EQ(tensor_mistake::find(written_as(tensor, {brick.com, {}}), brick).mistake,
            TensorMistake::kProductsNegated);
}

TEST(TensorMistake, NamesATensorAboutTheOrigin) {
  const auto brick = turned_brick();
  const auto written = written_as(mass::about_origin(brick), {brick.com, {}});
  EXPECT_EQ(tensor_mistake::find(written, brick).mistake, TensorMistake::kAboutLinkOrigin);
}

TEST(TensorMistake, NamesATensorAlongTheLinkThatThePoseTurns) {
  const auto brick = turned_brick();
  const auto written = written_as(brick.about_com, {brick.com, model::from_rpy(0, 0.9, 0)});
  EXPECT_EQ(tensor_mistake::find(written, brick).mistake, TensorMistake::kTurned);
}

TEST(TensorMistake, SaysWhereSwappedMomentsBelong) {
  const mass::MassProperties brick{3, {}, {0.0125, 0, 0, 0.0425, 0, 0.05}};
  const auto found = tensor_mistake::find(written_as({0.05, 0, 0, 0.0125, 0, 0.0425}, {}), brick);
  ASSERT_EQ(found.mistake, TensorMistake::kAxesSwapped);
  // What stands as ixx is izz, what stands as iyy is ixx, and what stands as izz is iyy.
  EXPECT_EQ(found.belongs, (std::array<std::size_t, 3>{2, 0, 1}));
}

TEST(WrittenDigits, AreGoodToHalfOfTheLastOne) {
  EXPECT_DOUBLE_EQ(half_of_last_digit("0.012"), 0.0005);
  EXPECT_DOUBLE_EQ(half_of_last_digit("-3.50"), 0.005);
  EXPECT_DOUBLE_EQ(half_of_last_digit("1.2e-5"), 5e-7);
  EXPECT_DOUBLE_EQ(half_of_last_digit("2E+3"), 500);
  EXPECT_EQ(half_of_last_digit("12"), 0);
  EXPECT_EQ(half_of_last_digit(""), 0);
}

}  // namespace
}  // namespace rigor::rules
