// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mesh_cache.h>

#include <memory>
#include <optional>

#include <rigor/mass/mesh_facts_code.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/scene.h>

namespace rigor::mass {
namespace {

using mesh::Format;

// Questions asked about other files: a thousand textures, each in the places where it may be.
constexpr std::size_t kMaxWitnesses = 8000;

Format format_of_file(const OpenFile& file, const std::string& path) {
  std::string first(mesh::kProbeBytes, '\0');
  first.resize(file.read(0, first.data(), first.size()));
  return mesh::format_of(first, file.size(), path);
}

/// What a file of a format of `kOther` names is known to its importer alone.
bool names_are_known(Format format) {
  return format != Format::kOther && format != Format::kUnknown;
}

/// Empty for what rigor reads itself. Costs a process: it is asked only when all else is as it was.
std::string importer_of(Format format) {
  const bool own =
      format == Format::kStlBinary || format == Format::kStlAscii || format == Format::kObj;
  return own ? "" : mesh::scene_importer();
}

bool holds(const Disk& disk, const CachedMeshFacts& entry) {
  return still_so(disk, entry.witnesses) && importer_of(entry.facts.format) == entry.importer;
}

/// Buffers are read in the importer's process, where no witness sees it.
void look_at_buffers(const WitnessDisk& disk, const MeshFacts& facts) {
  if (!facts.asset.gltf) return;
  for (const mesh::FileReference& buffer : facts.asset.gltf->buffers) {
    if (!buffer.path.empty()) disk.open(buffer.path);
  }
}

}  // namespace

MeshFacts MeshCache::find(const Disk& disk, const std::string& path, MeshDepth depth) const {
  const std::optional<Digest> before = key(disk, path, depth);
  if (!before) return mesh_facts(disk, path, depth);
  if (const std::optional<std::string> bytes = store_.get(*before)) {
    std::optional<CachedMeshFacts> known = decode(*bytes);
    if (known && holds(disk, *known)) return std::move(known->facts);
  }
  const WitnessDisk asked(disk, path);
  MeshFacts facts = mesh_facts(asked, path, depth);
  if (!keeps(facts)) return facts;
  look_at_buffers(asked, facts);
  CachedMeshFacts entry{asked.witnesses(), importer_of(facts.format), std::move(facts)};
  // What changed while it was looked at is not known well enough.
  const bool steady = holds(disk, entry) && key(disk, path, depth) == before;
  if (steady && entry.witnesses.size() <= kMaxWitnesses) store_.put(*before, encode(entry));
  return std::move(entry.facts);
}

std::optional<Digest> MeshCache::key(const Disk& disk, const std::string& path,
                                     MeshDepth depth) const {
  const std::unique_ptr<OpenFile> file = disk.open(path);
  if (!file || file->size() == 0 || file->size() > mesh::kMaxMeshBytes) return std::nullopt;
  const Format format = format_of_file(*file, path);
  if (!names_are_known(format)) return std::nullopt;
  Hasher hasher;
  const auto add = [&hasher](std::string_view text) { hasher.add(view(digest_of(text))); };
  add(kMeshFactsCode);
  add(program_);
  add(path);
  add(std::to_string(static_cast<int>(depth)));
  hasher.add(view(digest_of(*file)));
  return hasher.digest();
}

/// A mesh that could not be read to its end may be readable tomorrow.
bool MeshCache::keeps(const MeshFacts& facts) const {
  const bool all_buffers =
      !facts.asset.gltf || facts.asset.gltf->buffers.size() < mesh::kMaxReferences;
  return facts.usable() && facts.triangles >= least_ && facts.asset.problem.empty() && all_buffers;
}

}  // namespace rigor::mass
