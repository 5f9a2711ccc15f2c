// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <rigor/robot/compare_parts.h>

namespace rigor::robot {
namespace {

using model::JointType;

/// A number of an axis that both formats have.
struct AxisNumber {
  DifferenceKind kind;
  double Axis::*number;
  std::string_view turning, sliding;  ///< units
  bool limits = false;                ///< whether it stands in `<limit>`
};

constexpr AxisNumber kAxisNumbers[] = {
    {DifferenceKind::kLower, &Axis::lower, "rad", "m", true},
    {DifferenceKind::kUpper, &Axis::upper, "rad", "m", true},
    {DifferenceKind::kEffort, &Axis::effort, "N·m", "N", true},
    {DifferenceKind::kVelocity, &Axis::velocity, "rad/s", "m/s", true},
    {DifferenceKind::kDamping, &Axis::damping, "N·m·s/rad", "N·s/m"},
    {DifferenceKind::kFriction, &Axis::friction, "N·m", "N"},
};

/// What URDF has no word for.
constexpr AxisNumber kSpringNumbers[] = {
    {DifferenceKind::kSpringReference, &Axis::spring_reference, "rad", "m"},
    {DifferenceKind::kSpringStiffness, &Axis::spring_stiffness, "N·m/rad", "N/m"},
};

/// Joints that follow each other in a row before nobody asks any more.
constexpr int kMaxFollowed = 100;

/// The first joint of each name.
using JointNames = std::unordered_map<std::string_view, std::uint32_t>;

JointNames joints_by_name(const Robot& robot) {
  JointNames found;
  for (std::uint32_t i = 0; i < robot.joints.size(); ++i)
    found.try_emplace(robot.joints[i].name, i);
  return found;
}

class JointComparer {
 public:
  explicit JointComparer(Comparison& comparison)
      : c_(comparison), a_(joints_by_name(comparison.a)), b_(joints_by_name(comparison.b)) {}

  void compare() {
    for (std::uint32_t i = 0; i < c_.a.joints.size(); ++i) {
      if (c_.match.a.joint[i] != kNoIndex) {
        pair(i);
      } else if (!c_.match.a.silent_joint[i] && !of_frame(c_.a, c_.match.a, i)) {
        only(DifferenceKind::kJointOnlyInA, c_.a.joints[i]);
      }
    }
    for (std::uint32_t j = 0; j < c_.b.joints.size(); ++j) {
      if (c_.match.b.joint[j] != kNoIndex || c_.match.b.silent_joint[j]) continue;
      if (!of_frame(c_.b, c_.match.b, j)) only(DifferenceKind::kJointOnlyInB, c_.b.joints[j]);
    }
  }

 private:
  /// The joint of a link that is nothing but a frame is reported with that.
  static bool of_frame(const Robot& robot, const Match::Side& side, std::uint32_t i) {
    const Joint& joint = robot.joints[i];
    if (i == side.root_joint) return true;
    return joint.type == JointType::kFixed && side.body[joint.child] == kNoIndex &&
           is_helper(robot.bodies[joint.child]);
  }

  void only(DifferenceKind kind, const Joint& joint) {
    const bool in_a = kind == DifferenceKind::kJointOnlyInA;
    const std::string name = subject("joint", joint.name);
    Difference& d = c_.add(kind, in_a ? name : "", in_a ? "" : name, in_a ? joint.span : Span{},
                           in_a ? Span{} : joint.span);
    (in_a ? d.from : d.to).text = to_string(joint.type);
  }

  void pair(std::uint32_t i) {
    const Joint& x = c_.a.joints[i];
    const std::vector<std::uint32_t>& several = c_.match.substitutes[i];
    const Joint& last = c_.b.joints[end_of_row(several, c_.match.a.joint[i], End::kLast)];
    const Joint& first = c_.b.joints[end_of_row(several, c_.match.a.joint[i], End::kFirst)];
    const std::size_t before = c_.found.size();
    const auto add = [&](DifferenceKind kind) -> Difference& {
      return c_.add(kind, subject("joint", x.name), subject("joint", last.name), x.span, last.span);
    };
    if (c_.match.renamed_joint[i]) add(DifferenceKind::kJointRenamed);
    if (several.empty() && x.type != last.type) {
      Difference& d = add(DifferenceKind::kJointType);
      d.from.text = to_string(x.type);
      d.to.text = to_string(last.type);
    }
    compare_ends(x, first, last, add);
    if (!x.closes_loop) moved(i, x, first, last, add);
    for (std::uint32_t k = 0; k < x.axes.size(); ++k) {
      const Match::Axis& other = c_.match.axes[i][k];
      if (other.joint != kNoIndex) compare_axis(i, k, other);
    }
    // What moves in another way for a reason that is reported; where a joint stands is allowed for.
    const std::vector<DifferenceKind> otherwise = {
        DifferenceKind::kJointType, DifferenceKind::kJointParent, DifferenceKind::kJointChild,
        DifferenceKind::kJointAxis};
    if (x.closes_loop) {
      compare_loop(x, last, add);
    } else if (c_.shifts[x.child].motion_differs && !reported_since(before, otherwise)) {
      const BodyShift& shift = c_.shifts[x.child];
      Difference& d = add(DifferenceKind::kJointMotion);
      d.distance = shift.motion.distance;
      d.angle = shift.motion.angle;
      d.unit = "m";
      d.configuration = shift.configuration;
    }
    if (reported_since(before, otherwise) ||
        reported_since(before, {DifferenceKind::kJointMoved, DifferenceKind::kJointMotion})) {
      c_.explained[x.child] = true;
    }
  }

  enum class End : std::uint8_t { kFirst, kLast };

  /// Of B's joints in a row that represent one, in the order of its axes, the one at that end of the row:
  /// a screw's slides before it turns.
  std::uint32_t end_of_row(const std::vector<std::uint32_t>& row, std::uint32_t only,
                           End end) const {
    for (const std::uint32_t one : row) {
      const bool inner = std::any_of(row.begin(), row.end(), [&](std::uint32_t other) {
        return end == End::kFirst ? c_.b.joints[other].child == c_.b.joints[one].parent
                                  : c_.b.joints[other].parent == c_.b.joints[one].child;
      });
      if (!inner) return one;
    }
    return only;
  }

  /// Whether one of the kinds is derived from there on.
  bool reported_since(std::size_t first, const std::vector<DifferenceKind>& kinds) const {
    return std::any_of(c_.found.begin() + static_cast<std::ptrdiff_t>(first), c_.found.end(),
                       [&kinds](const Difference& d) {
                         return std::find(kinds.begin(), kinds.end(), d.kind) != kinds.end();
                       });
  }

  /// The matched body that an end is, or is fixed to.
  static std::uint32_t stands_for(const Match::Side& side, std::uint32_t body) {
    return side.body[body] != kNoIndex ? body : side.ancestor[body];
  }

  template <class Add>
  void compare_ends(const Joint& x, const Joint& first, const Joint& last, Add add) {
    const auto differ = [this](std::uint32_t in_a, std::uint32_t in_b) {
      const std::uint32_t a = stands_for(c_.match.a, in_a), b = stands_for(c_.match.b, in_b);
      return (a == kNoIndex ? kNoIndex : c_.match.a.body[a]) != b;
    };
    const auto tell = [&](DifferenceKind kind, std::uint32_t in_a, std::uint32_t in_b) {
      Difference& d = add(kind);
      d.from.text = c_.a.bodies[in_a].name;
      d.to.text = c_.b.bodies[in_b].name;
    };
    if (differ(x.parent, first.parent)) tell(DifferenceKind::kJointParent, x.parent, first.parent);
    if (differ(x.child, last.child)) tell(DifferenceKind::kJointChild, x.child, last.child);
  }

  template <class Add>
  void moved(std::uint32_t i, const Joint& x, const Joint& first, const Joint& last, Add add) {
    const BodyShift& shift = c_.shifts[x.child];
    const bool carries = c_.a.bodies[x.child].carrier == i && c_.match.a.body[x.child] != kNoIndex;
    if (carries && !shift.frame_moved) return;
    // Of a joint whose child has no counterpart, what the files say.
    const Apart off = carries ? shift.frame : apart(x.X_PJ, first.X_PJ);
    if (!carries && (c_.match.a.body[x.parent] != first.parent ||
                     near(x.X_PJ, first.X_PJ, c_.tolerance) || last.closes_loop)) {
      return;
    }
    Difference& d = add(DifferenceKind::kJointMoved);
    d.from.numbers = pose_numbers(x.X_PJ);
    d.to.numbers = pose_numbers(first.X_PJ);
    d.unit = "m";
    d.distance = off.distance;
    d.angle = off.angle;
  }

  /// A joint that closes a loop has a place in both of its bodies.
  template <class Add>
  void compare_loop(const Joint& x, const Joint& y, Add add) {
    const auto expected = [this](std::uint32_t body, const model::Pose& X) {
      const model::Pose& E = c_.shifts[body].E;
      return E == model::Pose{} ? X : compose(E, X);
    };
    const Apart in_parent = apart(expected(x.parent, x.X_PJ), y.X_PJ);
    const Apart in_child = apart(expected(x.child, x.X_CJ), y.X_CJ);
    if (within(in_parent, c_.tolerance, length(x.X_PJ.translation)) &&
        within(in_child, c_.tolerance, length(x.X_CJ.translation))) {
      return;
    }
    Difference& d = add(DifferenceKind::kJointMoved);
    d.from.numbers = pose_numbers(x.X_PJ);
    d.to.numbers = pose_numbers(y.X_PJ);
    d.unit = "m";
    d.distance = std::max(in_parent.distance, in_child.distance);
    d.angle = std::max(in_parent.angle, in_child.angle);
  }

  void compare_axis(std::uint32_t i, std::uint32_t k, const Match::Axis& other) {
    const Joint& joint_a = c_.a.joints[i];
    const Joint& joint_b = c_.b.joints[other.joint];
    const Axis& x = joint_a.axes[k];
    const Axis& y = joint_b.axes[other.axis];
    const std::string nth = joint_a.axes.size() > 1 ? " axis " + std::to_string(k + 1) : "";
    const auto add = [&](DifferenceKind kind) -> Difference& {
      return c_.add(kind, subject("joint", joint_a.name) + nth, subject("joint", joint_b.name),
                    x.span, y.span);
    };
    compare_direction(joint_a, x, joint_b, y, add);
    const auto compare = [&](const AxisNumber& number) {
      const double from = x.*number.number, to = y.*number.number;
      if (near(from, to, c_.tolerance) || stands_for_none(from, to)) return;
      Difference& d = add(number.kind);
      d.from.numbers = {from};
      d.to.numbers = {to};
      d.unit = x.motion == Axis::Motion::kSlide ? number.sliding : number.turning;
      d.distance = std::abs(to - from);
      if (!number.limits) return;
      if (!x.limit_span.nowhere()) d.span_a = x.limit_span;
      if (!y.limit_span.nowhere()) d.span_b = y.limit_span;
    };
    for (const AxisNumber& number : kAxisNumbers) compare(number);
    if (c_.names.placement == Placement::kReported) {
      for (const AxisNumber& number : kSpringNumbers) compare(number);
    }
    compare_follow(x, y, add);
  }

  bool stands_for_none(double limit, double number) const {
    return std::isinf(limit) && number == std::copysign(c_.names.unlimited, limit);
  }

  /// In the joint frames, or where these differ in what they hang on.
  template <class Add>
  void compare_direction(const Joint& joint_a, const Axis& x, const Joint& joint_b, const Axis& y,
                         Add add) {
    const auto angle = [](const model::Vector3& p, const model::Vector3& q) {
      return p == q ? 0 : std::atan2(length(cross(p, q)), dot(p, q));
    };
    const double own = angle(x.direction, y.direction);
    if (own <= c_.tolerance.angle && near(x.slide, y.slide, c_.tolerance)) return;
    const bool screw_too = near(x.slide, y.slide, c_.tolerance) ||
                           y.motion != Axis::Motion::kScrew;  // substituted by two joints
    const model::Quaternion& R = c_.shifts[joint_a.parent].E.rotation;
    const double hung = angle(rotate(R, rotate(joint_a.X_PJ.rotation, x.direction)),
                              rotate(joint_b.X_PJ.rotation, y.direction));
    if (screw_too && (own <= c_.tolerance.angle || hung <= c_.tolerance.angle)) return;
    Difference& d = add(DifferenceKind::kJointAxis);
    d.from.numbers = {x.direction.x, x.direction.y, x.direction.z};
    d.to.numbers = {y.direction.x, y.direction.y, y.direction.z};
    d.angle = own;
    if (x.slide != 0 || y.slide != 0) {
      d.from.numbers.push_back(x.slide);
      d.to.numbers.push_back(y.slide);
    }
  }

  template <class Add>
  void compare_follow(const Axis& x, const Axis& y, Add add) {
    if (!x.follow && !y.follow) return;
    if (x.follow && y.follow && same_follow(*x.follow, *y.follow)) return;
    Difference& d = add(DifferenceKind::kMimic);
    const auto say = [](const std::optional<Mimic>& follow, DifferenceValue& value) {
      if (!follow) return;
      value.text = follow->joint + (follow->axis > 0 ? " axis 2" : "");
      value.numbers = {follow->multiplier, follow->offset};
    };
    say(x.follow, d.from);
    say(y.follow, d.to);
  }

  /// Whom it follows in the end, and how: a follower of a follower may as well name the leader of both.
  static Mimic in_the_end(const Robot& robot, const JointNames& names, Mimic follow) {
    const Mimic written = follow;
    for (int steps = 0; steps < kMaxFollowed; ++steps) {
      const auto leader = names.find(follow.joint);
      if (leader == names.end()) return follow;
      const std::vector<Axis>& axes = robot.joints[leader->second].axes;
      if (follow.axis >= axes.size()) return follow;
      const std::optional<Mimic>& next = axes[follow.axis].follow;
      if (!next) return follow;
      follow = {.joint = next->joint,
                .axis = next->axis,
                .multiplier = follow.multiplier * next->multiplier,
                .offset = follow.multiplier * next->offset + follow.offset};
    }
    return written;  // a circle has no end
  }

  bool same_follow(const Mimic& written_x, const Mimic& written_y) const {
    const Mimic x = in_the_end(c_.a, a_, written_x), y = in_the_end(c_.b, b_, written_y);
    // A folded reference comes with the rounding of its product.
    const double scale = std::max({1.0, std::abs(x.offset), std::abs(x.multiplier)});
    const bool offset =
        x.offset == y.offset || std::abs(x.offset - y.offset) <= c_.tolerance.relative * scale;
    return offset && near(x.multiplier, y.multiplier, c_.tolerance) && same_leader(x, y);
  }

  bool same_leader(const Mimic& x, const Mimic& y) const {
    const auto leader = a_.find(x.joint);
    if (leader != a_.end() && x.axis < c_.match.axes[leader->second].size()) {
      const Match::Axis& other = c_.match.axes[leader->second][x.axis];
      return other.joint != kNoIndex && c_.b.joints[other.joint].name == y.joint &&
             other.axis == y.axis;
    }
    return x.joint == y.joint && x.axis == y.axis;  // nobody's: the same nonsense in both
  }

  Comparison& c_;
  const JointNames a_, b_;
};

}  // namespace

void compare_joints(Comparison& comparison) { JointComparer(comparison).compare(); }

}  // namespace rigor::robot
