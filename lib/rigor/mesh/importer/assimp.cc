// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/importer/assimp.h>

#include <assimp/cfileio.h>
#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/version.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include <rigor/mesh/asset/file_reference.h>
#include <rigor/mesh/importer/bake.h>
#include <rigor/text/path.h>

namespace rigor::mesh {
namespace {

// ---- The library

struct Library {
  decltype(&aiCreatePropertyStore) create_properties = nullptr;
  decltype(&aiSetImportPropertyInteger) set_integer = nullptr;
  decltype(&aiImportFileExWithProperties) import_file = nullptr;
  decltype(&aiGetErrorString) error = nullptr;
  std::array<decltype(&aiGetVersionMajor), 3> version{};
  std::string problem;  ///< why there is none
};

/// Whether it is there, but does not fit into the memory that is left: glibc tells these apart in words only.
bool lacks_memory(std::string_view problem) {
  return problem.find("failed to map segment") != std::string_view::npos ||
         problem.find("annot allocate") != std::string_view::npos;
}

Library open_library() {
  Library library;
  void* handle = ::dlopen(RIGOR_ASSIMP_SONAME, RTLD_NOW | RTLD_LOCAL);
  if (!handle) {
    const char* problem = ::dlerror();
    library.problem = problem ? problem : RIGOR_ASSIMP_SONAME;
    if (lacks_memory(library.problem)) throw std::bad_alloc();
  }
  const auto find = [&]<class Function>(const char* name, Function& function) {
    if (handle) function = reinterpret_cast<Function>(::dlsym(handle, name));
    if (function || !library.problem.empty()) return;
    const char* problem = ::dlerror();
    library.problem = problem ? problem : name;
  };
  find("aiCreatePropertyStore", library.create_properties);
  find("aiSetImportPropertyInteger", library.set_integer);
  find("aiImportFileExWithProperties", library.import_file);
  find("aiGetErrorString", library.error);
  find("aiGetVersionMajor", library.version[0]);
  find("aiGetVersionMinor", library.version[1]);
  find("aiGetVersionPatch", library.version[2]);
  return library;
}

// ---- Files

/// An open file in assimp's hands. What it names beyond the scene's own file is kept in `own`.
struct Stream {
  aiFile face = {};
  std::string own;
  std::string_view bytes;
  std::size_t at = 0;
};

Stream& stream(aiFile* file) { return *reinterpret_cast<Stream*>(file->UserData); }

/// As fread.
std::size_t read_stream(aiFile* file, char* into, std::size_t size, std::size_t count) {
  Stream& from = stream(file);
  if (size == 0) return 0;
  const std::size_t whole = std::min(count, (from.bytes.size() - from.at) / size);
  from.bytes.copy(into, whole * size, from.at);
  from.at += whole * size;
  return whole;
}

aiReturn seek_stream(aiFile* file, std::size_t offset, aiOrigin origin) {
  Stream& in = stream(file);
  // A negative offset comes as a huge one; the sum wraps to what is meant.
  const std::size_t at = offset + (origin == aiOrigin_CUR   ? in.at
                                   : origin == aiOrigin_END ? in.bytes.size()
                                                            : 0);
  if (at > in.bytes.size()) return aiReturn_FAILURE;
  in.at = at;
  return aiReturn_SUCCESS;
}

class Files {
 public:
  Files(const Disk& disk, const std::string& path, std::string_view bytes)
      : disk_(disk), path_(path), folder_(normalize_path(parent_path(path))), bytes_(bytes) {
    if (folder_.back() != '/') folder_ += '/';
    face_.OpenProc = [](aiFileIO* io, const char* name, const char* mode) {
      return reinterpret_cast<Files*>(io->UserData)->open(name, mode);
    };
    face_.CloseProc = [](aiFileIO*, aiFile* file) { delete &stream(file); };
    face_.UserData = reinterpret_cast<aiUserData>(this);
  }

  aiFileIO* face() { return &face_; }

 private:
  aiFile* open(std::string_view name, std::string_view mode) {
    if (!mode.starts_with('r')) return nullptr;
    auto file = std::make_unique<Stream>();
    if (name == path_) {
      file->bytes = bytes_;
    } else {
      std::optional<std::string> bytes = side_file(normalize_path(name));
      if (!bytes) return nullptr;
      file->own = std::move(*bytes);
      file->bytes = file->own;
    }
    file->face.ReadProc = read_stream;
    file->face.WriteProc = [](aiFile*, const char*, std::size_t, std::size_t) -> std::size_t {
      return 0;
    };
    file->face.TellProc = [](aiFile* self) { return stream(self).at; };
    file->face.FileSizeProc = [](aiFile* self) { return stream(self).bytes.size(); };
    file->face.SeekProc = seek_stream;
    file->face.FlushProc = [](aiFile*) {};
    file->face.UserData = reinterpret_cast<aiUserData>(file.get());
    return &file.release()->face;
  }

  /// Nothing outside the scene's folder: a mesh from elsewhere must not name the user's files.
  std::optional<std::string> side_file(const std::string& name) const {
    const bool inside =
        folder_ == "./" ? !is_absolute(name) && !name.starts_with("..") : name.starts_with(folder_);
    if (!inside) return std::nullopt;
    return disk_.read(name, kMaxMeshBytes).bytes;
  }

  const Disk& disk_;
  const std::string& path_;
  std::string folder_;
  std::string_view bytes_;
  aiFileIO face_ = {};
};

// ---- What assimp leaves as it is

/// Collada's surfaces have a color or a picture; for those with a picture assimp makes up a gray.
/// The names of glTF's pictures are URIs, which assimp hands on undecoded.
void mend_materials(std::vector<Material>& materials, const std::string& ending) {
  for (Material& material : materials) {
    if (material.texture.empty()) continue;
    if (ending == ".dae") material.diffuse = {1, 1, 1, material.diffuse.back()};
    if (ending == ".gltf" || ending == ".glb") material.texture = percent_decoded(material.texture);
  }
}

}  // namespace

LoadedMesh import_with_assimp(const Disk& disk, const std::string& path, std::string_view bytes) {
  const Library library = open_library();
  if (!library.problem.empty()) return {.faults = {{FaultKind::kImporterMissing, library.problem}}};

  aiPropertyStore* properties = library.create_properties();
  library.set_integer(properties, AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, 1);
  library.set_integer(properties, AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, 1);
  // Else a file without meshes gets one that shows its bones.
  library.set_integer(properties, AI_CONFIG_IMPORT_NO_SKELETON_MESHES, 1);

  Files files(disk, path, bytes);
  constexpr unsigned kNoPostProcessing = 0;
  const aiScene* scene =
      library.import_file(path.c_str(), kNoPostProcessing, files.face(), properties);
  if (scene) {
    LoadedMesh loaded = bake(*scene);
    mend_materials(loaded.mesh.materials, extension(path));
    return loaded;
  }
  const std::string error = library.error();
  if (error.find("bad_alloc") != std::string::npos) throw std::bad_alloc();  // it caught one
  return {.faults = {{FaultKind::kMalformed, error}}};
}

std::string assimp_version() {
  const Library library = open_library();
  if (!library.problem.empty()) return library.problem;
  std::string text = "assimp ";
  for (const auto number : library.version) text += std::to_string(number()) + '.';
  text.pop_back();
  return text;
}

}  // namespace rigor::mesh
