// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/upgrade/config.h>

#include <cstddef>
#include <utility>

#include <fmt/core.h>

#include <rigor/read/model_config.h>
#include <rigor/read/workspace.h>
#include <rigor/text/path.h>
#include <rigor/xml/document.h>

namespace rigor::author {
namespace {

/// The file that consumers load, as the configuration writes it; empty when there is none.
std::string chosen_file(std::string_view config) {
  const xml::Document document = xml::parse(config, kNoSource);
  const read::ModelConfig read = read::read_model_config(document);
  const read::SdfEntry* entry = read::choose(read);
  return entry != nullptr ? entry->file.value : "";
}

}  // namespace

ConfigUpgrade upgrade_config(const Disk& disk, const std::string& sdf, schema::Version to) {
  ConfigUpgrade result;
  const std::string folder(parent_path(sdf));
  const std::string path = join_path(folder, "model.config");
  ReadResult read = disk.read(path, read::kMaxModelBytes);
  if (!read.bytes) return result;
  const xml::Document document = xml::parse(*read.bytes, SourceId{0});
  if (!document.complete() || !document.root()) return result;

  FileChange change{path, std::move(*read.bytes), {}, {}};
  const std::string version = to_string(to);
  std::string stated;
  for (const read::SdfEntry& entry : read::read_model_config(document).entries) {
    if (join_path(folder, entry.file.value) != normalize_path(sdf)) continue;
    if (!entry.version.written || entry.version.value == version) continue;
    stated = entry.version.value;
    change.edits.push_back({entry.version.span, version});
  }
  if (change.edits.empty()) return result;
  std::optional<std::string> text = apply_edits(change.before, change.edits);
  const std::string before = chosen_file(change.before);
  const std::string after = text ? chosen_file(*text) : "";
  if (!text || before != after) {
    result.notes.push_back(
        {UpgradeNoteKind::kConfigEntry,
         Severity::kWarning,
         {},
         fmt::format("{} still has it as version {}: with {}, consumers would load {} and not {}",
                     path, stated, version, after, before)});
    return result;
  }
  change.text = std::move(*text);
  result.change = std::move(change);
  return result;
}

}  // namespace rigor::author
