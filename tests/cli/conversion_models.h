// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Small robots for the tests of `rigor sdf2urdf` and `rigor urdf2sdf`.

#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/program.h"

namespace rigor::test {

inline std::string link_named(const std::string& name) {
  return "<link name='" + name +
         "'><inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>"
         "</inertial></link>";
}

inline std::string arm(const std::string& joint_type, const std::string& more = "") {
  return "<sdf version='1.9'><model name='arm'>" + link_named("base") + link_named("tip") +
         "<joint name='elbow' type='" + joint_type +
         "'><pose relative_to='base'>0 0 0.50 0 0 0</pose><parent>base</parent><child>tip</child>"
         "<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper><effort>5</effort>"
         "<velocity>2</velocity></limit></axis></joint>" +
         more + "</model></sdf>";
}

/// With the arm in its folder.
class ConversionCli : public testing::Test {
 protected:
  void SetUp() override { folder.put("arm.sdf", arm("revolute")); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder.path(name)); }

  Folder folder;
};

inline std::string urdf_link(const std::string& name, const std::string& izz = "1") {
  return "<link name='" + name +
         "'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='" +
         izz + "'/></inertial></link>";
}

inline std::string urdf_joint(const std::string& name, const std::string& type,
                              const std::string& parent, const std::string& child,
                              const std::string& more = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/>" + more + "</joint>";
}

}  // namespace rigor::test
