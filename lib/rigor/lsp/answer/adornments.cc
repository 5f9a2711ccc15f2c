// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What an editor shows in and beside the text: links, colors, hints, token colors, lenses.

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/author/names/template_names.h>
#include <rigor/lsp/answer/answers.h>
#include <rigor/lsp/answer/edits_json.h>
#include <rigor/lsp/answer/uri_at.h>
#include <rigor/mass/resolve.h>
#include <rigor/report/number.h>

namespace rigor::lsp {
namespace {

using Rgba = std::array<double, 4>;

/// Red, green, blue and, where it is there, alpha: from 0 to 1.
std::optional<Rgba> color_in(std::string_view text) {
  Rgba color{0, 0, 0, 1};
  std::size_t count = 0;
  const char* at = text.data();
  const char* end = at + text.size();
  while (true) {
    while (at != end && (*at == ' ' || *at == '\t' || *at == '\n' || *at == '\r')) ++at;
    if (at == end) break;
    if (count == color.size()) return std::nullopt;
    const auto [past, error] = std::from_chars(at, end, color[count]);
    if (error != std::errc() || color[count] < 0 || color[count] > 1) return std::nullopt;
    ++count;
    at = past;
  }
  return count >= 3 ? std::optional(color) : std::nullopt;
}

Span color_span(xml::Element element) {
  static constexpr std::array<std::string_view, 8> kTexts{"ambient",  "diffuse",    "specular",
                                                          "emissive", "background", "shadow_color",
                                                          "color",    "sky_color"};
  if (const auto rgba = element.attribute("rgba"); rgba && rgba->verbatim())
    return rgba->value_span();
  const bool is_text = std::find(kTexts.begin(), kTexts.end(), element.name()) != kTexts.end();
  return is_text && element.text_verbatim() ? element.text_span() : Span{};
}

/// Of the legend of `semantic_tokens`.
enum class TokenType : std::uint8_t { kMacro, kParameter, kProperty, kArgument };
constexpr std::array<std::string_view, 4> kTokenTypes{"macro", "parameter", "property", "variable"};

/// Commands of the client that a lens may call on the document, with their titles.
struct LensCommand {
  std::string_view command;
  std::string_view title;
};
constexpr std::array<LensCommand, 2> kLensCommands{
    {{"rigor.simulate", "simulate"}, {"rigor.view", "view"}}};

std::string count_of(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

struct HintList {
  const OpenDocument& document;
  std::uint32_t begin;
  std::uint32_t end;
  Json list = Json::array();

  void add(Span tag, const std::string& label) {
    if (tag.nowhere() || tag.end < begin || tag.begin > end) return;
    list.push_back({{"position", position_json(document.lines().position(tag.end))},
                    {"label", label},
                    {"paddingLeft", true}});
  }
};

}  // namespace

Json document_links(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  Json list = Json::array();
  for (const FileReference& reference :
       file_references(state, document.analysis(state.environment()))) {
    if (state.disk.kind(reference.path) == PathKind::kFolder) continue;
    list.push_back({{"range", range_json(document.lines(), reference.where)},
                    {"target", uri_of_file(state, reference.path)}});
  }
  return list;
}

Json document_colors(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  const xml::Document& written = document.analysis(state.environment()).written();
  Json list = Json::array();
  for (std::uint32_t i = 0; i < written.element_count(); ++i) {
    const Span where = color_span(written.element(i));
    if (where.nowhere() || where.size() == 0) continue;
    const auto color = color_in(written.bytes().substr(where.begin, where.size()));
    if (!color) continue;
    list.push_back({{"range", range_json(document.lines(), where)},
                    {"color",
                     {{"red", (*color)[0]},
                      {"green", (*color)[1]},
                      {"blue", (*color)[2]},
                      {"alpha", (*color)[3]}}}});
  }
  return list;
}

Json color_presentations(State&, const Json& params) {
  std::string label;
  for (const std::string_view part : {"red", "green", "blue", "alpha"}) {
    const Json& value = member(params, "color", part);
    const double number = value.is_number() ? value.get<double>() : 0;
    label += (label.empty() ? "" : " ") + report::number(number, 3);
  }
  return Json::array(
      {{{"label", label}, {"textEdit", {{"range", member(params, "range")}, {"newText", label}}}}});
}

/// Masses of links that do not say theirs in the file, and where poses lead that are relative to other frames.
Json inlay_hints(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  Analysis& analysis = document.analysis(state.environment());
  if (!analysis.written().complete()) return Json::array();
  HintList hints{document, offset_in(document, member(params, "range", "start")),
                 offset_in(document, member(params, "range", "end"))};
  const model::Root& root = analysis.loaded().root;
  if (root.format != model::Format::kSdf && root.format != model::Format::kUrdf) return hints.list;
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    const model::Link& link = root.links[i];
    if (!root.own(link.site) || analysis.is_template()) continue;
    const auto X_ML = analysis.frames().pose(model::Id<model::Link>{i});
    std::string label =
        report::number(mass::resolve(root, model::Id<model::Link>{i}).mass, 4) + " kg";
    if (X_ML && !link.pose.relative_to.value.empty())
      label += fmt::format(", at {}", report::numbers(X_ML->translation, 4));
    hints.add(analysis.written_span(link.site.tag), label);
  }
  return hints.list;
}

Json semantic_token_types() { return kTokenTypes; }

/// Of xacro: macros, parameters, properties and arguments, wherever they are used.
Json semantic_tokens(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  Analysis& analysis = document.analysis(state.environment());
  Json data = Json::array();
  if (!analysis.is_template()) return {{"data", data}};
  struct Placed {
    Span where;
    TokenType type;
    bool defines;
  };
  std::vector<Placed> tokens;
  for (const author::TemplateName& name : author::template_names(analysis.written())) {
    for (const Span where : {name.where, name.also}) {
      if (!where.nowhere())
        tokens.push_back({where, static_cast<TokenType>(name.kind), name.defines});
    }
  }
  std::sort(tokens.begin(), tokens.end(),
            [](const Placed& a, const Placed& b) { return a.where.begin < b.where.begin; });
  TextPosition last;
  std::uint32_t past = 0;
  for (const Placed& token : tokens) {
    const TextPosition begin = document.lines().position(token.where.begin);
    const TextPosition end = document.lines().position(token.where.end);
    if (begin.line != end.line || token.where.begin < past) continue;
    const bool same_line = begin.line == last.line;
    for (const std::uint32_t number :
         {begin.line - last.line, same_line ? begin.character - last.character : begin.character,
          end.character - begin.character, static_cast<std::uint32_t>(token.type),
          token.defines ? 1U : 0U})
      data.push_back(number);
    last = begin;
    past = token.where.end;
  }
  return {{"data", std::move(data)}};
}

/// At each model of the file: what it has, what it weighs, and what the client can do with it.
Json code_lenses(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  Analysis& analysis = document.analysis(state.environment());
  Json list = Json::array();
  if (!analysis.written().complete()) return list;
  const model::Root& root = analysis.loaded().root;
  for (std::uint32_t i = 0; i < root.models.size(); ++i) {
    const model::Model& model = root.models[i];
    const Span where = analysis.written_span(model.site.name);
    if (where.nowhere() || model.include != 0xffffffffU) continue;
    double mass = 0;
    for (const model::Id<model::Link> link : model.links) mass += mass::resolve(root, link).mass;
    const std::string title =
        fmt::format("{}, {}, {} kg", count_of(model.links.size(), "link"),
                    count_of(model.joints.size(), "joint"), report::number(mass, 4));
    list.push_back({{"range", range_json(document.lines(), where)},
                    {"command", {{"title", title}, {"command", ""}}}});
    for (const auto& [command, text] : kLensCommands) {
      const auto& known = state.client.commands;
      if (std::find(known.begin(), known.end(), command) == known.end()) continue;
      list.push_back({{"range", range_json(document.lines(), where)},
                      {"command",
                       {{"title", text},
                        {"command", command},
                        {"arguments", Json::array({document.uri()})}}}});
    }
  }
  return list;
}

}  // namespace rigor::lsp
