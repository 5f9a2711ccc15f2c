// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// SDF to URDF over the corpus as DART reads the result: where it puts the bodies and what they weigh,
// against libsdformat's poses of the source. Built where DART is installed.

#include <gtest/gtest.h>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/utils/urdf/DartLoader.hpp>

#include <cstdio>
#include <map>
#include <string>

#include "corpus/judged_conversion.h"

namespace rigor::judge {
namespace {

Rigid rigid_in_dart(const Eigen::Isometry3d& X) {
  Rigid result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result.R[i][j] = X(Eigen::Index(i), Eigen::Index(j));
    result.p[i] = X(Eigen::Index(i), 3);
  }
  return result;
}

/// As the loader leaves it, the root is free.
class DartRobot {
 public:
  DartRobot(const std::string& text, const urdf::ModelInterface& urdf)
      : urdf_(urdf),
        robot_(dart::utils::DartLoader().parseSkeletonString(without_shapes(text, [](auto&) {}),
                                                             "file:///nowhere")) {}

  explicit operator bool() const { return robot_ != nullptr; }

  Seen at(const std::map<std::string, double>& positions) {
    for (const auto& [name, position] : positions) {
      dart::dynamics::Joint* joint = robot_->getJoint(name);
      EXPECT_TRUE(joint != nullptr && joint->getNumDofs() == 1) << name;
      if (joint != nullptr) joint->setPosition(0, position);
    }
    // A root of the name "world" is no body.
    const dart::dynamics::BodyNode* root = robot_->getBodyNode(urdf_.getRoot()->name);
    const Rigid X_from =
        root == nullptr ? Rigid{} : inverse(rigid_in_dart(root->getWorldTransform()));
    Seen seen;
    for (std::size_t i = 0; i < robot_->getNumBodyNodes(); ++i) {
      add(*robot_->getBodyNode(i), X_from, seen);
    }
    return seen;
  }

 private:
  void add(const dart::dynamics::BodyNode& body, const Rigid& X_from, Seen& seen) const {
    const Rigid X = X_from * rigid_in_dart(body.getWorldTransform());
    seen.links[body.getName()] = X;
    if (!urdf_.getLink(body.getName())->inertial) return;  // DART makes it weigh 1 kg
    const Eigen::Vector3d c = body.getInertia().getLocalCOM();
    const Eigen::Matrix3d I = body.getInertia().getMoment();
    Matrix inertia{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) inertia[i][j] = I(Eigen::Index(i), Eigen::Index(j));
    }
    seen.sum.add(X, body.getMass(), {c.x(), c.y(), c.z()}, inertia);
  }

  const urdf::ModelInterface& urdf_;
  dart::dynamics::SkeletonPtr robot_;
};

TEST(CorpusConversionDart, SeesTheSource) {
  RIGOR_NEEDS_CORPUS();
  if (!has_oracle()) GTEST_SKIP() << "no oracle beside the corpus";
  JudgedCounts counts;
  const ConversionCounts all = for_each_conversion([&counts](const Converted& converted) {
    DartRobot robot(*converted.result.text, converted.urdf);
    EXPECT_TRUE(robot) << named(converted);
    if (robot) hold(converted, robot, kAgreement, counts);
  });
  std::printf("%d converted, %d agree in %d poses, %d in mass\n", all.converted, counts.poses_agree,
              counts.poses, counts.moments_agree);
  EXPECT_EQ(counts.poses_agree, all.converted);
}

}  // namespace
}  // namespace rigor::judge
