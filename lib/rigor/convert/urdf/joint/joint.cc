// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/joint/joint.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <rigor/convert/urdf/joint/axis.h>
#include <rigor/model/motion.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>
#include <rigor/write/numbers.h>

namespace rigor::convert {
namespace {

using model::Id;
using model::JointType;

class UrdfJointWriter {
 public:
  UrdfJointWriter(UrdfDraft& draft, Id<model::Joint> id, const UrdfJointNames& names,
                  const UrdfJointPlace& place)
      : draft_(draft),
        ledger_(draft.ledger),
        id_(id),
        joint_(draft.source.root[id]),
        names_(names),
        place_(place) {}

  void write() {
    take_head();
    switch (joint_.type) {
      case JointType::kFixed: write_fixed(); break;
      case JointType::kRevolute: write_single("revolute"); break;
      case JointType::kContinuous: write_single("continuous"); break;
      case JointType::kPrismatic: write_single("prismatic"); break;
      case JointType::kUniversal:
      case JointType::kRevolute2: write_two(); break;
      case JointType::kBall: write_ball(); break;
      case JointType::kScrew: write_screw(); break;
      default: write_unknown(); break;
    }
    // Last, since a type that is expressed otherwise has been taken as that.
    ledger_.take(joint_.type_name);
  }

 private:
  void take_head() {
    ledger_.take(joint_.site);
    ledger_.take(joint_.name);
    ledger_.take(joint_.parent);
    ledger_.take(joint_.child);
    // In SDF 1.0 the value is an attribute of these.
    const xml::Element element = draft_.source.documents.element(joint_.site);
    for (const char* name : {"parent", "child"}) {
      if (const auto end = element.child(name)) ledger_.take(*end);
    }
  }

  /// The i-th in the row, between its links; the first one stands where the joint does.
  UrdfJoint in_row(std::size_t i, std::string type) const {
    return in_row(i, std::move(type), names_.joints[i]);
  }
  UrdfJoint in_row(std::size_t i, std::string type, const std::string& name) const {
    UrdfJoint joint;
    joint.name = name;
    joint.type = std::move(type);
    joint.parent = i == 0 ? place_.parent : names_.links[i - 1];
    joint.child = i + 1 == names_.joints.size() ? place_.child : names_.links[i];
    if (i == 0) joint.origin = place_.origin;
    return joint;
  }

  void add(UrdfJoint joint) { draft_.robot.joints.push_back(std::move(joint)); }

  void add_links_between() {
    UrdfDraft::Row row{{}, place_.carried};
    for (const std::string& name : names_.links) {
      row.links.push_back(draft_.robot.links.size());
      draft_.robot.links.push_back({.name = name});
    }
    draft_.rows.push_back(std::move(row));
  }

  void note(NoteKind kind, Outcome outcome, std::string instead) {
    ledger_.take(joint_.type_name, outcome);
    ledger_.note({.kind = kind,
                  .outcome = outcome,
                  .where = joint_.type_name.written ? joint_.type_name.span : joint_.site.name,
                  .subject = model::subject(draft_.source.root, joint_),
                  .written = joint_.type_name.value,
                  .instead = std::move(instead)});
  }

  /// The first axis. Of a joint that hangs the other way round, the same position turns the other way.
  void set_first_axis(UrdfJoint& joint) {
    set_axis(draft_, id_, 0, joint);
    if (!place_.turned) return;
    for (Number& number : *joint.axis) {
      if (number.value != 0) number = {-number.value, {}};
    }
  }

  /// Axes that no consumer of SDF reads.
  void take_idle_axes() {
    for (const model::Axis& axis : joint_.axes) {
      if (axis.site.span.nowhere()) continue;
      const xml::Element element = draft_.source.documents.element(axis.site);
      ledger_.pass_over(element, model::subject(draft_.source.root, joint_),
                        std::string(element.name()) + " of a " + joint_.type_name.value + " joint");
    }
  }

  void lose_second_axis() {
    for (std::size_t k = 1; k < joint_.axes.size(); ++k) {
      ledger_.lose(joint_.axes[k].site, {.kind = NoteKind::kSecondAxis,
                                         .subject = model::subject(draft_.source.root, joint_),
                                         .written = joint_.type_name.value});
    }
  }

  void write_fixed() {
    take_idle_axes();
    add(in_row(0, "fixed"));
  }

  void write_single(std::string type) {
    UrdfJoint joint = in_row(0, std::move(type));
    set_first_axis(joint);
    lose_second_axis();
    add(std::move(joint));
  }

  void write_two() {
    note(NoteKind::kJointType, Outcome::kRewritten, "two revolute joints with a link between");
    add_links_between();
    for (std::size_t k = 0; k < 2; ++k) {
      UrdfJoint joint = in_row(k, "revolute");
      set_axis(draft_, id_, k, joint);
      add(std::move(joint));
    }
  }

  void write_ball() {
    note(NoteKind::kJointType, Outcome::kSubstituted,
         "three continuous joints with two links between");
    take_idle_axes();
    add_links_between();
    const model::Vector3 axes[] = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    for (std::size_t k = 0; k < 3; ++k) {
      UrdfJoint joint = in_row(k, "continuous");
      joint.axis = numbers(axes[k]);
      add(std::move(joint));
    }
  }

  /// It slides first: so the link between, which slides along, stays where what turns has its origin.
  void write_screw() {
    note(NoteKind::kJointType, Outcome::kSubstituted,
         "a revolute joint and a prismatic one that mimics it");
    add_links_between();
    UrdfJoint turn = in_row(1, "revolute", names_.joints[0]);
    set_first_axis(turn);
    lose_second_axis();
    UrdfJoint slide = in_row(0, "prismatic", names_.joints[1]);
    slide.axis = turn.axis;
    slide.limit = no_limit(draft_.options);
    const double meters_per_radian = screw_slide();
    if (turn.limit && turn.limit->lower && turn.limit->upper) {
      const auto at = [meters_per_radian](double angle) {
        const double meters = meters_per_radian * angle;
        return write::settled(meters, 0, std::abs(meters));
      };
      const double a = at(turn.limit->lower->value);
      const double b = at(turn.limit->upper->value);
      slide.limit->lower = Number{std::min(a, b), {}};
      slide.limit->upper = Number{std::max(a, b), {}};
    }
    slide.mimic = UrdfMimic{turn.name, {meters_per_radian, {}}, {0, {}}};
    add(std::move(slide));
    add(std::move(turn));
  }

  double screw_slide() {
    const bool per_turn = joint_.screw_thread_pitch.written;
    ledger_.take(joint_.screw_thread_pitch);
    ledger_.take(joint_.thread_pitch, per_turn ? Outcome::kImplied : Outcome::kConverted);
    return screw_lead(draft_.source.root, joint_);
  }

  void write_unknown() {
    note(NoteKind::kJointTypeLost, Outcome::kSubstituted, "it is fixed");
    add(in_row(0, "fixed"));
  }

  UrdfDraft& draft_;
  Ledger& ledger_;
  Id<model::Joint> id_;
  const model::Joint& joint_;
  const UrdfJointNames& names_;
  const UrdfJointPlace& place_;
};

}  // namespace

std::size_t urdf_joint_count(JointType type) {
  switch (type) {
    case JointType::kBall: return 3;
    case JointType::kUniversal:
    case JointType::kRevolute2:
    case JointType::kScrew: return 2;
    default: return 1;
  }
}

void add_joint(UrdfDraft& draft, Id<model::Joint> joint, const UrdfJointNames& names,
               const UrdfJointPlace& place) {
  UrdfJointWriter(draft, joint, names, place).write();
}

}  // namespace rigor::convert
