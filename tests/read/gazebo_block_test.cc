// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <map>
#include <string>

#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>

namespace rigor::read {
namespace {

const std::string kBlocks =
    "<robot name='arm'>"
    "<gazebo reference='tip'><sensor name='eye' type='camera'><pose>0 0 1 0 0 0</pose>"
    "<update_rate>30</update_rate><camera><image><width>64</width></image></camera>"
    "<plugin name='p' filename='libp.so'/></sensor></gazebo>"
    "<link name='base'/><link name='tip'/>"
    "<joint name='wrist' type='fixed'><parent link='base'/><child link='tip'/>"
    "<origin xyz='2 0 0' rpy='0 0 0'/></joint>"
    "<gazebo reference='wrist'><sensor name='load' type='force_torque'/></gazebo>"
    "<gazebo><plugin name='q' filename='libq.so'/><sensor name='lost' type='imu'/></gazebo>"
    "</robot>";

/// The robot above, read.
struct BlockRobot {
  BlockRobot() : disk({{"arm.urdf", kBlocks}}), environment(disk, {}), workspace(disk, sources) {
    const Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
    loaded = load(reader, workspace.open("arm.urdf"));
  }
  const model::Root& root() const { return loaded.root; }

  MemoryDisk disk;
  Environment environment;
  Sources sources;
  Workspace workspace;
  Loaded loaded;
};

TEST(GazeboBlock, HoldsSensorsAsSdfDoes) {
  const BlockRobot robot;
  ASSERT_EQ(robot.root().sensors.size(), 3U);
  const model::Sensor& eye = robot.root().sensors[0];
  EXPECT_EQ(eye.name.value, "eye");
  EXPECT_EQ(eye.type.value, "camera");
  EXPECT_EQ(eye.update_rate.value, 30);
  ASSERT_EQ(eye.cameras.size(), 1U);
  EXPECT_EQ(eye.cameras[0].width.value, 64);
  EXPECT_EQ(kBlocks.substr(eye.update_rate.span.begin, eye.update_rate.span.size()), "30");
}

TEST(GazeboBlock, BelongsToTheLinkItRefersToWhereverThatStands) {
  const BlockRobot robot;
  const model::Root& root = robot.root();
  ASSERT_TRUE(root.sensors[0].link);
  EXPECT_EQ(root[root.sensors[0].link].name.value, "tip");
  EXPECT_TRUE(root[root.sensors[0].link].sensors.empty()) << "the link does not hold it itself";
  EXPECT_FALSE(root.sensors[1].link) << "a joint's";
  EXPECT_FALSE(root.sensors[2].link) << "nobody's";
  // The tip is 2 m along x of the base, the eye 1 m above the tip.
  const model::Frames frames(root);
  EXPECT_EQ(frames.pose(model::Id<model::Sensor>{0})->translation, (model::Vector3{2, 0, 1}));
}

TEST(GazeboBlock, HoldsPluginsAndThoseOfItsSensors) {
  const BlockRobot robot;
  const model::Root& root = robot.root();
  ASSERT_EQ(root.plugins.size(), 2U);
  for (const model::Plugin& plugin : root.plugins) {
    EXPECT_EQ(plugin.filename.value == "libp.so", static_cast<bool>(plugin.sensor));
    EXPECT_EQ(plugin.filename.value == "libq.so", static_cast<bool>(plugin.model));
    EXPECT_EQ(plugin.gazebo_reference, plugin.sensor ? "tip" : "");
  }
}

/// libsdformat's GetKeyValueAsString; `simulate` and all else that asks a block reads it here.
TEST(GazeboBlock, TakesAnAttributeForTheValueOfAKey) {
  MemoryDisk disk(std::map<std::string, std::string>{
      {"a.urdf",
       "<robot name='a'><link name='l'/><gazebo reference='l'><mu1 value=' 0.2 '/>"
       "<kp value='3'>4</kp><kd>5</kd></gazebo></robot>"}});
  const Environment environment(disk, {});
  Sources sources;
  Workspace workspace(disk, sources);
  const Loaded loaded = load({workspace, environment.resolver, environment.sdf, environment.urdf},
                             workspace.open("a.urdf"));
  const model::Parameters& keys = loaded.root.gazebo_blocks.at(0).content;
  ASSERT_EQ(keys.size(), 3U);
  EXPECT_EQ(keys[0].value.value, "0.2");
  EXPECT_EQ(keys[1].value.value, "3");
  EXPECT_EQ(keys[2].value.value, "5");
}

}  // namespace
}  // namespace rigor::read
