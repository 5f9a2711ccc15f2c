// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/mark_painter.h>

#include <cstdint>
#include <utility>

#include <rigor/mass/resolve.h>
#include <rigor/view/turn.h>

namespace rigor::view {
namespace {

using model::Id;
using model::Pose;

// Of the diagonal of a model.
constexpr double kFrameLength = 0.06;
constexpr double kAxisLength = 0.1;
constexpr double kComRadius = 0.01;

constexpr Color kInertiaPurple{0.65F, 0.25F, 0.85F, 0.5F};

}  // namespace

std::string name_of(const model::Root& root, Id<model::Link> link) {
  return scoped_name(root, root[link].model) + "/link " + root[link].name.value;
}

void MarkPainter::draw(Layer layer) {
  if (layer == Layer::kInertia || layer == Layer::kCom) draw_masses(layer);
  if (layer == Layer::kFrames) draw_frames();
  if (layer == Layer::kAxes) draw_axes();
  if (layer == Layer::kContacts) draw_contacts();
}

void MarkPainter::draw_masses(Layer layer) {
  const Mark com = layer == Layer::kCom ? com_mark() : Mark();
  for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
    const Id<model::Link> link{i};
    const auto X_WL = frames_.pose(link);
    if (!X_WL || model::is_static(root_, root_[link].model)) continue;
    const mass::MassProperties mass = mass::resolve(root_, frames_, link, {}).body;
    if (mass.mass == 0 && mass.about_com == mass::Inertia()) continue;  // URDF: none at all
    Body body{.layer = layer, .link = link, .where = root_[link].inertial.site.tag};
    if (body.where.nowhere()) body.where = root_[link].site.tag;
    body.name = name_of(root_, link) + (layer == Layer::kCom ? "/center of mass" : "/inertia");
    if (layer == Layer::kCom) {
      body.pose = {transform(*X_WL, mass.com), X_WL->rotation};
      add_mark(std::move(body), com, kComRadius);
    } else {
      add_inertia(std::move(body), *X_WL, mass);
    }
  }
}

void MarkPainter::add_inertia(Body body, const Pose& X_WL, const mass::MassProperties& mass) {
  if (!(mass.mass > 0) || !mass::judge(mass).possible()) {
    canvas_.refuse(body, "no rigid body has such a mass and inertia");
    return;
  }
  const mass::PrincipalAxes principal = mass::principal_axes(mass.about_com);
  const auto sides = mass::equivalent_box(mass.mass, principal.moments);
  const auto& [x, y, z] = principal.axes;
  body.pose = compose(X_WL, {mass.com, model::from_axes(x, y, z)});
  body.scale = {sides[0], sides[1], sides[2]};
  body.mesh = finder_.unit_box();
  body.surfaces = {{kInertiaPurple}};
  canvas_.add(std::move(body));
}

void MarkPainter::draw_frames() {
  const Mark mark = frame_mark();
  note_places();
  for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
    const Id<model::Link> link{i};
    const auto X_WL = frames_.pose(link);
    if (!X_WL) continue;
    Body body{.layer = Layer::kFrames, .link = link, .pose = *X_WL};
    body.name = name_of(root_, link) + "/frame";
    body.where = root_[link].site.tag;
    add_mark(std::move(body), mark, kFrameLength);
  }
}

void MarkPainter::draw_axes() {
  const Mark mark = axis_mark();
  note_places();
  for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
    const Id<model::Joint> id{i};
    const model::Joint& joint = root_[id];
    const auto X_WJ = frames_.pose(id);
    if (!X_WJ || joint.type == model::JointType::kFixed) continue;
    for (std::size_t a = 0; a < joint.axes.size(); ++a) {
      const auto axis = frames_.axis(id, a);
      if (!axis) continue;
      Body body{.layer = Layer::kAxes, .link = frames_.ends(id).child, .joint = id};
      body.pose = {X_WJ->translation, turn_from_z(*axis)};
      body.where = joint.axes[a].site.tag;
      body.name = scoped_name(root_, joint.model) + "/joint " + joint.name.value +
                  (a == 0 ? "/axis" : "/axis2");
      add_mark(std::move(body), mark, kAxisLength);
    }
  }
}

void MarkPainter::add_mark(Body body, const Mark& mark, double share) {
  const double size = share * canvas_.size_around(body.link);
  body.mesh = mark.mesh;
  body.surfaces = mark.surfaces;
  body.scale = {size, size, size};
  canvas_.add(std::move(body));
}

/// A model whose shapes are not shown is as large as its frames lie apart.
void MarkPainter::note_places() {
  if (std::exchange(noted_, true)) return;
  for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
    const auto X_WL = frames_.pose(Id<model::Link>{i});
    if (X_WL) canvas_.note(Id<model::Link>{i}, X_WL->translation);
  }
}

}  // namespace rigor::view
