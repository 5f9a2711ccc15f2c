// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What may stand where in a file, for every version of a format. A schema is one text
// (schemas/*.schema, which explains its own language at the top) that is parsed once into tables of
// views of that text; a Node is a cheap view of one element or attribute as it is in one version,
// and walking a document is walking from Node to Node.
//
//   auto parsed = Schema::parse(sdf_schema_text());  // the text must outlive the schema
//   const Schema& schema = std::get<Schema>(parsed);
//   std::optional<Node> sdf = schema.root("sdf", Version{10});
//   std::optional<Node> link = sdf->child("model")->child("link");
//   for (Node required : link->required_attributes()) { ... }    // name
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <rigor/schema/type.h>
#include <rigor/schema/version.h>

namespace rigor::schema {

enum class Cardinality : std::uint8_t {
  kOptional,    // at most one
  kOne,         // exactly one
  kMany,        // any number
  kOneOrMore,   // at least one
  kDeprecated,  // at most one, and better none
};

// The way a schema file writes it: 0, 1, *, +, -1.
std::string_view to_string(Cardinality cardinality);

// The values a consumer knows, in the order of the schema file. Empty: any value will do.
class Enumeration {
 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = std::string_view;
    using difference_type = std::ptrdiff_t;
    using pointer = const std::string_view*;
    using reference = std::string_view;

    Iterator() = default;
    explicit Iterator(std::string_view rest) : rest_(rest), done_(rest.empty()) {}
    std::string_view operator*() const { return rest_.substr(0, rest_.find('|')); }
    Iterator& operator++();
    Iterator operator++(int);
    bool operator==(const Iterator& other) const {
      return done_ == other.done_ && (done_ || rest_.data() == other.rest_.data());
    }

   private:
    std::string_view rest_;
    bool done_ = true;
  };

  Enumeration() = default;
  explicit Enumeration(std::string_view text) : text_(text) {}
  bool empty() const { return text_.empty(); }
  bool contains(std::string_view value) const;  // bytes must be equal: "Revolute" is not "revolute"
  Iterator begin() const { return Iterator(text_); }
  Iterator end() const { return Iterator(); }

 private:
  std::string_view text_;  // a|b|c
};

// How many values of its type an attribute holds, with spaces between.
struct Count {
  std::size_t least = 1;
  std::optional<std::size_t> most;
  std::size_t multiple = 1;  // and their number is a multiple of this

  bool allows(std::size_t number) const {
    return number >= least && (!most || number <= *most) && number % multiple == 0;
  }
};
std::string to_string(const Count& count);  // "3 numbers", "1 to 3 numbers"

struct Tables;  // the parsed file; private to schema.cc and parse.cc
class NodeRange;

// One element or attribute as it is in one version: a few words to copy. Valid as long as the
// Schema it comes from.
class Node {
 public:
  std::string_view name() const;
  std::string_view doc() const;  // one line; empty for some attributes
  Version version() const { return Version{minor_}; }

  Type type() const;
  std::optional<Count> count() const;  // nothing: the type's own number
  Cardinality cardinality() const;
  std::optional<std::string_view> default_value() const;  // may be the empty text
  std::optional<std::string_view> minimum() const;        // inclusive
  std::optional<std::string_view> maximum() const;        // inclusive
  Enumeration enumeration() const;
  // Whether more than its type may limit a value: an enumeration, a minimum or a maximum in some version.
  bool may_have_limits() const;
  // The first later version in which a value is listed that this one does not list.
  std::optional<Version> listed_since(std::string_view value) const;
  std::string_view unit() const;  // empty: none, or none that can be named

  Version since() const;                 // first version in which this place exists
  std::optional<Version> until() const;  // last one; nothing when it exists in the latest
  std::optional<Version> deprecated_since() const;  // nothing when not deprecated in this version
  std::string_view instead() const;  // what to use in place of it; empty when nobody knows
  bool open() const;                 // what stands inside is not described: a plugin

  // The child or attribute of that name that exists in this version. No allocation.
  std::optional<Node> child(std::string_view name) const;
  std::optional<Node> attribute(std::string_view name) const;

  // The one that exists not now but in another version, as it is there: the nearest later one, or
  // else the nearest earlier one. Nothing when it exists now, or never.
  std::optional<Node> child_in_other_version(std::string_view name) const;
  std::optional<Node> attribute_in_other_version(std::string_view name) const;

  // Those that exist in this version, in the order of the schema file; required is 1 and +.
  NodeRange children() const;
  NodeRange attributes() const;
  NodeRange required_children() const;
  NodeRange required_attributes() const;
  bool requires_children() const;  // whether there are any: of most elements none
  bool requires_attributes() const;

  // The same number for every place where the same block is used: a model in a world and a model in
  // a model. What is inside is the same, so a walk that must end need not enter a number twice.
  std::uint32_t declaration() const { return declaration_; }

  // Another number for every child and every attribute of a declaration.
  std::uint32_t place() const { return place_; }

 private:
  friend class Schema;
  friend class NodeRange;
  Node(const Tables* tables, std::uint32_t place, std::uint32_t declaration, int minor)
      : tables_(tables), place_(place), declaration_(declaration), minor_(minor) {}

  const Tables* tables_;
  std::uint32_t place_;        // the line where it stands: `use` or its own
  std::uint32_t declaration_;  // the line that says what is inside
  int minor_;
};

// Nodes to iterate over, once or often; nothing is stored.
class NodeRange {
 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Node;
    using difference_type = std::ptrdiff_t;
    using pointer = const Node*;
    using reference = Node;

    Iterator() = default;
    Node operator*() const;
    Iterator& operator++();
    Iterator operator++(int);
    bool operator==(const Iterator& other) const { return at_ == other.at_; }

   private:
    friend class NodeRange;
    Iterator(const NodeRange& range, std::uint32_t at)
        : tables_(range.tables_),
          at_(at),
          last_(range.last_),
          minor_(range.minor_),
          required_(range.filter_ == Filter::kRequired) {
      if (at_ != last_) skip();
    }
    void skip();  // to the next that the filter holds, or the end

    const Tables* tables_ = nullptr;
    std::uint32_t at_ = 0, last_ = 0;
    int minor_ = 0;
    bool required_ = false;
  };

  Iterator begin() const { return Iterator(*this, first_); }
  Iterator end() const { return Iterator(*this, last_); }
  bool empty() const { return begin() == end(); }

 private:
  friend class Node;
  friend class Schema;
  enum class Filter : std::uint8_t { kAll, kRequired };
  NodeRange(const Tables* tables, std::uint32_t first, std::uint32_t last, int minor, Filter filter)
      : tables_(tables), first_(first), last_(last), minor_(minor), filter_(filter) {}

  const Tables* tables_;
  std::uint32_t first_, last_;  // half-open, into the tables' entries
  int minor_;
  Filter filter_;
};

class Schema {
 public:
  // What is wrong with a schema text; a defect of the schema, never of a user's model.
  struct Fault {
    int line = 0;  // from 1
    std::string message;
  };

  // The text is not copied and must outlive the schema and every Node.
  static std::variant<Schema, Fault> parse(std::string_view text);

  Schema(Schema&&) noexcept;
  Schema& operator=(Schema&&) noexcept;
  ~Schema();

  // Oldest first.
  const std::vector<Version>& versions() const;
  Version latest() const { return versions().back(); }
  bool knows(Version version) const;
  // The newest known version that is not newer than this one; the oldest for one before all.
  Version nearest(Version version) const;

  // The root element of a document: "sdf". Nothing for another name or a version this schema does
  // not know.
  std::optional<Node> root(std::string_view element_name, Version version) const;
  // All roots of that version.
  NodeRange roots(Version version) const;

  // Where an element of that name may stand in this version, for the message "misplaced": paths as
  // short as they are clear, "link" or "joint/axis". In the order of the schema file, each once.
  std::vector<std::string> parents_of(std::string_view name, Version version) const;

 private:
  explicit Schema(std::unique_ptr<const Tables> tables);
  std::unique_ptr<const Tables> tables_;
};

}  // namespace rigor::schema
