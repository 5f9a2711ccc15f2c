// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// STL, binary and ASCII. Binary: 80 bytes of header, a 32-bit count, 50 bytes a facet (normal,
// three corners as little-endian floats, two bytes of attributes). ASCII: `solid name`, facets with
// `vertex x y z` thrice, `endsolid`. Neither has a unit.
//
// The reader believes nothing: the count is checked against the size before anything is allocated,
// "solid" in a binary header is no ASCII file, keywords may be in any case, lines may end with CR,
// LF or both. What is beside the corners is not read: consumers take normals from the corners, and
// the colors that some writers put in the attributes follow no common rule.
//
//   LoadedMesh loaded = read_stl(bytes);

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include <rigor/mesh/read.h>
#include <rigor/text/disk.h>

namespace rigor::mesh {

inline constexpr std::size_t kStlHeaderBytes = 84;  ///< with the count
inline constexpr std::size_t kStlFacetBytes = 50;

/// Whether the size is just what the count asks for, which hardly befalls any other file. `size` is
/// the whole file's, of which `first_bytes` is the beginning (512 bytes or all).
bool stl_size_fits(std::string_view first_bytes, std::uint64_t size);

/// Whether the bytes are a binary STL: the size fits the count, or they are no text that begins
/// with "solid".
bool is_binary_stl(std::string_view first_bytes, std::uint64_t size);

/// The triangles that a binary STL really holds, which can be fewer than its count says.
std::uint64_t stl_triangles(std::string_view header, std::uint64_t size);

/// The corners of the facet whose 50 bytes begin at `bytes`.
Facet stl_facet(const char* bytes);

LoadedMesh read_stl(std::string_view bytes);

/// The same in blocks, of a binary STL that has the size that its count says; nothing when it is
/// something else, or the disk fails.
std::optional<LoadedMesh> read_plain_stl(const OpenFile& file);

}  // namespace rigor::mesh
