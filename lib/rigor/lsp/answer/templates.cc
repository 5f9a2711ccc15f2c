// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Templates: what they expand to, and which macros call which.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <rigor/author/names/template_rename.h>
#include <rigor/lsp/answer/answers.h>
#include <rigor/lsp/answer/edits_json.h>
#include <rigor/lsp/answer/name_lookup.h>
#include <rigor/lsp/protocol/uri.h>
#include <rigor/report/rules/explain.h>
#include <rigor/rules/example.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

/// Of the protocol's SymbolKind.
constexpr int kFileSymbol = 1;
constexpr int kFunctionSymbol = 12;

/// Of a macro, or of a file that calls some outside of any.
struct MacroSite {
  std::string name;
  int kind = kFunctionSymbol;
  std::string uri;
  Json range;      // of the whole element
  Json selection;  // of the name
};

Json item_json(const MacroSite& site) {
  return {{"name", site.name},
          {"kind", site.kind},
          {"uri", site.uri},
          {"range", site.range},
          {"selectionRange", site.selection}};
}

/// All macros and calls in the files that an open document's template reads.
struct MacroCalls {
  std::map<std::string, MacroSite> macros;  ///< and files, by their URIs
  struct Call {
    std::string from;  ///< the macro around it; the file's URI at its top
    std::string to;
    Json range;
  };
  std::vector<Call> calls;
};

MacroCalls macro_calls_of(State& state, Analysis& analysis) {
  MacroCalls result;
  const read::File& file = analysis.file();
  if (!file.expanded) return result;
  for (const xacro::FileUse& use : file.expanded->expansion().files) {
    if (use.source == kNoSource) continue;
    const std::string_view bytes = analysis.sources().bytes(use.source);
    const LineIndex lines(bytes, state.client.encoding);
    const xml::Document document = xml::parse_own(bytes, use.source);
    const auto names = author::template_names(document);
    const std::string_view path = analysis.sources().path(use.source);
    const std::string uri = uri_of_file(state, path);
    const Json top = range_json(lines, 0, 0);
    result.macros[uri] = {std::string(file_name(path)), kFileSymbol, uri, top, top};
    for (const author::TemplateName& name : names) {
      if (name.kind != author::TemplateNameKind::kMacro) continue;
      if (name.defines) {
        result.macros[name.name] = {name.name, kFunctionSymbol, uri,
                                    range_json(lines, name.element), range_json(lines, name.where)};
        continue;
      }
      std::string around = uri;
      for (const author::TemplateName& outer : names) {
        const bool holds =
            outer.element.begin < name.where.begin && name.where.end < outer.element.end;
        if (outer.kind == author::TemplateNameKind::kMacro && outer.defines && holds)
          around = outer.name;
      }
      result.calls.push_back({around, name.name, range_json(lines, name.where)});
    }
  }
  return result;
}

/// The calls of whichever open document reads the macro's file.
MacroCalls calls_about(State& state, const Json& item) {
  for (const auto& [uri, document] : state.documents) {
    Analysis& analysis = document->up_to_date(state.environment());
    if (!analysis.is_template()) continue;
    MacroCalls calls = macro_calls_of(state, analysis);
    const auto macro = calls.macros.find(text_at(item, "name"));
    if (macro != calls.macros.end() && macro->second.uri == text_at(item, "uri")) return calls;
  }
  return {};
}

}  // namespace

Json prepared_call_hierarchy(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  Analysis& analysis = document.up_to_date(state.environment());
  const std::uint32_t offset =
      document.to_readable(offset_in(document, member(params, "position")));
  const auto name = name_at(analysis, offset);
  if (!name) return nullptr;
  const auto* written = std::get_if<author::TemplateName>(&name->name);
  if (written == nullptr || written->kind != author::TemplateNameKind::kMacro) return nullptr;
  const MacroCalls calls = macro_calls_of(state, analysis);
  const auto macro = calls.macros.find(written->name);
  return macro == calls.macros.end() ? Json(nullptr) : Json::array({item_json(macro->second)});
}

Json incoming_calls(State& state, const Json& params) {
  const Json& item = member(params, "item");
  const MacroCalls calls = calls_about(state, item);
  std::map<std::string, Json> by_caller;
  for (const MacroCalls::Call& call : calls.calls) {
    if (call.to == text_at(item, "name") && calls.macros.contains(call.from))
      by_caller[call.from].push_back(call.range);
  }
  Json list = Json::array();
  for (auto& [from, ranges] : by_caller)
    list.push_back({{"from", item_json(calls.macros.at(from))}, {"fromRanges", std::move(ranges)}});
  return list;
}

Json outgoing_calls(State& state, const Json& params) {
  const Json& item = member(params, "item");
  const MacroCalls calls = calls_about(state, item);
  std::map<std::string, Json> by_callee;
  for (const MacroCalls::Call& call : calls.calls) {
    if (call.from == text_at(item, "name") && calls.macros.contains(call.to))
      by_callee[call.to].push_back(call.range);
  }
  Json list = Json::array();
  for (auto& [to, ranges] : by_callee)
    list.push_back({{"to", item_json(calls.macros.at(to))}, {"fromRanges", std::move(ranges)}});
  return list;
}

/// `{"textDocument": …}` → `{"text": …}`: what `rigor expand` prints.
Json expanded_template(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  const read::File& file = document.up_to_date(state.environment()).file();
  if (!file.expanded || !file.document)
    throw RequestError(ErrorCode::kRequestFailed, "the document is no template");
  return {{"text", file.document->bytes()}};
}

/// `{"rule": …}` → `{"text": …}`: what `rigor explain` prints.
Json explained_rule(State& state, const Json& params) {
  const rules::Rule* rule = state.environment().registry.find(text_at(params, "rule"));
  if (rule == nullptr) throw RequestError(ErrorCode::kInvalidParams, "no such rule");
  return {{"text", report::explain(*rule, rules::examples_of(*rule))}};
}

}  // namespace rigor::lsp
