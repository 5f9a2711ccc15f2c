// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include <rigor/mesh/write/parts.h>
#include <rigor/mesh/write/write.h>

namespace rigor::mesh {
namespace {

/// The nearest of 256 steps from 0 to 1.
int byte_of(float part) { return static_cast<int>(std::lround(part * 255.0F)); }

bool are_floats(const std::vector<Vector3>& positions) {
  return std::all_of(positions.begin(), positions.end(), [](const Vector3& p) {
    return as_float(p.x) == p.x && as_float(p.y) == p.y && as_float(p.z) == p.z;
  });
}

/// Colors as bytes are what every reader understands; others would be rounded by them.
bool are_bytes(const std::vector<Corners::Color>& colors) {
  return std::all_of(colors.begin(), colors.end(), [](const Corners::Color& color) {
    return std::all_of(color.begin(), color.end(), [](float part) {
      return part >= 0 && part <= 1 && static_cast<float>(byte_of(part)) / 255.0F == part;
    });
  });
}

std::string properties(const std::string& number, std::initializer_list<const char*> names) {
  std::string text;
  for (const char* name : names) text += "property " + number + ' ' + name + '\n';
  return text;
}

std::string header(const Welded& mesh, const std::string& number) {
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                     std::to_string(mesh.positions.size()) + '\n' +
                     properties(number, {"x", "y", "z"});
  if (!mesh.normals.empty()) text += properties("float", {"nx", "ny", "nz"});
  if (!mesh.texture.empty()) text += properties("float", {"s", "t"});
  if (!mesh.colors.empty()) {
    text +=
        properties(are_bytes(mesh.colors) ? "uchar" : "float", {"red", "green", "blue", "alpha"});
  }
  return text + "element face " + std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

template <class Number>
bool begins_with_line_feed(const Vector3& p) {
  std::string bytes;
  append_bytes(bytes, static_cast<Number>(p.x));
  return bytes.front() == '\n';
}

/// assimp 5.2.5 drops a line feed behind the header's last line, though it is the first byte of the
/// first number, and then finds no mesh (its issue 5341). So another vertex becomes the first. When
/// all x are such numbers there is none, and assimp does not read the file.
template <class Number>
void avoid_line_feed(Welded& mesh) {
  const auto good =
      std::find_if_not(mesh.positions.begin(), mesh.positions.end(), begins_with_line_feed<Number>);
  if (good == mesh.positions.end()) return;
  const auto index = static_cast<std::uint32_t>(good - mesh.positions.begin());
  std::swap(mesh.positions.front(), *good);
  if (!mesh.texture.empty()) std::swap(mesh.texture.front(), mesh.texture[index]);
  if (!mesh.normals.empty()) std::swap(mesh.normals.front(), mesh.normals[index]);
  if (!mesh.colors.empty()) std::swap(mesh.colors.front(), mesh.colors[index]);
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) corner = corner == 0 ? index : corner == index ? 0 : corner;
  }
}

template <class Number>
std::string bytes_of(Welded mesh, const std::string& number) {
  avoid_line_feed<Number>(mesh);
  std::string bytes = header(mesh, number);
  const bool byte_colors = are_bytes(mesh.colors);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vector3& p = mesh.positions[i];
    for (const double coordinate : {p.x, p.y, p.z}) {
      append_bytes(bytes, static_cast<Number>(coordinate));
    }
    if (!mesh.normals.empty()) append_bytes(bytes, mesh.normals[i]);
    if (!mesh.texture.empty()) append_bytes(bytes, mesh.texture[i]);
    if (mesh.colors.empty()) continue;
    if (byte_colors) {
      for (const float part : mesh.colors[i]) bytes += static_cast<char>(byte_of(part));
    } else {
      append_bytes(bytes, mesh.colors[i]);
    }
  }
  for (const Triangle& t : mesh.triangles) {
    bytes += '\3';
    for (const std::uint32_t corner : t) append_bytes(bytes, corner);
  }
  return bytes;
}

}  // namespace

std::string write_ply(const TriangleMesh& mesh) {
  const Part part = whole(mesh);
  Welded all = welded(mesh, part, PartCorners(mesh).of(part), Precision::kDouble);
  // A coordinate over the largest float is none either way: infinity is not equal to it.
  return are_floats(all.positions) ? bytes_of<float>(std::move(all), "float")
                                   : bytes_of<double>(std::move(all), "double");
}

}  // namespace rigor::mesh
