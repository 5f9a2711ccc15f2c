// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// URIs of documents, and the paths that they mean (RFC 8089; RFC 3986 for the escapes).
//
//   path_of_uri("file:///home/me/my%20robot.sdf");   // "/home/me/my robot.sdf"

#pragma once

#include <string>
#include <string_view>

namespace rigor::lsp {

/// Of a URI with another scheme, as an editor gives to what was never saved, all of it: such a document has a
/// name and is on no disk.
std::string path_of_uri(std::string_view uri);

/// A path that has a scheme already is a URI.
std::string uri_of_path(std::string_view path);

}  // namespace rigor::lsp
