// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/srdf/srdf_text.h>

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

using LinkNames = std::pair<std::string, std::string>;

/// A pair has no order.
LinkNames link_names(std::string a, std::string b) {
  if (b < a) std::swap(a, b);
  return {std::move(a), std::move(b)};
}

/// Six digits: a hundred-thousandth of a degree.
std::string position_text(double position) {
  return fmt::format("{:.6g}", position == 0 ? 0.0 : position);
}

std::string disable_element(const DisabledPair& pair) {
  return fmt::format(R"(<disable_collisions link1="{}" link2="{}" reason="{}"/>)",
                     xml::escaped(pair.link1), xml::escaped(pair.link2), xml::escaped(pair.reason));
}

class SrdfWriter {
 public:
  std::string write(const Semantics& semantics) && {
    line(0, R"(<?xml version="1.0" encoding="UTF-8"?>)");
    line(0, R"(<robot name="{}">)", xml::escaped(semantics.robot));
    for (const SemanticGroup& group : semantics.groups) write_group(group);
    for (const SemanticState& state : semantics.states) write_state(state);
    for (const EndEffector& effector : semantics.end_effectors) {
      line(1, R"(<end_effector name="{}" parent_link="{}" group="{}" parent_group="{}"/>)",
           xml::escaped(effector.name), xml::escaped(effector.parent_link),
           xml::escaped(effector.group), xml::escaped(effector.parent_group));
    }
    if (const auto& joint = semantics.virtual_joint) {
      line(1, R"(<virtual_joint name="{}" type="{}" parent_frame="{}" child_link="{}"/>)",
           xml::escaped(joint->name), joint->type, xml::escaped(joint->parent_frame),
           xml::escaped(joint->child_link));
    }
    for (const DisabledPair& pair : semantics.disabled) line(1, "{}", disable_element(pair));
    line(0, "</robot>");
    return std::move(text_);
  }

 private:
  void write_group(const SemanticGroup& group) {
    line(1, R"(<group name="{}">)", xml::escaped(group.name));
    if (!group.tip_link.empty()) {
      line(2, R"(<chain base_link="{}" tip_link="{}"/>)", xml::escaped(group.base_link),
           xml::escaped(group.tip_link));
    }
    for (const std::string& link : group.links) line(2, R"(<link name="{}"/>)", xml::escaped(link));
    for (const std::string& joint : group.joints)
      line(2, R"(<joint name="{}"/>)", xml::escaped(joint));
    line(1, "</group>");
  }

  void write_state(const SemanticState& state) {
    line(1, R"(<group_state name="{}" group="{}">)", xml::escaped(state.name),
         xml::escaped(state.group));
    for (const auto& [joint, position] : state.positions)
      line(2, R"(<joint name="{}" value="{}"/>)", xml::escaped(joint), position_text(position));
    line(1, "</group_state>");
  }

  template <class... Args>
  void line(std::size_t level, fmt::format_string<Args...> format, Args&&... args) {
    text_.append(4 * level, ' ');
    text_ += fmt::format(format, std::forward<Args>(args)...);
    text_ += '\n';
  }

  std::string text_;
};

std::string attribute_value(xml::Element element, std::string_view name) {
  const auto attribute = element.attribute(name);
  return attribute ? std::string(attribute->value()) : std::string();
}

}  // namespace

std::string srdf_text(const Semantics& semantics) { return SrdfWriter().write(semantics); }

MatrixUpdate updated_matrix(const xml::Document& document,
                            const std::vector<DisabledPair>& disabled) {
  MatrixUpdate update;
  const auto root = document.root();
  if (!root || !document.complete()) {
    update.refused = "is not well-formed";
    return update;
  }
  if (root->name() != "robot") {
    update.refused = "is not an SRDF: its root is no <robot>";
    return update;
  }
  // An SRDF names links and joints only within groups and states.
  for (const char* part : {"link", "joint"}) {
    if (!root->child(part)) continue;
    update.refused = fmt::format("is a URDF, not an SRDF: its <robot> has a <{}>", part);
    return update;
  }
  std::map<LinkNames, const DisabledPair*> wanted;
  for (const DisabledPair& pair : disabled)
    wanted.emplace(link_names(pair.link1, pair.link2), &pair);
  std::set<LinkNames> written;
  std::vector<xml::Element> computed;
  std::optional<xml::Element> last, last_pair;  // children that stay
  for (const xml::Element child : root->children()) {
    const bool is_pair = child.name() == "disable_collisions";
    if (is_pair && is_computed_reason(attribute_value(child, "reason"))) {
      computed.push_back(child);
      continue;
    }
    last = child;
    if (!is_pair) continue;
    last_pair = child;
    ++update.by_hand;
    written.insert(link_names(attribute_value(child, "link1"), attribute_value(child, "link2")));
  }
  for (const xml::Element child : computed) {
    const LinkNames names =
        link_names(attribute_value(child, "link1"), attribute_value(child, "link2"));
    const auto pair = wanted.find(names);
    if (pair == wanted.end() || !written.insert(names).second) {
      append(update.edits, xml::remove_element(document, child));
      ++update.removed;
      continue;
    }
    if (!last_pair || last_pair->index() < child.index()) last_pair = child;
    if (attribute_value(child, "reason") == pair->second->reason) continue;
    append(update.edits, xml::set_attribute(document, child, "reason", pair->second->reason));
    ++update.changed;
  }
  std::string added;
  for (const DisabledPair& pair : disabled) {
    if (!written.insert(link_names(pair.link1, pair.link2)).second) continue;
    if (!added.empty()) added += '\n';
    added += disable_element(pair);
    ++update.added;
  }
  if (!added.empty()) {
    append(update.edits, xml::insert_child(document, *root, last_pair ? last_pair : last, added));
  }
  return update;
}

}  // namespace rigor::author
