// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Structs as bytes, and back, for what goes to a worker and comes from it. Private to the room.
//
// `Fields::visit(archive, whole)` names the fields of a struct in their order, once for both ways:
//
//   auto& [time, bodies] = whole;   // does not compile when a field is missing
//   archive(time, bodies);
//
//   ArchiveWriter<Fields> writer;
//   writer(scene);
//   ArchiveReader<Fields> reader(writer.bytes);
//   reader(scene);
//   if (!reader.done()) refuse();

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include <rigor/mass/mass_properties.h>
#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/simulate/engine/state.h>
#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

template <class T, class... Kinds>
constexpr bool kIsOneOf = (std::is_same_v<T, Kinds> || ...);

/// Copied as they are: they have no gaps between their members.
template <class T>
constexpr bool kArchivePlain =
    std::has_unique_object_representations_v<T> ||
    kIsOneOf<T, double, Vector3, Quaternion, Pose, BodyState, AxisState, mass::MassProperties,
             mesh::Box, mesh::Sphere, mesh::Cylinder, mesh::Capsule, HalfSpace, SceneMimic, Gains>;

template <class T>
constexpr bool kArchiveVector = false;
template <class T>
constexpr bool kArchiveVector<std::vector<T>> = true;

template <class T>
constexpr bool kArchiveOptional = false;
template <class T>
constexpr bool kArchiveOptional<std::optional<T>> = true;

template <class T>
constexpr bool kArchiveVariant = false;
template <class... T>
constexpr bool kArchiveVariant<std::variant<T...>> = true;

template <class Fields>
class ArchiveWriter {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }

  std::string bytes;

 private:
  void copy(const void* from, std::size_t size) {
    bytes.append(static_cast<const char*>(from), size);
  }

  template <class T>
  void put(const T& value) {
    if constexpr (std::is_same_v<T, std::string>) {
      put(std::uint64_t{value.size()});
      bytes += value;
    } else if constexpr (kArchiveVector<T>) {
      put(std::uint64_t{value.size()});
      if constexpr (kArchivePlain<typename T::value_type>) {
        copy(value.data(), value.size() * sizeof(typename T::value_type));
      } else {
        for (const auto& element : value) put(element);
      }
    } else if constexpr (kArchiveOptional<T>) {
      put(value.has_value());
      if (value) put(*value);
    } else if constexpr (kArchiveVariant<T>) {
      put(std::uint64_t{value.index()});
      std::visit([&](const auto& kind) { this->put(kind); }, value);
    } else if constexpr (kArchivePlain<T>) {
      copy(&value, sizeof value);
    } else {
      Fields::visit(*this, value);
    }
  }
};

/// Once something does not fit, nothing more is read.
template <class Fields>
class ArchiveReader {
 public:
  explicit ArchiveReader(std::string_view bytes) : rest_(bytes) {}

  template <class... T>
  void operator()(T&... values) {
    (get(values), ...);
  }

  bool done() const { return sound_ && rest_.empty(); }

 private:
  void copy(void* to, std::size_t size) {
    if (size > rest_.size()) sound_ = false;
    if (!sound_ || size == 0) return;
    std::memcpy(to, rest_.data(), size);
    rest_.remove_prefix(size);
  }

  /// Of elements that take a byte each at least.
  std::size_t size() {
    std::uint64_t wanted = 0;
    get(wanted);
    if (wanted > rest_.size()) sound_ = false;
    return sound_ ? static_cast<std::size_t>(wanted) : 0;
  }

  bool flag() {
    std::uint8_t value = 0;
    get(value);
    if (value > 1) sound_ = false;
    return sound_ && value == 1;
  }

  /// Makes `value` hold the kind with this number, and reads it.
  template <std::size_t kKind = 0, class T>
  void get_kind(std::uint64_t kind, T& value) {
    if constexpr (kKind == std::variant_size_v<T>) {
      sound_ = false;
    } else if (kind == kKind) {
      get(value.template emplace<kKind>());
    } else {
      get_kind<kKind + 1>(kind, value);
    }
  }

  template <class T>
  void get(T& value) {
    if constexpr (std::is_same_v<T, std::string>) {
      value.resize(size());
      copy(value.data(), value.size());
    } else if constexpr (std::is_same_v<T, bool>) {
      value = flag();
    } else if constexpr (kArchiveVector<T>) {
      using Element = typename T::value_type;
      const std::size_t count = size();
      if constexpr (kArchivePlain<Element>) {
        if (count > rest_.size() / sizeof(Element)) sound_ = false;
        if (!sound_) return;
        value.resize(count);
        copy(value.data(), count * sizeof(Element));
      } else {
        for (std::size_t i = 0; i < count && sound_; ++i) get(value.emplace_back());
      }
    } else if constexpr (kArchiveOptional<T>) {
      if (flag()) get(value.emplace());
    } else if constexpr (kArchiveVariant<T>) {
      std::uint64_t kind = 0;
      get(kind);
      get_kind(kind, value);
    } else if constexpr (kArchivePlain<T>) {
      copy(&value, sizeof value);
    } else {
      Fields::visit(*this, value);
    }
  }

  std::string_view rest_;
  bool sound_ = true;
};

}  // namespace rigor::simulate
