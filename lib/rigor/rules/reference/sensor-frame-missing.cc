// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <unordered_set>

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/xml/xacro.h>

namespace rigor::rules::sensor_frame_missing {

constexpr std::string_view kFrames[] = {"gz_frame_id", "ignition_frame_id", "frameName",
                                        "frame_name"};
// Frames that others publish.
constexpr std::string_view kOutside[] = {"world", "map", "odom"};

template <std::size_t count>
bool is_among(const std::string_view (&list)[count], std::string_view name) {
  return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

using Links = std::unordered_set<std::string_view>;

/// Whether the frame is a link's name but for a letter within it: no one else publishes it.
bool is_slip(std::string_view frame, const Links& links) {
  constexpr std::size_t kMin = 6;
  return frame.size() >= kMin &&
         std::any_of(links.begin(), links.end(), [&](std::string_view link) {
           return frame.front() == link.front() && frame.back() == link.back() &&
                  schema::edit_distance(frame, link, 1) == 1;
         });
}

void look_at(const model::Field<std::string>& field, const model::Sensor& sensor,
             const Links& links, Context& context) {
  const std::string_view name = field.value;
  // A namespace may stand in front.
  const std::string_view frame = name.substr(name.rfind('/') + 1);
  if (frame.empty() || links.count(frame) != 0 || is_among(kOutside, frame)) return;
  if (has_xacro(name)) return;
  Finding finding = with_nearest(
      {.where = field.span,
       .message = "the sensor measures in the frame '" + std::string(name) +
                  "', which is no link of this robot",
       .subject = context.subject(sensor)},
      name, [&context] { return names_of(context.root().links); }, context);
  if (is_slip(frame, links)) finding.severity = Severity::kWarning;
  context.report(std::move(finding));
}

void check(const model::Root& root, Context& context) {
  if (root.sensors.empty()) return;
  const Links links = name_set(root.links);
  for (const model::Sensor& sensor : root.sensors) {
    if (!root.own(sensor.site)) continue;
    for (const auto& frame : sensor.frames) look_at(frame, sensor, links, context);
  }
  for (const model::Plugin& plugin : root.plugins) {
    if (!plugin.sensor || !root.own(plugin.site)) continue;
    for (const model::Parameter& given : plugin.parameters) {
      if (!is_among(kFrames, given.name)) continue;
      look_at(given.value, root[plugin.sensor], links, context);
    }
  }
}

Rule rule() {
  return {
      .name = "sensor-frame-missing",
      .severity = Severity::kInfo,
      .formats = Formats::kUrdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a sensor measures in a frame that is no link of the robot",
      .why = "In ROS the frame in the header of a measurement is looked up in tf, where "
             "robot_state_publisher publishes the links of the URDF. What comes in an unknown "
             "frame, RViz drops, and navigation waits for, unless something else publishes it. "
             "One that is a link's name but for a letter is a warning.",
      .what_to_do = "Name a link of the robot: mostly the one that carries the sensor.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::sensor_frame_missing
