// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Paths as text: UTF-8 with '/' between the parts, never looked up on a disk.
//
//   join_path("models/arm", "../meshes/a.stl");     // "models/meshes/a.stl"
//   parent_path("models/arm/model.sdf");            // "models/arm"

#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// Whether nothing in a path is to be removed: no part is empty or begins with a dot. Most paths are like that.
bool is_normal(std::string_view path);

/// Removes `.`, empty parts and, where a part stands before it, `..`. "" becomes ".".
std::string normalize_path(std::string_view path);

/// `path` seen from `folder`, normalized; `path` itself when it is absolute.
std::string join_path(std::string_view folder, std::string_view path);

/// The other way: `path` as it is written in `folder`, "../meshes/a.stl". `path` itself, normalized, when
/// that cannot be said: only one of them is absolute, or the folder lies above where both begin.
std::string relative_path(std::string_view folder, std::string_view path);

/// All but the last part: "." for a bare name, "/" for a name in the root.
std::string_view parent_path(std::string_view path);

/// The folder that a folder lies in, which of "." is ".."; the path itself at the top.
std::string enclosing_folder(const std::string& path);

/// The last part.
std::string_view file_name(std::string_view path);

/// The last part's ending with its dot, in lower case: ".sdf"; empty when it has none.
std::string extension(std::string_view path);

/// Whether a file is a model, a mesh, a material or a picture by its ending. Who reads one takes its bytes for nothing
/// else: a YAML reader refuses it, whose errors and values would tell what stands there.
bool is_model_data(std::string_view path);

bool is_absolute(std::string_view path);

}  // namespace rigor
