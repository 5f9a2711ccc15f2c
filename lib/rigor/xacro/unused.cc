// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a file defines and nothing uses. A branch that was not taken may use it: what is mentioned anywhere
// else counts as used.

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include <rigor/xacro/expander.h>

namespace rigor::xacro {
namespace {

bool is_name_byte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Whether a text has a name as a whole word, outside of `left_out`.
bool has_name(std::string_view text, std::string_view name, std::size_t begin = 0,
              std::size_t end = 0) {
  for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
    const std::size_t behind = at + name.size();
    if (at >= begin && behind <= end) continue;
    const bool begins = at == 0 || !is_name_byte(text[at - 1]);
    if (begins && (behind == text.size() || !is_name_byte(text[behind]))) return true;
  }
  return false;
}

bool mentions(const Node& node, std::string_view name, int depth = 0) {
  constexpr int kDeepest = 200;
  if (depth > kDeepest || has_name(node.text, name)) return true;
  for (const NodeAttribute& attribute : node.attributes) {
    if (attribute.name != "params" && has_name(attribute.value, name)) return true;
  }
  for (const Node* child = node.first; child != nullptr; child = child->next) {
    if (mentions(*child, name, depth + 1)) return true;
  }
  return false;
}

}  // namespace

bool Expander::is_mentioned(std::string_view name, Span definition) const {
  return std::any_of(result_.files.begin(), result_.files.end(), [&](const FileUse& file) {
    const bool own = file.source == definition.source;
    return has_name(sources_.bytes(file.source), name, own ? definition.begin : 0,
                    own ? definition.end : 0);
  });
}

void Expander::report_unused() {
  const SourceId own = result_.files.front().source;
  for (const Definition& definition : definitions_) {
    if (definition.used || definition.where.source != own) continue;
    if (!is_mentioned(definition.name, definition.where))
      report(FactKind::kUnusedProperty, {definition.where, true}, std::string(definition.name));
  }
  for (const Macro& macro : macros_) {
    if (macro.body->where.span.source != own) continue;
    // A file of macros alone is for others to call.
    if (!macro.used && result_.root->first_element() != nullptr &&
        !is_mentioned(macro.name, macro.body->where.span)) {
      report(FactKind::kUnusedMacro, macro.body->where, std::string(macro.name));
    }
    for (std::size_t i = 0; i < macro.parameters.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (macro.parameters[i].symbol != macro.parameters[j].symbol) continue;
        report(FactKind::kRepeatedParameter, macro.body->attribute("params")->where,
               std::string(macro.parameters[i].name), std::string(macro.name));
      }
    }
    if (!macro.used) continue;
    for (const MacroParameter& parameter : macro.parameters) {
      std::string_view name = parameter.name;
      while (name.starts_with('*')) name.remove_prefix(1);
      if (!parameter.used && !mentions(*macro.body, name))
        report(FactKind::kUnusedParameter, macro.body->attribute("params")->where,
               std::string(parameter.name), std::string(macro.name));
    }
  }
  report_unused_includes();
  for (const auto& [name, argument] : arguments_) {
    if (argument.used || argument.place.span.source != own) continue;
    if (!is_mentioned(name, argument.declared))
      report(FactKind::kUnusedArgument, argument.place, name);
  }
}

/// What is not used may be used in a branch that was not taken: of its names, none may be mentioned
/// elsewhere either.
void Expander::report_unused_includes() {
  using Id = std::uint32_t;
  std::unordered_set<Id> used;
  const auto use = [&used](Span where) { used.insert(static_cast<Id>(where.source)); };
  const auto is_named_elsewhere = [this](std::string_view name, Span definition) {
    return std::any_of(result_.files.begin(), result_.files.end(), [&](const FileUse& file) {
      return file.source != definition.source && has_name(sources_.bytes(file.source), name);
    });
  };
  for (const Definition& definition : definitions_) {
    if (definition.used) use(definition.where);
  }
  for (const Macro& macro : macros_) {
    if (macro.used) use(macro.body->where.span);
  }
  for (const auto& [name, argument] : arguments_) {
    if (argument.used) use(argument.place.span);
  }
  // Only what brought nothing so far is worth a search.
  const auto is_open = [&used](Span where) {
    return !used.contains(static_cast<Id>(where.source));
  };
  for (const Definition& definition : definitions_) {
    if (is_open(definition.where) && is_named_elsewhere(definition.name, definition.where))
      use(definition.where);
  }
  for (const Macro& macro : macros_) {
    const Span where = macro.body->where.span;
    if (is_open(where) && is_named_elsewhere(macro.name, where)) use(where);
  }
  for (const IncludeUse& include : includes_) {
    const bool is_used =
        std::any_of(include.sources.begin(), include.sources.end(),
                    [&used](SourceId source) { return used.contains(static_cast<Id>(source)); });
    if (!is_used && !include.brings_elements)
      report(FactKind::kUnusedInclude, include.place, shown_path(include.path));
  }
}

}  // namespace rigor::xacro
