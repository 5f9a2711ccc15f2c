// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>

#include <rigor/read/mjcf/mjcf_checks.h>

namespace rigor::read {
namespace {

using MjcfOptions = std::map<std::string, std::string>;

/// Of all `<option>`, the last of each.
MjcfOptions options_of(const MjcfTree& tree) {
  MjcfOptions options;
  for (const xml::Element section : tree.children(tree.root())) {
    if (section.name() != "option") continue;
    for (const xml::Attribute attribute : section.attributes()) {
      options[std::string(attribute.name())] = trimmed(attribute.value());
    }
  }
  return options;
}

bool is_same(const std::string& a, const std::string& b) {
  if (a == b) return true;
  const auto numbers = mjcf_numbers(a);
  return numbers && numbers == mjcf_numbers(b);
}

/// Those that conflict="merge" takes the smaller or the larger of.
constexpr std::array<std::string_view, 12> kMergedOptions{
    "timestep",          "tolerance",       "ls_tolerance",   "noslip_tolerance",
    "ccd_tolerance",     "sleep_tolerance", "iterations",     "ls_iterations",
    "noslip_iterations", "ccd_iterations",  "sdf_iterations", "sdf_initpoints"};

}  // namespace

void check_mjcf_attached(const MjcfScope& scope, const MjcfScope& attached, xml::Element element,
                         MjcfFacts& facts) {
  std::string policy;
  for (const xml::Element section : scope.tree.children(scope.tree.root())) {
    if (section.name() != "compiler") continue;
    if (const auto conflict = section.attribute("conflict")) policy = trimmed(conflict->value());
  }
  if (policy != "error" && policy != "merge") return;
  const MjcfOptions own = options_of(scope.tree);
  for (const auto& [name, value] : options_of(attached.tree)) {
    const auto mine = own.find(name);
    if (mine == own.end() || is_same(mine->second, value)) continue;
    const bool merged =
        std::find(kMergedOptions.begin(), kMergedOptions.end(), name) != kMergedOptions.end();
    if (policy == "merge" && merged) continue;
    facts.push_back({.kind = MjcfFactKind::kAttachConflict,
                     .where = element.tag_span(),
                     .name = policy,
                     .detail = name + " is '" + mine->second + "' here and '" + value + "' in " +
                               attached.tree.file().path});
    return;
  }
}

void check_mjcf_plugins(const MjcfScope& scope, MjcfFacts& facts) {
  for (const xml::Element plugin : scope.tree.in_sections("extension")) {
    if (plugin.name() != "plugin") continue;
    const auto name = mjcf_name(plugin, "plugin");
    if (!name.written) continue;
    facts.push_back({.kind = MjcfFactKind::kPluginNeeded, .where = name.span, .name = name.value});
  }
}

}  // namespace rigor::read
