// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/add/add.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/verbs/add/add_template.h>
#include <rigor/author/verbs/add/wheel_layout.h>
#include <rigor/author/verbs/block.h>
#include <rigor/author/verbs/draft.h>
#include <rigor/rules/world/sensor_systems.h>
#include <rigor/schema/value.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

enum class AdditionKind {
  kSensor,
  kJointSensor,
  kPlugin,
  kDrive,
  kJointPlugin,
  kControl,
  kTransmission
};

struct Addition {
  std::string_view name;
  AdditionKind kind;
  int since = 0;  ///< the first SDF 1.x that has it
};

constexpr Addition kAdditions[] = {
    {"camera", AdditionKind::kSensor},
    {"depth_camera", AdditionKind::kSensor, 6},
    {"rgbd_camera", AdditionKind::kSensor, 6},
    {"imu", AdditionKind::kSensor},
    {"lidar", AdditionKind::kSensor, 6},
    {"contact", AdditionKind::kSensor},
    {"force_torque", AdditionKind::kJointSensor, 4},
    {"gps", AdditionKind::kSensor, 3},
    {"altimeter", AdditionKind::kSensor, 5},
    {"magnetometer", AdditionKind::kSensor, 5},
    {"diff-drive", AdditionKind::kDrive},
    {"ackermann", AdditionKind::kDrive},
    {"joint-state-publisher", AdditionKind::kPlugin},
    {"joint-position-controller", AdditionKind::kJointPlugin},
    {"odometry-publisher", AdditionKind::kPlugin},
    {"pose-publisher", AdditionKind::kPlugin},
    {"ros2_control", AdditionKind::kControl},
    {"transmission", AdditionKind::kTransmission},
};

constexpr int kLastInClassic = 7;
constexpr int kFirstWithNavsat = 7;  // of SDF 1.x; called gps before

/// Measured lengths, in m, and angles: as a person would write them.
std::string rounded(double value) {
  constexpr double kMicro = 1e6;
  return schema::to_shortest(std::round(value * kMicro) / kMicro);
}

bool moves(const model::Joint& joint) {
  return joint.type == model::JointType::kRevolute || joint.type == model::JointType::kContinuous ||
         joint.type == model::JointType::kPrismatic;
}

bool follows_another(const model::Joint& joint) {
  return !joint.axes.empty() && joint.axes.front().mimic.has_value();
}

std::string indented_lines(std::string text) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 3)
    text.insert(at + 1, "  ");
  return "  " + text;
}

class Adder {
 public:
  Adder(const EditedModel& edited, const AddRequest& request, const Addition& addition)
      : edited_(edited), request_(request), addition_(addition), draft_(edited) {}

  Change add() {
    std::string refused = fill();
    if (!refused.empty()) return refusal(std::move(refused));
    Change change;
    change.steps = draft_.take();
    change.expected = edited_.robot;
    change.notes = std::move(notes_);
    change.asks_for_setting = [](const robot::Difference& difference) {
      return difference.kind == robot::DifferenceKind::kAttachmentOnlyInB || difference.a.empty();
    };
    return change;
  }

 private:
  /// Why nothing is added; empty when something is.
  std::string fill() {
    const bool is_ros =
        addition_.kind == AdditionKind::kControl || addition_.kind == AdditionKind::kTransmission;
    target_ = rules::to_string(
        request_.target.value_or(is_ros ? rules::Target::kRos : rules::Target::kGzSim));
    const auto text = add_template(target_, addition_.name);
    if (!text) return fmt::format("there is no {} for the target {}", addition_.name, target_);
    text_ = *text;
    const int version = edited_.root()[edited_.model].version;
    if (!edited_.is_urdf() && version < addition_.since) {
      return fmt::format("SDF has {} since 1.{}, and the file is 1.{}: upgrade it first",
                         addition_.name, addition_.since, version);
    }
    if (!edited_.is_urdf() && is_for_classic() && version > kLastInClassic) {
      return fmt::format("Gazebo classic reads SDF up to 1.{}, and the file is 1.{}",
                         kLastInClassic, version);
    }
    switch (addition_.kind) {
      case AdditionKind::kSensor: return sensor();
      case AdditionKind::kJointSensor: return joint_sensor();
      case AdditionKind::kPlugin: return plugin();
      case AdditionKind::kDrive: return drive();
      case AdditionKind::kJointPlugin: return joint_plugins();
      case AdditionKind::kControl: return control();
      case AdditionKind::kTransmission: return transmissions();
    }
    return {};
  }

  bool is_for_classic() const { return target_ == to_string(rules::Target::kGazeboClassic); }

  // --- Sensors ---

  std::string sensor() {
    const model::Id<model::Link> id = edited_.link(request_.to);
    if (!id) return fmt::format("no link is named '{}'", request_.to);
    const model::Link& holder = edited_.root()[id];
    if (!edited_.root().own(holder.site)) return "the link is in a file that is included";
    TemplateValues values = sensor_values();
    values["LINK"] = {xml::escaped(holder.name.value)};
    if (addition_.name == "contact") {
      values["COLLISION"] = collisions(holder);
      if (values["COLLISION"].empty()) return "the link has no collision to watch";
    }
    insert_at(holder.site, holder.name.value, filled(text_, values));
    return {};
  }

  /// Names as they are in SDF: there a URDF's that has none is called so by libsdformat.
  std::vector<std::string> collisions(const model::Link& link) const {
    std::vector<std::string> names;
    for (const model::Id<model::Collision> id : link.collisions) {
      std::string name = edited_.root()[id].name.value;
      if (name.empty()) {
        name = link.name.value + "_collision";
        if (!names.empty()) name += fmt::format("_{}", names.size());
      }
      names.push_back(xml::escaped(name));
    }
    return names;
  }

  std::string joint_sensor() {
    const model::Id<model::Joint> id = edited_.joint(request_.to);
    if (!id) return fmt::format("no joint is named '{}'", request_.to);
    const model::Joint& holder = edited_.root()[id];
    if (!edited_.root().own(holder.site)) return "the joint is in a file that is included";
    TemplateValues values = sensor_values();
    const std::uint32_t joint = edited_.joint_index(request_.to);
    if (joint != robot::kNoIndex)
      values["CHILD"] = {
          xml::escaped(edited_.robot.bodies[edited_.robot.joints[joint].child].name)};
    std::string text = filled(text_, values);
    // libsdformat lumps what a fixed joint connects, and the sensor would be gone.
    if (edited_.is_urdf() && holder.type == model::JointType::kFixed)
      text = "<preserveFixedJoint>true</preserveFixedJoint>\n" + text;
    insert_at(holder.site, holder.name.value, text);
    return {};
  }

  TemplateValues sensor_values() {
    const auto is_taken = [&](const std::string& name) {
      return std::any_of(edited_.root().sensors.begin(), edited_.root().sensors.end(),
                         [&](const model::Sensor& each) { return each.name.value == name; });
    };
    std::string name(addition_.name);
    for (int i = 2; is_taken(name); ++i) name = fmt::format("{}_{}", addition_.name, i);
    TemplateValues values;
    values["NAME"] = {name};
    if (!(request_.X == model::Pose{}))
      values["POSE"] = {xyz_text(request_.X) + ' ' + rpy_text(request_.X)};
    const bool has_navsat =
        edited_.is_urdf() || edited_.root()[edited_.model].version >= kFirstWithNavsat;
    values["TYPE"] = {has_navsat ? "navsat" : "gps"};
    note_systems();
    return values;
  }

  void note_systems() {
    if (is_for_classic()) return;
    const std::string type = addition_.name == "lidar" ? "gpu_lidar" : std::string(addition_.name);
    if (const rules::SensorSystem* system = rules::sensor_system(type)) {
      notes_.push_back(fmt::format("the world has to load gz-sim-{}-system (gz::sim::systems::{})",
                                   system->library, system->name));
    }
    if (type == "gps") notes_.push_back("the world has to have <spherical_coordinates>");
  }

  void insert_at(const model::Site& site, const std::string& name, const std::string& text) {
    if (edited_.is_urdf()) {
      insert_in_model(fmt::format("<gazebo reference=\"{}\">\n{}\n</gazebo>", xml::escaped(name),
                                  indented_lines(text)));
    } else {
      const xml::Element element = edited_.element(site);
      draft_.insert(element, last_child_of(element), text);
    }
  }

  void insert_in_model(const std::string& text) {
    const xml::Element model = edited_.element(edited_.root()[edited_.model].site);
    draft_.insert(model, last_child_of(model), text);
  }

  // --- Plugins ---

  void insert_plugins(const std::string& text) {
    insert_in_model(edited_.is_urdf() ? "<gazebo>\n" + indented_lines(text) + "\n</gazebo>" : text);
  }

  std::string base() const {
    for (const robot::Body& body : edited_.robot.bodies) {
      if (body.carrier == robot::kNoIndex) return xml::escaped(body.name);
    }
    return {};
  }

  std::string plugin() {
    TemplateValues values;
    values["BASE"] = {base()};
    for (const model::Joint* joint : joints()) values["MOVING_JOINT"].push_back(name_of(*joint));
    const bool has_joints = !values["MOVING_JOINT"].empty();
    if (addition_.name == "joint-state-publisher" && !has_joints) return "no joint moves";
    values["DIMENSIONS"] = {wheel_layout(edited_).problem.empty() ? "2" : "3"};
    insert_plugins(filled(text_, values));
    return {};
  }

  std::string drive() {
    const WheelLayout layout = wheel_layout(edited_);
    if (!layout.problem.empty()) return layout.problem;
    TemplateValues values;
    for (const std::string& joint : layout.left) values["LEFT"].push_back(xml::escaped(joint));
    for (const std::string& joint : layout.right) values["RIGHT"].push_back(xml::escaped(joint));
    values["SEPARATION"] = {rounded(layout.separation)};
    values["RADIUS"] = {rounded(layout.radius)};
    const std::size_t pairs = layout.left.size();
    if (pairs > 1) values["PAIRS"] = {std::to_string(pairs)};
    values["SEPARATION_OF_PAIR"].assign(pairs, rounded(layout.separation));
    values["DIAMETER_OF_PAIR"].assign(pairs, rounded(2 * layout.radius));
    values["BASE"] = {base()};
    if (addition_.name == "ackermann") {
      if (!layout.steering) {
        return "no pair of wheels is steered: each behind a revolute joint of its own about z";
      }
      const SteeringLayout& steering = *layout.steering;
      values["LEFT_STEERING"] = {xml::escaped(steering.left)};
      values["RIGHT_STEERING"] = {xml::escaped(steering.right)};
      values["KINGPIN"] = {rounded(steering.kingpin)};
      values["WHEEL_BASE"] = {rounded(steering.wheel_base)};
      if (std::isfinite(steering.limit)) values["STEERING_LIMIT"] = {rounded(steering.limit)};
    }
    notes_.push_back(fmt::format("wheels: radius {} m, {} m apart", rounded(layout.radius),
                                 rounded(layout.separation)));
    insert_plugins(filled(text_, values));
    return {};
  }

  /// Of the file itself, those that move by a command; the one that is asked for.
  std::vector<const model::Joint*> joints() const {
    std::vector<const model::Joint*> found;
    for (const model::Joint& joint : edited_.root().joints) {
      const bool is_own = edited_.root().own(joint.site) && joint.model == edited_.model;
      const bool is_asked = request_.to.empty() || joint.name.value == request_.to;
      if (is_own && is_asked && moves(joint)) found.push_back(&joint);
    }
    return found;
  }

  std::string no_joint() const {
    return request_.to.empty() ? "no joint moves"
                               : fmt::format("no joint named '{}' moves", request_.to);
  }

  static std::string name_of(const model::Joint& joint) { return xml::escaped(joint.name.value); }

  std::string joint_plugins() {
    std::string text;
    for (const model::Joint* joint : joints()) {
      if (follows_another(*joint)) continue;
      TemplateValues values;
      values["JOINT"] = {name_of(*joint)};
      const double velocity = joint->axes.empty() ? 0 : joint->axes.front().velocity.value;
      if (std::isfinite(velocity) && velocity > 0)
        values["VELOCITY"] = {schema::to_shortest(velocity)};
      text += (text.empty() ? "" : "\n") + filled(text_, values);
    }
    if (text.empty()) return no_joint();
    insert_plugins(text);
    return {};
  }

  // --- ros2_control and ros_control ---

  std::string control() {
    if (!edited_.is_urdf()) return "ros2_control is read from URDF";
    if (!edited_.root().ros2_controls.empty()) return "it has a <ros2_control> already";
    TemplateValues values;
    values["NAME"] = {xml::escaped(edited_.robot.name)};
    const auto block = add_template(to_string(rules::Target::kRos), "ros2_control_joint");
    for (const model::Joint* joint : joints()) {
      TemplateValues of_joint;
      of_joint["JOINT"] = {name_of(*joint)};
      if (!follows_another(*joint)) {
        of_joint["COMMAND"] = {joint->type == model::JointType::kContinuous ? "velocity"
                                                                            : "position"};
      }
      values["JOINT_BLOCK"].push_back(filled(*block, of_joint));
    }
    if (values["JOINT_BLOCK"].empty()) return no_joint();
    const bool is_simulated = text_.find("@PARAMETERS@") != std::string::npos;
    if (is_simulated && request_.parameters.empty())
      return "the plugin needs the controllers' YAML: name it with --parameters";
    values["PARAMETERS"] = {xml::escaped(request_.parameters)};
    insert_in_model(filled(text_, values));
    return {};
  }

  bool has_transmission(const model::Joint& joint) const {
    const auto& all = edited_.root().transmissions;
    return std::any_of(all.begin(), all.end(), [&](const model::Parameter& each) {
      return std::any_of(
          each.children.begin(), each.children.end(), [&](const model::Parameter& part) {
            const auto* name = model::attribute(part, "name");
            return part.name == "joint" && name != nullptr && name->value == joint.name.value;
          });
    });
  }

  std::string transmissions() {
    if (!edited_.is_urdf()) return "transmissions are read from URDF";
    std::string text;
    for (const model::Joint* joint : joints()) {
      if (follows_another(*joint) || has_transmission(*joint)) continue;
      TemplateValues values;
      values["JOINT"] = {name_of(*joint)};
      values["INTERFACE"] = {joint->type == model::JointType::kContinuous
                                 ? "VelocityJointInterface"
                                 : "PositionJointInterface"};
      text += (text.empty() ? "" : "\n") + filled(text_, values);
    }
    if (text.empty())
      return joints().empty() ? no_joint() : "the joints have transmissions already";
    insert_in_model(text);
    return {};
  }

  const EditedModel& edited_;
  const AddRequest& request_;
  const Addition& addition_;
  std::string target_;
  std::string text_;  ///< of the template
  Draft draft_;
  std::vector<std::string> notes_;
};

}  // namespace

std::string_view needed_place(std::string_view name) {
  for (const Addition& each : kAdditions) {
    if (each.name != name) continue;
    if (each.kind == AdditionKind::kSensor) return "LINK";
    if (each.kind == AdditionKind::kJointSensor) return "JOINT";
  }
  return {};
}

std::vector<std::string_view> addition_names() {
  std::vector<std::string_view> names;
  for (const Addition& addition : kAdditions) names.push_back(addition.name);
  return names;
}

Change added(const EditedModel& edited, const AddRequest& request) {
  const auto* addition =
      std::find_if(std::begin(kAdditions), std::end(kAdditions),
                   [&](const Addition& each) { return each.name == request.what; });
  if (addition == std::end(kAdditions))
    return refusal(fmt::format("'{}' cannot be added", request.what));
  return Adder(edited, request, *addition).add();
}

}  // namespace rigor::author
