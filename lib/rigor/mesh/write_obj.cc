// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/mesh/write.h>
#include <rigor/mesh/write_parts.h>

namespace rigor::mesh {
namespace {

/// As the rest of a line, which a backslash at its end would join to the next.
std::string rest_of_line(const std::string& name) {
  std::string line = name.empty() ? "" : ' ' + clean(name);
  if (line.ends_with('\\')) line.back() = '_';
  return line + '\n';
}

}  // namespace

std::string write_obj(const TriangleMesh& mesh) {
  const Welded all = welded(mesh);
  std::string text;
  for (const Vector3& p : all.positions) {
    text += "v ";
    append_number(text, p);
    text += '\n';
  }
  Part before;
  for (const Part& part : parts_with_triangles(mesh)) {
    if (part.name != before.name) text += "o" + rest_of_line(part.name);
    if (part.material != before.material) text += "usemtl" + rest_of_line(part.material);
    before = part;
    for (std::size_t i = part.first; i < part.first + part.count; ++i) {
      text += 'f';
      for (const std::uint32_t corner : all.triangles[i]) text += ' ' + std::to_string(corner + 1);
      text += '\n';
    }
  }
  return text;
}

}  // namespace rigor::mesh
