// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether what a glTF file leans on is long enough: accessors lie in buffer views, those in buffers,
// and the bytes of a buffer are somewhere (glTF 2.0, 3.6).
//
//   GltfRanges ranges;
//   for_each_scalar(json, [&](const JsonScalar& scalar) { ranges.take(scalar); });
//   ranges.hold(0, bytes_of_the_file);
//   if (ranges.overruns().count > 0) complain();

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <rigor/mesh/asset/asset.h>
#include <rigor/mesh/gltf/json.h>

namespace rigor::mesh {

class GltfRanges {
 public:
  /// What is of no buffer, view or accessor is passed over.
  void take(const JsonScalar& scalar);

  /// So many bytes of a buffer are there.
  void hold(std::uint64_t buffer, std::uint64_t bytes);
  /// The buffer says where its bytes are, be they there or not.
  void name(std::uint64_t buffer);

  GltfOverruns overruns() const;
  /// Buffers with bytes that are nowhere.
  Sighting nameless() const;

 private:
  struct Buffer {
    std::uint64_t promised = 0;
    std::optional<std::uint64_t> held = {};
    bool named = false;
  };
  struct View {
    std::optional<std::uint64_t> buffer = {};
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
    std::uint64_t stride = 0;
  };
  struct Accessor {
    std::optional<std::uint64_t> view = {};
    std::uint64_t offset = 0;
    std::uint64_t count = 0;
    std::uint64_t component = 0;  ///< bytes; 0 when not known
    std::uint64_t width = 0;      ///< components; 0 when not known
  };

  void take(Buffer& buffer, const JsonScalar& scalar) const;
  void take(View& view, const JsonScalar& scalar) const;
  void take(Accessor& accessor, const JsonScalar& scalar) const;

  /// The byte behind the last that the accessor reads of its view.
  static std::uint64_t end_of(const Accessor& accessor, const View& view);

  std::vector<Buffer> buffers_;
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
};

}  // namespace rigor::mesh
