// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/parameter/find_target.h>

#include <cstddef>
#include <cstdint>

#include <rigor/read/values.h>

namespace rigor::read {
namespace {

std::string_view name_of_target(xml::Element element) {
  const auto name = element.attribute("name");
  return name ? name->value() : std::string_view();
}

struct TargetQuery {
  std::string_view id;
  std::string_view element_name;
  bool adds;  ///< to what is found, whatever its element name is

  bool accepts(xml::Element element, std::string_view rest) const {
    return rest == name_of_target(element) && (adds || element.name() == element_name);
  }
};

/// Where the last byte of the name is in the id, if the id has it at `start`; else -1.
std::int64_t last_byte_of(std::string_view name, std::string_view id, std::int64_t start) {
  const std::string_view rest = id.substr(static_cast<std::size_t>(start));
  return rest.starts_with(name) ? start + static_cast<std::int64_t>(name.size()) - 1 : -1;
}

/// Past the `::` that follows the last byte of a name, if it does.
std::int64_t past_colons(std::string_view id, std::int64_t last) {
  const auto at = static_cast<std::size_t>(last);
  return id.find("::", at) == at + 1 ? last + 3 : last;
}

/// The same steps as libsdformat's, with what is odd about them: `longest` begins at 0, so that a name whose
/// only byte is at 0 is not longer, and a name need not end where a part of the id does.
std::optional<xml::Element> found_as_libsdformat(xml::Element parent, const TargetQuery& query) {
  std::int64_t start = 0;
  std::int64_t longest = 0;
  while (true) {
    std::optional<xml::Element> next;
    for (const xml::Element child : parent.children()) {
      const std::string_view name = name_of_target(child);
      if (name.empty()) continue;
      if (query.adds && query.id == name) return child;
      const std::int64_t last = last_byte_of(name, query.id, start);
      if (last <= longest) continue;
      if (query.accepts(child, query.id.substr(static_cast<std::size_t>(start)))) return child;
      next = child;
      longest = last;
    }
    if (!next) return std::nullopt;
    parent = *next;
    start = past_colons(query.id, longest);
  }
}

/// Whether the include is, or may be, of a model with the name that the text begins with.
bool may_be_named_by(xml::Element include, std::string_view text) {
  const auto name = include.child("name");
  const auto merge = include.attribute("merge");
  return !name || merge || text.starts_with(trimmed(name->text()));
}

}  // namespace

std::optional<xml::Element> find_target(xml::Element model, std::string_view element_name,
                                        std::string_view element_id) {
  return found_as_libsdformat(model, {element_id, element_name, false});
}

std::optional<xml::Element> find_parent_to_add_to(xml::Element model, std::string_view element_id) {
  return found_as_libsdformat(model, {element_id, {}, true});
}

bool begins_with_one_letter_name(xml::Element model, std::string_view element_id) {
  const std::string_view first = element_id.substr(0, element_id.find("::"));
  if (first.size() != 1) return false;
  for (const xml::Element child : model.children()) {
    if (name_of_target(child) == first) return true;
  }
  return false;
}

bool may_lead_into_include(xml::Element model, std::string_view element_id) {
  while (true) {
    std::optional<xml::Element> next;
    for (const xml::Element child : model.children()) {
      if (child.name() == "include" && may_be_named_by(child, element_id)) return true;
      const std::string_view name = name_of_target(child);
      if (child.name() == "model" && !name.empty() && element_id.starts_with(name)) next = child;
    }
    const std::size_t colons = element_id.find("::");
    if (!next || colons == std::string_view::npos) return false;
    model = *next;
    element_id.remove_prefix(colons + 2);
  }
}

}  // namespace rigor::read
