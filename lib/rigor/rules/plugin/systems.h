// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The plugins that come with Gazebo and with gazebo_ros_pkgs: their libraries, the classes in them and
// the parameters that they read.
//
//   const GazeboSystem* system = gazebo_system(plugin.filename.value);  // null when it is not one
//   if (system != nullptr && has_word(system->required, "joint_name")) …

#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

namespace rigor::rules {

/// A library of new Gazebo. Words stand between blanks.
struct GazeboSystem {
  std::string_view library;     ///< without gz-sim- in front, and -system behind
  std::string_view classes;     ///< without gz::sim::systems:: in front
  std::string_view parameters;  ///< those it reads; empty when rigor does not know
  std::string_view required;    ///< those without which it does nothing
};

// As documented in the headers of gz-sim's systems, with those that the code reads beside.
inline constexpr GazeboSystem kGazeboSystems[] = {
    {"ackermann-steering", "AckermannSteering",
     "left_joint right_joint left_steering_joint right_steering_joint wheel_separation "
     "kingpin_width wheel_base steering_limit wheel_radius odom_publish_frequency min_velocity "
     "max_velocity min_acceleration max_acceleration min_jerk max_jerk topic sub_topic odom_topic "
     "tf_topic frame_id child_frame_id steering_only steer_p_gain use_actuator_msg "
     "actuator_number",
     "left_steering_joint right_steering_joint"},
    {"acoustic-comms", "AcousticComms", "", ""},
    {"advanced-lift-drag", "AdvancedLiftDrag", "", ""},
    {"air-pressure", "AirPressure", "", ""},
    {"air-speed", "AirSpeed", "", ""},
    {"altimeter", "Altimeter", "", ""},
    {"apply-joint-force", "ApplyJointForce", "joint_name", "joint_name"},
    {"apply-link-wrench", "ApplyLinkWrench", "", ""},
    {"breadcrumbs", "Breadcrumbs", "", ""},
    {"buoyancy", "Buoyancy", "", ""},
    {"buoyancy-engine", "BuoyancyEngine", "", ""},
    {"camera-video-recorder", "CameraVideoRecorder", "", ""},
    {"collada-world-exporter", "ColladaWorldExporter", "", ""},
    {"comms-endpoint", "CommsEndpoint", "", ""},
    {"contact", "Contact", "", ""},
    {"cpu-lidar", "CpuLidar", "", ""},
    {"detachable-joint", "DetachableJoint",
     "parent_link child_model child_link topic detach_topic attach_topic output_topic "
     "suppress_child_warning",
     "parent_link child_model child_link"},
    {"diff-drive", "DiffDrive",
     "left_joint right_joint wheel_separation wheel_radius odom_publish_frequency topic "
     "odom_topic tf_topic frame_id child_frame_id min_velocity max_velocity min_acceleration "
     "max_acceleration min_jerk max_jerk min_linear_velocity max_linear_velocity "
     "min_angular_velocity max_angular_velocity min_linear_acceleration "
     "max_linear_acceleration min_angular_acceleration max_angular_acceleration "
     "min_linear_jerk max_linear_jerk min_angular_jerk max_angular_jerk",
     "left_joint right_joint"},
    {"drive-to-pose-controller", "DriveToPoseController", "", ""},
    {"dvl", "DopplerVelocityLogSystem", "", ""},
    {"dynamic-detachable-joint", "", "", ""},
    {"elevator", "", "", ""},
    {"entity-semantics", "", "", ""},
    {"environment-preload", "", "", ""},
    {"environmental-sensor", "", "", ""},
    {"follow-actor", "FollowActor", "", ""},
    {"forcetorque", "ForceTorque", "", ""},
    {"free-space-explorer", "", "", ""},
    {"hydrodynamics", "Hydrodynamics", "", "link_name"},
    {"imu", "Imu", "", ""},
    {"joint-controller", "JointController",
     "joint_name use_force_commands use_actuator_msg actuator_number topic sub_topic "
     "initial_velocity p_gain i_gain d_gain i_max i_min cmd_max cmd_min cmd_offset "
     "disable_braking",
     "joint_name"},
    {"joint-position-controller", "JointPositionController",
     "joint_name joint_index use_actuator_msg actuator_number actuatorNumber p_gain i_gain "
     "d_gain i_max i_min cmd_max cmd_min cmd_offset use_velocity_commands topic sub_topic "
     "initial_position",
     "joint_name"},
    {"joint-state-publisher", "JointStatePublisher", "joint_name topic update_rate", ""},
    {"joint-trajectory-controller", "JointTrajectoryController",
     "topic use_header_start_time joint_name initial_position position_p_gain position_i_gain "
     "position_d_gain position_i_min position_i_max position_cmd_min position_cmd_max "
     "position_cmd_offset velocity_p_gain velocity_i_gain velocity_d_gain velocity_i_min "
     "velocity_i_max velocity_cmd_min velocity_cmd_max velocity_cmd_offset",
     ""},
    {"kinetic-energy-monitor", "KineticEnergyMonitor", "", ""},
    {"label", "Label", "", ""},
    {"led-plugin", "", "", ""},
    {"lens-flare", "LensFlare", "", ""},
    {"lift-drag", "LiftDrag",
     "link_name air_density area a0 cla cda cma alpha_stall cla_stall cda_stall cma_stall cp "
     "forward upward radial_symmetry control_joint_name control_joint_rad_to_cl cm_delta",
     "link_name"},
    {"lighter_than_air_dynamics", "LighterThanAirDynamics", "", ""},
    {"linearbatteryplugin", "LinearBatteryPlugin", "", ""},
    {"log", "LogRecord LogPlayback", "", ""},
    {"log-video-recorder", "LogVideoRecorder", "", ""},
    {"logical-camera", "LogicalCamera", "", ""},
    {"logicalaudiosensorplugin", "LogicalAudioSensorPlugin", "", ""},
    {"lookup-wheel-slip", "", "", ""},
    {"magnetometer", "Magnetometer", "", ""},
    {"mecanum-drive", "MecanumDrive",
     "front_left_joint front_right_joint back_left_joint back_right_joint wheelbase "
     "wheel_separation wheel_radius odom_publish_frequency topic odom_topic tf_topic frame_id "
     "child_frame_id min_velocity max_velocity min_acceleration max_acceleration min_jerk "
     "max_jerk min_linear_velocity max_linear_velocity min_angular_velocity "
     "max_angular_velocity min_linear_acceleration max_linear_acceleration "
     "min_angular_acceleration max_angular_acceleration min_linear_jerk max_linear_jerk "
     "min_angular_jerk max_angular_jerk",
     "front_left_joint front_right_joint back_left_joint back_right_joint"},
    {"model-photo-shoot", "ModelPhotoShoot", "", ""},
    {"multicopter-control", "MulticopterVelocityControl", "", ""},
    {"multicopter-motor-model", "MulticopterMotorModel",
     "robotNamespace jointName linkName turningDirection timeConstantUp timeConstantDown "
     "maxRotVelocity motorConstant momentConstant commandSubTopic motorNumber actuator_number "
     "rotorDragCoefficient rollingMomentCoefficient motorSpeedPubTopic "
     "rotorVelocitySlowdownSim motorType",
     "jointName linkName"},
    {"navsat", "NavSat", "", ""},
    {"odometry-publisher", "OdometryPublisher",
     "odom_frame robot_base_frame odom_publish_frequency odom_topic odom_covariance_topic "
     "tf_topic dimensions xyz_offset rpy_offset gaussian_noise",
     ""},
    {"opticaltactileplugin", "OpticalTactilePlugin", "", ""},
    {"particle-emitter", "ParticleEmitter", "", ""},
    {"particle-emitter2", "", "", ""},
    {"perfect-comms", "PerfectComms", "", ""},
    {"performer-detector", "PerformerDetector", "", ""},
    {"physics", "Physics", "", ""},
    {"pose-publisher", "PosePublisher",
     "publish_link_pose publish_visual_pose publish_collision_pose publish_sensor_pose "
     "publish_model_pose publish_nested_model_pose use_pose_vector_msg update_frequency "
     "static_publisher static_update_frequency topic",
     ""},
    {"python-system-loader", "PythonSystemLoader", "", ""},
    {"rf-comms", "RFComms", "", ""},
    {"scene-broadcaster", "SceneBroadcaster", "", ""},
    {"sensors", "Sensors", "", ""},
    {"shader-param", "ShaderParam", "", ""},
    {"spacecraft-thruster-model", "", "", ""},
    {"thermal", "Thermal", "", ""},
    {"thermal-sensor", "ThermalSensor", "", ""},
    {"thruster", "Thruster",
     "namespace topic joint_name use_angvel_cmd fluid_density propeller_diameter "
     "thrust_coefficient wake_fraction alpha_1 alpha_2 velocity_control p_gain i_gain d_gain "
     "max_thrust_cmd min_thrust_cmd deadband power_load battery_name link_name",
     "joint_name"},
    {"touchplugin", "TouchPlugin", "", ""},
    {"track-controller", "TrackController", "", "link"},
    {"tracked-vehicle", "TrackedVehicle", "", ""},
    {"trajectory-follower", "TrajectoryFollower", "", ""},
    {"triggered-publisher", "TriggeredPublisher", "", ""},
    {"user-commands", "UserCommands", "", ""},
    {"velocity-control", "VelocityControl", "", ""},
    {"wheel-slip", "WheelSlip", "", ""},
    {"wind-effects", "WindEffects", "", ""},
    {"websocket-server", "", "", ""},
};

/// Plugins of gazebo_ros_pkgs, without libgazebo_ros_ in front and .so behind.
inline constexpr std::string_view kGazeboRosPlugins[] = {
    "ackermann_drive",
    "api_plugin",
    "block_laser",
    "bumper",
    "camera",
    "camera_utils",
    "control",
    "depth_camera",
    "diff_drive",
    "elevator",
    "f3d",
    "factory",
    "force",
    "force_system",
    "ft_sensor",
    "gps_sensor",
    "gpu_laser",
    "hand_of_god",
    "harness",
    "imu",
    "imu_sensor",
    "init",
    "joint_pose_trajectory",
    "joint_state_publisher",
    "laser",
    "multicamera",
    "node",
    "openni_kinect",
    "p3d",
    "paths_plugin",
    "planar_move",
    "projector",
    "properties",
    "prosilica",
    "range",
    "ray_sensor",
    "skid_steer_drive",
    "state",
    "template",
    "tricycle_drive",
    "triggered_camera",
    "triggered_multicamera",
    "utils",
    "vacuum_gripper",
    "video",
    "wheel_slip",
};

/// Parameters of the gazebo_ros plugins that people port most, in the names of ROS 1 and ROS 2. New Gazebo
/// has systems that do the same, and read none of what only the old ones know.
struct GazeboRosParameters {
  std::string_view plugin;  ///< as in kGazeboRosPlugins
  std::string_view system;  ///< as in kGazeboSystems; empty when there is none
  std::string_view parameters;
};

inline constexpr GazeboRosParameters kGazeboRosParameters[] = {
    {
        "diff_drive",
        "diff-drive",
        "ros update_rate updateRate num_wheel_pairs left_joint right_joint leftJoint rightJoint "
        "wheel_separation wheelSeparation wheel_diameter wheelDiameter max_wheel_torque "
        "wheelTorque "
        "max_wheel_acceleration wheelAcceleration command_topic commandTopic odometry_topic "
        "odometryTopic odometry_frame odometryFrame robot_base_frame robotBaseFrame "
        "odometry_source "
        "odometrySource publish_odom publish_odom_tf publish_wheel_tf publishOdomTF publishWheelTF "
        "publishOdom publishWheelJointState publishTf publishTF rosDebugLevel robotNamespace "
        "covariance_x covariance_y covariance_yaw legacyMode alwaysOn always_on",
    },
    {"joint_state_publisher", "joint-state-publisher",
     "ros joint_name jointName update_rate updateRate robotNamespace rosDebugLevel alwaysOn"},
    {"p3d", "odometry-publisher",
     "ros update_rate updateRate body_name bodyName frame_name frameName topicName xyz_offset "
     "xyz_offsets rpy_offset rpy_offsets xyzOffset xyzOffsets rpyOffset rpyOffsets "
     "gaussian_noise gaussianNoise robotNamespace local_twist alwaysOn always_on"},
};

/// A plugin's filename in its parts.
struct SystemFile {
  std::string_view before;  ///< "lib", or the folders
  std::string_view prefix;  ///< "gz-sim-", "gz-sim8-", "ignition-gazebo-", "libgazebo_ros_"
  std::string_view name;    ///< what is left: "diff-drive-system", "diff_drive"
  std::string_view after;   ///< ".so"
};

/// Nothing when it is no file that could be of new Gazebo.
inline std::optional<SystemFile> system_file(std::string_view file) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  for (const std::string_view family :
       {std::string_view("gz-sim"), std::string_view("ignition-gazebo")}) {
    const std::size_t begin = file.find(family);
    if (begin == std::string_view::npos) continue;
    std::size_t end = begin + family.size();
    while (end < file.size() && is_digit(file[end])) ++end;
    if (end >= file.size() || file[end] != '-') continue;
    SystemFile parts{
        file.substr(0, begin), file.substr(begin, end + 1 - begin), file.substr(end + 1), {}};
    if (parts.name.ends_with(".so")) {
      parts.after = parts.name.substr(parts.name.size() - 3);
      parts.name.remove_suffix(3);
    }
    return parts;
  }
  return std::nullopt;
}

/// Which library a filename means, whatever version and spelling of lib and .so; null for none of these.
inline const GazeboSystem* gazebo_system(std::string_view file) {
  const auto parts = system_file(file);
  constexpr std::string_view kEnd = "-system";
  if (!parts || !parts->name.ends_with(kEnd)) return nullptr;
  const std::string_view library = parts->name.substr(0, parts->name.size() - kEnd.size());
  const auto* const found =
      std::find_if(std::begin(kGazeboSystems), std::end(kGazeboSystems),
                   [library](const GazeboSystem& system) { return system.library == library; });
  return found == std::end(kGazeboSystems) ? nullptr : found;
}

/// Calls `visit` with each word; stops when it says true, and says so.
template <class Visit>
bool some_word(std::string_view words, const Visit& visit) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (end > 0 && visit(words.substr(0, end))) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

inline bool has_word(std::string_view words, std::string_view word) {
  return some_word(words, [word](std::string_view other) { return other == word; });
}

}  // namespace rigor::rules
