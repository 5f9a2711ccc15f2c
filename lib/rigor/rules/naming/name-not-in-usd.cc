// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/rule.h>

namespace rigor::rules::name_not_in_usd {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }  // USD of today takes others

/// What name-nonportable tells of, whatever the file is for.
bool is_reported_elsewhere(std::string_view name) {
  return name.find_first_of(" /\\:\"'#") != std::string_view::npos;
}

bool is_taken(std::string_view name) {
  const auto fits = [](char c) { return is_letter(c) || is_digit(c) || !is_ascii(c); };
  return name.empty() || (!is_digit(name.front()) && std::all_of(name.begin(), name.end(), fits));
}

std::string in_usd(std::string_view name) {
  std::string taken(name);
  for (char& c : taken) {
    if (is_ascii(c) && !is_letter(c) && !is_digit(c)) c = '_';
  }
  return taken;
}

template <class Entity>
void check_names(const std::vector<Entity>& entities, Context& context) {
  std::map<std::string, const Entity*> first;
  for (const Entity& entity : entities) first.try_emplace(entity.name.value, &entity);
  for (const Entity& entity : entities) {
    const std::string& name = entity.name.value;
    if (is_taken(name) || is_reported_elsewhere(name)) continue;
    const std::string taken = in_usd(name);
    Finding finding{.where = entity.name.span,
                    .message = "'" + name + "' is no name in USD: it becomes " +
                               (is_digit(name.front()) ? "another" : "'" + taken + "'"),
                    .subject = context.subject(entity)};
    const auto [same, is_new] = first.try_emplace(taken, &entity);
    if (!is_new && same->second != &entity) {
      finding.message += ", which another has";
      finding.related = {{same->second->name.span, "the other"}};
    }
    context.report(finding);
  }
}

void check(const model::Root& root, Context& context) {
  check_names(root.links, context);
  check_names(root.joints, context);
}

Rule rule() {
  return {
      .name = "name-not-in-usd",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .targets = {Target::kIsaac},
      .summary = "a name of a link or joint is none that USD takes",
      .why =
          "A prim of USD is named by letters, digits and underscores, and begins with no digit. "
          "Isaac Sim's importer replaces the other characters by underscores, so programs that ask "
          "for the joint by its name in the URDF do not find it, and two names may become one.",
      .what_to_do =
          "Write letters, digits and underscores; its documentation advises to do so in the URDF.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::name_not_in_usd
