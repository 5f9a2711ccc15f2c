// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/lookups.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <variant>

#include <rigor/read/values.h>
#include <rigor/schema/value.h>

namespace rigor::robot {
namespace {

constexpr double kAmbientShare = 0.4;  // of what Gazebo's renderer adds up
constexpr double kDiffuseShare = 0.8;

/// The element that a site names, where its file is still known.
std::optional<xml::Element> element_at(read::Workspace& workspace, const model::Site& site) {
  if (site.span.nowhere()) return std::nullopt;
  const std::string path(workspace.sources().path(site.span.source));
  const read::File& file = workspace.open(path);
  if (!file.document || file.source != site.span.source) return std::nullopt;
  return file.document->element(site.element);
}

/// Three or four numbers between blanks; opacity is 1 where it is not written.
std::optional<Color> parse_rgba(std::string_view text) {
  std::array<double, 4> numbers{0, 0, 0, 1};
  std::size_t count = 0;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (text.empty()) break;
    const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
    text.remove_prefix(word.size());
    const auto parsed = schema::parse_double(word);
    const double* number = std::get_if<double>(&parsed);
    if (number == nullptr || count == numbers.size()) return std::nullopt;
    numbers[count++] = *number;
  }
  if (count < 3) return std::nullopt;
  return Color{numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::optional<Color> urdf_color(const xml::Element& material) {
  const auto color = material.child("color");
  const auto rgba = color ? color->attribute("rgba") : std::nullopt;
  return rgba ? parse_rgba(rgba->value()) : std::nullopt;
}

/// `visual` is the element that holds the material.
std::optional<Color> sdf_color(const xml::Element& visual, const xml::Element& material) {
  if (material.child("script")) return std::nullopt;
  const auto read = [&material](std::string_view name) {
    const auto element = material.child(name);
    return element ? parse_rgba(element->text()) : std::nullopt;
  };
  const std::optional<Color> ambient = read("ambient"), diffuse = read("diffuse");
  if (!ambient && !diffuse) return std::nullopt;
  const Color a = ambient.value_or(diffuse.value_or(Color{})), d = diffuse.value_or(a);
  const bool one = a.r == d.r && a.g == d.g && a.b == d.b;
  const auto part = [one](double of_ambient, double of_diffuse) {
    const double sum = kAmbientShare * of_ambient + kDiffuseShare * of_diffuse;
    return std::clamp(one ? of_diffuse : sum, 0.0, 1.0);
  };
  Color color{part(a.r, d.r), part(a.g, d.g), part(a.b, d.b), std::clamp(d.a, 0.0, 1.0)};
  if (const auto transparency = visual.child("transparency")) {
    const auto parsed = schema::parse_double(transparency->text());
    if (const double* share = std::get_if<double>(&parsed)) {
      color.a *= 1 - std::clamp(*share, 0.0, 1.0);
    }
  }
  return color;
}

using NamedColors = std::map<std::string, std::optional<Color>>;

/// Of a URDF, by the material's name: urdfdom takes the robot's own, else the first that a visual
/// defines, and whatever else a visual says under that name counts for nothing.
NamedColors named_colors(const model::Root& root, read::Workspace& workspace) {
  NamedColors colors;
  for (const model::RobotMaterial& material : root.materials) {
    const auto element = element_at(workspace, material.site);
    if (element) colors.try_emplace(material.name.value, urdf_color(*element));
  }
  if (root.format != model::Format::kUrdf) return colors;
  for (const model::Visual& visual : root.visuals) {
    const model::Material& material = visual.material;
    if (!material.defines_color || colors.contains(material.name.value)) continue;
    const auto element = element_at(workspace, material.site);
    if (element) colors.emplace(material.name.value, urdf_color(*element));
  }
  return colors;
}

using Springs = std::map<std::string, std::array<double, 2>>;

Springs springs_of(const model::Root& root) {
  Springs springs;
  for (const model::GazeboBlock& block : root.gazebo_blocks) {
    auto& [reference, stiffness] = springs[block.reference.value];
    const auto take = [&block](double& out, std::string_view name) {
      const auto* given = find(block.content, name);
      const auto number = given != nullptr ? read::number_field(*given) : model::Field<double>{};
      if (number.written) out = number.value;
    };
    take(reference, "springReference");
    take(stiffness, "springStiffness");
  }
  return springs;
}

std::optional<Color> color_of(const model::Root& root, read::Workspace& workspace,
                              const NamedColors& named, const model::Visual& visual) {
  if (const auto& rgba = visual.material.rgba)
    return Color{(*rgba)[0], (*rgba)[1], (*rgba)[2], (*rgba)[3]};
  if (!visual.material.written) return std::nullopt;
  const auto element = element_at(workspace, visual.material.site);
  if (!element) return std::nullopt;
  if (root[root[visual.link].model].format != model::Format::kUrdf) {
    const auto holder = element->parent();
    return holder ? sdf_color(*holder, *element) : std::nullopt;
  }
  const std::string& name = visual.material.name.value;
  const auto found = name.empty() ? named.end() : named.find(name);
  return found == named.end() ? urdf_color(*element) : found->second;
}

}  // namespace

Lookups lookups_in(const model::Root& root, read::Workspace& workspace,
                   const read::Resolver& resolver) {
  Lookups lookups;
  lookups.find_file = [&workspace, &resolver](const std::string& uri, SourceId from) {
    const std::string file(workspace.sources().path(from));
    return workspace.resolve(resolver, uri, file).path.value_or("");
  };
  lookups.color_of = [&root, &workspace,
                      named = named_colors(root, workspace)](model::Id<model::Visual> id) {
    return color_of(root, workspace, named, root[id]);
  };
  lookups.spring = [&root, springs = springs_of(root)](model::Id<model::Joint> id) {
    const auto found = springs.find(root[id].name.value);
    return found == springs.end() ? std::array<double, 2>{} : found->second;
  };
  return lookups;
}

}  // namespace rigor::robot
