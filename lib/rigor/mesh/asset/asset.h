// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a mesh file says and holds beside its triangles: units and axes as they are written, what
// consumers pass over, the files that it names. Read from the bytes themselves, without the importer
// of scenes, so that nothing is made good on the way.
//
//   Asset asset = asset_of(disk, "meshes/arm.dae", Format::kCollada);
//   if (asset.collada && !asset.collada->meter) say("no unit is written");
//   for (const FileReference& texture : asset.textures) look_at(texture.state);

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rigor/mesh/asset/file_reference.h>
#include <rigor/mesh/read.h>
#include <rigor/text/disk.h>

namespace rigor::mesh {

/// How often something is there, and where first: its line in a text format, its number from 1 in a
/// binary one.
struct Sighting {
  std::uint64_t count = 0;
  std::uint64_t first = 0;

  void add(std::uint64_t place) {
    if (count++ == 0) first = place;
  }
  bool operator==(const Sighting&) const = default;
};

struct ColladaFacts {
  enum class Up : std::uint8_t { kNotWritten, kX, kY, kZ, kOther };

  std::string version;
  std::string authoring_tool;
  std::string unit_name;
  std::optional<double> meter;  ///< of a unit; nothing when it is not written, or no number
  std::uint64_t unit_line = 0;  ///< 0 without a <unit>
  Up up_axis = Up::kNotWritten;
  std::uint64_t up_axis_line = 0;

  Sighting cameras;
  Sighting lights;
  Sighting animations;
  Sighting controllers;
  Sighting lines;  ///< groups of lines or line strips
  Sighting instance_nodes;
  Sighting repeated_geometries;  ///< that are instanced more than once
  Sighting missing_geometries;   ///< instances of what the file has not
  Sighting double_sided;

  // Of nodes that hold shapes, by their own transform.
  Sighting mirrored_nodes;         ///< a negative determinant
  Sighting sheared_nodes;          ///< axes that are not square to each other
  Sighting unevenly_scaled_nodes;  ///< axes of different lengths
  Sighting unclear_nodes;          ///< a transform that is damaged, a skew or a lookat
};

struct StlFacts {
  std::string header;  ///< 80 bytes, or the rest of the line of `solid`; without zeros behind
  bool binary = false;
  bool solid_header = false;  ///< a binary file that begins with "solid"
  bool color_header = false;  ///< "COLOR=", as Materialise Magics writes it
  std::uint64_t facets = 0;
  Sighting attributes;  ///< facets whose two bytes of attributes are not zero
  Sighting zero_normals;
  Sighting odd_normals;       ///< a number that is NaN, infinite or none
  Sighting contrary_normals;  ///< more than 90° from what the winding says
};

struct ObjFacts {
  std::vector<FileReference> libraries;  ///< the files of `mtllib`
};

/// Pieces of a glTF file that are shorter than what stands in them: how many, and the first.
struct GltfOverruns {
  enum class Of : std::uint8_t {
    kBuffer,    ///< in its file
    kView,      ///< in its buffer
    kAccessor,  ///< in its buffer view
    kChunk,     ///< the text of a .glb, in the multiple of four bytes that it is to be filled up to
  };

  std::uint64_t count = 0;
  Of of = Of::kBuffer;
  std::uint64_t index = 0;   ///< from 0, as the file counts
  std::uint64_t needed = 0;  ///< bytes
  std::uint64_t held = 0;    ///< bytes

  bool operator==(const GltfOverruns&) const = default;
};

struct GltfFacts {
  std::string version;
  std::string generator;
  std::vector<std::string> extensions_required;
  std::vector<FileReference> buffers;  ///< that are not inside a .glb
  Sighting nameless_buffers;           ///< with bytes that are nowhere; numbered from 1
  GltfOverruns overruns;
};

/// A name, and the line where it first stands.
struct Mention {
  std::string name;
  std::uint64_t line = 0;

  bool operator==(const Mention&) const = default;
};

/// More files of one kind that a mesh names are not looked for: the most seen is 60.
inline constexpr std::size_t kMaxReferences = 1000;

struct Asset {
  Format format = Format::kUnknown;
  std::string problem = {};  ///< why nothing could be told of the file; else empty

  // One of them, by the format; of PLY and others there is nothing to tell.
  std::optional<ColladaFacts> collada = {};
  std::optional<StlFacts> stl = {};
  std::optional<ObjFacts> obj = {};
  std::optional<GltfFacts> gltf = {};

  /// Each time one is named, in the order of the file.
  std::vector<FileReference> textures = {};

  /// That triangles of an OBJ or Collada file have and nothing defines, each once. Nothing where a
  /// library of materials that might define them is not there.
  std::vector<Mention> undefined_materials = {};
};

/// `format` is what `format_of` or `read_mesh` says the file is.
Asset asset_of(const Disk& disk, const std::string& path, Format format);

}  // namespace rigor::mesh
