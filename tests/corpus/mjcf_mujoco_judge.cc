// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// SDF and URDF to MJCF over the corpus as MuJoCo compiles the result: every robot that is a tree of joints of
// one degree, its bodies at 20 positions, masses, tensors, limits, axes and actuators held against the
// robot of the source. Built where MuJoCo is installed.

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <rigor/author/conversion.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/robot/compare.h>
#include <rigor/robot/lookups.h>
#include <rigor/robot/robot.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/mesh_finder.h>
#include <rigor/view/drawing/files.h>
#include <rigor/view/drawing/looks.h>

#include "corpus/source_robot.h"
#include "support/corpus.h"
#include "support/part.h"

namespace rigor::judge {
namespace {

using model::JointType;
using model::Pose;
using robot::Robot;

constexpr double kAgreement = 1e-9;  ///< m, rad, and of masses and tensors relative
constexpr std::size_t kPositions = 20;
constexpr int kMaxOfAFile = 10;  // one world has 3000 boxes

using MujocoModel = std::unique_ptr<mjModel, void (*)(mjModel*)>;
using MujocoData = std::unique_ptr<mjData, void (*)(mjData*)>;

struct Verdict {
  int robots = 0, trees = 0, converted = 0, compiled = 0, agree = 0;
  double pose = 0, mass = 0, inertia = 0;
};

/// In a folder of its own, with its assets.
MujocoModel compile(const author::Conversion& result, std::string& complaint) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("rigor_mjcf_judge_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder / "assets");
  std::ofstream(folder / "robot.xml", std::ios::binary) << *result.text;
  for (const convert::SideFile& file : result.files) {
    std::ofstream(folder / file.name, std::ios::binary) << file.bytes;
  }
  std::array<char, 1000> error{};
  MujocoModel model(mj_loadXML((folder / "scene.xml").c_str(), nullptr, error.data(), error.size()),
                    mj_deleteModel);
  std::filesystem::remove_all(folder);
  if (!model) complaint = error.data();
  return model;
}

double apart(const model::Vector3& a, const mjtNum* b) {
  return std::max({std::abs(a.x - b[0]), std::abs(a.y - b[1]), std::abs(a.z - b[2])});
}

/// Half the angle between them, rad; a quaternion and its negative are one rotation.
double turned(const model::Quaternion& a, const mjtNum* b) {
  const model::Quaternion d = conjugate(a) * model::Quaternion{b[0], b[1], b[2], b[3]};
  return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

class Held {
 public:
  Held(const Robot& robot, const author::Conversion& result, mjModel& model)
      : robot_(robot),
        result_(result),
        model_(model),
        data_(mj_makeData(&model), mj_deleteData),
        X_WM_(robot.X_WM.value_or(Pose{})) {
    for (const convert::Note& note : result.account.notes) {
      own_masses_ = own_masses_ && note.kind != convert::NoteKind::kMjcfInertiaMoved &&
                    note.kind != convert::NoteKind::kMjcfMassless;
    }
  }

  bool hold(const std::string& name, Verdict& verdict) {
    worst_ = {};
    for (const robot::Positions& positions : robot::configurations(robot_, kPositions)) {
      hold_poses(positions);
    }
    hold_masses();
    hold_joints();
    EXPECT_LE(worst_.pose, kAgreement) << name;
    EXPECT_LE(worst_.mass, kAgreement) << name;
    EXPECT_LE(worst_.inertia, kAgreement) << name;
    EXPECT_EQ(wrong_, "") << name;
    verdict.pose = std::max(verdict.pose, worst_.pose);
    verdict.mass = std::max(verdict.mass, worst_.mass);
    verdict.inertia = std::max(verdict.inertia, worst_.inertia);
    return worst_.pose <= kAgreement && worst_.mass <= kAgreement && worst_.inertia <= kAgreement &&
           wrong_.empty();
  }

 private:
  bool is_static() const { return robot_.is_static.value_or(false); }

  int joint_id(std::size_t j, std::size_t k) const {
    const auto names = result_.names.joints.find(robot_.joints[j].name);
    if (names == result_.names.joints.end() || k >= names->second.size()) return -1;
    return mj_name2id(&model_, mjOBJ_JOINT, names->second[k].c_str());
  }

  void hold_poses(robot::Positions positions) {
    mj_resetData(&model_, data_.get());
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      for (std::size_t k = 0; k < positions[j].size(); ++k) {
        if (is_static()) positions[j][k] = 0;
        const int id = joint_id(j, k);
        if (id >= 0) data_->qpos[model_.jnt_qposadr[id]] = positions[j][k];
      }
    }
    mj_kinematics(&model_, data_.get());
    const std::vector<Pose> X_MB = robot::body_poses(robot_, positions);
    mass::Inertia second;
    model::Vector3 first;
    double mass = 0;
    for (std::size_t i = 0; i < robot_.bodies.size(); ++i) {
      if (robot_.bodies[i].name == robot::kWorldBody) continue;
      const int id = mj_name2id(&model_, mjOBJ_BODY, robot_.bodies[i].name.c_str());
      if (id < 0) {
        wrong_ = "no body " + robot_.bodies[i].name;
        return;
      }
      const Pose X_WB = compose(X_WM_, X_MB[i]);
      const double scale = std::max(1.0, model::length(X_WB.translation));
      worst_.pose = std::max({worst_.pose, apart(X_WB.translation, data_->xpos + 3 * id) / scale,
                              turned(X_WB.rotation, data_->xquat + 4 * id)});
      const mass::MassProperties body = theirs(id);
      const Pose X_W{{data_->xpos[3 * id], data_->xpos[3 * id + 1], data_->xpos[3 * id + 2]},
                     {data_->xquat[4 * id], data_->xquat[4 * id + 1], data_->xquat[4 * id + 2],
                      data_->xquat[4 * id + 3]}};
      const mass::MassProperties placed = mass::transformed(X_W, body);
      mass += placed.mass;
      first = first + placed.mass * placed.com;
      second = second + mass::about_origin(placed);
    }
    hold_sums(X_MB, mass, first, second);
  }

  void hold_sums(const std::vector<Pose>& X_MB, double mass, const model::Vector3& first,
                 const mass::Inertia& second) {
    std::vector<Pose> X_WB;
    for (const Pose& X : X_MB) X_WB.push_back(compose(X_WM_, X));
    const robot::Moments wanted = robot::moments(robot_, X_WB);
    if (!(wanted.mass > 0)) return;
    worst_.mass = std::max(worst_.mass, std::abs(wanted.mass - mass) / wanted.mass);
    const double reach = std::max(1.0, model::length(wanted.first) / wanted.mass);
    worst_.mass =
        std::max(worst_.mass, model::length(wanted.first - first) / (wanted.mass * reach));
    const mass::Inertia off = wanted.second - second;
    const double size = std::max(std::abs(mass::trace(wanted.second)), 1e-12);
    for (const double each : {off.ixx, off.ixy, off.ixz, off.iyy, off.iyz, off.izz}) {
      worst_.inertia = std::max(worst_.inertia, std::abs(each) / size);
    }
  }

  mass::MassProperties theirs(int id) const {
    const mjtNum* I = model_.body_inertia + 3 * id;
    const mjtNum* q = model_.body_iquat + 4 * id;
    const mjtNum* p = model_.body_ipos + 3 * id;
    return {
        model_.body_mass[id],
        {p[0], p[1], p[2]},
        mass::rotated(model::normalized({q[0], q[1], q[2], q[3]}), {I[0], 0, 0, I[1], 0, I[2]})};
  }

  void hold_masses() {
    if (!own_masses_) return;  // their sums are held
    for (const robot::Body& body : robot_.bodies) {
      const int id = mj_name2id(&model_, mjOBJ_BODY, body.name.c_str());
      if (id <= 0 || body.mass.mass == 0) continue;
      const mass::MassProperties seen = theirs(id);
      const double share = std::abs(seen.mass - body.mass.mass) / body.mass.mass;
      worst_.mass = std::max({worst_.mass, share, model::length(seen.com - body.mass.com)});
      const mass::Inertia off = seen.about_com - body.mass.about_com;
      const double size = std::max(mass::trace(body.mass.about_com), 1e-5 * body.mass.mass);
      for (const double each : {off.ixx, off.ixy, off.ixz, off.iyy, off.iyz, off.izz}) {
        worst_.inertia = std::max(worst_.inertia, std::abs(each) / size);
      }
    }
  }

  void hold_joints() {
    if (is_static()) return;
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      const robot::Joint& joint = robot_.joints[j];
      if (joint.axes.empty()) continue;
      const int id = joint_id(j, 0);
      if (id < 0) {
        wrong_ = "no joint " + joint.name;
        return;
      }
      hold_axis(joint, joint.axes[0], id);
    }
  }

  static bool near(double a, double b) {
    return std::abs(a - b) <= kAgreement * std::max({1.0, std::abs(a), std::abs(b)});
  }

  void hold_axis(const robot::Joint& joint, const robot::Axis& axis, int id) {
    const bool slides = joint.type == JointType::kPrismatic;
    if (model_.jnt_type[id] != (slides ? mjJNT_SLIDE : mjJNT_HINGE)) wrong_ = joint.name + ": type";
    if (apart(axis.direction, model_.jnt_axis + 3 * id) > kAgreement)
      wrong_ = joint.name + ": axis";
    const int dof = model_.jnt_dofadr[id];
    if (!near(std::max(axis.damping, 0.0), model_.dof_damping[dof]))
      wrong_ = joint.name + ": damping";
    if (!near(std::max(axis.friction, 0.0), model_.dof_frictionloss[dof])) {
      wrong_ = joint.name + ": friction";
    }
    if (!near(axis.spring_stiffness, model_.jnt_stiffness[id])) wrong_ = joint.name + ": spring";
    const bool limited = axis.lower < axis.upper && axis.lower > -1e10 && axis.upper < 1e10;
    if (limited) {
      const mjtNum* range = model_.jnt_range + 2 * id;
      const bool same =
          model_.jnt_limited[id] && near(range[0], axis.lower) && near(range[1], axis.upper);
      if (!same) wrong_ = joint.name + ": range";
    }
    const int actuator = mj_name2id(&model_, mjOBJ_ACTUATOR, joint.name.c_str());
    const bool drives =
        std::isfinite(axis.effort) && axis.effort > 0 && !axis.follow && axis.lower != axis.upper;
    if (drives && actuator < 0) wrong_ = joint.name + ": no actuator";
    if (drives && actuator >= 0) {
      const mjtNum* range = model_.actuator_ctrlrange + 2 * actuator;
      const bool same = model_.actuator_ctrllimited[actuator] && near(range[0], -axis.effort) &&
                        near(range[1], axis.effort) && model_.actuator_gear[6 * actuator] == 1;
      if (!same) wrong_ = joint.name + ": actuator range";
    }
  }

  const Robot& robot_;
  const author::Conversion& result_;
  mjModel& model_;
  MujocoData data_;
  Pose X_WM_;
  bool own_masses_ = true;
  Verdict worst_;
  std::string wrong_;
};

bool is_plain_tree(const Robot& robot) {
  return robot.unknown.empty() && !robot.bodies.empty() &&
         std::all_of(robot.joints.begin(), robot.joints.end(), [](const robot::Joint& joint) {
           const bool plain = joint.type == JointType::kFixed ||
                              joint.type == JointType::kRevolute ||
                              joint.type == JointType::kPrismatic;
           return plain && !joint.closes_loop;
         });
}

struct Listed {
  std::string path;
  bool urdf = false;
};

/// What libsdformat calls valid, and urdfdom takes, by their verdicts in the corpus' list.
std::vector<Listed> valid_models() {
  std::vector<Listed> models;
  std::istringstream list(test::read_file(test::corpus() + "/MANIFEST.tsv"));
  for (std::string line; std::getline(list, line);) {
    const Words columns = split_at(line, '\t');
    if (columns.size() < 7) continue;
    const bool urdf = columns[0].ends_with(".urdf");
    const bool sdf = columns[5] == "sdf" || columns[5] == "gazebo";
    const bool valid =
        columns[6].starts_with("valid") || (urdf && columns.size() > 18 && columns[18] == "ok");
    if (valid && (urdf || sdf)) models.push_back({test::corpus() + '/' + columns[0], urdf});
  }
  return models;
}

std::string first_error(const author::Conversion& result) {
  for (const Diagnostic& found : result.diagnostics.list()) {
    if (found.severity == Severity::kError) return std::string(found.rule) + ": " + found.message;
  }
  return "no text";
}

class Judge {
 public:
  void judge(const Listed& listed, Verdict& verdict) {
    const std::string name = listed.path.substr(test::corpus().size() + 1);
    const std::string set = name.substr(0, name.find('/'));
    const Environment& environment =
        environments_.try_emplace(set, disk_, folders_[set]).first->second;
    Sources sources;
    read::Workspace workspace(disk_, sources);
    const read::Loaded loaded =
        read::load({workspace, environment.resolver, environment.sdf, environment.urdf},
                   workspace.open(listed.path));
    const model::Frames frames(loaded.root);
    mass::MeshSurveys surveys(disk_, {.workers = &environment.workers});
    robot::Lookups lookups = robot::lookups_in(loaded.root, workspace, environment.resolver);
    lookups.find_mesh = rules::mesh_finder(environment.resolver, sources, surveys);
    int of_file = 0;
    for (std::uint32_t i = 0; i < loaded.root.models.size() && of_file < kMaxOfAFile; ++i) {
      const model::Model& model = loaded.root.models[i];
      if (model.parent || model.merged) continue;
      const Robot robot = robot::robot_of(loaded.root, frames, {i}, lookups);
      ++verdict.robots;
      ++of_file;
      if (!is_plain_tree(robot)) continue;
      ++verdict.trees;
      mass::MeshReads reads(disk_, environment.workers);
      const author::Conversion result = author::to_mjcf(
          environment, sources, workspace, loaded,
          {.model = listed.urdf ? std::string() : model.name.value,
           .looks = view::looks_of(loaded.root, sources,
                                   view::files_of(environment.resolver, sources, reads))},
          {.out = "/nowhere/robot.xml"});
      hold(name + ' ' + model.name.value, robot, result, verdict);
    }
  }

 private:
  void hold(const std::string& name, const Robot& robot, const author::Conversion& result,
            Verdict& verdict) {
    if (!result.text || result.diagnostics.count(Severity::kError) > 0) {
      std::printf("not converted: %s: %s\n", name.c_str(), first_error(result).c_str());
      return;
    }
    ++verdict.converted;
    std::string complaint;
    const MujocoModel model = compile(result, complaint);
    EXPECT_TRUE(model) << name << ": " << complaint;
    if (!model) return;
    ++verdict.compiled;
    Held held(robot, result, *model);
    if (held.hold(name, verdict)) ++verdict.agree;
  }

  RealDisk disk_;
  std::map<std::string, read::SearchPaths> folders_ = oracle_folders();
  std::map<std::string, Environment> environments_;

  static std::map<std::string, read::SearchPaths> oracle_folders() {
    std::map<std::string, read::SearchPaths> folders;
    for (const Words& row : oracle_rows("model-paths.tsv")) {
      if (row.size() != 2 || row[0] == "set") continue;
      folders[row[0]].given.push_back({test::corpus() + "/" + row[1], "--model-path"});
    }
    return folders;
  }
};

TEST(CorpusMjcf, MujocoSeesTheSource) {
  RIGOR_NEEDS_CORPUS();
  Judge judge;
  std::map<bool, Verdict> verdicts;
  for (const Listed& listed : valid_models()) {
    if (test::in_part(listed.path)) judge.judge(listed, verdicts[listed.urdf]);
  }
  int trees = 0, converted = 0;
  for (const auto& [urdf, v] : verdicts) {
    std::printf(
        "%s: %d models, %d trees of one-degree joints, %d converted, %d compiled, %d agree; "
        "worst pose %.2g, mass %.2g, inertia %.2g\n",
        urdf ? "URDF" : "SDF", v.robots, v.trees, v.converted, v.compiled, v.agree, v.pose, v.mass,
        v.inertia);
    EXPECT_EQ(v.compiled, v.converted);
    EXPECT_EQ(v.agree, v.compiled);
    trees += v.trees;
    converted += v.converted;
  }
  EXPECT_GE(converted * 100, trees * 97);
}

}  // namespace
}  // namespace rigor::judge
