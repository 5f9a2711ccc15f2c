// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The name at the cursor, and all places that have it.

#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <rigor/author/names/name_graph.h>
#include <rigor/author/names/rename.h>
#include <rigor/author/names/template_names.h>
#include <rigor/author/names/workspace_files.h>
#include <rigor/lsp/document/analysis.h>
#include <rigor/lsp/session/state.h>

namespace rigor::lsp {

struct NamePlace {
  Span where;
  bool defines = false;
};

struct NameAt {
  Span where;  ///< in the written document
  std::string text;
  std::variant<author::EntityId, author::TemplateName> name;
};

/// The name that a byte offset of the written document is in; nothing where none is known.
std::optional<NameAt> name_at(Analysis& analysis, std::uint32_t offset);

/// Entities whose name an expression at the offset composes: of `${side}_wheel` in a macro, each that a call makes.
/// `files` are those that may call it.
std::vector<NameAt> composed_names_at(Analysis& analysis, std::uint32_t offset,
                                      const std::vector<std::string>& files);

/// Its places in a file and those that the file leads to, and expressions that compose it; spans are of the analysis'
/// sources.
std::vector<NamePlace> places_of(Analysis& analysis, const NameAt& name,
                                 const std::vector<std::string>& files);

/// The workspace's, or that of the document when it has none.
std::vector<std::string> workspace_folders(const State& state, const OpenDocument& document);

/// What may refer to a model of the workspace.
author::WorkspaceFiles files_of_workspace(const State& state, const OpenDocument& document);

/// Its models and templates, and the documents that are open.
std::vector<std::string> workspace_files(const State& state, const OpenDocument& document);

/// Those of the files that may be robots: an SRDF refers to one by its name.
void add_robots(author::NameGraph& graph, const std::vector<std::string>& files);

/// Where a use is written: itself, or the place in a template that it was made of; nowhere when an expression
/// composes the name.
Span written_place(Analysis& analysis, const read::File& file, Span where);

/// The same; when an expression composes the name, that.
Span written_or_composed(Analysis& analysis, const read::File& file, Span where);

}  // namespace rigor::lsp
