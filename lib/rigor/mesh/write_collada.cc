// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// COLLADA 1.4.1 as Gazebo reads it: the file's unit is applied, its up axis is not, a submesh has
// its node's name and only the normals that the file gives it. So each triangle gets its own.
//
// There is no date in it, though the schema wants `<created>` and `<modified>`: readers do not.

#include <string_view>

#include <rigor/mesh/write.h>
#include <rigor/mesh/write_parts.h>
#include <rigor/xml/edit.h>

namespace rigor::mesh {
namespace {

constexpr std::string_view kBegin = R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset>
    <unit name="meter" meter="1"/>
    <up_axis>Z_UP</up_axis>
  </asset>
)";

constexpr std::string_view kEnd = R"(  <scene>
    <instance_visual_scene url="#scene"/>
  </scene>
</COLLADA>
)";

/// ` name="…"`, or nothing for an empty name: consumers then take an id or make one up.
std::string name_attribute(const std::string& name) {
  return name.empty() ? "" : " name=\"" + xml::escaped(clean(name)) + '"';
}

std::string numbered(std::string_view what, std::size_t number) {
  return std::string(what) + '-' + std::to_string(number);
}

/// Of a material only the name is known.
void append_materials(std::string& text, const Materials& materials) {
  if (materials.names.empty()) return;
  std::string effects;
  std::string names;
  for (std::size_t i = 0; i < materials.names.size(); ++i) {
    const std::string effect = numbered("effect", i);
    effects += "    <effect id=\"" + effect +
               "\"><profile_COMMON><technique sid=\"common\"><lambert/></technique>"
               "</profile_COMMON></effect>\n";
    names += "    <material id=\"" + numbered("material", i) + '"' +
             name_attribute(materials.names[i]) + "><instance_effect url=\"#" + effect +
             "\"/></material>\n";
  }
  text += "  <library_effects>\n" + effects + "  </library_effects>\n";
  text += "  <library_materials>\n" + names + "  </library_materials>\n";
}

void append_source(std::string& text, const std::string& id, const std::vector<Vector3>& values) {
  text += "        <source id=\"" + id + "\">\n          <float_array id=\"" + id +
          "-array\" count=\"" + std::to_string(3 * values.size()) + "\">";
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += ' ';
    append_number(text, values[i]);
  }
  text += "</float_array>\n          <technique_common><accessor source=\"#" + id +
          "-array\" count=\"" + std::to_string(values.size()) +
          "\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
          "<param name=\"Z\" type=\"float\"/></accessor></technique_common>\n        </source>\n";
}

void append_triangles(std::string& text, const std::string& id,
                      const std::vector<Triangle>& triangles) {
  text += "        <triangles material=\"material\" count=\"" + std::to_string(triangles.size()) +
          "\">\n          <input semantic=\"VERTEX\" source=\"#" + id +
          "-vertices\" offset=\"0\"/>\n          <input semantic=\"NORMAL\" source=\"#" + id +
          "-normals\" offset=\"1\"/>\n          <p>";
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::string normal = ' ' + std::to_string(i);
    for (const std::uint32_t corner : triangles[i]) {
      if (text.back() != '>') text += ' ';
      text += std::to_string(corner) + normal;
    }
  }
  text += "</p>\n        </triangles>\n";
}

void append_geometry(std::string& text, const std::string& id, const Part& part,
                     const TriangleMesh& mesh) {
  const Welded shape = welded(mesh, part, Precision::kDouble);
  std::vector<Vector3> normals;
  normals.reserve(part.count);
  for (std::size_t i = part.first; i < part.first + part.count; ++i) {
    normals.push_back(unit_normal(facet(mesh, mesh.triangles[i])));
  }
  text += "    <geometry id=\"" + id + '"' + name_attribute(part.name) + ">\n      <mesh>\n";
  append_source(text, id + "-positions", shape.positions);
  append_source(text, id + "-normals", normals);
  text += "        <vertices id=\"" + id + "-vertices\"><input semantic=\"POSITION\" source=\"#" +
          id + "-positions\"/></vertices>\n";
  append_triangles(text, id, shape.triangles);
  text += "      </mesh>\n    </geometry>\n";
}

void append_node(std::string& text, const std::string& geometry, const Part& part,
                 const std::string& material, std::size_t number) {
  text += "      <node id=\"" + numbered("node", number) + '"' + name_attribute(part.name) +
          "><instance_geometry url=\"#" + geometry +
          "\"><bind_material><technique_common><instance_material symbol=\"material\" target=\"#" +
          material + "\"/></technique_common></bind_material></instance_geometry></node>\n";
}

}  // namespace

std::string write_collada(const TriangleMesh& mesh) {
  const std::vector<Part> parts = parts_with_triangles(mesh);
  const Materials materials = materials_of(parts);
  std::string text(kBegin);
  append_materials(text, materials);
  std::string nodes;
  if (!parts.empty()) text += "  <library_geometries>\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string id = numbered("part", i);
    append_geometry(text, id, parts[i], mesh);
    append_node(nodes, id, parts[i], numbered("material", materials.of_part[i]), i);
  }
  if (!parts.empty()) text += "  </library_geometries>\n";
  text += "  <library_visual_scenes>\n    <visual_scene id=\"scene\">\n" + nodes +
          "    </visual_scene>\n  </library_visual_scenes>\n";
  text += kEnd;
  return text;
}

}  // namespace rigor::mesh
