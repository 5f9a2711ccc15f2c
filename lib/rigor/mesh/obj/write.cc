// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <string>

#include <rigor/mesh/obj/materials.h>
#include <rigor/mesh/write/parts.h>
#include <rigor/mesh/write/write.h>

namespace rigor::mesh {
namespace {

/// A vertex has no opacity in this format.
void append_vertex_color(std::string& text, const Corners::Color& color) {
  append_numbers(text, std::array<float, 3>{color[0], color[1], color[2]});
}

void append_vertices(std::string& text, const Welded& vertices) {
  for (std::size_t i = 0; i < vertices.positions.size(); ++i) {
    text += "v ";
    append_number(text, vertices.positions[i]);
    if (!vertices.colors.empty()) append_vertex_color(text, vertices.colors[i]);
    text += '\n';
  }
}

template <class Value>
void append_values(std::string& text, const char* statement, const std::vector<Value>& values) {
  for (const Value& value : values) {
    text += statement;
    append_numbers(text, value);
    text += '\n';
  }
}

/// Behind how many texture points and normals of other parts those of a part stand.
struct NumbersBefore {
  std::size_t texture = 0;
  std::size_t normals = 0;
};

/// `7`, `7/1`, `7//2` or `7/1/2`; 0 for none.
void append_corner(std::string& text, std::size_t vertex, std::size_t texture, std::size_t normal) {
  text += ' ' + std::to_string(vertex);
  if (texture + normal > 0) text += '/';
  if (texture > 0) text += std::to_string(texture);
  if (normal > 0) text += '/' + std::to_string(normal);
}

void append_part(std::string& text, const Part& part, const std::vector<Triangle>& vertices,
                 const Corners& corners, NumbersBefore& before) {
  const Indexed<Corners::Texture> texture = indexed(corners.texture);
  const Indexed<Corners::Normal> normals = indexed(corners.normals);
  append_values(text, "vt", texture.values);
  append_values(text, "vn", normals.values);
  for (std::size_t i = 0; i < part.count; ++i) {
    text += 'f';
    for (std::size_t c = 0; c < 3; ++c) {
      const auto number = [i, c](std::size_t others, const std::vector<Triangle>& triangles) {
        return triangles.empty() ? 0 : others + triangles[i][c] + 1;
      };
      append_corner(text, std::size_t{vertices[part.first + i][c]} + 1,
                    number(before.texture, texture.triangles),
                    number(before.normals, normals.triangles));
    }
    text += '\n';
  }
  before.texture += texture.values.size();
  before.normals += normals.values.size();
}

}  // namespace

std::string write_obj(const TriangleMesh& mesh, const std::string& library) {
  std::string text;
  if (!library.empty()) text += "mtllib" + rest_of_obj_line(library);
  const PartCorners corners(mesh);
  const Corners colors{.colors = corners.of(whole(mesh)).colors};
  const Welded vertices = welded(mesh, whole(mesh), colors, Precision::kDouble);
  append_vertices(text, vertices);
  NumbersBefore before;
  Part last;
  for (const Part& part : parts_with_triangles(mesh)) {
    if (part.name != last.name) text += "o" + rest_of_obj_line(part.name);
    if (part.material != last.material) text += "usemtl" + rest_of_obj_line(part.material);
    last = part;
    append_part(text, part, vertices.triangles, corners.of(part), before);
  }
  return text;
}

}  // namespace rigor::mesh
