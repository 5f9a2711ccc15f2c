// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "command/edit/rename_target.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <rigor/author/verbs/edited_model.h>
#include <rigor/read/workspace.h>

#include "command/command.h"

namespace rigor::tool {
namespace {

using author::EntityId;
using author::NameGraph;

constexpr std::array<author::NameKind, 4> kRenamedKinds{
    author::NameKind::kLink, author::NameKind::kJoint, author::NameKind::kFrame,
    author::NameKind::kModel};

/// Of a file with many models the first tell enough.
constexpr std::size_t kMaxNamesakesShown = 4;

void keep_kind(NameGraph& graph, const std::string& kind, std::vector<EntityId>& found) {
  if (kind.empty()) return;
  std::vector<std::string_view> names;
  for (const author::NameKind each : kRenamedKinds) names.push_back(to_string(each));
  const author::NameKind asked = kRenamedKinds[choice("--kind", kind, names)];
  std::erase_if(found, [&](const EntityId& id) { return graph.entity(id).kind != asked; });
}

/// "joint arm::elbow (line 12)"
std::string described(NameGraph& graph, const Sources& sources, const EntityId& id) {
  const author::NamedEntity& entity = graph.entity(id);
  std::string text = fmt::format("{} {}", to_string(entity.kind), graph.scoped_name(id));
  // Lines of an expansion are nowhere written.
  if (!entity.where.nowhere() && !graph.file(id.path).expanded)
    text +=
        fmt::format(" (line {})", sources.position(entity.where.source, entity.where.begin).line);
  return text;
}

[[noreturn]] void refuse_several(NameGraph& graph, const Sources& sources, const std::string& file,
                                 const std::string& name, const std::vector<EntityId>& found) {
  std::string all;
  bool is_of_one_kind = true;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i < kMaxNamesakesShown) all += (i == 0 ? "" : ", ") + described(graph, sources, found[i]);
    is_of_one_kind = is_of_one_kind && graph.entity(found[i]).kind == graph.entity(found[0]).kind;
  }
  if (found.size() > kMaxNamesakesShown)
    all += fmt::format(" and {} more", found.size() - kMaxNamesakesShown);
  throw InputError(fmt::format("{}: {} are named '{}': {}: choose one with {}", file, found.size(),
                               name, all,
                               is_of_one_kind ? "--model, or by its scoped name" : "--kind"));
}

}  // namespace

EntityId found_in(NameGraph& graph, const Sources& sources, const std::string& file,
                  const RenameTarget& target) {
  const auto& document = graph.file(file).document;
  if (document && document->root() && document->root()->name() == "mujoco")
    throw InputError(file + std::string(author::kMjcfNotEdited));
  std::vector<EntityId> found = graph.find_all(file, target.name, target.model);
  if (found.empty() && !target.model.empty() && graph.find_all(file, target.model).empty())
    throw InputError(fmt::format("{} has no model '{}'", file, target.model));
  keep_kind(graph, target.kind, found);
  if (found.empty()) {
    throw InputError(fmt::format("{}: no{} is named '{}'{}", file,
                                 target.kind.empty() ? "thing" : ' ' + target.kind, target.name,
                                 target.model.empty() ? "" : " in model '" + target.model + '\''));
  }
  if (found.size() > 1) refuse_several(graph, sources, file, target.name, found);
  return found.front();
}

}  // namespace rigor::tool
