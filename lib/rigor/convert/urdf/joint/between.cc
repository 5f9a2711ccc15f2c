// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/joint/between.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <rigor/mass/mass_properties.h>
#include <rigor/model/subject.h>
#include <rigor/write/numbers.h>

namespace rigor::convert {
namespace {

/// kg. libsdformat takes up to 1e-6 for nothing (math::equal in its parser_urdf.cc; measured with 12.3).
const Number kLinkMass{2e-6, "2e-6"};
/// kg·m². MuJoCo refuses less than 1e-15 (mjMINVAL).
const Number kLinkMoment{1e-14, "1e-14"};

/// What carries less than this many times a row's mass would be another link without it.
constexpr double kMinTimes = 100;

mass::Inertia tensor_of(const UrdfInertial& inertial) {
  const auto& [ixx, ixy, ixz, iyy, iyz, izz] = inertial.inertia;
  return {ixx.value, ixy.value, ixz.value, iyy.value, iyz.value, izz.value};
}

/// The author's digits where nothing changes.
void set(Number& number, double value) {
  value = write::settled(value, number.value, std::abs(number.value));
  if (value != number.value) number = {value, {}};
}

/// What is left when balls of `mass` (kg) and `moment` (kg·m²) in all are taken away at the link's
/// origin: the rest keeps Σ m c and the tensor about the origin, so with c in the axes of the inertial
/// the center goes to c m / m' and the tensor there loses `moment` and that of (m / m') `mass` at c.
/// Nothing when no body is left that could be.
std::optional<UrdfInertial> without_balls(UrdfInertial inertial, double mass, double moment) {
  const double whole = inertial.mass.value;
  const double rest = whole - mass;
  if (!(whole >= kMinTimes * mass)) return std::nullopt;
  const model::Pose X = pose_of(inertial.origin);
  const model::Vector3 c = rotate(conjugate(X.rotation), X.translation);
  const mass::Inertia before = tensor_of(inertial);
  const mass::Inertia after = before - mass::Inertia{moment, 0, 0, moment, 0, moment} -
                              mass::point_inertia(mass * whole / rest, c);
  if (mass::judge(whole, before).possible() && !mass::judge(rest, after).possible()) {
    return std::nullopt;
  }
  set(inertial.mass, rest);
  const std::array place{X.translation.x, X.translation.y, X.translation.z};
  for (std::size_t i = 0; i < 3; ++i) set(inertial.origin.xyz[i], place[i] * whole / rest);
  const std::array tensor{after.ixx, after.ixy, after.ixz, after.iyy, after.iyz, after.izz};
  for (std::size_t i = 0; i < tensor.size(); ++i) set(inertial.inertia[i], tensor[i]);
  return inertial;
}

UrdfLink* link_named(UrdfRobot& robot, const std::string& name) {
  const auto found = std::find_if(robot.links.begin(), robot.links.end(),
                                  [&name](const UrdfLink& link) { return link.name == name; });
  return found == robot.links.end() ? nullptr : &*found;
}

}  // namespace

void weigh_links_between(UrdfDraft& draft, model::Id<model::Model> id) {
  UrdfInertial ball{{}, kLinkMass, {}};
  ball.inertia = {kLinkMoment, Number{}, Number{}, kLinkMoment, Number{}, kLinkMoment};
  const model::Root& root = draft.source.root;
  std::size_t weighed = 0;
  for (const UrdfDraft::Row& row : draft.rows) {
    UrdfLink* carried = link_named(draft.robot, draft.link_names.at(row.carried));
    if (carried == nullptr || !carried->inertial) continue;
    const auto count = static_cast<double>(row.links.size());
    auto rest =
        without_balls(*carried->inertial, count * kLinkMass.value, count * kLinkMoment.value);
    if (!rest) continue;
    carried->inertial = *std::move(rest);
    for (const std::size_t link : row.links) draft.robot.links[link].inertial = ball;
    draft.ledger.take(root[row.carried].inertial.mass, Outcome::kSubstituted);
    weighed += row.links.size();
  }
  if (weighed == 0) return;
  draft.ledger.note({.kind = NoteKind::kLinkBetween,
                     .outcome = Outcome::kSubstituted,
                     .where = root[id].site.name,
                     .subject = model::subject(root, root[id]),
                     .instead = to_text(kLinkMass) + " kg",
                     .count = weighed});
}

}  // namespace rigor::convert
