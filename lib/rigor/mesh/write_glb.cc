// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// glTF 2.0 in one binary file (Khronos, "glTF 2.0 specification", 4.4): a header, a chunk of JSON,
// and a chunk of bytes in which each part has its positions, then its indices.

#include <array>
#include <string>

#include <rigor/mesh/write.h>
#include <rigor/mesh/write_parts.h>

namespace rigor::mesh {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;  // "glTF"
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;  // "BIN\0"
constexpr std::uint32_t kHeaderBytes = 12;
constexpr std::size_t kAlignment = 4;

/// A string of JSON, in quotes (RFC 8259, 7).
std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : clean(name)) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}

/// A member of an object with a comma before it, or nothing for an empty name.
std::string name_member(const std::string& name) {
  return name.empty() ? "" : ",\"name\":" + quoted(name);
}

std::string array(const std::vector<std::string>& items) {
  std::string text = "[";
  for (const std::string& item : items) {
    if (text.size() > 1) text += ',';
    text += item;
  }
  return text + ']';
}

std::string array(const Vector3& p) {
  std::array<std::string, 3> numbers;
  append_number(numbers[0], p.x);
  append_number(numbers[1], p.y);
  append_number(numbers[2], p.z);
  return array({numbers.begin(), numbers.end()});
}

class Glb {
 public:
  void add(const Part& part, const Welded& shape, std::size_t material) {
    const std::string mesh = std::to_string(nodes_.size());
    const std::size_t positions = add_positions(shape.positions);
    const std::size_t indices = add_indices(shape.triangles);
    roots_.push_back(mesh);
    nodes_.push_back("{\"mesh\":" + mesh + name_member(part.name) + '}');
    meshes_.push_back(
        "{\"primitives\":[{\"attributes\":{\"POSITION\":" + std::to_string(positions) +
        "},\"indices\":" + std::to_string(indices) + ",\"material\":" + std::to_string(material) +
        "}]" + name_member(part.name) + '}');
  }

  /// Of a material only the name is known. The format's default would be bare metal, which is black
  /// where nothing is around to be mirrored.
  void add_material(const std::string& name) {
    materials_.push_back("{\"pbrMetallicRoughness\":{\"metallicFactor\":0}" + name_member(name) +
                         '}');
  }

  std::string bytes() const {
    std::string json = this->json();
    json.append((kAlignment - json.size() % kAlignment) % kAlignment, ' ');
    std::string chunks;
    append_chunk(chunks, kJsonChunk, json);
    if (!binary_.empty()) append_chunk(chunks, kBinaryChunk, binary_);
    std::string file;
    append_bytes(file, kMagic);
    append_bytes(file, kVersion);
    append_bytes(file, static_cast<std::uint32_t>(kHeaderBytes + chunks.size()));
    return file + chunks;
  }

 private:
  static void append_chunk(std::string& into, std::uint32_t kind, const std::string& content) {
    append_bytes(into, static_cast<std::uint32_t>(content.size()));
    append_bytes(into, kind);
    into += content;
  }

  std::size_t add_positions(const std::vector<Vector3>& positions) {
    const std::size_t begin = binary_.size();
    for (const Vector3& p : positions) {
      for (const double coordinate : {p.x, p.y, p.z}) {
        append_bytes(binary_, static_cast<float>(coordinate));
      }
    }
    const Bounds bounds = bounds_of(positions);
    return add_accessor(begin, "34962",
                        "\"componentType\":5126,\"count\":" + std::to_string(positions.size()) +
                            ",\"type\":\"VEC3\",\"min\":" + array(bounds.min) +
                            ",\"max\":" + array(bounds.max));
  }

  std::size_t add_indices(const std::vector<Triangle>& triangles) {
    const std::size_t begin = binary_.size();
    for (const Triangle& t : triangles) {
      for (const std::uint32_t corner : t) append_bytes(binary_, corner);
    }
    return add_accessor(begin, "34963",
                        "\"componentType\":5125,\"count\":" + std::to_string(3 * triangles.size()) +
                            ",\"type\":\"SCALAR\"");
  }

  /// Of what has been appended since `begin`, which gets a view of its own.
  std::size_t add_accessor(std::size_t begin, const std::string& target, const std::string& rest) {
    const std::size_t index = accessors_.size();
    views_.push_back("{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) + ",\"byteLength\":" +
                     std::to_string(binary_.size() - begin) + ",\"target\":" + target + '}');
    accessors_.push_back("{\"bufferView\":" + std::to_string(index) + ',' + rest + '}');
    return index;
  }

  /// The format has no empty lists.
  std::string json() const {
    if (nodes_.empty()) return R"({"asset":{"version":"2.0"}})";
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":)" + array(roots_) +
           "}],\"nodes\":" + array(nodes_) + ",\"meshes\":" + array(meshes_) +
           ",\"materials\":" + array(materials_) + ",\"accessors\":" + array(accessors_) +
           ",\"bufferViews\":" + array(views_) +
           ",\"buffers\":[{\"byteLength\":" + std::to_string(binary_.size()) + "}]}";
  }

  std::vector<std::string> roots_;
  std::vector<std::string> nodes_;
  std::vector<std::string> meshes_;
  std::vector<std::string> materials_;
  std::vector<std::string> accessors_;
  std::vector<std::string> views_;
  std::string binary_;
};

}  // namespace

std::string write_glb(const TriangleMesh& mesh) {
  const std::vector<Part> parts = parts_with_triangles(mesh);
  const Materials materials = materials_of(parts);
  Glb glb;
  for (const std::string& name : materials.names) glb.add_material(name);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    glb.add(parts[i], welded(mesh, parts[i], Precision::kFloat), materials.of_part[i]);
  }
  return glb.bytes();
}

}  // namespace rigor::mesh
