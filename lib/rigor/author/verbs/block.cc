// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/block.h>

#include <cstddef>
#include <map>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/verbs/draft.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/edit.h>
#include <rigor/xml/style.h>

namespace rigor::author {
namespace {

constexpr std::string_view kDeclaration = "xmlns:";

/// What is before the colon, of a name that needs a declaration.
std::string_view prefix_of(std::string_view name) {
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos || name.starts_with("xml:") || name.starts_with(kDeclaration))
    return {};
  return name.substr(0, colon);
}

/// Adds what the prefix is bound to, unless an element behind `begin` says so.
void add_namespace(xml::Element user, std::string_view prefix, std::uint32_t begin,
                   std::map<std::string, std::string>& used) {
  if (prefix.empty()) return;
  const std::string name = std::string(kDeclaration) + std::string(prefix);
  for (std::optional<xml::Element> at = user; at; at = at->parent()) {
    const auto declaration = at->attribute(name);
    if (!declaration) continue;
    if (at->span().begin < begin) used.emplace(prefix, declaration->value());
    return;
  }
}

}  // namespace

std::vector<Namespace> namespaces_used(const xml::Document& document, std::uint32_t begin,
                                       std::uint32_t end) {
  std::map<std::string, std::string> used;
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    const xml::Element element = document.element(i);
    if (element.span().begin < begin || element.span().begin >= end) continue;
    add_namespace(element, prefix_of(element.name()), begin, used);
    for (const xml::Attribute attribute : element.attributes())
      add_namespace(element, prefix_of(attribute.name()), begin, used);
  }
  return {used.begin(), used.end()};
}

std::vector<Namespace> declared_namespaces(xml::Element element) {
  std::vector<Namespace> namespaces;
  for (const xml::Attribute attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    if (name.starts_with(kDeclaration))
      namespaces.emplace_back(name.substr(kDeclaration.size()), attribute.value());
  }
  return namespaces;
}

std::vector<std::string> namespace_conflicts(const std::vector<Namespace>& bound,
                                             std::string_view into,
                                             const std::vector<Namespace>& used,
                                             std::string_view from) {
  std::vector<std::string> notes;
  for (const auto& [prefix, uri] : used) {
    for (const auto& [other, other_uri] : bound) {
      if (other == prefix && other_uri != uri)
        notes.push_back(fmt::format("namespace prefix '{}' is {} as in {}, not {} as in {}", prefix,
                                    other_uri, into, uri, from));
    }
  }
  return notes;
}

std::vector<Edit> declared(const xml::Document& document, xml::Element element,
                           const std::vector<Namespace>& namespaces) {
  std::vector<std::string> names;
  for (const auto& [prefix, uri] : namespaces) names.push_back(std::string(kDeclaration) + prefix);
  std::vector<xml::NamedValue> values;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!element.attribute(names[i])) values.push_back({names[i], namespaces[i].second});
  }
  return values.empty() ? std::vector<Edit>{} : xml::set_attributes(document, element, values);
}

std::optional<std::uint32_t> end_of_content(const xml::Document& document, xml::Element element) {
  const Span span = element.span();
  const std::string_view bytes = document.bytes();
  if (xml::is_empty_tag(document, element)) return std::nullopt;
  const auto at = static_cast<std::uint32_t>(bytes.rfind("</", span.end - 1));
  std::uint32_t line = at;
  while (line > span.begin && xml::kBlanks.find(bytes[line - 1]) != std::string_view::npos) --line;
  return bytes[line - 1] == '\n' ? line : at;
}

std::string part_after(const xml::Document& document, std::uint32_t begin, std::uint32_t end,
                       std::vector<Edit> edits) {
  std::erase_if(edits,
                [&](const Edit& edit) { return edit.span.begin < begin || edit.span.end > end; });
  for (Edit& edit : edits) {
    edit.span.begin -= begin;
    edit.span.end -= begin;
  }
  return apply_edits(document.bytes().substr(begin, end - begin), std::move(edits)).value_or("");
}

std::optional<Edit> block_at_end(const xml::Document& document, xml::Element holder,
                                 std::string text) {
  const auto at = end_of_content(document, holder);
  if (!at) return std::nullopt;
  const std::string line(xml::line_end(document, *at));
  if (document.bytes()[*at - 1] != '\n') text.insert(0, line);
  return Edit{{document.source(), *at, *at}, with_line_ends(text + line, line)};
}

std::string with_line_ends(std::string_view text, std::string_view line) {
  std::string result;
  while (true) {
    const std::size_t feed = text.find('\n');
    if (feed == std::string_view::npos) return result.append(text);
    const bool carriage = feed > 0 && text[feed - 1] == '\r';
    result.append(text.substr(0, feed - (carriage ? 1 : 0))).append(line);
    text.remove_prefix(feed + 1);
  }
}

std::optional<Edit> block_in_template(const EditedModel& edited, std::string text) {
  const read::ExpandedFile* expanded = edited.loaded.file->expanded.get();
  const xml::Element root = edited.element(edited.root()[edited.model].site);
  if (expanded == nullptr) return std::nullopt;
  const Span tag = expanded->origin(edited.document(), root.name_span(), edited.sources).where;
  if (tag.nowhere()) return std::nullopt;
  const xml::Document written = xml::parse_own(edited.sources.bytes(tag.source), tag.source);
  if (!written.complete() || !written.root() || !written.root()->attribute("xmlns:xacro"))
    return std::nullopt;
  return block_at_end(written, *written.root(), std::move(text));
}

std::string child_indentation(const xml::Document& document, xml::Element holder) {
  for (const xml::Element child : holder.children()) {
    if (xml::stands_first(document, child)) return xml::indentation(document, child);
  }
  return xml::indentation(document, holder) + xml::indent_unit(document, holder);
}

std::optional<xml::Element> last_child_of(xml::Element element) {
  std::optional<xml::Element> last;
  for (const xml::Element child : element.children()) last = child;
  return last;
}

std::string trimmed_lines(std::string text) {
  text.erase(text.find_last_not_of(write::kSpace) + 1);
  const std::size_t first = text.find_first_not_of(write::kSpace);
  if (first == std::string::npos) return {};
  const std::size_t line = text.rfind('\n', first);
  return line == std::string::npos ? text : text.substr(line + 1);
}

std::string xyz_text(const model::Pose& X) {
  const double size = length(X.translation);
  const auto number = [size](double value) { return write::settled(value, 0, size); };
  return write::joined({number(X.translation.x), number(X.translation.y), number(X.translation.z)});
}

std::string rpy_text(const model::Pose& X) {
  const model::Vector3 rpy = to_rpy(X.rotation);
  const auto number = [](double value) { return write::settled(value, 0, std::numbers::pi); };
  return write::joined({number(rpy.x), number(rpy.y), number(rpy.z)});
}

}  // namespace rigor::author
