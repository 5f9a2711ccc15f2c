// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The result of an expansion, and the files it is made of: a light tree of elements, texts and comments,
// each of which knows where it was written and what brought it there.
//
//   for (const Node* link = root.first; link != nullptr; link = link->next)
//     if (const NodeAttribute* name = link->attribute("name")) use(name->value, name->where);

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <string_view>

#include <rigor/text/span.h>
#include <rigor/xacro/arena.h>

namespace rigor::xacro {

/// Where a text is written. In a `verbatim` one, offsets in the value are offsets in the file.
struct Place {
  Span span;
  bool verbatim = true;

  /// Of a part of the text; all of it where offsets mean nothing.
  Place part(std::size_t begin, std::size_t end) const {
    if (!verbatim || span.nowhere()) return *this;
    const auto at = [this](std::size_t offset) {
      return span.begin + static_cast<std::uint32_t>(offset < span.size() ? offset : span.size());
    };
    return {{span.source, at(begin), at(end)}, true};
  }
};

/// What is known of a text before it is evaluated: nothing, that it is white space alone, that it holds no
/// `$`, or the number of the text among those that `TextTemplates` takes apart.
enum class TextCode : std::uint32_t { kUnknown, kBlank, kPlain, kFirst };

inline bool has_no_dollar(TextCode code) {
  return code == TextCode::kPlain || code == TextCode::kBlank;
}

struct NodeAttribute {
  std::string_view name;
  std::string_view value;  ///< expanded, not escaped
  Place where;             ///< of the value as it is written, without the quotes
  Span from = {};          ///< where a property, argument or YAML value in it is set; else nowhere
  TextCode code = TextCode::kUnknown;
};

/// In the memory of the nodes.
class AttributeList {
 public:
  explicit AttributeList(Arena& arena) : arena_(&arena) {}
  AttributeList(const AttributeList& other);
  AttributeList& operator=(const AttributeList& other);

  const NodeAttribute* begin() const { return first_; }
  const NodeAttribute* end() const { return first_ + size_; }
  NodeAttribute* begin() { return first_; }
  NodeAttribute* end() { return first_ + size_; }
  const NodeAttribute& operator[](std::size_t index) const { return first_[index]; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  void reserve(std::size_t room);
  void push_back(const NodeAttribute& attribute) {
    if (size_ == room_) {
      const NodeAttribute kept = attribute;
      reserve(size_ == 0 ? 2 : 2 * std::size_t{size_});
      first_[size_++] = kept;
      return;
    }
    first_[size_++] = attribute;
  }
  void erase(std::string_view name) {
    const auto* last =
        std::remove_if(begin(), end(), [name](const NodeAttribute& a) { return a.name == name; });
    size_ = static_cast<std::uint32_t>(last - first_);
  }

 private:
  Arena* arena_;
  NodeAttribute* first_ = nullptr;
  std::uint32_t size_ = 0;
  std::uint32_t room_ = 0;
};

enum class NodeKind : std::uint8_t { kElement, kText, kCData, kComment, kInstruction, kDoctype };

/// What an element means to the expander, by its name.
enum class Tag : std::uint8_t {
  kUnknown,  ///< not examined
  kPlain,    ///< none of xacro's
  kProperty,
  kMacro,
  kIf,
  kUnless,
  kInclude,
  kInsertBlock,
  kArgument,
  kElement,
  kAttribute,
  kDynamicCall,
  kCall,  ///< of a macro
};

inline constexpr std::string_view kTagPrefix = "xacro:";

Tag tag_of(std::string_view name);

struct Node {
  NodeKind kind = NodeKind::kElement;
  Tag tag = Tag::kUnknown;
  bool is_partial = false;     ///< of a result: an error took something of it, its children apart
  std::uint32_t frame = 0;     ///< index in `Expansion::frames`; 0 is the file itself
  std::string_view name = {};  ///< of an element; the target of an instruction
  std::string_view text = {};  ///< of all others
  AttributeList attributes;
  Node* parent = nullptr;
  Node* previous = nullptr;
  Node* next = nullptr;
  Node* first = nullptr;
  Node* last = nullptr;
  Place where = {};  ///< the start tag; the text
  Span from = {};    ///< as of an attribute, of a text
  TextCode code = TextCode::kUnknown;

  const NodeAttribute* attribute(std::string_view wanted) const;
  void set_attribute(const NodeAttribute& attribute);
  void append(Node& child) {
    child.parent = this;
    child.previous = last;
    child.next = nullptr;
    (last != nullptr ? last->next : first) = &child;
    last = &child;
  }
  /// All children of another node, behind those that are there.
  void take_children(Node& other);
  void remove(Node& child);
  const Node* first_element() const;
  const Node* next_element() const;
};

/// Nodes that stay where they are, with their attributes in the same few blocks of memory: there are
/// thousands of them, and they end together.
class Nodes {
 public:
  Node& emplace_back() {
    // Never destroyed: all that a node owns is in this memory.
    return *new (arena_.take(sizeof(Node), alignof(Node)))
        Node{.attributes = AttributeList(arena_)};
  }

 private:
  Arena arena_;
};

}  // namespace rigor::xacro
