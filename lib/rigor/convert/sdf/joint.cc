// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <string>
#include <utility>

#include <rigor/convert/bullet_urdf.h>
#include <rigor/convert/number_text.h>
#include <rigor/convert/sdf/draft.h>
#include <rigor/convert/written_number.h>
#include <rigor/model/subject.h>
#include <rigor/robot/robot.h>
#include <rigor/write/numbers.h>

namespace rigor::convert {
namespace {

using model::Id;
using model::Joint;
using model::JointType;

/// How SDF before 1.10 says that a joint has no limit.
constexpr const char* kNoLowerLimit = "-1e16";
constexpr const char* kNoUpperLimit = "1e16";

/// An axis is a unit vector as well as its digits allow; many files have six.
constexpr double kUnitAxisTolerance = 1e-5;

class SdfJointConverter {
 public:
  SdfJointConverter(SdfDraft& draft, Id<Joint> id)
      : draft_(draft),
        ledger_(draft.ledger),
        root_(draft.source.root),
        joint_(root_[id]),
        name_(draft.tree.joint_names[id.value]) {
    const model::Names& names = draft.source.frames.names();
    parent_ = names.find_link(joint_.model, joint_.parent.value);
    child_ = names.find_link(joint_.model, joint_.child.value);
  }

  std::vector<SdfPart> convert() {
    const SdfNode& child = draft_.node(child_);
    const bool gone = child.role == SdfNode::Role::kFrame || child.carried_by_frame;
    take_head(gone ? Outcome::kRewritten : Outcome::kConverted);
    if (gone) {
      take_idle_axis();
      return {};
    }
    switch (joint_.type) {
      case JointType::kFixed: return fixed();
      case JointType::kRevolute:
      case JointType::kContinuous: return single("revolute");
      case JointType::kPrismatic: return single("prismatic");
      case JointType::kFloating: return floating();
      case JointType::kPlanar: return planar();
      default: break;
    }
    if (is_spherical(joint_)) return ball();
    note(NoteKind::kJointTypeLost, Outcome::kSubstituted, joint_.type_name.span,
         joint_.type_name.value, "a fixed joint");
    return fixed();
  }

 private:
  void note(NoteKind kind, Outcome outcome, Span where, std::string written, std::string instead) {
    ledger_.note({.kind = kind,
                  .outcome = outcome,
                  .where = where.nowhere() ? joint_.site.name : where,
                  .subject = model::subject(root_, joint_),
                  .written = std::move(written),
                  .instead = std::move(instead)});
  }

  void take_head(Outcome outcome) {
    ledger_.take(joint_.site, outcome);
    ledger_.take(joint_.name, outcome);
    ledger_.take(joint_.type_name, outcome);
    ledger_.take(joint_.parent, outcome);
    ledger_.take(joint_.child, outcome);
    ledger_.take_all(joint_.pose.site, outcome);
    const xml::Element element = draft_.source.documents.element(joint_.site);
    for (const char* name : {"parent", "child"}) {
      if (const auto end = element.child(name)) ledger_.take(*end, outcome);
    }
  }

  /// What a joint that does not move says of moving.
  void take_idle_axis() {
    const xml::Element element = draft_.source.documents.element(joint_.site);
    for (const char* name : {"axis", "limit", "dynamics", "joint_properties", "mimic"}) {
      if (const auto child = element.child(name)) {
        ledger_.pass_over(*child, model::subject(root_, joint_),
                          std::string(name) + " of a " + joint_.type_name.value + " joint");
      }
    }
  }

  void pass_over_rpy(xml::Element axis) {
    if (const auto idle = axis.attribute("rpy")) {
      ledger_.pass_over_value(idle->value_span(), model::subject(root_, joint_), "rpy of an axis");
    }
  }

  bool on_world() const { return draft_.node(parent_).role == SdfNode::Role::kWorld; }

  SdfJoint joint_of(std::string type) const {
    SdfJoint joint;
    joint.name = name_;
    joint.type = std::move(type);
    joint.parent = on_world() ? "world" : draft_.node(parent_).name;
    joint.child = draft_.node(child_).name;
    joint.pose = {on_world() ? "__model__" : joint.parent,
                  urdf_written_origin(draft_.source.documents, joint_.pose)};
    return joint;
  }

  std::vector<SdfPart> fixed() {
    take_idle_axis();
    return {joint_of("fixed")};
  }

  /// Bullet's URDF has it; SDF has the same joint by another name.
  std::vector<SdfPart> ball() {
    ledger_.take(joint_.type_name, Outcome::kSubstituted);
    note(NoteKind::kJointDialect, Outcome::kSubstituted, joint_.type_name.span, "spherical",
         "ball");
    take_idle_axis();
    return {joint_of("ball")};
  }

  /// The child is free; its link stands where the joint would put it.
  std::vector<SdfPart> floating() {
    ledger_.take(joint_.type_name, Outcome::kSubstituted);
    note(NoteKind::kJointType, Outcome::kSubstituted, joint_.type_name.span, "floating",
         "a free link without a joint");
    take_idle_axis();
    return {};
  }

  /// Slides along two directions in the plane, then turns about its normal.
  std::vector<SdfPart> planar() {
    ledger_.take(joint_.type_name, Outcome::kSubstituted);
    note(NoteKind::kJointType, Outcome::kSubstituted, joint_.type_name.span, "planar",
         "two prismatic joints and a revolute one, with links of next to no mass between");
    const model::Vector3 normal = joint_.axes[0].xyz.value;
    const double size = length(normal);
    const auto axes = robot::planar_axes(size > 0 ? (1 / size) * normal : model::Vector3{1, 0, 0});
    // What else it says of moving stays in the account as lost.
    ledger_.take(joint_.axes[0].xyz, Outcome::kSubstituted);
    ledger_.take(joint_.axes[0].site, Outcome::kSubstituted);
    if (!joint_.axes[0].site.span.nowhere()) {
      pass_over_rpy(draft_.source.documents.element(joint_.axes[0].site));
    }
    std::vector<SdfPart> parts;
    std::string before;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const bool last = i + 1 == axes.size();
      SdfJoint joint = joint_of(last ? "revolute" : "prismatic");
      if (!before.empty()) {
        joint.parent = before;
        joint.pose = {before, {}};
      }
      joint.axis = SdfAxis{.xyz = numbers(axes[i].direction)};
      SdfElement limit{.name = "limit"};
      limit.set("lower", kNoLowerLimit);
      limit.set("upper", kNoUpperLimit);
      joint.axis->rest.push_back(std::move(limit));
      if (last) {
        parts.emplace_back(std::move(joint));
        break;
      }
      joint.name = name_ + (i == 0 ? "_slide" : "_slide_2");
      joint.child = before = joint.name + "_link";
      SdfLink link{.name = joint.child, .pose = {joint.name, {}}};
      link.inertial = next_to_nothing(draft_);
      parts.emplace_back(std::move(joint));
      parts.emplace_back(std::move(link));
    }
    return parts;
  }

  std::vector<SdfPart> single(std::string type) {
    const model::Axis& axis = joint_.axes[0];
    const double size = length(axis.xyz.value);
    if (size == 0) {
      note(NoteKind::kAxisZero, Outcome::kSubstituted, axis.xyz.span, "0 0 0", "a fixed joint");
      return fixed();
    }
    Number3 xyz = written_numbers(draft_.source.documents, axis.xyz);
    if (std::abs(size - 1) > kUnitAxisTolerance) {
      const std::string written = number_texts(xyz);
      xyz = numbers((1 / size) * axis.xyz.value);
      for (Number& number : xyz) number.value = write::settled(number.value, 0, 1);
      ledger_.take(axis.xyz, Outcome::kRewritten);
      note(NoteKind::kAxisUnit, Outcome::kRewritten, axis.xyz.span, written, number_texts(xyz));
    }
    ledger_.take(axis.xyz);
    ledger_.take(axis.site);
    const xml::Element element = draft_.source.documents.element(axis.site);
    pass_over_rpy(element);
    SdfJoint joint = joint_of(std::move(type));
    joint.axis = SdfAxis{.xyz = xyz};
    add_limit(*joint.axis, axis);
    add_dynamics(*joint.axis, axis);
    if (axis.mimic) add_mimic(*joint.axis, *axis.mimic);
    return {std::move(joint)};
  }

  std::string digits(const model::Field<double>& field) {
    ledger_.take(field);
    return to_text(written_number(draft_.source.documents, field));
  }

  void add_limit(SdfAxis& result, const model::Axis& axis) {
    SdfElement limit{.name = "limit"};
    if (axis.limit_written) ledger_.take(axis.limit_site);
    if (joint_.type == JointType::kContinuous) {
      note(NoteKind::kContinuous, Outcome::kRewritten, joint_.type_name.span, "continuous",
           "revolute without limits");
      ledger_.take(joint_.type_name, Outcome::kRewritten);
      for (const auto* bound : {&axis.lower, &axis.upper}) {
        if (!bound->written) continue;
        ledger_.pass_over_value(bound->span, model::subject(root_, joint_),
                                (bound == &axis.lower ? "lower" : "upper") +
                                    std::string(" limit of a continuous joint"));
      }
      limit.set("lower", kNoLowerLimit);
      limit.set("upper", kNoUpperLimit);
    } else {
      limit.set("lower", digits(axis.lower));
      limit.set("upper", digits(axis.upper));
      if (axis.lower.value > axis.upper.value) {
        note(NoteKind::kLimitInverted, Outcome::kConverted, axis.limit_site.name,
             digits(axis.lower) + " > " + digits(axis.upper), {});
      }
    }
    add_ceiling(limit, "effort", axis.effort, NoteKind::kEffortStandIn);
    add_ceiling(limit, "velocity", axis.velocity, NoteKind::kVelocityStandIn);
    result.rest.push_back(std::move(limit));
  }

  /// What is no number limits nothing; SDF says so by saying nothing.
  void add_ceiling(SdfElement& limit, const char* name, const model::Field<double>& field,
                   NoteKind kind) {
    if (!field.written) return;
    if (std::isfinite(field.value)) {
      limit.set(name, digits(field));
      return;
    }
    ledger_.take(field, Outcome::kRewritten);
    note(kind, Outcome::kRewritten, field.span, std::isnan(field.value) ? "nan" : "inf", "none");
  }

  void add_dynamics(SdfAxis& result, const model::Axis& axis) {
    SdfElement dynamics{.name = "dynamics"};
    if (axis.damping.written) dynamics.set("damping", digits(axis.damping));
    if (axis.friction.written) dynamics.set("friction", digits(axis.friction));
    const xml::Element joint = draft_.source.documents.element(joint_.site);
    if (const auto element = joint.child("dynamics")) ledger_.take(*element);
    if (!dynamics.children.empty()) result.rest.push_back(std::move(dynamics));
  }

  void add_mimic(SdfAxis& result, const model::Mimic& mimic) {
    const Id<Joint> leader =
        draft_.source.frames.names().find_joint(joint_.model, mimic.joint.value);
    const bool is_fixed = leader && root_[leader].type == JointType::kFixed;
    const std::string why_not = !leader    ? "there is no such joint"
                                : is_fixed ? "it is fixed, and has no axis"
                                : draft_.robot.version < kMimicVersion
                                    ? "SDF has mimic from 1.11 on"
                                    : ring();
    if (!why_not.empty()) {
      ledger_.take_all(mimic.site, Outcome::kLost);
      note(NoteKind::kMimicLost, Outcome::kLost, mimic.site.name, mimic.joint.value, why_not);
      return;
    }
    ledger_.take_all(mimic.site);
    const read::Documents& documents = draft_.source.documents;
    result.mimic = UrdfMimic{draft_.tree.joint_names[leader.value],
                             written_number(documents, mimic.multiplier),
                             written_number(documents, mimic.offset)};
  }

  /// The joints that follow each other in a ring, of which the last in the file is this one; empty where
  /// there is none.
  std::string ring() const {
    const Id<Joint> own = draft_.source.frames.names().find_joint(joint_.model, joint_.name.value);
    std::vector<Id<Joint>> walk;
    for (Id<Joint> at = own; walk.size() <= root_.joints.size(); at = leader_of(at)) {
      if (!at || draft_.not_in_ring.contains(at.value)) {
        for (const Id<Joint> seen : walk) draft_.not_in_ring.insert(seen.value);
        return {};
      }
      if (at.value > own.value) return {};
      if (at == own && !walk.empty()) return words_of_ring(walk);
      walk.push_back(at);
    }
    return {};
  }

  Id<Joint> leader_of(Id<Joint> follower) const {
    const std::vector<model::Axis>& axes = root_[follower].axes;
    if (axes.empty() || !axes[0].mimic) return {};
    return draft_.source.frames.names().find_joint(joint_.model, axes[0].mimic->joint.value);
  }

  std::string words_of_ring(const std::vector<Id<Joint>>& ring) const {
    std::string text;
    for (const Id<Joint> joint : ring) text += root_[joint].name.value + " → ";
    return text + joint_.name.value + " is a ring, cut at " + joint_.name.value;
  }

  SdfDraft& draft_;
  Ledger& ledger_;
  const model::Root& root_;
  const Joint& joint_;
  const std::string& name_;
  Id<model::Link> parent_, child_;
};

}  // namespace

std::vector<SdfPart> sdf_joint(SdfDraft& draft, Id<Joint> id) {
  return SdfJointConverter(draft, id).convert();
}

}  // namespace rigor::convert
