// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The tutorial's robot, with the inertias of its shapes, driven by MuJoCo as by `simulate`: the same
// bodies, shapes and commands, another engine. Built where MuJoCo is installed.

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>

#include <fmt/core.h>

#include <rigor/simulate/run.h>
#include <rigor/simulate/stage.h>
#include <rigor/simulate/test/tests.h>
#include <rigor/simulate/wheels.h>
#include <simulate/fault_suite.h>

#include "support/workers.h"

namespace rigor::simulate {
namespace {

std::string three(const Vector3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

std::string placed(const Pose& X) {
  const Quaternion& q = X.rotation;
  return fmt::format("pos=\"{}\" quat=\"{} {} {} {}\"", three(X.translation), q.w, q.x, q.y, q.z);
}

/// A shape in MuJoCo's words: half sizes. The smaller friction of a pair counts here and the larger one
/// there, but for the geom of higher priority: so one without friction has it.
std::string geom(const SceneShape& shape) {
  std::string kind;
  if (const auto* box = std::get_if<mesh::Box>(&shape.kind)) {
    kind = fmt::format("type=\"box\" size=\"{}\"", three(0.5 * box->size));
  } else if (const auto* sphere = std::get_if<mesh::Sphere>(&shape.kind)) {
    kind = fmt::format("type=\"sphere\" size=\"{}\"", sphere->radius);
  } else if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape.kind)) {
    kind = fmt::format("type=\"cylinder\" size=\"{} {}\"", cylinder->radius, cylinder->length / 2);
  } else {
    ADD_FAILURE() << shape.name << " has a shape that this test does not know";
  }
  return fmt::format("<geom {} {} friction=\"{} 0.005 0.0001\" priority=\"{}\"/>\n", kind,
                     placed(shape.X_BS), std::max(shape.surface.mu, 1e-6),
                     shape.surface.mu < 1 ? 1 : 0);
}

class Mjcf {
 public:
  explicit Mjcf(const Scene& scene) : scene_(scene) {}

  std::string text() const {
    std::string out = fmt::format(
        "<mujoco><option timestep=\"{}\" gravity=\"{}\" cone=\"elliptic\"/>\n"
        "<default><geom condim=\"3\"/></default><worldbody>\n"
        "<geom type=\"plane\" size=\"0 0 1\" friction=\"1 0.005 0.0001\"/>\n",
        scene_.solver.step, three(scene_.gravity));
    const std::uint32_t base = scene_.models.front().base;
    out += body(base, scene_.bodies[base].X_WB, "<freejoint/>\n");
    return out + "</worldbody></mujoco>\n";
  }

 private:
  std::string body(std::uint32_t index, const Pose& X, const std::string& joint) const {
    const SceneBody& b = scene_.bodies[index];
    const mass::Inertia& i = b.mass.about_com;
    std::string out = fmt::format(
        "<body name=\"b{}\" {}>\n{}<inertial pos=\"{}\" mass=\"{}\" "
        "fullinertia=\"{} {} {} {} {} {}\"/>\n",
        index, placed(X), joint, three(b.mass.com), b.mass.mass, i.ixx, i.iyy, i.izz, i.ixy, i.ixz,
        i.iyz);
    for (const SceneShape& shape : scene_.shapes) {
      if (shape.body == index) out += geom(shape);
    }
    for (std::uint32_t j = 0; j < scene_.joints.size(); ++j) {
      const SceneJoint& child = scene_.joints[j];
      if (child.parent != index) continue;
      const Pose X_WC = scene_.bodies[child.child].X_WB;
      const Pose X_CW = inverse(X_WC);
      out += body(child.child, compose(inverse(b.X_WB), X_WC),
                  fmt::format("<joint name=\"j{}\" type=\"hinge\" axis=\"{}\" pos=\"{}\"/>\n", j,
                              three(rotate(X_CW.rotation, child.axes[0].direction_W)),
                              three(transform(X_CW, child.anchor_W))));
    }
    return out + "</body>\n";
  }

  const Scene& scene_;
};

/// The velocity that a command asks for at a time; nothing when it is not active.
double commanded(const Scenario& scenario, std::uint32_t joint, double time) {
  double value = 0;
  for (const Command& command : scenario.commands) {
    if (command.joint != joint || time < command.begin || time >= command.end) continue;
    const double since = time - command.begin;
    value = command.ramp > 0 ? command.value * std::min(1.0, since / command.ramp) : command.value;
  }
  return value;
}

/// How stiffly a wheel follows its command, N·m·s/rad: about what a step of 1 ms lets a wheel of 0.5 kg
/// follow without trembling, so that it lags behind its ramp by a hundredth.
constexpr double kFollow = 3;

TEST(SimulateJudge, MujocoDrivesTheTutorialsRobotAsFar) {
  const test::SuiteModel model("sane/diff_drive.sdf");
  const SceneResult made = build_scene(model.input(), {});
  ASSERT_FALSE(made.blocked());
  const MadeTest drive = make_test("drive", made.scene, find_wheels(made.scene, {}));
  ASSERT_TRUE(drive.scenario) << drive.why_not;
  const Scene scene = stage(made.scene, *drive.scenario);
  const Record record = run_isolated(scene, *drive.scenario, scene.solver, test::workers());
  ASSERT_EQ(record.end, Record::End::kDone) << record.message;
  const std::uint32_t base = scene.models.front().base;
  const Vector3 ours = record.final.bodies[base].p_WBcm;

  const std::string path =
      (std::filesystem::temp_directory_path() / fmt::format("rigor-{}.xml", ::getpid())).string();
  std::ofstream(path) << Mjcf(scene).text();
  char error[1000] = "";
  const std::unique_ptr<mjModel, void (*)(mjModel*)> mujoco(
      mj_loadXML(path.c_str(), nullptr, error, sizeof error), mj_deleteModel);
  std::filesystem::remove(path);
  ASSERT_NE(mujoco, nullptr) << error;
  const std::unique_ptr<mjData, void (*)(mjData*)> data(mj_makeData(mujoco.get()), mj_deleteData);
  while (data->time < drive.scenario->duration - scene.solver.step / 2) {
    for (int j = 1; j < mujoco->njnt; ++j) {
      const auto joint =
          static_cast<std::uint32_t>(std::stoul(mj_id2name(mujoco.get(), mjOBJ_JOINT, j) + 1));
      const int dof = mujoco->jnt_dofadr[j];
      data->qfrc_applied[dof] =
          kFollow * (commanded(*drive.scenario, joint, data->time) - data->qvel[dof]);
    }
    mj_step(mujoco.get(), data.get());
  }
  mj_kinematics(mujoco.get(), data.get());
  const int body = mj_name2id(mujoco.get(), mjOBJ_BODY, fmt::format("b{}", base).c_str());
  const mjtNum* p = data->xipos + 3 * body;
  const Vector3 begin = transform(scene.bodies[base].X_WB, scene.bodies[base].mass.com);
  const double way = length(ours - begin);
  EXPECT_GT(way, 1);
  EXPECT_NEAR(p[0], ours.x, 0.02 * way);
  EXPECT_NEAR(p[1], ours.y, 0.02 * way);
  EXPECT_NEAR(p[2], ours.z, 0.02 * way);
}

}  // namespace
}  // namespace rigor::simulate
