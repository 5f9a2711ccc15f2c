// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// SDF to URDF over the corpus as MuJoCo simulates the result: where it puts the bodies and what they
// weigh, against libsdformat's poses of the source. Built where MuJoCo is installed.

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>
#include <tinyxml2.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>

#include "corpus/judged_conversion.h"

namespace rigor::judge {
namespace {

using MujocoModel = std::unique_ptr<mjModel, void (*)(mjModel*)>;
using MujocoData = std::unique_ptr<mjData, void (*)(mjData*)>;

/// With each link a body.
void add_mujoco_words(tinyxml2::XMLElement& robot) {
  auto* compiler = robot.InsertNewChildElement("mujoco")->InsertNewChildElement("compiler");
  compiler->SetAttribute("fusestatic", "false");
  compiler->SetAttribute("balanceinertia", "false");
}

class MujocoRobot {
 public:
  explicit MujocoRobot(const std::string& urdf)
      : model_(load(urdf)), data_(nullptr, mj_deleteData) {
    if (model_) data_.reset(mj_makeData(model_.get()));
  }

  explicit operator bool() const { return model_ != nullptr; }
  const std::string& complaint() const { return complaint_; }

  Seen at(const std::map<std::string, double>& positions) {
    mj_resetData(model_.get(), data_.get());
    for (const auto& [name, position] : positions) {
      const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, name.c_str());
      EXPECT_GE(joint, 0) << name;
      if (joint >= 0) data_->qpos[model_->jnt_qposadr[joint]] = position;
    }
    mj_kinematics(model_.get(), data_.get());
    Seen seen;
    for (int i = 1; i < model_->nbody; ++i) {
      const Rigid X = pose(data_->xquat + 4 * i, data_->xpos + 3 * i);
      seen.links[mj_id2name(model_.get(), mjOBJ_BODY, i)] = X;
      const mjtNum* I = model_->body_inertia + 3 * i;
      seen.sum.add(X * pose(model_->body_iquat + 4 * i, model_->body_ipos + 3 * i),
                   model_->body_mass[i], {}, {{{I[0], 0, 0}, {0, I[1], 0}, {0, 0, I[2]}}});
    }
    return seen;
  }

 private:
  static Rigid pose(const mjtNum* q, const mjtNum* p) {
    return {rotation_of(q[0], q[1], q[2], q[3]), {p[0], p[1], p[2]}};
  }

  MujocoModel load(const std::string& urdf) {
    const auto path = std::filesystem::temp_directory_path() /
                      ("rigor_mujoco_judge_" + std::to_string(::getpid()) + ".urdf");
    std::ofstream(path) << without_shapes(urdf, add_mujoco_words);
    std::array<char, 1000> error{};
    MujocoModel model(mj_loadXML(path.c_str(), nullptr, error.data(), error.size()),
                      mj_deleteModel);
    std::filesystem::remove(path);
    if (!model) complaint_ = error.data();
    return model;
  }

  std::string complaint_;
  MujocoModel model_;
  MujocoData data_;
};

/// Moments, relative: it finds principal axes to some 1e-9 itself.
constexpr double kMujocoMoments = 1e-8;

TEST(CorpusConversionMujoco, SeesTheSource) {
  RIGOR_NEEDS_CORPUS();
  if (!has_oracle()) GTEST_SKIP() << "no oracle beside the corpus";
  JudgedCounts counts;
  int refused = 0;
  const ConversionCounts all = for_each_conversion([&](const Converted& converted) {
    MujocoRobot robot(*converted.result.text);
    if (robot) return hold(converted, robot, kMujocoMoments, counts);
    // The source's own: no body has such an inertia.
    EXPECT_NE(robot.complaint().find("A + B >= C"), std::string::npos)
        << named(converted) << ": " << robot.complaint();
    ++refused;
  });
  std::printf(
      "%d converted, %d refused for an impossible inertia, %d agree in %d poses, %d in mass\n",
      all.converted, refused, counts.poses_agree, counts.poses, counts.moments_agree);
  EXPECT_EQ(counts.poses_agree, all.converted - refused);
  EXPECT_LE(refused, all.converted / 500);
}

}  // namespace
}  // namespace rigor::judge
