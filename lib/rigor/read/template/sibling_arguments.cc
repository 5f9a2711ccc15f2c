// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/template/sibling_arguments.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/xacro/fact.h>
#include <rigor/xml/document.h>

namespace rigor::read {
namespace {

/// Arguments by the names of the parameters that they are handed to.
using HandedArguments = std::map<std::string, std::string, std::less<>>;

/// Parameters that the files hand an argument to, if it has no default but an empty one.
HandedArguments handed_arguments(const xacro::Expansion& expansion, const Sources& sources) {
  constexpr std::string_view kReference = "$(arg ";
  std::set<std::string, std::less<>> with_default;
  HandedArguments handed;
  for (const xacro::FileUse& file : expansion.files) {
    const xml::Document document = xml::parse_own(sources.bytes(file.source), file.source);
    for (std::uint32_t i = 0; i < document.element_count(); ++i) {
      const xml::Element element = document.element(i);
      if (!element.name().starts_with(xacro::kTagPrefix)) continue;
      const auto name = element.attribute("name");
      const auto value = element.attribute("default");
      if (element.name() == "xacro:arg" && name && value && !value->value().empty())
        with_default.emplace(name->value());
      if (xacro::tag_of(element.name()) != xacro::Tag::kCall) continue;
      for (const xml::Attribute attribute : element.attributes()) {
        const std::string_view text = attribute.value();
        if (!text.starts_with(kReference) || text.find(')') != text.size() - 1) continue;
        handed.try_emplace(std::string(attribute.name()),
                           text.substr(kReference.size(), text.size() - kReference.size() - 1));
      }
    }
  }
  std::erase_if(handed, [&](const auto& pair) { return with_default.contains(pair.second); });
  return handed;
}

std::span<const xacro::FrameParameter> parameters_of(const xacro::Expansion& expansion,
                                                     const xacro::Frame& call) {
  return std::span(expansion.frame_parameters).subspan(call.parameters, call.parameter_count);
}

/// The macros that the expansion called with nothing for one of the parameters.
std::set<std::string_view> macros_without(const xacro::Expansion& expansion,
                                          const HandedArguments& handed) {
  std::set<std::string_view> macros;
  for (const xacro::Frame& frame : expansion.frames) {
    if (frame.kind != xacro::FactFrame::Kind::kMacro) continue;
    for (const auto& [name, value] : parameters_of(expansion, frame)) {
      if (value.empty() && handed.find(name) != handed.end()) macros.insert(frame.name);
    }
  }
  return macros;
}

}  // namespace

std::vector<TemplateArguments> sibling_arguments(
    const xacro::Expansion& expansion, const Sources& sources,
    const std::vector<const xacro::Expansion*>& others) {
  const HandedArguments handed = handed_arguments(expansion, sources);
  const std::set<std::string_view> macros = macros_without(expansion, handed);
  std::vector<TemplateArguments> sets;
  if (macros.empty()) return sets;
  for (const xacro::Expansion* other : others) {
    for (const xacro::Frame& frame : other->frames) {
      if (frame.kind != xacro::FactFrame::Kind::kMacro || !macros.contains(frame.name)) continue;
      std::map<std::string, std::string> values;
      for (const auto& [name, value] : parameters_of(*other, frame)) {
        const auto argument = handed.find(name);
        if (argument != handed.end() && !value.empty()) values.emplace(argument->second, value);
      }
      TemplateArguments set(values.begin(), values.end());
      const bool is_new = std::find(sets.begin(), sets.end(), set) == sets.end();
      if (!set.empty() && is_new) sets.push_back(std::move(set));
    }
  }
  return sets;
}

}  // namespace rigor::read
