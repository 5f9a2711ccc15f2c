// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <string>

#include <rigor/read/load.h>
#include <rigor/read/values.h>
#include <rigor/rules/environment.h>

namespace rigor::read {
namespace {

/// What a file of that text holds; its one source is the text.
model::Root root_of(const std::string& name, const std::string& text) {
  MemoryDisk disk;
  disk.put(name, text);
  const Environment environment(disk, {});
  Sources sources;
  Workspace workspace(disk, sources);
  const Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
  return load(reader, workspace.open(name)).root;
}

std::string bytes(const std::string& text, Span span) {
  return text.substr(span.begin, span.size());
}

const std::string kRobot =
    "<robot name='arm'><link name='a'/><link name='b'/>"
    "<joint name='j' type='continuous'><parent link='a'/><child link='b'/></joint>"
    "<gazebo reference='a'><mu1> 0.5 </mu1><plugin name='p' filename='p.so'>"
    "<topic> /cmd </topic><pid kind='full'><p>1</p><i/></pid></plugin></gazebo>"
    "<transmission name='t'><joint name='j'><hardwareInterface>x</hardwareInterface></joint>"
    "<actuator name='m'><mechanicalReduction>50</mechanicalReduction></actuator></transmission>"
    "<ros2_control name='c'><hardware><plugin>h/H</plugin></hardware>"
    "<joint name='j'><command_interface name='effort'/></joint></ros2_control>"
    "<mujoco><compiler meshdir='m'/></mujoco></robot>";

TEST(Parameters, AreATreeThatKnowsItsPlaces) {
  const model::Root root = root_of("arm.urdf", kRobot);
  ASSERT_EQ(root.plugins.size(), 1U);
  const model::Parameters& given = root.plugins[0].parameters;
  ASSERT_EQ(given.size(), 2U);
  const model::Parameter* topic = find(given, "topic");
  ASSERT_NE(topic, nullptr);
  EXPECT_EQ(topic->value.value, "/cmd");
  EXPECT_EQ(bytes(kRobot, topic->value.span), " /cmd ");
  EXPECT_EQ(bytes(kRobot, topic->site.name), "topic");
  const model::Parameter* pid = find(given, "pid");
  ASSERT_NE(pid, nullptr);
  ASSERT_NE(attribute(*pid, "kind"), nullptr);
  EXPECT_EQ(bytes(kRobot, attribute(*pid, "kind")->span), "full");
  ASSERT_EQ(pid->children.size(), 2U);
  EXPECT_EQ(number_field(pid->children[0]).value, 1);
  EXPECT_FALSE(number_field(pid->children[1]).written);
  EXPECT_EQ(find(given, "absent"), nullptr);
}

TEST(Parameters, OfBlocksThatNoFormatDefines) {
  const model::Root root = root_of("arm.urdf", kRobot);
  ASSERT_EQ(root.gazebo_blocks.size(), 1U);
  ASSERT_EQ(root.gazebo_blocks[0].content.size(), 1U) << "without the plugin";
  EXPECT_EQ(number_field(root.gazebo_blocks[0].content[0]).value, 0.5);
  ASSERT_EQ(root.transmissions.size(), 1U);
  EXPECT_NE(find(root.transmissions[0].children, "actuator"), nullptr);
  ASSERT_EQ(root.ros2_controls.size(), 1U);
  EXPECT_NE(find(root.ros2_controls[0].children, "hardware"), nullptr);
  ASSERT_EQ(root.controlled_joints.size(), 2U);
  EXPECT_NE(find(root.controlled_joints[0].parameters, "hardwareInterface"), nullptr);
  EXPECT_FALSE(root.controlled_joints[0].ros2_control);
  EXPECT_NE(find(root.controlled_joints[1].parameters, "command_interface"), nullptr);
  EXPECT_TRUE(root.controlled_joints[1].ros2_control);
  ASSERT_NE(find(root.mujoco, "compiler"), nullptr);
}

TEST(Typed, WhatSensorsAndSurfacesSay) {
  const model::Root root = root_of(
      "m.sdf",
      "<sdf version='1.9'><model name='m'><self_collide>1</self_collide><link name='l'>"
      "<collision name='c'><surface><friction><ode><fdir1>0 1 0</fdir1></ode></friction>"
      "<contact><collide_bitmask>1</collide_bitmask><ode><min_depth>0.01</min_depth></ode>"
      "</contact></surface></collision>"
      "<visual name='v'><transparency>0.3</transparency><material><emissive>1 0 0 1</emissive>"
      "<pbr/></material></visual>"
      "<sensor name='s' type='lidar'><gz_frame_id>f</gz_frame_id><lidar><scan>"
      "<horizontal><samples>9</samples><min_angle>-1</min_angle></horizontal>"
      "<vertical><max_angle>2</max_angle></vertical></scan>"
      "<noise><stddev>-3</stddev></noise></lidar></sensor></link></model></sdf>");
  EXPECT_TRUE(root.models.at(0).self_collide.value);
  EXPECT_FALSE(root.links.at(0).self_collide.written);
  const model::Surface& surface = root.collisions.at(0).surface;
  EXPECT_EQ(surface.fdir1.value, (model::Vector3{0, 1, 0}));
  EXPECT_TRUE(surface.chooses_contacts);
  EXPECT_EQ(surface.min_depth.value, 0.01);
  const model::Visual& visual = root.visuals.at(0);
  EXPECT_EQ(visual.transparency.value, 0.3);
  EXPECT_TRUE(visual.material.has_color);
  EXPECT_FALSE(visual.material.pbr.span.nowhere());
  const model::Sensor& sensor = root.sensors.at(0);
  ASSERT_TRUE(sensor.lidar);
  EXPECT_EQ(sensor.lidar->horizontal.samples.value, 9);
  EXPECT_EQ(sensor.lidar->horizontal.min_angle.value, -1);
  EXPECT_EQ(sensor.lidar->vertical.max_angle.value, 2);
  EXPECT_EQ(sensor.lidar->noises.at(0).stddev.value, -3);
  EXPECT_EQ(sensor.frames.at(0).value, "f");
  EXPECT_FALSE(sensor.settings.empty());
}

TEST(Parameters, ABlockForGazeboIsEmptyWithoutAnyElement) {
  const auto is_empty = [](const std::string& content) {
    return root_of("a.urdf", "<robot name='a'><link name='l'/><gazebo reference='l'>" + content +
                                 "</gazebo></robot>")
        .gazebo_blocks.at(0)
        .empty;
  };
  EXPECT_TRUE(is_empty("<!-- later -->"));
  EXPECT_FALSE(is_empty("<mu1>1</mu1>"));
  EXPECT_FALSE(is_empty("<plugin name='p' filename='p.so'/>"));
  EXPECT_FALSE(is_empty("<sensor name='s' type='imu'/>"));
}

std::vector<double> deviations(const std::vector<model::Noise>& noises) {
  std::vector<double> all;
  for (const model::Noise& noise : noises) all.push_back(noise.stddev.value);
  return all;
}

TEST(Parameters, NoisesOfAnImuAreOfWhatIsMeasured) {
  const auto imu_of = [](const std::string& version, const std::string& imu) {
    return root_of("a.sdf", "<sdf version='" + version + "'><model name='m'><link name='l'>" +
                                "<sensor name='s' type='imu'><imu>" + imu +
                                "</imu></sensor></link></model></sdf>")
        .sensors.at(0);
  };
  const auto axis = [](const std::string& name, const std::string& stddev) {
    return "<" + name + "><noise type='gaussian'><stddev>" + stddev + "</stddev></noise></" + name +
           ">";
  };
  const model::Sensor each = imu_of(
      "1.9", "<linear_acceleration>" + axis("x", "4") + "</linear_acceleration>" +
                 "<angular_velocity>" + axis("x", "1") + axis("z", "3") + "</angular_velocity>");
  EXPECT_EQ(deviations(each.angular_velocity_noises), (std::vector<double>{1, 3}));
  EXPECT_EQ(deviations(each.linear_acceleration_noises), (std::vector<double>{4}));
  EXPECT_EQ(each.settings, (std::vector<std::string>{"imu"}));
  const model::Sensor old = imu_of("1.4",
                                   "<noise><accel><stddev>6</stddev></accel><rate>"
                                   "<stddev>5</stddev></rate></noise>");
  EXPECT_EQ(deviations(old.angular_velocity_noises), (std::vector<double>{5}));
  EXPECT_EQ(deviations(old.linear_acceleration_noises), (std::vector<double>{6}));
}

TEST(Parameters, StatesOfAWorldNameTheirModels) {
  const model::Root root =
      root_of("a.sdf",
              "<sdf version='1.6'><world name='w'><light name='sun' type='point'/>"
              "<state world_name='w'><model name='box'/><light name='sun'/><model/></state>"
              "<state world_name='w'><insertions/></state></world></sdf>");
  const model::World& world = root.worlds.at(0);
  EXPECT_EQ(world.names, (std::vector<std::string>{"sun"})) << "the states have none";
  ASSERT_EQ(world.states.size(), 2U);
  ASSERT_EQ(world.states[0].models.size(), 2U);
  EXPECT_EQ(world.states[0].models[0].name.value, "box");
  EXPECT_FALSE(world.states[0].models[1].name.written);
  EXPECT_FALSE(world.states[0].inserts);
  EXPECT_TRUE(world.states[1].inserts);
}

}  // namespace
}  // namespace rigor::read
