// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/importer/flat.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace rigor::mesh {
namespace {

class FlatWriter {
 public:
  template <class T>
  void value(T value) {
    append(&value, sizeof value);
  }

  void number(std::uint64_t number) { value(number); }

  template <class T>
  void list(const T& values) {
    static_assert(std::is_trivially_copyable_v<typename T::value_type>);
    number(values.size());
    append(values.data(), values.size() * sizeof(typename T::value_type));
  }

  std::string take() { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }

  std::string bytes_;
};

/// Once something does not fit, `good` is false and all that follows is empty.
class FlatReader {
 public:
  explicit FlatReader(std::string_view bytes) : bytes_(bytes) {}

  bool good() const { return good_; }
  bool at_end() const { return bytes_.empty(); }

  template <class T>
  T value() {
    T value{};
    if (fits(1, sizeof value)) take(&value, sizeof value);
    return value;
  }

  std::uint64_t number() { return value<std::uint64_t>(); }

  template <class T>
  T list() {
    constexpr std::size_t kSize = sizeof(typename T::value_type);
    const std::uint64_t count = number();
    T values;
    if (!fits(count, kSize)) return values;
    values.resize(static_cast<std::size_t>(count));
    take(values.data(), values.size() * kSize);
    return values;
  }

  template <class E>
  E enumerator(E last) {
    const std::uint64_t value = number();
    good_ = good_ && value <= static_cast<std::uint64_t>(last);
    return good_ ? static_cast<E>(value) : E{};
  }

 private:
  bool fits(std::uint64_t count, std::size_t size) {
    good_ = good_ && count <= bytes_.size() / size;
    return good_;
  }
  void take(void* into, std::size_t size) {
    if (size > 0) std::memcpy(into, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }

  std::string_view bytes_;
  bool good_ = true;
};

bool corners_exist(const TriangleMesh& mesh) {
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    return std::max({t[0], t[1], t[2]}) < mesh.positions.size();
  });
}

/// Each list of the corners is empty or as long as the triangles'.
bool lists_fit(const TriangleMesh& mesh) {
  const auto fits = [&mesh](const auto& list) {
    return list.empty() || list.size() == mesh.triangles.size();
  };
  const Corners& corners = mesh.corners;
  return fits(corners.texture) && fits(corners.normals) && fits(corners.colors);
}

/// Each once, in the order of the materials.
using EmbeddedPicture = std::shared_ptr<const std::string>;
std::vector<EmbeddedPicture> embedded_pictures(const TriangleMesh& mesh) {
  std::vector<EmbeddedPicture> pictures;
  for (const Material& material : mesh.materials) {
    const EmbeddedPicture& picture = material.embedded_picture;
    if (picture && std::find(pictures.begin(), pictures.end(), picture) == pictures.end()) {
      pictures.push_back(picture);
    }
  }
  return pictures;
}

/// 0 for none.
std::uint64_t number_of(const EmbeddedPicture& picture, const std::vector<EmbeddedPicture>& all) {
  if (!picture) return 0;
  return static_cast<std::uint64_t>(std::find(all.begin(), all.end(), picture) - all.begin()) + 1;
}

bool parts_cover(const TriangleMesh& mesh) {
  std::size_t next = 0;
  for (const Part& part : mesh.parts) {
    if (part.first != next || part.count > mesh.triangles.size() - next) return false;
    next += part.count;
  }
  return next == mesh.triangles.size();
}

}  // namespace

std::string flatten(const LoadedMesh& loaded) {
  FlatWriter writer;
  writer.number(static_cast<std::uint64_t>(loaded.format));
  writer.list(loaded.mesh.positions);
  writer.list(loaded.mesh.triangles);
  writer.number(loaded.mesh.parts.size());
  for (const Part& part : loaded.mesh.parts) {
    writer.list(part.name);
    writer.list(part.material);
    writer.number(part.first);
    writer.number(part.count);
  }
  const std::vector<EmbeddedPicture> pictures = embedded_pictures(loaded.mesh);
  writer.number(pictures.size());
  for (const EmbeddedPicture& picture : pictures) writer.list(*picture);
  writer.number(loaded.mesh.materials.size());
  for (const Material& material : loaded.mesh.materials) {
    writer.list(material.name);
    for (const float part : material.diffuse) writer.value(part);
    writer.list(material.texture);
    writer.number(number_of(material.embedded_picture, pictures));
    writer.number(material.picture_opacity ? 1 : 0);
  }
  writer.list(loaded.mesh.corners.texture);
  writer.list(loaded.mesh.corners.normals);
  writer.list(loaded.mesh.corners.colors);
  writer.number(loaded.faults.size());
  for (const Fault& fault : loaded.faults) {
    writer.number(static_cast<std::uint64_t>(fault.kind));
    writer.list(fault.detail);
    writer.number(fault.count);
    writer.number(fault.line);
  }
  return writer.take();
}

std::optional<LoadedMesh> unflatten(std::string_view bytes) {
  FlatReader reader(bytes);
  LoadedMesh loaded;
  TriangleMesh& mesh = loaded.mesh;
  loaded.format = reader.enumerator(Format::kOther);
  mesh.positions = reader.list<std::vector<Vector3>>();
  mesh.triangles = reader.list<std::vector<Triangle>>();
  for (std::uint64_t left = reader.number(); left > 0 && reader.good(); --left) {
    Part& part = mesh.parts.emplace_back();
    part.name = reader.list<std::string>();
    part.material = reader.list<std::string>();
    part.first = reader.number();
    part.count = reader.number();
  }
  std::vector<EmbeddedPicture> pictures{nullptr};
  for (std::uint64_t left = reader.number(); left > 0 && reader.good(); --left) {
    pictures.push_back(std::make_shared<const std::string>(reader.list<std::string>()));
  }
  for (std::uint64_t left = reader.number(); left > 0 && reader.good(); --left) {
    Material& material = mesh.materials.emplace_back();
    material.name = reader.list<std::string>();
    for (float& part : material.diffuse) part = reader.value<float>();
    material.texture = reader.list<std::string>();
    const std::uint64_t picture = reader.number();
    if (picture >= pictures.size()) return std::nullopt;
    material.embedded_picture = pictures[picture];
    material.picture_opacity = reader.number() != 0;
  }
  mesh.corners.texture = reader.list<decltype(Corners::texture)>();
  mesh.corners.normals = reader.list<decltype(Corners::normals)>();
  mesh.corners.colors = reader.list<decltype(Corners::colors)>();
  for (std::uint64_t left = reader.number(); left > 0 && reader.good(); --left) {
    Fault& fault = loaded.faults.emplace_back();
    fault.kind = reader.enumerator(FaultKind::kExtensionMismatch);
    fault.detail = reader.list<std::string>();
    fault.count = reader.number();
    fault.line = reader.number();
  }
  const bool whole = reader.good() && reader.at_end() && corners_exist(mesh) && parts_cover(mesh) &&
                     lists_fit(mesh);
  return whole ? std::optional(std::move(loaded)) : std::nullopt;
}

}  // namespace rigor::mesh
