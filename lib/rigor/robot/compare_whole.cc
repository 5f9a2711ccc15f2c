// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The robots as wholes. Of what the parts have told already nothing is reported
// again.

#include <algorithm>
#include <cmath>
#include <limits>

#include <rigor/robot/compare_parts.h>

namespace rigor::robot {
namespace {

/// What sums are made of, without signs: what rounding grows with.
struct SumScale {
  double mass = 0;    ///< kg
  double first = 0;   ///< kg·m
  double second = 0;  ///< kg·m²
};

/// Of the bodies of at most this mass, kg.
SumScale scale_of(const Robot& robot, const std::vector<model::Pose>& X_RB,
                  double most = std::numeric_limits<double>::infinity()) {
  SumScale scale;
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    const mass::MassProperties& body = robot.bodies[i].mass;
    if (!(std::abs(body.mass) <= most)) continue;
    const double reach = length(X_RB[i].translation) + length(body.com);
    scale.mass += std::abs(body.mass);
    scale.first += std::abs(body.mass) * reach;
    scale.second += std::abs(body.mass) * reach * reach + std::abs(mass::trace(body.about_com));
  }
  return scale;
}

double farthest(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

class WholeComparer {
 public:
  explicit WholeComparer(Comparison& comparison) : c_(comparison) {}

  void compare() {
    compare_worlds();
    compare_sums();
    if (c_.names.placement == Placement::kReported) compare_placement();
  }

 private:
  Difference& add(DifferenceKind kind) {
    return c_.add(kind, subject("robot", c_.a.name), subject("robot", c_.b.name), {}, {});
  }

  /// Every thing of every pair that nothing is informed of yet.
  void compare_worlds() {
    std::vector<bool> explained = c_.explained;
    for (const std::uint32_t i : c_.a.order) {
      const std::uint32_t up = c_.match.a.ancestor[i];
      if (up != kNoIndex && explained[up]) explained[i] = true;
      if (c_.match.a.body[i] != kNoIndex && !explained[i]) compare_world(i);
    }
  }

  void compare_world(std::uint32_t i) {
    const std::uint32_t j = c_.match.a.body[i];
    const Body& x = c_.a.bodies[i];
    const Body& y = c_.b.bodies[j];
    Apart worst;
    std::size_t configuration = 0;
    bool differs = false;
    for (std::size_t k = 0; k < c_.poses.count(); ++k) {
      const auto hold = [&](const model::Pose& X_a, const model::Pose& X_b) {
        const Apart off = apart(X_a, X_b);
        if (within(off, c_.tolerance, length(X_a.translation))) return;
        differs = true;
        if (off.distance + off.angle <= worst.distance + worst.angle) return;
        worst = off;
        configuration = k;
      };
      const model::Pose& F_a = c_.poses.a(k, i);
      const model::Pose& F_b = c_.poses.b(k, j);
      hold(F_a, F_b);
      if (near(x.mass.com, y.mass.com, c_.tolerance)) {
        hold({transform(F_a, x.mass.com), {}}, {transform(F_b, y.mass.com), {}});
      }
      hold_parts(x.collisions, y.collisions, F_a, F_b, hold);
      hold_parts(x.visuals, y.visuals, F_a, F_b, hold);
    }
    if (!differs) return;
    Difference& d = c_.add(DifferenceKind::kWorldPose, subject("link", x.name),
                           subject("link", y.name), x.span, y.span);
    d.distance = worst.distance;
    d.angle = worst.angle;
    d.unit = "m";
    d.configuration = configuration;
  }

  template <class Hold>
  void hold_parts(const std::vector<Part>& xs, const std::vector<Part>& ys, const model::Pose& F_a,
                  const model::Pose& F_b, Hold hold) const {
    for (const PartPair& pair : pair_parts(xs, ys)) {
      if (pair.a == kNoIndex || pair.b == kNoIndex) continue;
      const model::Pose& X_a = xs[pair.a].X_BS;
      const model::Pose& X_b = ys[pair.b].X_BS;
      if (near(X_a, X_b, c_.tolerance)) hold(compose(F_a, X_a), compose(F_b, X_b));
    }
  }

  bool told(std::initializer_list<DifferenceKind> kinds) const {
    return std::any_of(c_.found.begin(), c_.found.end(), [&kinds](const Difference& d) {
      return std::find(kinds.begin(), kinds.end(), d.kind) != kinds.end();
    });
  }

  void compare_sums() {
    using enum DifferenceKind;
    const auto mass_of = [](const Robot& robot) {
      double sum = 0;
      for (const Body& body : robot.bodies) sum += body.mass.mass;
      return sum;
    };
    const double from = mass_of(c_.a), to = mass_of(c_.b);
    if (from <= kNothing && to <= kNothing) return;
    const bool structure = told({kLinkOnlyInA, kLinkOnlyInB});
    if (!near(from, to, c_.tolerance)) {
      if (!structure && told({kMass})) return;
      Difference& d = add(kTotalMass);
      d.from.numbers = {from};
      d.to.numbers = {to};
      d.distance = std::abs(to - from);
      d.unit = "kg";
      return;
    }
    const bool moved =
        std::find(c_.explained.begin(), c_.explained.end(), true) != c_.explained.end();
    if (!moved && !told({kMass, kInertia, kCenterOfMass, kRootPose, kWorldPose})) compare_moments();
  }

  void compare_moments() {
    Difference first, second;
    for (std::size_t k = 0; k < c_.poses.count(); ++k) {
      const Moments x = moments(c_.a, c_.poses.all_a(k)),
                    y = moments(c_.b_as_read, c_.poses.all_b(k));
      // What weighs next to nothing in B may weigh nothing in A.
      const SumScale all = scale_of(c_.a, c_.poses.all_a(k));
      const SumScale nothing = scale_of(c_.b_as_read, c_.poses.all_b(k), kNothing);
      const double relative = c_.tolerance.relative;
      const double off = c_.tolerance.distance;  // that every center of mass may be
      keep_worst(first, k, {x.first.x, x.first.y, x.first.z}, {y.first.x, y.first.y, y.first.z},
                 relative * all.first + off * all.mass + nothing.first);
      keep_worst(second, k, tensor_numbers(x.second), tensor_numbers(y.second),
                 relative * all.second + off * all.first + nothing.second);
    }
    tell(DifferenceKind::kTotalFirst, first, "kg·m");
    tell(DifferenceKind::kTotalSecond, second, "kg·m²");
  }

  void keep_worst(Difference& worst, std::size_t k, std::vector<double> from,
                  std::vector<double> to, double allowed) const {
    const double off = farthest(from, to);
    if (!(off > allowed) || off <= worst.distance) return;
    worst.from.numbers = std::move(from);
    worst.to.numbers = std::move(to);
    worst.distance = off;
    worst.configuration = k;
  }

  void tell(DifferenceKind kind, const Difference& worst, std::string_view unit) {
    if (worst.from.numbers.empty()) return;
    Difference& d = add(kind);
    d.from = worst.from;
    d.to = worst.to;
    d.distance = worst.distance;
    d.configuration = worst.configuration;
    d.unit = unit;
  }

  /// Only where both formats have a place for it.
  void compare_placement() {
    if (c_.a.X_WM && c_.b.X_WM) {
      compare_pose(DifferenceKind::kModelPose, *c_.a.X_WM, *c_.b.X_WM);
      if (c_.match.reference_a != kNoIndex) {
        const Body& x = c_.a.bodies[c_.match.reference_a];
        const Body& y = c_.b.bodies[c_.match.reference_b];
        if (x.carrier == kNoIndex && y.carrier == kNoIndex) {
          compare_pose(DifferenceKind::kRootPose, x.X_MB, y.X_MB);
        }
      }
    }
    if (c_.a.is_static && c_.b.is_static && *c_.a.is_static != *c_.b.is_static) {
      Difference& d = add(DifferenceKind::kStatic);
      d.from.text = *c_.a.is_static ? "static" : "not static";
      d.to.text = *c_.b.is_static ? "static" : "not static";
    }
  }

  void compare_pose(DifferenceKind kind, const model::Pose& x, const model::Pose& y) {
    if (near(x, y, c_.tolerance)) return;
    Difference& d = add(kind);
    d.from.numbers = pose_numbers(x);
    d.to.numbers = pose_numbers(y);
    d.unit = "m";
    const Apart off = apart(x, y);
    d.distance = off.distance;
    d.angle = off.angle;
  }

  Comparison& c_;
};

}  // namespace

void compare_whole(Comparison& comparison) { WholeComparer(comparison).compare(); }

}  // namespace rigor::robot
