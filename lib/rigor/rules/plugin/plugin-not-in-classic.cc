// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/plugin/simulator.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_not_in_classic {
namespace {

void check(const model::Plugin& plugin, Context& context) {
  const std::string& library = plugin.filename.value;
  if (!is_of_new_gazebo(library)) return;
  context.report(
      {.where = plugin.filename.span,
       .message = "'" + library + "' is a system of gz-sim: Gazebo classic cannot load it",
       .subject = context.subject(plugin)});
}

}  // namespace

Rule rule() {
  return {
      .name = "plugin-not-in-classic",
      .category = Category::kPlugin,
      .severity = Severity::kWarning,
      .targets = {Target::kGazeboClassic},
      .summary = "a system of gz-sim in a model for Gazebo classic",
      .why =
          "Gazebo classic loads libraries of its own kind only. It says that it cannot load this "
          "one, and goes on without what it would do.",
      .what_to_do =
          "Keep a file for each simulator, or use the plugin of Gazebo classic that does the "
          "same, such as libDiffDrivePlugin.so for gz-sim-diff-drive-system.",
      .bad = {{R"(<sdf version="1.6">
  <model name="arm">
    <link name="base">
      <collision name="c">
        <geometry><sphere><radius>1</radius></sphere></geometry>
      </collision>
    </link>
    <plugin name="gz::sim::systems::DiffDrive" filename="«gz-sim-diff-drive-system»">
    </plugin>
  </model>
</sdf>
)"},
              {R"(<robot name="arm">
  <link name="base">
    <inertial>
      <mass value="1"/>
      <inertia ixx="0.4" ixy="0" ixz="0" iyy="0.4" iyz="0" izz="0.4"/>
    </inertial>
  </link>
  <gazebo>
    <plugin name="control" filename="«libgz_ros2_control-system.so»"/>
  </gazebo>
</robot>
)"}},
      .good = {{R"(<sdf version="1.6">
  <model name="arm">
    <link name="base">
      <collision name="c">
        <geometry><sphere><radius>1</radius></sphere></geometry>
      </collision>
    </link>
    <plugin name="drive" filename="libDiffDrivePlugin.so">
    </plugin>
  </model>
</sdf>
)"}},
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_not_in_classic
