// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <utility>

#include <rigor/read/sdf_reader.h>

namespace rigor::read {

using model::Id;

namespace {

/// SDF 1.11 computes inertials from densities.
constexpr int kDensity = 11;

model::FluidAddedMass read_added_mass(xml::Element element) {
  const auto value = [element](std::string_view name) {
    return number_field(child_text(element, name), 0);
  };
  return {value("xx"), value("yy"), value("zz"), value("pp"), value("qq"), value("rr")};
}

}  // namespace

void SdfReader::read_link(xml::Element element, Id<model::Model> parent) {
  const Id<model::Link> id = model::next_id(root_.links);
  model::Link& link = root_.links.emplace_back();
  link.site = site_of(element);
  link.name = string_field(attribute_text(element, "name"));
  link.model = parent;
  link.pose = read_pose(element);
  link.inertial = read_inertial(element);
  link.kinematic = bool_field(child_text(element, "kinematic"), false);
  link.gravity = bool_field(child_text(element, "gravity"), true);
  link.self_collide = bool_field(child_text(element, "self_collide"), false);
  root_.models[parent.value].links.push_back(id);
  for (const xml::Element child : element.children()) {
    const std::string_view name = child.name();
    if (name == "collision") {
      read_collision(child, id);
    } else if (name == "visual") {
      read_visual(child, id);
    } else if (name == "sensor") {
      model::Sensor sensor;
      sensor.link = id;
      read_sensor(child, std::move(sensor));
    } else if (name == "light") {
      read_light(child, id);
    } else if (name == "plugin") {
      read_plugin(child, {.link = id});
    }
  }
}

model::Inertial SdfReader::read_inertial(xml::Element link) const {
  model::Inertial inertial;
  for (auto* moment : {&inertial.mass, &inertial.ixx, &inertial.iyy, &inertial.izz}) {
    moment->value = 1;  // what every SDF version defaults to, with or without <inertial>
  }
  inertial.density.value = 1000;
  const auto element = link.child("inertial");
  if (!element) return inertial;
  inertial.site = site_of(*element);
  inertial.written = true;
  inertial.automatic = bool_field(attribute_text(*element, "auto"), false);
  if (version_ >= kDensity || inertial.automatic.value) {
    inertial.density = number_field(child_text(*element, "density"), 1000);
  }
  inertial.mass = number_field(child_text(*element, "mass"), 1);
  inertial.pose = read_pose(*element);
  if (const auto added = element->child("fluid_added_mass")) {
    inertial.added_mass = read_added_mass(*added);
  }
  const auto tensor = element->child("inertia");
  if (!tensor) return inertial;
  inertial.tensor_written = true;
  inertial.tensor_site = site_of(*tensor);
  inertial.ixx = number_field(child_text(*tensor, "ixx"), 1);
  inertial.ixy = number_field(child_text(*tensor, "ixy"), 0);
  inertial.ixz = number_field(child_text(*tensor, "ixz"), 0);
  inertial.iyy = number_field(child_text(*tensor, "iyy"), 1);
  inertial.iyz = number_field(child_text(*tensor, "iyz"), 0);
  inertial.izz = number_field(child_text(*tensor, "izz"), 1);
  return inertial;
}

namespace {

model::Surface read_surface(xml::Element collision) {
  model::Surface surface;
  const auto descend = [](std::optional<xml::Element> from, std::string_view name) {
    return from ? from->child(name) : std::nullopt;
  };
  const auto value = [](std::optional<xml::Element> from, std::string_view name, double fallback) {
    return number_field(from ? child_text(*from, name) : std::nullopt, fallback);
  };
  const auto element = collision.child("surface");
  const auto friction = descend(descend(element, "friction"), "ode");
  surface.mu = value(friction, "mu", 1);
  surface.mu2 = value(friction, "mu2", 1);
  surface.slip1 = value(friction, "slip1", 0);
  surface.slip2 = value(friction, "slip2", 0);
  if (const auto fdir1 = descend(friction, "fdir1")) {
    surface.fdir1 = vector_field(Text{fdir1->text(), fdir1->text_span()}, {});
    surface.fdir1_in_frame = !fdir1->attributes().empty();
  }
  const auto contacts = descend(element, "contact");
  surface.chooses_contacts = descend(contacts, "collide_bitmask") ||
                             descend(contacts, "category_bitmask") ||
                             descend(contacts, "collide_without_contact");
  const auto contact = descend(contacts, "ode");
  surface.min_depth = value(contact, "min_depth", 0);
  surface.kp = value(contact, "kp", 1e12);
  surface.kd = value(contact, "kd", 1);
  return surface;
}

model::Material read_visual_material(xml::Element visual) {
  model::Material material;
  const auto element = visual.child("material");
  if (!element) return material;
  material.written = true;
  material.site = site_of(*element);
  if (const auto script = element->child("script")) {
    material.script = site_of(*script);
    material.name = string_field(child_text(*script, "name"));
    material.script_uri = string_field(child_text(*script, "uri"));
  }
  if (const auto pbr = element->child("pbr")) material.pbr = site_of(*pbr);
  material.defines_color = element->child("diffuse") || element->child("ambient");
  material.has_color = material.defines_color || element->child("emissive");
  return material;
}

}  // namespace

void SdfReader::read_collision(xml::Element element, Id<model::Link> link) {
  root_.links[link.value].collisions.push_back(model::next_id(root_.collisions));
  model::Collision& collision = root_.collisions.emplace_back();
  collision.site = site_of(element);
  collision.name = string_field(attribute_text(element, "name"));
  collision.link = link;
  collision.pose = read_pose(element);
  collision.geometry = read_geometry(element);
  collision.surface = read_surface(element);
  if (version_ >= kDensity) {
    collision.density = number_field(child_text(element, "density"), 1000);
  }
}

void SdfReader::read_visual(xml::Element element, Id<model::Link> link) {
  root_.links[link.value].visuals.push_back(model::next_id(root_.visuals));
  model::Visual& visual = root_.visuals.emplace_back();
  visual.site = site_of(element);
  visual.name = string_field(attribute_text(element, "name"));
  visual.link = link;
  visual.pose = read_pose(element);
  visual.geometry = read_geometry(element);
  visual.material = read_visual_material(element);
  visual.transparency = number_field(child_text(element, "transparency"), 0);
}

}  // namespace rigor::read
