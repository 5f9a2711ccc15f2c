// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which simulator a plugin was built for, by the name of its library.

#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

namespace rigor::rules {

/// The plugins that Gazebo classic brings along, and those of gazebo_ros_pkgs.
inline bool is_of_gazebo_classic(std::string_view library) {
  // Those of gazebosim.org's comparison of features that new Gazebo has under another name, or not at all.
  static constexpr std::string_view kClassic[] = {"libActorPlugin.so",
                                                  "libActuatorPlugin.so",
                                                  "libArduCopterPlugin.so",
                                                  "libArrangePlugin.so",
                                                  "libAttachLightPlugin.so",
                                                  "libBlinkVisualPlugin.so",
                                                  "libBreakableJointPlugin.so",
                                                  "libBuoyancyPlugin.so",
                                                  "libCameraPlugin.so",
                                                  "libCartDemoPlugin.so",
                                                  "libCessnaPlugin.so",
                                                  "libContactPlugin.so",
                                                  "libContainPlugin.so",
                                                  "libDepthCameraPlugin.so",
                                                  "libDiffDrivePlugin.so",
                                                  "libElevatorPlugin.so",
                                                  "libFlashLightPlugin.so",
                                                  "libFollowerPlugin.so",
                                                  "libForceTorquePlugin.so",
                                                  "libGimbalSmall2dPlugin.so",
                                                  "libGpuRayPlugin.so",
                                                  "libGravityCompensationPlugin.so",
                                                  "libHarnessPlugin.so",
                                                  "libHydraDemoPlugin.so",
                                                  "libHydraPlugin.so",
                                                  "libImuSensorPlugin.so",
                                                  "libInitialVelocityPlugin.so",
                                                  "libJointControlPlugin.so",
                                                  "libJointTrajectoryPlugin.so",
                                                  "libJoyPlugin.so",
                                                  "libKeysToCmdVelPlugin.so",
                                                  "libKeysToJointsPlugin.so",
                                                  "libLedPlugin.so",
                                                  "libLiftDragPlugin.so",
                                                  "libLinearBatteryConsumerPlugin.so",
                                                  "libLinearBatteryPlugin.so",
                                                  "libLinkPlot3DPlugin.so",
                                                  "libMisalignmentPlugin.so",
                                                  "libMudPlugin.so",
                                                  "libPlaneDemoPlugin.so",
                                                  "libPressurePlugin.so",
                                                  "libRandomVelocityPlugin.so",
                                                  "libRayPlugin.so",
                                                  "libRaySensorNoisePlugin.so",
                                                  "libRegionEventBoxPlugin.so",
                                                  "libRubblePlugin.so",
                                                  "libSimpleTrackedVehiclePlugin.so",
                                                  "libSkidSteerDrivePlugin.so",
                                                  "libSonarPlugin.so",
                                                  "libSphereAtlasDemoPlugin.so",
                                                  "libStaticMapPlugin.so",
                                                  "libTouchPlugin.so",
                                                  "libTrackedVehiclePlugin.so",
                                                  "libTransporterPlugin.so",
                                                  "libVariableGearboxPlugin.so",
                                                  "libVehiclePlugin.so",
                                                  "libWheelSlipPlugin.so",
                                                  "libWheelTrackedVehiclePlugin.so",
                                                  "libWindPlugin.so"};
  return library.starts_with("libgazebo_ros_") ||
         std::find(std::begin(kClassic), std::end(kClassic), library) != std::end(kClassic);
}

/// A system of new Gazebo, under its name of today or as it was called when it was Ignition.
inline bool is_of_new_gazebo(std::string_view library) {
  if (library.starts_with("lib")) library.remove_prefix(3);
  return library.starts_with("gz-sim") || library.starts_with("ignition-gazebo") ||
         library.starts_with("gz_ros2_control") || library.starts_with("ign_ros2_control");
}

}  // namespace rigor::rules
