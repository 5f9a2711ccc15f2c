// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A new model from a template: its files as bytes, for somebody else to write.
//
//   if (const auto problem = name_problem(name)) return refuse(problem->what, problem->suggestion);
//   for (const ScaffoldFile& file : scaffold("diff-drive", name)) put(file.path, file.bytes);
//
// or a ROS 2 package of a robot:
//
//   if (const auto problem = ros2_name_problem(name)) return refuse(problem->what, problem->suggestion);
//   for (const ScaffoldFile& file : scaffold_ros2_package(name)) put(file.path, file.bytes);
//
// A template is a folder under templates/; what all models have is in its `common`, the package in `ros2`. The name
// takes the place of each @NAME@, in paths too. It needs no escaping anywhere, since only names that need none are
// taken.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::author {

/// "arm", "box", …
std::vector<std::string_view> template_names();

/// File names have 255 bytes, and topics and frames of ROS as many: there is to be room for what a
/// simulator puts before and behind.
inline constexpr std::size_t kMaxNameLength = 64;

struct NameProblem {
  std::string what;        ///< "begins with '2'"; lower case, no full stop
  std::string suggestion;  ///< a name that can be taken
};

/// What keeps a model from having this name: SDF, XML, Gazebo's topics, URIs, file systems, one of them
/// takes it otherwise. Letters, digits, _ and - can be taken.
std::optional<NameProblem> name_problem(std::string_view name);

struct ScaffoldFile {
  std::string path;  ///< from the model's folder: "model.sdf", "meshes/bollard.obj"
  std::string bytes;
};

/// In the order of their paths. Of a template that is not one of template_names(), none; the name must have
/// no problem.
std::vector<ScaffoldFile> scaffold(std::string_view model_template, std::string_view name);

/// What the name of a robot's description package ends with: "my_robot_description".
inline constexpr std::string_view kDescriptionSuffix = "_description";

/// What keeps a robot's package from having this name, without the suffix: what name_problem() says, and ROS 2's own
/// conventions (REP 144): lowercase letters, digits and single underscores, since it becomes names of topics, nodes
/// and frames.
std::optional<NameProblem> ros2_name_problem(std::string_view name);

/// The package NAME_description (package.xml format 3, ament_cmake) of a differential drive robot in xacro, with
/// ros2_control, a launch file, tests and hooks that call rigor; in the order of paths, which are from the package's
/// folder. The name is the robot's, without the suffix, and must have no problem.
std::vector<ScaffoldFile> scaffold_ros2_package(std::string_view name);

}  // namespace rigor::author
