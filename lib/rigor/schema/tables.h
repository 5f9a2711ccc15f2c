// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A parsed schema file, as parse.cc builds it and schema.cc reads it; not for other rooms. Every
// line of the file that represents an element, attribute or use is a Line; the children of a line
// lie side by side as Entries, which hold all that a search by name needs. A set of versions is a
// word with bit n for 1.n.
//
//   std::variant<Tables, Schema::Fault> parsed = parse_tables(text);
//   const Line& line = tables.lines[tables.entries[i].line];
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include <rigor/schema/schema.h>

namespace rigor::schema {

using VersionSet = std::uint32_t;
constexpr int kVersionLimit = 32;  // bits of a VersionSet; SDFormat is at 1.12 after fifteen years

constexpr VersionSet only(int minor) { return VersionSet{1} << minor; }

enum class Key : std::uint8_t {
  kCard,
  kType,
  kCount,
  kDefault,
  kMin,
  kMax,
  kEnum,
  kUnit,
  kDeprecated,
  kInstead,
};

// Nearly all that is asked of a line is whether it has a facet that it has not.
using KeySet = std::uint16_t;

constexpr KeySet only(Key key) { return static_cast<KeySet>(1U << static_cast<unsigned>(key)); }

struct Facet {
  std::string_view value;
  Key key;
  std::uint8_t from;    // minor of the first version it holds for
  std::uint8_t number;  // of the Type, Cardinality, or the minor of Deprecated
  bool present;         // false: the facet is taken away from here on
};

enum class Kind : std::uint8_t { kBlock, kElement, kAttribute, kUse };

struct Line {
  std::string_view name;
  std::string_view doc;
  std::uint32_t number = 0;                       // in the file, from 1
  std::uint32_t parent = 0;                       // line around it; itself for a block
  std::uint32_t declaration = 0;                  // of a use: the block's root element; else itself
  std::uint32_t first_facet = 0, last_facet = 0;  // half-open, by key, then version
  std::uint32_t first_child = 0, last_child = 0;  // half-open, into entries: elements and uses
  std::uint32_t first_attribute = 0, last_attribute = 0;
  VersionSet exists = 0;     // where it is written that it exists, seen from the block's own root
  VersionSet reachable = 0;  // and a document of that version can contain it
  VersionSet requires_child = 0;  // some child of it is required
  VersionSet requires_attribute = 0;
  KeySet keys = 0;                // of its facets and of its declaration's
  std::optional<Type> only_type;  // where it is one for all versions: of nearly every line
  Kind kind = Kind::kBlock;
  bool open = false;
};

struct Entry {
  const char* name;
  std::uint32_t length;
  std::uint32_t line;  // where it stands; the use, not what is used
  VersionSet exists;
  VersionSet required;
};

struct Tables {
  std::vector<Version> versions;
  VersionSet known = 0;
  std::uint32_t root = 0;  // the block `root`
  std::vector<Line> lines;
  std::vector<Facet> facets;
  std::vector<Entry> entries;

  // The facet as it is in a version: what the place says, else what the declaration says.
  const Facet* facet(std::uint32_t place, std::uint32_t declaration, Key key, int minor) const;
};

/// Nothing for what is not of the form 3, 1..3, 1.. or 3*.
std::optional<Count> parse_count(std::string_view text);

std::variant<Tables, Schema::Fault> parse_tables(std::string_view text);

}  // namespace rigor::schema
