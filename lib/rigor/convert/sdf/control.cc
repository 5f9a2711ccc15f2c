// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/sdf/control.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/convert/xml_layout.h>
#include <rigor/convert/xml_writer.h>
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

/// position, velocity or effort, of "hardware_interface/PositionJointInterface"; empty for states and
/// interfaces of other packages.
std::vector<std::string> commands_of(std::string_view interface) {
  const std::string name = lowered(interface);
  if (name.ends_with("posveljointinterface")) return {"position", "velocity"};
  for (const char* known : {"position", "velocity", "effort"}) {
    if (name.find(known) != std::string::npos) return {known};
  }
  return {};
}

/// The result tells the states of all joints.
bool is_state(std::string_view interface) {
  return lowered(interface).ends_with("jointstateinterface");
}

std::string text_of(xml::Element element) { return std::string(read::trimmed(element.text())); }

std::string written_name(xml::Element element) {
  const auto name = element.attribute("name");
  return name ? std::string(read::trimmed(name->value())) : std::string();
}

class ControlWriter {
 public:
  ControlWriter(SdfDraft& draft, std::vector<SideFile>& files)
      : draft_(draft),
        root_(draft.source.root),
        files_(files),
        gz_(draft.options.control == ControlPolicy::kGz) {}

  void write() {
    if (!gz_) keep_blocks();
    take_blocks();
    if (gz_) {
      write_gz();
    } else if (!commands_.empty() || controlled_) {
      write_ros2_control();
    }
  }

 private:
  using Commands = std::vector<std::string>;

  Id<model::Joint> find_joint(std::string_view name) const {
    return draft_.source.frames.names().find_joint({0}, std::string(name));
  }

  const std::string* sdf_joint(std::string_view name) const {
    const Id<model::Joint> id = find_joint(name);
    if (!id || root_[id].type == model::JointType::kFixed) return nullptr;
    return draft_.joint(id) == nullptr ? nullptr : &draft_.tree.joint_names[id.value];
  }

  xml::Element robot_element() const {
    return draft_.source.documents.element(root_.models[0].site);
  }

  /// Blocks of ros2_control stay as they are, and are what drives their joints.
  void keep_blocks() {
    for (const xml::Element block : robot_element().children()) {
      if (block.name() != "ros2_control") continue;
      kept_blocks_.push_back(block);
      controlled_ = true;
      for (const xml::Element joint : block.children()) {
        const std::string* name =
            joint.name() == "joint" ? sdf_joint(written_name(joint)) : nullptr;
        if (name == nullptr) continue;
        kept_joints_.insert(*name);
        commands_.try_emplace(*name);
        for (const xml::Element interface : joint.children()) {
          if (interface.name() != "command_interface") continue;
          for (std::string& command : commands_of(written_name(interface))) {
            add_command(*name, std::move(command));
          }
        }
      }
    }
  }

  void add_command(const std::string& joint, std::string command) {
    Commands& all = commands_[joint];
    if (std::find(all.begin(), all.end(), command) == all.end()) all.push_back(std::move(command));
  }

  /// Whether the result has the command for a joint. A plugin of Gazebo Sim takes one for each joint, and a
  /// block that stays takes those that it has.
  bool take_command(const std::string& joint, const std::string& command) {
    Commands& all = commands_[joint];
    if (std::find(all.begin(), all.end(), command) != all.end()) return true;
    if ((gz_ && !all.empty()) || kept_joints_.contains(joint)) return false;
    all.push_back(command);
    return true;
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

  /// A part of a block that is not in the result, or all of it.
  struct Loss {
    xml::Element element;
    std::string what, why;  ///< "joint elbow", "does not exist"
  };

  void take_blocks() {
    for (const xml::Element child : robot_element().children()) {
      if (child.name() == "transmission" || (gz_ && child.name() == "ros2_control")) {
        take_block(child);
      } else if (child.name() == "ros2_control") {
        lose_gears(child);
        note(child, "ros2_control " + written_name(child), written_block());
      } else if (child.name() == "gazebo") {
        take_plugins(child);
      }
    }
  }

  std::string written_block() const {
    return gz_ ? "plugins of Gazebo Sim" : "a ros2_control block";
  }

  void take_plugins(xml::Element block) {
    for (const xml::Element plugin : block.children()) {
      if (plugin.name() != "plugin" || !is_control(draft_.options.control, plugin)) continue;
      const std::string library = library_of(plugin);
      controlled_ = controlled_ || is_ros_control(library);
      joint_states_ = joint_states_ || is_joint_states(library);
      if (const DrivePlugin* drive = gz_ ? drive_of(library) : nullptr) add_drive(*drive, plugin);
      if (is_ros_control(library) || is_joint_states(library)) lose_parameters(plugin);
      note(plugin, "plugin " + library,
           gz_ ? written_block() : std::string("the plugin of gz_ros2_control"));
    }
  }

  /// A transmission, or for Gazebo Sim a block of ros2_control: what of it drives no joint in the result is
  /// lost, and all of it when nothing does.
  void take_block(xml::Element block) {
    std::vector<Loss> losses;
    bool any = false;
    for (const xml::Element child : block.children()) {
      if (child.name() == "joint") {
        any = take_joint(block, child, losses) || any;
      } else if (child.name() == "gpio" || child.name() == "sensor") {
        losses.push_back({child, std::string(child.name()) + ' ' + written_name(child), {}});
      }
    }
    if (!any) {
      std::string why = "it names no joint";
      for (auto loss = losses.rbegin(); loss != losses.rend(); ++loss) {
        if (!loss->why.empty()) why = loss->what + ' ' + loss->why;  // of the first
      }
      lose_in_block(block, block, "is lost: " + why);
      return;
    }
    controlled_ = true;
    for (const Loss& loss : losses) {
      lose_in_block(block, loss.element,
                    "loses " + loss.what + (loss.why.empty() ? "" : ", which " + loss.why));
    }
    if (block.name() == "transmission") lose_coupling(block);
    lose_gears(block);
    note(block, std::string(block.name()) + ' ' + written_name(block), written_block());
  }

  /// Whether the result drives the joint as it says, in one way at least, or tells its state.
  bool take_joint(xml::Element block, xml::Element joint, std::vector<Loss>& losses) {
    const std::string what = "joint " + written_name(joint);
    const std::string* name = sdf_joint(written_name(joint));
    if (name == nullptr) {
      const bool exists = static_cast<bool>(find_joint(written_name(joint)));
      losses.push_back({joint, what, exists ? "does not move" : "does not exist"});
      return false;
    }
    const std::vector<xml::Element> interfaces = interfaces_of(block, joint);
    if (interfaces.empty()) {
      if (block.name() == "ros2_control") return true;  // its state
      losses.push_back({joint, what, "has no hardwareInterface"});
      return false;
    }
    bool any = false;
    for (const xml::Element interface : interfaces) {
      const std::string text =
          block.name() == "ros2_control" ? written_name(interface) : text_of(interface);
      any = take_interface(*name, interface, text, losses) || any;
    }
    return any;
  }

  bool take_interface(const std::string& joint, xml::Element interface, const std::string& text,
                      std::vector<Loss>& losses) {
    if (is_state(text)) return commands_.try_emplace(joint), true;
    const std::vector<std::string> wanted = commands_of(text);
    const std::string what = std::string(interface.name()) + ' ' + text + " of joint " + joint;
    if (wanted.empty()) {
      losses.push_back({interface, what, "is none of position, velocity and effort"});
      return false;
    }
    bool any = false;
    std::string missing;
    for (const std::string& command : wanted) {
      if (take_command(joint, command)) {
        any = true;
      } else {
        missing = gz_ ? "is not the " + commands_[joint].front() + " command that drives it"
                      : "is not in its ros2_control block";
      }
    }
    if (!missing.empty()) losses.push_back({interface, what, std::move(missing)});
    return any;
  }

  /// ros_control's oldest form has them at the actuator.
  static std::vector<xml::Element> interfaces_of(xml::Element block, xml::Element joint) {
    std::vector<xml::Element> found;
    const auto look_in = [&found](xml::Element parent, std::string_view name) {
      for (const xml::Element child : parent.children()) {
        if (child.name() == name) found.push_back(child);
      }
    };
    if (block.name() == "ros2_control") return look_in(joint, "command_interface"), found;
    look_in(joint, "hardwareInterface");
    if (!found.empty()) return found;
    for (const xml::Element child : block.children()) {
      if (child.name() == "actuator") look_in(child, "hardwareInterface");
    }
    return found;
  }

  void lose_in_block(xml::Element block, xml::Element element, std::string how) {
    const bool transmission = block.name() == "transmission";
    draft_.ledger.lose(read::site_of(element),
                       {.kind = transmission ? NoteKind::kTransmission : NoteKind::kRos2Control,
                        .outcome = Outcome::kLost,
                        .where = element.name_span(),
                        .subject = model::subject(root_, root_.models[0]),
                        .written = written_name(block),
                        .instead = std::move(how)});
  }

  /// What a transmission that is not simple does between its actuators and joints.
  void lose_coupling(xml::Element transmission) {
    const auto element = transmission.child("type");
    const auto attribute = transmission.attribute("type");
    if (!element && !attribute) return;
    const std::string type =
        element ? text_of(*element) : std::string(read::trimmed(attribute->value()));
    if (type.empty() || lowered(type).ends_with("simpletransmission")) return;
    const std::string how = "loses what its type does between actuators and joints: " + type;
    if (element) return lose_in_block(transmission, *element, how);
    draft_.ledger.take_value(attribute->value_span(), Outcome::kLost);
    draft_.ledger.note({.kind = NoteKind::kTransmission,
                        .outcome = Outcome::kLost,
                        .where = attribute->value_span(),
                        .subject = model::subject(root_, root_.models[0]),
                        .written = written_name(transmission),
                        .instead = how});
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
    if (commands_.empty() && !controlled_ && !joint_states_) return;
    for (const auto& [joint, commands] : commands_) {
      if (commands.empty()) continue;  // its state alone
      if (std::find(driven_.begin(), driven_.end(), joint) != driven_.end()) continue;
      const std::string& interface = commands.front();
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
    if (kept_blocks_.empty() || kept_joints_.size() < commands_.size()) {
      out.open("ros2_control", {{"name", block_name()}, {"type", "system"}});
      out.open("hardware");
      out.text("plugin", "gz_ros2_control/GazeboSimSystem");
      out.close();
      for (const auto& [joint, commands] : commands_) {
        if (kept_joints_.contains(joint)) continue;
        out.open("joint", {{"name", joint}});
        for (const std::string& command : commands) {
          out.empty("command_interface", {{"name", command}});
        }
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

  /// None that a block that stays has.
  std::string block_name() const {
    const std::string first = "GazeboSimSystem";
    std::string name = first;
    const auto is_taken = [&name](xml::Element block) { return written_name(block) == name; };
    for (int n = 2; std::any_of(kept_blocks_.begin(), kept_blocks_.end(), is_taken); ++n) {
      name = first + '_' + std::to_string(n);
    }
    return name;
  }

  std::string controllers_text() const {
    std::map<std::string, std::vector<std::string>> by_interface;
    for (const auto& [joint, commands] : commands_) {
      for (const std::string& command : commands) by_interface[command].push_back(joint);
    }
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
  const bool gz_;
  std::map<std::string, Commands> commands_;  // of SDF's joints
  std::set<std::string> kept_joints_;         // those of `kept_blocks_`
  std::vector<std::string> driven_;           // by a plugin for wheels
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
