// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Texts with expressions and commands in them, and the values of names.

#include <algorithm>
#include <span>
#include <utility>

#include <rigor/text/path.h>
#include <rigor/xacro/builtins.h>
#include <rigor/xacro/expander.h>
#include <rigor/xacro/value/literal.h>
#include <rigor/xacro/value/near.h>
#include <rigor/xacro/value/number_text.h>
#include <rigor/xacro/value/unicode.h>
#include <rigor/xacro/yaml.h>

namespace rigor::xacro {
namespace {

bool has_no_code(std::string_view text, TextCode code) {
  return has_no_dollar(code) ||
         (code == TextCode::kUnknown && text.find('$') == std::string_view::npos);
}

}  // namespace

Value Expander::evaluate(std::string_view text, Scope& scope, Place place, TextCode code) {
  if (has_no_code(text, code)) return Value::text(text);
  const TextTemplate& parts = templates_.of(code, text);
  if (parts.segments.size() != 1 || parts.trouble)
    return evaluate_joined(parts, text, scope, place);
  const Value v = evaluate_segment(parts.segments[0], scope, place);
  if (const auto failure = evaluator_.take_failure()) report_failure(*failure, place);
  return v;
}

Value Expander::evaluate_joined(const TextTemplate& parts, std::string_view text, Scope& scope,
                                Place place) {
  bool whole = true;
  const std::size_t begin = joined_.size();
  const std::size_t first_origin = joined_origins_.size();
  for (const TextSegment& segment : parts.segments) {
    used_ = {};
    const Value v = evaluate_segment(segment, scope, place);
    std::optional<std::string> printed;
    if (v.is_text()) {
      joined_ += v.as_text();
    } else if (const auto number = short_number_text(v)) {
      joined_ += number->view();
    } else if (!v.failed() && (printed = evaluator_.text_of(v))) {
      joined_ += *printed;
    } else {
      if (const auto failure = evaluator_.take_failure()) report_failure(*failure, place);
      whole = false;
      continue;
    }
    if (segment.kind != TextSegment::Kind::kText && !used_.nowhere()) {
      joined_origins_.push_back(
          {segment.begin, segment.begin + static_cast<std::uint32_t>(segment.text.size()), used_});
    }
  }
  // Of one part only it can be said of the whole.
  const std::size_t origins = joined_origins_.size() - first_origin;
  used_ = origins == 1 ? joined_origins_.back().from : Span{};
  if (parts.trouble) {
    report(FactKind::kBadText, place.part(*parts.trouble, *parts.trouble + 2),
           std::string(text.substr(*parts.trouble, 40)));
    whole = false;
  }
  const Value result =
      whole ? evaluator_.text(std::string_view(joined_).substr(begin)) : Value::error();
  if (const auto failure = evaluator_.take_failure()) report_failure(*failure, place);
  if (origins > 1 && result.is_text())
    result_.part_origins.add(result.as_text(), std::span(joined_origins_).subspan(first_origin));
  joined_.resize(begin);
  joined_origins_.resize(first_origin);
  return result;
}

Value Expander::evaluate_segment(const TextSegment& segment, Scope& scope, Place place) {
  if (segment.kind == TextSegment::Kind::kText) return Value::text(segment.text);
  const std::size_t begin = segment.begin + segment.skipped;
  if (segment.expression != nullptr) {
    const std::string_view text = segment.expression->text;
    return evaluate_expression(text, *segment.expression, scope,
                               place.part(begin, begin + text.size()));
  }
  const Place inside = place.part(segment.begin, segment.begin + segment.text.size());
  if (segment.kind == TextSegment::Kind::kCommand) return run_command(segment.text, scope, inside);
  const auto text = evaluate_text(segment.text, scope, inside);
  if (!text) return Value::error();
  const std::string_view expression = stripped(*text);
  return evaluate_expression(expression, templates_.expression(expression), scope,
                             {inside.span, false});
}

Value Expander::evaluate_expression(std::string_view, const Expression& expression, Scope& scope,
                                    Place place) {
  const Span outer = std::exchange(reader_, place.span);
  const Value v = evaluator_.evaluate(expression, scope);
  reader_ = outer;
  if (expression.degrees != kNoNode) report_degrees(expression, scope, place);
  if (const auto failure = evaluator_.take_failure()) {
    for (const ExpressionNode& node : expression.nodes) {
      if (node.op != Op::kName) continue;
      const Binding* binding = scope.find(node.symbol);
      if (binding == nullptr || !binding->value.is_text()) continue;
      text_in_use_ = binding->from.nowhere() ? binding->place.span : binding->from;
      break;
    }
    report_failure(*failure,
                   place.part(failure->begin, std::max(failure->end, failure->begin + 1)));
    return Value::error();
  }
  return v;
}

std::optional<std::string_view> Expander::evaluate_text(std::string_view text, Scope& scope,
                                                        Place place, TextCode code) {
  if (has_no_code(text, code)) return text;
  const Value v = evaluate(text, scope, place, code);
  if (v.failed()) return std::nullopt;
  if (v.is_text()) return v.as_text();
  if (const auto number = short_number_text(v)) return heap_.keep(number->view());
  const auto printed = evaluator_.text_of(v);
  if (const auto failure = evaluator_.take_failure()) report_failure(*failure, place);
  if (!printed) return std::nullopt;
  return heap_.keep(*printed);
}

std::optional<bool> Expander::evaluate_condition(const NodeAttribute& attribute, Names names) {
  used_ = {};
  const Value v = evaluate(attribute.value, *names.values, attribute.where, attribute.code);
  if (v.failed() || (v.is_text() && needs_missing_package(v.as_text()))) return std::nullopt;
  const std::optional<bool> is = boolean_value(heap_, v);
  if (!is)
    report(FactKind::kNotBoolean, attribute.where,
           std::string(v.is_text() ? v.as_text() : std::string_view{}), {}, used_);
  return is;
}

std::optional<Value> Expander::look_up(Scope& scope, Symbol name) {
  Scope* home = nullptr;
  if (Binding* binding = scope.find(name, &home)) {
    binding->used = true;
    if (binding->definition != kNoDefinition) definitions_[binding->definition].used = true;
    return resolve(*binding, name, *home);
  }
  if (const Value v = builtin(name); !v.failed()) {
    if (v.is(Type::kFunction)) {
      const std::string_view function = v.function_->name;
      const bool python = function == "sorted" || function == "range";
      if (python || function == "load_yaml" || function == "abs_filename" || function == "dotify") {
        report(FactKind::kDeprecatedFunction, {reader_, false}, std::string(function),
               python ? "python" : "xacro");
      }
    }
    return v;
  }
  // Names may be in a file that is missing, which has been reported.
  if (incomplete_) return Value::error();
  return std::nullopt;
}

Value Expander::resolve(Binding& binding, Symbol name, Scope& scope) {
  if (binding.lazy) {
    if (binding.resolving || resolving_.size() >= kMaxLazyDepth) {
      std::string cycle;
      const auto first = std::find(resolving_.begin(), resolving_.end(), symbols_.name(name));
      for (auto it = first; it != resolving_.end(); ++it) cycle += std::string(*it) + " -> ";
      if (binding.resolving)
        return evaluator_.fail(FactKind::kCycle, std::string(symbols_.name(name)),
                               cycle + std::string(symbols_.name(name)));
      return evaluator_.fail(FactKind::kBoundReached, {},
                             "the number of properties that need each other");
    }
    binding.resolving = true;
    resolving_.push_back(symbols_.name(name));
    const std::string_view text = binding.value.as_text();
    used_ = {};
    const Value v = literal_value(heap_, evaluate(text, scope, binding.place, binding.code));
    if (used_ != Span{} && templates_.of(binding.code, text).is_reference) binding.from = used_;
    resolving_.pop_back();
    binding.resolving = false;
    binding.lazy = false;
    binding.value = v;
  }
  used_ = binding.from.nowhere() ? binding.place.span : binding.from;
  return binding.value;
}

Value Expander::load_yaml(std::string_view written) {
  if (needs_missing_package(written)) return Value::error();
  const std::string path = absolute_path(written);
  const auto known = yaml_.find(path);
  if (known != yaml_.end()) {
    if (known->second.loading) return evaluator_.fail(FactKind::kIncludeCycle, path);
    return known->second.value.failed() ? Value::error() : heap_.wrapped(known->second.value);
  }
  report_if_outside(path, {reader_, false});
  Yaml& file = yaml_[path];
  file.value = Value::error();
  std::string found = path;
  ReadResult read = read_file(found);
  if (is_model_data(found)) read = {std::nullopt, "its name is not that of a YAML file"};
  if (!read.bytes) return evaluator_.fail(FactKind::kFileNotFound, shown_path(path), read.problem);
  file.source = sources_.add(shown_path(found), std::move(*read.bytes));
  result_.files.push_back({found, file.source});
  heap_.charge(sources_.bytes(file.source).size());
  file.loading = true;
  Scope empty(nullptr, ScopeKind::kFile);
  const YamlResult result = read_yaml(
      sources_.bytes(file.source), file.source, heap_, [&](std::string_view text, Span where) {
        const std::string_view expression = stripped(text);
        return evaluate_expression(expression, templates_.expression(expression), empty,
                                   {where, where.size() == expression.size()});
      });
  file.loading = false;
  if (result.trouble) {
    const bool is_value = result.trouble->kind == FactKind::kWrongValue;
    report(result.trouble->kind, {result.trouble->where, true},
           is_value ? result.trouble->detail : path, result.trouble->detail, reader_);
    return Value::error();
  }
  file.value = result.value;
  return heap_.wrapped(file.value);
}

std::optional<std::string_view> Expander::argument(std::string_view name) {
  const auto found = arguments_.find(name);
  if (found == arguments_.end()) return std::nullopt;
  found->second.used = true;
  used_ = found->second.place.span;
  return found->second.value;
}

void Expander::message(std::string_view function, std::string text) {
  report(FactKind::kMessage, {reader_, false}, std::string(function), std::move(text));
}

std::string Expander::name_near(Scope& scope, std::string_view name) {
  std::vector<std::string_view> candidates;
  for (Scope* at = &scope; at != nullptr; at = at->parent()) {
    for (const auto& [symbol, binding] : at->own()) candidates.push_back(symbols_.name(symbol));
  }
  const std::vector<std::string_view> builtins = global_builtin_names();
  candidates.insert(candidates.end(), builtins.begin(), builtins.end());
  // Thousands of names may be undefined, each in a thousand scopes.
  if (!evaluator_.work(candidates.size())) return {};
  std::sort(candidates.begin(), candidates.end());
  return nearest_name(name, candidates);
}

}  // namespace rigor::xacro
