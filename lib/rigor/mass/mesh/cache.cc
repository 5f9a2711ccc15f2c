// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mesh/cache.h>

#include <algorithm>
#include <mutex>
#include <unordered_map>
#include <utility>

#include <rigor/mass/mesh/facts_code.h>
#include <rigor/mesh/importer/scene.h>
#include <rigor/mesh/read.h>

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

/// Read by rigor itself; other formats by an importer.
bool own_format(Format format) {
  return format == Format::kStlBinary || format == Format::kStlAscii || format == Format::kObj;
}

/// In a file of a format that rigor reads itself.
std::uint64_t most_triangles(Format format, std::uint64_t bytes) {
  // Of binary STL 50 bytes are one; of text "f 1 2 3" and half a "v 0 0 0" at least.
  constexpr std::uint64_t kBinary = 50;
  constexpr std::uint64_t kText = 8;
  return bytes / (format == Format::kStlBinary ? kBinary : kText);
}

/// Buffers are read in the importer's process, where no witness sees it.
void look_at_buffers(const WitnessDisk& disk, const mesh::Asset& asset) {
  if (!asset.gltf) return;
  for (const mesh::FileReference& buffer : asset.gltf->buffers) {
    if (!buffer.path.empty()) disk.open(buffer.path);
  }
}

/// A mesh that could not be read to its end may be readable tomorrow.
bool all_was_read(const mesh::Asset& asset) {
  const bool all_buffers = !asset.gltf || asset.gltf->buffers.size() < mesh::kMaxReferences;
  return asset.problem.empty() && all_buffers;
}

}  // namespace

/// Asked once, when it is needed for the first time: a worker opens the library to know.
class MeshCache::Importer {
 public:
  explicit Importer(const process::Workers& workers) : workers_(workers) {}

  const std::string& name() {
    std::call_once(asked_, [this] { name_ = mesh::scene_importer(workers_); });
    return name_;
  }

 private:
  const process::Workers& workers_;
  std::once_flag asked_;
  std::string name_;
};

/// Of files' bytes, as long as the system says that they are the same.
class MeshCache::Digests {
 public:
  explicit Digests(Stamp stamp) : stamp_(std::move(stamp)) {}

  /// Nothing when the file cannot be opened.
  std::optional<Digest> of(const Disk& disk, const std::string& path) {
    // Before it is opened: else a link that changes in between gives one file's stamp to another's bytes.
    const std::optional<FileStamp> before = stamp_ ? stamp_(path) : std::nullopt;
    if (!before) return read_digest(disk, path);
    {
      const std::lock_guard lock(mutex_);
      const auto found = known_.find(path);
      if (found != known_.end() && found->second.stamp == *before) return found->second.digest;
    }
    const std::optional<Digest> digest = read_digest(disk, path);
    // Replaced or written to while it was read: not what the stamp is of.
    if (digest && stamp_(path) == before) {
      const std::lock_guard lock(mutex_);
      known_.insert_or_assign(path, Known{*before, *digest});
    }
    return digest;
  }

  /// For witnesses. It outlives what this gives.
  ContentDigest function() {
    return [this](const Disk& disk, const std::string& path) { return of(disk, path); };
  }

 private:
  struct Known {
    FileStamp stamp;
    Digest digest = {};
  };

  Stamp stamp_;
  std::mutex mutex_;
  std::unordered_map<std::string, Known> known_;
};

MeshCache::MeshCache(FolderStore store, std::string program, const process::Workers& workers,
                     std::uint64_t least, Stamp stamp)
    : store_(std::move(store)),
      program_(std::move(program)),
      workers_(workers),
      min_(least),
      importer_(std::make_shared<Importer>(workers)),
      digests_(std::make_shared<Digests>(std::move(stamp))) {}

MeshFacts MeshCache::facts(const Disk& disk, const std::string& path, MeshDepth depth,
                           MeshReads* reads) const {
  const std::string what = "facts " + std::to_string(static_cast<int>(depth));
  return find<MeshFacts>(disk, path, what, [&](const WitnessDisk& asked) {
    MeshFacts facts = reads ? mesh_facts(asked, path, *reads->find(path), depth)
                            : mesh_facts(asked, path, depth, workers_);
    look_at_buffers(asked, facts.asset);
    const bool whole = all_was_read(facts.asset);
    return std::pair(std::move(facts), whole);
  });
}

MeshSurvey MeshCache::survey(const Disk& disk, const MeshChoice& choice, MeshReads* reads) const {
  // Rare, and not worth an entry of its own for each scale.
  if (choice.sheet_scale) {
    return reads ? survey_mesh(disk, choice, *reads) : survey_mesh(disk, choice, workers_);
  }
  const std::string what = "survey " + std::to_string(choice.center) + choice.submesh;
  return find<MeshSurvey>(disk, choice.path, what, [&](const WitnessDisk& asked) {
    MeshSurvey survey =
        reads ? survey_mesh(asked, choice, *reads) : survey_mesh(asked, choice, workers_);
    mesh::Asset asset;
    if (survey.format == Format::kGltf) asset = mesh::asset_of(asked, choice.path, survey.format);
    look_at_buffers(asked, asset);
    return std::pair(std::move(survey), all_was_read(asset));
  });
}

/// `find` gives what was found, and whether it may be kept.
template <class Found, class Find>
Found MeshCache::find(const Disk& disk, const std::string& path, std::string_view what,
                      const Find& find) const {
  const std::optional<Digest> before = key(disk, path, what);
  if (before) {
    if (const std::optional<std::string> bytes = store_.get(*before)) {
      std::optional<CachedMesh> known = decode(*bytes);
      Found* found = known ? std::get_if<Found>(&known->found) : nullptr;
      if (found != nullptr && holds(disk, *known)) return std::move(*found);
    }
  }
  const WitnessDisk asked(disk, path, digests_->function());
  auto [found, whole] = find(asked);
  const bool small = own_format(found.format) && found.triangles < min_;
  if (!before || !whole || !found.usable() || small) return std::move(found);
  CachedMesh entry{asked.witnesses(), importer_of(found.format), std::move(found)};
  // What changed while it was examined is not known well enough.
  const bool steady = holds(disk, entry) && key(disk, path, what) == before;
  if (steady && entry.witnesses.size() <= kMaxWitnesses) store_.put(*before, encode(entry));
  return std::move(std::get<Found>(entry.found));
}

std::optional<Digest> MeshCache::key(const Disk& disk, const std::string& path,
                                     std::string_view what) const {
  const std::unique_ptr<OpenFile> file = disk.open(path);
  if (!file || file->size() == 0 || file->size() > mesh::kMaxMeshBytes) return std::nullopt;
  const Format format = format_of_file(*file, path);
  if (!names_are_known(format)) return std::nullopt;
  // Then it is not even looked up.
  if (own_format(format) && most_triangles(format, file->size()) < min_) return std::nullopt;
  Hasher hasher;
  const auto add = [&hasher](std::string_view text) { hasher.add(digest_bytes(digest_of(text))); };
  add(kMeshFactsCode);
  add(program_);
  add(path);
  add(what);
  const std::optional<Digest> content = digests_->of(disk, path);
  if (!content) return std::nullopt;
  hasher.add(digest_bytes(*content));
  return hasher.digest();
}

/// Empty for what rigor reads itself.
std::string MeshCache::importer_of(Format format) const {
  return own_format(format) ? "" : importer_->name();
}

bool MeshCache::holds(const Disk& disk, const CachedMesh& entry) const {
  const Format format = std::visit([](const auto& found) { return found.format; }, entry.found);
  return still_so(disk, entry.witnesses, digests_->function()) &&
         importer_of(format) == entry.importer;
}

}  // namespace rigor::mass
