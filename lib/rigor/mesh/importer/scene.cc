// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/importer/scene.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/mesh/collada/collada.h>
#include <rigor/mesh/importer/assimp.h>
#include <rigor/mesh/importer/flat.h>
#include <rigor/text/path.h>

namespace rigor::mesh {
namespace {

constexpr std::string_view kImportKind = "mesh.import";
constexpr std::string_view kImporterNameKind = "mesh.importer-name";

/// The importer goes by the ending first; one that lies gets the true one behind it.
std::string honest_path(const std::string& path, Format format) {
  const bool known = format == Format::kCollada || format == Format::kGltf ||
                     format == Format::kGlb || format == Format::kPly;
  const std::string ending = '.' + std::string(to_string(format));
  return known && extension(path) != ending ? path + ending : path;
}

/// The files of the process that asked for the scene.
class AskedFiles final : public Disk {
 public:
  explicit AskedFiles(const process::Ask& ask) : ask_(ask) {}

  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override {
    std::optional<std::string> bytes = ask_(path);
    if (!bytes || bytes->size() > max_bytes) return {std::nullopt, "not there"};
    return {std::move(bytes), {}};
  }
  // The importer asks for nothing else.
  std::unique_ptr<OpenFile> open(const std::string&) const override { return nullptr; }
  PathKind kind(const std::string&) const override { return PathKind::kMissing; }
  std::vector<std::string> list(const std::string&) const override { return {}; }

 private:
  const process::Ask& ask_;
};

/// In the worker.
process::Reply import_asked(const std::string& path, const process::Ask& ask) {
  const std::string bytes = ask(path).value_or("");
  return flatten(import_with_assimp(AskedFiles(ask), path, bytes));
}

/// Whether the importer said no to what another reader may well understand.
bool importer_failed(const LoadedMesh& loaded) {
  return std::any_of(loaded.faults.begin(), loaded.faults.end(), [](const Fault& fault) {
    return fault.kind == FaultKind::kMalformed || fault.kind == FaultKind::kImporterCrashed ||
           fault.kind == FaultKind::kImporterMissing || fault.kind == FaultKind::kWorkerMissing;
  });
}

/// Whether the text of each <p>, a list of indices, holds whole numbers only.
bool lists_whole_numbers(std::string_view bytes) {
  constexpr std::string_view kTag = "<p";
  constexpr std::string_view kAfterTag = "> \t\r\n";
  constexpr std::string_view kListed = "0123456789+- \t\r\n";
  for (std::size_t at = bytes.find(kTag); at != std::string_view::npos; at = bytes.find(kTag, at)) {
    at += kTag.size();
    if (at == bytes.size() || kAfterTag.find(bytes[at]) == std::string_view::npos) continue;
    at = bytes.find('>', at);
    if (at == std::string_view::npos) return false;
    at = bytes.find_first_not_of(kListed, at + 1);
    if (at == std::string_view::npos || bytes.substr(at, 2) != "</") return false;
  }
  return true;
}

/// When both readers say no, the importer's reason counts. assimp looks for an index for ever where there is none, and is
/// not asked then.
LoadedMesh load_collada(const Disk& disk, const std::string& path, std::string_view bytes,
                        const process::Workers& workers) {
  if (!lists_whole_numbers(bytes)) return read_collada(bytes);
  LoadedMesh imported = import_scene(disk, path, bytes, workers);
  if (!importer_failed(imported)) return imported;
  LoadedMesh own = read_collada(bytes);
  return own.usable() ? std::move(own) : std::move(imported);
}

/// Whether a line of a PLY begins with the word that ends its header, and with no longer one.
bool ends_header(std::string_view bytes) {
  constexpr std::string_view kEndOfHeader = "end_header";
  for (std::size_t at = bytes.find(kEndOfHeader); at != std::string_view::npos;
       at = bytes.find(kEndOfHeader, at + kEndOfHeader.size())) {
    const std::size_t before = bytes.substr(0, at).find_last_not_of(" \t");
    const std::string_view after = bytes.substr(at + kEndOfHeader.size());
    if (before != std::string_view::npos && (bytes[before] == '\n' || bytes[before] == '\r') &&
        (after.empty() ||
         std::string_view(" \t\r\n\f\0", 6).find(after[0]) != std::string_view::npos)) {
      return true;
    }
  }
  return false;
}

LoadedMesh load(const Disk& disk, const std::string& path, std::string_view bytes, Format format,
                const process::Workers& workers) {
  // assimp's reader of PLY looks for the header's end for ever.
  if (format == Format::kPly && !ends_header(bytes)) {
    return {.faults = {{FaultKind::kMalformed, "the header has no end_header"}}};
  }
  const std::string honest = honest_path(path, format);
  return format == Format::kCollada ? load_collada(disk, honest, bytes, workers)
                                    : import_scene(disk, honest, bytes, workers);
}

}  // namespace

void allow_imports(process::Workers& workers, std::uint64_t bytes) {
  workers.set_memory(kImportKind, bytes);
}

LoadedMesh import_scene(const Disk& disk, const std::string& path, std::string_view bytes,
                        const process::Workers& workers) {
  using End = process::RequestResult::End;
  std::string beside;
  process::RequestLimits limits = workers.limits_of(kImportKind, kImportLimits);
  limits.cpu_seconds += static_cast<unsigned>(bytes.size() / kBytesPerImportSecond);
  const process::RequestResult result =
      workers.call({.kind = kImportKind, .bytes = path, .limits = limits},
                   [&](std::string_view name) -> std::optional<std::string_view> {
                     if (name == path) return bytes;
                     ReadResult file = disk.read(std::string(name), kMaxMeshBytes);
                     if (!file.bytes) return std::nullopt;
                     beside = std::move(*file.bytes);
                     return beside;
                   });
  if (result.end != End::kDone) {
    // Without a worker the file is not to blame.
    const bool missing = result.end == End::kNotStarted;
    std::string why = describe(result, limits);
    if (result.end == End::kOutOfMemory) why += " (--mesh-memory allows more)";
    return {.faults = {{missing ? FaultKind::kWorkerMissing : FaultKind::kImporterCrashed,
                        std::move(why)}}};
  }
  if (std::optional<LoadedMesh> loaded = unflatten(result.bytes)) return std::move(*loaded);
  return {.faults = {{FaultKind::kImporterCrashed, "gave back a damaged mesh"}}};
}

LoadedMesh read_scene(const Disk& disk, const std::string& path, const process::Workers& workers) {
  const ReadResult file = disk.read(path, kMaxMeshBytes);
  if (!file.bytes) return {.faults = {{FaultKind::kUnreadable, file.problem}}};
  if (file.bytes->empty()) return {.faults = {{FaultKind::kEmpty}}};
  const std::string_view bytes = *file.bytes;
  const Format format = format_of(bytes.substr(0, kProbeBytes), bytes.size(), path);
  LoadedMesh loaded = load(disk, path, bytes, format, workers);
  loaded.format = format;
  return loaded;
}

std::string scene_importer(const process::Workers& workers) {
  return workers.call({.kind = kImporterNameKind, .limits = kImportLimits}).bytes;
}

process::Service import_service() { return {kImportKind, import_asked}; }

process::Service importer_name_service() {
  return {kImporterNameKind, [](const std::string&, const process::Ask&) -> process::Reply {
            return assimp_version();
          }};
}

}  // namespace rigor::mesh
