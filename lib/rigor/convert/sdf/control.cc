// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/sdf/control.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/convert/xml_layout.h>
#include <rigor/convert/xml_writer.h>
#include <rigor/model/parameter.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>
#include <rigor/text/letter_case.h>
#include <rigor/text/path.h>
#include <rigor/write/numbers.h>

namespace rigor::convert {
namespace {

using model::Id;

using ParameterNames = std::array<std::string_view, 2>;

/// A plugin of Gazebo classic that drives wheels, and what it calls what DiffDrive of Gazebo Sim takes.
struct DrivePlugin {
  std::string_view library;
  ParameterNames left, right, separation, diameter;
};

/// What its parameters are called there, and in DiffDrive of Gazebo Sim, which takes them as they are.
constexpr std::pair<std::string_view, const char*> kDriveParameters[] = {
    {"commandTopic", "topic"},
    {"command_topic", "topic"},
    {"odometryTopic", "odom_topic"},
    {"odometry_topic", "odom_topic"},
    {"odometryFrame", "frame_id"},
    {"odometry_frame", "frame_id"},
    {"robotBaseFrame", "child_frame_id"},
    {"robot_base_frame", "child_frame_id"},
    {"updateRate", "odom_publish_frequency"},
    {"update_rate", "odom_publish_frequency"},
};

constexpr DrivePlugin kDrivePlugins[] = {
    {"gazebo_ros_diff_drive",
     {"leftJoint", "left_joint"},
     {"rightJoint", "right_joint"},
     {"wheelSeparation", "wheel_separation"},
     {"wheelDiameter", "wheel_diameter"}},
    {"gazebo_ros_skid_steer_drive",
     {"leftFrontJoint", "leftRearJoint"},
     {"rightFrontJoint", "rightRearJoint"},
     {"wheelSeparation"},
     {"wheelDiameter"}},
};

/// Parameters that only concern Gazebo classic's own way: the publisher of Gazebo Sim takes all joints, and
/// the robot's description comes as it always does.
constexpr std::string_view kIdleParameters[] = {"jointName",       "joint_name", "robotSimType",
                                                "legacyModeNS",    "robotParam", "robot_param",
                                                "robot_param_node"};

std::string library_of(xml::Element plugin) {
  const auto filename = plugin.attribute("filename");
  return filename ? std::string(filename->value()) : std::string();
}

bool is_ros_control(const std::string& library) {
  return library.find("gazebo_ros_control") != std::string::npos ||
         library.find("gazebo_ros2_control") != std::string::npos;
}

const DrivePlugin* drive_of(const std::string& library) {
  for (const DrivePlugin& drive : kDrivePlugins) {
    if (library.find(drive.library) != std::string::npos) return &drive;
  }
  return nullptr;
}

bool is_joint_states(const std::string& library) {
  return library.find("gazebo_ros_joint_state_publisher") != std::string::npos;
}

/// position, velocity or effort, of "hardware_interface/PositionJointInterface"; empty of none of these.
std::string interface_in(std::string_view text) {
  const std::string name = lowered(text);
  for (const char* known : {"position", "velocity", "effort"}) {
    if (name.find(known) != std::string::npos) return known;
  }
  return {};
}

const model::Parameter* first_named(const model::Parameters& parameters, std::string_view name) {
  for (const model::Parameter& one : parameters) {
    if (one.name == name) return &one;
    if (const auto* below = first_named(one.children, name)) return below;
  }
  return nullptr;
}

class ControlWriter {
 public:
  ControlWriter(SdfDraft& draft, std::vector<SideFile>& files)
      : draft_(draft), root_(draft.source.root), files_(files) {}

  void write() {
    find_joints();
    const bool gz = draft_.options.control == ControlPolicy::kGz;
    take_blocks(gz);
    if (gz) {
      write_gz();
    } else if (!interfaces_.empty() || controlled_) {
      write_ros2_control();
    }
  }

 private:
  const std::string* sdf_joint(std::string_view name) const {
    const Id<model::Joint> id = draft_.source.frames.names().find_joint({0}, std::string(name));
    if (!id || root_[id].type == model::JointType::kFixed) return nullptr;
    return draft_.joint(id) == nullptr ? nullptr : &draft_.tree.joint_names[id.value];
  }

  void find_joints() {
    for (std::size_t i = 0; i < root_.controlled_joints.size(); ++i) {
      const model::ControlledJoint& joint = root_.controlled_joints[i];
      const std::string* name = sdf_joint(joint.joint.value);
      if (name == nullptr) continue;
      const model::Parameter* written = first_named(
          joint.parameters, joint.ros2_control ? "command_interface" : "hardwareInterface");
      std::string interface;
      if (written != nullptr) {
        const auto* attribute = model::attribute(*written, "name");
        interface = interface_in(joint.ros2_control && attribute != nullptr ? attribute->value
                                                                            : written->value.value);
      }
      // ros_control's oldest form has it at the actuator.
      if (interface.empty() && !joint.ros2_control) interface = interface_of_actuator(joint);
      if (!interface.empty()) interfaces_.try_emplace(*name, interface);
    }
  }

  std::string interface_of_actuator(const model::ControlledJoint& joint) const {
    for (const model::Parameter& transmission : root_.transmissions) {
      const bool own = std::any_of(
          transmission.children.begin(), transmission.children.end(),
          [&joint](const model::Parameter& child) { return child.site.tag == joint.site.tag; });
      const auto* written = own ? first_named(transmission.children, "hardwareInterface") : nullptr;
      if (written != nullptr) return interface_in(written->value.value);
    }
    return {};
  }

  /// What the plugins and blocks that are written do not say.
  void lose(xml::Element element, std::string what) {
    draft_.ledger.lose(read::site_of(element), {.where = element.name_span(),
                                                .subject = model::subject(root_, root_.models[0]),
                                                .written = std::move(what)});
  }

  /// Neither a block nor a plugin has the gear between the actuator and the joint.
  void lose_gears(xml::Element transmission) {
    for (const xml::Element child : transmission.children()) {
      for (const xml::Element below : child.children()) {
        if (below.name() == "mechanicalReduction") lose_gear(below);
      }
      if (child.name() == "mechanicalReduction") lose_gear(child);
    }
  }
  void lose_gear(xml::Element reduction) {
    if (write::number_in(std::string(read::trimmed(reduction.text()))) == 1) return;
    lose(reduction, "a mechanicalReduction of " + std::string(read::trimmed(reduction.text())));
  }

  void lose_parameters(xml::Element plugin) {
    for (const xml::Element child : plugin.children()) {
      const bool idle = std::find(std::begin(kIdleParameters), std::end(kIdleParameters),
                                  child.name()) != std::end(kIdleParameters);
      if (!idle) lose(child, "plugin/" + std::string(child.name()));
    }
  }

  void note(xml::Element element, std::string written, std::string instead) {
    draft_.ledger.take_all(element, Outcome::kRewritten);
    draft_.ledger.note({.kind = NoteKind::kControl,
                        .outcome = Outcome::kRewritten,
                        .where = element.name_span(),
                        .subject = model::subject(root_, root_.models[0]),
                        .written = std::move(written),
                        .instead = std::move(instead)});
  }

  void take_blocks(bool gz) {
    const xml::Element robot = draft_.source.documents.element(root_.models[0].site);
    const std::string instead = gz ? "plugins of Gazebo Sim" : "a ros2_control block";
    for (const xml::Element child : robot.children()) {
      const bool block = child.name() == "transmission" || child.name() == "ros2_control";
      if (!block && child.name() != "gazebo") continue;
      if (block) {
        controlled_ = true;
        if (!gz && child.name() == "ros2_control") kept_blocks_.push_back(child);
        const auto name = child.attribute("name");
        lose_gears(child);
        note(child, std::string(child.name()) + ' ' + std::string(name ? name->value() : ""),
             instead);
        continue;
      }
      for (const xml::Element plugin : child.children()) {
        if (plugin.name() != "plugin" || !is_control(draft_.options.control, plugin)) continue;
        const std::string library = library_of(plugin);
        controlled_ = controlled_ || is_ros_control(library);
        joint_states_ = joint_states_ || is_joint_states(library);
        if (const DrivePlugin* drive = gz ? drive_of(library) : nullptr) add_drive(*drive, plugin);
        if (is_ros_control(library) || is_joint_states(library)) lose_parameters(plugin);
        note(plugin, "plugin " + library, instead);
      }
    }
  }

  // --- Gazebo Sim ---

  static void open_plugin(XmlWriter& out, std::string_view system, const char* name) {
    out.open("plugin", {{"filename", "gz-sim-" + std::string(system) + "-system"},
                        {"name", std::string("gz::sim::systems::") + name}});
  }

  void add_drive(const DrivePlugin& drive, xml::Element plugin) {
    XmlWriter out;
    open_plugin(out, "diff-drive", "DiffDrive");
    const auto value = [&plugin](const ParameterNames& names) {
      for (const std::string_view name : names) {
        if (const auto child = plugin.child(name)) return std::string(read::trimmed(child->text()));
      }
      return std::string();
    };
    const auto joints = [&](const char* side, const ParameterNames& names) {
      for (const std::string_view name : names) {
        const auto child = plugin.child(name);
        if (!child) continue;
        const std::string written(read::trimmed(child->text()));
        const std::string* joint = sdf_joint(written);
        out.text(side, joint != nullptr ? *joint : written);
        driven_.push_back(joint != nullptr ? *joint : written);
      }
    };
    joints("left_joint", drive.left);
    joints("right_joint", drive.right);
    if (const std::string text = value(drive.separation); !text.empty()) {
      out.text("wheel_separation", text);
    }
    if (const auto diameter = write::number_in(value(drive.diameter))) {
      out.text("wheel_radius", to_text(Number{*diameter / 2, {}}));
    }
    for (const xml::Element child : plugin.children()) {
      const auto* known = std::find_if(std::begin(kDriveParameters), std::end(kDriveParameters),
                                       [&](const auto& one) { return one.first == child.name(); });
      if (known != std::end(kDriveParameters)) {
        out.text(known->second, std::string(read::trimmed(child.text())));
      } else if (!is_one_of(child.name(),
                            {&drive.left, &drive.right, &drive.separation, &drive.diameter})) {
        lose(child, "plugin/" + std::string(child.name()));
      }
    }
    out.close();
    draft_.robot.raw.push_back(std::move(out).take());
  }

  static bool is_one_of(std::string_view name, std::initializer_list<const ParameterNames*> lists) {
    return std::any_of(lists.begin(), lists.end(), [name](const ParameterNames* names) {
      return std::find(names->begin(), names->end(), name) != names->end();
    });
  }

  void write_gz() {
    if (interfaces_.empty() && !controlled_ && !joint_states_) return;
    for (const auto& [joint, interface] : interfaces_) {
      if (std::find(driven_.begin(), driven_.end(), joint) != driven_.end()) continue;
      XmlWriter out;
      if (interface == "position") {
        open_plugin(out, "joint-position-controller", "JointPositionController");
        out.text("joint_name", joint);
        out.text("use_velocity_commands", "true");
      } else if (interface == "velocity") {
        open_plugin(out, "joint-controller", "JointController");
        out.text("joint_name", joint);
      } else {
        open_plugin(out, "apply-joint-force", "ApplyJointForce");
        out.text("joint_name", joint);
      }
      out.close();
      draft_.robot.raw.push_back(std::move(out).take());
    }
    XmlWriter out;
    open_plugin(out, "joint-state-publisher", "JointStatePublisher");
    out.close();
    draft_.robot.raw.push_back(std::move(out).take());
  }

  // --- ros2_control ---

  std::string stem() const {
    const std::string name(file_name(draft_.source.out));
    const std::string stem = name.substr(0, name.rfind('.'));
    return stem.empty() ? "robot" : stem;
  }

  void write_ros2_control() {
    const std::string controllers = stem() + ".controllers.yaml";
    XmlWriter plugin;
    plugin.open("plugin", {{"filename", "gz_ros2_control-system"},
                           {"name", "gz_ros2_control::GazeboSimROS2ControlPlugin"}});
    plugin.text("parameters", controllers);
    plugin.close();
    draft_.robot.raw.push_back(std::move(plugin).take());
    files_.push_back({stem() + ".ros2_control.xacro", block_text()});
    files_.push_back({controllers, controllers_text()});
  }

  /// For the robot description: `<xacro:include filename="…"/>`.
  std::string block_text() const {
    XmlWriter out;
    out.open("robot", {{"name", draft_.robot.name}});
    if (kept_blocks_.empty()) {
      out.open("ros2_control", {{"name", "GazeboSimSystem"}, {"type", "system"}});
      out.open("hardware");
      out.text("plugin", "gz_ros2_control/GazeboSimSystem");
      out.close();
      for (const auto& [joint, interface] : interfaces_) {
        out.open("joint", {{"name", joint}});
        out.empty("command_interface", {{"name", interface}});
        for (const char* state : {"position", "velocity", "effort"}) {
          out.empty("state_interface", {{"name", state}});
        }
        out.close();
      }
      out.close();
    }
    for (const xml::Element block : kept_blocks_) {
      out.raw(laid_out(draft_.source.documents.of(block.name_span().source), block));
    }
    out.close();
    return "<?xml version=\"1.0\"?>\n" + std::move(out).take();
  }

  std::string controllers_text() const {
    std::map<std::string, std::vector<std::string>> by_interface;
    for (const auto& [joint, interface] : interfaces_) by_interface[interface].push_back(joint);
    std::string text =
        "controller_manager:\n  ros__parameters:\n    update_rate: 100\n"
        "    joint_state_broadcaster:\n"
        "      type: joint_state_broadcaster/JointStateBroadcaster\n";
    for (const auto& [interface, joints] : by_interface) {
      text += "    " + interface + "_controller:\n" +
              "      type: forward_command_controller/ForwardCommandController\n";
    }
    for (const auto& [interface, joints] : by_interface) {
      text += '\n' + interface +
              "_controller:\n  ros__parameters:\n    interface_name: " + interface +
              "\n    joints:\n";
      for (const std::string& joint : joints) text += "      - \"" + joint + "\"\n";
    }
    return text;
  }

  SdfDraft& draft_;
  const model::Root& root_;
  std::vector<SideFile>& files_;
  std::map<std::string, std::string> interfaces_;  // of SDF's joints
  std::vector<std::string> driven_;                // by a plugin for wheels
  std::vector<xml::Element> kept_blocks_;
  bool controlled_ = false;
  bool joint_states_ = false;
};

}  // namespace

bool is_control(ControlPolicy policy, xml::Element plugin) {
  if (policy == ControlPolicy::kKeep) return false;
  const std::string library = library_of(plugin);
  if (is_ros_control(library)) return true;
  return policy == ControlPolicy::kGz && (drive_of(library) != nullptr || is_joint_states(library));
}

void add_control(SdfDraft& draft, std::vector<SideFile>& files) {
  if (draft.options.control == ControlPolicy::kKeep) return;
  ControlWriter(draft, files).write();
}

}  // namespace rigor::convert
