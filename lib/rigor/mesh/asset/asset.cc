// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/asset/asset.h>

#include <memory>
#include <utility>

#include <rigor/mesh/asset/readers.h>

namespace rigor::mesh {
namespace {

Asset with_bytes(const Disk& disk, const std::string& path, Format format) {
  ReadResult file = disk.read(path, kMaxMeshBytes);
  if (!file.bytes) return {.problem = std::move(file.problem)};
  switch (format) {
    case Format::kStlAscii: return {.stl = ascii_stl_facts(*file.bytes)};
    case Format::kObj: return obj_asset(disk, path, *file.bytes);
    case Format::kCollada: return collada_asset(disk, path, *file.bytes);
    case Format::kGltf:
    case Format::kGlb: return gltf_asset(disk, path, *file.bytes);
    default: return {};
  }
}

Asset without_format(const Disk& disk, const std::string& path, Format format) {
  if (format != Format::kStlBinary) return with_bytes(disk, path, format);
  const std::unique_ptr<OpenFile> file = disk.open(path);
  if (!file) return {.problem = disk.read(path, kMaxMeshBytes).problem};
  return {.stl = binary_stl_facts(*file)};
}

}  // namespace

Asset asset_of(const Disk& disk, const std::string& path, Format format) {
  Asset asset = without_format(disk, path, format);
  asset.format = format;
  return asset;
}

}  // namespace rigor::mesh
