// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Calls of macros: which one, its parameters, its body.

#include <algorithm>
#include <utility>

#include <rigor/xacro/expander.h>
#include <rigor/xacro/value/literal.h>
#include <rigor/xacro/value/near.h>
#include <rigor/xacro/value/number_text.h>

namespace rigor::xacro {
namespace {

std::string parameter_near(std::string_view name, const Macro& macro) {
  std::vector<std::string_view> candidates;
  for (const MacroParameter& parameter : macro.parameters) candidates.push_back(parameter.name);
  return nearest_name(name, candidates);
}

/// Whether one of the parameters before has the same name.
bool is_repeated(const Macro& macro, std::size_t index) {
  for (std::size_t i = 0; i < index; ++i) {
    if (macro.parameters[i].symbol == macro.parameters[index].symbol) return true;
  }
  return false;
}

}  // namespace

Macro* Expander::find_macro(std::string_view name, Names& names) {
  if (MacroEntry* entry = names.macros->find(symbols_.of(name))) return entry->macro;
  Names inner = names;
  for (std::size_t dot = name.find('.'); dot != std::string_view::npos; dot = name.find('.')) {
    const Symbol space = symbols_.of(name.substr(0, dot));
    MacroEntry* entry = inner.macros->find(space);
    if (entry == nullptr || entry->name_space == nullptr) return nullptr;
    Binding* values = inner.values->find(space);
    if (values == nullptr || !values->value.is(Type::kNamespace)) return nullptr;
    values->used = true;
    inner = {entry->name_space, values->value.scope_};
    name.remove_prefix(dot + 1);
  }
  MacroEntry* entry = inner.macros->find(symbols_.of(name));
  if (entry == nullptr) return nullptr;
  names = inner;
  return entry->macro;
}

std::string Expander::macro_near(std::string_view name, MacroScope& macros) {
  std::vector<std::string_view> candidates;
  for (MacroScope* scope = &macros; scope != nullptr; scope = scope->parent()) {
    for (const auto& [symbol, entry] : scope->own()) candidates.push_back(symbols_.name(symbol));
  }
  return nearest_name(name, candidates);
}

void Expander::expand_dynamic_call(const Node& node, Names names, Node& out) {
  const NodeAttribute* macro = required(node, "macro");
  if (macro == nullptr) return;
  const auto name = evaluate_text(*macro, names);
  out.is_partial = out.is_partial || !name;
  if (!name) return;
  Node call = node;
  call.attributes.erase("macro");
  // Siblings and children are the node's own.
  expand_call(call, *name, names, out);
}

void Expander::expand_call(const Node& node, std::string_view name, Names names, Node& out) {
  Names own = names;
  Macro* macro = find_macro(name, own);
  if (macro == nullptr) {
    out.is_partial = true;
    if (!incomplete_) {
      report(FactKind::kUndefinedMacro, node.where.part(1, 1 + node.name.size()), std::string(name),
             macro_near(name, *names.macros));
    }
    check_attributes(node, names);
    Node& lost = fragment();
    return expand_children(node, names, lost);
  }
  macro->used = true;
  if (!enter(node)) return;
  Scope* scope = nullptr;
  if (!free_scopes_.empty()) {
    scope = free_scopes_.back();
    free_scopes_.pop_back();
    scope->reset(own.values);
  } else {
    scope = &scopes_.emplace_back(own.values, ScopeKind::kMacro);
  }
  MacroScope* macros = nullptr;
  if (!free_macro_scopes_.empty()) {
    macros = free_macro_scopes_.back();
    free_macro_scopes_.pop_back();
    macros->reset(own.macros);
  } else {
    macros = &macro_scopes_.emplace_back(own.macros);
  }
  std::vector<bool> given(macro->parameters.size(), false);
  bind_attributes(node, *macro, names, *scope, given);
  Node& content = fragment();
  const std::size_t lost = lost_blocks_;
  expand_children(node, names, content);
  bind_blocks(node, *macro, content, *scope, given,
              lost == lost_blocks_ ? Blocks::kAll : Blocks::kSomeLost);
  bind_defaults(node, *macro, names, own, *scope, given);

  const std::uint32_t outer = frame_;
  frame_ = push_call_frame(node, *macro, *scope);
  Node& body = fragment();
  const Names inner{macros, scope};
  for (const NodeAttribute& attribute : macro->body->attributes) {
    if (!attribute.name.starts_with("xmlns:") || attribute.name == "xmlns:xacro") continue;
    body.set_attribute(attribute);
  }
  check_attributes(*macro->body, inner);
  expand_children(*macro->body, inner, body);
  frame_ = outer;
  for (MacroParameter& parameter : macro->parameters) {
    const Binding* binding = scope->own().find(parameter.symbol);
    parameter.used = parameter.used || (binding != nullptr && binding->used);
  }
  if (!name_spaces_made_) {
    free_scopes_.push_back(scope);
    free_macro_scopes_.push_back(macros);
  }
  leave();
  drop_comments_before(node, out);
  place_marker(node, out);
  lift_namespaces(body, out);
  append_content(body, out);
}

void Expander::bind_attributes(const Node& node, const Macro& macro, Names names, Scope& scope,
                               std::vector<bool>& given) {
  unknown_parameter_ = false;
  for (const NodeAttribute& attribute : node.attributes) {
    std::size_t i = 0;
    while (i < given.size() && (given[i] || macro.parameters[i].name != attribute.name)) ++i;
    if (i == given.size()) {
      report(FactKind::kUnknownParameter, attribute.where, std::string(attribute.name),
             std::string(macro.name), macro.body->where.span);
      unknown_parameter_ = true;
      Fact& told = result_.facts.back();
      if (told.kind == FactKind::kUnknownParameter && told.where == attribute.where.span)
        told.near = parameter_near(attribute.name, macro);
      // The body may use it: that it has no such parameter is reported here.
      Binding& lost = scope.own()[symbols_.of(attribute.name)];
      lost.value = Value::error();
      lost.place = attribute.where;
      continue;
    }
    given[i] = true;
    Binding binding;
    binding.place = attribute.where;
    used_ = {};
    const Value value = evaluate(attribute.value, *names.values, attribute.where, attribute.code);
    if (used_ != Span{} && templates_.of(attribute.code, attribute.value).is_reference)
      binding.from = used_;
    bind(scope, macro.parameters[i].symbol, value, binding);
  }
}

void Expander::bind_blocks(const Node& node, const Macro& macro, const Node& content, Scope& scope,
                           std::vector<bool>& given, Blocks blocks) {
  const Node* block = content.first_element();
  for (std::size_t i = 0; i < given.size(); ++i) {
    const MacroParameter& parameter = macro.parameters[i];
    if (given[i] || !parameter.name.starts_with('*')) continue;
    given[i] = true;
    Binding binding;
    binding.place = node.where;
    binding.value = Value::error();
    if (block != nullptr) {
      binding.value = Value::block(*block);
      binding.place = block->where;
      block = block->next_element();
    } else if (blocks == Blocks::kAll) {
      report(FactKind::kMissingBlock, node.where, std::string(parameter.name),
             std::string(macro.name), macro.body->where.span);
    }
    scope.own()[parameter.symbol] = binding;
  }
  if (block != nullptr)
    report(FactKind::kUnusedBlock, block->where, std::string(block->name), std::string(macro.name),
           macro.body->where.span);
}

void Expander::bind_defaults(const Node& node, const Macro& macro, Names caller, Names own,
                             Scope& scope, const std::vector<bool>& given) {
  for (std::size_t i = 0; i < given.size(); ++i) {
    const MacroParameter& parameter = macro.parameters[i];
    if (given[i]) continue;
    Binding binding;
    binding.place = parameter.place;
    Value value = Value::error();
    const std::optional<Value> outer =
        parameter.forwards ? look_up(*caller.values, parameter.symbol) : std::nullopt;
    if (const auto failure = evaluator_.take_failure()) report_failure(*failure, node.where);
    if (outer) {
      value = *outer;
      binding.from = used_;
    } else if (parameter.has_default) {
      used_ = {};
      value = evaluate(parameter.text, *own.values, parameter.place, parameter.code);
      if (!has_no_dollar(parameter.code) &&
          templates_.of(parameter.code, parameter.text).is_reference)
        binding.from = used_;
    } else if (is_repeated(macro, i)) {
      report(FactKind::kBadName, macro.body->attribute("params")->where,
             std::string(parameter.name), "the macro lists it twice, and a call gives it once");
    } else if (!unknown_parameter_ && (!incomplete_ || !parameter.forwards)) {
      // A parameter that is unknown and one that is missing are one misspelling.
      report(FactKind::kMissingParameter, node.where, std::string(parameter.name),
             std::string(macro.name), macro.body->where.span);
    }
    bind(scope, parameter.symbol, value, binding);
  }
}

std::uint32_t Expander::push_call_frame(const Node& node, const Macro& macro, Scope& scope) {
  Frame frame{FactFrame::Kind::kMacro, frame_, node.where.span, macro.name,
              static_cast<std::uint32_t>(result_.frame_parameters.size())};
  for (const MacroParameter& parameter : macro.parameters) {
    const Binding* binding = scope.own().find(parameter.symbol);
    if (binding == nullptr) continue;
    const Value v = binding->value;
    std::string_view text = "…";
    if (v.is_text()) {
      text = v.as_text();
    } else if (const auto number = short_number_text(v)) {
      text = heap_.keep(number->view());
    } else if (v.is_number() || v.is(Type::kNone)) {
      if (const auto printed = evaluator_.text_of(v)) text = heap_.keep(*printed);
      evaluator_.take_failure();  // of a number with too many digits to show
    }
    result_.frame_parameters.push_back({parameter.name, text});
    ++frame.parameter_count;
  }
  return push_frame(std::move(frame));
}

}  // namespace rigor::xacro
