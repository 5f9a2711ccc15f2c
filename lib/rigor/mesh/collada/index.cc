// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collada/index.h>

#include <algorithm>
#include <charconv>

#include <rigor/mesh/text_cursor.h>

namespace rigor::mesh {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

std::string_view value(xml::Element element, std::string_view attribute) {
  const std::optional<xml::Attribute> found = element.attribute(attribute);
  return found ? trimmed(found->value()) : std::string_view();
}

std::optional<std::uint64_t> count_of(xml::Element element, std::string_view attribute) {
  const std::string_view text = value(element, attribute);
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return count;
}

std::string_view trimmed_text(xml::Element element) { return trimmed(element.text()); }

std::optional<xml::Element> descend(xml::Element from,
                                    std::initializer_list<std::string_view> names) {
  std::optional<xml::Element> at = from;
  for (const std::string_view name : names) {
    at = at->child(name);
    if (!at) break;
  }
  return at;
}

std::optional<std::vector<double>> numbers(xml::Element element, std::size_t count) {
  TextCursor cursor(element.text());
  std::vector<double> values;
  for (cursor.skip_space(); !cursor.at_end(); cursor.skip_space()) {
    const std::optional<double> number = cursor.number();
    if (!number || values.size() == count) return std::nullopt;
    values.push_back(*number);
  }
  if (values.size() != count) return std::nullopt;
  return values;
}

ColladaIndex::ColladaIndex(const xml::Document& document) : document_(document) {
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    const std::string_view id = value(document.element(i), "id");
    if (!id.empty()) elements_.emplace_back(id, i);
  }
  std::sort(elements_.begin(), elements_.end());
  const std::string_view bytes = document.bytes();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const bool before_lf = i + 1 < bytes.size() && bytes[i + 1] == '\n';
    if (bytes[i] == '\n' || (bytes[i] == '\r' && !before_lf)) {
      line_ends_.push_back(static_cast<std::uint32_t>(i));
    }
  }
}

std::optional<xml::Element> ColladaIndex::find(std::string_view url, std::string_view name) const {
  if (!url.starts_with('#')) return std::nullopt;
  return find_id(url.substr(1), name);
}

std::optional<xml::Element> ColladaIndex::find_id(std::string_view id,
                                                  std::string_view name) const {
  const auto found =
      std::lower_bound(elements_.begin(), elements_.end(), std::pair(id, std::uint32_t{0}));
  if (found == elements_.end() || found->first != id) return std::nullopt;
  const xml::Element element = document_.element(found->second);
  if (element.name() != name) return std::nullopt;
  return element;
}

std::uint64_t ColladaIndex::line(xml::Element element) const {
  const auto at = std::lower_bound(line_ends_.begin(), line_ends_.end(), element.tag_span().begin);
  return static_cast<std::uint64_t>(at - line_ends_.begin()) + 1;
}

}  // namespace rigor::mesh
