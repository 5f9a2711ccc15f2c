// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The structure of a document: symbols, folding, selections.

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include <rigor/author/names/file_names.h>
#include <rigor/lsp/answer/answers.h>
#include <rigor/lsp/answer/edits_json.h>
#include <rigor/lsp/answer/name_lookup.h>
#include <rigor/text/letter_case.h>

namespace rigor::lsp {
namespace {

/// Of the protocol's SymbolKind, by the name of an element that is shown.
struct SymbolElement {
  std::string_view element;
  int kind;
};
constexpr SymbolElement kSymbolElements[] = {
    {"world", 3},        {"model", 2},         {"include", 2},         {"robot", 2},
    {"link", 5},         {"joint", 6},         {"frame", 8},           {"sensor", 24},
    {"plugin", 12},      {"light", 14},        {"collision", 19},      {"visual", 19},
    {"material", 7},     {"transmission", 11}, {"ros2_control", 11},   {"gazebo", 11},
    {"xacro:macro", 12}, {"xacro:arg", 26},    {"xacro:property", 14}, {"actor", 2},
    {"group", 18},       {"group_state", 19},  {"physics", 11}};

int symbol_kind(std::string_view name) {
  for (const SymbolElement& each : kSymbolElements) {
    if (each.element == name) return each.kind;
  }
  return 0;
}

std::string symbol_name(xml::Element element) {
  for (const std::string_view attribute : {"name", "reference", "filename"}) {
    if (const auto value = element.attribute(attribute); value && !value->value().empty())
      return std::string(value->value());
  }
  if (const auto uri = element.child("uri")) return std::string(uri->text());
  return std::string(element.name());
}

class SymbolTree {
 public:
  explicit SymbolTree(const LineIndex& lines) : lines_(lines) {}

  /// Elements that are no symbols are passed through: what is in them is shown in their place.
  void add(xml::Element element, Json& list) const {
    const int kind = symbol_kind(element.name());
    if (kind == 0) return add_children(element, list);
    Json children = Json::array();
    add_children(element, children);
    Json symbol{{"name", symbol_name(element)},
                {"detail", element.name()},
                {"kind", kind},
                {"range", range_json(lines_, element.span())},
                {"selectionRange", range_json(lines_, element.name_span())}};
    if (!children.empty()) symbol["children"] = std::move(children);
    list.push_back(std::move(symbol));
  }

 private:
  void add_children(xml::Element element, Json& list) const {
    for (const xml::Element child : element.children()) add(child, list);
  }

  const LineIndex& lines_;
};

/// Symbols of a workspace that are listed for a query.
constexpr std::size_t kMaxSymbols = 500;

/// Whether the letters of a query come in the name, in their order.
bool matches(std::string_view name, std::string_view query) {
  for (const char c : name) {
    if (!query.empty() && lower(c) == lower(query[0])) query.remove_prefix(1);
  }
  return query.empty();
}

}  // namespace

Json document_symbols(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  Analysis& analysis = document.analysis(state.environment());
  Json list = Json::array();
  if (const auto root = analysis.written().root()) SymbolTree(document.lines()).add(*root, list);
  return list;
}

/// Links, joints, frames, models and macros of all files, as they are written.
Json workspace_symbols(State& state, const Json& params) {
  const std::string query = text_at(params, "query");
  Json list = Json::array();
  if (state.documents.empty() && state.client.folders.empty()) return list;
  std::vector<std::string> files = state.documents.empty()
                                       ? std::vector<std::string>{}
                                       : workspace_files(state, *state.documents.begin()->second);
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  for (const std::string& path : files) {
    const ReadResult read = state.disk.read(path, read::kMaxModelBytes);
    if (!read.bytes) continue;
    const xml::Document document = xml::parse_own(*read.bytes, SourceId{0});
    const LineIndex lines(*read.bytes, state.client.encoding);
    for (std::uint32_t i = 0; i < document.element_count() && list.size() < kMaxSymbols; ++i) {
      const xml::Element element = document.element(i);
      const auto name = element.attribute("name");
      const int kind = name ? symbol_kind(element.name()) : 0;
      if (kind == 0 || !matches(name->value(), query)) continue;
      list.push_back({{"name", name->value()},
                      {"kind", kind},
                      {"location",
                       {{"uri", uri_of_file(state, path)},
                        {"range", range_json(lines, name->value_span())}}}});
    }
  }
  return list;
}

Json folding_ranges(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  const xml::Document& written = document.analysis(state.environment()).written();
  Json list = Json::array();
  const auto add = [&](Span span, bool is_comment) {
    const std::uint32_t first = document.lines().position(span.begin).line;
    std::uint32_t last = document.lines().position(span.end).line;
    if (!is_comment && last > first) --last;  // the end tag stays to be seen
    if (last <= first) return;
    Json range{{"startLine", first}, {"endLine", last}};
    if (is_comment) range["kind"] = "comment";
    list.push_back(std::move(range));
  };
  for (std::uint32_t i = 0; i < written.element_count(); ++i) add(written.element(i).span(), false);
  for (const xml::Token& token : written.tokens()) {
    if (token.kind == xml::TokenKind::kComment)
      add({written.source(), token.begin, token.end}, true);
  }
  return list;
}

Json selection_ranges(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  const xml::Document& written = document.analysis(state.environment()).written();
  Json list = Json::array();
  for (const Json& position : member(params, "positions")) {
    const std::uint32_t offset = offset_in(document, position);
    std::vector<Span> spans;  // the innermost first
    auto element = written.element_at(offset);
    if (element) {
      for (const xml::Attribute attribute : element->attributes()) {
        for (const Span span : {attribute.value_span(), attribute.span()}) {
          if (span.begin <= offset && offset <= span.end) spans.push_back(span);
        }
      }
      const Span tag = element->tag_span();
      if (tag.begin <= offset && offset < tag.end) spans.push_back(tag);
    }
    for (; element; element = element->parent()) {
      const Span text = element->text_span();
      if (text.size() > 0 && text.begin <= offset && offset <= text.end) spans.push_back(text);
      spans.push_back(element->span());
    }
    spans.push_back({written.source(), 0, static_cast<std::uint32_t>(document.text().size())});
    Json range = nullptr;
    for (auto span = spans.rbegin(); span != spans.rend(); ++span) {
      Json inner{{"range", range_json(document.lines(), *span)}};
      if (!range.is_null()) inner["parent"] = std::move(range);
      range = std::move(inner);
    }
    list.push_back(std::move(range));
  }
  return list;
}

}  // namespace rigor::lsp
