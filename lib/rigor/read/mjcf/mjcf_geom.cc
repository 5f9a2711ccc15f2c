// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/mjcf/mjcf_geom.h>

#include <utility>

#include <rigor/read/mjcf/mjcf_pose.h>

namespace rigor::read {
namespace {

model::Field<double> length_field(double value, const MjcfValues& values) {
  const auto text = values.text("size");
  return {value, text ? text->span : Span{}, text.has_value()};
}

model::Field<model::Vector3> sides_field(const model::Vector3& value, const MjcfValues& values) {
  const auto text = values.text("size");
  return {value, text ? text->span : Span{}, text.has_value()};
}

/// MuJoCo's sizes are radii and half lengths.
model::Shape primitive(std::string_view type, std::vector<double> size,
                       const std::optional<Segment>& segment, const MjcfValues& values) {
  size.resize(3, 0);
  if (segment) {
    if (type == "capsule" || type == "cylinder") size[1] = segment->half_length;
    if (type == "box" || type == "ellipsoid") size = {size[0], size[0], segment->half_length};
  }
  if (type == "sphere") return model::Sphere{length_field(size[0], values)};
  if (type == "capsule") {
    return model::Capsule{length_field(size[0], values), length_field(2 * size[1], values)};
  }
  if (type == "cylinder") {
    return model::Cylinder{length_field(size[0], values), length_field(2 * size[1], values)};
  }
  if (type == "ellipsoid") {
    return model::Ellipsoid{sides_field({size[0], size[1], size[2]}, values)};
  }
  if (type == "box") {
    return model::Box{sides_field({2 * size[0], 2 * size[1], 2 * size[2]}, values)};
  }
  if (type == "plane") return model::Plane{{{0, 0, 1}, {}, false}};
  return model::NoShape{};
}

model::GeomWeight::Fit fit_of(std::string_view type) {
  using Fit = model::GeomWeight::Fit;
  if (type == "sphere") return Fit::kSphere;
  if (type == "capsule") return Fit::kCapsule;
  if (type == "cylinder") return Fit::kCylinder;
  if (type == "ellipsoid") return Fit::kEllipsoid;
  if (type == "box") return Fit::kBox;
  return Fit::kNone;
}

}  // namespace

MjcfGeom mjcf_geom(const MjcfValues& values, const MjcfSettings& settings, MjcfAssets& assets,
                   InPair in_pair) {
  MjcfGeom geom;
  geom.geometry.site = site_of(values.element());
  geom.geometry.written = true;
  geom.X_BG = mjcf_pose(values, settings);
  const auto segment = mjcf_segment(values);
  if (segment) geom.X_BG = segment->pose;

  const auto mesh_name = values.string("mesh");
  const std::string type(trimmed(values.string("type", "sphere").value));
  const auto mesh = assets.meshes.find(mesh_name.value);
  const bool takes_mesh = mesh_name.written && type != "plane" && type != "hfield";
  auto law = model::GeomWeight::MeshLaw::kLegacy;
  if (takes_mesh && mesh != assets.meshes.end()) {
    geom.geometry.shape = mesh->second.mesh;
    geom.X_BG = compose(geom.X_BG, mesh->second.X_RM);
    geom.fitted = type != "mesh" && type != "sdf" && values.own("type").has_value();
    law = mesh->second.law;
  } else if (type == "hfield") {
    const auto field = assets.height_fields.find(values.string("hfield").value);
    if (field != assets.height_fields.end()) geom.geometry.shape = field->second.heightmap;
  } else {
    geom.geometry.shape = primitive(type, values.numbers("size"), segment, values);
  }

  const double contype = values.number("contype", 1).value;
  const double conaffinity = values.number("conaffinity", 1).value;
  const double group = values.number("group", 0).value;
  geom.touches = contype != 0 || conaffinity != 0 || in_pair == InPair::kYes;
  geom.drawn = group <= kLastDrawnGroup || !geom.touches;

  const bool weighs = type != "plane" && type != "hfield" && group >= settings.inertia_groups[0] &&
                      group <= settings.inertia_groups[1];
  if (weighs) {
    geom.weight = model::GeomWeight{values.number("mass", 0), values.number("density", 1000),
                                    values.is_true("shellinertia"), law};
    if (geom.fitted && !settings.fit_to_bounds) {
      geom.weight->fit = fit_of(type);
      geom.weight->fit_scale = values.number("fitscale", 1).value;
    }
  }

  const auto material = assets.materials.find(values.string("material").value);
  if (material != assets.materials.end()) geom.rgba = material->second.rgba;
  const std::vector<double> rgba = values.numbers("rgba");
  if (rgba.size() == 4) geom.rgba = {rgba[0], rgba[1], rgba[2], rgba[3]};
  return geom;
}

}  // namespace rigor::read
