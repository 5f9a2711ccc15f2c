// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/template/stand_ins.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/read/template/argument_sets.h>
#include <rigor/read/template/sibling_arguments.h>
#include <rigor/text/path.h>
#include <rigor/xacro/fact.h>
#include <rigor/xml/document.h>

namespace rigor::read {
namespace {

/// Of the `<xacro:arg name="…" default="…"/>` in one of the files; it may stand behind the argument's use, as behind
/// the robot's name. Nothing where the argument is not declared.
std::optional<std::string> declared_default(const xacro::Expansion& expansion,
                                            const Sources& sources, std::string_view name) {
  for (const xacro::FileUse& file : expansion.files) {
    const xml::Document document = xml::parse_own(sources.bytes(file.source), file.source);
    for (std::uint32_t i = 0; i < document.element_count(); ++i) {
      const xml::Element element = document.element(i);
      if (element.name() != "xacro:arg") continue;
      const auto declared = element.attribute("name");
      const auto value = element.attribute("default");
      if (declared && value && declared->value() == name) return std::string(value->value());
    }
  }
  return std::nullopt;
}

/// Whether an argument that is declared nowhere is only part of the robot's own name: then any text will do. In a
/// link's name it may be a misspelt one.
bool is_only_in_robot_name(const xacro::Expansion& expansion, const Sources& sources,
                           std::string_view argument) {
  const std::string reference = "$(arg " + std::string(argument) + ')';
  std::size_t uses = 0;
  for (const xacro::FileUse& file : expansion.files) {
    const std::string_view bytes = sources.bytes(file.source);
    for (std::size_t at = bytes.find(reference); at != bytes.npos;
         at = bytes.find(reference, at + 1))
      ++uses;
  }
  if (uses != 1 || expansion.files.empty()) return false;
  const SourceId own = expansion.files.front().source;
  const xml::Document document = xml::parse_own(sources.bytes(own), own);
  if (document.element_count() == 0) return false;
  const auto name = document.element(0).attribute("name");
  return name && name->value().find(reference) != std::string_view::npos;
}

/// Whether it is a robot of its own name, and no part that others include.
bool is_robot_of_its_own(const xacro::Expansion& expansion,
                         const std::vector<const xacro::Expansion*>& others,
                         const Sources& sources) {
  if (expansion.root == nullptr || expansion.root->name != "robot" ||
      expansion.root->attribute("name") == nullptr)
    return false;
  const auto path_of = [&sources](const xacro::FileUse& file) {
    return normalize_path(sources.path(file.source));
  };
  const std::string own = path_of(expansion.files.front());
  return std::none_of(others.begin(), others.end(), [&](const xacro::Expansion* other) {
    return std::any_of(other->files.begin(), other->files.end(),
                       [&](const xacro::FileUse& file) { return path_of(file) == own; });
  });
}

}  // namespace

bool lacks_argument(const xacro::Expansion& expansion) {
  return std::any_of(expansion.facts.begin(), expansion.facts.end(), [](const xacro::Fact& fact) {
    return fact.kind == xacro::FactKind::kUndefinedArgument;
  });
}

std::optional<TemplateArguments> stand_ins(
    const xacro::Expansion& expansion, const std::vector<const xacro::Expansion*>& others,
    const Sources& sources, const Disk& disk,
    const std::function<bool(std::size_t number, const TemplateArguments& arguments)>&
        makes_robot) {
  std::map<std::string, std::string> lacking;
  bool all_declared = true;
  for (const xacro::Fact& fact : expansion.facts) {
    if (fact.kind != xacro::FactKind::kUndefinedArgument) continue;
    const auto value = declared_default(expansion, sources, fact.name);
    if (!value && !is_only_in_robot_name(expansion, sources, fact.name)) return std::nullopt;
    all_declared = all_declared && value.has_value();
    // What is composed is not known before it is expanded: the argument's own name will do.
    const bool is_known = value && value->find('$') == std::string::npos;
    lacking.emplace(fact.name, is_known ? *value : fact.name);
  }
  if (lacking.empty()) return std::nullopt;
  if (!all_declared && !is_robot_of_its_own(expansion, others, sources)) return std::nullopt;
  ArgumentPlan plan;
  plan.sets.emplace_back();
  plan = all_arguments(expansion, sources, disk, std::move(plan));
  plan.sets.resize(std::min(plan.sets.size(), kMaxStandIns));
  std::vector<TemplateArguments> siblings = sibling_arguments(expansion, sources, others);
  siblings.resize(std::min(siblings.size(), kMaxStandIns));
  plan.sets.insert(plan.sets.end(), siblings.begin(), siblings.end());
  for (std::size_t i = 0; i < plan.sets.size(); ++i) {
    std::map<std::string, std::string> values = lacking;
    for (const auto& [name, value] : plan.sets[i]) values[name] = value;
    TemplateArguments arguments(values.begin(), values.end());
    if (makes_robot(i, arguments)) return arguments;
  }
  return std::nullopt;
}

}  // namespace rigor::read
