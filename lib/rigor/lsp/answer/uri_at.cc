// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/uri_at.h>

#include <string_view>

#include <rigor/read/model_config.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

/// The bytes of a value that may be a URI; nowhere for other values.
Span uri_span(xml::Element element) {
  static constexpr std::string_view kTexts[] = {"uri", "albedo_map", "normal_map", "filename",
                                                "texture"};
  for (const std::string_view name : kTexts) {
    if (element.name() == name && element.text_verbatim() && !element.text().empty())
      return element.text_span();
  }
  for (const std::string_view name : {"filename", "url"}) {
    const auto attribute = element.attribute(name);
    if (attribute && attribute->verbatim() && element.name() != "plugin")
      return attribute->value_span();
  }
  return {};
}

/// `$(find PACKAGE)/rest` is `package://PACKAGE/rest`.
std::string as_uri(std::string_view text) {
  constexpr std::string_view kFind = "$(find ";
  const std::size_t close = text.find(')');
  if (!text.starts_with(kFind) || close == std::string_view::npos) return std::string(text);
  return "package://" + std::string(text.substr(kFind.size(), close - kFind.size())) +
         std::string(text.substr(close + 1));
}

std::optional<FileReference> reference_of(const State& state, const Analysis& analysis,
                                          xml::Element element) {
  const Span where = uri_span(element);
  if (where.nowhere() || where.size() == 0) return std::nullopt;
  std::string_view text = analysis.text().substr(where.begin, where.size());
  if (text.find_first_of("\r\n") != std::string_view::npos) return std::nullopt;
  const std::string uri = as_uri(text);
  if (uri.find('$') != std::string::npos) return std::nullopt;
  const read::Resolution found = state.environment().resolver.resolve(uri, analysis.path());
  if (!found.path) return std::nullopt;
  return FileReference{where, *found.path};
}

}  // namespace

std::vector<FileReference> file_references(const State& state, Analysis& analysis) {
  std::vector<FileReference> references;
  const xml::Document& document = analysis.written();
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    if (auto reference = reference_of(state, analysis, document.element(i)))
      references.push_back(*reference);
  }
  return references;
}

std::optional<FileReference> reference_at(const State& state, Analysis& analysis,
                                          std::uint32_t offset) {
  const auto element = analysis.written().element_at(offset);
  if (!element) return std::nullopt;
  auto reference = reference_of(state, analysis, *element);
  if (!reference || offset < reference->where.begin || offset > reference->where.end)
    return std::nullopt;
  return reference;
}

std::optional<std::string> path_at(const State& state, Analysis& analysis, std::uint32_t offset) {
  const auto reference = reference_at(state, analysis, offset);
  if (!reference) return std::nullopt;
  if (state.disk.kind(reference->path) != PathKind::kFolder) return reference->path;
  const std::string config = join_path(reference->path, "model.config");
  const ReadResult bytes = state.disk.read(config, read::kMaxModelBytes);
  if (!bytes.bytes) return std::nullopt;
  const read::ModelConfig read = read::read_model_config(xml::parse_own(*bytes.bytes, SourceId{0}));
  const read::SdfEntry* entry = read::choose(read);
  return entry == nullptr ? config : join_path(reference->path, entry->file.value);
}

}  // namespace rigor::lsp
