// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names for places: SDF's `<frame>`, and links that hold nothing and are fixed
// to their parent, which is what URDF has for it, with the names of the joints
// that fix them.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <rigor/robot/compare_parts.h>

namespace rigor::robot {
namespace {

enum class PlaceKind : std::uint8_t { kFrame, kLink, kJoint };

std::string_view word_for(PlaceKind kind) {
  if (kind == PlaceKind::kJoint) return "joint";
  return kind == PlaceKind::kLink ? "link" : "frame";
}

struct NamedPlace {
  std::string name;
  PlaceKind kind = PlaceKind::kFrame;
  std::uint32_t body = kNoIndex;  ///< that it is fixed to
  model::Pose X_BF;
  Span span;
  bool told = true;          ///< when the other has none
  std::string carried = {};  ///< of a joint: the link that it fixes
};

/// A frame may be what a link or a joint of the other format is; a link is no joint.
bool may_be_one(PlaceKind x, PlaceKind y) {
  return x == y || x == PlaceKind::kFrame || y == PlaceKind::kFrame;
}

/// For each body the matched one that it is fixed to, which may be itself, and where in it; kNoIndex
/// when there is none.
class MatchedHolders {
 public:
  MatchedHolders(const Robot& robot, const Match::Side& side) : holders_(robot.bodies.size()) {
    for (const std::uint32_t i : robot.order) {
      const std::uint32_t carrier = robot.bodies[i].carrier;
      if (side.body[i] != kNoIndex) {
        holders_[i].body = i;
      } else if (carrier != kNoIndex && robot.joints[carrier].type == model::JointType::kFixed) {
        const Joint& joint = robot.joints[carrier];
        const Holder& above = holders_[joint.parent];
        holders_[i] = {above.body, compose(above.X_HB, joint.X_PJ)};
      }
    }
  }

  NamedPlace of(NamedPlace place) const {
    if (place.body == kNoIndex) return place;
    const Holder& holder = holders_[place.body];
    if (holder.body != place.body) place.X_BF = compose(holder.X_HB, place.X_BF);
    place.body = holder.body;
    return place;
  }

 private:
  struct Holder {
    std::uint32_t body = kNoIndex;
    model::Pose X_HB;
  };
  std::vector<Holder> holders_;
};

std::vector<NamedPlace> places_in(const Robot& robot, const Match::Side& side, Helpers helpers) {
  std::vector<NamedPlace> places;
  const MatchedHolders holders(robot, side);
  const bool told = helpers == Helpers::kReported;
  for (const Frame& frame : robot.frames) {
    places.push_back(
        holders.of({frame.name, frame.of_joint ? PlaceKind::kJoint : PlaceKind::kFrame, frame.body,
                    frame.X_BF, frame.span, frame.of_joint ? told : true}));
  }
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    const Body& body = robot.bodies[i];
    if (side.body[i] != kNoIndex || !is_helper(body) || body.carrier == kNoIndex) continue;
    if (robot.joints[body.carrier].type != model::JointType::kFixed) continue;
    const Joint& carrier = robot.joints[body.carrier];
    places.push_back(
        holders.of({body.name, PlaceKind::kLink, i, {}, body.span, !side.silent_body[i]}));
    places.push_back(
        holders.of({carrier.name, PlaceKind::kJoint, i, {}, carrier.span, told, body.name}));
  }
  if (side.root_joint != kNoIndex) {
    const Joint& joint = robot.joints[side.root_joint];
    const Body& root = robot.bodies[joint.parent];
    places.push_back({root.name, PlaceKind::kLink, joint.child, inverse(joint.X_PJ), root.span,
                      !side.silent_body[joint.parent]});
    places.push_back({joint.name, PlaceKind::kJoint, joint.child, {}, joint.span, told, root.name});
  }
  return places;
}

void place_in_one(Comparison& c, const NamedPlace& place, bool in_a) {
  if (!place.told) return;
  constexpr DifferenceKind kOnlyInA[] = {
      DifferenceKind::kFrameOnlyInA, DifferenceKind::kLinkOnlyInA, DifferenceKind::kJointOnlyInA};
  constexpr DifferenceKind kOnlyInB[] = {
      DifferenceKind::kFrameOnlyInB, DifferenceKind::kLinkOnlyInB, DifferenceKind::kJointOnlyInB};
  const auto kind = static_cast<std::size_t>(place.kind);
  const std::string name = subject(word_for(place.kind), place.name);
  if (in_a) {
    c.add(kOnlyInA[kind], name, "", place.span, {});
  } else {
    c.add(kOnlyInB[kind], "", name, {}, place.span);
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
  Difference& d = c.add(DifferenceKind::kFrameMoved, subject(word_for(x.kind), x.name),
                        subject(word_for(y.kind), y.name), x.span, y.span);
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

/// The places of B by name, each of which is one of A at most.
class PlacesByName {
 public:
  explicit PlacesByName(const std::vector<NamedPlace>& places)
      : places_(places), taken_(places.size()) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      by_name_[plain_name(places[i].name)].push_back(i);
    }
  }

  /// Null when there is none; of the same kind first.
  const NamedPlace* take(const std::string& name, PlaceKind kind) {
    const auto found = by_name_.find(plain_name(name));
    if (found == by_name_.end()) return nullptr;
    std::optional<std::size_t> best;
    for (const std::size_t i : found->second) {
      if (taken_[i] || !may_be_one(kind, places_[i].kind)) continue;
      if (!best || (places_[i].kind == kind && places_[*best].kind != kind)) best = i;
    }
    if (!best) return nullptr;
    taken_[*best] = true;
    return &places_[*best];
  }

  bool is_taken(std::size_t i) const { return taken_[i]; }

 private:
  const std::vector<NamedPlace>& places_;
  std::vector<bool> taken_;
  std::unordered_map<std::string, std::vector<std::size_t>> by_name_;
};

const std::string& name_in_b(const Correspondence& names, const NamedPlace& place) {
  if (place.kind != PlaceKind::kJoint) {
    const auto given = names.links.find(place.name);
    return given == names.links.end() ? place.name : given->second;
  }
  const auto given = names.joints.find(place.name);
  return given == names.joints.end() || given->second.empty() ? place.name : given->second.front();
}

/// A frame of SDF is fixed by no joint: the name that a conversion makes up for one is no difference.
bool is_made_up(const NamedPlace& joint, const std::unordered_set<std::string>& frames) {
  return joint.kind == PlaceKind::kJoint && joint.name == joint.carried + "_joint" &&
         frames.contains(plain_name(joint.carried));
}

std::unordered_set<std::string> frame_names(const std::vector<NamedPlace>& places) {
  std::unordered_set<std::string> names;
  for (const NamedPlace& place : places) {
    if (place.kind == PlaceKind::kFrame) names.insert(plain_name(place.name));
  }
  return names;
}

}  // namespace

void compare_frames(Comparison& c) {
  const std::vector<NamedPlace> in_a = places_in(c.a, c.match.a, c.names.helpers);
  const std::vector<NamedPlace> in_b = places_in(c.b, c.match.b, c.names.helpers);
  const std::unordered_set<std::string> frames_a = frame_names(in_a);
  const std::unordered_set<std::string> frames_b = frame_names(in_b);
  PlacesByName by_name(in_b);
  for (const NamedPlace& place : in_a) {
    if (const NamedPlace* other = by_name.take(name_in_b(c.names, place), place.kind)) {
      compare_places(c, place, *other);
    } else if (!is_made_up(place, frames_b)) {
      place_in_one(c, place, true);
    }
  }
  for (std::size_t j = 0; j < in_b.size(); ++j) {
    if (!by_name.is_taken(j) && !is_made_up(in_b[j], frames_a)) place_in_one(c, in_b[j], false);
  }
}

}  // namespace rigor::robot
