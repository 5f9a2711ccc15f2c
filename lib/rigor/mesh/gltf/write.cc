// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// glTF 2.0 in one binary file (Khronos, "glTF 2.0 specification", 4.4): a header, a chunk of JSON,
// and a chunk of bytes in which each part has what its vertices carry, then its indices.

#include <array>
#include <map>
#include <string>

#include <rigor/mesh/image/embedded_pictures.h>
#include <rigor/mesh/write/parts.h>
#include <rigor/mesh/write/write.h>

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

template <class Number, std::size_t kSize>
std::string array(const std::array<Number, kSize>& numbers) {
  std::vector<std::string> items(kSize);
  for (std::size_t i = 0; i < kSize; ++i) append_number(items[i], double{numbers[i]});
  return array(items);
}

std::string array(const Vector3& p) { return array(std::array<double, 3>{p.x, p.y, p.z}); }

class Glb {
 public:
  void add(const Part& part, const Welded& shape, std::size_t material) {
    const std::string mesh = std::to_string(nodes_.size());
    std::string attributes = "\"POSITION\":" + std::to_string(add_positions(shape.positions));
    const auto add_attribute = [&](const char* name, const char* type, const auto& values) {
      if (values.empty()) return;
      attributes += std::string(",\"") + name + "\":" + std::to_string(add_values(type, values));
    };
    add_attribute("NORMAL", "VEC3", shape.normals);
    add_attribute("TEXCOORD_0", "VEC2", turned(shape.texture));
    add_attribute("COLOR_0", "VEC4", shape.colors);
    const std::size_t indices = add_indices(shape.triangles);
    roots_.push_back(mesh);
    nodes_.push_back("{\"mesh\":" + mesh + name_member(part.name) + '}');
    meshes_.push_back("{\"primitives\":[{\"attributes\":{" + attributes + "},\"indices\":" +
                      std::to_string(indices) + ",\"material\":" + std::to_string(material) + "}]" +
                      name_member(part.name) + '}');
  }

  /// The format's default would be bare metal, which is black where nothing is around to be
  /// mirrored.
  void add_material(const Look& look) {
    std::string surface = "\"metallicFactor\":0";
    std::string rest;
    if (look.material) {
      surface += ",\"baseColorFactor\":" + array(look.material->diffuse);
      surface += picture_member(*look.material);
      if (look.material->diffuse.back() != 1) rest = ",\"alphaMode\":\"BLEND\"";
    }
    materials_.push_back("{\"pbrMetallicRoughness\":{" + surface + '}' + rest +
                         name_member(look.name) + '}');
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

  /// Of a surface, if it has a picture.
  std::string picture_member(const Material& material) {
    const PictureKind kind = kind_of(material.embedded_picture);
    std::size_t index = images_.size();
    if (!material.texture.empty()) {
      add_image("\"uri\":" + quoted(uri(material.texture)));
    } else if (kind == PictureKind::kPng || kind == PictureKind::kJpeg) {
      const auto [known, is_new] = held_.try_emplace(material.embedded_picture, index);
      index = known->second;
      if (is_new) add_held(*material.embedded_picture, kind);
    } else {
      return {};
    }
    return ",\"baseColorTexture\":{\"index\":" + std::to_string(index) + '}';
  }

  void add_held(const std::string& bytes, PictureKind kind) {
    const std::size_t begin = binary_.size();
    binary_ += bytes;
    add_image("\"bufferView\":" + std::to_string(add_view(begin, "")) + ",\"mimeType\":\"image/" +
              (kind == PictureKind::kPng ? "png" : "jpeg") + '"');
    binary_.append((kAlignment - binary_.size() % kAlignment) % kAlignment, '\0');
  }

  void add_image(const std::string& members) {
    textures_.push_back("{\"source\":" + std::to_string(images_.size()) + '}');
    images_.push_back('{' + members + '}');
  }

  /// With v down from the picture's upper edge, as the format has it.
  static std::vector<Corners::Texture> turned(std::vector<Corners::Texture> texture) {
    for (auto& [u, v] : texture) v = 1 - v;
    return texture;
  }

  template <class Value>
  std::size_t add_values(const std::string& type, const std::vector<Value>& values) {
    const std::size_t begin = binary_.size();
    for (const Value& value : values) append_bytes(binary_, value);
    return add_accessor(begin, "34962",
                        "\"componentType\":5126,\"count\":" + std::to_string(values.size()) +
                            ",\"type\":\"" + type + '"');
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
    const std::size_t view = add_view(begin, ",\"target\":" + target);
    accessors_.push_back("{\"bufferView\":" + std::to_string(view) + ',' + rest + '}');
    return accessors_.size() - 1;
  }

  std::size_t add_view(std::size_t begin, const std::string& rest) {
    views_.push_back("{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) +
                     ",\"byteLength\":" + std::to_string(binary_.size() - begin) + rest + '}');
    return views_.size() - 1;
  }

  /// The format has no empty lists.
  std::string json() const {
    std::string text = R"({"asset":{"version":"2.0"})";
    if (nodes_.empty()) return text + '}';
    text += R"(,"scene":0,"scenes":[{"nodes":)" + array(roots_) + "}]";
    const auto add = [&text](const char* name, const std::vector<std::string>& items) {
      if (!items.empty()) text += std::string(",\"") + name + "\":" + array(items);
    };
    add("nodes", nodes_);
    add("meshes", meshes_);
    add("materials", materials_);
    add("textures", textures_);
    add("images", images_);
    add("accessors", accessors_);
    add("bufferViews", views_);
    return text + ",\"buffers\":[{\"byteLength\":" + std::to_string(binary_.size()) + "}]}";
  }

  std::vector<std::string> roots_;
  std::vector<std::string> nodes_;
  std::vector<std::string> meshes_;
  std::vector<std::string> materials_;
  std::vector<std::string> textures_;
  std::vector<std::string> images_;
  std::vector<std::string> accessors_;
  std::vector<std::string> views_;
  std::map<std::shared_ptr<const std::string>, std::size_t> held_;  // images
  std::string binary_;
};

}  // namespace

std::string write_glb(const TriangleMesh& mesh) {
  const std::vector<Part> parts = parts_with_triangles(mesh);
  const Looks looks = looks_of(mesh, parts);
  const PartCorners corners(mesh);
  Glb glb;
  for (const Look& look : looks.looks) glb.add_material(look);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    glb.add(parts[i], welded(mesh, parts[i], corners.of(parts[i]), Precision::kFloat),
            looks.of_part[i]);
  }
  return glb.bytes();
}

}  // namespace rigor::mesh
