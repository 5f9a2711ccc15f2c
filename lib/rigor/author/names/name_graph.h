// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What names mean, across files: a reference in a world leads through its includes to a link of a model's file.
//
//   NameGraph graph(workspace, resolver);
//   for (const NameUse& use : graph.uses("worlds/lab.sdf")) if (use.target == link) point_at(use.where);
//
// Of `arm::hand` each part is a use of its own: of the model and of what is in it. Templates are examined as
// what they expand to; `read::ExpandedFile` leads back.

#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/author/names/file_names.h>
#include <rigor/read/resolver.h>
#include <rigor/read/workspace.h>

namespace rigor::author {

/// A definition, in the file that has it.
struct EntityId {
  std::string path;         ///< normalized
  std::uint32_t index = 0;  ///< in the entities of the file's names

  auto operator<=>(const EntityId&) const = default;
};

struct NameUse {
  EntityId target;
  Span where;  ///< of the name itself, in the file that is asked
  bool defines = false;
};

class NameGraph {
 public:
  /// Both outlive it.
  NameGraph(read::Workspace& workspace, const read::Resolver& resolver)
      : workspace_(workspace), resolver_(resolver) {}

  /// Where files that have no model of their own, SRDF, look for links and joints: robots by their paths.
  void add_robot(const std::string& path);

  const FileNames& names(const std::string& path) { return indexed(path).names; }
  const NamedEntity& entity(const EntityId& id) { return names(id.path).entities[id.index]; }
  const read::File& file(const std::string& path) { return workspace_.open(path); }

  /// All names in a file whose meaning is known: definitions, and references to any file.
  const std::vector<NameUse>& uses(const std::string& path);

  /// The definition of that name, as a reference at the file's first model would find it: "hand::palm".
  std::optional<EntityId> find(const std::string& path, std::string_view name);

  /// All definitions that the name can mean in the file: of a URDF's link and joint of one name both, of a world's
  /// models each one's. Names in a nested model count where the model around it has none such. With `model`, those of
  /// that one of the file's models.
  std::vector<EntityId> find_all(const std::string& path, std::string_view name,
                                 std::string_view model = {});

  /// "arm::hand::palm", from the file or the world that it is in.
  std::string scoped_name(const EntityId& id);

  /// Names of those kinds that a reference at a byte offset of the file can have: of the innermost model or world
  /// around it, and, behind `::`, of models in that. Of SRDF those of its robots.
  std::vector<std::string> visible(const std::string& path, std::uint32_t offset, NameKinds kinds);

  /// What else has a name in the same scope, when something has: for renaming to it.
  std::optional<EntityId> taken(const EntityId& target, std::string_view name);

 private:
  struct Place {
    std::string path;
    std::uint32_t scope = 0;
  };
  std::optional<EntityId> find_here(const Place& place, std::string_view name, NameKinds kinds);
  /// Of each kind one.
  std::vector<EntityId> find_each_kind(const Place& place, std::string_view name);
  /// Where the parts of a model are defined; nothing where its file is not there.
  std::optional<Place> inside(const EntityId& model);
  std::optional<std::string> included(const std::string& path, const NamedEntity& include);
  /// Those that the file describes by their name, as SRDF does; none of a file with names of its own.
  std::vector<std::string> described_robots(const std::string& path);
  std::vector<NameUse> parts(const std::string& path, const NameReference& reference);
  std::vector<NameUse> parts_in(Place place, const NameReference& reference);
  std::vector<NameUse> find_uses(const std::string& path);

  read::Workspace& workspace_;
  const read::Resolver& resolver_;
  std::vector<std::string> robots_;
  /// The names of a file, and where to find them.
  struct Indexed {
    FileNames names;
    std::map<std::pair<std::uint32_t, std::string_view>, std::vector<std::uint32_t>>
        by_name;  // of a scope
    std::map<std::uint32_t, std::vector<std::uint32_t>>
        unnamed;  // by scope: includes that bring names
  };
  const Indexed& indexed(const std::string& path);
  static void index(Indexed& file);

  std::map<std::string, Indexed> names_;              // by normalized path
  std::map<std::string, std::vector<NameUse>> uses_;  // the same
};

}  // namespace rigor::author
