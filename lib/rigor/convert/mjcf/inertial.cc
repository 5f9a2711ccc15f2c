// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Mass, center of mass and moments about the principal axes. MuJoCo keeps these as they are written; of a
// full tensor it computes the axes itself, to 1e-12 kg·m², which is much for a finger.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/core.h>

#include <rigor/convert/mjcf/draft.h>
#include <rigor/mass/mass_properties.h>
#include <rigor/mass/nearest.h>
#include <rigor/model/subject.h>

namespace rigor::convert {
namespace {

/// kg and kg·m²: MuJoCo rejects a moving body with less (mjMINVAL is 1e-15).
constexpr double kMujocoLeast = 2e-15;

/// How far from its center the mass of a link without mass lies, m: solvers dislike points.
constexpr double kMasslessGyration = 0.1;

using Moments = std::array<double, 3>;

/// The rotation whose columns are the axes, after Shepperd, "Quaternion from rotation matrix", 1978.
model::Quaternion rotation_to(const std::array<model::Vector3, 3>& a) {
  const double xx = a[0].x, yy = a[1].y, zz = a[2].z;
  const std::array squares{1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz};
  const auto* const largest = std::max_element(squares.begin(), squares.end());
  const double s = 0.5 / std::sqrt(*largest);
  const double wx = a[1].z - a[2].y, wy = a[2].x - a[0].z, wz = a[0].y - a[1].x;
  const double xy = a[0].y + a[1].x, xz = a[0].z + a[2].x, yz = a[1].z + a[2].y;
  model::Quaternion q;
  switch (largest - squares.begin()) {
    case 0: q = {*largest * s, wx * s, wy * s, wz * s}; break;
    case 1: q = {wx * s, *largest * s, xy * s, xz * s}; break;
    case 2: q = {wy * s, xy * s, *largest * s, yz * s}; break;
    default: q = {wz * s, xz * s, yz * s, *largest * s};
  }
  return normalized(q);
}

bool is_diagonal(const mass::Inertia& I) { return I.ixy == 0 && I.ixz == 0 && I.iyz == 0; }

/// What rounding leaves of a flat plate: the largest moment is at most the sum of the others.
void settle_moments(Moments& moments, double least) {
  for (double& moment : moments) moment = std::max(moment, least);
  for (std::size_t i = 0; i < 3; ++i) {
    const double sum = moments[(i + 1) % 3] + moments[(i + 2) % 3];
    moments[i] = std::min(moments[i], sum);
  }
}

MjcfElement inertial_element(const mass::MassProperties& body, double least) {
  MjcfElement element{"inertial"};
  Moments moments{body.about_com.ixx, body.about_com.iyy, body.about_com.izz};
  model::Quaternion rotation;
  if (!is_diagonal(body.about_com)) {
    const mass::PrincipalAxes principal = mass::principal_axes(body.about_com);
    moments = principal.moments;
    rotation = rotation_to(principal.axes);
  }
  settle_moments(moments, least);
  element.set("pos", mjcf_numbers({body.com.x, body.com.y, body.com.z}));
  const std::string quat = mjcf_quaternion(rotation);
  if (quat != "1 0 0 0") element.set("quat", quat);
  element.set("mass", mjcf_number(body.mass));
  element.set("diaginertia", mjcf_numbers({moments[0], moments[1], moments[2]}));
  return element;
}

bool weighs_enough(const mass::MassProperties& body) {
  const auto moments = mass::principal_moments(body.about_com);
  return body.mass >= kMujocoLeast && moments[0] >= kMujocoLeast;
}

/// Whether MuJoCo would divide by what the body weighs: it moves, and nothing that is fixed to it weighs.
bool must_weigh(const MjcfDraft& draft, std::uint32_t i) {
  const robot::Robot& robot = draft.robot();
  const std::uint32_t carrier = robot.bodies[i].carrier;
  if (i == draft.assembly.world) return false;
  if (carrier != robot::kNoIndex && robot.joints[carrier].type == model::JointType::kFixed) {
    return false;
  }
  for (const robot::Joint& joint : robot.joints) {
    const bool fixed_to_it =
        joint.parent == i && !joint.closes_loop && joint.type == model::JointType::kFixed;
    if (fixed_to_it && weighs_enough(robot.bodies[joint.child].mass)) return false;
  }
  return true;
}

std::string moments_words(const Moments& moments) {
  return fmt::format("{:.3g}, {:.3g} and {:.3g}", moments[0], moments[1], moments[2]);
}

void note_on_body(MjcfDraft& draft, std::uint32_t i, NoteKind kind, std::string written,
                  std::string instead) {
  const model::Link* link = draft.entities.link(draft.robot().bodies[i].span);
  if (link == nullptr) return;
  draft.ledger.note({.kind = kind,
                     .outcome = Outcome::kSubstituted,
                     .where = link->inertial.written ? link->inertial.site.name : link->site.name,
                     .subject = model::subject(draft.root(), *link),
                     .written = std::move(written),
                     .instead = std::move(instead)});
}

}  // namespace

std::vector<MjcfElement> mjcf_inertial(MjcfDraft& draft, std::uint32_t i) {
  mass::MassProperties body = draft.robot().bodies[i].mass;
  const bool must = must_weigh(draft, i);
  if (!mass::judge(body).possible()) {
    const auto nearest = mass::nearest_possible(body.about_com);
    const bool usable = nearest && body.mass > 0;
    note_on_body(draft, i, NoteKind::kMjcfInertia,
                 moments_words(mass::principal_moments(body.about_com)),
                 usable ? moments_words(mass::principal_moments(*nearest)) : "nothing");
    if (usable) body.about_com = *nearest;
    if (!usable) body = {};
  }
  if (body.mass < kMujocoLeast && must) {
    const double moment = draft.next_to_nothing * kMasslessGyration * kMasslessGyration;
    body.mass = draft.next_to_nothing;
    body.about_com = {moment, 0, 0, moment, 0, moment};
    note_on_body(draft, i, NoteKind::kMjcfMassless, {}, fmt::format("{:.1e} kg", body.mass));
  }
  if (body.mass <= 0 && body.about_com == mass::Inertia{}) return {};
  return {inertial_element(body, must ? kMujocoLeast : 0)};
}

void tell_moved_inertias(MjcfDraft& draft) {
  for (const auto& [from, to, moments] : draft.assembly.moved_inertias) {
    note_on_body(draft, from, NoteKind::kMjcfInertiaMoved, moments_words(moments),
                 to == draft.assembly.world
                     ? "it is the nearest possible one, in a body that never moves"
                     : "it is part of body " + draft.robot().bodies[to].name + " now");
  }
}

}  // namespace rigor::convert
