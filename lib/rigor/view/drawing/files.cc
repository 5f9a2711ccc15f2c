// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/files.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <rigor/mesh/asset/file_reference.h>
#include <rigor/mesh/select.h>
#include <rigor/text/path.h>

namespace rigor::view {
namespace {

using mesh::TriangleMesh;
using model::Vector3;
using SharedMesh = std::shared_ptr<const TriangleMesh>;
using SharedPicture = std::shared_ptr<const Picture>;

/// A folder of material scripts has one or two, of some kilobytes.
constexpr std::size_t kMaxScriptFiles = 32;
constexpr std::uint64_t kMaxScriptBytes = std::uint64_t{1} << 20U;

/// Behind the name of the file.
std::string words_of(const mesh::LoadedMesh& loaded) {
  for (const mesh::Fault& fault : loaded.faults) {
    if (!mesh::fatal(fault.kind)) continue;
    switch (fault.kind) {
      case mesh::FaultKind::kLfsPointer: return "is a Git LFS pointer";
      case mesh::FaultKind::kImporterMissing: return "cannot be read: assimp is not installed";
      case mesh::FaultKind::kEmpty: return "is empty";
      case mesh::FaultKind::kTooLarge: return "is too large";
      case mesh::FaultKind::kNotFinite: return "has coordinates that are no numbers";
      // Its words may quote the file, which a page or a log is not to tell of files that lie anywhere.
      default: return "cannot be read: `rigor mesh-check` says why";
    }
  }
  return "cannot be read";
}

std::vector<std::uint32_t> faces_of_submesh(const TriangleMesh& mesh, const std::string& name) {
  std::vector<std::uint32_t> faces;
  for (const mesh::Part& part : mesh.parts) {
    if (part.name != name) continue;
    for (std::size_t i = part.first; i < part.first + part.count && i < mesh.triangles.size();
         ++i) {
      faces.push_back(static_cast<std::uint32_t>(i));
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Nothing when no part has the name.
SharedMesh submesh_of(const TriangleMesh& mesh, const model::Mesh& shape) {
  TriangleMesh chosen = mesh::selected(mesh, faces_of_submesh(mesh, shape.submesh.value));
  if (chosen.triangles.empty()) return nullptr;
  mesh::compact(chosen);
  if (shape.center.value) {
    const mesh::Bounds bounds = mesh::bounds_of(chosen.positions);
    const Vector3 middle = 0.5 * (bounds.min + bounds.max);
    for (Vector3& p : chosen.positions) p = p - middle;
  }
  return std::make_shared<const TriangleMesh>(std::move(chosen));
}

class DiskFiles {
 public:
  DiskFiles(const read::Resolver& resolver, const Sources& sources, mass::MeshReads& reads)
      : resolver_(resolver), sources_(sources), reads_(reads) {}

  std::string path(const std::string& uri, Span where) const {
    if (uri.empty() || where.nowhere()) return {};
    const auto found = resolver_.resolve(uri, sources_.path(where.source));
    if (!found.path || resolver_.disk().kind(*found.path) != PathKind::kFile) return {};
    return *found.path;
  }

  SharedMesh mesh(const model::Mesh& shape, std::string& why) {
    const std::string path = this->path(shape.uri.value, shape.uri.span);
    if (path.empty()) {
      why = shape.uri.value + " is not found";
      return nullptr;
    }
    const auto loaded = reads_.find(path);
    if (!loaded->usable()) {
      why = shape.uri.value + ' ' + words_of(*loaded);
      return nullptr;
    }
    const std::string& name = shape.submesh.value;
    if (name.empty()) return {loaded, &loaded->mesh};
    const auto key = std::tuple(path, name, shape.center.value);
    auto known = submeshes_.find(key);
    if (known == submeshes_.end()) {
      known = submeshes_.emplace(key, submesh_of(loaded->mesh, shape)).first;
    }
    if (!known->second) why = shape.uri.value + " has no part \"" + name + '"';
    return known->second;
  }

  std::string texture(const model::Mesh& shape, const std::string& written) const {
    const std::string path = this->path(shape.uri.value, shape.uri.span);
    if (path.empty()) return {};
    const auto found = mesh::resolve(resolver_.disk(), path, written, 0);
    return mesh::is_there(found) ? found.path : std::string();
  }

  std::string scripts(const std::string& uri, Span where) const {
    if (uri.empty() || where.nowhere()) return {};
    const auto found = resolver_.resolve(uri, sources_.path(where.source));
    if (!found.path) return {};
    const Disk& disk = resolver_.disk();
    std::vector<std::string> paths;
    if (disk.kind(*found.path) == PathKind::kFolder) {
      for (const std::string& name : disk.list(*found.path)) {
        if (name.ends_with(".material") && paths.size() < kMaxScriptFiles) {
          paths.push_back(join_path(*found.path, name));
        }
      }
    } else {
      paths.push_back(*found.path);
    }
    std::string text;
    for (const std::string& path : paths) {
      if (const auto read = disk.read(path, kMaxScriptBytes); read.bytes)
        text += *read.bytes + '\n';
    }
    return text;
  }

  SharedPicture picture(const std::string& path) {
    const auto [known, is_new] = pictures_.try_emplace(path);
    if (!is_new) return known->second;
    const ReadResult read = resolver_.disk().read(path, kMaxPictureBytes);
    return known->second = read.bytes ? decoded_picture(*read.bytes) : nullptr;
  }

  SharedPicture embedded_picture(const std::shared_ptr<const std::string>& bytes) {
    const auto [known, is_new] = held_pictures_.try_emplace(bytes);
    if (!is_new) return known->second;
    return known->second = decoded_picture(*bytes);
  }

 private:
  SharedPicture decoded_picture(std::string_view bytes) {
    auto decoded = decode(bytes);
    if (!decoded || pixels_ + decoded->pixels.size() > kMaxPicturePixels) return nullptr;
    pixels_ += decoded->pixels.size();
    return std::make_shared<const Picture>(std::move(*decoded));
  }

  const read::Resolver& resolver_;
  const Sources& sources_;
  mass::MeshReads& reads_;
  std::map<std::tuple<std::string, std::string, bool>, SharedMesh> submeshes_;
  std::map<std::string, SharedPicture> pictures_;
  std::map<std::shared_ptr<const std::string>, SharedPicture> held_pictures_;
  std::uint64_t pixels_ = 0;
};

}  // namespace

Files files_of(const read::Resolver& resolver, const Sources& sources, mass::MeshReads& reads) {
  const auto disk = std::make_shared<DiskFiles>(resolver, sources, reads);
  Files files;
  files.mesh = [disk](const model::Mesh& shape, std::string& why) {
    return disk->mesh(shape, why);
  };
  files.texture = [disk](const model::Mesh& shape, const std::string& written) {
    return disk->texture(shape, written);
  };
  files.picture = [disk](const std::string& path) { return disk->picture(path); };
  files.embedded_picture = [disk](const auto& bytes) { return disk->embedded_picture(bytes); };
  files.resolve = [disk](const std::string& uri, Span where) { return disk->path(uri, where); };
  files.scripts = [disk](const std::string& uri, Span where) { return disk->scripts(uri, where); };
  return files;
}

}  // namespace rigor::view
