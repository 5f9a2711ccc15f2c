// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/test_world.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include <rigor/mass/mass_properties.h>
#include <rigor/mass/shapes.h>
#include <rigor/write/inertial_text.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

using model::Vector3;

constexpr std::string_view kHead = R"(<?xml version="1.0"?>
<sdf version="1.6">
  <world name="test">
    <light name="sun" type="directional">
      <cast_shadows>true</cast_shadows>
      <pose>0 0 10 0 0 0</pose>
      <diffuse>0.8 0.8 0.8 1</diffuse>
      <specular>0.2 0.2 0.2 1</specular>
      <direction>-0.5 0.1 -0.9</direction>
    </light>
    <model name="ground">
      <static>true</static>
      <link name="link">
        <collision name="collision">
          <geometry>
            <plane>
              <normal>0 0 1</normal>
              <size>100 100</size>
            </plane>
          </geometry>
        </collision>
        <visual name="visual">
          <geometry>
            <plane>
              <normal>0 0 1</normal>
              <size>100 100</size>
            </plane>
          </geometry>
          <material>
            <ambient>0.8 0.8 0.8 1</ambient>
            <diffuse>0.8 0.8 0.8 1</diffuse>
          </material>
        </visual>
      </link>
    </model>
)";

constexpr std::string_view kFoot = R"(  </world>
</sdf>
)";

std::string line(int level, std::string_view text) {
  return std::string(static_cast<std::size_t>(2 * level), ' ').append(text).append("\n");
}

/// Each line of a block that begins at the left.
std::string block(int level, std::string_view text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result += line(level, text.substr(begin, end - begin));
    begin = end + 1;
  }
  return result;
}

std::string triple(const Vector3& v) { return write::joined({v.x, v.y, v.z}); }

Vector3 scaled(const Vector3& s, const Vector3& v) { return {s.x * v.x, s.y * v.y, s.z * v.z}; }

/// In the world's unit; a factor may be negative.
mesh::Bounds scaled(const Vector3& scale, const mesh::Bounds& bounds) {
  const Vector3 a = scaled(scale, bounds.min);
  const Vector3 b = scaled(scale, bounds.max);
  return {{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
          {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
}

mass::MassProperties box_around(const mesh::Bounds& bounds, double density) {
  const Vector3 sides = bounds.max - bounds.min;
  const mass::Solid box = mass::box(
      {std::max(sides.x, kMinSide), std::max(sides.y, kMinSide), std::max(sides.z, kMinSide)});
  return mass::translated(0.5 * (bounds.min + bounds.max), mass::of_density(box, density));
}

mass::MassProperties body_in(const TestBody& body, const mass::MeshSurvey& survey,
                             const mesh::Bounds& bounds) {
  const mass::MeshBody solid = mass::body_of(survey, body.scale);
  if (solid.solid) return mass::of_density(*solid.solid, body.density);
  return box_around(bounds, body.density);
}

/// On the ground, above the origin.
Vector3 standing(const mesh::Bounds& bounds) {
  const Vector3 middle = 0.5 * (bounds.min + bounds.max);
  const double size = mesh::diagonal(bounds) + length(middle);
  return {write::settled(-middle.x, 0, size), write::settled(-middle.y, 0, size),
          write::settled(-bounds.min.z, 0, size)};
}

std::string part(std::string_view kind, const TestBody& body) {
  const std::string name(kind);
  std::string text = '<' + name + " name=\"" + name + "\">\n  <geometry>\n    <mesh>\n      <uri>" +
                     xml::escaped(body.uri) + "</uri>\n";
  if (body.scale != Vector3{1, 1, 1}) text += "      <scale>" + triple(body.scale) + "</scale>\n";
  return text + "    </mesh>\n  </geometry>\n</" + name + ">\n";
}

}  // namespace

std::string test_world(const TestBody& body, const mass::MeshSurvey& survey) {
  mesh::Bounds bounds = scaled(body.scale, survey.bounds);
  if (survey.triangles == 0) bounds = {};
  const mass::MassProperties mass = body_in(body, survey, bounds);
  return std::string(kHead) + line(2, "<model name=\"" + xml::escaped(body.name) + "\">") +
         line(3, "<pose>" + triple(standing(bounds)) + " 0 0 0</pose>") +
         line(3, "<link name=\"link\">") +
         block(4, write::inertial_text(mass, write::BlockFormat::kSdf)) +
         block(4, part("collision", body)) + block(4, part("visual", body)) + line(3, "</link>") +
         line(2, "</model>") + std::string(kFoot);
}

}  // namespace rigor::author
