// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/scene.h>

#include <optional>
#include <string_view>
#include <utility>

#include <rigor/mesh/assimp.h>
#include <rigor/mesh/flat.h>
#include <rigor/process/child.h>
#include <rigor/text/path.h>

namespace rigor::mesh {
namespace {

using process::ChildLimits;
using process::ChildResult;

Format format_by_ending(const std::string& path) {
  const std::string ending = extension(path);
  for (const Format format : {Format::kCollada, Format::kGltf, Format::kGlb, Format::kPly}) {
    if (ending.substr(ending.empty() ? 0 : 1) == to_string(format)) return format;
  }
  return Format::kOther;
}

LoadedMesh import_in_child(const Disk& disk, const std::string& path, std::string_view bytes) {
  const ChildLimits limits{.cpu_seconds = kImportSeconds, .memory_bytes = kImportBytes};
  const ChildResult result =
      process::run_in_child(limits, [&] { return flatten(import_with_assimp(disk, path, bytes)); });
  if (result.end != ChildResult::End::kDone) {
    return {.faults = {{FaultKind::kImporterCrashed, describe(result, limits)}}};
  }
  if (std::optional<LoadedMesh> loaded = unflatten(result.bytes)) return std::move(*loaded);
  return {.faults = {{FaultKind::kImporterCrashed, "gave back a damaged mesh"}}};
}

/// assimp's reader of PLY looks for the header's end for ever.
bool header_never_ends(const std::string& path, std::string_view bytes) {
  return extension(path) == ".ply" && bytes.find("end_header") == std::string_view::npos;
}

LoadedMesh load(const Disk& disk, const std::string& path) {
  const ReadResult file = disk.read(path, kMaxMeshBytes);
  if (!file.bytes) return {.faults = {{FaultKind::kUnreadable, file.problem}}};
  if (file.bytes->empty()) return {.faults = {{FaultKind::kEmpty}}};
  if (header_never_ends(path, *file.bytes)) {
    return {.faults = {{FaultKind::kMalformed, "the header has no end_header"}}};
  }
  return import_in_child(disk, path, *file.bytes);
}

}  // namespace

LoadedMesh read_scene(const Disk& disk, const std::string& path) {
  LoadedMesh loaded = load(disk, path);
  loaded.format = format_by_ending(path);
  return loaded;
}

}  // namespace rigor::mesh
