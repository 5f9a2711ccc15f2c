// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/materials.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <variant>

#include <rigor/read/values.h>
#include <rigor/schema/script_material.h>
#include <rigor/schema/value.h>
#include <rigor/view/drawing/material_script.h>

namespace rigor::view {
namespace {

Color color_of(const std::array<double, 4>& rgba) {
  return {static_cast<float>(rgba[0]), static_cast<float>(rgba[1]), static_cast<float>(rgba[2]),
          static_cast<float>(rgba[3])};
}

/// Three or four numbers, each brought to 0 to 1: consumers do not refuse those outside.
std::optional<Color> parsed_color(std::string_view rest) {
  std::array<double, 4> rgba{0, 0, 0, 1};
  std::size_t count = 0;
  while (!(rest = read::trimmed(rest)).empty()) {
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
    rest.remove_prefix(word.size());
    const auto parsed = schema::parse_double(word);
    const double* number = std::get_if<double>(&parsed);
    if (number == nullptr || std::isnan(*number) || count == rgba.size()) return std::nullopt;
    rgba[count++] = std::clamp(*number, 0.0, 1.0);
  }
  return count >= 3 ? std::optional(color_of(rgba)) : std::nullopt;
}

/// Of `<ambient>` and the like; in SDF 1.0 an attribute of it.
std::optional<Color> child_color(xml::Element material, std::string_view name) {
  const auto element = material.child(name);
  if (!element) return std::nullopt;
  const auto attribute = read::value_attribute(*element, "rgba");
  return parsed_color(attribute ? attribute->text : element->text());
}

std::string script_of(xml::Element material) {
  if (const auto script = material.child("script")) {
    if (const auto name = read::child_text(*script, "name"))
      return std::string(read::trimmed(name->text));
    return std::string(read::trimmed(script->text()));
  }
  const auto attribute = read::value_attribute(material, "script");
  return attribute ? std::string(read::trimmed(attribute->text)) : std::string();
}

std::optional<Color> script_color(std::string_view name) {
  const auto found = schema::find_material(name);
  return found ? std::optional(color_of(found->diffuse)) : std::nullopt;
}

/// What shines by itself is at least as bright as that.
Color lit_by(Color color, const std::optional<Color>& emissive) {
  if (!emissive) return color;
  color.r = std::max(color.r, emissive->r);
  color.g = std::max(color.g, emissive->g);
  color.b = std::max(color.b, emissive->b);
  return color;
}

/// The picture of a color, in either of the workflows of `<pbr>`.
std::optional<read::Text> albedo_map(xml::Element material) {
  const auto pbr = material.child("pbr");
  if (!pbr) return std::nullopt;
  for (const xml::Element workflow : pbr->children()) {
    if (const auto map = read::child_text(workflow, "albedo_map")) return map;
  }
  return std::nullopt;
}

constexpr Color kUntinted{1, 1, 1, 1};

/// More URIs of one script are not examined: real ones have two, of scripts and of textures.
constexpr std::size_t kMaxScripts = 8;

/// Exporters of Collada write a transparency of zero for what is not transparent, which the format reads as
/// invisible. Nobody keeps what cannot be seen, and simulators show it.
Color visible_color(const std::array<float, 4>& diffuse) {
  const auto part = [](float value) {  // a file may say anything
    return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 1.0F;
  };
  const float opacity = part(diffuse[3]);
  return {part(diffuse[0]), part(diffuse[1]), part(diffuse[2]), opacity > 0 ? opacity : 1};
}

}  // namespace

bool Materials::is_urdf(const model::Visual& visual) const {
  if (!visual.link) return root_.format == model::Format::kUrdf;
  const model::Id<model::Model> model = root_[visual.link].model;
  return model && root_[model].format == model::Format::kUrdf;
}

void Materials::put_texture(Surface& surface, const std::string& uri, Span where) {
  if (uri.empty() || !files_.resolve || !files_.picture) return;
  const std::string path = files_.resolve(uri, where);
  if (path.empty()) return;
  surface.texture = files_.picture(path);
  if (surface.texture) surface.texture_path = path;
}

/// Of the first script that has it. Its picture is looked for where the URIs lead, and in the folder `textures`
/// beside.
std::optional<Surface> Materials::of_own_script(xml::Element script, const std::string& name) {
  if (!files_.scripts) return std::nullopt;
  std::vector<read::Text> uris;
  std::string key;
  for (const xml::Element child : script.children()) {
    if (child.name() != "uri" || uris.size() == kMaxScripts) continue;
    uris.push_back({read::trimmed(child.text()), child.text_span()});
    key += std::string(uris.back().text) + '\n';
  }
  const auto [known, is_new] = scripted_.try_emplace({script.span().source, key + name});
  if (!is_new) return known->second;
  for (const read::Text& uri : uris) {
    const auto paint = find_in_script(files_.scripts(std::string(uri.text), uri.span), name);
    if (!paint) continue;
    Surface surface;
    surface.color = paint->diffuse ? color_of(*paint->diffuse) : kUntinted;
    if (!paint->texture.empty()) {
      for (const read::Text& folder : uris) {
        for (const char* between : {"/", "/../textures/", "/../../textures/"}) {
          if (surface.texture) break;
          put_texture(surface, std::string(folder.text) + between + paint->texture, folder.span);
        }
      }
    }
    known->second = surface;
    break;
  }
  return known->second;
}

std::optional<Surface> Materials::of_script(xml::Element material) {
  const std::string name = script_of(material);
  if (name.empty()) return std::nullopt;
  if (const auto color = script_color(name)) return Surface{.color = *color};
  const auto script = material.child("script");
  return script ? of_own_script(*script, name) : std::nullopt;
}

std::optional<Surface> Materials::of_sdf(xml::Element material) {
  const auto diffuse = child_color(material, "diffuse");
  const auto ambient = child_color(material, "ambient");
  const auto emissive = child_color(material, "emissive");
  const auto scripted = of_script(material);
  const auto map = albedo_map(material);
  if (!diffuse && !ambient && !emissive && !scripted && !map) return std::nullopt;
  Surface surface = scripted.value_or(Surface());
  if (map) surface.color = kUntinted;
  if (!scripted) {
    for (const auto& color : {diffuse, ambient, emissive}) {
      if (!color) continue;
      surface.color = *color;
      break;
    }
  } else if (diffuse && !surface.texture) {
    surface.color = *diffuse;
  }
  surface.color = lit_by(surface.color, emissive);
  if (map) put_texture(surface, std::string(read::trimmed(map->text)), map->span);
  return surface;
}

/// Of a URDF's own `<color>` and `<texture>`; nothing where it only has a name.
std::optional<Surface> Materials::of_urdf(xml::Element material) {
  const auto color = material.child("color");
  const auto texture = material.child("texture");
  if (!color && !texture) return std::nullopt;
  Surface surface;
  if (texture) surface.color = kUntinted;
  if (color) {
    const auto rgba = color->attribute("rgba");
    const auto parsed = rgba ? parsed_color(rgba->value()) : std::nullopt;
    if (parsed) surface.color = *parsed;
  }
  if (texture) {
    const auto file = texture->attribute("filename");
    if (file) put_texture(surface, std::string(read::trimmed(file->value())), file->value_span());
  }
  return surface;
}

const Materials::NamedSurfaces& Materials::named() {
  if (named_) return *named_;
  named_.emplace();
  const auto add = [this](const model::Site& site, const std::string& name) {
    const auto element = name.empty() ? std::nullopt : elements_.at(site);
    if (!element || named_->contains({site.span.source, name})) return;
    if (auto surface = of_urdf(*element)) named_->try_emplace({site.span.source, name}, *surface);
  };
  for (const model::RobotMaterial& material : root_.materials) {
    add(material.site, material.name.value);
  }
  for (const model::Visual& visual : root_.visuals) {
    if (visual.material.written && is_urdf(visual)) {
      add(visual.material.site, visual.material.name.value);
    }
  }
  return *named_;
}

std::optional<Surface> Materials::of_urdf(const model::Visual& visual) {
  if (!visual.material.written) return std::nullopt;
  const auto known = named().find({visual.material.site.span.source, visual.material.name.value});
  if (known != named().end()) return known->second;
  const auto element = elements_.at(visual.material.site);
  return element ? of_urdf(*element) : std::nullopt;
}

/// `<gazebo reference="link"><material>Gazebo/Orange</material></gazebo>`
std::optional<Surface> Materials::of_block(const model::Visual& visual) {
  if (!blocks_) {
    blocks_.emplace();
    for (const model::GazeboBlock& block : root_.gazebo_blocks) {
      const auto element = elements_.at(block.site);
      if (!element) continue;
      std::optional<Surface> surface;
      if (const auto material = element->child("material")) {
        const auto value = material->attribute("value");
        const std::string_view name = value ? value->value() : material->text();
        if (const auto color = script_color(read::trimmed(name))) {
          surface = Surface{.color = *color};
        }
      } else if (const auto inner = element->child("visual")) {
        if (const auto inner_material = inner->child("material")) surface = of_sdf(*inner_material);
      }
      if (surface) blocks_->try_emplace({block.site.span.source, block.reference.value}, *surface);
    }
  }
  if (!visual.link) return std::nullopt;
  const auto found = blocks_->find({visual.site.span.source, root_[visual.link].name.value});
  return found == blocks_->end() ? std::nullopt : std::optional(found->second);
}

std::optional<Surface> Materials::written(const model::Visual& visual) {
  if (const auto& rgba = visual.material.rgba) {
    Surface surface;
    surface.color = color_of(*rgba);
    return surface;
  }
  if (is_urdf(visual)) {
    auto own = of_urdf(visual);
    return own ? own : of_block(visual);
  }
  const auto element = visual.material.written ? elements_.at(visual.material.site) : std::nullopt;
  return element ? of_sdf(*element) : std::nullopt;
}

std::vector<Surface> Materials::of_parts(const model::Mesh& shape, const mesh::TriangleMesh& mesh) {
  std::map<std::string_view, Surface> known;
  for (const mesh::Material& material : mesh.materials) {
    Surface surface;
    surface.color = visible_color(material.diffuse);
    surface.texture_opacity = material.picture_opacity;
    if (material.embedded_picture && files_.embedded_picture) {
      surface.texture = files_.embedded_picture(material.embedded_picture);
    }
    if (!material.texture.empty() && files_.texture && files_.picture) {
      const std::string path = files_.texture(shape, material.texture);
      if (!path.empty()) surface.texture = files_.picture(path);
      if (surface.texture) surface.texture_path = path;
    }
    known.try_emplace(material.name, std::move(surface));
  }
  Surface plain;
  if (!mesh.corners.colors.empty()) plain.color = kUntinted;
  std::vector<Surface> surfaces;
  for (const mesh::Part& part : mesh.parts) {
    const auto found = known.find(part.material);
    surfaces.push_back(found == known.end() ? plain : found->second);
  }
  if (surfaces.empty()) surfaces.push_back(plain);
  return surfaces;
}

std::vector<Surface> Materials::of(const model::Visual& visual, const mesh::TriangleMesh& mesh) {
  const auto* shape = std::get_if<model::Mesh>(&visual.geometry.shape);
  const bool keeps_its_own = shape != nullptr && !mesh.materials.empty() && is_urdf(visual);
  const auto own = keeps_its_own ? std::nullopt : written(visual);
  std::vector<Surface> surfaces;
  if (own || shape == nullptr) {
    surfaces = {own.value_or(Surface())};
  } else {
    surfaces = of_parts(*shape, mesh);
  }
  const auto element = is_urdf(visual) ? std::nullopt : elements_.at(visual.site);
  if (!element) return surfaces;
  const double transparency =
      read::number_field(read::child_text(*element, "transparency"), 0).value;
  if (!(transparency > 0)) return surfaces;
  const auto left = static_cast<float>(1 - std::min(transparency, 1.0));
  for (Surface& surface : surfaces) surface.color.a *= left;
  return surfaces;
}

}  // namespace rigor::view
