// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Each struct's members are named once, for writing and for reading. A
// structured binding names all members or does not compile, so that none that
// is added can be forgotten.

#include <rigor/mass/mesh/facts_code.h>

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace rigor::mass {
namespace {

// ---- What there is

template <class Use>
void members(model::Vector3& v, const Use& use) {
  auto& [x, y, z] = v;
  use(x, y, z);
}

template <class Use>
void members(mesh::Bounds& v, const Use& use) {
  auto& [min, max] = v;
  use(min, max);
}

template <class Use>
void members(mesh::Fault& v, const Use& use) {
  auto& [kind, detail, count, line] = v;
  use(kind, detail, count, line);
}

template <class Use>
void members(mesh::FileReference& v, const Use& use) {
  auto& [written, path, state, from, line, bytes, width, height] = v;
  use(written, path, state, from, line, bytes, width, height);
}

template <class Use>
void members(mesh::Sighting& v, const Use& use) {
  auto& [count, first] = v;
  use(count, first);
}

template <class Use>
void members(mesh::ColladaFacts& v, const Use& use) {
  auto& [version, tool, unit_name, meter, unit_line, up_axis, up_axis_line, cameras, lights,
         animations, controllers, lines, instance_nodes, repeated, missing, double_sided, mirrored,
         sheared, unevenly_scaled, unclear] = v;
  use(version, tool, unit_name, meter, unit_line, up_axis, up_axis_line, cameras, lights,
      animations, controllers, lines, instance_nodes, repeated, missing, double_sided, mirrored,
      sheared, unevenly_scaled, unclear);
}

template <class Use>
void members(mesh::StlFacts& v, const Use& use) {
  auto& [header, binary, solid_header, color_header, facets, attributes, zero, odd, contrary] = v;
  use(header, binary, solid_header, color_header, facets, attributes, zero, odd, contrary);
}

template <class Use>
void members(mesh::ObjFacts& v, const Use& use) {
  auto& [libraries] = v;
  use(libraries);
}

template <class Use>
void members(mesh::GltfOverruns& v, const Use& use) {
  auto& [count, of, index, needed, held] = v;
  use(count, of, index, needed, held);
}

template <class Use>
void members(mesh::GltfFacts& v, const Use& use) {
  auto& [version, generator, extensions_required, buffers, nameless_buffers, overruns] = v;
  use(version, generator, extensions_required, buffers, nameless_buffers, overruns);
}

template <class Use>
void members(mesh::Mention& v, const Use& use) {
  auto& [name, line] = v;
  use(name, line);
}

template <class Use>
void members(mesh::Asset& v, const Use& use) {
  auto& [format, problem, collada, stl, obj, gltf, textures, undefined_materials] = v;
  use(format, problem, collada, stl, obj, gltf, textures, undefined_materials);
}

template <class Use>
void members(mesh::Example& v, const Use& use) {
  auto& [defect, index, at] = v;
  use(defect, index, at);
}

template <class Use>
void members(mesh::Boundary& v, const Use& use) {
  auto& [loops, longest_edges, longest_length, total_length] = v;
  use(loops, longest_edges, longest_length, total_length);
}

template <class Use>
void members(mesh::Component& v, const Use& use) {
  auto& [first_face, triangles, bounds, volume, closed, nesting, inside] = v;
  use(first_face, triangles, bounds, volume, closed, nesting, inside);
}

template <class Use>
void members(mesh::Topology& v, const Use& use) {
  auto& [vertices, edges, triangles, boundary_edges, nonmanifold_edges, inconsistent_edges,
         nonmanifold_vertices, degenerate, zero_area, slivers, duplicates, unreferenced, examples,
         boundary, components, inverted, cavities, doubled, not_nested, list] = v;
  use(vertices, edges, triangles, boundary_edges, nonmanifold_edges, inconsistent_edges,
      nonmanifold_vertices, degenerate, zero_area, slivers, duplicates, unreferenced, examples,
      boundary, components, inverted, cavities, doubled, not_nested, list);
}

template <class Use>
void members(PolyhedronMoments& v, const Use& use) {
  auto& [reference, volume, first, second, area, area_vector] = v;
  use(reference, volume, first, second, area, area_vector);
}

template <class Use>
void members(mesh::Intersection& v, const Use& use) {
  auto& [triangles, at] = v;
  use(triangles, at);
}

template <class Use>
void members(mesh::SelfIntersections& v, const Use& use) {
  auto& [pairs, complete, left_out, examples] = v;
  use(pairs, complete, left_out, examples);
}

template <class Use>
void members(MeshShape& v, const Use& use) {
  auto& [topology, moments, convex, self_intersections] = v;
  use(topology, moments, convex, self_intersections);
}

template <class Use>
void members(MeshFacts& v, const Use& use) {
  auto& [path, bytes, format, faults, asset, triangles, largest_part, normals, bounds, shape] = v;
  use(path, bytes, format, faults, asset, triangles, largest_part, normals, bounds, shape);
}

template <class Use>
void members(Witness& v, const Use& use) {
  auto& [question, path, answer] = v;
  use(question, path, answer);
}

template <class Use>
void members(mesh::Winding& v, const Use& use) {
  auto& [doubled, inverted, lines] = v;
  use(doubled, inverted, lines);
}

template <class Use>
void members(MeshSurvey& v, const Use& use) {
  auto& [format, faults, triangles, bounds, moments, closed, winding, topology, hull, pyramids,
         pyramids_as_wound, sheet] = v;
  static_cast<void>(sheet);  // one with a sheet is not kept
  use(format, faults, triangles, bounds, moments, closed, winding, topology, hull, pyramids,
      pyramids_as_wound);
}

template <class Use>
void members(CachedMesh& v, const Use& use) {
  auto& [witnesses, importer, found] = v;
  use(witnesses, importer, found);
}

// ---- How it is written: numbers in eight bytes, the lowest first; lists after
// their lengths

using FactsNumber = std::uint64_t;

template <class T>
concept FactsInteger = std::integral<T> || std::is_enum_v<T>;  // also bool

class FactsWriter {
 public:
  std::string take() { return std::move(bytes_); }

  void code(FactsInteger auto& v) { number(static_cast<FactsNumber>(v)); }
  void code(double& v) { number(std::bit_cast<FactsNumber>(v)); }

  void code(std::string& v) {
    number(v.size());
    bytes_ += v;
  }

  void code(Digest& v) { bytes_ += digest_bytes(v); }

  template <class T>
  void code(std::vector<T>& v) {
    number(v.size());
    for (T& each : v) code(each);
  }

  template <class T, std::size_t size>
  void code(std::array<T, size>& v) {
    for (T& each : v) code(each);
  }

  template <class T>
  void code(std::optional<T>& v) {
    number(v ? 1 : 0);
    if (v) code(*v);
  }

  void code(std::variant<MeshFacts, MeshSurvey>& v) {
    number(v.index());
    std::visit([this](auto& found) { code(found); }, v);
  }

  template <class T>
  void code(T& v) {
    members(v, [&](auto&... each) { (code(each), ...); });
  }

 private:
  void number(FactsNumber v) {
    for (unsigned i = 0; i < 8; ++i) bytes_ += static_cast<char>(v >> (8 * i));
  }

  std::string bytes_;
};

/// After the first thing that is not there, everything is zero or empty.
class FactsReader {
 public:
  explicit FactsReader(std::string_view bytes) : rest_(bytes) {}

  bool whole() const { return !failed_ && rest_.empty(); }

  void code(FactsInteger auto& v) {
    v = static_cast<std::remove_reference_t<decltype(v)>>(number());
  }
  void code(double& v) { v = std::bit_cast<double>(number()); }

  void code(std::string& v) {
    v = rest_.substr(0, length());
    rest_.remove_prefix(v.size());
  }

  void code(Digest& v) {
    const std::string_view bytes = rest_.substr(0, v.size());
    failed_ = failed_ || bytes.size() < v.size();
    std::copy(bytes.begin(), bytes.end(), v.begin());
    rest_.remove_prefix(bytes.size());
  }

  template <class T>
  void code(std::vector<T>& v) {
    for (FactsNumber left = length(); left > 0 && !failed_; --left) code(v.emplace_back());
  }

  template <class T, std::size_t size>
  void code(std::array<T, size>& v) {
    for (T& each : v) code(each);
  }

  template <class T>
  void code(std::optional<T>& v) {
    if (number() != 0) code(v.emplace());
  }

  void code(std::variant<MeshFacts, MeshSurvey>& v) {
    if (number() != 0) v.emplace<MeshSurvey>();
    std::visit([this](auto& found) { code(found); }, v);
  }

  template <class T>
  void code(T& v) {
    members(v, [&](auto&... each) { (code(each), ...); });
  }

 private:
  /// Of what has a byte at least for each of so many.
  FactsNumber length() {
    const FactsNumber v = number();
    if (v <= rest_.size()) return v;
    failed_ = true;
    return 0;
  }

  FactsNumber number() {
    if (failed_ || rest_.size() < 8) {
      failed_ = true;
      return 0;
    }
    FactsNumber v = 0;
    for (unsigned i = 8; i-- > 0;) v = v << 8U | static_cast<unsigned char>(rest_[i]);
    rest_.remove_prefix(8);
    return v;
  }

  std::string_view rest_;
  bool failed_ = false;
};

}  // namespace

std::string encode(CachedMesh entry) {
  FactsWriter writer;
  writer.code(entry);
  return writer.take();
}

std::optional<CachedMesh> decode(std::string_view bytes) {
  FactsReader reader(bytes);
  CachedMesh entry;
  reader.code(entry);
  if (!reader.whole()) return std::nullopt;
  return entry;
}

}  // namespace rigor::mass
