// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What `rigor edit rename OLD NEW FILE` renames; private to `rigor edit`.

#pragma once

#include <string>

#include <rigor/author/names/name_graph.h>

namespace rigor::tool {

struct RenameTarget {
  std::string name;   ///< "elbow", or scoped: "arm::elbow"
  std::string model;  ///< of --model; empty for any
  std::string kind;   ///< of --kind; empty for any
};

/// The one definition in the file that is meant. Throws where there is none, and where there are several.
author::EntityId found_in(author::NameGraph& graph, const Sources& sources, const std::string& file,
                          const RenameTarget& target);

}  // namespace rigor::tool
