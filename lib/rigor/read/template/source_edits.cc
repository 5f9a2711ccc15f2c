// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/template/source_edits.h>

#include <algorithm>
#include <string>
#include <utility>

#include <rigor/xml/decode.h>
#include <rigor/xml/edit.h>

namespace rigor::read {
namespace {

bool are_same_edits(const std::vector<Edit>& a, const std::vector<Edit>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Edit& x, const Edit& y) {
    return x.span == y.span && x.text == y.text;
  });
}

/// Neither an expression nor a tag of xacro's within it.
bool is_literal(std::string_view written) {
  return written.find('$') == std::string_view::npos &&
         written.find("<xacro:") == std::string_view::npos;
}

/// The name and the value of ` name="value"`.
std::optional<std::pair<std::string_view, std::string>> attribute_in(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const std::size_t equals = text.find('=');
  if (begin == std::string_view::npos || begin == 0 || equals == std::string_view::npos ||
      equals < begin || equals + 2 > text.size() || text.size() < equals + 3)
    return std::nullopt;
  const char quote = text[equals + 1];
  if ((quote != '"' && quote != '\'') || text.find(quote, equals + 2) != text.size() - 1)
    return std::nullopt;
  return std::pair{text.substr(begin, equals - begin),
                   xml::decode(text.substr(equals + 2, text.size() - equals - 3)).text};
}

std::optional<xml::Element> last_child(xml::Element element) {
  std::optional<xml::Element> last;
  for (const xml::Element child : element.children()) last = child;
  return last;
}

/// Its lines with as much less indentation as the first has; nothing where one has less.
std::string as_snippet(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  const std::size_t line = begin == 0 ? std::string_view::npos : text.rfind('\n', begin - 1);
  const std::size_t indent = line == std::string_view::npos ? begin : begin - line - 1;
  std::string snippet;
  for (std::size_t at = begin; at <= end;) {
    const std::size_t feed = std::min(text.find('\n', at), end + 1);
    snippet += text.substr(at, feed - at);
    if (feed > end) break;
    snippet += '\n';
    at = feed + 1;
    const std::size_t first = text.find_first_not_of(' ', at);
    if (first == std::string_view::npos || first - at < indent) return {};
    at += indent;
  }
  return snippet;
}

}  // namespace

std::optional<SourceEdits::Pair> SourceEdits::pair_of(xml::Element shown) const {
  if (shown.index() >= elements_.size()) return std::nullopt;
  const xacro::Node& node = *elements_[shown.index()];
  const Span tag = node.where.span;
  if (tag.nowhere()) return std::nullopt;
  xml::Document file = xml::parse_own(sources_.bytes(tag.source), tag.source);
  const auto written = file.element_at(tag.begin);
  if (!file.complete() || !written || written->tag_span() != tag || written->name() != node.name)
    return std::nullopt;
  const std::uint32_t index = written->index();
  return Pair{shown, std::move(file), index};
}

std::vector<Edit> SourceEdits::of(const std::vector<Edit>& edits) const {
  if (edits.empty()) return {};
  const Edit& first = edits.front();
  if (edits.size() == 1) {
    const auto element = expanded_.element_at(first.span.begin);
    if (element && first.span.begin < element->tag_span().end) {
      const auto pair = pair_of(*element);
      std::vector<Edit> written = pair ? of_attribute(*pair, first) : std::vector<Edit>{};
      if (!written.empty()) return written;
    }
    if (first.span.begin == first.span.end) return of_inserted(first);
  }
  // The first tag that is changed is that of the element.
  const std::string_view bytes = expanded_.bytes();
  std::size_t tag = std::min(bytes.find('<', first.span.begin), bytes.size());
  if (tag >= first.span.end && first.span.begin > 0) tag = first.span.begin - 1U;
  const auto element = expanded_.element_at(static_cast<std::uint32_t>(tag));
  const auto pair = element ? pair_of(*element) : std::nullopt;
  if (!pair) return {};
  std::vector<Edit> written = of_removed(*pair, edits);
  return written.empty() ? of_renamed(*pair, edits) : written;
}

std::vector<Edit> SourceEdits::of_attribute(const Pair& pair, const Edit& edit) const {
  for (const xml::Attribute attribute : pair.shown.attributes()) {
    if (!are_same_edits(xml::remove_attribute(expanded_, attribute), {edit})) continue;
    const auto own = pair.written().attribute(attribute.name());
    const bool same = own && own->value() == attribute.value() && is_literal(own->value());
    return same ? xml::remove_attribute(pair.file, *own) : std::vector<Edit>{};
  }
  const auto added = edit.span.size() == 0 ? attribute_in(edit.text) : std::nullopt;
  if (!added || pair.written().attribute(added->first) ||
      !are_same_edits(xml::set_attribute(expanded_, pair.shown, added->first, added->second),
                      {edit})) {
    return {};
  }
  return xml::set_attribute(pair.file, pair.written(), added->first, added->second);
}

std::vector<Edit> SourceEdits::of_removed(const Pair& pair, const std::vector<Edit>& edits) const {
  const bool literal = is_literal(sources_.bytes(pair.written().span()));
  if (!literal || !are_same_edits(xml::remove_element(expanded_, pair.shown), edits)) return {};
  return xml::remove_element(pair.file, pair.written());
}

std::vector<Edit> SourceEdits::of_renamed(const Pair& pair, const std::vector<Edit>& edits) const {
  const std::string& name = edits.front().text;
  if (!are_same_edits(xml::rename_element(expanded_, pair.shown, name), edits)) return {};
  return xml::rename_element(pair.file, pair.written(), name);
}

/// Behind a child, or as the first of a parent.
std::vector<Edit> SourceEdits::of_inserted(const Edit& edit) const {
  const std::size_t before = expanded_.bytes().substr(0, edit.span.begin).rfind('<');
  if (before == std::string_view::npos) return {};
  const auto near = expanded_.element_at(static_cast<std::uint32_t>(before));
  if (!near) return {};
  std::vector<Edit> written;
  if (near->span().end <= edit.span.begin && near->parent())
    written = of_inserted(*near->parent(), *near, edit);
  return written.empty() ? of_inserted(*near, std::nullopt, edit) : written;
}

std::vector<Edit> SourceEdits::of_inserted(xml::Element parent, std::optional<xml::Element> after,
                                           const Edit& edit) const {
  const std::string snippet = as_snippet(edit.text);
  if (snippet.empty() ||
      !are_same_edits(xml::insert_child(expanded_, parent, after, snippet), {edit}))
    return {};
  const auto pair = pair_of(parent);
  if (!pair) return {};
  if (!after) return xml::insert_child(pair->file, pair->written(), std::nullopt, snippet);
  const auto beside = pair_of(*after);
  if (beside && beside->file.source() == pair->file.source()) {
    const xml::Element own = pair->file.element(beside->index);
    if (own.parent() && own.parent()->index() == pair->index)
      return xml::insert_child(pair->file, pair->written(), own, snippet);
  }
  // What a macro or a condition brought is written elsewhere; behind the last of a parent is at its end all the same.
  const auto last = last_child(pair->written());
  if (!last || last_child(parent)->index() != after->index()) return {};
  return xml::insert_child(pair->file, pair->written(), last, snippet);
}

}  // namespace rigor::read
