// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/entry_points.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>

#include <rigor/text/path.h>
#include <rigor/xacro/fact.h>

namespace rigor::rules {
namespace {

struct TemplateCandidate {
  std::string path;
  std::string absolute;
  bool named = false;
  bool is_robot = false;
  bool has_name = true;
  bool ok = false;
  bool broken = false;                // no XML: it is unknown what it was to be
  bool lacks_call = false;            // an element is written like one
  std::string left_out;               // why a robot is none that can be checked by itself
  std::string lacks_package;          // whose files may hold all that makes it a robot
  std::vector<std::string> includes;  // absolute, all that was read below it
  const TemplateCandidate* includer = nullptr;
};

/// urdfdom rejects a <robot> without a name: one that has none is a part of others, included by them in
/// some condition.
bool has_name(const read::File& file) {
  const xacro::Node& root = *file.expanded->expansion().root;
  return root.name != "robot" || root.attribute("name") != nullptr;
}

bool is_named_robot(const read::File& file) {
  const xacro::Node* root = file.expanded->expansion().root;
  return root != nullptr && root->name == "robot" && has_name(file);
}

TemplateCandidate candidate_of(const std::string& path, read::Workspace& workspace,
                               const std::string& working_folder) {
  TemplateCandidate one{path, join_path(working_folder, path)};
  const read::File& file = workspace.open(path);
  if (!file.expanded) return one;
  one.is_robot = makes_robot(file);
  one.has_name = !one.is_robot || has_name(file);
  one.ok = file.expanded->is_known();
  const xacro::Expansion& expansion = file.expanded->expansion();
  for (const xacro::Fact& fact : expansion.facts) {
    one.broken = one.broken || (fact.kind == xacro::FactKind::kNotWellFormed &&
                                fact.where.source == expansion.files.front().source);
    // Its parts are missing because the call of their macro is none.
    one.lacks_call = one.lacks_call || (fact.kind == xacro::FactKind::kMissingPrefix &&
                                        fact.where.source == expansion.files.front().source);
    if (fact.kind == xacro::FactKind::kPackageNotFound && one.lacks_package.empty())
      one.lacks_package = fact.name;
    // What is near to an argument that there is was misspelt, and no launch file gives it.
    if (fact.kind == xacro::FactKind::kUndefinedArgument && fact.near.empty() &&
        one.left_out.empty()) {
      one.left_out = "xacro: argument '" + fact.name +
                     "' has no default: give sets of arguments in [[xacro]] of rigor.toml";
    }
  }
  if ((!one.lacks_package.empty() || one.lacks_call) && is_named_robot(file))
    one.is_robot = one.has_name = true;
  for (std::size_t i = 1; i < expansion.files.size(); ++i)
    one.includes.push_back(join_path(working_folder, expansion.files[i].path));
  return one;
}

}  // namespace

bool makes_robot(const read::File& file) {
  const xacro::Node* root = file.expanded->expansion().root;
  if (root == nullptr) return false;
  if (root->name == "sdf") return true;
  if (root->name != "robot") return false;
  const bool is_srdf = is_srdf_template(file.path);
  for (const xacro::Node* child = root->first_element(); child != nullptr;
       child = child->next_element()) {
    if (child->name == (is_srdf ? "group" : "link")) return true;
  }
  return false;
}

bool is_srdf_template(std::string_view path) {
  return path.ends_with(".srdf.xacro") || path.ends_with(".srdf");
}

EntryPoints entry_points(const std::vector<std::string>& paths, const std::set<std::string>& named,
                         read::Workspace& workspace, const std::string& working_folder) {
  std::vector<TemplateCandidate> all;
  all.reserve(paths.size());
  std::map<std::string, TemplateCandidate*> by_path;
  for (const std::string& path : paths) {
    all.push_back(candidate_of(path, workspace, working_folder));
    all.back().named = named.contains(path);
    by_path.emplace(all.back().absolute, &all.back());
  }
  // What a whole robot includes is seen there with its arguments; of a broken one only parts are seen.
  for (const bool whole : {true, false}) {
    for (const TemplateCandidate& robot : all) {
      if (!robot.is_robot || robot.ok != whole) continue;
      for (const std::string& path : robot.includes) {
        const auto part = by_path.find(path);
        if (part == by_path.end() || part->second == &robot || part->second->includer != nullptr)
          continue;
        if (!whole && part->second->is_robot && part->second->ok) continue;
        if (robot.includer == part->second) continue;
        part->second->includer = &robot;
      }
    }
  }
  EntryPoints found;
  for (const TemplateCandidate& one : all) {
    if (one.named || (one.is_robot && one.has_name && one.ok && one.includer == nullptr)) {
      found.robots.push_back(one.path);
    } else if (one.includer != nullptr && !one.includer->left_out.empty() && !one.includer->named) {
      found.unreached.push_back(
          {one.path, "xacro: only " + one.includer->path + " includes it, which is left out"});
    } else if (one.includer != nullptr) {
      found.parts.push_back({one.path, one.includer->path});
    } else if (!one.left_out.empty()) {
      found.unreached.push_back({one.path, one.left_out});
    } else if ((one.is_robot && one.has_name) || one.broken) {
      found.robots.push_back(one.path);
    } else {
      const std::string why =
          !one.lacks_package.empty()
              ? "package '" + one.lacks_package +
                    "' is not found: name its folder with --package " + one.lacks_package + "=DIR"
          : one.has_name ? "no robot by itself, and none includes it by default"
                         : "its <robot> has no name, and none includes it by default";
      found.unreached.push_back({one.path, "xacro: " + why});
    }
  }
  return found;
}

}  // namespace rigor::rules
