// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/mjcf/mjcf_defaults.h>

#include <algorithm>
#include <utility>

#include <rigor/read/mjcf/mjcf_settings.h>

namespace rigor::read {

std::optional<Text> MjcfValues::text(std::string_view name) const {
  if (auto own = attribute_text(own_, name)) return own;
  for (const xml::Element element : defaults_) {
    if (auto text = attribute_text(element, name)) return text;
  }
  return std::nullopt;
}

model::Field<std::string> MjcfValues::string(std::string_view name,
                                             std::string_view fallback) const {
  const auto given = text(name);
  if (!given) return {std::string(fallback), {}, false};
  return {std::string(given->text), given->span, true};
}

model::Field<double> MjcfValues::number(std::string_view name, double fallback) const {
  model::Field<double> field{fallback, {}, false};
  const auto given = text(name);
  if (!given) return field;
  const auto list = mjcf_numbers(given->text);
  if (list && !list->empty()) field = {list->front(), given->span, true};
  return field;
}

std::vector<double> MjcfValues::numbers(std::string_view name) const {
  std::vector<double> all;
  const auto add_missing = [&](const std::optional<Text>& given) {
    const auto list = given ? mjcf_numbers(given->text) : std::nullopt;
    if (!list) return !given;
    for (std::size_t i = all.size(); i < list->size(); ++i) all.push_back((*list)[i]);
    return true;
  };
  // MuJoCo reads each list over the one of the class around it.
  if (!add_missing(attribute_text(own_, name))) return {};
  for (const xml::Element element : defaults_) {
    if (!add_missing(attribute_text(element, name))) break;
  }
  return all;
}

model::Field<model::Vector3> MjcfValues::vector(std::string_view name,
                                                model::Vector3 fallback) const {
  model::Field<model::Vector3> field{fallback, {}, false};
  const std::vector<double> list = numbers(name);
  if (list.size() == 3) field = {{list[0], list[1], list[2]}, text(name)->span, true};
  return field;
}

bool MjcfValues::is_true(std::string_view name) const {
  const auto given = text(name);
  return given && given->text == "true";
}

MjcfDefaults::MjcfDefaults(const MjcfTree& tree, MjcfFacts& facts) {
  add("main", kMain);
  for (const xml::Element section : tree.children(tree.root())) {
    if (section.name() != "default") continue;
    const std::string name = mjcf_name(section, "class").value;
    if (name.empty() || name == "main") {
      read(tree, section, kMain, facts);
    } else if (const auto known = find(name)) {
      read(tree, section, *known, facts);
    } else {
      add(name, kMain);
      read(tree, section, classes_.size() - 1, facts);
    }
  }
}

void MjcfDefaults::read(const MjcfTree& tree, xml::Element element, std::size_t into,
                        MjcfFacts& facts) {
  const std::vector<xml::Element> children = tree.children(element);
  for (const xml::Element child : children) {
    if (child.name() != "default") classes_[into].elements.push_back(child);
  }
  for (const xml::Element child : children) {
    if (child.name() != "default") continue;
    const auto name = mjcf_name(child, "class");
    if (const auto known = find(name.value); known && !name.value.empty()) {
      facts.push_back({MjcfFactKind::kClassRepeated, name.span, {}, name.value});
    }
    if (name.value.empty()) {
      facts.push_back({.kind = MjcfFactKind::kAttributeMissing,
                       .where = name.written ? name.span : child.tag_span(),
                       .name = "default",
                       .detail = "class"});
    }
    add(name.value, into);
    read(tree, child, classes_.size() - 1, facts);
  }
}

std::optional<std::size_t> MjcfDefaults::find(std::string_view name) const {
  const auto found = index_.find(name);
  return found == index_.end() ? std::nullopt : std::optional(found->second);
}

void MjcfDefaults::add(std::string name, std::size_t parent) {
  // No name finds a class without one.
  if (!name.empty()) index_.try_emplace(name, classes_.size());
  classes_.push_back({std::move(name), parent, {}});
}

std::vector<std::string> MjcfDefaults::names() const {
  std::vector<std::string> names;
  for (const Class& one : classes_) names.push_back(one.name);
  return names;
}

MjcfValues MjcfDefaults::values(xml::Element element, std::string_view tag,
                                std::size_t class_id) const {
  return values_of_any(element, {tag}, class_id);
}

MjcfValues MjcfDefaults::values_of_any(xml::Element element,
                                       const std::vector<std::string_view>& tags,
                                       std::size_t class_id) const {
  std::vector<xml::Element> found;
  for (std::size_t at = class_id;; at = classes_[at].parent) {
    const auto& elements = classes_[at].elements;
    for (std::size_t i = elements.size(); i-- > 0;) {
      if (std::find(tags.begin(), tags.end(), elements[i].name()) != tags.end()) {
        found.push_back(elements[i]);
      }
    }
    if (at == kMain) break;
  }
  return {element, std::move(found)};
}

}  // namespace rigor::read
