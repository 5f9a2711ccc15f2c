// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/expanded_templates.h>

#include <algorithm>
#include <utility>

#include <rigor/read/xacro_places.h>
#include <rigor/text/path.h>

namespace rigor::rules {

bool ExpandedTemplates::takes(const read::LeftOut& left) const {
  const auto& named = options_.paths;
  return options_.expand && !left.excluded && extension(left.path) == ".xacro" &&
         std::find(named.begin(), named.end(), left.path) != named.end();
}

void ExpandedTemplates::expand(const std::string& path) {
  if (!options_.shard.has(path)) return;
  read::Expansion expansion = options_.expand(path);
  if (expansion.text) workspace_.put(path, std::move(*expansion.text));
  expansions_[normalize_path(path)] = std::move(expansion);
}

const read::Expansion* ExpandedTemplates::failed(const std::string& path) const {
  const read::Expansion* expansion = find(path);
  return expansion != nullptr && !expansion->text ? expansion : nullptr;
}

Diagnostics ExpandedTemplates::in_source(const std::string& path, Diagnostics found) const {
  const read::File& file = workspace_.open(path);
  ReadResult read = environment_.disk.read(path, read::kMaxModelBytes);
  if (!file.document || !read.bytes) return found;
  const SourceId id = sources_.add(path, std::move(*read.bytes));
  const auto source = xml::parse(sources_.bytes(id), id);
  const read::XacroPlaces places(*file.document, source);
  Diagnostics traced;
  for (const Diagnostic& each : found.list()) traced.add(places.in_source(each, path));
  return traced;
}

const read::Expansion* ExpandedTemplates::find(const std::string& path) const {
  const auto known = expansions_.find(normalize_path(path));
  return known == expansions_.end() ? nullptr : &known->second;
}

}  // namespace rigor::rules
