// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The findings of a document: those of `rigor validate FILE` with the same settings and baseline.

#pragma once

#include <memory>
#include <set>
#include <string>

#include <rigor/lsp/project/project.h>
#include <rigor/rules/baseline.h>
#include <rigor/rules/validate.h>
#include <rigor/text/sources.h>

namespace rigor::lsp {

struct CheckedDocument {
  std::unique_ptr<Sources> sources;
  rules::ValidateResult result;
  std::set<std::string> asked_files;  ///< that it depends on, itself among them; normalized paths
};

/// What `validate` is asked about the file at a path. The project outlives it.
rules::ValidateOptions check_options(const Project& project, const std::string& path,
                                     rules::MeshPolicy meshes);

/// Of the baseline at a path, whose project's files are named by their whole paths here.
rules::BaselinePlace baseline_place(const std::string& path);

/// With kLeaveOut no mesh file is read, as while somebody types, and a robot that has meshes is not assembled: what
/// its other shapes alone show is often wrong.
CheckedDocument check(const EditorDisk& disk, const Project& project, const std::string& path,
                      rules::MeshPolicy meshes,
                      rules::TemplateDepth depth = rules::TemplateDepth::kModel);

/// The same of a text in place of that of the file at a path.
CheckedDocument check_text(const EditorDisk& disk, const Project& project, const std::string& path,
                           std::string text, rules::MeshPolicy meshes);

/// Whether a file is one that `validate` knows, by its name or its root element.
bool is_checked(std::string_view path, std::string_view text);

}  // namespace rigor::lsp
