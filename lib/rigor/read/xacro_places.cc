// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/xacro_places.h>

#include <algorithm>

namespace rigor::read {
namespace {

/// A source with more names made by expressions is generated; each finding is held against all of them.
constexpr std::size_t kMaxXacroPatterns = 2000;

std::size_t expression_begin(std::string_view text) {
  return std::min(text.find("${"), text.find("$("));
}

/// Past the bracket that closes the expression at the beginning of `text`.
std::size_t expression_end(std::string_view text) {
  const std::size_t close = text.find(text[1] == '{' ? '}' : ')');
  return close == std::string_view::npos ? text.size() : close + 1;
}

std::optional<xml::Element> only_child(const xml::Element& parent, std::string_view tag) {
  std::optional<xml::Element> only;
  for (const xml::Element child : parent.children()) {
    if (child.name() != tag) continue;
    if (only) return std::nullopt;
    only = child;
  }
  return only;
}

bool holds(Span outer, Span inner) { return outer.begin <= inner.begin && inner.end <= outer.end; }

/// The part of `source` that is what `where` is of `element`.
Span same_part(const xml::Element& element, Span where, const xml::Element& source) {
  for (const xml::Attribute attribute : element.attributes()) {
    if (!holds(attribute.span(), where)) continue;
    const std::optional<xml::Attribute> same = source.attribute(attribute.name());
    if (!same) break;
    return holds(attribute.value_span(), where) ? same->value_span() : same->name_span();
  }
  if (holds(element.name_span(), where)) return source.name_span();
  const bool has_text = !element.text().empty() && !source.text().empty();
  if (has_text && holds(element.text_span(), where)) return source.text_span();
  return source.tag_span();
}

}  // namespace

bool fits_xacro_name(std::string_view pattern, std::string_view name) {
  bool anything = false;  // an expression stands before what is left
  while (true) {
    const std::size_t begin = expression_begin(pattern);
    const std::string_view plain = pattern.substr(0, begin);
    if (begin == std::string_view::npos) {
      return anything ? name.ends_with(plain) : name == plain;
    }
    const std::size_t at = anything ? name.find(plain) : (name.starts_with(plain) ? 0 : name.npos);
    if (at == std::string_view::npos) return false;
    name.remove_prefix(at + plain.size());
    pattern.remove_prefix(begin);
    pattern.remove_prefix(expression_end(pattern));
    anything = true;
  }
}

XacroPlaces::XacroPlaces(const xml::Document& expanded, const xml::Document& source)
    : expanded_(expanded),
      source_(source),
      in_expanded_(index_of(expanded)),
      in_source_(index_of(source)) {
  for (std::uint32_t i = 1; i < source.element_count(); ++i) {
    const xml::Element element = source.element(i);
    const std::optional<xml::Attribute> name = element.attribute("name");
    if (name && expression_begin(name->value()) != std::string_view::npos) {
      patterns_.push_back(element);
    }
    if (element.name() == "xacro:include" || patterns_.size() > kMaxXacroPatterns) {
      patterns_.clear();
      break;
    }
  }
}

XacroPlaces::Index XacroPlaces::index_of(const xml::Document& document) {
  Index index;
  for (std::uint32_t i = 1; i < document.element_count(); ++i) {
    const xml::Element element = document.element(i);
    const std::optional<xml::Attribute> name = element.attribute("name");
    if (!name) continue;
    const auto [entry, is_new] = index.try_emplace({element.name(), name->value()}, i);
    if (!is_new) entry->second = std::nullopt;
  }
  return index;
}

/// What a named element comes from.
std::optional<xml::Element> XacroPlaces::origin(const xml::Element& element) const {
  const std::optional<xml::Attribute> name = element.attribute("name");
  if (!name) return std::nullopt;
  const Key key{element.name(), name->value()};
  const auto known = in_source_.find(key);
  if (known == in_source_.end()) return fitting(key);
  const auto here = in_expanded_.find(key);
  if (!known->second || here == in_expanded_.end() || !here->second) return std::nullopt;
  return source_.element(*known->second);
}

std::optional<xml::Element> XacroPlaces::fitting(const Key& key) const {
  std::optional<xml::Element> only;
  for (const xml::Element& element : patterns_) {
    if (element.name() != key.first) continue;
    if (!fits_xacro_name(element.attribute("name")->value(), key.second)) continue;
    if (only) return std::nullopt;
    only = element;
  }
  return only;
}

Span XacroPlaces::of(Span where) const {
  if (where.nowhere()) return {};
  std::vector<xml::Element> way;  // from the element at fault up to the one whose origin is known
  std::optional<xml::Element> source;
  for (std::optional<xml::Element> at = expanded_.element_at(where.begin); at && !source;
       at = at->parent()) {
    if (at->index() == 0) return {};
    way.push_back(*at);
    source = origin(*at);
  }
  if (!source) return {};
  while (way.size() > 1) {
    const std::string_view tag = way[way.size() - 2].name();
    const std::optional<xml::Element> next = only_child(*source, tag);
    if (!next || !only_child(way.back(), tag)) return source->tag_span();
    source = next;
    way.pop_back();
  }
  return same_part(way.front(), where, *source);
}

Diagnostic XacroPlaces::in_source(Diagnostic diagnostic, const std::string& path) const {
  diagnostic.fixes.clear();
  if (diagnostic.where.source == expanded_.source()) {
    diagnostic.where = of(diagnostic.where);
    if (diagnostic.where.nowhere()) diagnostic.path = path;
  }
  std::vector<Label> related;
  for (Label& label : diagnostic.related) {
    if (label.where.source == expanded_.source()) label.where = of(label.where);
    if (!label.where.nowhere()) related.push_back(std::move(label));
  }
  diagnostic.related = std::move(related);
  return diagnostic;
}

}  // namespace rigor::read
