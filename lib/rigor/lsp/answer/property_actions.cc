// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/property_actions.h>

#include <string>
#include <utility>

#include <rigor/author/names/template_property.h>
#include <rigor/lsp/answer/edits_json.h>
#include <rigor/lsp/answer/name_lookup.h>

namespace rigor::lsp {
namespace {

constexpr std::string_view kExtract = "extract property";
constexpr std::string_view kInline = "inline property";

Json deferred(const OpenDocument& document, std::string title, std::string_view kind,
              std::string_view what, Span where) {
  return {{"title", std::move(title)},
          {"kind", kind},
          {"data",
           {{"what", what},
            {"uri", document.uri()},
            {"version", document.version()},
            {"begin", where.begin},
            {"end", where.end}}}};
}

std::optional<author::TemplateName> property_at(const xml::Document& written,
                                                std::uint32_t offset) {
  for (author::TemplateName& name : author::template_names(written)) {
    if (name.kind == author::TemplateNameKind::kProperty && name.where.begin <= offset &&
        offset <= name.where.end)
      return std::move(name);
  }
  return std::nullopt;
}

}  // namespace

std::vector<Json> property_actions(State& state, OpenDocument& document, std::uint32_t begin,
                                   std::uint32_t end) {
  std::vector<Json> actions;
  Analysis& analysis = document.analysis(state.environment());
  const xml::Document& written = analysis.written();
  if (!analysis.is_template() || !written.complete()) return actions;
  if (const auto name = property_at(written, begin)) {
    actions.push_back(deferred(document, "inline property '" + name->name + "'", "refactor.inline",
                               kInline, name->where));
    return actions;
  }
  const Span value = author::extractable_value(written, {written.source(), begin, end});
  if (value.nowhere()) return actions;
  actions.push_back(
      deferred(document, "extract to property '" + author::proposed_property(written, value) + "'",
               "refactor.extract", kExtract, value));
  return actions;
}

std::optional<Json> property_edit(State& state, OpenDocument& document, const Json& data) {
  const std::string what = text_at(data, "what");
  if (what != kExtract && what != kInline) return std::nullopt;
  Analysis fresh(state.environment(), document.path(), document.text());
  const xml::Document& written = fresh.written();
  const auto size = static_cast<std::int64_t>(document.text().size());
  const std::int64_t begin = number_at(data, "begin");
  const std::int64_t end = number_at(data, "end");
  if (begin < 0 || end < begin || end > size)
    throw RequestError(ErrorCode::kInvalidParams, "no such place");
  const Span where{written.source(), static_cast<std::uint32_t>(begin),
                   static_cast<std::uint32_t>(end)};
  std::vector<std::string> templates = workspace_files(state, document);
  templates.push_back(document.path());
  const author::RenameContext context{fresh.names(), state.environment().resolver, fresh.sources()};
  author::Renaming change;
  if (what == kExtract) {
    change = author::extracted_property(context, templates, written, where,
                                        author::proposed_property(written, where));
  } else if (const auto name = property_at(written, where.begin)) {
    change = author::inlined_property(context, templates, *name);
  } else {
    throw RequestError(ErrorCode::kInvalidParams, "no property is here");
  }
  if (!change.refused.empty())
    throw RequestError(ErrorCode::kRequestFailed, "the property stays: " + change.refused);
  return workspace_edit(state, fresh.sources(), change.edits);
}

}  // namespace rigor::lsp
