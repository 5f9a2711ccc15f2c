// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/compare_poses.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace rigor::robot {
namespace {

using model::Pose;

/// A link that moved as a whole is found by what it holds: a few parts are
/// enough to vote.
constexpr std::size_t kMaxVoters = 64;
constexpr std::size_t kMaxHypotheses = 4;

std::vector<Pose> seen_from(const std::vector<Pose>& X_M, std::uint32_t reference) {
  if (X_M[reference] == Pose{}) return X_M;
  const Pose X_RM = inverse(X_M[reference]);
  std::vector<Pose> X_R;
  X_R.reserve(X_M.size());
  for (const Pose& X : X_M) X_R.push_back(compose(X_RM, X));
  return X_R;
}

/// B's joints where A's are; what A has no axis for follows its leader, or
/// stays at zero.
Positions positions_in_b(const Robot& b, const Match& match, const Positions& in_a) {
  Positions given(b.joints.size());
  std::vector<std::vector<bool>> is_given(b.joints.size());
  for (std::size_t i = 0; i < b.joints.size(); ++i) {
    given[i].resize(b.joints[i].axes.size());
    is_given[i].resize(b.joints[i].axes.size());
  }
  for (std::size_t i = 0; i < match.axes.size(); ++i) {
    for (std::size_t k = 0; k < match.axes[i].size(); ++k) {
      const Match::Axis& axis = match.axes[i][k];
      if (axis.joint == kNoIndex) continue;
      given[axis.joint][axis.axis] = in_a[i][k];
      is_given[axis.joint][axis.axis] = true;
    }
  }
  Positions all = followed(b, given);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < all[i].size(); ++k) {
      if (is_given[i][k]) all[i][k] = given[i][k];
    }
  }
  return all;
}

/// What votes on how a body's content is shifted.
struct BodyVotes {
  const Body& a;
  const Body& b;
  const Tolerance& tolerance;
  std::vector<PartPair> collisions, visuals;

  bool agrees(const Pose& E, const Part& x, const Part& y) const {
    return near(E == Pose{} ? x.X_BS : compose(E, x.X_BS), y.X_BS, tolerance);
  }

  std::size_t count(const Pose& E) const {
    std::size_t votes = 0;
    for_each_pair([&](const Part& x, const Part& y) { votes += agrees(E, x, y); });
    const bool has_mass = a.mass.mass != 0 && b.mass.mass != 0;
    return votes + (has_mass && near(transform(E, a.mass.com), b.mass.com, tolerance) ? 1 : 0);
  }

  template <class Use>
  void for_each_pair(Use use) const {
    std::size_t seen = 0;
    for (const PartPair& p : collisions) {
      if (p.a == kNoIndex || p.b == kNoIndex || ++seen > kMaxVoters) continue;
      use(a.collisions[p.a], b.collisions[p.b]);
    }
    for (const PartPair& p : visuals) {
      if (p.a == kNoIndex || p.b == kNoIndex || ++seen > kMaxVoters) continue;
      use(a.visuals[p.a], b.visuals[p.b]);
    }
  }
};

/// The shift that most of the content agrees with; the identity where none has
/// more.
Pose shift_of(const BodyVotes& votes, const Pose& stays) {
  std::size_t most = votes.count({});
  std::size_t all = votes.a.mass.mass != 0 && votes.b.mass.mass != 0 ? 1 : 0;
  std::vector<Pose> hypotheses{stays};
  votes.for_each_pair([&](const Part& x, const Part& y) {
    ++all;
    if (hypotheses.size() < kMaxHypotheses && !votes.agrees({}, x, y)) {
      hypotheses.push_back(compose(y.X_BS, inverse(x.X_BS)));
    }
  });
  Pose best;
  if (most == all) return best;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    const std::size_t count = votes.count(hypotheses[i]);
    // One part that moved says nothing of the link, unless that stayed where
    // its joint left it.
    if (count <= most || (count < 2 && i > 0)) continue;
    most = count;
    best = hypotheses[i];
  }
  return best;
}

}  // namespace

TwinPoses::TwinPoses(const Robot& a, const Robot& b, const Match& match, std::size_t count) {
  if (match.reference_a == kNoIndex) return;
  for (const Positions& positions : configurations(a, count)) {
    in_a_.push_back(seen_from(body_poses(a, positions), match.reference_a));
    in_b_.push_back(
        seen_from(body_poses(b, positions_in_b(b, match, positions)), match.reference_b));
  }
}

std::vector<PartPair> pair_parts(const std::vector<Part>& a, const std::vector<Part>& b) {
  std::unordered_map<std::string_view, std::uint32_t> in_b;
  for (std::uint32_t i = 0; i < b.size(); ++i) {
    if (!b[i].name.empty()) in_b.try_emplace(b[i].name, i);
  }
  std::vector<PartPair> pairs(a.size());
  std::vector<bool> taken(b.size());
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    pairs[i].a = i;
    const auto found = a[i].name.empty() ? in_b.end() : in_b.find(a[i].name);
    if (found == in_b.end() || taken[found->second]) continue;
    pairs[i].b = found->second;
    taken[found->second] = true;
  }
  // One that is lost must not shift the others: a box is paired with a box.
  std::unordered_map<std::string_view, std::deque<std::uint32_t>> by_kind;
  for (std::uint32_t i = 0; i < b.size(); ++i) {
    if (!taken[i]) by_kind[b[i].shape.kind].push_back(i);
  }
  for (PartPair& pair : pairs) {
    std::deque<std::uint32_t>& same = by_kind[a[pair.a].shape.kind];
    if (pair.b != kNoIndex || same.empty()) continue;
    pair.b = same.front();
    taken[pair.b] = true;
    same.pop_front();
  }
  std::uint32_t next = 0;
  const auto skip = [&] {
    while (next < b.size() && taken[next]) ++next;
  };
  for (PartPair& pair : pairs) {
    skip();
    if (pair.b == kNoIndex && next < b.size()) pair.b = next++;
  }
  for (skip(); next < b.size(); skip()) pairs.push_back({kNoIndex, next++});
  return pairs;
}

std::vector<BodyShift> shifts(const Robot& a, const Robot& b, const Match& match,
                              const TwinPoses& poses, const Tolerance& tolerance) {
  std::vector<BodyShift> all(a.bodies.size());
  for (const std::uint32_t i : a.order) {
    const std::uint32_t j = match.a.body[i];
    if (j == kNoIndex) continue;
    const std::uint32_t up =
        match.a.ancestor[i] != kNoIndex ? match.a.ancestor[i] : match.reference_a;
    const std::uint32_t up_b = match.a.body[up];
    Pose E_up = all[up].E;
    const auto in_parent_a = [&](std::size_t k) {
      const Pose R = i == up ? Pose{} : compose(inverse(poses.a(k, up)), poses.a(k, i));
      return E_up == Pose{} || i == up ? R : compose(E_up, R);
    };
    const auto in_parent_b = [&](std::size_t k) {
      return i == up ? Pose{} : compose(inverse(poses.b(k, up_b)), poses.b(k, j));
    };
    if (E_up != Pose{}) {  // what stands in the frame as before did not go along with the content
      const Pose moved = std::exchange(E_up, Pose{});
      if (!near(in_parent_a(0), in_parent_b(0), tolerance)) E_up = moved;
    }
    BodyShift& shift = all[i];
    const Pose rest_a = in_parent_a(0), rest_b = in_parent_b(0);
    shift.frame = apart(rest_a, rest_b);
    shift.frame_moved = !within(shift.frame, tolerance, length(rest_a.translation));
    const BodyVotes votes{a.bodies[i], b.bodies[j], tolerance,
                          pair_parts(a.bodies[i].collisions, b.bodies[j].collisions),
                          pair_parts(a.bodies[i].visuals, b.bodies[j].visuals)};
    const Pose stays = shift.frame_moved ? compose(inverse(rest_b), rest_a) : Pose{};
    shift.E = shift_of(votes, stays);
    if (shift.E != Pose{} && !near(rest_a, compose(rest_b, shift.E), tolerance)) {
      shift.content_moved = true;
      shift.content = apart({}, shift.E);
    }
    for (std::size_t k = 1; k < poses.count(); ++k) {
      Pose X_a = in_parent_a(k), X_b = in_parent_b(k);
      if (shift.frame_moved) {
        X_a = compose(inverse(rest_a), X_a);
        X_b = compose(inverse(rest_b), X_b);
      }
      const Apart off = apart(X_a, X_b);
      if (within(off, tolerance, length(X_a.translation))) continue;
      shift.motion_differs = true;
      if (off.distance + off.angle > shift.motion.distance + shift.motion.angle ||
          shift.configuration == 0) {
        shift.motion = off;
        shift.configuration = k;
      }
    }
  }
  return all;
}

}  // namespace rigor::robot
