// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The readers behind asset_of, one a format. None believes a file: damage ends the reading with what
// was understood so far.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <rigor/mesh/asset/asset.h>
#include <rigor/text/disk.h>

namespace rigor::mesh {

/// Of a name or another text that is copied from a file, which is some words long.
inline constexpr std::size_t kMaxCopiedText = 256;

/// Piece by piece, so that a file of any size takes no memory.
StlFacts binary_stl_facts(const OpenFile& file);
StlFacts ascii_stl_facts(std::string_view bytes);

Asset obj_asset(const Disk& disk, const std::string& path, std::string_view bytes);
Asset collada_asset(const Disk& disk, const std::string& path, std::string_view bytes);
/// Of a .gltf or the JSON of a .glb.
Asset gltf_asset(const Disk& disk, const std::string& path, std::string_view bytes);

}  // namespace rigor::mesh
