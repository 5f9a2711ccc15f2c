// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>

#include <rigor/convert/plugin_text.h>
#include <rigor/convert/sdf/draft.h>
#include <rigor/convert/urdf/names.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>

namespace rigor::convert {
namespace {

using model::Id;
using model::Joint;
using model::JointType;
using model::Link;
using Role = SdfNode::Role;

/// Names that begin and end so are SDF's own.
std::string without_dunder(std::string_view name) {
  if (name.size() < 4 || name.substr(0, 2) != "__" || name.substr(name.size() - 2) != "__") {
    return std::string(name);
  }
  const std::size_t begin = name.find_first_not_of('_');
  if (begin == std::string_view::npos) return "unnamed";
  return std::string(name.substr(begin, name.find_last_not_of('_') + 1 - begin));
}

/// Names of roots in a note: more say nothing new.
constexpr std::size_t kMaxSdfRootsReported = 10;

class SdfTreeBuilder {
 public:
  SdfTreeBuilder(const Source& source, const SdfOptions& options, Ledger& ledger)
      : root_(source.root), source_(source), options_(options), ledger_(ledger) {}

  std::optional<SdfTree> build() {
    tree_.nodes.resize(root_.links.size());
    children_.resize(root_.links.size());
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      if (!connect_joint({i})) return std::nullopt;
    }
    const std::optional<Id<Link>> root = find_root();
    if (!root) return std::nullopt;
    put_in_order(*root);
    if (tree_.order.size() != root_.links.size()) {
      refuse_cycle(unreached());
      return std::nullopt;
    }
    find_needed_joints();
    choose_roles(*root);
    choose_names();
    return std::move(tree_);
  }

 private:
  SdfNode& node(Id<Link> id) { return tree_.nodes[id.value]; }

  bool refuse(NoteKind kind, Span where, std::string subject, std::string written,
              std::size_t count = 1) {
    ledger_.note({.kind = kind,
                  .outcome = Outcome::kLost,
                  .where = where,
                  .subject = std::move(subject),
                  .written = std::move(written),
                  .count = count});
    return false;
  }

  bool connect_joint(Id<Joint> id) {
    const Joint& joint = root_[id];
    const model::Names& names = source_.frames.names();
    const Id<Link> parent = names.find_link(joint.model, joint.parent.value);
    const Id<Link> child = names.find_link(joint.model, joint.child.value);
    const Span where = joint.name.written ? joint.name.span : joint.site.name;
    if (!parent || !child || parent == child) {
      return refuse(NoteKind::kDanglingJoint, where, model::subject(root_, joint),
                    parent ? joint.child.value : joint.parent.value);
    }
    if (node(child).carrier) {
      return refuse(NoteKind::kLoop, where, model::subject(root_, joint), joint.child.value);
    }
    node(child).carrier = id;
    node(child).parent = parent;
    children_[parent.value].push_back(child);
    return true;
  }

  std::optional<Id<Link>> find_root() {
    std::vector<Id<Link>> roots;
    std::string names;
    for (std::uint32_t i = 0; i < tree_.nodes.size(); ++i) {
      if (tree_.nodes[i].carrier) continue;
      roots.push_back({i});
      if (roots.size() > kMaxSdfRootsReported) continue;
      names += (names.empty() ? "" : ", ") + root_.links[i].name.value;
    }
    if (roots.size() > kMaxSdfRootsReported) names += ", …";
    if (roots.size() == 1) return roots[0];
    const model::Model& robot = root_.models[0];
    if (roots.empty()) {
      refuse_cycle({0});
    } else {
      refuse(NoteKind::kSeveralRoots, robot.site.name, model::subject(root_, robot),
             std::move(names), roots.size());
    }
    return std::nullopt;
  }

  /// Of the cycle that is above a link.
  void refuse_cycle(Id<Link> below) {
    std::set<std::uint32_t> above;
    while (above.insert(below.value).second) below = node(below).parent;
    std::string names = root_[below].name.value;
    std::size_t count = 1;
    for (Id<Link> link = node(below).parent; link != below; link = node(link).parent) {
      if (count++ < kMaxSdfRootsReported) names = root_[link].name.value + " → " + names;
    }
    if (count > kMaxSdfRootsReported) names = "… → " + names;
    const model::Model& robot = root_.models[0];
    refuse(NoteKind::kNoRoot, robot.site.name, model::subject(root_, robot),
           root_[below].name.value + " → " + names);
  }

  /// What a cycle beside the tree holds is not reached.
  void put_in_order(Id<Link> root) {
    std::vector<Id<Link>> stack{root};
    while (!stack.empty()) {
      const Id<Link> link = stack.back();
      stack.pop_back();
      tree_.order.push_back(link);
      const auto& children = children_[link.value];
      stack.insert(stack.end(), children.rbegin(), children.rend());
    }
  }

  /// One of the links that are not in the tree.
  Id<Link> unreached() const {
    std::vector<bool> reached(root_.links.size());
    for (const Id<Link> id : tree_.order) reached[id.value] = true;
    const auto first = std::find(reached.begin(), reached.end(), false);
    return {static_cast<std::uint32_t>(first - reached.begin())};
  }

  /// Fixed joints that a block measures at, or, when joints are lumped, wants to be kept.
  void find_needed_joints() {
    for (const model::GazeboBlock& block : root_.gazebo_blocks) {
      const xml::Element element = source_.documents.element(block.site);
      const auto keeps = element.child("preserveFixedJoint");
      const bool kept =
          options_.fixed == FixedPolicy::kLump && keeps &&
          read::bool_field(read::child_text(element, "preserveFixedJoint"), false).value;
      if (kept || element.child("sensor") || element.child("provideFeedback")) {
        needed_joints_.insert(block.reference.value);
      }
    }
  }

  bool is_empty(const Link& link) const {
    return is_massless(link) && link.visuals.empty() && link.collisions.empty();
  }

  bool becomes_frame(const SdfNode& of, const Link& link) {
    const Joint& joint = root_[of.carrier];
    if (joint.type != JointType::kFixed || node(of.parent).role == Role::kWorld) return false;
    const bool is_link =
        source_.frames.names().find_link(joint.model, joint.name.value).operator bool();
    if (needed_joints_.count(joint.name.value) != 0 && !is_link) return false;
    if (options_.fixed == FixedPolicy::kLump) return true;
    if (options_.massless == MasslessPolicy::kLink) return is_empty(link);
    return is_massless(link);
  }

  void choose_roles(Id<Link> root) {
    const Link& base = root_[root];
    if (base.name.value == "world" && is_empty(base) && tree_.order.size() > 1) {
      node(root).role = Role::kWorld;
    }
    for (const Id<Link> id : tree_.order) {
      SdfNode& one = node(id);
      one.holder = id;
      if (!one.carrier || one.role == Role::kWorld || !becomes_frame(one, root_[id])) continue;
      one.role = Role::kFrame;
      one.holder = node(one.parent).holder;
    }
    if (node(root).role == Role::kLink && is_massless(base)) hand_over(root);
    for (const Id<Link> id : tree_.order) {
      if (const Id<Link> holder = node(id).holder) node(holder).held.push_back(id);
    }
  }

  /// A root without mass, such as `base_footprint`, becomes a frame of the first link with mass that
  /// is fixed to it.
  void hand_over(Id<Link> root) {
    if (options_.massless == MasslessPolicy::kLink && !is_empty(root_[root])) return;
    const auto heir = std::find_if(tree_.order.begin() + 1, tree_.order.end(), [&](Id<Link> id) {
      const SdfNode& one = node(id);
      return one.role == Role::kLink && node(one.parent).holder == root &&
             root_[one.carrier].type == JointType::kFixed && !is_massless(root_[id]) &&
             needed_joints_.count(root_[one.carrier].name.value) == 0;
    });
    if (heir == tree_.order.end()) return;
    node(root).role = Role::kFrame;
    node(*heir).carried_by_frame = true;
    for (SdfNode& one : tree_.nodes) {
      if (one.holder == root) one.holder = *heir;
    }
  }

  void choose_names() {
    UrdfNames names("unnamed", {"world"});
    std::vector<std::string> wanted;
    for (const Link& link : root_.links) wanted.push_back(without_dunder(link.name.value));
    const std::vector<std::string> links = names.take(wanted);
    const std::unordered_set<std::string> taken(links.begin(), links.end());
    for (std::uint32_t i = 0; i < links.size(); ++i) {
      tree_.nodes[i].name = links[i];
      if (tree_.nodes[i].role == Role::kWorld) {
        tree_.nodes[i].name = "world";
        continue;
      }
      const Link& link = root_.links[i];
      report_name(link.name, links[i], model::subject(root_, link));
    }
    for (const Joint& joint : root_.joints) {
      const std::string name = without_dunder(joint.name.value);
      tree_.joint_names.push_back(names.add(taken.count(name) != 0 ? name + "_joint" : name));
      report_name(joint.name, tree_.joint_names.back(), model::subject(root_, joint));
    }
  }

  void report_name(const model::Field<std::string>& name, const std::string& instead,
                   std::string subject) {
    if (name.value == instead) return;
    ledger_.take(name, Outcome::kRewritten);
    ledger_.note({.kind = NoteKind::kRenamed,
                  .outcome = Outcome::kRewritten,
                  .where = name.span,
                  .subject = std::move(subject),
                  .written = name.value,
                  .instead = instead});
  }

  const model::Root& root_;
  const Source& source_;
  const SdfOptions& options_;
  Ledger& ledger_;
  SdfTree tree_;
  std::vector<std::vector<Id<Link>>> children_;
  std::unordered_set<std::string> needed_joints_;
};

}  // namespace

std::string sdf_name(std::string_view name) { return without_dunder(without_scope(name)); }

bool is_massless(const model::Link& link) {
  const model::Inertial& i = link.inertial;
  return !i.written || !i.mass.written || !i.tensor_written || i.mass.value == 0;
}

std::optional<SdfTree> sdf_tree(const Source& source, const SdfOptions& options, Ledger& ledger) {
  return SdfTreeBuilder(source, options, ledger).build();
}

}  // namespace rigor::convert
