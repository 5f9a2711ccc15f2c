// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What couples joints: mimics, gearboxes, threads of screws, joints whose limits leave one position; and joints that
// close loops, as constraints between bodies.

#include <cmath>
#include <string>

#include <rigor/convert/mjcf/draft.h>
#include <rigor/model/subject.h>

namespace rigor::convert {
namespace {

using model::JointType;
using model::Pose;
using model::Vector3;

/// Two points on the axis of a hinge that closes a loop are this far apart, m: about as wide as a bearing.
constexpr double kBearing = 0.1;

class MjcfCoupler {
 public:
  explicit MjcfCoupler(MjcfDraft& draft) : draft_(draft), robot_(draft.robot()) {}

  void couple() {
    for (std::uint32_t i = 0; i < robot_.joints.size(); ++i) {
      if (robot_.joints[i].closes_loop) {
        close_loop(robot_.joints[i]);
      } else {
        couple_axes(i);
      }
    }
  }

 private:
  /// y = offset + slope · x; without x, y = offset.
  void add(const std::string& y, const std::string& x, double offset, double slope) {
    MjcfElement element{"joint", {{"joint1", y}}};
    if (!x.empty()) element.set("joint2", x);
    element.set("polycoef", mjcf_numbers({offset, x.empty() ? 0 : slope, 0, 0, 0}));
    draft_.equality.add(std::move(element));
  }

  void couple_axes(std::uint32_t i) {
    const robot::Joint& joint = robot_.joints[i];
    for (std::size_t k = 0; k < joint.axes.size() && k < draft_.joint_names[i].size(); ++k) {
      const robot::Axis& axis = joint.axes[k];
      const std::string& name = draft_.joint_names[i][k];
      if (length(axis.direction) == 0) continue;
      if (axis.motion == robot::Axis::Motion::kScrew) add(name + "_slide", name, 0, axis.slide);
      if (axis.lower == axis.upper) add(name, {}, axis.lower, 0);
      if (axis.follow) follow(joint, axis, name);
    }
  }

  void follow(const robot::Joint& joint, const robot::Axis& axis, const std::string& name) {
    for (std::uint32_t i = 0; i < robot_.joints.size(); ++i) {
      const auto& names = draft_.joint_names[i];
      const bool leads = robot_.joints[i].name == axis.follow->joint && &robot_.joints[i] != &joint;
      if (!leads || axis.follow->axis >= names.size() ||
          names.size() != robot_.joints[i].axes.size())
        continue;
      return add(name, names[axis.follow->axis], axis.follow->offset, axis.follow->multiplier);
    }
    const model::Joint* source = draft_.entities.joint(joint.span);
    if (source == nullptr) return;
    draft_.ledger.note({.kind = NoteKind::kMimicLost,
                        .outcome = Outcome::kLost,
                        .where = source->site.name,
                        .subject = model::subject(draft_.root(), *source),
                        .written = axis.follow->joint,
                        .instead = "it moves freely"});
  }

  void connect(const robot::Joint& joint, const Vector3& anchor_P) {
    MjcfElement element{"connect", {{"body1", robot_.bodies[joint.parent].name}}};
    element.set("body2", robot_.bodies[joint.child].name);
    element.set("anchor", mjcf_numbers({anchor_P.x, anchor_P.y, anchor_P.z}));
    draft_.equality.add(std::move(element));
  }

  void close_loop(const robot::Joint& joint) {
    std::string instead;
    switch (joint.type) {
      case JointType::kFixed:
        draft_.equality.add({"weld",
                             {{"body1", robot_.bodies[joint.parent].name},
                              {"body2", robot_.bodies[joint.child].name}}});
        instead = "a weld equality";
        break;
      case JointType::kRevolute:
      case JointType::kContinuous: {
        if (joint.axes.empty()) break;
        const Vector3 along = rotate(joint.X_PJ.rotation, joint.axes[0].direction);
        connect(joint, joint.X_PJ.translation);
        connect(joint, joint.X_PJ.translation + kBearing * along);
        instead = "two connect equalities on its axis";
        break;
      }
      case JointType::kBall:
        connect(joint, joint.X_PJ.translation);
        instead = "a connect equality";
        break;
      default: break;
    }
    const model::Joint* source = draft_.entities.joint(joint.span);
    if (source == nullptr) return;
    const bool lost = instead.empty();
    draft_.ledger.note({.kind = lost ? NoteKind::kJointTypeLost : NoteKind::kMjcfLoop,
                        .outcome = lost ? Outcome::kLost : Outcome::kSubstituted,
                        .where = source->site.name,
                        .subject = model::subject(draft_.root(), *source),
                        .written = source->type_name.value,
                        .instead = std::move(instead)});
  }

  MjcfDraft& draft_;
  const robot::Robot& robot_;
};

}  // namespace

void add_mjcf_equalities(MjcfDraft& draft) { MjcfCoupler(draft).couple(); }

}  // namespace rigor::convert
