// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/schema_place.h>

#include <fmt/core.h>

#include <rigor/lsp/document/xacro_tags.h>

namespace rigor::lsp {
namespace {

std::optional<schema::Node> sdf_root(const Environment& environment, std::string_view version) {
  const auto parsed = schema::parse_version(version);
  return environment.sdf.root("sdf",
                              parsed ? environment.sdf.nearest(*parsed) : environment.sdf.latest());
}

/// In <gazebo>: whichever of SDF's elements has the child.
std::optional<schema::Node> in_gazebo(const Environment& environment, std::string_view name) {
  const auto root = sdf_root(environment, "");
  const auto model = root ? root->child("model") : std::nullopt;
  if (!model) return std::nullopt;
  for (const std::string_view parent : {"link", "joint"}) {
    const auto node = model->child(parent);
    if (const auto child = node ? node->child(name) : std::nullopt) return child;
  }
  return model->child(name);
}

}  // namespace

std::optional<schema::Node> schema_place(const Environment& environment,
                                         const std::vector<std::string_view>& path,
                                         std::string_view version) {
  std::optional<schema::Node> node;
  bool in_sdf_block = false;
  for (const std::string_view name : path) {
    if (is_of_xacro(name)) continue;
    if (in_sdf_block) {
      node = in_gazebo(environment, name);
      in_sdf_block = false;
    } else if (node) {
      node = node->child(name);
    } else if (name == "sdf") {
      node = sdf_root(environment, version);
    } else {
      node = environment.urdf.root(name, environment.urdf.latest());
    }
    if (!node) return std::nullopt;
    in_sdf_block = name == "gazebo";
  }
  return node;
}

std::string schema_text(const schema::Node& node) {
  std::string text = fmt::format("**{}**", node.name());
  if (!schema::to_string(node.type()).empty())
    text += fmt::format(" `{}`", schema::to_string(node.type()));
  if (const auto count = node.count(); count && count->most != 1)
    text += fmt::format(", {}", schema::to_string(*count));
  if (!node.unit().empty()) text += fmt::format(" in {}", node.unit());
  if (!node.doc().empty()) text += fmt::format("\n\n{}", node.doc());
  std::string facts;
  if (const auto value = node.default_value(); value && !value->empty())
    facts += fmt::format("Default `{}`. ", *value);
  if (const auto least = node.minimum()) facts += fmt::format("At least {}. ", *least);
  if (const auto most = node.maximum()) facts += fmt::format("At most {}. ", *most);
  if (!node.enumeration().empty()) {
    facts += "One of";
    for (const std::string_view value : node.enumeration()) facts += fmt::format(" `{}`", value);
    facts += ". ";
  }
  facts += fmt::format("Since {}", schema::to_string(node.since()));
  if (const auto until = node.until())
    facts += fmt::format(", until {}", schema::to_string(*until));
  if (const auto deprecated = node.deprecated_since()) {
    facts += fmt::format("; deprecated since {}", schema::to_string(*deprecated));
    if (!node.instead().empty()) facts += fmt::format(", use `{}`", node.instead());
  }
  return text + "\n\n" + facts + ".";
}

}  // namespace rigor::lsp
