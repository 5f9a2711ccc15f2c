// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <utility>

#include <rigor/mesh/write.h>
#include <rigor/mesh/write_parts.h>

namespace rigor::mesh {
namespace {

bool are_floats(const std::vector<Vector3>& positions) {
  return std::all_of(positions.begin(), positions.end(), [](const Vector3& p) {
    return as_float(p.x) == p.x && as_float(p.y) == p.y && as_float(p.z) == p.z;
  });
}

std::string header(const Welded& mesh, const std::string& number) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " +
         std::to_string(mesh.positions.size()) + "\nproperty " + number + " x\nproperty " + number +
         " y\nproperty " + number + " z\nelement face " + std::to_string(mesh.triangles.size()) +
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
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) corner = corner == 0 ? index : corner == index ? 0 : corner;
  }
}

template <class Number>
std::string bytes_of(Welded mesh, const std::string& number) {
  avoid_line_feed<Number>(mesh);
  std::string bytes = header(mesh, number);
  for (const Vector3& p : mesh.positions) {
    for (const double coordinate : {p.x, p.y, p.z}) {
      append_bytes(bytes, static_cast<Number>(coordinate));
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
  Welded all = welded(mesh);
  // A coordinate over the largest float is none either way: infinity is not equal to it.
  return are_floats(all.positions) ? bytes_of<float>(std::move(all), "float")
                                   : bytes_of<double>(std::move(all), "double");
}

}  // namespace rigor::mesh
