// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Holding efforts over the corpus against mj_inverse at rest. Built where MuJoCo is installed.

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>
#include <tinyxml2.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <string>

#include <rigor/robot/static_loads.h>

#include "corpus/judged_conversion.h"
#include "robot/robots.h"

namespace rigor::judge {
namespace {

using MujocoModel = std::unique_ptr<mjModel, void (*)(mjModel*)>;
using MujocoData = std::unique_ptr<mjData, void (*)(mjData*)>;

/// Each joint by itself: MuJoCo ignores <mimic>, and so must the robot that it is held against.
void prepare(tinyxml2::XMLElement& robot) {
  auto* compiler = robot.InsertNewChildElement("mujoco")->InsertNewChildElement("compiler");
  compiler->SetAttribute("fusestatic", "false");
  compiler->SetAttribute("balanceinertia", "false");
  for (auto* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    while (auto* mimic = joint->FirstChildElement("mimic")) joint->DeleteChild(mimic);
  }
}

MujocoModel mujoco_model(const std::string& urdf) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("rigor_loads_judge_" + std::to_string(::getpid()) + ".urdf");
  std::ofstream(path) << urdf;
  std::array<char, 1000> error{};
  MujocoModel model(mj_loadXML(path.c_str(), nullptr, error.data(), error.size()), mj_deleteModel);
  std::filesystem::remove(path);
  return model;
}

/// The largest difference, as a share of the largest effort; efforts of no joints differ by 0.
double difference(const robot::Robot& robot, mjModel& model, std::mt19937& generator) {
  const MujocoData data(mj_makeData(&model), mj_deleteData);
  model.opt.disableflags |= mjDSBL_CONSTRAINT;
  const model::Vector3 gravity{0.3, -0.4, -9.8};
  model.opt.gravity[0] = gravity.x;
  model.opt.gravity[1] = gravity.y;
  model.opt.gravity[2] = gravity.z;
  std::uniform_real_distribution<double> position(-1.5, 1.5);
  double difference = 0, largest = 1e-3;
  for (int pose = 0; pose < 20; ++pose) {
    robot::Positions positions = followed(robot, {});
    mj_resetData(&model, data.get());
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      const int id = mj_name2id(&model, mjOBJ_JOINT, robot.joints[j].name.c_str());
      if (id < 0 || robot.joints[j].axes.size() != 1) continue;
      positions[j][0] = position(generator);
      data->qpos[model.jnt_qposadr[id]] = positions[j][0];
    }
    mj_inverse(&model, data.get());
    const auto efforts = holding_efforts(robot, positions, gravity);
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      const int id = mj_name2id(&model, mjOBJ_JOINT, robot.joints[j].name.c_str());
      if (id < 0 || robot.joints[j].axes.size() != 1) continue;
      const double theirs = data->qfrc_inverse[model.jnt_dofadr[id]];
      difference = std::max(difference, std::abs(theirs - efforts[j][0]));
      largest = std::max(largest, std::abs(theirs));
    }
  }
  return difference / largest;
}

TEST(CorpusStaticLoadsMujoco, AreThoseOfInverseDynamicsAtRest) {
  RIGOR_NEEDS_CORPUS();
  if (!has_oracle()) GTEST_SKIP() << "no oracle beside the corpus";
  std::mt19937 generator(20261123);
  int robots = 0;
  double worst = 0;
  for_each_conversion([&](const Converted& converted) {
    const std::string urdf = without_shapes(*converted.result.text, prepare);
    const MujocoModel model = mujoco_model(urdf);
    if (!model || model->njnt == 0) return;
    const double found = difference(test::robot_from(urdf), *model, generator);
    EXPECT_LT(found, 1e-9) << named(converted);
    worst = std::max(worst, found);
    ++robots;
  });
  std::printf("%d robots, largest difference %.2g of the largest effort\n", robots, worst);
  EXPECT_GE(robots, 100);
}

}  // namespace
}  // namespace rigor::judge
