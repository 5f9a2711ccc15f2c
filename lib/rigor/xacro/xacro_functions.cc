// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The module `xacro` of the expression language.

#include <utility>

#include <rigor/xacro/expression/evaluator.h>
#include <rigor/xacro/expression/function.h>
#include <rigor/xacro/value/compare.h>

namespace rigor::xacro {
namespace {

std::optional<std::string> joined_texts(Evaluator& e, const Arguments& a) {
  std::string text;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const auto part = e.text_of(a.values[i]);
    if (!part) return std::nullopt;
    if (i > 0) text += ' ';
    text += *part;
  }
  return text;
}

Value say(Evaluator& e, std::string_view function, const Arguments& a) {
  auto text = joined_texts(e, a);
  if (!text) return Value::error();
  e.host().message(function, std::move(*text));
  return Value::text({});
}

Value xacro_message(Evaluator& e, Value, Arguments& a) { return say(e, "message", a); }
Value xacro_warning(Evaluator& e, Value, Arguments& a) { return say(e, "warning", a); }
Value xacro_error(Evaluator& e, Value, Arguments& a) { return say(e, "error", a); }
Value xacro_print_location(Evaluator&, Value, Arguments&) { return Value::text({}); }

Value xacro_fatal(Evaluator& e, Value, Arguments& a) {
  const auto text = joined_texts(e, a);
  return text ? e.fail(FactKind::kFatal, {}, *text) : Value::error();
}

Value xacro_load_yaml(Evaluator& e, Value, Arguments& a) {
  const Value path = a.get(0, a.find("filename").value_or(Value::none()));
  if (!path.is_text())
    return e.wrong_type("load_yaml() takes a path, not " + std::string(type_name(path)));
  return e.host().load_yaml(path.as_text());
}

Value xacro_abs_filename(Evaluator& e, Value, Arguments& a) {
  if (!a.values[0].is_text())
    return e.wrong_type("abs_filename() takes a path, not " + std::string(type_name(a.values[0])));
  return e.text(e.host().absolute_path(a.values[0].as_text()));
}

Value xacro_dotify(Evaluator& e, Value, Arguments& a) {
  const Value made = e.call(Value::function(class_named("dict"), Type::kClass), a.values);
  return made.failed() ? made : e.heap().wrapped(made);
}

Value xacro_arg(Evaluator& e, Value, Arguments& a) {
  if (!a.values[0].is_text())
    return e.wrong_type("arg() takes a name, not " + std::string(type_name(a.values[0])));
  if (const auto value = e.host().argument(a.values[0].as_text())) return e.text(*value);
  return e.fail(FactKind::kUndefinedArgument, std::string(a.values[0].as_text()));
}

/// Splits at each of the characters in `sep`, which are those of a regular expression's `[…]`.
Value xacro_tokenize(Evaluator& e, Value, Arguments& a) {
  const Value separators = a.find("sep").value_or(a.get(1, Value::text(",; ")));
  const bool skip = is_true(a.find("skip_empty").value_or(a.get(2, Value::boolean(true))));
  if (!a.values[0].is_text() || !separators.is_text())
    return e.wrong_type("tokenize() takes texts");
  const std::string_view by = separators.as_text();
  if (by.empty() || by.find_first_of("\\]^[-") != std::string_view::npos) {
    return e.fail(FactKind::kOutsideLanguage, {},
                  "separators with a meaning in regular expressions");
  }
  std::vector<Value> tokens;
  std::string_view rest = a.values[0].as_text();
  if (!e.fits(rest.size() / 2)) return Value::error();
  while (true) {
    const std::size_t end = std::min(rest.find_first_of(by), rest.size());
    if (end > 0 || !skip) tokens.push_back(Value::text(rest.substr(0, end)));
    if (end == rest.size()) break;
    rest.remove_prefix(end + 1);
  }
  return e.list(std::move(tokens));
}

constexpr Function kXacroFunctions[] = {{"abs_filename", xacro_abs_filename, 1, 1},
                                        {"arg", xacro_arg, 1, 1},
                                        {"dotify", xacro_dotify, 0, 1},
                                        {"error", xacro_error, 0, kAnyCount, "*"},
                                        {"fatal", xacro_fatal, 0, kAnyCount},
                                        {"load_yaml", xacro_load_yaml, 1, 1, "filename"},
                                        {"message", xacro_message, 0, kAnyCount, "*"},
                                        {"print_location", xacro_print_location, 0, kAnyCount, "*"},
                                        {"tokenize", xacro_tokenize, 1, 3, "sep skip_empty"},
                                        {"warning", xacro_warning, 0, kAnyCount, "*"}};

}  // namespace

const Module kXacroModule{"xacro", {}, kXacroFunctions, {}};

}  // namespace rigor::xacro
