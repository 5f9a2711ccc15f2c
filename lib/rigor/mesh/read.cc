// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/read.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include <rigor/mesh/importer/scene.h>
#include <rigor/mesh/obj/obj.h>
#include <rigor/mesh/stl/stl.h>
#include <rigor/mesh/text_cursor.h>
#include <rigor/text/path.h>

namespace rigor::mesh {
namespace {

constexpr std::string_view kLfsPointer = "version https://git-lfs.github.com/spec/";

// Endings of files that robot models name now and then and assimp knows; more it would read, but
// nothing else does.
constexpr std::array<std::string_view, 11> kOtherEndings{
    ".3ds", ".3mf", ".ac", ".amf", ".blend", ".fbx", ".lwo", ".off", ".x", ".x3d", ".zae"};

template <class List, class Item>
bool contains(const List& list, const Item& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

/// Whether the ending, with its dot, is the format's.
bool names(std::string_view ending, Format format) {
  return !ending.empty() && ending.substr(1) == to_string(format);
}

constexpr std::array<Format, 5> kNamedFormats{Format::kObj, Format::kCollada, Format::kGltf,
                                              Format::kGlb, Format::kPly};

/// Whether the first line that is no comment is a statement of OBJ.
bool begins_as_obj(std::string_view first_bytes) {
  constexpr std::array<std::string_view, 9> kStatements{"v", "vt", "vn",     "f",     "o",
                                                        "g", "s",  "usemtl", "mtllib"};
  if (contains(first_bytes, '\0')) return false;  // the header of a binary file
  TextCursor cursor(first_bytes);
  for (cursor.skip_space(); !cursor.at_end(); cursor.skip_space()) {
    if (!cursor.at_line_end()) return contains(kStatements, cursor.word());
    cursor.skip_line();
  }
  return false;
}

Format format_by_bytes(std::string_view first_bytes, std::uint64_t size) {
  const auto has = [first_bytes](std::string_view text) {
    return first_bytes.find(text) != std::string_view::npos;
  };
  TextCursor text(first_bytes);
  text.skip_space();
  const std::string_view begin = first_bytes.substr(text.offset());
  if (first_bytes.starts_with("glTF")) return Format::kGlb;
  if (first_bytes.starts_with("ply\n") || first_bytes.starts_with("ply\r")) return Format::kPly;
  if (begin.starts_with('<') && has("<COLLADA")) return Format::kCollada;
  if (begin.starts_with('{') && has("\"asset\"")) return Format::kGltf;
  if (stl_size_fits(first_bytes, size)) return Format::kStlBinary;
  if (text.sees("solid") && !is_binary_stl(first_bytes, size)) return Format::kStlAscii;
  return begins_as_obj(first_bytes) ? Format::kObj : Format::kUnknown;
}

Format format_by_ending(std::string_view first_bytes, std::uint64_t size, std::string_view ending) {
  if (ending == ".stl") {
    return is_binary_stl(first_bytes, size) ? Format::kStlBinary : Format::kStlAscii;
  }
  for (const Format format : kNamedFormats) {
    if (names(ending, format)) return format;
  }
  return contains(kOtherEndings, ending) ? Format::kOther : Format::kUnknown;
}

LoadedMesh no_mesh(FaultKind kind, std::string detail = {}) {
  return {.faults = {{kind, std::move(detail)}}};
}

std::string read(const OpenFile& file, std::uint64_t count) {
  std::string bytes(static_cast<std::size_t>(std::min(count, file.size())), '\0');
  bytes.resize(file.read(0, bytes.data(), bytes.size()));
  return bytes;
}

LoadedMesh read_as(Format format, const OpenFile& file, const Disk& disk, const std::string& path,
                   const process::Workers& workers) {
  if (format == Format::kUnknown) return no_mesh(FaultKind::kUnknownFormat, extension(path));
  const bool is_stl = format == Format::kStlBinary || format == Format::kStlAscii;
  if (!is_stl && format != Format::kObj) return read_scene(disk, path, workers);
  if (format == Format::kStlBinary) {
    if (std::optional<LoadedMesh> loaded = read_plain_stl(file)) return std::move(*loaded);
  }
  const std::string bytes = read(file, file.size());
  if (bytes.size() < file.size()) return no_mesh(FaultKind::kUnreadable, "cannot be read");
  return is_stl ? read_stl(bytes) : read_obj(bytes, disk, path);
}

}  // namespace

std::string_view to_string(Format format) {
  switch (format) {
    case Format::kStlBinary:
    case Format::kStlAscii: return "stl";
    case Format::kObj: return "obj";
    case Format::kCollada: return "dae";
    case Format::kGltf: return "gltf";
    case Format::kGlb: return "glb";
    case Format::kPly: return "ply";
    case Format::kOther: return "other";
    case Format::kUnknown: break;
  }
  return "unknown";
}

bool LoadedMesh::usable() const {
  return std::none_of(faults.begin(), faults.end(),
                      [](const Fault& fault) { return fatal(fault.kind); });
}

bool has_mesh_ending(std::string_view path) {
  const std::string ending = extension(path);
  return ending == ".stl" || std::any_of(kNamedFormats.begin(), kNamedFormats.end(),
                                         [&](Format format) { return names(ending, format); });
}

Format format_of(std::string_view first_bytes, std::uint64_t size, std::string_view path) {
  const Format format = format_by_bytes(first_bytes, size);
  return format != Format::kUnknown ? format : format_by_ending(first_bytes, size, extension(path));
}

/// Where symbolic links are turned off, git writes the path that one leads to into a file.
bool is_link_text(std::string_view first_bytes, std::uint64_t size, const std::string& path) {
  constexpr std::uint64_t kLongest = 512;
  if (size > kLongest || size > first_bytes.size()) return false;
  std::string_view text = first_bytes;
  if (text.ends_with('\n')) text.remove_suffix(1);
  const bool one_line = std::none_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) <= ' ' || c == '<' || c == '{';
  });
  return one_line && text.find('/') != text.npos && !extension(path).empty() &&
         extension(std::string(text)) == extension(path);
}

LoadedMesh read_mesh(const Disk& disk, const std::string& path) {
  return read_mesh(disk, path, process::Workers());
}

LoadedMesh read_mesh(const Disk& disk, const std::string& path, const process::Workers& workers) {
  const std::unique_ptr<OpenFile> file = disk.open(path);
  if (!file) return no_mesh(FaultKind::kUnreadable, disk.read(path, kMaxMeshBytes).problem);
  if (file->size() == 0) return no_mesh(FaultKind::kEmpty);
  if (file->size() > kMaxMeshBytes) return no_mesh(FaultKind::kTooLarge, "over 2 GiB");
  const std::string first_bytes = read(*file, kProbeBytes);
  if (first_bytes.starts_with(kLfsPointer)) return no_mesh(FaultKind::kLfsPointer);
  if (is_link_text(first_bytes, file->size(), path)) {
    return no_mesh(FaultKind::kMalformed,
                   "it is a symbolic link of git that was checked out as text");
  }
  const Format format = format_of(first_bytes, file->size(), path);
  LoadedMesh loaded = read_as(format, *file, disk, path, workers);
  loaded.format = format;
  const std::string ending = extension(path);
  const bool says_nothing =
      ending.empty() || format == Format::kOther || format == Format::kUnknown;
  if (!says_nothing && !names(ending, format)) {
    loaded.faults.push_back({FaultKind::kExtensionMismatch, std::string(to_string(format))});
  }
  return loaded;
}

}  // namespace rigor::mesh
