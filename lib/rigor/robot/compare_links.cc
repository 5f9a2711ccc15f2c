// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include <rigor/robot/compare_parts.h>

namespace rigor::robot {
namespace {

/// What the bodies weigh with those that are fixed to them and have no
/// counterpart, in their own frames: that is what lumping leaves the same.
std::vector<mass::MassProperties> with_lumped(const Robot& robot, const Match::Side& side) {
  std::vector<mass::MassProperties> sums(robot.bodies.size());
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = robot.bodies[i].mass;
  for (std::size_t n = robot.order.size(); n-- > 0;) {
    const std::uint32_t i = robot.order[n];
    const std::uint32_t carrier = robot.bodies[i].carrier;
    if (side.body[i] != kNoIndex || carrier == kNoIndex) continue;
    const Joint& joint = robot.joints[carrier];
    if (joint.type != model::JointType::kFixed || sums[i] == mass::MassProperties{}) continue;
    sums[joint.parent] = mass::add(sums[joint.parent], mass::transformed(joint.X_PJ, sums[i]));
  }
  return sums;
}

double total_mass(const Robot& robot) {
  double total = 0;
  for (const Body& body : robot.bodies) total += body.mass.mass;
  return total;
}

class LinkComparer {
 public:
  explicit LinkComparer(Comparison& comparison)
      : c_(comparison),
        nothing_(std::max(kNothing, c_.tolerance.relative * total_mass(c_.a))),
        sums_a_(with_lumped(c_.a, c_.match.a)),
        sums_b_(with_lumped(c_.b, c_.match.b)) {}

  void compare() {
    for (std::uint32_t i = 0; i < c_.a.bodies.size(); ++i) {
      const std::uint32_t j = c_.match.a.body[i];
      if (j != kNoIndex) {
        pair(i, j);
      } else if (!c_.match.a.silent_body[i] && !is_frame(c_.a, c_.match.a, i)) {
        only_in_one(DifferenceKind::kLinkOnlyInA, c_.a.bodies[i]);
      }
    }
    for (std::uint32_t j = 0; j < c_.b.bodies.size(); ++j) {
      if (c_.match.b.body[j] != kNoIndex || c_.match.b.silent_body[j]) continue;
      if (!is_frame(c_.b, c_.match.b, j)) only_in_one(DifferenceKind::kLinkOnlyInB, c_.b.bodies[j]);
    }
  }

 private:
  /// Told with the frames.
  static bool is_frame(const Robot& robot, const Match::Side& side, std::uint32_t i) {
    const Body& body = robot.bodies[i];
    if (side.root_joint != kNoIndex && robot.joints[side.root_joint].parent == i) return true;
    return is_helper(body) && body.carrier != kNoIndex &&
           robot.joints[body.carrier].type == model::JointType::kFixed;
  }

  void only_in_one(DifferenceKind kind, const Body& body) {
    const bool in_a = kind == DifferenceKind::kLinkOnlyInA;
    const std::string name = subject("link", body.name);
    Difference& d = c_.add(kind, in_a ? name : "", in_a ? "" : name, in_a ? body.span : Span{},
                           in_a ? Span{} : body.span);
    (in_a ? d.from : d.to).numbers = {body.mass.mass};
    d.unit = "kg";
  }

  void pair(std::uint32_t i, std::uint32_t j) {
    const Body& x = c_.a.bodies[i];
    const Body& y = c_.b.bodies[j];
    const BodyShift& shift = c_.shifts[i];
    const auto add = [&](DifferenceKind kind) -> Difference& {
      return c_.add(kind, subject("link", x.name), subject("link", y.name), x.span, y.span);
    };
    if (c_.match.renamed_body[i]) add(DifferenceKind::kLinkRenamed);
    const bool free = x.carrier == kNoIndex && y.carrier == kNoIndex;
    if (shift.content_moved || (free && shift.frame_moved)) {
      const Apart& off = shift.content_moved ? shift.content : shift.frame;
      Difference& d = add(free && !shift.content_moved ? DifferenceKind::kRootPose
                                                       : DifferenceKind::kLinkMoved);
      d.distance = off.distance;
      d.angle = off.angle;
      d.unit = "m";
      if (free) {
        d.from.numbers = pose_numbers(x.X_MB);
        d.to.numbers = pose_numbers(y.X_MB);
      }
      c_.explained[i] = true;
    }
    compare_mass(i, j, add);
    compare_shapes(c_, i);
  }

  template <class Add>
  void compare_mass(std::uint32_t i, std::uint32_t j, Add add) {
    const model::Pose& E = c_.shifts[i].E;
    const auto shifted = [&E](const mass::MassProperties& body) {
      return E == model::Pose{} ? body : mass::transformed(E, body);
    };
    const mass::MassProperties x = shifted(c_.a.bodies[i].mass);  // as it would be in B's frame
    const mass::MassProperties& y = c_.b.bodies[j].mass;
    const mass::MassProperties sum_x = shifted(sums_a_[i]);
    const mass::MassProperties& sum_y = sums_b_[j];
    if (x.mass <= nothing_ && y.mass <= nothing_) return;
    if (!near(x.mass, y.mass, c_.tolerance) && !near(sum_x.mass, sum_y.mass, c_.tolerance)) {
      Difference& d = add(DifferenceKind::kMass);
      d.from.numbers = {x.mass};
      d.to.numbers = {y.mass};
      d.distance = std::abs(x.mass - y.mass);
      d.unit = "kg";
    }
    if (!near(x.com, y.com, c_.tolerance) && !near(sum_x.com, sum_y.com, c_.tolerance)) {
      Difference& d = add(DifferenceKind::kCenterOfMass);
      d.from.numbers = {x.com.x, x.com.y, x.com.z};
      d.to.numbers = {y.com.x, y.com.y, y.com.z};
      d.distance = length(y.com - x.com);
      d.unit = "m";
      c_.explained[i] = true;
    }
    // MuJoCo takes none below 1e-15 kg·m².
    constexpr double kNoMoment = 1e-14;
    if (std::max(mass::trace(x.about_com), mass::trace(y.about_com)) <= kNoMoment) return;
    if (near(x.about_com, y.about_com, c_.tolerance) ||
        near(sum_x.about_com, sum_y.about_com, c_.tolerance) || same_tensor_at_rest(i, j)) {
      return;
    }
    Difference& d = add(DifferenceKind::kInertia);
    d.from.numbers = tensor_numbers(x.about_com);
    d.to.numbers = tensor_numbers(y.about_com);
    for (std::size_t n = 0; n < d.to.numbers.size(); ++n) {
      d.distance = std::max(d.distance, std::abs(d.to.numbers[n] - d.from.numbers[n]));
    }
    d.unit = "kg·m²";
  }

  /// Along the axes of the reference body: a frame that was turned turns its tensor's numbers. Or
  /// along their own, unchanged: then it was the link that turned.
  bool same_tensor_at_rest(std::uint32_t i, std::uint32_t j) const {
    const mass::Inertia& x = c_.a.bodies[i].mass.about_com;
    const mass::Inertia& y = c_.b.bodies[j].mass.about_com;
    return near(x, y, c_.tolerance) ||
           near(mass::rotated(c_.poses.a(0, i).rotation, x),
                mass::rotated(c_.poses.b(0, j).rotation, y), c_.tolerance);
  }

  Comparison& c_;
  double nothing_;  ///< kg: two links of no more are the same
  std::vector<mass::MassProperties> sums_a_, sums_b_;
};

}  // namespace

void compare_links(Comparison& comparison) { LinkComparer(comparison).compare(); }

}  // namespace rigor::robot
