// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names for places: SDF's `<frame>`, and links that hold nothing and are fixed
// to their parent, which is what URDF has for it.

#include <map>

#include <rigor/robot/compare_parts.h>

namespace rigor::robot {
namespace {

struct NamedPlace {
  std::string name;
  std::string_view kind;
  std::uint32_t body = kNoIndex;  ///< that it is fixed to
  model::Pose X_BF;
  Span span;
  bool told = true;  ///< when the other has none
};

/// The matched body that this one is fixed to, and where in it; kNoIndex when
/// there is none.
NamedPlace in_matched(const Robot& robot, const Match::Side& side, NamedPlace place) {
  while (place.body != kNoIndex && side.body[place.body] == kNoIndex) {
    const std::uint32_t carrier = robot.bodies[place.body].carrier;
    if (carrier == kNoIndex || robot.joints[carrier].type != model::JointType::kFixed) {
      place.body = kNoIndex;
      break;
    }
    place.X_BF = compose(robot.joints[carrier].X_PJ, place.X_BF);
    place.body = robot.joints[carrier].parent;
  }
  return place;
}

std::vector<NamedPlace> places_in(const Robot& robot, const Match::Side& side, Helpers helpers) {
  std::vector<NamedPlace> places;
  const bool told = helpers == Helpers::kTold;
  for (const Frame& frame : robot.frames) {
    places.push_back(
        in_matched(robot, side, {frame.name, "frame", frame.body, frame.X_BF, frame.span, told}));
  }
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    const Body& body = robot.bodies[i];
    if (side.body[i] != kNoIndex || !is_helper(body) || body.carrier == kNoIndex) continue;
    if (robot.joints[body.carrier].type != model::JointType::kFixed) continue;
    places.push_back(
        in_matched(robot, side, {body.name, "link", i, {}, body.span, !side.silent_body[i]}));
  }
  return places;
}

void place_in_one(Comparison& c, const NamedPlace& place, bool in_a) {
  if (!place.told) return;
  const bool link = place.kind == "link";
  const std::string name = subject(place.kind, place.name);
  if (in_a) {
    c.add(link ? DifferenceKind::kLinkOnlyInA : DifferenceKind::kFrameOnlyInA, name, "", place.span,
          {});
  } else {
    c.add(link ? DifferenceKind::kLinkOnlyInB : DifferenceKind::kFrameOnlyInB, "", name, {},
          place.span);
  }
}

void compare_places(Comparison& c, const NamedPlace& x, const NamedPlace& y) {
  if (x.body == kNoIndex && y.body == kNoIndex) return;
  const bool same_body = x.body != kNoIndex && c.match.a.body[x.body] == y.body;
  const model::Pose E = x.body == kNoIndex ? model::Pose{} : c.shifts[x.body].E;
  const model::Pose expected = E == model::Pose{} ? x.X_BF : compose(E, x.X_BF);
  if (same_body && (near(expected, y.X_BF, c.tolerance) || near(x.X_BF, y.X_BF, c.tolerance))) {
    return;
  }
  Difference& d = c.add(DifferenceKind::kFrameMoved, subject(x.kind, x.name),
                        subject(y.kind, y.name), x.span, y.span);
  d.from.numbers = pose_numbers(x.X_BF);
  d.to.numbers = pose_numbers(y.X_BF);
  d.unit = "m";
  if (!same_body) {
    d.from.text = x.body == kNoIndex ? "nothing" : c.a.bodies[x.body].name;
    d.to.text = y.body == kNoIndex ? "nothing" : c.b.bodies[y.body].name;
    return;
  }
  const Apart off = apart(expected, y.X_BF);
  d.distance = off.distance;
  d.angle = off.angle;
}

}  // namespace

void compare_frames(Comparison& c) {
  const std::vector<NamedPlace> in_a = places_in(c.a, c.match.a, c.names.helpers);
  const std::vector<NamedPlace> in_b = places_in(c.b, c.match.b, c.names.helpers);
  std::map<std::string, std::size_t> by_name;
  for (std::size_t j = 0; j < in_b.size(); ++j) by_name.try_emplace(plain_name(in_b[j].name), j);
  std::vector<bool> taken(in_b.size());
  for (const NamedPlace& place : in_a) {
    const auto given = c.names.links.find(place.name);
    const std::string& name = given == c.names.links.end() ? place.name : given->second;
    const auto found = by_name.find(plain_name(name));
    if (found == by_name.end() || taken[found->second]) {
      place_in_one(c, place, true);
      continue;
    }
    taken[found->second] = true;
    compare_places(c, place, in_b[found->second]);
  }
  for (std::size_t j = 0; j < in_b.size(); ++j) {
    if (!taken[j]) place_in_one(c, in_b[j], false);
  }
}

}  // namespace rigor::robot
