// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// COLLADA 1.4.1 as Gazebo reads it: the file's unit is applied, its up axis is not, a submesh has
// its node's name and only the normals that the file gives it. So each triangle gets its own where
// the mesh carries none.
//
// There is no date in it, though the schema wants `<created>` and `<modified>`: readers do not.

#include <array>
#include <string_view>

#include <rigor/mesh/write/parts.h>
#include <rigor/mesh/write/write.h>
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

// ---- Looks

void append_color(std::string& text, const std::array<float, 4>& color) {
  text += "<color>";
  for (const float part : color) {
    if (text.back() != '>') text += ' ';
    append_number(text, double{part});
  }
  text += "</color>";
}

/// A surface has a picture or a color; which pixels are meant, two parameters say in a roundabout
/// way.
void append_picture(std::string& parameters, std::string& surface, const std::string& image) {
  parameters += "<newparam sid=\"surface\"><surface type=\"2D\"><init_from>" + image +
                "</init_from></surface></newparam><newparam sid=\"sampler\"><sampler2D>"
                "<source>surface</source></sampler2D></newparam>";
  surface += "<texture texture=\"sampler\" texcoord=\"UV\"/>";
}

/// With the color's own opacity 1, and the true one apart, as consumers look for it there.
void append_effect(std::string& text, const Material* look, const std::string& image) {
  text += "<profile_COMMON>";
  std::string surface;
  if (look) {
    const auto& [red, green, blue, opacity] = look->diffuse;
    surface += "<diffuse>";
    if (look->texture.empty()) append_color(surface, {red, green, blue, 1});
    if (!look->texture.empty()) append_picture(text, surface, image);
    surface += "</diffuse>";
    if (opacity != 1) {
      surface +=
          "<transparent opaque=\"A_ONE\"><color>1 1 1 1</color></transparent>"
          "<transparency><float>";
      append_number(surface, double{opacity});
      surface += "</float></transparency>";
    }
  }
  text +=
      "<technique sid=\"common\"><lambert>" + surface + "</lambert></technique></profile_COMMON>";
}

void append_library(std::string& text, const std::string& name, const std::string& items) {
  if (!items.empty()) text += "  <" + name + ">\n" + items + "  </" + name + ">\n";
}

void append_materials(std::string& text, const std::vector<Look>& looks) {
  std::string images;
  std::string effects;
  std::string names;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const Material* look = looks[i].material;
    const std::string image = numbered("image", i);
    const std::string effect = numbered("effect", i);
    if (look && !look->texture.empty()) {
      images += "    <image id=\"" + image + "\"><init_from>" + xml::escaped(uri(look->texture)) +
                "</init_from></image>\n";
    }
    effects += "    <effect id=\"" + effect + "\">";
    append_effect(effects, look, image);
    effects += "</effect>\n";
    names += "    <material id=\"" + numbered("material", i) + '"' + name_attribute(looks[i].name) +
             "><instance_effect url=\"#" + effect + "\"/></material>\n";
  }
  append_library(text, "library_images", images);
  append_library(text, "library_effects", effects);
  append_library(text, "library_materials", names);
}

// ---- Shapes

void append_value(std::string& text, const Vector3& value) {
  text += ' ';
  append_number(text, value);
}

template <std::size_t kSize>
void append_value(std::string& text, const std::array<float, kSize>& value) {
  append_numbers(text, value);
}

/// `parameters` with one letter for each number of a value.
template <class Value>
void append_source(std::string& text, const std::string& id, std::string_view parameters,
                   const std::vector<Value>& values) {
  text += "        <source id=\"" + id + "\">\n          <float_array id=\"" + id +
          "-array\" count=\"" + std::to_string(parameters.size() * values.size()) + "\">";
  const std::size_t begin = text.size();
  for (const Value& value : values) append_value(text, value);
  if (!values.empty()) text.erase(begin, 1);  // the first blank
  text += "</float_array>\n          <technique_common><accessor source=\"#" + id +
          "-array\" count=\"" + std::to_string(values.size()) + "\" stride=\"" +
          std::to_string(parameters.size()) + "\">";
  for (const char parameter : parameters) {
    text += std::string("<param name=\"") + parameter + "\" type=\"float\"/>";
  }
  text += "</accessor></technique_common>\n        </source>\n";
}

/// What triangles draw on, by the index of each corner.
struct Input {
  std::string semantic;
  std::string source;
  const std::vector<Triangle>* corners;
};

void append_triangles(std::string& text, std::size_t count, const std::vector<Input>& inputs) {
  text += "        <triangles material=\"material\" count=\"" + std::to_string(count) + "\">\n";
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    text += "          <input semantic=\"" + inputs[i].semantic + "\" source=\"#" +
            inputs[i].source + "\" offset=\"" + std::to_string(i) + '"';
    if (inputs[i].semantic == "TEXCOORD") text += " set=\"0\"";
    text += "/>\n";
  }
  text += "          <p>";
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (const Input& input : inputs) {
        if (text.back() != '>') text += ' ';
        text += std::to_string((*input.corners)[t][corner]);
      }
    }
  }
  text += "</p>\n        </triangles>\n";
}

void append_geometry(std::string& text, const std::string& id, const Part& part, Corners corners,
                     const TriangleMesh& mesh) {
  if (corners.normals.empty()) corners.normals = flat_normals(mesh, part);
  const Indexed<Vector3> positions = indexed_positions(mesh, part, Precision::kDouble);
  const Indexed<Corners::Normal> normals = indexed(corners.normals);
  const Indexed<Corners::Texture> texture = indexed(corners.texture);
  const Indexed<Corners::Color> colors = indexed(corners.colors);
  std::vector<Input> inputs{{"VERTEX", id + "-vertices", &positions.triangles},
                            {"NORMAL", id + "-normals", &normals.triangles}};
  text += "    <geometry id=\"" + id + '"' + name_attribute(part.name) + ">\n      <mesh>\n";
  append_source(text, id + "-positions", "XYZ", positions.values);
  append_source(text, id + "-normals", "XYZ", normals.values);
  if (!texture.values.empty()) {
    append_source(text, id + "-texture", "ST", texture.values);
    inputs.push_back({"TEXCOORD", id + "-texture", &texture.triangles});
  }
  if (!colors.values.empty()) {
    append_source(text, id + "-colors", "RGBA", colors.values);
    inputs.push_back({"COLOR", id + "-colors", &colors.triangles});
  }
  text += "        <vertices id=\"" + id + "-vertices\"><input semantic=\"POSITION\" source=\"#" +
          id + "-positions\"/></vertices>\n";
  append_triangles(text, part.count, inputs);
  text += "      </mesh>\n    </geometry>\n";
}

void append_node(std::string& text, const std::string& geometry, const Part& part,
                 const std::string& material, std::size_t number) {
  text += "      <node id=\"" + numbered("node", number) + '"' + name_attribute(part.name) +
          "><instance_geometry url=\"#" + geometry +
          "\"><bind_material><technique_common><instance_material symbol=\"material\" target=\"#" +
          material +
          "\"><bind_vertex_input semantic=\"UV\" input_semantic=\"TEXCOORD\" input_set=\"0\"/>"
          "</instance_material></technique_common></bind_material></instance_geometry></node>\n";
}

}  // namespace

std::string write_collada(const TriangleMesh& mesh) {
  const std::vector<Part> parts = parts_with_triangles(mesh);
  const Looks looks = looks_of(mesh, parts);
  const PartCorners corners(mesh);
  std::string text(kBegin);
  append_materials(text, looks.looks);
  std::string shapes;
  std::string nodes;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string id = numbered("part", i);
    append_geometry(shapes, id, parts[i], corners.of(parts[i]), mesh);
    append_node(nodes, id, parts[i], numbered("material", looks.of_part[i]), i);
  }
  append_library(text, "library_geometries", shapes);
  text += "  <library_visual_scenes>\n    <visual_scene id=\"scene\">\n" + nodes +
          "    </visual_scene>\n  </library_visual_scenes>\n";
  text += kEnd;
  return text;
}

}  // namespace rigor::mesh
