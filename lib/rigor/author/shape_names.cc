// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/shape_names.h>

#include <algorithm>
#include <cstddef>

namespace rigor::author {
namespace {

template <class Part>
void add(const model::Root& root, model::Id<model::Link> link,
         const std::vector<model::Id<Part>>& parts, const std::string& kind,
         std::vector<ShapeName>& names) {
  const std::string outer = scoped_name(root, link) + "::";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string& name = root[parts[i]].name.value;
    const std::string with_kind =
        outer + kind + ' ' + (name.empty() ? std::to_string(i + 1) : name);
    const std::string by_kind = parts.size() == 1 ? outer + kind : std::string();
    const std::string& unnamed = by_kind.empty() ? with_kind : by_kind;
    names.push_back({parts[i], name.empty() ? unnamed : outer + name, with_kind, by_kind});
  }
}

template <class Means>
std::vector<ShapeName> those(const std::vector<ShapeName>& all, Means means) {
  std::vector<ShapeName> found;
  for (const ShapeName& shape : all) {
    if (means(shape.plain) || means(shape.with_kind) || means(shape.by_kind)) {
      found.push_back(shape);
    }
  }
  return found;
}

}  // namespace

std::vector<ShapeName> shape_names(const model::Root& root) {
  std::vector<ShapeName> names;
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    add(root, {i}, root.links[i].collisions, "collision", names);
    add(root, {i}, root.links[i].visuals, "visual", names);
  }
  return names;
}

std::vector<ShapeName> find_shapes(const std::vector<ShapeName>& all, std::string_view name) {
  auto whole = those(all, [name](const std::string& full) { return full == name; });
  if (!whole.empty()) return whole;
  const std::string end = "::" + std::string(name);
  return those(all, [&end](const std::string& full) { return full.ends_with(end); });
}

std::vector<ShapeName> neighbors(const std::vector<ShapeName>& all, std::string_view name) {
  const std::size_t inner = name.rfind("::");
  if (inner == std::string_view::npos) return {};
  const std::string link = "::" + std::string(name.substr(0, inner));
  return those(all, [&link](const std::string& full) {
    const std::string_view outer = std::string_view(full).substr(0, full.rfind("::"));
    return ("::" + std::string(outer)).ends_with(link);
  });
}

std::string to_type(const std::vector<ShapeName>& all, const ShapeName& shape) {
  const auto same = [&shape](const ShapeName& other) { return other.plain == shape.plain; };
  return std::count_if(all.begin(), all.end(), same) == 1 ? shape.plain : shape.with_kind;
}

}  // namespace rigor::author
