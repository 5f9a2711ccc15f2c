// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What fixes are made of, beside the edits of xml/edit.h.
//
//   .fix = fix_of("remove it", Applicability::kUnsafe, xml::remove_element(context.document(), element))

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/rules/context.h>
#include <rigor/schema/suggest.h>
#include <rigor/text/edit.h>
#include <rigor/xml/edit.h>

namespace rigor::rules {

/// Nothing where there are no edits.
inline std::optional<Fix> fix_of(std::string title, Applicability applicability,
                                 std::vector<Edit> edits) {
  if (edits.empty()) return std::nullopt;
  return Fix{std::move(title), applicability, std::move(edits)};
}

/// Takes an element away, with all that is in it.
inline std::vector<Edit> removed(const Context& context, const model::Site& site) {
  return xml::remove_element(context.document(), context.element(site));
}

/// Gives an element another name, in its start tag and its end tag.
inline std::vector<Edit> renamed(const Context& context, const model::Site& site,
                                 std::string_view name) {
  return xml::rename_element(context.document(), context.element(site), name);
}

/// Puts a child into an element, behind the child that the span `after` is in the tag or text of; as the
/// last one when that is nowhere.
inline std::vector<Edit> inserted(const Context& context, const model::Site& parent, Span after,
                                  std::string_view child) {
  const auto before = after.nowhere() ? std::nullopt : context.document().element_at(after.begin);
  return xml::insert_child(context.document(), context.element(parent), before, child);
}

/// Takes an attribute away, and the blanks before it; nothing where there is none.
inline std::vector<Edit> attribute_removed(const Context& context, const model::Site& site,
                                           std::string_view name) {
  const auto attribute = context.element(site).attribute(name);
  if (!attribute) return {};
  return xml::remove_attribute(context.document(), *attribute);
}

/// Takes a text away, and the line with it when nothing else stands there.
inline Edit without(const Context& context, Span text) {
  const std::string_view bytes = context.document().bytes();
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  Span line = text;
  while (line.begin > 0 && is_blank(bytes[line.begin - 1])) --line.begin;
  while (line.end < bytes.size() && is_blank(bytes[line.end])) ++line.end;
  if (line.begin > 0 && bytes[line.begin - 1] != '\n') return {text, ""};
  if (bytes.substr(line.end).starts_with("\r\n"))
    return {{line.source, line.begin, line.end + 2}, ""};
  if (bytes.substr(line.end).starts_with('\n'))
    return {{line.source, line.begin, line.end + 1}, ""};
  return {text, ""};
}

/// Takes a part of a value away, and the blanks before it.
inline Edit without_part(const Context& context, Span part) {
  const std::string_view bytes = context.document().bytes();
  while (part.begin > 0 && (bytes[part.begin - 1] == ' ' || bytes[part.begin - 1] == '\t')) {
    --part.begin;
  }
  return {part, ""};
}

/// Puts the only candidate that is near in the place of what stands at `where`; nothing when there is none,
/// or several.
inline std::optional<Fix> nearest_instead(std::string_view written,
                                          const std::vector<std::string_view>& candidates,
                                          Span where) {
  const auto near = schema::near(written, candidates);
  if (near.size() != 1) return std::nullopt;
  const std::string meant(near.front());
  return Fix{"write '" + meant + "'", Applicability::kUnsafe, {{where, meant}}};
}

/// Puts what stands at one place at the other, and the other way round.
inline Fix swap(const std::string& title, Span a, Span b, const Context& context) {
  return {title,
          Applicability::kUnsafe,
          {{a, std::string(context.bytes(b))}, {b, std::string(context.bytes(a))}}};
}

}  // namespace rigor::rules
