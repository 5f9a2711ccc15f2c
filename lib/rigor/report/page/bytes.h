// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers of meshes as a page holds them: small, and read by a browser without parsing. Positions are
// whole numbers of 16 bits between a mesh's own bounds, normals of 8; corners that are the same then are one
// vertex. All of it is one zlib stream in base64.
//
//   PageBytes bytes;
//   const PageMesh wheel = bytes.add(mesh, Textured::kNo);
//   page += bytes.text();

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::report {

/// Of the bytes before they are compressed; `at` is a multiple of four.
struct ByteRange {
  std::size_t at = 0;
  std::size_t bytes = 0;
};

/// Numbers are little-endian; those of a vertex or triangle stand side by side.
struct PageMesh {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  /// A position is `low` + `step` times what is written, axis by axis; m.
  mesh::Vector3 low;
  mesh::Vector3 step;
  ByteRange positions;               ///< 3 x uint16
  std::optional<ByteRange> normals;  ///< 3 x int8, of 127
  std::optional<ByteRange> uvs;      ///< 2 x float32
  std::optional<ByteRange> colors;   ///< 4 x uint8
  ByteRange indices;  ///< 3 x uint16; uint32 where there are more than 65,535 vertices
};

/// Whether places in a picture are kept: many files have them for pictures that are not there.
enum class Textured : std::uint8_t { kNo, kYes };

class PageBytes {
 public:
  /// Triangles keep their number and order.
  PageMesh add(const mesh::TriangleMesh& mesh, Textured textured);

  /// Base64 of a zlib stream; empty when nothing was added. Throws std::bad_alloc where memory is short.
  std::string text() const;

 private:
  ByteRange append(const std::string& numbers);

  std::string bytes_;
};

}  // namespace rigor::report
