// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/write_parts.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <rigor/mesh/weld.h>
#include <rigor/xml/characters.h>

namespace rigor::mesh {
namespace {

constexpr double kLeastFixed = 1e-6;
constexpr double kMostFixed = 1e15;

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

double rounded(double value, Precision precision) {
  return precision == Precision::kFloat ? as_float(value) : value + 0.0;  // -0 becomes 0
}

}  // namespace

void append_number(std::string& text, double value) {
  const double size = std::abs(value);
  const bool fixed = value == 0 || (size >= kLeastFixed && size < kMostFixed);
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 fixed ? std::chars_format::fixed : std::chars_format::scientific)
                       .ptr;
  text.append(digits.data(), end);
}

void append_number(std::string& text, const Vector3& p) {
  append_number(text, p.x);
  text += ' ';
  append_number(text, p.y);
  text += ' ';
  append_number(text, p.z);
}

std::string clean(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  std::uint32_t at = 0;
  while (const std::optional<xml::BadCharacter> bad = xml::find_bad_character(name, at)) {
    name.replace(bad->begin, bad->end - bad->begin, kReplacement);
    at = bad->begin + static_cast<std::uint32_t>(kReplacement.size());
  }
  return name;
}

Vector3 unit_normal(const Facet& f) {
  const Vector3 normal = model::cross(f[1] - f[0], f[2] - f[0]);
  const double length = model::length(normal);
  if (length == 0 || !std::isfinite(length)) return {};
  return {as_float(normal.x / length), as_float(normal.y / length), as_float(normal.z / length)};
}

std::vector<Part> parts_with_triangles(const TriangleMesh& mesh) {
  std::vector<Part> parts = mesh.parts;
  if (parts.empty()) parts = {{{}, {}, 0, mesh.triangles.size()}};
  std::erase_if(parts, [](const Part& part) { return part.count == 0; });
  return parts;
}

Materials materials_of(const std::vector<Part>& parts) {
  Materials materials;
  for (const Part& part : parts) {
    std::vector<std::string>& names = materials.names;
    const auto at = std::find(names.begin(), names.end(), part.material);
    materials.of_part.push_back(static_cast<std::size_t>(at - names.begin()));
    if (at == names.end()) names.push_back(part.material);
  }
  return materials;
}

Welded welded(const TriangleMesh& mesh, const Part& part, Precision precision) {
  std::vector<Vector3> corners;
  corners.reserve(3 * part.count);
  for (std::size_t i = part.first; i < part.first + part.count; ++i) {
    for (const Vector3& p : facet(mesh, mesh.triangles[i])) {
      corners.push_back(
          {rounded(p.x, precision), rounded(p.y, precision), rounded(p.z, precision)});
    }
  }
  const Weld weld = mesh::weld(corners);
  Welded result;
  result.positions.reserve(weld.places());
  for (const std::uint32_t first : weld.first) result.positions.push_back(corners[first]);
  result.triangles.reserve(part.count);
  for (std::size_t i = 0; i < weld.place.size(); i += 3) {
    result.triangles.push_back({weld.place[i], weld.place[i + 1], weld.place[i + 2]});
  }
  return result;
}

Welded welded(const TriangleMesh& mesh) {
  return welded(mesh, {.first = 0, .count = mesh.triangles.size()}, Precision::kDouble);
}

}  // namespace rigor::mesh
