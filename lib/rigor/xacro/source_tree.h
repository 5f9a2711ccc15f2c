// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A file as nodes, with values decoded as XML 1.0 has it: line ends are one LF, blanks in attributes are
// spaces.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/span.h>
#include <rigor/xacro/node.h>

namespace rigor::xacro {

class Heap;
class TextTemplates;

struct NotWellFormed {
  Span where;
  std::string detail;
};

struct SourceTree {
  /// Holds what the file has at its top: comments, the root. Null where there is no root.
  Node* document = nullptr;
  const Node* root = nullptr;
  /// What a strict parser, as the reference has it, refuses the file for.
  std::vector<NotWellFormed> faults;
};

/// `bytes` outlive the nodes, which are added to `nodes`; decoded texts go to the heap, those with a `$` get
/// a number of `templates`.
SourceTree read_source_tree(std::string_view bytes, SourceId source, Nodes& nodes, Heap& heap,
                            TextTemplates& templates);

}  // namespace rigor::xacro
