// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The names of one document: what it defines, and where it refers to what by name.
//
//   const FileNames names = file_names(document);
//   for (const NameReference& reference : names.references) point_at(reference.where);
//
// Definitions are models, links, joints and frames; references are those of the formats, and what plugins,
// transmissions, ros2_control and SRDF are reported. Nothing is resolved here: names cross files (name_graph.h).

#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/span.h>
#include <rigor/xml/document.h>

namespace rigor::author {

enum class NameKind : std::uint8_t { kLink = 1, kJoint = 2, kFrame = 4, kModel = 8 };

std::string_view to_string(NameKind kind);

/// A set of kinds, a bit each.
class NameKinds {
 public:
  constexpr NameKinds(std::initializer_list<NameKind> kinds) {
    for (const NameKind kind : kinds) bits_ |= static_cast<unsigned>(kind);
  }
  constexpr bool has(NameKind kind) const { return (bits_ & static_cast<unsigned>(kind)) != 0; }

 private:
  unsigned bits_ = 0;
};

inline constexpr std::uint32_t kNoEntity = 0xffffffffU;

/// In which names are unique: a model, a world, a robot, the top of a file.
struct NameScope {
  std::uint32_t outer = 0;          ///< index of the scope around it; of the first, itself
  std::uint32_t model = kNoEntity;  ///< index of the entity that it is the inside of
};

struct NamedEntity {
  NameKind kind = NameKind::kLink;
  std::string name;  ///< empty for an include that takes its model's own name
  Span where;        ///< of the name; nowhere without one
  Span element;
  std::uint32_t scope = 0;           ///< index of the scope that it is defined in
  std::uint32_t inside = kNoEntity;  ///< of a model: index of its own scope
  std::string uri;                   ///< of an include
  bool merged = false;               ///< an include whose parts join the scope
};

struct NameReference {
  std::string text;  ///< "arm::hand"
  Span where;        ///< of the text, as it is written
  std::uint32_t scope = 0;
  std::uint32_t within =
      kNoEntity;  ///< an entity in whose inside the text is looked up, rather than in `scope`
  NameKinds kinds{};
  /// Whether it must be a name. What a plugin is told is one only where something has that name.
  bool certain = true;
};

struct FileNames {
  bool shared_kinds = true;  ///< SDF: a link and a joint of one scope do not have one name
  std::vector<NameScope> scopes;
  std::vector<NamedEntity> entities;
  std::vector<NameReference> references;
};

/// What the value of an attribute, or the text of an element where `attribute` is empty, names, in a document with
/// that root; nothing where it is no name. Elements by their names.
std::optional<NameKinds> referenced_kinds(std::string_view root, std::string_view parent,
                                          std::string_view element, std::string_view attribute);

/// Of SDF, URDF and SRDF; of another document no names.
FileNames file_names(const xml::Document& document);

}  // namespace rigor::author
