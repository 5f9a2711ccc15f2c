// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/convert/bullet_urdf.h>
#include <rigor/convert/mjcf/draft.h>
#include <rigor/convert/urdf/take.h>
#include <rigor/convert/urdf/tree.h>
#include <rigor/model/motion.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>
#include <rigor/robot/gearbox.h>

namespace rigor::convert {
namespace {

constexpr std::array<std::pair<std::string_view, NoteKind>, 14> kMjcfKinds{
    {{"sensor", NoteKind::kSensor},
     {"plugin", NoteKind::kPlugin},
     {"surface", NoteKind::kMjcfContact},
     {"max_contacts", NoteKind::kMjcfContact},
     {"mu1", NoteKind::kMjcfContact},
     {"mu2", NoteKind::kMjcfContact},
     {"kp", NoteKind::kMjcfContact},
     {"kd", NoteKind::kMjcfContact},
     {"minDepth", NoteKind::kMjcfContact},
     {"maxVel", NoteKind::kMjcfContact},
     {"material", NoteKind::kMjcfLook},
     {"texture", NoteKind::kMjcfLook},
     {"cast_shadows", NoteKind::kMjcfLook},
     {"laser_retro", NoteKind::kMjcfLook}}};

void tell_incomplete_inertia(MjcfDraft& draft, const model::Link& link) {
  if (!has_incomplete_inertia(link)) return;
  draft.ledger.note({.kind = NoteKind::kInertiaIncomplete,
                     .outcome = Outcome::kSubstituted,
                     .where = link.inertial.tensor_site.name,
                     .subject = model::subject(draft.root(), link),
                     .written = missing_entries(link.inertial),
                     .instead = "0"});
}

void take_mjcf_link(MjcfDraft& draft, const model::Link& link) {
  Ledger& ledger = draft.ledger;
  ledger.take(link.site);
  ledger.take(link.name);
  take_pose(draft.source.source, ledger, link.pose);
  const model::Inertial& inertial = link.inertial;
  if (!inertial.written) return;
  if (draft.root().format == model::Format::kUrdf) {
    tell_incomplete_inertia(draft, link);
    ledger.take_all(inertial.site);
    return;
  }
  ledger.take(inertial.site);
  ledger.take(inertial.automatic);
  ledger.take(inertial.density);
  ledger.take(inertial.mass);
  take_pose(draft.source.source, ledger, inertial.pose);
  for (const auto* entry :
       {&inertial.ixx, &inertial.ixy, &inertial.ixz, &inertial.iyy, &inertial.iyz, &inertial.izz}) {
    ledger.take(*entry);
  }
}

/// MuJoCo limits efforts and positions, no velocities.
void take_velocity(MjcfDraft& draft, const model::Joint& joint, const model::Axis& axis) {
  if (!axis.velocity.written) return;
  const double limit = model::velocity_limit(draft.root(), joint, axis);
  const bool kept = std::isinf(limit) || draft.options.actuators == MjcfActuators::kVelocity;
  draft.ledger.take(axis.velocity, kept ? Outcome::kConverted : Outcome::kLost);
  if (kept) return;
  draft.ledger.note({.kind = NoteKind::kMjcfVelocity,
                     .outcome = Outcome::kLost,
                     .where = axis.velocity.span,
                     .subject = model::subject(draft.root(), joint),
                     .written = mjcf_number(axis.velocity.value)});
}

void take_frame(MjcfDraft& draft, const model::Frame& frame) {
  draft.ledger.take(frame.site, Outcome::kRewritten);
  draft.ledger.take(frame.name, Outcome::kRewritten);
  draft.ledger.take(frame.attached_to, Outcome::kRewritten);
  take_pose(draft.source.source, draft.ledger, frame.pose, Outcome::kRewritten);
}

void take_static(MjcfDraft& draft, const model::Model& model) {
  draft.ledger.take(model.is_static, Outcome::kRewritten);
  if (!model.is_static.value || !model.is_static.written) return;
  draft.ledger.note({.kind = NoteKind::kStatic,
                     .outcome = Outcome::kRewritten,
                     .where = model.is_static.span,
                     .subject = model::subject(draft.root(), model),
                     .written = "true",
                     .instead = "bodies without joints"});
}

void take_model_pose(MjcfDraft& draft, const model::Model& model) {
  take_pose(draft.source.source, draft.ledger, model.pose);
  if (!model.pose.pose.written || model.pose.pose.value == model::Pose{}) return;
  draft.ledger.note({.kind = NoteKind::kMjcfModelPose,
                     .outcome = Outcome::kRewritten,
                     .where = model.pose.pose.span,
                     .subject = model::subject(draft.root(), model)});
}

/// What names joints becomes actuators on them.
void take_drives(MjcfDraft& draft, const model::Parameters& drives) {
  if (draft.options.actuators == MjcfActuators::kNone) return;
  for (const model::Parameter& drive : drives) {
    const auto* name = attribute(drive, "name");
    draft.ledger.take_all(drive.site, Outcome::kSubstituted);
    draft.ledger.note({.kind = NoteKind::kControl,
                       .outcome = Outcome::kSubstituted,
                       .where = drive.site.name,
                       .subject = model::subject(draft.root(), draft.root().models[0]),
                       .written = drive.name + (name != nullptr ? " " + name->value : ""),
                       .instead = "actuators"});
  }
}

void take_urdf_robot(MjcfDraft& draft) {
  const model::Root& root = draft.root();
  Ledger& ledger = draft.ledger;
  ledger.open(root.site);
  ledger.take(root.site);
  ledger.take(root.models[0].name);
  ledger.take(root.version_text);
  for (const model::RobotMaterial& material : root.materials) {
    ledger.take(material.site);
    ledger.take(material.name);
    const xml::Element element = draft.source.source.documents.element(material.site);
    if (const auto color = element.child("color")) ledger.take_all(*color);
  }
  for (const model::GazeboBlock& block : root.gazebo_blocks) {
    ledger.take(block.site);
    ledger.take(block.reference);
    for (const std::string_view spring : {"springReference", "springStiffness"}) {
      if (const auto* given = find(block.content, spring)) ledger.take_all(given->site);
    }
  }
  take_drives(draft, root.transmissions);
  take_drives(draft, root.ros2_controls);
}

/// Without limits and dynamics, as `urdf_to_sdf` takes it.
void take_spherical(MjcfDraft& draft, const model::Joint& joint) {
  const std::string subject = model::subject(draft.root(), joint);
  draft.ledger.take(joint.type_name, Outcome::kSubstituted);
  draft.ledger.note({.kind = NoteKind::kJointDialect,
                     .outcome = Outcome::kSubstituted,
                     .where = joint.type_name.span,
                     .subject = subject,
                     .written = joint.type_name.value,
                     .instead = "ball"});
  const xml::Element element = draft.source.source.documents.element(joint.site);
  for (const char* name : {"axis", "limit", "dynamics", "joint_properties", "mimic"}) {
    const auto idle = element.child(name);
    if (idle) draft.ledger.pass_over(*idle, subject, std::string(name) + " of a spherical joint");
  }
}

}  // namespace

void take_mjcf_joint(MjcfDraft& draft, const model::Joint& joint) {
  Ledger& ledger = draft.ledger;
  ledger.take(joint.site);
  ledger.take(joint.name);
  ledger.take(joint.type_name);
  ledger.take(joint.parent);
  ledger.take(joint.child);
  take_pose(draft.source.source, ledger, joint.pose);
  const xml::Element element = draft.source.source.documents.element(joint.site);
  const bool spherical = draft.root().format == model::Format::kUrdf && is_spherical(joint);
  if (spherical) take_spherical(draft, joint);
  if (draft.root().format == model::Format::kUrdf) {
    ledger.take_all(joint.pose.site);
    for (const std::string_view name : {"parent", "child", "dynamics"}) {
      if (const auto child = element.child(name)) ledger.take(*child);
    }
  }
  if (spherical) return;
  ledger.take(joint.thread_pitch);
  ledger.take(joint.screw_thread_pitch);
  const bool fixed = joint.type == model::JointType::kFixed;
  if (fixed && joint.name.written) {
    ledger.take(joint.name, Outcome::kLost);
    ledger.note({.kind = NoteKind::kMjcfFixedJoint,
                 .outcome = Outcome::kLost,
                 .where = joint.name.span,
                 .subject = model::subject(draft.root(), joint),
                 .written = joint.name.value});
  }
  for (const model::Axis& axis : joint.axes) {
    if (fixed || joint.type == model::JointType::kBall) {
      ledger.take_all(axis.site, Outcome::kImplied);
      ledger.take_all(axis.limit_site, Outcome::kImplied);
    }
    ledger.take(axis.site);
    ledger.take(axis.xyz);
    ledger.take(axis.expressed_in);
    if (!axis.site.span.nowhere()) {
      const xml::Element written = draft.source.source.documents.element(axis.site);
      const auto in_model = written.child("use_parent_model_frame");
      if (in_model) ledger.take(*in_model);
    }
    ledger.take(axis.limit_site);
    for (const auto* field : {&axis.lower, &axis.upper, &axis.effort, &axis.damping, &axis.friction,
                              &axis.spring_reference, &axis.spring_stiffness}) {
      ledger.take(*field);
    }
    if (!fixed) take_velocity(draft, joint, axis);
    if (axis.mimic) ledger.take_all(axis.mimic->site);
  }
}

namespace {

/// A gearbox that couples two joints is in the robot as one that follows the other (robot/gearbox.h).
void take_gearboxes(MjcfDraft& draft, const UrdfTree& tree) {
  if (tree.gearboxes.empty()) return;
  const model::Root& root = draft.root();
  std::map<model::Id<model::Joint>, robot::GearCoupling> couplings;
  for (const auto& gear : robot::gear_couplings(root, draft.source.source.frames)) {
    couplings.emplace(gear.gearbox, gear);
  }
  for (const auto id : tree.gearboxes) {
    const model::Joint& joint = root[id];
    Note note{.kind = NoteKind::kJointTypeLost,
              .where = joint.type_name.written ? joint.type_name.span : joint.site.name,
              .subject = model::subject(root, joint),
              .written = "gearbox",
              .instead = "it couples no two revolute joints of one reference body"};
    const auto gear = couplings.find(id);
    if (gear == couplings.end()) {
      draft.ledger.lose(joint.site, std::move(note));
      continue;
    }
    draft.ledger.take_all(joint.site, Outcome::kRewritten);
    note.kind = NoteKind::kMjcfJointType;
    note.outcome = Outcome::kRewritten;
    note.instead = "an equality, by which " + root[gear->second.follower].name.value + " follows " +
                   root[gear->second.leader].name.value;
    draft.ledger.note(std::move(note));
  }
}

}  // namespace

void take_mjcf_model(MjcfDraft& draft, model::Id<model::Model> id) {
  const Source& source = draft.source.source;
  const UrdfTree tree = urdf_tree(source.root, source.frames, id);
  if (source.root.format == model::Format::kUrdf) take_urdf_robot(draft);
  for (const auto model : tree.models) {
    if (source.root.format == model::Format::kUrdf) break;
    take_model(source, draft.ledger, model);
    take_model_pose(draft, source.root[model]);
    draft.ledger.take(source.root[model].placement_frame);
    draft.ledger.take(source.root[model].canonical_link);
    take_static(draft, source.root[model]);
  }
  for (const auto link : tree.links) take_mjcf_link(draft, source.root[link]);
  for (const auto frame : tree.frames) take_frame(draft, source.root[frame]);
  for (const UrdfTree::Edge& edge : tree.edges) take_mjcf_joint(draft, source.root[edge.joint]);
  for (const auto& left_out : tree.left_out) take_mjcf_joint(draft, source.root[left_out.joint]);
  take_gearboxes(draft, tree);
}

NoteKind mjcf_kind_of(xml::Element element) {
  for (auto at = std::optional(element); at; at = at->parent()) {
    for (const auto& [name, kind] : kMjcfKinds) {
      if (at->name() == name) return kind;
    }
    if (at->name() == "link" || at->name() == "joint" || at->name() == "model") break;
  }
  if (element.name() == "self_collide") return NoteKind::kSelfCollide;
  if (element.name() == "gravity") return NoteKind::kGravity;
  return NoteKind::kMjcfLost;
}

}  // namespace rigor::convert
