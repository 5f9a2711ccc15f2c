// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/inspect/inspect.h>

#include <fmt/core.h>

namespace rigor::report {
namespace {

using model::Id;

std::string dot_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c == '\n' || c == '\r' ? ' ' : c;
  }
  return out + '"';
}

/// Links have ids of their own, because names may be doubled.
std::string node(Id<model::Link> link) { return fmt::format("link{}", link.value); }

std::string edge(const Inspection& inspection, Id<model::Joint> id) {
  const model::Frames::Ends& ends = inspection.frames.ends(id);
  if (!ends.child || (!ends.parent && !ends.parent_is_world)) return {};
  const model::Joint& joint = inspection.root[id];
  const std::string label =
      fmt::format("{} ({})", scoped_name(inspection.root, id), to_string(joint.type));
  return fmt::format("  {} -> {} [label={}];\n", ends.parent_is_world ? "world" : node(ends.parent),
                     node(ends.child), dot_string(label));
}

}  // namespace

std::string inspect_dot(const Inspection& inspection) {
  const model::Root& root = inspection.root;
  std::string nodes;
  std::string edges;
  bool to_world = false;
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    nodes += fmt::format("  {} [label={}];\n", node({i}),
                         dot_string(scoped_name(root, Id<model::Link>{i})));
  }
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    edges += edge(inspection, {i});
    to_world = to_world || inspection.frames.ends({i}).parent_is_world;
  }
  if (to_world) nodes = "  world [shape=box];\n" + nodes;
  return fmt::format("digraph {} {{\n{}{}}}\n", dot_string(inspection.path), nodes, edges);
}

}  // namespace rigor::report
