// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The <input> children of a group of polygons, or of <vertices>: which sources corners draw on, and
// where in a <p> their indices stand.
//
//   const ColladaInputs inputs = collada_inputs(triangles);
//   ColladaCornerReader corners(p.text(), inputs);
//   while (auto corner = corners.next()) use((*corner)[kColladaNormal]);

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include <rigor/mesh/collada/index.h>
#include <rigor/mesh/text_cursor.h>

namespace rigor::mesh {

// What a corner has. Tangents, and all but the first set of texture points and of colors, are
// passed over, as mesh/importer/bake.h does.
inline constexpr std::size_t kColladaPosition = 0;
inline constexpr std::size_t kColladaTexture = 1;
inline constexpr std::size_t kColladaNormal = 2;
inline constexpr std::size_t kColladaColor = 3;
inline constexpr std::size_t kColladaKinds = 4;

/// Numbers that one of each has.
inline constexpr std::array<std::size_t, kColladaKinds> kColladaWidths{3, 2, 3, 4};

struct ColladaInput {
  std::string_view source;  ///< url; empty without such an input
  std::uint64_t offset = 0;
};

struct ColladaInputs {
  /// Of a group, the position's source is its VERTEX input, which names <vertices>.
  std::array<ColladaInput, kColladaKinds> of;
  std::uint64_t stride = 1;  ///< indices of one corner, side by side
};

/// Of several of a kind the one with the lowest set counts, and of those the first.
ColladaInputs collada_inputs(xml::Element holder);

/// For each kind the index that a corner names, or kNoColladaIndex, which is none of any source.
using ColladaCorner = std::array<std::uint32_t, kColladaKinds>;
inline constexpr std::uint32_t kNoColladaIndex = 0xffffffffU;

/// The corners of a <p>, one by one.
class ColladaCornerReader {
 public:
  /// The inputs must outlive the reader.
  ColladaCornerReader(std::string_view text, const ColladaInputs& inputs)
      : cursor_(text), inputs_(inputs) {}

  /// Nothing at the end, or when something is no index.
  std::optional<ColladaCorner> next();

  bool at_end() {
    cursor_.skip_space();
    return cursor_.at_end();
  }
  bool failed() const { return failed_; }  ///< at something that is no index

 private:
  TextCursor cursor_;
  const ColladaInputs& inputs_;
  bool failed_ = false;
};

}  // namespace rigor::mesh
