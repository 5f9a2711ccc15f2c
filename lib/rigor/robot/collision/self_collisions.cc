// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/collision/self_collisions.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <rigor/robot/random.h>
#include <rigor/text/for_each_index.h>

namespace rigor::robot {
namespace {

// As MoveIt has them: of so many samples, this share makes a pair one that always collides.
constexpr std::size_t kTrialSamples = 200;
constexpr double kAlwaysShare = 0.95;

/// After so many samples, pairs that were seen to collide are left out of the rest.
constexpr std::size_t kBatch = 512;

/// m to each side, of a sliding axis without limits: more than arms reach.
constexpr double kOpenSlide = 1;

struct AxisSpan {
  double lower = 0, upper = 0;
};

AxisSpan sampled_span(const Axis& axis) {
  const double open = axis.motion == Axis::Motion::kSlide ? kOpenSlide : std::numbers::pi;
  const bool has_lower = std::isfinite(axis.lower), has_upper = std::isfinite(axis.upper);
  AxisSpan span{has_lower ? axis.lower : -open, has_upper ? axis.upper : open};
  if (!has_lower) span.lower = std::min(span.lower, span.upper);
  if (!has_upper) span.upper = std::max(span.upper, span.lower);
  return span.lower <= span.upper ? span : AxisSpan{span.lower, span.lower};
}

Positions sampled_positions(const Robot& robot, std::uint64_t seed, std::size_t sample) {
  Random random(Random(seed + sample).next());
  Positions positions(robot.joints.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    for (const Axis& axis : robot.joints[j].axes) {
      const AxisSpan span = sampled_span(axis);
      positions[j].push_back(random.between(span.lower, span.upper));
    }
  }
  return followed(robot, std::move(positions));
}

class PairSampler {
 public:
  PairSampler(const Robot& robot, const CollisionBodies& bodies, const SampleOptions& options,
              Turns& turns)
      : robot_(robot), bodies_(bodies), options_(options), turns_(turns) {}

  /// How many samples of [begin, end) each of the pairs collides at.
  std::vector<std::size_t> hits(const std::vector<LinkPair*>& pairs, std::size_t begin,
                                std::size_t end) const {
    std::vector<std::atomic<std::size_t>> counts(pairs.size());
    for_each_index(end - begin, turns_, 8, [&](std::size_t i) {
      const CollisionPoses poses =
          bodies_.placed(body_poses(robot_, sampled_positions(robot_, options_.seed, begin + i)));
      for (std::size_t p = 0; p < pairs.size(); ++p) {
        if (bodies_.collide(pairs[p]->a, pairs[p]->b, poses)) ++counts[p];
      }
    });
    return {counts.begin(), counts.end()};
  }

  void classify(std::vector<LinkPair*> open) const {
    const std::size_t trial = std::min(kTrialSamples, options_.samples);
    const double always = kAlwaysShare * static_cast<double>(trial);
    const auto at_trial = hits(open, 0, trial);
    std::vector<LinkPair*> free;
    for (std::size_t p = 0; p < open.size(); ++p) {
      const auto count = static_cast<double>(at_trial[p]);
      if (count == 0)
        free.push_back(open[p]);
      else if (count >= always)
        open[p]->kind = PairKind::kAlways;
    }
    for (std::size_t begin = trial; begin < options_.samples && !free.empty(); begin += kBatch) {
      const auto counts = hits(free, begin, std::min(begin + kBatch, options_.samples));
      std::vector<LinkPair*> rest;
      for (std::size_t p = 0; p < free.size(); ++p) {
        if (counts[p] == 0) rest.push_back(free[p]);
      }
      free = std::move(rest);
    }
    if (options_.samples == 0) return;
    for (LinkPair* pair : free) {
      if (bodies_.is_complete(pair->a) && bodies_.is_complete(pair->b))
        pair->kind = PairKind::kNever;
    }
  }

 private:
  const Robot& robot_;
  const CollisionBodies& bodies_;
  const SampleOptions& options_;
  Turns& turns_;
};

}  // namespace

Positions rest_positions(const Robot& robot) {
  Positions positions(robot.joints.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    for (const Axis& axis : robot.joints[j].axes) {
      double q = 0;
      if (axis.lower > 0)
        q = std::isfinite(axis.upper) ? (axis.lower + axis.upper) / 2 : axis.lower;
      else if (axis.upper < 0)
        q = std::isfinite(axis.lower) ? (axis.lower + axis.upper) / 2 : axis.upper;
      positions[j].push_back(q);
    }
  }
  return followed(robot, std::move(positions));
}

std::vector<LinkPair> adjacent_pairs(const Robot& robot,
                                     const std::vector<bool>& bodies_with_shape) {
  std::vector<std::vector<std::uint32_t>> neighbors(robot.bodies.size());
  for (const Joint& joint : robot.joints) {
    if (joint.parent == kNoIndex || joint.child == kNoIndex) continue;
    neighbors[joint.parent].push_back(joint.child);
    neighbors[joint.child].push_back(joint.parent);
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> found;
  for (std::uint32_t from = 0; from < robot.bodies.size(); ++from) {
    if (!bodies_with_shape[from]) continue;
    std::vector<bool> seen(robot.bodies.size());
    std::vector<std::uint32_t> passed{from};  // the body, and bodies without a shape
    seen[from] = true;
    for (std::size_t i = 0; i < passed.size(); ++i) {
      for (const std::uint32_t next : neighbors[passed[i]]) {
        if (seen[next]) continue;
        seen[next] = true;
        if (bodies_with_shape[next])
          found.emplace(std::min(from, next), std::max(from, next));
        else
          passed.push_back(next);
      }
    }
  }
  std::vector<LinkPair> pairs;
  for (const auto& [a, b] : found) pairs.push_back({a, b, PairKind::kAdjacent});
  return pairs;
}

SelfCollisions self_collisions(const Robot& robot, const CollisionBodies& bodies,
                               const SampleOptions& options, Turns& turns) {
  std::vector<bool> with_shape(robot.bodies.size());
  for (std::uint32_t i = 0; i < with_shape.size(); ++i) with_shape[i] = bodies.has_shape(i);
  if (std::count(with_shape.begin(), with_shape.end(), true) >
      static_cast<std::ptrdiff_t>(kMaxCollisionLinks))
    return {.too_many_links = true};
  std::set<std::pair<std::uint32_t, std::uint32_t>> adjacent;
  for (const LinkPair& pair : adjacent_pairs(robot, with_shape)) adjacent.emplace(pair.a, pair.b);
  const CollisionPoses at_rest = bodies.placed(body_poses(robot, rest_positions(robot)));
  SelfCollisions result;
  for (std::uint32_t a = 0; a < with_shape.size(); ++a) {
    for (std::uint32_t b = a + 1; b < with_shape.size(); ++b) {
      if (!with_shape[a] || !with_shape[b]) continue;
      LinkPair pair{a, b};
      if (adjacent.contains({a, b}))
        pair.kind = PairKind::kAdjacent;
      else if (bodies.collide(a, b, at_rest))
        pair.kind = PairKind::kDefault;
      result.pairs.push_back(pair);
    }
  }
  std::vector<LinkPair*> open;
  for (LinkPair& pair : result.pairs) {
    if (pair.kind == PairKind::kSometimes) open.push_back(&pair);
  }
  PairSampler(robot, bodies, options, turns).classify(std::move(open));
  return result;
}

}  // namespace rigor::robot
