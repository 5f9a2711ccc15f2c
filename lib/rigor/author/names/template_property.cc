// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/template_property.h>

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/names/expansion_proof.h>
#include <rigor/author/names/template_rename.h>
#include <rigor/text/path.h>
#include <rigor/xml/edit.h>
#include <rigor/xml/style.h>

namespace rigor::author {
namespace {

constexpr std::string_view kNumberCharacters = "0123456789.eE+-";

bool is_number_text(std::string_view text) {
  return !text.empty() && text.find_first_not_of(kNumberCharacters) == std::string_view::npos &&
         text.find_first_of("0123456789") != std::string_view::npos;
}

/// The expression around an offset of a value, from `$` past `}`; nothing outside of one.
std::optional<std::pair<std::size_t, std::size_t>> expression_around(std::string_view value,
                                                                     std::size_t offset) {
  for (std::size_t at = value.find("${"); at != std::string_view::npos && at < offset;
       at = value.find("${", at + 2)) {
    const std::size_t close = value.find('}', at);
    if (close != std::string_view::npos && offset <= close) return std::pair{at, close + 1};
  }
  return std::nullopt;
}

/// The number around an offset, without a sign before it.
std::pair<std::size_t, std::size_t> number_around(std::string_view text, std::size_t offset) {
  const auto is_part = [&](std::size_t at) {
    const char c = text[at];
    return (c >= '0' && c <= '9') || c == '.';
  };
  std::size_t begin = std::min(offset, text.size());
  std::size_t end = begin;
  while (begin > 0 && is_part(begin - 1)) --begin;
  while (end < text.size() && is_part(end)) ++end;
  const auto is_letter = [&](std::size_t at) {
    const char c = text[at];
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const bool in_name = (begin > 0 && is_letter(begin - 1)) || (end < text.size() && is_letter(end));
  return in_name ? std::pair{offset, offset} : std::pair{begin, end};
}

std::optional<xml::Attribute> attribute_at(const xml::Document& document, Span where) {
  const auto element = document.element_at(where.begin);
  if (!element) return std::nullopt;
  for (const xml::Attribute attribute : element->attributes()) {
    const Span value = attribute.value_span();
    if (value.begin <= where.begin && where.end <= value.end) return attribute;
  }
  return std::nullopt;
}

/// The child of the root that a place is in.
std::optional<xml::Element> part_at(const xml::Document& document, std::uint32_t offset) {
  auto element = document.element_at(offset);
  while (element && element->parent() && element->parent()->parent()) element = element->parent();
  return element && element->parent() ? element : std::nullopt;
}

bool has_template_name(const xml::Document& document, std::string_view name) {
  const auto names = template_names(document);
  return std::any_of(names.begin(), names.end(),
                     [name](const TemplateName& each) { return each.name == name; });
}

/// Those of the templates that read the file at a path.
std::vector<std::string> readers_of(const RenameContext& context,
                                    const std::vector<std::string>& templates,
                                    const std::string& path) {
  std::vector<std::string> readers;
  for (const std::string& each : templates) {
    const read::File& file = context.graph.file(each);
    if (!file.expanded || !file.document) continue;
    const auto& files = file.expanded->expansion().files;
    const bool reads = std::any_of(files.begin(), files.end(), [&](const xacro::FileUse& use) {
      return use.source != kNoSource && normalize_path(context.sources.path(use.source)) == path;
    });
    if (reads && std::find(readers.begin(), readers.end(), each) == readers.end())
      readers.push_back(each);
  }
  return readers;
}

Renaming proven_change(const RenameContext& context, const std::vector<std::string>& templates,
                       std::vector<Edit> edits) {
  if (std::string fault = expansion_fault(context, templates, edits); !fault.empty())
    return {{}, std::move(fault)};
  std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) {
    return std::pair(a.span.source, a.span.begin) < std::pair(b.span.source, b.span.begin);
  });
  return {std::move(edits), {}};
}

/// What a use of a property becomes: in `${property}` alone the text itself, in an expression what gives the same.
std::optional<Edit> inlined_use(std::string_view bytes, Span use, std::string_view value) {
  const auto skip_back = [&](std::size_t at) {
    while (at > 0 && bytes[at - 1] == ' ') --at;
    return at;
  };
  std::size_t after = use.end;
  while (after < bytes.size() && bytes[after] == ' ') ++after;
  const std::size_t before = skip_back(use.begin);
  const bool alone = before >= 2 && bytes.substr(before - 2, 2) == "${" && after < bytes.size() &&
                     bytes[after] == '}';
  if (alone) {
    const Span whole{use.source, static_cast<std::uint32_t>(before - 2),
                     static_cast<std::uint32_t>(after + 1)};
    return Edit{whole, std::string(value)};
  }
  if (is_number_text(value))
    return Edit{use, value[0] == '-' ? fmt::format("({})", value) : std::string(value)};
  const bool is_expression = value.starts_with("${") && value.ends_with('}') &&
                             value.find('$', 1) == std::string_view::npos;
  if (is_expression) return Edit{use, fmt::format("({})", value.substr(2, value.size() - 3))};
  if (value.find_first_of("$'\"\\") != std::string_view::npos) return std::nullopt;
  return Edit{use, fmt::format("'{}'", value)};
}

}  // namespace

Span extractable_value(const xml::Document& document, Span selection) {
  const auto attribute = attribute_at(document, selection);
  if (!attribute || !attribute->verbatim() || attribute->value().empty()) return {};
  const auto element = document.element_at(selection.begin);
  if (!part_at(document, selection.begin) || element->name() == "xacro:macro" ||
      attribute->name() == "name" || attribute->name() == "params")
    return {};
  const Span value = attribute->value_span();
  const std::size_t offset = selection.begin - value.begin;
  if (!expression_around(attribute->value(), offset)) {
    // A selected part of a row, "0 0 0.5", else all of it.
    return selection.begin < selection.end ? Span{value.source, selection.begin, selection.end}
                                           : value;
  }
  const auto [begin, end] = number_around(attribute->value(), offset);
  if (begin == end) return {};
  return {value.source, value.begin + static_cast<std::uint32_t>(begin),
          value.begin + static_cast<std::uint32_t>(end)};
}

std::string proposed_property(const xml::Document& document, Span value) {
  const auto attribute = attribute_at(document, value);
  const auto element = document.element_at(value.begin);
  if (!attribute || !element) return "value";
  std::string base = std::string(element->name()) + '_' + std::string(attribute->name());
  for (char& c : base) {
    const bool fits = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!fits) c = '_';
  }
  std::string name = base;
  for (int number = 2; has_template_name(document, name); ++number)
    name = base + '_' + std::to_string(number);
  return name;
}

Renaming extracted_property(const RenameContext& context, const std::vector<std::string>& templates,
                            const xml::Document& document, Span value, std::string_view name) {
  const auto attribute = attribute_at(document, value);
  const auto part = part_at(document, value.begin);
  if (!attribute || !part || value.size() == 0) return {{}, "there is no value here"};
  if (has_template_name(document, name)) return {{}, fmt::format("'{}' exists already", name)};
  const std::string_view bytes = document.bytes();
  const std::string_view text = bytes.substr(value.begin, value.size());
  const Span whole = attribute->value_span();
  const bool in_expression =
      expression_around(attribute->value(), value.begin - whole.begin).has_value();
  const char quote = text.find('"') == std::string_view::npos ? '"' : '\'';
  const std::uint32_t begin = part->span().begin;
  std::uint32_t line = begin;
  while (line > 0 && (bytes[line - 1] == ' ' || bytes[line - 1] == '\t')) --line;
  std::string property =
      fmt::format("<xacro:property name=\"{}\" value={}{}{}/>", name, quote, text, quote);
  property += xml::line_end(document, begin);
  property += bytes.substr(line, begin - line);
  std::vector<Edit> edits{
      {{document.source(), begin, begin}, std::move(property)},
      {value, in_expression ? std::string(name) : fmt::format("${{{}}}", name)}};
  const std::string path = normalize_path(context.sources.path(document.source()));
  const std::vector<std::string> readers = readers_of(context, templates, path);
  if (readers.empty()) return {{}, "no template that can be expanded reads the file"};
  return proven_change(context, readers, std::move(edits));
}

Renaming inlined_property(const RenameContext& context, const std::vector<std::string>& templates,
                          const TemplateName& name) {
  if (name.kind != TemplateNameKind::kProperty) return {{}, "it is no property"};
  std::vector<std::string> readers;
  std::vector<TemplateUse> uses;
  for (const std::string& each : templates) {
    const read::File& file = context.graph.file(each);
    auto found = template_uses(file, context.sources, name);
    if (found.empty() || std::find(readers.begin(), readers.end(), each) != readers.end()) continue;
    readers.push_back(each);
    for (TemplateUse& use : found) {
      const bool known = std::any_of(uses.begin(), uses.end(), [&](const TemplateUse& other) {
        return other.where.begin == use.where.begin && other.where.end == use.where.end &&
               context.sources.path(other.where.source) == context.sources.path(use.where.source);
      });
      if (!known) uses.push_back(std::move(use));
    }
  }
  const auto is_definition = [](const TemplateUse& use) { return use.name.defines; };
  const auto definition = std::find_if(uses.begin(), uses.end(), is_definition);
  if (definition == uses.end()) return {{}, "it is set nowhere"};
  if (std::count_if(uses.begin(), uses.end(), is_definition) > 1)
    return {{}, "it is set more than once"};
  const xml::Document document =
      xml::parse_own(context.sources.bytes(definition->where.source), definition->where.source);
  const auto element = document.element_at(definition->where.begin);
  const auto value = element ? element->attribute("value") : std::nullopt;
  if (!value || !value->verbatim()) return {{}, "it has no value that is a text"};
  if (uses.size() == 1) return {{}, "nothing uses it"};
  std::vector<Edit> edits = xml::remove_element(document, *element);
  for (const TemplateUse& use : uses) {
    if (use.name.defines) continue;
    auto edit = inlined_use(context.sources.bytes(use.where.source), use.where, value->value());
    if (!edit) return {{}, "an expression uses its text"};
    edits.push_back(*std::move(edit));
  }
  return proven_change(context, readers, std::move(edits));
}

}  // namespace rigor::author
