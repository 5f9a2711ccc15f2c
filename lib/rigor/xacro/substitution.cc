// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `$(find NAME)`, `$(arg NAME)`, `$(env NAME)`, `$(optenv NAME default)`, `$(dirname)`, `$(cwd)` and
// `$(eval …)`, as roslaunch had them.

#include <algorithm>
#include <utility>
#include <vector>

#include <rigor/text/letter_case.h>
#include <rigor/text/path.h>
#include <rigor/xacro/expander.h>
#include <rigor/xacro/value/near.h>
#include <rigor/xacro/value/number_text.h>
#include <rigor/xacro/value/unicode.h>

namespace rigor::xacro {
namespace {

/// A command's words; only blanks part them.
std::vector<std::string_view> words_of(std::string_view command) {
  std::vector<std::string_view> words;
  while (!command.empty()) {
    const std::size_t end = std::min(command.find(' '), command.size());
    if (end > 0) words.push_back(command.substr(0, end));
    command.remove_prefix(std::min(end + 1, command.size()));
  }
  return words;
}

std::string_view first_word(std::string_view command) {
  command.remove_prefix(std::min(command.find_first_not_of(' '), command.size()));
  return command.substr(0, command.find(' '));
}

bool is_known_command(std::string_view name) {
  return name == "find" || name == "env" || name == "optenv" || name == "dirname" || name == "arg";
}

/// What `$(eval …)` makes of an argument's text.
Value automatic_value(Heap& heap, std::string_view text) {
  if (text.find('.') == std::string_view::npos) {
    if (const Value whole = integer_from_text(heap, text); !whole.failed()) return whole;
  } else if (const auto real = real_from_text(text)) {
    return Value::real(*real);
  }
  const std::string low = lowered(text);
  if (low == "true" || low == "false") return Value::boolean(low == "true");
  return Value::text(text);
}

}  // namespace

Value Expander::run_command(std::string_view written, Scope& scope, Place place) {
  const auto command = evaluate_text(written, scope, place);
  if (!command) return Value::error();
  if (*command == "cwd") return evaluator_.text(world_.working_folder);
  if (command->starts_with("eval ")) return evaluate_eval(command->substr(5), place);
  if (command->starts_with("arg ") && is_identifier(command->substr(4))) {
    const auto value = argument(command->substr(4));
    if (value && value->find('$') == std::string_view::npos) return Value::text(*value);
  }
  const auto once = command->find_first_of("$()") == std::string_view::npos && !command->empty()
                        ? command_value(*command, place)
                        : substitute("$(" + std::string(*command) + ')', false, place);
  if (!once) return Value::error();
  // What an argument brought may hold a `$(find …)` of its own.
  const auto twice = once->find('$') == std::string::npos ? once : substitute(*once, true, place);
  return twice ? evaluator_.text(*twice) : Value::error();
}

std::optional<std::string> Expander::substitute(std::string_view text, bool only_find,
                                                Place place) {
  std::string result(text);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find('$', at);
    if (open == std::string_view::npos) break;
    at = open + 1;
    while (at < text.size() && text[at] == '$') ++at;
    if (at >= text.size() || text[at] != '(') continue;
    const std::size_t begin = ++at;
    const std::size_t close = text.find(')', begin);
    if (close == std::string_view::npos) break;
    at = close + 1;
    const std::string_view command = text.substr(begin, close - begin);
    if (command.empty()) continue;
    if (command.find_first_of("$(") != std::string_view::npos) {
      report(FactKind::kBadCommand, place, std::string(command), "$ and ( cannot be in a command");
      return std::nullopt;
    }
    if (only_find && first_word(command) != "find") {
      if (is_known_command(first_word(command))) continue;
    }
    const auto value = command_value(command, place);
    if (!value) return std::nullopt;
    const std::string whole = "$(" + std::string(command) + ')';
    for (std::size_t found = result.find(whole); found != std::string::npos;
         found = result.find(whole, found + value->size())) {
      result.replace(found, whole.size(), *value);
      if (result.size() > options_.bounds.text_bytes) {
        report(FactKind::kBoundReached, place, {}, "the length of a text");
        return std::nullopt;
      }
    }
  }
  return result;
}

std::optional<std::string> Expander::command_value(std::string_view command, Place place) {
  const std::string_view name = first_word(command);
  if (!is_known_command(name)) {
    report(FactKind::kUnknownCommand, place, std::string(name));
    return std::nullopt;
  }
  return substitution_of(name, command.substr(command.find(name) + name.size()), place);
}

std::optional<std::string> Expander::substitution_of(std::string_view command,
                                                     std::string_view rest, Place place) {
  const std::vector<std::string_view> words = words_of(rest);
  const auto refuse = [&](FactKind kind, std::string name, std::string detail = {}) {
    report(kind, place, std::move(name), std::move(detail));
    return std::nullopt;
  };
  if (command == "dirname") {
    // The reference has no file's name here, whatever the file.
    return refuse(
        FactKind::kBadCommand, "dirname",
        "xacro gives it no file name: use a path relative to the file, or xacro.abs_filename('')");
  }
  if (words.size() != 1 && !(command == "optenv" && !words.empty())) {
    return refuse(FactKind::kBadCommand, std::string(command),
                  "$(" + std::string(command) + " …) takes one name");
  }
  const std::string name(words[0]);
  if (command == "arg") {
    if (const auto value = argument(name)) return std::string(*value);
    // A file that is missing, which has been reported, may declare it.
    if (lacks_files_) return std::nullopt;
    std::vector<std::string_view> candidates;
    for (const auto& [key, value] : arguments_) candidates.push_back(key);
    return refuse(FactKind::kUndefinedArgument, name, nearest_name(name, candidates));
  }
  if (command == "find") {
    auto folder =
        world_.find_package ? world_.find_package(name, file_stack_.back()) : std::nullopt;
    if (folder) return folder;
    report(FactKind::kPackageUnresolved, place, name);
    unresolved_.insert(name);
    return std::string(kPackageScheme) + name;
  }
  auto value = world_.variable ? world_.variable(name) : std::nullopt;
  if (value) return value;
  if (command == "env") return refuse(FactKind::kUndefinedVariable, name);
  std::string otherwise;
  for (std::size_t i = 1; i < words.size(); ++i)
    otherwise += (i > 1 ? " " : "") + std::string(words[i]);
  return otherwise;
}

Value Expander::evaluate_eval(std::string_view text, Place place) {
  if (text.find("__") != std::string_view::npos) {
    report(FactKind::kOutsideLanguage, place, {}, "a double underscore");
    return Value::error();
  }
  // Its names are the arguments, and Python's own.
  Scope scope(nullptr, ScopeKind::kFile);
  for (const auto& [name, argument] : arguments_) {
    if (is_identifier(name))
      scope.own()[symbols_.of(name)].value = automatic_value(heap_, argument.value);
  }
  for (const std::string_view name : {"true", "false"})
    scope.own()[symbols_.of(name)].value = Value::boolean(name == "true");
  for (const Function& function : kPythonModule.functions) {
    const Symbol symbol = symbols_.of(function.name);
    if (builtin(symbol).failed()) scope.own()[symbol].value = Value::function(function);
  }
  const Value v = evaluate_expression(text, templates_.expression(heap_.keep(stripped(text))),
                                      scope, {place.span, false});
  for (const auto& [symbol, binding] : scope.own()) {
    const auto found = arguments_.find(symbols_.name(symbol));
    if (found != arguments_.end()) found->second.used = found->second.used || binding.used;
  }
  if (v.failed()) return v;
  const auto printed = evaluator_.text_of(v);
  if (const auto failure = evaluator_.take_failure()) report_failure(*failure, place);
  return printed ? evaluator_.text(*printed) : Value::error();
}

}  // namespace rigor::xacro
