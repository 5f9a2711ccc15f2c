// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mesh/reads.h>

#include <utility>
#include <vector>

namespace rigor::mass {
namespace {

template <class T>
std::uint64_t bytes_in(const std::vector<T>& list) {
  return list.size() * sizeof(T);
}

/// A picture that several materials have counts as often.
std::uint64_t bytes_of(const mesh::LoadedMesh& loaded) {
  const mesh::TriangleMesh& mesh = loaded.mesh;
  std::uint64_t pictures = 0;
  for (const mesh::Material& material : mesh.materials) {
    if (material.embedded_picture) pictures += material.embedded_picture->size();
  }
  return pictures + sizeof loaded + bytes_in(mesh.positions) + bytes_in(mesh.triangles) +
         bytes_in(mesh.corners.texture) + bytes_in(mesh.corners.normals) +
         bytes_in(mesh.corners.colors);
}

}  // namespace

std::shared_ptr<const mesh::LoadedMesh> MeshReads::find(const std::string& path) {
  const std::shared_ptr<Entry> entry = entry_of(path);
  const std::unique_lock reading =
      turns_ ? turns_->lock(entry->reading) : std::unique_lock(entry->reading);
  if (!entry->mesh) {
    auto mesh = std::make_shared<const mesh::LoadedMesh>(mesh::read_mesh(disk_, path, workers_));
    const std::lock_guard lock(mutex_);
    entry->bytes = bytes_of(*mesh);
    entry->mesh = std::move(mesh);
    make_room();
  }
  return entry->mesh;
}

std::shared_ptr<MeshReads::Entry> MeshReads::entry_of(const std::string& path) {
  const std::lock_guard lock(mutex_);
  const auto known = known_.find(path);
  if (known != known_.end()) {
    used_.splice(used_.begin(), used_, known->second);
  } else {
    used_.emplace_front(path, std::make_shared<Entry>());
    known_[path] = used_.begin();
  }
  return used_.front().second;
}

/// Forgets those that were not asked for the longest. Whoever has one keeps it.
void MeshReads::make_room() {
  std::uint64_t kept = 0;
  for (auto each = used_.begin(); each != used_.end();) {
    kept += each->second->bytes;
    if (kept <= max_bytes_ || each->second->bytes == 0) {  // none yet: it is being read
      ++each;
      continue;
    }
    known_.erase(each->first);
    each = used_.erase(each);
  }
}

}  // namespace rigor::mass
