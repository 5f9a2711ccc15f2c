// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/add.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/verbs/block.h>
#include <rigor/author/verbs/draft.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

constexpr std::string_view kCameraText = R"(<update_rate>30</update_rate>
  <camera>
    <horizontal_fov>1.047</horizontal_fov>
    <image>
      <width>640</width>
      <height>480</height>
    </image>
    <clip>
      <near>0.05</near>
      <far>50</far>
    </clip>
  </camera>)";

constexpr std::string_view kImuText = "<update_rate>100</update_rate>";

/// The element is `ray` up to SDF 1.6.
constexpr std::string_view kLidarText = R"(<update_rate>10</update_rate>
  <{0}>
    <scan>
      <horizontal>
        <samples>640</samples>
        <resolution>1</resolution>
        <min_angle>-1.5708</min_angle>
        <max_angle>1.5708</max_angle>
      </horizontal>
    </scan>
    <range>
      <min>0.08</min>
      <max>10</max>
      <resolution>0.01</resolution>
    </range>
  </{0}>)";

std::string_view name_of_sensor(SensorTemplate kind) {
  switch (kind) {
    case SensorTemplate::kCamera: return "camera";
    case SensorTemplate::kImu: return "imu";
    case SensorTemplate::kLidar: return "lidar";
  }
  return "";
}

constexpr int kFirstWithLidar = 6;  // SDF 1.6 calls a ray sensor so, too

std::string sensor_text(const EditedModel& edited, SensorTemplate kind, const std::string& name,
                        const model::Pose& X) {
  // What is in a <gazebo> block is read as libsdformat's newest.
  const bool has_lidar = edited.is_urdf() || edited.root()[edited.model].version >= kFirstWithLidar;
  std::string type(name_of_sensor(kind)), content;
  switch (kind) {
    case SensorTemplate::kCamera: content = kCameraText; break;
    case SensorTemplate::kImu: content = kImuText; break;
    case SensorTemplate::kLidar:
      type = has_lidar ? "gpu_lidar" : "ray";
      content = fmt::format(fmt::runtime(kLidarText), has_lidar ? "lidar" : "ray");
      break;
  }
  std::string pose;
  if (!(X == model::Pose{})) pose = fmt::format("  <pose>{} {}</pose>\n", xyz_text(X), rpy_text(X));
  return fmt::format("<sensor name=\"{}\" type=\"{}\">\n{}  {}\n</sensor>", name, type, pose,
                     content);
}

bool is_attachment_only_after(const robot::Difference& difference) {
  return difference.kind == robot::DifferenceKind::kAttachmentOnlyInB || difference.a.empty();
}

std::optional<xml::Element> last_child_of(xml::Element element) {
  std::optional<xml::Element> last;
  for (const xml::Element child : element.children()) last = child;
  return last;
}

std::string indented_lines(std::string text) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 3)
    text.insert(at + 1, "  ");
  return "  " + text;
}

}  // namespace

Change with_sensor(const EditedModel& edited, SensorTemplate kind, std::string_view link,
                   const model::Pose& X_LS) {
  const model::Id<model::Link> id = edited.link(link);
  if (!id) return refusal(fmt::format("no link is named '{}'", link));
  const model::Link& holder = edited.root()[id];
  if (!edited.root().own(holder.site)) return refusal("the link is in a file that is included");
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(edited.root().sensors.begin(), edited.root().sensors.end(),
                       [&](const model::Sensor& each) { return each.name.value == name; });
  };
  std::string name(name_of_sensor(kind));
  for (int i = 2; is_taken(name); ++i) name = fmt::format("{}_{}", name_of_sensor(kind), i);
  const std::string text = sensor_text(edited, kind, name, X_LS);
  Draft draft(edited);
  if (edited.is_urdf()) {
    const xml::Element root = edited.element(edited.root()[edited.model].site);
    draft.insert(root, last_child_of(root),
                 fmt::format("<gazebo reference=\"{}\">\n{}\n</gazebo>",
                             xml::escaped(holder.name.value), indented_lines(text)));
  } else {
    const xml::Element element = edited.element(holder.site);
    draft.insert(element, last_child_of(element), text);
  }
  Change change;
  change.steps = draft.take();
  change.expected = edited.robot;
  change.asks_for_setting = is_attachment_only_after;
  return change;
}

Change with_ros2_control(const EditedModel& edited) {
  if (!edited.is_urdf()) return refusal("ros2_control is read from URDF");
  if (!edited.root().ros2_controls.empty()) return refusal("it has a <ros2_control> already");
  std::string joints;
  for (const model::Joint& joint : edited.root().joints) {
    const bool moves = joint.type == model::JointType::kRevolute ||
                       joint.type == model::JointType::kContinuous ||
                       joint.type == model::JointType::kPrismatic;
    if (!moves) continue;
    const bool follows = !joint.axes.empty() && joint.axes.front().mimic;
    joints += fmt::format("\n  <joint name=\"{}\">", xml::escaped(joint.name.value));
    if (!follows) {
      joints += fmt::format("\n    <command_interface name=\"{}\"/>",
                            joint.type == model::JointType::kContinuous ? "velocity" : "position");
    }
    joints +=
        "\n    <state_interface name=\"position\"/>\n    <state_interface name=\"velocity\"/>";
    joints += "\n  </joint>";
  }
  if (joints.empty()) return refusal("no joint moves");
  const xml::Element root = edited.element(edited.root()[edited.model].site);
  Draft draft(edited);
  draft.insert(root, last_child_of(root),
               fmt::format("<ros2_control name=\"{}\" type=\"system\">\n  <hardware>\n    "
                           "<plugin>mock_components/GenericSystem</plugin>\n  </hardware>{}\n"
                           "</ros2_control>",
                           xml::escaped(edited.robot.name), joints));
  Change change;
  change.steps = draft.take();
  change.expected = edited.robot;
  change.asks_for_setting = is_attachment_only_after;
  return change;
}

}  // namespace rigor::author
