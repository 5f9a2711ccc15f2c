// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/joint/mimic.h>

#include <cmath>
#include <map>
#include <unordered_map>
#include <variant>

#include <rigor/convert/written_number.h>
#include <rigor/model/subject.h>
#include <rigor/robot/gearbox.h>
#include <rigor/write/numbers.h>

namespace rigor::convert {
namespace {

using model::Id;

/// Joints that follow each other in a row: no hand has a hundred, and each is walked for each.
constexpr int kMaxLeaders = 100;

using JointsByName = std::unordered_map<std::string, UrdfJoint*>;

JointsByName joints_by_name(UrdfRobot& robot) {
  JointsByName found;
  for (UrdfJoint& joint : robot.joints) found.emplace(joint.name, &joint);
  return found;
}

/// Whether `joint` is `leader` or follows it, over others or not. What follows has one leader, so no
/// circle is walked twice.
bool leads(const JointsByName& joints, const UrdfJoint* leader, const UrdfJoint* joint) {
  for (int steps = 0; joint != nullptr && steps <= kMaxLeaders; ++steps) {
    if (joint == leader) return true;
    const auto found = joint->mimic ? joints.find(joint->mimic->joint) : joints.end();
    joint = found == joints.end() ? nullptr : found->second;
  }
  return joint != nullptr;
}

class MimicAdder {
 public:
  MimicAdder(UrdfDraft& draft, const JointNames& names)
      : draft_(draft), names_(names), joints_(joints_by_name(draft.robot)) {}

  void add(Id<model::Joint> id) {
    const model::Joint& joint = draft_.source.root[id];
    for (std::size_t k = 0; k < joint.axes.size(); ++k) {
      if (joint.axes[k].mimic) add(id, k, *joint.axes[k].mimic);
    }
  }

 private:
  void add(Id<model::Joint> id, std::size_t k, const model::Mimic& mimic) {
    const model::Joint& joint = draft_.source.root[id];
    Note note{.kind = NoteKind::kMimicLost,
              .where = mimic.joint.written ? mimic.joint.span : mimic.site.name,
              .subject = model::subject(draft_.source.root, joint),
              .written = mimic.joint.value};
    UrdfJoint* follower = k < names_.at(id).joints.size() ? at(names_.at(id).joints[k]) : nullptr;
    UrdfJoint* leader = leader_of(joint, mimic);
    note.instead = why_not(follower, leader);
    if (!note.instead.empty()) return draft_.ledger.lose(mimic.site, std::move(note));
    follower->mimic = UrdfMimic{leader->name, written_number(documents(), mimic.multiplier),
                                written_number(documents(), mimic.offset)};
    take(mimic);
    fold_reference(mimic, *follower->mimic, std::move(note));
  }

  UrdfJoint* at(const std::string& name) const {
    const auto found = joints_.find(name);
    return found == joints_.end() ? nullptr : found->second;
  }

  UrdfJoint* leader_of(const model::Joint& joint, const model::Mimic& mimic) const {
    const auto named =
        draft_.source.frames.names().find({joint.model, joint.world}, mimic.joint.value);
    const auto* id = std::get_if<Id<model::Joint>>(&named);
    if (id == nullptr) return nullptr;
    const auto found = names_.find(*id);
    const std::size_t k = mimic.axis.value == "axis2" ? 1 : 0;
    if (found == names_.end() || k >= found->second.joints.size()) return nullptr;
    return at(found->second.joints[k]);
  }

  /// Empty when the one can follow the other.
  std::string why_not(const UrdfJoint* follower, const UrdfJoint* leader) const {
    const auto moves = [](const UrdfJoint& joint) { return joint.axis.has_value(); };
    if (leader == nullptr) return "there is no such joint in the result";
    if (!moves(*leader)) return "it does not move";
    if (follower == nullptr || !moves(*follower)) return "this joint does not move";
    if (follower->mimic) return "it follows another one";
    return leads(joints_, follower, leader) ? ring_of(*follower, *leader) : "";
  }

  /// The joints of a ring, which ends where one of them no longer follows.
  std::string ring_of(const UrdfJoint& follower, const UrdfJoint& leader) const {
    std::string text = follower.name;
    const UrdfJoint* joint = &leader;
    for (int steps = 0; joint != nullptr && joint != &follower && steps < kMaxLeaders; ++steps) {
      text += " → " + joint->name;
      const auto found = joint->mimic ? joints_.find(joint->mimic->joint) : joints_.end();
      joint = found == joints_.end() ? nullptr : found->second;
    }
    return text + " → " + follower.name + " is a ring, cut at " + follower.name;
  }

  void take(const model::Mimic& mimic) {
    Ledger& ledger = draft_.ledger;
    ledger.take(mimic.site);
    ledger.take(mimic.joint);
    ledger.take(mimic.axis);
    ledger.take(mimic.multiplier);
    ledger.take(mimic.offset);
    ledger.take(mimic.reference);
  }

  /// SDF: follower = multiplier · (leader - reference) + offset.
  void fold_reference(const model::Mimic& mimic, UrdfMimic& target, Note note) {
    if (mimic.reference.value == 0) return;
    target.offset = {mimic.offset.value - mimic.multiplier.value * mimic.reference.value, {}};
    note.kind = NoteKind::kMimicReference;
    note.outcome = Outcome::kRewritten;
    note.where = mimic.reference.span;
    note.written = to_text(written_number(documents(), mimic.reference));
    note.instead = to_text(target.offset);
    draft_.ledger.take(mimic.reference, Outcome::kRewritten);
    draft_.ledger.note(std::move(note));
  }

  const read::Documents& documents() const { return draft_.source.documents; }

  UrdfDraft& draft_;
  const JointNames& names_;
  JointsByName joints_;
};

class GearboxAdder {
 public:
  GearboxAdder(UrdfDraft& draft, const JointNames& names)
      : draft_(draft), names_(names), joints_(joints_by_name(draft.robot)) {
    for (const robot::GearCoupling& gear :
         robot::gear_couplings(draft.source.root, draft.source.frames)) {
      couplings_.emplace(gear.gearbox, gear);
    }
  }

  void add(Id<model::Joint> id) {
    const model::Joint& joint = draft_.source.root[id];
    Note note{.kind = NoteKind::kJointTypeLost,
              .where = joint.type_name.written ? joint.type_name.span : joint.site.name,
              .subject = model::subject(draft_.source.root, joint),
              .written = "gearbox"};
    const auto gear = couplings_.find(id);
    UrdfJoint* leader = gear == couplings_.end() ? nullptr : at(gear->second.leader);
    UrdfJoint* follower = gear == couplings_.end() ? nullptr : at(gear->second.follower);
    if (leader == nullptr || follower == nullptr || leads(joints_, follower, leader)) {
      note.instead = "it couples no two revolute joints of one reference body";
      return draft_.ledger.lose(joint.site, std::move(note));
    }
    follower->mimic = UrdfMimic{leader->name, {gear->second.multiplier, {}}, {0, {}}};
    draft_.ledger.take_all(joint.site, Outcome::kSubstituted);
    note.kind = NoteKind::kJointType;
    note.outcome = Outcome::kSubstituted;
    note.instead = follower->name + " mimics " + leader->name;
    draft_.ledger.note(std::move(note));
  }

 private:
  UrdfJoint* at(Id<model::Joint> id) const {
    const auto names = names_.find(id);
    if (names == names_.end()) return nullptr;
    const auto found = joints_.find(names->second.joints.front());
    return found == joints_.end() ? nullptr : found->second;
  }

  UrdfDraft& draft_;
  const JointNames& names_;
  JointsByName joints_;
  std::map<Id<model::Joint>, robot::GearCoupling> couplings_;
};

/// Lets each joint follow the one that follows nobody: consumers of URDF look at one leader only.
class MimicFlattener {
 public:
  MimicFlattener(UrdfDraft& draft, const JointNames& names)
      : draft_(draft), names_(names), joints_(joints_by_name(draft.robot)) {}

  void flatten(Id<model::Joint> id) {
    const auto& row = names_.at(id).joints;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const auto found = joints_.find(row[k]);
      if (found == joints_.end() || !found->second->mimic) continue;
      const std::string written = found->second->mimic->joint;
      if (follow_last(*found->second)) tell(id, k, written, *found->second->mimic);
    }
  }

 private:
  /// c = m₂ b + o₂ and b = m₁ a + o₁: c = m₂ m₁ a + (m₂ o₁ + o₂). False when it does already.
  bool follow_last(UrdfJoint& joint) const {
    UrdfMimic& mimic = *joint.mimic;
    bool changed = false;
    for (int steps = 0; steps < kMaxLeaders; ++steps) {
      const auto leader = joints_.find(mimic.joint);
      if (leader == joints_.end() || !leader->second->mimic) break;
      const UrdfMimic& next = *leader->second->mimic;
      mimic.offset = {product(mimic.multiplier, next.offset) + mimic.offset.value, {}};
      mimic.multiplier = {product(mimic.multiplier, next.multiplier), {}};
      mimic.joint = next.joint;
      changed = true;
    }
    return changed;
  }

  /// 0.1 · 3 is 0.3 for who reads it.
  static double product(const Number& a, const Number& b) {
    const double value = a.value * b.value;
    return write::settled(value, 0, std::abs(value));
  }

  void tell(Id<model::Joint> id, std::size_t k, const std::string& written,
            const UrdfMimic& mimic) const {
    const model::Joint& joint = draft_.source.root[id];
    Note note{.kind = NoteKind::kMimicChain,
              .outcome = Outcome::kRewritten,
              .where = joint.site.name,
              .subject = model::subject(draft_.source.root, joint),
              .written = written,
              .instead = mimic.joint};
    if (k < joint.axes.size() && joint.axes[k].mimic) {
      const model::Mimic& own = *joint.axes[k].mimic;
      draft_.ledger.take(own.joint, Outcome::kRewritten);
      if (own.joint.written) note.where = own.joint.span;
    }
    draft_.ledger.note(std::move(note));
  }

  UrdfDraft& draft_;
  const JointNames& names_;
  JointsByName joints_;
};

}  // namespace

void flatten_mimics(UrdfDraft& draft, const UrdfTree& tree, const JointNames& names) {
  MimicFlattener flattener(draft, names);
  for (const UrdfTree::Edge& edge : tree.edges) flattener.flatten(edge.joint);
}

void add_mimics(UrdfDraft& draft, const UrdfTree& tree, const JointNames& names) {
  MimicAdder adder(draft, names);
  for (const UrdfTree::Edge& edge : tree.edges) adder.add(edge.joint);
}

void add_gearboxes(UrdfDraft& draft, const UrdfTree& tree, const JointNames& names) {
  if (tree.gearboxes.empty()) return;
  GearboxAdder adder(draft, names);
  for (const Id<model::Joint> joint : tree.gearboxes) adder.add(joint);
}

}  // namespace rigor::convert
