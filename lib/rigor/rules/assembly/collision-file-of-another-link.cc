// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::collision_file_of_another_link {

// Links whose collision and visual files have one name, which say that this robot's have.
constexpr std::size_t kFewest = 3;

std::string_view file_name(std::string_view uri) {
  const std::size_t slash = uri.find_last_of('/');
  return slash == std::string_view::npos ? uri : uri.substr(slash + 1);
}

std::string_view stem_of(std::string_view uri) {
  const std::string_view name = file_name(uri);
  return name.substr(0, name.find('.'));
}

/// What the part is called: the stem in lower case, without words that say what the file is for.
std::string part_name(std::string_view uri) {
  std::string name(stem_of(uri));
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  constexpr std::array<std::string_view, 8> kUses{"collision",  "visual", "convex", "hull",
                                                  "simplified", "coll",   "vis",    "col"};
  for (const std::string_view use : kUses) {
    const std::size_t at = name.rfind(use);
    if (at == std::string::npos) continue;
    const bool ends = at + use.size() == name.size();
    if (!ends && at != 0) continue;
    name.erase(at, use.size());
  }
  const auto is_mark = [](char c) { return c == '_' || c == '-' || c == '.'; };
  while (!name.empty() && is_mark(name.back())) name.pop_back();
  while (!name.empty() && is_mark(name.front())) name.erase(0, 1);
  return name;
}

struct FileOf {
  std::uint32_t index = 0;  ///< in the root's collisions or visuals
  const model::Field<std::string>* uri = nullptr;
  std::string part;
};

/// Whether both are one part, but for a letter or two at an end: `finger` and `finger_c`.
bool is_variant(const std::string& a, const std::string& b) {
  const std::string& longer = a.size() > b.size() ? a : b;
  const std::string& shorter = a.size() > b.size() ? b : a;
  constexpr std::size_t kMaxLetters = 3;
  if (longer.size() > shorter.size() + kMaxLetters || !longer.starts_with(shorter)) return false;
  const std::string_view more = std::string_view(longer).substr(shorter.size());
  return std::none_of(more.begin(), more.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The mesh files of a link.
struct LinkFiles {
  std::uint32_t link = 0;
  std::vector<FileOf> touched;
  std::vector<FileOf> seen;

  bool shows(const std::string& part) const {
    return std::any_of(seen.begin(), seen.end(),
                       [&part](const FileOf& file) { return is_variant(part, file.part); });
  }
  bool fits() const {
    return std::all_of(touched.begin(), touched.end(),
                       [this](const FileOf& file) { return shows(file.part); });
  }
};

template <class Ids>
std::vector<FileOf> files_of(const Ids& ids, const model::Root& root) {
  std::vector<FileOf> result;
  for (const auto id : ids) {
    const auto* mesh = std::get_if<model::Mesh>(&root[id].geometry.shape);
    if (mesh == nullptr || mesh->uri.value.empty() || !mesh->submesh.value.empty()) continue;
    result.push_back({id.value, &mesh->uri, part_name(mesh->uri.value)});
  }
  return result;
}

std::map<std::uint32_t, std::vector<LinkFiles>> files_by_model(const model::Root& root) {
  std::map<std::uint32_t, std::vector<LinkFiles>> models;
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    const model::Link& link = root.links[i];
    if (!root.own(link.site) || link.collisions.empty() || link.visuals.empty()) continue;
    LinkFiles files{i, files_of(link.collisions, root), files_of(link.visuals, root)};
    if (!files.touched.empty() && !files.seen.empty())
      models[link.model.value].push_back(std::move(files));
  }
  return models;
}

void check(const model::Root& root, Context& context) {
  if (root.links.size() <= kFewest) return;
  for (const auto& [model, links] : files_by_model(root)) {
    const auto fitting = static_cast<std::size_t>(std::count_if(
        links.begin(), links.end(), [](const LinkFiles& files) { return files.fits(); }));
    if (fitting < kFewest || fitting + 1 < links.size()) continue;
    for (const LinkFiles& files : links) {
      for (const FileOf& touched : files.touched) {
        if (files.shows(touched.part)) continue;
        const auto owner = std::find_if(links.begin(), links.end(), [&](const LinkFiles& other) {
          return other.link != files.link && other.shows(touched.part);
        });
        if (owner == links.end()) continue;
        const model::Collision& collision = root.collisions[touched.index];
        context.report({.where = touched.uri->span,
                        .message = fmt::format(
                            "the collision's file is '{}', that of link '{}'; this link's "
                            "visual is '{}'",
                            file_name(touched.uri->value), root.links[owner->link].name.value,
                            file_name(files.seen.front().uri->value)),
                        .subject = context.subject(collision),
                        .related = {{files.seen.front().uri->span, "the visual of this link"}},
                        .help = fmt::format(
                            "the {} other links have collisions named as their visuals", fitting)});
      }
    }
  }
}

Rule rule() {
  return {
      .name = "collision-file-of-another-link",
      .severity = Severity::kWarning,
      .summary = "a link's collision is the mesh file of another link",
      .why = "The link touches what it does not reach, and passes through what it hits. The "
             "collision's file has the name of another link's visual, while the robot's other "
             "links have collisions and visuals of one name: a block was copied and not changed. "
             "Names are compared, so that it is found without the files, too.",
      .what_to_do = "Use the file of this link.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::collision_file_of_another_link
