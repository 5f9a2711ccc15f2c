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

}  // namespace

std::optional<TemplateArguments> stand_ins(
    const xacro::Expansion& expansion, const Sources& sources, const Disk& disk,
    const std::function<bool(std::size_t number, const TemplateArguments& arguments)>&
        makes_robot) {
  std::map<std::string, std::string> lacking;
  for (const xacro::Fact& fact : expansion.facts) {
    if (fact.kind != xacro::FactKind::kUndefinedArgument) continue;
    const auto value = declared_default(expansion, sources, fact.name);
    if (!value) return std::nullopt;
    // What is composed is not known before it is expanded: the argument's own name will do.
    lacking.emplace(fact.name, value->find('$') == std::string::npos ? *value : fact.name);
  }
  if (lacking.empty()) return std::nullopt;
  ArgumentPlan plan;
  plan.sets.emplace_back();
  plan = all_arguments(expansion, sources, disk, std::move(plan));
  for (std::size_t i = 0; i < std::min(plan.sets.size(), kMaxStandIns); ++i) {
    std::map<std::string, std::string> values = lacking;
    for (const auto& [name, value] : plan.sets[i]) values[name] = value;
    TemplateArguments arguments(values.begin(), values.end());
    if (makes_robot(i, arguments)) return arguments;
  }
  return std::nullopt;
}

}  // namespace rigor::read
