// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a model folder's `model.config`: the name and author of a model, and which file to load for
// which SDF version.
//
//   ModelConfig config = read_model_config(document);
//   if (const SdfEntry* entry = choose(config)) load(entry->file.value);

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/model/field.h>
#include <rigor/model/site.h>
#include <rigor/xml/document.h>

namespace rigor::read {

/// `<sdf version="1.6">model.sdf</sdf>`
struct SdfEntry {
  model::Site site;
  model::Field<std::string> file;     ///< relative to the folder
  model::Field<std::string> version;  ///< of SDF, as written
  int minor = 0;                      ///< of the version; 0 when it is missing or not a version
};

struct ModelConfig {
  model::Site site;
  model::Field<std::string> name;
  std::vector<SdfEntry> entries;
};

enum class ConfigFactKind : std::uint8_t {
  kNameMissing,
  kNoSdf,            ///< no `<sdf>` entry: nothing can be loaded
  kVersionMissing,   ///< of an entry
  kFileMissing,      ///< an entry's file does not exist; `other_case` when only the case differs
  kVersionMismatch,  ///< an entry's version is not its file's; `found` is the file's
};

struct ConfigFact {
  ConfigFactKind kind;
  Span where;
  std::string name;         ///< of the file, or version, as written
  std::string found;        ///< see the kinds
  bool of_several = false;  ///< whether there are other entries; of a version's mismatch
};

ModelConfig read_model_config(const xml::Document& document);

/// The entry that a consumer loads: the highest version, the first of equals; null when there is
/// none.
const SdfEntry* choose(const ModelConfig& config);

}  // namespace rigor::read
