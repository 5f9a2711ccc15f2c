// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/mjcf/look.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include <rigor/text/path.h>
#include <rigor/write/safe_name.h>

namespace rigor::convert {
namespace {

/// A mesh of more looks is one geom without any.
constexpr std::size_t kMaxGroups = 100;

std::string rgba_of(const robot::Color& c) { return mjcf_numbers({c.r, c.g, c.b, c.a}); }

std::string type_of(const MjcfElement& geom) {
  for (const auto& [name, value] : geom.attributes) {
    if (name == "type") return value;
  }
  return {};
}

/// The name of the texture asset.
std::string texture_of(MjcfDraft& draft, const robot::Look& look, bool cube) {
  const std::string type = cube ? "cube" : "2d";
  std::string& known = draft.texture_names[type + '\n' + look.picture];
  if (!known.empty()) return known;
  const std::string_view file = file_name(look.picture);
  const bool held = look.picture.starts_with('#');
  std::string stem = held ? "texture" : write::safe_name(file.substr(0, file.rfind('.')));
  if (cube) stem += "_cube";
  known = draft.name_for("texture", stem);
  const std::string name = draft.name_for("file", stem) + ".png";
  const auto shape = cube ? robot::PictureShape::kSquare : robot::PictureShape::kAsItIs;
  draft.files.push_back({std::string(kMjcfAssetFolder) + name, look.png(shape)});
  draft.asset.add({"texture", {{"type", type}, {"name", known}, {"file", name}}});
  return known;
}

bool same(const robot::Look& a, const robot::Look& b) {
  return a.color == b.color && a.picture == b.picture;
}

}  // namespace

void set_mjcf_look(MjcfDraft& draft, MjcfElement& geom, const std::string& name,
                   const robot::Look& look) {
  const std::string rgba = rgba_of(look.color);
  if (name.empty() && look.picture.empty()) return geom.set("rgba", rgba);
  std::string texture;
  if (!look.picture.empty()) {
    const std::string type = type_of(geom);
    texture = texture_of(draft, look, type != "mesh" && type != "plane");
  }
  std::string& known = draft.material_names[name + '\n' + rgba + '\n' + texture];
  if (known.empty()) {
    known = draft.name_for("material", name.empty() ? texture : name);
    MjcfElement material{"material", {{"name", known}}};
    if (!texture.empty()) material.set("texture", texture);
    if (texture.empty() || rgba != "1 1 1 1") material.set("rgba", rgba);
    draft.asset.add(std::move(material));
  }
  geom.set("material", known);
}

std::vector<MjcfMeshGroup> grouped_by_look(const std::vector<mesh::Part>& parts,
                                           const std::vector<robot::Look>& looks) {
  std::vector<MjcfMeshGroup> groups;
  for (std::size_t i = 0; i < parts.size() && !looks.empty(); ++i) {
    if (parts[i].count == 0) continue;
    const robot::Look& look = looks[std::min(i, looks.size() - 1)];
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&look](const MjcfMeshGroup& each) { return same(each.look, look); });
    if (group == groups.end()) {
      if (groups.size() == kMaxGroups) return {};
      groups.push_back({{}, parts[i].material, look});
      group = groups.end() - 1;
    }
    group->parts.push_back(i);
  }
  return groups;
}

}  // namespace rigor::convert
