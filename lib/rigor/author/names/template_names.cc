// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/template_names.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <rigor/xacro/expression/lexer.h>
#include <rigor/xacro/scope.h>

namespace rigor::author {
namespace {

constexpr std::string_view kTagPrefix = "xacro:";
constexpr std::string_view kArgumentCommand = "arg ";

/// Tags of the language itself; others with the prefix are calls.
constexpr std::string_view kTags[] = {"macro",  "property", "arg",          "include", "if",
                                      "unless", "call",     "insert_block", "element", "attribute"};

bool is_call(std::string_view name) {
  if (!name.starts_with(kTagPrefix)) return false;
  name.remove_prefix(kTagPrefix.size());
  return std::find(std::begin(kTags), std::end(kTags), name) == std::end(kTags);
}

/// The bracket that closes an expression which begins behind `begin`; quotes hold any.
std::size_t end_of_expression(std::string_view text, std::size_t begin, char close) {
  const char open = close == '}' ? '{' : '(';
  char quote = '\0';
  int depth = 1;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '\'' || c == '"') {
      quote = c;
    } else if (c == open) {
      ++depth;
    } else if (c == close && --depth == 0) {
      return i;
    }
  }
  return std::string_view::npos;
}

class TemplateNameCollector {
 public:
  explicit TemplateNameCollector(const xml::Document& document) : document_(document) {}

  std::vector<TemplateName> collect() && {
    if (const auto root = document_.root()) visit(*root, nullptr);
    std::stable_sort(
        names_.begin(), names_.end(),
        [](const TemplateName& a, const TemplateName& b) { return a.where.begin < b.where.begin; });
    return std::move(names_);
  }

 private:
  struct MacroAround {
    std::string name;
    std::set<std::string, std::less<>> parameters;
    const MacroAround* outer = nullptr;
  };

  Span sub(Span span, std::size_t begin, std::size_t end) const {
    return {span.source, span.begin + static_cast<std::uint32_t>(begin),
            span.begin + static_cast<std::uint32_t>(end)};
  }
  std::string text(Span span) const {
    return std::string(document_.bytes().substr(span.begin, span.size()));
  }

  TemplateName& add(TemplateNameKind kind, Span where, xml::Element element,
                    std::string owner = {}) {
    TemplateName name;
    name.kind = kind;
    name.owner = std::move(owner);
    name.name = text(where);
    name.where = where;
    name.element = element.span();
    names_.push_back(std::move(name));
    return names_.back();
  }

  void define(TemplateNameKind kind, xml::Element element) {
    const auto name = element.attribute("name");
    if (!name || !name->verbatim() || name->value().empty()) return;
    Span where = name->value_span();
    // Older files write the prefix in the name.
    if (kind == TemplateNameKind::kMacro && name->value().starts_with(kTagPrefix))
      where = sub(where, kTagPrefix.size(), where.size());
    if (text(where).find('$') == std::string::npos) add(kind, where, element).defines = true;
  }

  MacroAround macro(xml::Element element, const MacroAround* outer) {
    MacroAround around;
    around.outer = outer;
    if (const auto name = element.attribute("name")) around.name = name->value();
    if (around.name.starts_with(kTagPrefix)) around.name.erase(0, kTagPrefix.size());
    const auto params = element.attribute("params");
    if (!params || !params->verbatim()) return around;
    xacro::Symbols symbols;
    const std::string_view value = params->value();
    for (const xacro::MacroParameter& each :
         xacro::parse_parameters(value, {params->value_span()}, symbols)) {
      std::string_view name = each.name;
      if (name.data() < value.data() || name.data() >= value.data() + value.size()) continue;
      while (name.starts_with('*')) name.remove_prefix(1);
      const auto begin = static_cast<std::size_t>(name.data() - value.data());
      around.parameters.emplace(name);
      TemplateName& parameter =
          add(TemplateNameKind::kParameter, sub(params->value_span(), begin, begin + name.size()),
              element, around.name);
      parameter.defines = true;
      parameter.is_block = each.name.starts_with('*');
    }
    return around;
  }

  void call(xml::Element element) {
    const Span tag = element.name_span();
    TemplateName& name =
        add(TemplateNameKind::kMacro, sub(tag, kTagPrefix.size(), tag.size()), element);
    const std::string macro = name.name;
    const std::string_view whole =
        document_.bytes().substr(element.span().begin, element.span().size());
    const std::size_t end_tag = whole.rfind("</");
    if (!element.cut() && end_tag != std::string_view::npos &&
        element.span().end != element.tag_span().end) {
      const std::size_t begin = end_tag + 2 + kTagPrefix.size();
      name.also = sub(element.span(), begin, begin + macro.size());
    }
    for (const xml::Attribute attribute : element.attributes()) {
      if (attribute.name().find(':') == std::string_view::npos)
        add(TemplateNameKind::kParameter, attribute.name_span(), element, macro);
    }
  }

  void visit(xml::Element element, const MacroAround* around) {
    const std::string_view name = element.name();
    if (name == "xacro:property") define(TemplateNameKind::kProperty, element);
    if (name == "xacro:arg") define(TemplateNameKind::kArgument, element);
    if (name == "xacro:macro") define(TemplateNameKind::kMacro, element);
    if (name == "xacro:insert_block") insert_block(element, around);
    if (is_call(name)) call(element);
    MacroAround inner;
    if (name == "xacro:macro") {
      inner = macro(element, around);
      around = &inner;
    }
    for (const xml::Attribute attribute : element.attributes()) {
      if (attribute.verbatim())
        expressions(attribute.value(), attribute.value_span(), element, around);
    }
    if (element.text_verbatim()) expressions(element.text(), element.text_span(), element, around);
    for (const xml::Element child : element.children()) visit(child, around);
  }

  void insert_block(xml::Element element, const MacroAround* around) {
    const auto name = element.attribute("name");
    if (name && name->verbatim()) refer(name->value_span(), element, around);
  }

  void refer(Span where, xml::Element element, const MacroAround* around) {
    const std::string name = text(where);
    for (; around != nullptr; around = around->outer) {
      if (!around->parameters.contains(name)) continue;
      add(TemplateNameKind::kParameter, where, element, around->name);
      return;
    }
    add(TemplateNameKind::kProperty, where, element);
  }

  void expressions(std::string_view value, Span span, xml::Element element,
                   const MacroAround* around) {
    for (std::size_t at = value.find('$'); at != std::string_view::npos; at = value.find('$', at)) {
      const char next = at + 1 < value.size() ? value[at + 1] : '\0';
      if (next == '$') {
        at += 2;
        continue;
      }
      if (next != '{' && next != '(') {
        ++at;
        continue;
      }
      const std::size_t begin = at + 2;
      const std::size_t end = end_of_expression(value, begin, next == '{' ? '}' : ')');
      if (end == std::string_view::npos) return;
      const std::string_view inside = value.substr(begin, end - begin);
      if (next == '{') {
        names_in(inside, sub(span, begin, end), element, around);
      } else if (inside.starts_with(kArgumentCommand)) {
        const std::size_t name = inside.find_first_not_of(' ', kArgumentCommand.size());
        if (name != std::string_view::npos)
          add(TemplateNameKind::kArgument,
              sub(span, begin + name, begin + inside.find_last_not_of(' ') + 1), element);
      }
      at = end;
    }
  }

  /// Substitutions within an expression are made before it is evaluated; to the lexer they are a number.
  void names_in(std::string_view written, Span span, xml::Element element,
                const MacroAround* around) {
    std::string expression(written);
    for (std::size_t at = written.find("$("); at != std::string_view::npos;
         at = written.find("$(", at)) {
      const std::size_t end = end_of_expression(written, at + 2, ')');
      if (end == std::string_view::npos) return;
      expressions(written.substr(at, end + 1 - at), sub(span, at, end + 1), element, around);
      expression.replace(at, end + 1 - at, end + 1 - at, '0');
      at = end;
    }
    xacro::Lexer lexer(expression);
    bool is_attribute = false;
    while (true) {
      const xacro::Token token = lexer.next();
      if (token.type == xacro::TokenType::kEnd || token.type == xacro::TokenType::kTrouble) return;
      if (token.type == xacro::TokenType::kName && !is_attribute)
        refer(sub(span, token.begin, token.end), element, around);
      is_attribute =
          token.type == xacro::TokenType::kOperator &&
          std::string_view(expression).substr(token.begin, token.end - token.begin) == ".";
    }
  }

  const xml::Document& document_;
  std::vector<TemplateName> names_;
};

}  // namespace

std::string_view to_string(TemplateNameKind kind) {
  switch (kind) {
    case TemplateNameKind::kMacro: return "macro";
    case TemplateNameKind::kParameter: return "parameter";
    case TemplateNameKind::kProperty: return "property";
    case TemplateNameKind::kArgument: return "argument";
  }
  return "";
}

std::vector<TemplateName> template_names(const xml::Document& document) {
  return TemplateNameCollector(document).collect();
}

}  // namespace rigor::author
