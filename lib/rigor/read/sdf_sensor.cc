// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <utility>
#include <variant>

#include <rigor/read/sdf_reader.h>
#include <rigor/schema/value.h>

namespace rigor::read {
namespace {

model::Noise read_noise(xml::Element element) {
  return {site_of(element), number_field(child_text(element, "stddev"), 0)};
}

std::vector<model::Noise> noises_in(xml::Element measured) {
  std::vector<model::Noise> noises;
  for (const xml::Element child : measured.children()) {
    if (child.name() == "noise") noises.push_back(read_noise(child));
  }
  return noises;
}

model::Camera read_camera(xml::Element element) {
  model::Camera camera;
  camera.site = site_of(element);
  camera.pose = read_plain_pose(element);
  camera.horizontal_fov = number_field(child_text(element, "horizontal_fov"), 1.047);
  const auto clip = element.child("clip");
  camera.near_clip = number_field(clip ? child_text(*clip, "near") : std::nullopt, 0.1);
  camera.far_clip = number_field(clip ? child_text(*clip, "far") : std::nullopt, 100);
  const auto image = element.child("image");
  camera.width = number_field(image ? child_text(*image, "width") : std::nullopt, 320);
  camera.height = number_field(image ? child_text(*image, "height") : std::nullopt, 240);
  camera.noises = noises_in(element);
  return camera;
}

model::LidarScan read_scan(std::optional<xml::Element> element) {
  const auto value = [&element](std::string_view name, double fallback) {
    return number_field(element ? child_text(*element, name) : std::nullopt, fallback);
  };
  return {value("samples", 640), value("resolution", 1), value("min_angle", 0),
          value("max_angle", 0)};
}

model::Lidar read_lidar(xml::Element element) {
  model::Lidar lidar;
  lidar.site = site_of(element);
  const auto range = element.child("range");
  lidar.range_min = number_field(range ? child_text(*range, "min") : std::nullopt, 0);
  lidar.range_max = number_field(range ? child_text(*range, "max") : std::nullopt, 0);
  const auto scan = element.child("scan");
  lidar.horizontal = read_scan(scan ? scan->child("horizontal") : std::nullopt);
  lidar.vertical = read_scan(scan ? scan->child("vertical") : std::nullopt);
  lidar.noises = noises_in(element);
  return lidar;
}

/// Up to SDF 1.4 all axes have one noise: `<noise><rate>` and `<noise><accel>`.
void read_imu(xml::Element imu, model::Sensor& sensor) {
  auto& turning = sensor.angular_velocity_noises;
  auto& moving = sensor.linear_acceleration_noises;
  if (!turning.empty() || !moving.empty()) return;
  if (const auto old = imu.child("noise")) {
    if (const auto rate = old->child("rate")) turning.push_back(read_noise(*rate));
    if (const auto accel = old->child("accel")) moving.push_back(read_noise(*accel));
    return;
  }
  for (const xml::Element quantity : imu.children()) {
    auto& noises = quantity.name() == "angular_velocity" ? turning : moving;
    for (const xml::Element axis : quantity.children()) {
      for (model::Noise& noise : noises_in(axis)) noises.push_back(std::move(noise));
    }
  }
}

bool names_frame(std::string_view element) {
  return element == "gz_frame_id" || element == "ignition_frame_id" || element == "frameName" ||
         element == "frame_name";
}

}  // namespace

model::PoseField read_plain_pose(xml::Element parent) {
  model::PoseField field;
  const auto element = parent.child("pose");
  if (!element) return field;
  field.site = site_of(*element);
  const auto parsed = schema::parse_pose(element->text(), schema::RotationFormat::kEulerRpy);
  if (const auto* pose = std::get_if<schema::PoseNumbers>(&parsed)) {
    const auto& n = pose->numbers;
    field.pose = {
        {{n[0], n[1], n[2]}, model::from_rpy(n[3], n[4], n[5])}, element->text_span(), true};
  }
  return field;
}

void read_measurement(xml::Element element, model::Sensor& sensor) {
  sensor.site = site_of(element);
  sensor.name = string_field(attribute_text(element, "name"));
  sensor.type = string_field(attribute_text(element, "type"));
  sensor.update_rate = number_field(child_text(element, "update_rate"), 0);
  sensor.topic = string_field(child_text(element, "topic"));
  for (const xml::Element child : element.children()) {
    const std::string_view name = child.name();
    if (name != "plugin") sensor.settings.emplace_back(name);
    if (names_frame(name)) {
      sensor.frames.push_back(string_field(Text{child.text(), child.text_span()}));
    }
    if (name == "imu") read_imu(child, sensor);
    if (name == "force_torque") {
      sensor.wrench = {string_field(child_text(child, "frame")),
                       string_field(child_text(child, "measure_direction"))};
    }
    if (name == "camera") sensor.cameras.push_back(read_camera(child));
    if (name == "ray" || name == "lidar") sensor.lidar = read_lidar(child);
    if (name != "contact") continue;
    for (const xml::Element part : child.children()) {
      if (part.name() != "collision") continue;
      sensor.contact_collisions.push_back(string_field(Text{part.text(), part.text_span()}));
    }
  }
}

void SdfReader::read_sensor(xml::Element element, model::Sensor sensor) {
  const model::Id<model::Sensor> id = model::next_id(root_.sensors);
  read_measurement(element, sensor);
  sensor.pose = read_pose(element);
  for (const xml::Element child : element.children()) {
    if (child.name() == "plugin") read_plugin(child, {.sensor = id});
  }
  if (sensor.link) root_.links[sensor.link.value].sensors.push_back(id);
  root_.sensors.push_back(std::move(sensor));
}

}  // namespace rigor::read
