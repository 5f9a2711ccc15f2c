// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Robots out of texts, and one arm in both formats, for tests of comparisons.

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/read/load.h>
#include <rigor/robot/compare.h>
#include <rigor/robot/lookups.h>
#include <rigor/schema/embedded.h>

namespace rigor::test {

/// The first model of the text.
inline robot::Robot robot_from(const std::string& text) {
  static const auto sdf =
      std::get<schema::Schema>(schema::Schema::parse(schema::sdf_schema_text()));
  static const auto urdf =
      std::get<schema::Schema>(schema::Schema::parse(schema::urdf_schema_text()));
  const std::string path = text.find("<sdf") == std::string::npos ? "a.urdf" : "a.sdf";
  const MemoryDisk disk(std::map<std::string, std::string>{{path, text}});
  const read::Resolver resolver(disk, {});
  Sources sources;
  read::Workspace workspace(disk, sources);
  const read::Loaded loaded = read::load({workspace, resolver, sdf, urdf}, workspace.open(path));
  EXPECT_FALSE(loaded.root.models.empty()) << text;
  if (loaded.root.models.empty()) return {};
  const model::Frames frames(loaded.root);
  return robot_of(loaded.root, frames, {0}, robot::lookups_in(loaded.root, workspace, resolver));
}

/// With the first `from` replaced, which there is.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// As `rigor diff` compares.
inline std::vector<robot::Difference> all_differences(const std::string& a, const std::string& b) {
  return compare(robot_from(a), robot_from(b),
                 {.helpers = robot::Helpers::kReported, .placement = robot::Placement::kReported});
}

/// "joint-moved joint elbow", one for each.
inline std::vector<std::string> told(const std::vector<robot::Difference>& differences) {
  std::vector<std::string> lines;
  for (const robot::Difference& d : differences) {
    lines.push_back(std::string(to_string(d.kind)) + " " + (d.a.empty() ? d.b : d.a));
  }
  return lines;
}

/// A shoulder, an elbow, a finger that follows the elbow, and a tool that is a mere frame.
inline const std::string kArmUrdf = R"(<robot name="arm">
<material name="blue"><color rgba="0.1 0.2 0.8 0.9"/></material>
<link name="base">
  <inertial><origin xyz="0.01 0.02 0.03" rpy="0.1 0.2 0.3"/><mass value="2"/>
    <inertia ixx="0.1" ixy="0.01" ixz="0.02" iyy="0.12" iyz="0.03" izz="0.14"/></inertial>
  <collision name="c"><origin xyz="0.1 0.2 0.3" rpy="0.4 0.5 0.6"/>
    <geometry><box size="0.2 0.3 0.1"/></geometry></collision>
</link>
<link name="upper">
  <inertial><origin xyz="0 0 0.25"/><mass value="1.5"/>
    <inertia ixx="0.02" ixy="0.001" ixz="0.002" iyy="0.021" iyz="0.003" izz="0.03"/></inertial>
  <visual name="v"><origin xyz="0 0 0.25" rpy="0 0 0.7"/>
    <geometry><cylinder radius="0.04" length="0.5"/></geometry><material name="blue"/></visual>
  <visual name="w"><geometry><mesh filename="w.stl" scale="1 2 3"/></geometry></visual>
</link>
<link name="fore">
  <inertial><origin xyz="0.1 0 0.2"/><mass value="0.5"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.012" iyz="0" izz="0.015"/></inertial>
  <collision name="ball"><geometry><sphere radius="0.05"/></geometry></collision>
</link>
<link name="finger">
  <inertial><origin xyz="0 0 0.01"/><mass value="0.1"/>
    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.0012" iyz="0" izz="0.0015"/></inertial>
</link>
<link name="tool"/>
<joint name="shoulder" type="revolute"><origin xyz="0 0 0.1" rpy="0.1 0.2 0.3"/>
  <parent link="base"/><child link="upper"/><axis xyz="0.48 0.6 0.64"/>
  <limit lower="-1.5" upper="1.6" effort="10" velocity="2"/>
  <dynamics damping="0.1" friction="0.2"/></joint>
<joint name="elbow" type="continuous"><origin xyz="0 0 0.5" rpy="0 0 0.5"/>
  <parent link="upper"/><child link="fore"/><axis xyz="0 1 0"/></joint>
<joint name="slide" type="prismatic"><origin xyz="0 0.1 0.4"/>
  <parent link="fore"/><child link="finger"/><axis xyz="1 0 0"/>
  <limit lower="0.01" upper="0.05" effort="5" velocity="0.3"/>
  <mimic joint="elbow" multiplier="0.5" offset="0.02"/></joint>
<joint name="flange" type="fixed"><origin xyz="0 0 0.4" rpy="0.3 0 0"/>
  <parent link="fore"/><child link="tool"/></joint>
</robot>
)";

/// The same arm: link frames elsewhere, the elbow by limits that are none, the tool and its joint as frames, the
/// mimic with a reference: 0.5 (q - 0.1) + 0.07.
inline const std::string kArmSdf = R"(<sdf version="1.11"><model name="arm">
<link name="base">
  <inertial><pose>0.01 0.02 0.03 0.1 0.2 0.3</pose><mass>2</mass><inertia><ixx>0.1</ixx>
    <ixy>0.01</ixy><ixz>0.02</ixz><iyy>0.12</iyy><iyz>0.03</iyz><izz>0.14</izz></inertia></inertial>
  <collision name="c"><pose>0.1 0.2 0.3 0.4 0.5 0.6</pose>
    <geometry><box><size>0.2 0.3 0.1</size></box></geometry></collision>
</link>
<link name="upper"><pose relative_to="shoulder">0 0 0.25 0 0 0.7</pose>
  <inertial><pose>0 0 0 0 0 -0.7</pose><mass>1.5</mass><inertia><ixx>0.02</ixx><ixy>0.001</ixy>
    <ixz>0.002</ixz><iyy>0.021</iyy><iyz>0.003</iyz><izz>0.03</izz></inertia></inertial>
  <visual name="v"><geometry><cylinder><radius>0.04</radius><length>0.5</length></cylinder></geometry>
    <material><ambient>0.05 0.1 0.4 1</ambient><diffuse>0.1 0.2 0.8 0.9</diffuse></material></visual>
  <visual name="w"><pose relative_to="shoulder"/>
    <geometry><mesh><uri>w.stl</uri><scale>1 2 3</scale></mesh></geometry></visual>
</link>
<link name="fore"><pose relative_to="elbow"/>
  <inertial><pose>0.1 0 0.2 0 0 0</pose><mass>0.5</mass>
    <inertia><ixx>0.01</ixx><iyy>0.012</iyy><izz>0.015</izz></inertia></inertial>
  <collision name="ball"><geometry><sphere><radius>0.05</radius></sphere></geometry></collision>
</link>
<link name="finger"><pose relative_to="slide">1 2 3 0 0 0</pose>
  <inertial><pose>-1 -2 -2.99 0 0 0</pose><mass>0.1</mass>
    <inertia><ixx>0.001</ixx><iyy>0.0012</iyy><izz>0.0015</izz></inertia></inertial>
</link>
<frame name="flange" attached_to="fore"><pose>0 0 0.40 0.30 0 0</pose></frame>
<frame name="tool" attached_to="fore"><pose>0 0 0.4 0.3 0 0</pose></frame>
<joint name="shoulder" type="revolute"><pose relative_to="base">0 0 0.1 0.1 0.2 0.3</pose>
  <parent>base</parent><child>upper</child><axis><xyz>0.96 1.2 1.28</xyz>
  <limit><lower>-1.5</lower><upper>1.6</upper><effort>10</effort><velocity>2</velocity></limit>
  <dynamics><damping>0.1</damping><friction>0.2</friction></dynamics></axis></joint>
<joint name="elbow" type="revolute"><pose relative_to="shoulder">0 0 0.5 0 0 0.5</pose>
  <parent>upper</parent><child>fore</child><axis><xyz>0 1 0</xyz>
  <limit><lower>-1e16</lower><upper>inf</upper><effort>-1</effort><velocity>1e16</velocity></limit>
  </axis></joint>
<joint name="slide" type="prismatic"><pose relative_to="elbow">0 0.1 0.4 0 0 0</pose>
  <parent>fore</parent><child>finger</child><axis><xyz>1 0 0</xyz>
  <limit><lower>0.01</lower><upper>0.05</upper><effort>5</effort><velocity>0.3</velocity></limit>
  <mimic joint="elbow"><multiplier>0.5</multiplier><offset>0.07</offset><reference>0.1</reference></mimic>
  </axis></joint>
</model></sdf>
)";

}  // namespace rigor::test
