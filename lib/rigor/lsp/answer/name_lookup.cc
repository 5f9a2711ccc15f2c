// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/name_lookup.h>

#include <algorithm>
#include <utility>

#include <rigor/author/names/template_rename.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

bool contains(Span span, std::uint32_t offset) {
  return span.begin <= offset && offset <= span.end;
}

std::optional<NameAt> template_name_at(Analysis& analysis, std::uint32_t offset) {
  for (author::TemplateName& name : author::template_names(analysis.written())) {
    for (const Span where : {name.where, name.also}) {
      if (where.nowhere() || !contains(where, offset)) continue;
      std::string text = name.name;
      return NameAt{where, std::move(text), std::move(name)};
    }
  }
  return std::nullopt;
}

/// Of a value or a text with an expression.
bool is_composed_at(const xml::Document& document, std::uint32_t offset) {
  const auto element = document.element_at(offset);
  if (!element) return false;
  const auto composes = [offset](std::string_view value, Span where) {
    return contains(where, offset) && value.find('$') != std::string_view::npos;
  };
  for (const xml::Attribute attribute : element->attributes()) {
    if (composes(attribute.value(), attribute.value_span())) return true;
  }
  return composes(element->text(), element->text_span());
}

std::optional<NameAt> entity_at(Analysis& analysis, std::uint32_t offset) {
  const read::File& file = analysis.file();
  std::optional<NameAt> best;
  for (const author::NameUse& use : analysis.names().uses(analysis.path())) {
    const Span where = written_place(analysis, file, use.where);
    if (where.nowhere() || !contains(where, offset)) continue;
    if (normalize_path(analysis.sources().path(where.source)) != normalize_path(analysis.path()))
      continue;
    if (best && best->where.size() <= where.size()) continue;
    best = NameAt{where, std::string(analysis.sources().bytes(where)), use.target};
  }
  return best;
}

}  // namespace

Span written_place(Analysis& analysis, const read::File& file, Span where) {
  if (!file.expanded) return where;
  const Sources& sources = analysis.sources();
  const read::Origin origin = file.expanded->origin(*file.document, where, sources);
  for (const Span span : {origin.where, origin.from}) {
    if (!span.nowhere() && sources.bytes(span) == sources.bytes(where)) return span;
  }
  return {};
}

Span written_or_composed(Analysis& analysis, const read::File& file, Span where) {
  const Span written = written_place(analysis, file, where);
  if (!written.nowhere() || !file.expanded) return written;
  return file.expanded->origin(*file.document, where, analysis.sources()).where;
}

std::optional<NameAt> name_at(Analysis& analysis, std::uint32_t offset) {
  if (analysis.is_template()) {
    if (auto name = template_name_at(analysis, offset)) return name;
  }
  return entity_at(analysis, offset);
}

std::vector<NameAt> composed_names_at(Analysis& analysis, std::uint32_t offset,
                                      const std::vector<std::string>& files) {
  std::vector<NameAt> names;
  if (!analysis.is_template() || !is_composed_at(analysis.written(), offset)) return names;
  const std::string own = normalize_path(analysis.path());
  const Sources& sources = analysis.sources();
  std::vector<std::string> all = files;
  all.push_back(analysis.path());
  for (const std::string& path : all) {
    const read::File& file = analysis.names().file(path);
    if (!file.expanded) continue;
    for (const author::NameUse& use : analysis.names().uses(path)) {
      const Span where = written_or_composed(analysis, file, use.where);
      if (where.nowhere() || !contains(where, offset)) continue;
      if (normalize_path(sources.path(where.source)) != own) continue;
      names.push_back({where, std::string(sources.bytes(where)), use.target});
    }
  }
  return names;
}

std::vector<NamePlace> places_of(Analysis& analysis, const NameAt& name,
                                 const std::vector<std::string>& files) {
  std::vector<NamePlace> places;
  const auto add = [&places, &analysis](Span where, bool defines) {
    const bool known =
        where.nowhere() || std::any_of(places.begin(), places.end(), [&](const NamePlace& each) {
          return each.where.begin == where.begin && each.where.end == where.end &&
                 analysis.sources().path(each.where.source) ==
                     analysis.sources().path(where.source);
        });
    if (!known) places.push_back({where, defines});
  };
  if (const auto* written = std::get_if<author::TemplateName>(&name.name)) {
    std::vector<std::string> templates = files;
    templates.push_back(analysis.path());
    for (const std::string& path : templates) {
      const read::File& file = analysis.names().file(path);
      for (const author::TemplateUse& use :
           author::template_uses(file, analysis.sources(), *written))
        add(use.where, use.name.defines && use.where == use.name.where);
    }
    return places;
  }
  const auto& target = std::get<author::EntityId>(name.name);
  std::vector<std::string> all = files;
  all.push_back(target.path);
  all.push_back(analysis.path());
  for (std::string& path : all) path = normalize_path(path);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (const std::string& path : all) {
    const read::File& file = analysis.names().file(path);
    for (const author::NameUse& use : analysis.names().uses(path)) {
      if (use.target == target) add(written_or_composed(analysis, file, use.where), use.defines);
    }
  }
  return places;
}

std::vector<std::string> workspace_folders(const State& state, const OpenDocument& document) {
  if (!state.client.folders.empty()) return state.client.folders;
  return {std::string(parent_path(document.path()))};
}

author::WorkspaceFiles files_of_workspace(const State& state, const OpenDocument& document) {
  author::WorkspaceFiles files =
      author::workspace_files(state.disk, workspace_folders(state, document), {});
  for (const auto& [uri, open] : state.documents) files.models.push_back(open->path());
  return files;
}

std::vector<std::string> workspace_files(const State& state, const OpenDocument& document) {
  return files_of_workspace(state, document).models;
}

void add_robots(author::NameGraph& graph, const std::vector<std::string>& files) {
  for (const std::string& path : files) {
    if (extension(path) == ".urdf" || extension(path) == ".xacro") graph.add_robot(path);
  }
}

}  // namespace rigor::lsp
