// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/hardware_names.h>

#include <set>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

bool is_hardware(std::string_view element) {
  return element == "ros2_control" || element == "transmission" || element == "actuator" ||
         element == "sensor" || element == "gpio";
}

/// An element and the hardware in it.
void collect_hardware(xml::Element element, std::vector<xml::Element>& found) {
  if (element.attribute("name")) found.push_back(element);
  for (const xml::Element child : element.children()) {
    if (is_hardware(child.name())) collect_hardware(child, found);
  }
}

std::vector<xml::Element> hardware_of(const EditedModel& edited) {
  std::vector<xml::Element> found;
  for (const xml::Element child : edited.element(edited.root()[edited.model].site).children()) {
    if (child.name() == "ros2_control" || child.name() == "transmission")
      collect_hardware(child, found);
  }
  return found;
}

using HardwareName = std::pair<std::string, std::string>;  ///< kind and name

HardwareName name_of_hardware(xml::Element element) {
  return {std::string(element.name()), std::string(element.attribute("name")->value())};
}

}  // namespace

std::vector<Edit> renamed_hardware(const EditedModel& model, const EditedModel& part,
                                   const HardwarePrefixes& prefixes,
                                   std::vector<std::string>& notes) {
  std::set<HardwareName> taken;
  for (const xml::Element element : hardware_of(model)) taken.insert(name_of_hardware(element));
  std::vector<Edit> edits;
  for (const xml::Element element : hardware_of(part)) {
    const auto [kind, name] = name_of_hardware(element);
    const std::string& prefix = !prefixes.all.empty()          ? prefixes.all
                                : taken.contains({kind, name}) ? prefixes.taken
                                                               : prefixes.all;
    if (prefix.empty()) continue;
    edits.push_back({element.attribute("name")->value_span(), xml::escaped(prefix + name)});
    notes.push_back(fmt::format("{} {} is {} in the copy", kind, name, prefix + name));
  }
  return edits;
}

}  // namespace rigor::author
