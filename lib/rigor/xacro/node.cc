// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/node.h>

#include <algorithm>
#include <utility>

namespace rigor::xacro {

Tag tag_of(std::string_view name) {
  if (!name.starts_with(kTagPrefix)) return Tag::kPlain;
  constexpr std::pair<std::string_view, Tag> kTags[] = {
      {"property", Tag::kProperty}, {"macro", Tag::kMacro},     {"if", Tag::kIf},
      {"unless", Tag::kUnless},     {"include", Tag::kInclude}, {"insert_block", Tag::kInsertBlock},
      {"arg", Tag::kArgument},      {"element", Tag::kElement}, {"attribute", Tag::kAttribute},
      {"call", Tag::kDynamicCall},
  };
  name.remove_prefix(kTagPrefix.size());
  for (const auto& [known, tag] : kTags) {
    if (name == known) return tag;
  }
  return Tag::kCall;
}

AttributeList::AttributeList(const AttributeList& other) : arena_(other.arena_) { *this = other; }

AttributeList& AttributeList::operator=(const AttributeList& other) {
  if (this == &other) return *this;
  size_ = 0;
  reserve(other.size_);
  std::copy(other.begin(), other.end(), first_);
  size_ = other.size_;
  return *this;
}

void AttributeList::reserve(std::size_t room) {
  if (room <= room_) return;
  auto* const moved = static_cast<NodeAttribute*>(
      arena_->take(room * sizeof(NodeAttribute), alignof(NodeAttribute)));
  std::copy(begin(), end(), moved);
  first_ = moved;
  room_ = static_cast<std::uint32_t>(room);
}

const NodeAttribute* Node::attribute(std::string_view wanted) const {
  const auto* found = std::find_if(attributes.begin(), attributes.end(),
                                   [wanted](const NodeAttribute& a) { return a.name == wanted; });
  return found == attributes.end() ? nullptr : found;
}

void Node::set_attribute(const NodeAttribute& attribute) {
  auto* found =
      std::find_if(attributes.begin(), attributes.end(),
                   [&attribute](const NodeAttribute& a) { return a.name == attribute.name; });
  if (found == attributes.end()) {
    attributes.push_back(attribute);
  } else {
    *found = attribute;
  }
}

void Node::take_children(Node& other) {
  if (other.first == nullptr) return;
  for (Node* child = other.first; child != nullptr; child = child->next) child->parent = this;
  other.first->previous = last;
  (last != nullptr ? last->next : first) = other.first;
  last = other.last;
  other.first = nullptr;
  other.last = nullptr;
}

void Node::remove(Node& child) {
  (child.previous != nullptr ? child.previous->next : first) = child.next;
  (child.next != nullptr ? child.next->previous : last) = child.previous;
  child.parent = child.previous = child.next = nullptr;
}

const Node* Node::first_element() const {
  return first == nullptr || first->kind == NodeKind::kElement ? first : first->next_element();
}

const Node* Node::next_element() const {
  const Node* node = next;
  while (node != nullptr && node->kind != NodeKind::kElement) node = node->next;
  return node;
}

}  // namespace rigor::xacro
