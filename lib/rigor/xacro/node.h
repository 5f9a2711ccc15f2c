// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The result of an expansion, and the files it is made of: a light tree of elements, texts and comments,
// each of which knows where it was written and what brought it there.
//
//   for (const Node* link = root.first; link != nullptr; link = link->next)
//     if (const NodeAttribute* name = link->attribute("name")) use(name->value, name->where);

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <new>
#include <string_view>
#include <vector>

#include <rigor/text/span.h>

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

/// What is known of a text before it is evaluated: nothing, that it holds no `$`, or the number of the
/// text among those that `TextTemplates` takes apart.
enum class TextCode : std::uint32_t { kUnknown, kPlain, kFirst };

struct NodeAttribute {
  std::string_view name;
  std::string_view value;  ///< expanded, not escaped
  Place where;             ///< of the value as it is written, without the quotes
  Span from = {};          ///< where a property, argument or YAML value in it is set; else nowhere
  TextCode code = TextCode::kUnknown;
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
  std::uint32_t frame = 0;     ///< index in `Expansion::frames`; 0 is the file itself
  std::string_view name = {};  ///< of an element; the target of an instruction
  std::string_view text = {};  ///< of all others
  std::pmr::vector<NodeAttribute> attributes = {};
  Node* parent = nullptr;
  Node* previous = nullptr;
  Node* next = nullptr;
  Node* first = nullptr;
  Node* last = nullptr;
  Place where = {};  ///< the start tag; the text
  Span from = {};    ///< as of an attribute, of a text
  TextCode code = TextCode::kUnknown;

  const NodeAttribute* attribute(std::string_view wanted) const;
  void set_attribute(NodeAttribute attribute);
  void append(Node& child);
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
    return *new (memory_.allocate(sizeof(Node), alignof(Node)))
        Node{.attributes = std::pmr::vector<NodeAttribute>(&memory_)};
  }

 private:
  static constexpr std::size_t kFirstBlock = std::size_t{32} << 10U;
  std::pmr::monotonic_buffer_resource memory_{kFirstBlock};
};

}  // namespace rigor::xacro
