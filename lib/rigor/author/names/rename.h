// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Another name for a model, link, joint or frame, in every file that refers to it, as byte edits.
//
//   NameGraph graph(workspace, resolver);
//   const auto wheel = graph.find("robot.urdf", "wheel");
//   const Renaming renaming = renamed({graph, resolver, sources}, *wheel, "left_wheel", files);
//   if (renaming.refused.empty()) apply(renaming.edits);
//
// Controllers' YAML and scenarios' TOML do not say of which robot they are: a name is changed in them where a key says
// that it is one, and no other model has it; whatever else reads like it is listed as suspected.
//
// In templates the edits are of what their authors wrote. A name that an expression composes is refused; so is
// one whose renaming would change anything else of an expansion, which is expanded again and compared.

#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/names/name_graph.h>
#include <rigor/author/names/workspace_files.h>
#include <rigor/read/resolver.h>
#include <rigor/text/edit.h>
#include <rigor/text/sources.h>

namespace rigor::author {

struct RenameContext {
  NameGraph& graph;
  const read::Resolver& resolver;
  Sources& sources;  ///< of the graph's workspace
};

struct Renaming {
  std::vector<Edit> edits;  ///< of any number of files, sorted, none of them twice
  std::string refused;      ///< why there are none, as the end of a sentence; empty when there are
  /// Places that may be the name: in files of parameters, in texts that are not understood, and in other files of a
  /// robot of that name; none of them is among the edits.
  std::vector<Span> suspected = {};
};

/// Of the file that defines the name, and of `files`: models, templates, files of parameters and other texts of the
/// workspace, or none for that file alone.
Renaming renamed(const RenameContext& context, const EntityId& target, std::string_view name,
                 const ReferringFiles& files);

/// Several at once, each to its own name, so that names may change places.
Renaming renamed(const RenameContext& context, const std::map<EntityId, std::string>& names,
                 const ReferringFiles& files);

/// Why no model, link, joint or frame can have the name; empty when it can.
std::string name_fault(std::string_view name);

}  // namespace rigor::author
