// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/write/parts.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include <rigor/mesh/normals.h>
#include <rigor/mesh/topology/weld.h>
#include <rigor/xml/characters.h>

namespace rigor::mesh {
namespace {

constexpr double kMinFixed = 1e-6;
constexpr double kMaxFixed = 1e15;

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

double rounded_to(double value, Precision precision) {
  return precision == Precision::kFloat ? as_float(value) : value + 0.0;  // -0 becomes 0
}

// ---- Runs of triangles

/// The entries of a part's triangles, without -0.
template <class List>
List slice(const List& list, const Part& part) {
  if (list.empty()) return {};
  const auto first = list.begin() + static_cast<std::ptrdiff_t>(part.first);
  List cut(first, first + static_cast<std::ptrdiff_t>(part.count));
  for (auto& triangle : cut) {
    for (auto& corner : triangle) {
      for (float& number : corner) number += 0.0F;
    }
  }
  return cut;
}

template <class List, class Value>
bool all_are(const List& list, const Value& value) {
  return std::all_of(list.begin(), list.end(), [&value](const auto& triangle) {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&value](const Value& corner) { return corner == value; });
  });
}

// ---- Corners in a row

std::vector<Vector3> places(const TriangleMesh& mesh, const Part& part, Precision precision) {
  std::vector<Vector3> corners;
  corners.reserve(3 * part.count);
  for (std::size_t i = part.first; i < part.first + part.count; ++i) {
    for (const Vector3& p : facet(mesh, mesh.triangles[i])) {
      corners.push_back(
          {rounded_to(p.x, precision), rounded_to(p.y, precision), rounded_to(p.z, precision)});
    }
  }
  return corners;
}

template <class Value>
std::vector<Value> one_by_one(const std::vector<std::array<Value, 3>>& corners) {
  std::vector<Value> all;
  all.reserve(3 * corners.size());
  for (const std::array<Value, 3>& three : corners)
    all.insert(all.end(), three.begin(), three.end());
  return all;
}

/// Corners are the same that are so in both.
Weld together(const Weld& a, const Weld& b) {
  std::vector<Vector3> pairs;
  pairs.reserve(a.place.size());
  for (std::size_t i = 0; i < a.place.size(); ++i) {
    pairs.push_back({static_cast<double>(a.place[i]), static_cast<double>(b.place[i]), 0});
  }
  return weld(pairs);
}

/// Equal ones are one, as positions of up to three coordinates are.
template <class Value>
Weld weld_values(const std::vector<Value>& values) {
  constexpr std::size_t kSize = std::tuple_size_v<Value>;
  std::vector<Vector3> keys;
  keys.reserve(values.size());
  for (const Value& v : values) {
    keys.push_back({double{v[0]}, double{v[1]}, kSize == 2 ? 0 : double{v[kSize - 1]}});
  }
  if constexpr (kSize < 4) return weld(keys);
  const Weld others = weld(keys);
  for (std::size_t i = 0; i < values.size(); ++i) keys[i] = {double{values[i][2]}, 0, 0};
  return together(others, weld(keys));
}

/// For each place, what its first corner has; nothing when corners have nothing.
template <class Value>
std::vector<Value> firsts(const std::vector<Value>& corners, const Weld& weld) {
  std::vector<Value> values;
  if (corners.empty()) return values;
  values.reserve(weld.places());
  for (const std::uint32_t first : weld.first) values.push_back(corners[first]);
  return values;
}

template <class Value>
Indexed<Value> chosen(const std::vector<Value>& corners, const Weld& weld) {
  Indexed<Value> result{firsts(corners, weld), {}};
  result.triangles.reserve(weld.place.size() / 3);
  for (std::size_t i = 0; i < weld.place.size(); i += 3) {
    result.triangles.push_back({weld.place[i], weld.place[i + 1], weld.place[i + 2]});
  }
  return result;
}

}  // namespace

void append_number(std::string& text, double value) {
  const double size = std::abs(value);
  const bool fixed = value == 0 || (size >= kMinFixed && size < kMaxFixed);
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

/// Never inlined: of three conversions there and back side by side gcc 12.2 -O2 leaves some out.
[[gnu::noinline]] double as_float(double value) { return static_cast<float>(value) + 0.0; }

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

std::string uri(const std::string& path) {
  constexpr std::string_view kPlain = "-._~/:!$&'()*+,;=@";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text;
  for (const char c : path) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (letter || kPlain.find(c) != std::string_view::npos) {
      text += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    text += {'%', kDigits[byte >> 4U], kDigits[byte & 15U]};
  }
  return text;
}

std::vector<Part> parts_with_triangles(const TriangleMesh& mesh) {
  std::vector<Part> parts = mesh.parts;
  if (parts.empty()) parts = {{{}, {}, 0, mesh.triangles.size()}};
  std::erase_if(parts, [](const Part& part) { return part.count == 0; });
  return parts;
}

Looks looks_of(const TriangleMesh& mesh, const std::vector<Part>& parts) {
  std::map<std::string_view, const Material*> known;
  for (const Material& material : mesh.materials) known.try_emplace(material.name, &material);
  std::map<std::string_view, std::size_t> numbers;
  Looks result;
  for (const Part& part : parts) {
    const auto [at, is_new] = numbers.try_emplace(part.material, result.looks.size());
    result.of_part.push_back(at->second);
    if (!is_new) continue;
    const auto look = known.find(part.material);
    result.looks.push_back({part.material, look == known.end() ? nullptr : look->second});
  }
  return result;
}

Part whole(const TriangleMesh& mesh) { return {.first = 0, .count = mesh.triangles.size()}; }

PartCorners::PartCorners(const TriangleMesh& mesh)
    : mesh_(mesh),
      any_texture_(!all_are(mesh.corners.texture, Corners::Texture{})),
      any_color_(!all_are(mesh.corners.colors, kWhite)) {}

Corners PartCorners::of(const Part& part) const {
  Corners corners;
  corners.texture = slice(mesh_.corners.texture, part);
  if (any_texture_ && all_are(corners.texture, Corners::Texture{})) corners.texture.clear();
  corners.colors = slice(mesh_.corners.colors, part);
  if (any_color_ && all_are(corners.colors, kWhite)) corners.colors.clear();
  corners.normals = slice(mesh_.corners.normals, part);
  if (all_are(corners.normals, Corners::Normal{})) corners.normals.clear();
  for (std::size_t i = 0; i < corners.normals.size(); ++i) {
    const Corners::Normal flat = normal_of(facet(mesh_, mesh_.triangles[part.first + i]));
    for (Corners::Normal& normal : corners.normals[i]) {
      if (normal == Corners::Normal{}) normal = flat;
    }
  }
  return corners;
}

std::vector<std::array<Corners::Normal, 3>> flat_normals(const TriangleMesh& mesh,
                                                         const Part& part) {
  std::vector<std::array<Corners::Normal, 3>> normals;
  normals.reserve(part.count);
  for (std::size_t i = part.first; i < part.first + part.count; ++i) {
    const Corners::Normal normal = normal_of(facet(mesh, mesh.triangles[i]));
    normals.push_back({normal, normal, normal});
  }
  return normals;
}

Indexed<Corners::Texture> indexed(const std::vector<std::array<Corners::Texture, 3>>& corners) {
  const std::vector<Corners::Texture> values = one_by_one(corners);
  return chosen(values, weld_values(values));
}

Indexed<Corners::Normal> indexed(const std::vector<std::array<Corners::Normal, 3>>& corners) {
  const std::vector<Corners::Normal> values = one_by_one(corners);
  return chosen(values, weld_values(values));
}

Indexed<Corners::Color> indexed(const std::vector<std::array<Corners::Color, 3>>& corners) {
  const std::vector<Corners::Color> values = one_by_one(corners);
  return chosen(values, weld_values(values));
}

Indexed<Vector3> indexed_positions(const TriangleMesh& mesh, const Part& part,
                                   Precision precision) {
  const std::vector<Vector3> corners = places(mesh, part, precision);
  return chosen(corners, weld(corners));
}

Welded welded(const TriangleMesh& mesh, const Part& part, const Corners& corners,
              Precision precision) {
  const std::vector<Vector3> positions = places(mesh, part, precision);
  const std::vector<Corners::Texture> texture = one_by_one(corners.texture);
  const std::vector<Corners::Normal> normals = one_by_one(corners.normals);
  const std::vector<Corners::Color> colors = one_by_one(corners.colors);
  Weld all = weld(positions);
  for (const Weld& more : {weld_values(texture), weld_values(normals), weld_values(colors)}) {
    if (!more.place.empty()) all = together(all, more);
  }
  Indexed<Vector3> vertices = chosen(positions, all);
  return {std::move(vertices.values), std::move(vertices.triangles), firsts(texture, all),
          firsts(normals, all), firsts(colors, all)};
}

}  // namespace rigor::mesh
