// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/pose/stand_pose.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include <rigor/simulate/footprint.h>
#include <rigor/simulate/joint_load.h>
#include <rigor/simulate/metric/parts.h>
#include <rigor/simulate/mount.h>
#include <rigor/simulate/pose/posing.h>
#include <rigor/simulate/reach.h>
#include <rigor/simulate/stage.h>

namespace rigor::simulate {
namespace {

/// Of their mass and of the distance between them: the two legs of a pair are drawn apart.
constexpr double kPairSlack = 0.05;

/// Of its own height (the scene's size): feet end so far above the lowest point at most before a pose is sought.
constexpr double kFeetBand = 0.25;

/// Each pose that is tried costs the lowest point of every shape.
constexpr int kMaxTrials = 400;

/// The first step of the search, of a joint's range, and how often it is halved.
constexpr double kFirstStep = 0.25;
constexpr int kHalvings = 4;

/// A hinge without limits, or with more than a turn, is sought within a quarter turn of zero.
constexpr double kOpenRange = std::numbers::pi / 2;

/// rad: a stance that takes such a slope is good enough; beyond it the pose nearest to where it began wins.
constexpr double kGoodSlope = 0.25;

/// What a joint's whole range away from the begin is worth, in rad of that slope.
constexpr double kWayPrice = 0.05;

/// A legged robot has 12 to 60 joints; of a chain of thousands the limbs are not even counted.
constexpr std::size_t kMaxLeggedJoints = 200;

constexpr std::size_t kMaxReportedJoints = 6;

struct Limb {
  std::uint32_t trunk = 0;
  std::vector<std::uint32_t> joints;  ///< that can be commanded, from the trunk on
  std::vector<std::uint32_t> bodies;
  Vector3 root_W;
  double mass = 0;
};

/// Two limbs, and which way the second's joints turn when the first's do.
struct LegPair {
  const Limb* first = nullptr;
  const Limb* second = nullptr;
  std::vector<double> signs;
};

std::vector<Limb> limbs_of(const Scene& scene, std::uint32_t model) {
  const CarriedBodies carried(scene);
  std::vector<std::uint32_t> carriers(scene.bodies.size(),
                                      kWorld);  // the joint that holds each body
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    if (joint.child < carriers.size() && can_be_commanded(joint)) carriers[joint.child] = j;
  }
  std::vector<Limb> limbs;
  for (const SceneJoint& joint : scene.joints) {
    if (joint.parent >= scene.bodies.size() || joint.child >= scene.bodies.size()) continue;
    if (scene.bodies[joint.child].model != model) continue;
    Limb limb{.trunk = joint.parent, .bodies = carried.by(joint.child), .root_W = joint.anchor_W};
    for (const std::uint32_t body : limb.bodies) {
      limb.mass += scene.bodies[body].mass.mass;
      if (carriers[body] != kWorld) limb.joints.push_back(carriers[body]);
    }
    if (!limb.joints.empty()) limbs.push_back(std::move(limb));
  }
  return limbs;
}

/// How the second limb's joint mirrors the first's, across the plane between the limbs' roots; nothing when it does not.
std::optional<double> mirror_sign(const SceneJoint& a, const SceneJoint& b, const Vector3& across) {
  if (a.type != b.type) return std::nullopt;
  const Vector3& axis = a.axes[0].direction_W;
  const Vector3 along = dot(axis, across) * across;
  // An axis of rotation is mirrored as a turn is, one of a slider as an arrow is.
  const bool slides = a.type == model::JointType::kPrismatic;
  const Vector3 mirrored = slides ? axis - 2 * along : 2 * along - axis;
  const double cosine = dot(mirrored, b.axes[0].direction_W);
  if (std::abs(cosine) < 0.9) return std::nullopt;
  return cosine > 0 ? 1 : -1;
}

std::optional<LegPair> pair_of(const Scene& scene, const Limb& a, const Limb& b) {
  if (a.trunk != b.trunk || a.joints.size() != b.joints.size()) return std::nullopt;
  if (std::abs(a.mass - b.mass) > kPairSlack * std::max(a.mass, b.mass)) return std::nullopt;
  const Vector3 between = b.root_W - a.root_W;
  const double distance = length(between);
  if (!(distance > 0) || std::abs(between.z) > kPairSlack * distance) return std::nullopt;
  // Legs are mirrored to the side, not to the front: along x or along y of the file.
  const double least = std::min(std::abs(between.x), std::abs(between.y));
  if (least > kPairSlack * distance) return std::nullopt;
  LegPair pair{&a, &b, {}};
  for (std::size_t i = 0; i < a.joints.size(); ++i) {
    const auto sign =
        mirror_sign(scene.joints[a.joints[i]], scene.joints[b.joints[i]], (1 / distance) * between);
    if (!sign) return std::nullopt;
    pair.signs.push_back(*sign);
  }
  return pair;
}

double lowest_of(const LowestPoints& lowest, const Limb& limb) {
  double low = kInfinity;
  for (const std::uint32_t body : limb.bodies) low = std::min(low, lowest.of_body[body]);
  return low;
}

/// Pairs of limbs of one trunk: the trunk with the pair that reaches lowest, of several the one with the longest legs.
std::vector<LegPair> legs_of(const Scene& scene, std::uint32_t model,
                             const std::vector<Limb>& limbs) {
  const LowestPoints lowest(scene);
  const double band = lowest.of_model[model] + kFeetBand * scene.size;
  std::vector<LegPair> legs;
  std::vector<bool> taken(limbs.size());
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    for (std::size_t k = i + 1; k < limbs.size() && !taken[i]; ++k) {
      if (taken[k]) continue;
      std::optional<LegPair> pair = pair_of(scene, limbs[i], limbs[k]);
      if (!pair || lowest_of(lowest, limbs[i]) > band || lowest_of(lowest, limbs[k]) > band)
        continue;
      taken[i] = taken[k] = true;
      legs.push_back(std::move(*pair));
    }
  }
  // Toes are pairs, too: those count that carry the most.
  const auto longest = std::max_element(legs.begin(), legs.end(), [](const auto& a, const auto& b) {
    return a.first->joints.size() < b.first->joints.size();
  });
  if (longest == legs.end()) return {};
  const std::uint32_t trunk = longest->first->trunk;
  std::erase_if(legs, [&](const LegPair& pair) { return pair.first->trunk != trunk; });
  return legs;
}

/// Where a joint may be sought.
struct JointRange {
  double lower, upper;
  double middle() const { return (lower + upper) / 2; }
};

JointRange range_of(const SceneJoint& joint) {
  const SceneAxis& axis = joint.axes[0];
  const bool slides = joint.type == model::JointType::kPrismatic;
  const bool open = !std::isfinite(axis.lower) || !std::isfinite(axis.upper) ||
                    axis.upper - axis.lower > 2 * std::numbers::pi;
  if (slides && open) return {axis.start, axis.start};
  if (open) return {std::max(axis.lower, -kOpenRange), std::min(axis.upper, kOpenRange)};
  return {axis.lower, axis.upper};
}

class StandSearch {
 public:
  StandSearch(const Scene& scene, std::uint32_t model, const std::vector<LegPair>& legs)
      : scene_(scene), model_(model), legs_(legs), posing_(scene), is_leg_(scene.bodies.size()) {
    for (const LegPair& pair : legs) {
      for (const Limb* limb : {pair.first, pair.second}) {
        for (const std::uint32_t body : limb->bodies) is_leg_[body] = true;
      }
    }
  }

  bool is_tree() const { return posing_.is_tree(); }
  const std::vector<double>& start() const { return posing_.start(); }

  std::vector<double> middle() const {
    std::vector<double> positions = start();
    for (const LegPair& pair : legs_) {
      for (std::size_t i = 0; i < pair.signs.size(); ++i) {
        set(positions, pair, i, range_of(scene_.joints[pair.first->joints[i]]).middle());
      }
    }
    return positions;
  }

  /// Whether it stands on its legs, and on nothing else.
  bool stands(const std::vector<double>& positions) {
    return score(positions) > 0 && stands_by_itself(posing_.at(positions), model_);
  }

  /// The best pose near one. All legs move together before a pair does alone: one pair alone only lifts the other.
  std::vector<double> best_near(std::vector<double> positions) {
    std::vector<std::vector<double>> moves(2);
    std::size_t most = 0;
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      moves[0].push_back(1);
      moves[1].push_back(i % 2 == 0 ? 1 : -1);  // knees of the hind legs bend the other way
      most = std::max(most, legs_[i].signs.size());
    }
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      moves.emplace_back(legs_.size());
      moves.back()[i] = 1;
    }
    double best = score(positions);
    double share = kFirstStep;
    for (int i = 0; i <= kHalvings; ++i, share /= 2) {
      for (bool better = true; better && trials_ < kMaxTrials;) {
        better = false;
        for (const std::vector<double>& move : moves) {
          for (std::size_t k = 0; k < most; ++k) {
            better = step(move, k, share, positions, best) || better;
          }
        }
      }
    }
    return positions;
  }

 private:
  /// Both legs of a pair, within the limits of each.
  void set(std::vector<double>& positions, const LegPair& pair, std::size_t k, double value) const {
    const JointRange first = range_of(scene_.joints[pair.first->joints[k]]);
    const JointRange second = range_of(scene_.joints[pair.second->joints[k]]);
    positions[pair.first->joints[k]] = std::clamp(value, first.lower, first.upper);
    positions[pair.second->joints[k]] =
        std::clamp(pair.signs[k] * value, second.lower, second.upper);
  }

  /// The k-th joint of each pair that the move names, by a share of its range.
  bool step(const std::vector<double>& move, std::size_t k, double share,
            std::vector<double>& positions, double& best) {
    for (const double way : {share, -share}) {
      if (trials_ >= kMaxTrials) return false;
      std::vector<double> tried = positions;
      for (std::size_t i = 0; i < legs_.size(); ++i) {
        const LegPair& pair = legs_[i];
        if (move[i] == 0 || k >= pair.signs.size()) continue;
        const std::uint32_t joint = pair.first->joints[k];
        const JointRange range = range_of(scene_.joints[joint]);
        set(tried, pair, k, positions[joint] + move[i] * way * (range.upper - range.lower));
      }
      if (tried == positions) continue;
      const double reached = score(tried);
      if (!(reached > best)) continue;
      best = reached;
      positions = std::move(tried);
      return true;
    }
    return false;
  }

  /// rad: the slope that it stands on, less what the way to the pose costs; below -1 as long as a foot is in the air or
  /// something else than a foot is lowest.
  double score(const std::vector<double>& positions) {
    ++trials_;
    const Scene& posed = posing_.at(positions);
    const LowestPoints lowest(posed);
    const double ground = lowest.of_model[model_];
    const double slack = std::max(kFootSlack, kFeetSlack * scene_.size);
    double highest_foot = ground;
    for (const LegPair& pair : legs_) {
      for (const Limb* limb : {pair.first, pair.second}) {
        highest_foot = std::max(highest_foot, lowest_of(lowest, *limb));
      }
    }
    const double cost = kWayPrice * way_to(positions);
    if (highest_foot > ground + slack) return -1 - (highest_foot - ground) / scene_.size - cost;
    for (std::uint32_t b = 0; b < posed.bodies.size(); ++b) {
      const bool other = posed.bodies[b].model == model_ && !is_leg_[b];
      if (other && lowest.of_body[b] <= ground + slack) return -2 - cost;
    }
    const std::vector<Vector3> corners = footprint_at_start(posed, model_, slack);
    if (corners.size() < 3) return -1 - cost;
    return std::min(tip_angle(posed, model_, corners).angle, kGoodSlope) - cost;
  }

  /// The mean square of the legs' joints' ways from the start, as shares of their ranges.
  double way_to(const std::vector<double>& positions) const {
    double sum = 0;
    double count = 0;
    for (const LegPair& pair : legs_) {
      for (const std::uint32_t joint : pair.first->joints) {
        const JointRange range = range_of(scene_.joints[joint]);
        if (!(range.upper > range.lower)) continue;
        const double way = (positions[joint] - start()[joint]) / (range.upper - range.lower);
        sum += way * way;
        count += 1;
      }
    }
    return count > 0 ? sum / count : 0;
  }

  const Scene& scene_;
  std::uint32_t model_;
  const std::vector<LegPair>& legs_;
  Posing posing_;
  std::vector<bool> is_leg_;
  int trials_ = 0;
};

/// Of the start, with what the state names.
std::vector<double> positions_in(const Scene& scene, const GroupState& state,
                                 std::vector<double> positions) {
  for (const auto& [name, value] : state.positions) {
    for (std::size_t j = 0; j < scene.joints.size(); ++j) {
      if (is_named(scene.joints[j].name, name) && can_be_commanded(scene.joints[j]))
        positions[j] = value;
    }
  }
  return positions;
}

std::string three_digits(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3);
  return {text.data(), end.ptr};
}

}  // namespace

StandPose find_stand_pose(const Scene& scene, const DriveTrain& wheels,
                          const std::vector<GroupState>& states) {
  if (!scene.alone || !wheels.empty() || scene.models.size() != 1 || !stands_free(scene, 0))
    return {};
  // With half of its shapes nobody knows what its feet are.
  if (scene.models[0].missing_shapes > 0 || lowest_of_model(scene, 0) == kInfinity) return {};
  if (scene.joints.size() > kMaxLeggedJoints) return {};
  const std::vector<Limb> limbs = limbs_of(scene, 0);
  const std::vector<LegPair> legs = legs_of(scene, 0, limbs);
  if (legs.empty()) return {};
  StandSearch search(scene, 0, legs);
  if (!search.is_tree()) return {};
  for (const GroupState& state : states) {
    std::vector<double> positions = positions_in(scene, state, search.start());
    if (search.stands(positions)) {
      return {StandPose::Need::kFound, "the state '" + state.name + "' of " + state.file,
              std::move(positions)};
    }
  }
  if (stands_by_itself(scene, 0)) return {};
  std::vector<double> middle = search.middle();
  if (search.stands(middle)) {
    return {StandPose::Need::kFound, "the middle of the limits of its legs", std::move(middle)};
  }
  for (const std::vector<double>& from : {search.start(), middle}) {
    std::vector<double> positions = search.best_near(from);
    if (search.stands(positions)) {
      return {StandPose::Need::kFound, "a search for feet on the ground", std::move(positions)};
    }
  }
  return {StandPose::Need::kNotFound, {}, {}};
}

Scene in_stand_pose(const Scene& scene, const StandPose& pose) {
  Posing posing(scene);
  return stage(posing.at(pose.positions), {.name = {}, .spawn = Spawn::kOnGround, .ground = false});
}

std::string in_words(const Scene& scene, const StandPose& pose) {
  if (pose.need == StandPose::Need::kNone) return {};
  if (!pose.found()) {
    return "its legs do not stand as the model begins, and no other pose was found in which they "
           "do";
  }
  std::string words = "begins in a pose in which it stands, from " + pose.from + ": ";
  std::size_t reported = 0;
  std::size_t more = 0;
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    if (joint.axes.size() != 1 || pose.positions[j] == joint.axes[0].start) continue;
    if (reported == kMaxReportedJoints) {
      ++more;
      continue;
    }
    const std::string name = joint.name.substr(joint.name.rfind(':') + 1);
    const bool slides = joint.type == model::JointType::kPrismatic;
    words += (reported == 0 ? "" : ", ") + name + '=' + three_digits(pose.positions[j]) +
             (slides ? " m" : " rad");
    ++reported;
  }
  if (more > 0) words += " and " + std::to_string(more) + " more";
  return words + " (--joint NAME=VALUE begins elsewhere)";
}

}  // namespace rigor::simulate
