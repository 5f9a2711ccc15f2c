// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/template/expanded_file.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <rigor/read/template/source_edits.h>
#include <rigor/read/values.h>

namespace rigor::read {
namespace {

void add_elements(const xacro::Node& node, std::vector<const xacro::Node*>& elements) {
  // Without recursion: elements may nest as deep as a file says.
  const xacro::Node* at = &node;
  while (true) {
    if (at->kind == xacro::NodeKind::kElement) elements.push_back(at);
    if (at->first != nullptr) {
      at = at->first;
      continue;
    }
    while (at != &node && at->next == nullptr) at = at->parent;
    if (at == &node) return;
    at = at->next;
  }
}

constexpr std::string_view kSetHere = "the value is set here";

bool encloses(Span outer, Span inner) {
  return outer.source == inner.source && outer.begin <= inner.begin && inner.end <= outer.end;
}

Span span_at(SourceId source, std::size_t begin, std::size_t end) {
  return {source, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

/// Where words begin and end; what is in the brackets of an expression is one.
std::vector<std::pair<std::size_t, std::size_t>> words_of_template(std::string_view text) {
  std::vector<std::pair<std::size_t, std::size_t>> words;
  constexpr std::string_view kBlanks = " \t\r\n";
  for (std::size_t at = 0; at < text.size();) {
    if (kBlanks.find(text[at]) != std::string_view::npos) {
      ++at;
      continue;
    }
    const std::size_t begin = at;
    while (at < text.size() && kBlanks.find(text[at]) == std::string_view::npos) {
      const std::string_view rest = text.substr(at);
      const bool opens = rest.starts_with("${") || rest.starts_with("$(");
      const std::size_t close = opens ? rest.find(rest[1] == '{' ? '}' : ')') : 0;
      at += close == std::string_view::npos ? rest.size() : close + 1;
    }
    words.emplace_back(begin, at);
  }
  return words;
}

/// The name of the attribute whose value is written at `value`; nowhere when another stands there.
Span name_before(Span value, std::string_view name, const Sources& sources) {
  const std::string_view all = sources.bytes(value.source);
  constexpr std::string_view kBlanks = " \t\r\n";
  std::size_t at = value.begin > 0 ? value.begin - 1U : 0;  // the quote
  const auto skip_blanks = [&] {
    while (at > 0 && kBlanks.find(all[at - 1]) != std::string_view::npos) --at;
  };
  skip_blanks();
  if (at == 0 || all[at - 1] != '=') return {};
  --at;
  skip_blanks();
  if (at < name.size() || all.substr(at - name.size(), name.size()) != name) return {};
  return span_at(value.source, at - name.size(), at);
}

}  // namespace

ExpandedFile::ExpandedFile(xacro::Expansion expansion) : expansion_(std::move(expansion)) {
  if (expansion_.document != nullptr && expansion_.document->first != nullptr) {
    for (const xacro::Node* top = expansion_.document->first; top != nullptr; top = top->next) {
      if (top->kind == xacro::NodeKind::kElement) add_elements(*top, elements_);
    }
  }
}

std::vector<Span> ExpandedFile::whole_links(const xml::Document& expanded) const {
  std::vector<Span> links;
  const auto root = expanded.root();
  if (!root) return links;
  for (const xml::Element child : root->children()) {
    if (child.name() != "link" || child.index() >= elements_.size()) continue;
    std::vector<const xacro::Node*> parts;
    add_elements(*elements_[child.index()], parts);
    const auto is_partial = [](const xacro::Node* node) { return node->is_partial; };
    if (std::none_of(parts.begin(), parts.end(), is_partial)) links.push_back(child.span());
  }
  return links;
}

Origin ExpandedFile::of_attribute(const xml::Attribute& attribute, const xacro::Node& node,
                                  Span where, const Sources& sources) const {
  const xacro::NodeAttribute* made = node.attribute(attribute.name());
  if (made == nullptr || made->where.span.nowhere()) return {node.where.span, node.frame};
  const Span value = made->where.span;
  const bool verbatim = made->where.verbatim && attribute.verbatim();
  const Span shown = attribute.value_span();
  if (encloses(shown, where)) {
    if (!verbatim) return of_part(*made, node.frame, where.begin - shown.begin, sources);
    return {made->where.part(where.begin - shown.begin, where.end - shown.begin).span, node.frame,
            made->from, true};
  }
  const Span name = name_before(value, attribute.name(), sources);
  if (name.nowhere()) return {value, node.frame, made->from};
  const bool only_name = encloses(attribute.name_span(), where);
  return {{name.source, name.begin, only_name ? name.end : value.end + 1},
          node.frame,
          only_name ? Span{} : made->from,
          only_name || verbatim};
}

/// `0.1 -2` of `${a} ${b}`: the second number is the second expression's, if both have as many words.
Origin ExpandedFile::of_part(const xacro::NodeAttribute& made, std::uint32_t frame,
                             std::uint32_t offset, const Sources& sources) const {
  const Span value = made.where.span;
  const auto written = words_of_template(sources.bytes(value));
  const auto shown = words_of_template(made.value);
  if (written.size() != shown.size() || written.size() < 2) return {value, frame, made.from};
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const auto [begin, end] = shown[i];
    if (offset < begin || offset > end) continue;
    Origin origin{
        span_at(value.source, value.begin + written[i].first, value.begin + written[i].second),
        frame};
    const std::span<const xacro::PartOrigin> parts = expansion_.part_origins.of(made.value);
    if (parts.empty()) {
      origin.from = made.from;
      return origin;
    }
    for (const xacro::PartOrigin& part : parts) {
      if (part.begin >= written[i].first && part.end <= written[i].second) origin.from = part.from;
    }
    return origin;
  }
  return {value, frame, made.from};
}

Origin ExpandedFile::of_text(const xml::Element& element, const xacro::Node& node, Span where,
                             const Sources& sources) const {
  const Span shown = element.text_span();
  const std::string_view wanted = sources.bytes(where);
  for (const xacro::Node* child = node.first; child != nullptr; child = child->next) {
    const bool is_text =
        child->kind == xacro::NodeKind::kText || child->kind == xacro::NodeKind::kCData;
    if (!is_text || child->where.span.nowhere()) continue;
    const std::string_view written = sources.bytes(child->where.span);
    const std::size_t first = written.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) continue;
    const bool whole = child->where.verbatim && element.text_verbatim();
    const std::string_view rest = written;
    const std::size_t at = whole && !wanted.empty() ? rest.find(wanted) : std::string_view::npos;
    const std::uint32_t begin = child->where.span.begin;
    if (at != std::string_view::npos) {
      // Where it stands several times, the distance from the text's begin decides.
      const std::size_t offset = where.begin - shown.begin;
      const std::size_t best =
          rest.substr(std::min(offset, rest.size())).starts_with(wanted) ? offset : at;
      return {span_at(child->where.span.source, begin + best, begin + best + wanted.size()),
              child->frame, child->from, true};
    }
    const std::size_t last = written.find_last_not_of(" \t\r\n");
    return {span_at(child->where.span.source, begin + first, begin + last + 1), child->frame,
            child->from};
  }
  return {node.where.span, node.frame};
}

std::optional<Origin> ExpandedFile::of_text_between(const xacro::Node& node, Span where,
                                                    const Sources& sources) {
  const std::string_view wanted = trimmed(sources.bytes(where));
  if (wanted.empty()) return std::nullopt;
  for (const xacro::Node* child = node.first; child != nullptr; child = child->next) {
    if (child->kind != xacro::NodeKind::kText || child->where.span.nowhere()) continue;
    const std::size_t at = sources.bytes(child->where.span).find(wanted);
    if (at == std::string_view::npos) continue;
    const std::size_t begin = child->where.span.begin + at;
    return Origin{span_at(child->where.span.source, begin, begin + wanted.size()), child->frame,
                  child->from, child->where.verbatim};
  }
  return std::nullopt;
}

Origin ExpandedFile::origin(const xml::Document& expanded, Span where,
                            const Sources& sources) const {
  const auto element = expanded.element_at(where.begin);
  if (!element || element->index() >= elements_.size()) {
    const SourceId own = expansion_.files.front().source;
    return {{own, 0, 0}};
  }
  const xacro::Node& node = *elements_[element->index()];
  for (const xml::Attribute attribute : element->attributes()) {
    if (encloses(attribute.span(), where)) return of_attribute(attribute, node, where, sources);
  }
  const Span tag = node.where.span;
  if (encloses(element->name_span(), where)) {
    const std::string_view written = sources.bytes(tag);
    if (written.size() > node.name.size() && written.substr(1).starts_with(node.name)) {
      return {span_at(tag.source, tag.begin + 1, tag.begin + 1 + node.name.size()), node.frame};
    }
    return {tag, node.frame};
  }
  if (!element->text().empty() && encloses(element->text_span(), where)) {
    return of_text(*element, node, where, sources);
  }
  return of_text_between(node, where, sources).value_or(Origin{tag, node.frame});
}

Span ExpandedFile::literal_span(const xml::Document& expanded, Span where,
                                const Sources& sources) const {
  const Origin found = origin(expanded, where, sources);
  const bool same =
      found.literal && where.size() > 0 && sources.bytes(found.where) == sources.bytes(where);
  return same ? found.where : Span{};
}

Diagnostic ExpandedFile::in_source(const xml::Document& expanded, Diagnostic diagnostic,
                                   const Sources& sources) const {
  const auto is_expanded = [&](Span span) { return span.source == expanded.source(); };
  const Span where = diagnostic.where;
  for (Label& label : diagnostic.related) {
    if (is_expanded(label.where)) label.where = origin(expanded, label.where, sources).where;
  }
  if (is_expanded(where)) {
    const Origin found = origin(expanded, where, sources);
    diagnostic.where = found.where;
    diagnostic.origin = macro_calls(expansion_.stack_of(found.frame));
    if (!found.from.nowhere() && !encloses(found.from, found.where)) {
      diagnostic.related.push_back({found.from, std::string(kSetHere)});
    }
  }
  const auto edits_nothing = [](const Fix& fix) {
    return std::any_of(fix.edits.begin(), fix.edits.end(),
                       [](const Edit& edit) { return edit.span.nowhere(); });
  };
  // A fix is tried file by file.
  const auto edits_several = [](const Fix& fix) {
    return std::any_of(fix.edits.begin(), fix.edits.end(), [&fix](const Edit& edit) {
      return edit.span.source != fix.edits.front().span.source;
    });
  };
  for (Fix& fix : diagnostic.fixes) {
    const std::vector<Edit> shown = fix.edits;
    for (Edit& edit : fix.edits) {
      if (is_expanded(edit.span)) edit.span = literal_span(expanded, edit.span, sources);
    }
    if (!edits_nothing(fix) || !std::all_of(shown.begin(), shown.end(), [&](const Edit& edit) {
          return is_expanded(edit.span);
        }))
      continue;
    std::vector<Edit> written = SourceEdits(elements_, expanded, sources).of(shown);
    if (!written.empty()) fix.edits = std::move(written);
  }
  std::erase_if(diagnostic.fixes,
                [&](const Fix& fix) { return edits_nothing(fix) || edits_several(fix); });
  return diagnostic;
}

Span where_set(const Diagnostic& diagnostic) {
  for (const Label& label : diagnostic.related) {
    if (label.message == kSetHere) return label.where;
  }
  return {};
}

std::vector<MacroCall> macro_calls(const std::vector<xacro::FactFrame>& stack) {
  std::vector<MacroCall> calls;
  for (const xacro::FactFrame& frame : stack) {
    if (frame.kind != xacro::FactFrame::Kind::kMacro) continue;
    MacroCall& call = calls.emplace_back(MacroCall{frame.name, frame.where, {}});
    for (const xacro::FactParameter& parameter : frame.parameters) {
      call.params.emplace_back(parameter.name, parameter.value);
    }
  }
  return calls;
}

}  // namespace rigor::read
