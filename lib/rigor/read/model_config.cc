// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/model_config.h>

#include <rigor/read/values.h>
#include <rigor/schema/version.h>

namespace rigor::read {

ModelConfig read_model_config(const xml::Document& document) {
  ModelConfig config;
  const auto root = document.root();
  if (!root) return config;
  config.site = site_of(*root);
  config.name = string_field(child_text(*root, "name"));
  for (const xml::Element child : root->children()) {
    if (child.name() != "sdf") continue;
    SdfEntry entry;
    entry.site = site_of(child);
    entry.file = string_field(Text{child.text(), child.text_span()});
    entry.version = string_field(attribute_text(child, "version"));
    const auto version = schema::parse_version(entry.version.value);
    entry.minor = version ? version->minor : 0;
    config.entries.push_back(std::move(entry));
  }
  return config;
}

const SdfEntry* choose(const ModelConfig& config) {
  const SdfEntry* best = nullptr;
  for (const SdfEntry& entry : config.entries) {
    if (best == nullptr || entry.minor > best->minor) best = &entry;
  }
  return best;
}

}  // namespace rigor::read
