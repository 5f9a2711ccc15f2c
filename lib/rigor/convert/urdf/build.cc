// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/build.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/convert/comments.h>
#include <rigor/convert/digits.h>
#include <rigor/convert/number_text.h>
#include <rigor/convert/urdf/draft.h>
#include <rigor/convert/urdf/joint/between.h>
#include <rigor/convert/urdf/joint/joint.h>
#include <rigor/convert/urdf/joint/mimic.h>
#include <rigor/convert/urdf/naming.h>
#include <rigor/convert/urdf/places.h>
#include <rigor/convert/urdf/take.h>
#include <rigor/convert/written_number.h>
#include <rigor/model/subject.h>

namespace rigor::convert {
namespace {

using model::Id;
using model::Pose;

/// Nearer than this to a pitch of ±90°, rad, roll and yaw are expressed by one of them.
constexpr double kGimbal = 1e-9;

std::string pose_text(const UrdfOrigin& origin) {
  return number_texts(origin.xyz) + ' ' + number_texts(origin.rpy);
}

UrdfOptions with_static(UrdfOptions options, const UrdfRoots& roots) {
  if (roots.is_static) options.static_model = StaticPolicy::kWorldLink;
  return options;
}

class UrdfBuilder {
 public:
  UrdfBuilder(const Source& source, const UrdfOptions& options, const UrdfTree& tree,
              const UrdfRoots& roots, Ledger& ledger, UrdfConversion& result)
      : source_(source),
        root_(source.root),
        options_(with_static(options, roots)),
        tree_(tree),
        roots_(roots),
        ledger_(ledger),
        result_(result),
        top_(tree.models.front()),
        places_(source.root, source.frames, top_),
        naming_(urdf_naming(source, options, tree, ledger)),
        draft_{source, options_, ledger} {
    for (const auto& [frame, joint] : tree.fixed_by) written_frames_.insert(joint);
  }

  void build() && {
    draft_.robot.name = root_[top_].name.value.empty() ? "robot" : root_[top_].name.value;
    draft_.robot.comments = remarks_on_file(source_.documents.of(root_.site.span.source));
    draft_.link_names = naming_.links;
    for (const auto& [id, names] : naming_.joints) {
      draft_.joint_names.emplace(id, names.joints.front());
    }
    draft_.top = top_;
    name_for_plugins();
    if (options_.loop == LoopPolicy::kComment) comment_on_cuts();
    for (const Id<model::Model> id : tree_.models) add_model(id);
    add_root_link();
    for (const Id<model::Link> id : tree_.links) add_link(id);
    for (const UrdfTree::Edge& edge : tree_.edges) add_edge(edge);
    weigh_links_between(draft_, top_);
    for (const Id<model::Frame> id : tree_.frames) add_frame(id);
    for (const UrdfTree::LeftOut& left_out : tree_.left_out) leave_out(left_out);
    add_mimics(draft_, tree_, naming_.joints);
    add_gearboxes(draft_, tree_, naming_.joints);
    flatten_mimics(draft_, tree_, naming_.joints);
    hand_over();
  }

 private:
  void note(NoteKind kind, Outcome outcome, Span where, std::string subject, std::string written,
            std::string instead = {}) {
    ledger_.note({.kind = kind,
                  .outcome = outcome,
                  .where = where,
                  .subject = std::move(subject),
                  .written = std::move(written),
                  .instead = std::move(instead)});
  }

  /// For who wants to close the loops by hand, in front of the link that has lost a parent.
  void comment_on_cuts() {
    for (const auto& [id, flaw, carrier] : tree_.left_out) {
      if (flaw == UrdfTree::Flaw::kDangling) continue;
      const model::Joint& joint = root_[id];
      cut_.emplace(source_.frames.ends(id).child,
                   "Cut: " + joint.type_name.value + " joint " + joint.name.value + ", parent " +
                       joint.parent.value + ", child " + joint.child.value);
    }
  }

  /// Plugins name links and joints inside their model.
  void name_for_plugins() {
    PluginNames& plugins = draft_.plugin_names;
    plugins.model = root_[top_].name.value;
    for (const auto& [id, name] : naming_.links) {
      const std::string inside = name_inside(tree_, root_, scoped_name(root_, id));
      if (inside != name) plugins.links.insert_or_assign(inside, name);
      const Id<model::Joint> carrier = tree_.carriers[id.value];
      if (!carrier) continue;
      const Pose X_LJ = places_.X_L(carrier, id);
      if (!is_identity(X_LJ)) {
        plugins.moved.insert_or_assign(inside, PluginNames::Moved{name, inverse(X_LJ)});
      }
    }
    for (const auto& [id, names] : naming_.joints) {
      const std::string inside = name_inside(tree_, root_, scoped_name(root_, id));
      if (inside != names.joints.front()) {
        plugins.joints.insert_or_assign(inside, names.joints.front());
      }
    }
  }

  // --- Models ---

  void add_model(Id<model::Model> id) {
    take_model(source_, ledger_, id);
    if (id == top_) {
      take_model_pose();
    } else {
      take_pose(source_, ledger_, root_[id].pose);
      ledger_.take(root_[id].placement_frame);
    }
    add_model_blocks(draft_, id);
  }

  void take_model_pose() {
    const model::Model& model = root_[top_];
    const bool lost = !roots_.has_model_pose && !is_identity(places_.X_WM());
    const Outcome outcome = lost ? Outcome::kLost : Outcome::kConverted;
    take_pose(source_, ledger_, model.pose, outcome);
    ledger_.take(model.placement_frame, outcome);
    const auto canonical = source_.frames.canonical_link(top_);
    if (!tree_.roots.empty() && canonical == tree_.roots.front()) {
      ledger_.take(model.canonical_link);
    }
    if (!lost) return;
    const Span where = model.pose.pose.written         ? model.pose.pose.span
                       : model.placement_frame.written ? model.placement_frame.span
                                                       : model.site.name;
    note(NoteKind::kModelPose, outcome, where, model::subject(root_, model),
         pose_text(origin_like(source_.documents, places_.X_WM(), {&model.pose})));
  }

  // --- The root ---

  Pose X_M_world() const { return roots_.has_model_pose ? inverse(places_.X_WM()) : Pose{}; }

  void add_root_link() {
    if (roots_.kind == UrdfRoots::Kind::kWorld) root_link_ = "world";
    if (roots_.kind == UrdfRoots::Kind::kAdded) {
      const std::string& name = options_.root;
      root_link_ = naming_.link_names.add(name.empty() ? draft_.robot.name + "_root" : name);
    }
    if (!root_link_.empty()) draft_.robot.links.push_back({.name = root_link_});
    if (roots_.is_static) {
      const model::Model& model = root_[top_];
      ledger_.take(model.is_static, Outcome::kRewritten);
      note(NoteKind::kStatic, Outcome::kRewritten,
           model.is_static.written ? model.is_static.span : model.site.name,
           model::subject(root_, model), "true", "fixed to a link named world");
    } else if (!root_link_.empty() && tree_.roots.size() + (tree_.on_world ? 1 : 0) > 1) {
      Note several = note_on_roots(source_, tree_);
      several.kind = NoteKind::kRootAdded;
      several.outcome = Outcome::kSubstituted;
      several.instead = "fixed to a link named " + root_link_;
      ledger_.note(std::move(several));
    }
  }

  // --- Links ---

  Pose X_M_frame(Id<model::Link> link) const {
    const Id<model::Joint> carrier = tree_.carriers[link.value];
    return carrier ? places_.X_M(carrier) : places_.X_M(link);
  }

  void add_link(Id<model::Link> id) {
    const Id<model::Joint> carrier = tree_.carriers[id.value];
    Pose X_JL;
    if (carrier) {
      const Pose X_LJ = places_.X_L(carrier, id);
      if (!is_identity(X_LJ)) X_JL = inverse(X_LJ);
    }
    const std::string& name = naming_.links.at(id);
    draft_.robot.links.push_back(urdf_link(draft_, id, X_JL));
    draft_.robot.links.back().comments =
        remarks_on(source_.documents, root_[id].site, CommentsFor::kUrdf);
    const auto [first, last] = cut_.equal_range(id);
    for (auto cut = first; cut != last; ++cut) {
      draft_.robot.links.back().comments.push_back({cut->second});
    }
    if (!carrier) {
      add_root(id, name);
    } else if (is_identity(X_JL)) {
      take_pose(source_, ledger_, root_[id].pose);
    } else {
      move_link_frame(id, name, X_JL);
    }
  }

  void add_root(Id<model::Link> id, const std::string& name) {
    const model::Link& link = root_[id];
    const Pose X_ML = places_.X_M(id);
    if (!root_link_.empty()) {
      take_pose(source_, ledger_, link.pose);
      const Pose X_M_root = X_M_world();
      const Pose X = X_M_root == Pose{} ? X_ML : compose(inverse(X_M_root), X_ML);
      add_fixed(root_link_ + "_to_" + name, root_link_, name,
                origin_like(source_.documents, X, {&link.pose}));
      return;
    }
    const bool lost = !is_identity(X_ML);
    if (lost && hang_root_on_frame(id, name, X_ML)) return;
    take_pose(source_, ledger_, link.pose, lost ? Outcome::kLost : Outcome::kConverted);
    if (!lost) return;
    note(NoteKind::kRootPose, Outcome::kLost,
         link.pose.pose.written ? link.pose.pose.span : link.site.name, model::subject(root_, link),
         pose_text(origin_like(source_.documents, X_ML, {&link.pose})));
  }

  /// A frame of the root link at the model's origin, such as `base_footprint`, becomes the root: so URDF
  /// has a place for the link's pose in the model. The joint between has the name of a frame at the link,
  /// where one is called a joint.
  bool hang_root_on_frame(Id<model::Link> id, const std::string& name, const Pose& X_ML) {
    const auto is_frame_of_root = [&](Id<model::Frame> frame) {
      return root_[frame].model == top_ && source_.frames.carrier(frame) == id &&
             naming_.frames.contains(frame);
    };
    const auto origin =
        std::find_if(tree_.frames.begin(), tree_.frames.end(), [&](Id<model::Frame> frame) {
          return is_frame_of_root(frame) && !tree_.fixed_by.contains(frame) &&
                 is_identity(places_.X_M(frame));
        });
    if (origin == tree_.frames.end()) return false;
    const ReferredNames referred = referred_names(root_);
    const auto joint =
        std::find_if(tree_.frames.begin(), tree_.frames.end(), [&](Id<model::Frame> frame) {
          const bool is_next_to = follows(root_[frame].site, root_[id].site);
          return frame != *origin && is_frame_of_root(frame) && !tree_.fixed_by.contains(frame) &&
                 root_[frame].attached_to.value == root_[id].name.value &&
                 may_be_joint(root_[frame], is_next_to, referred) &&
                 is_identity(compose(inverse(X_ML), places_.X_M(frame)));
        });
    std::string joint_name = name + "_joint";
    if (joint != tree_.frames.end()) {
      joint_name = naming_.frames.at(*joint);
      take_frame(*joint);
      naming_.frames.erase(*joint);
      written_frames_.insert(*joint);
    }
    written_frames_.insert(*origin);
    take_pose(source_, ledger_, root_[id].pose);
    take_frame(*origin);
    const std::string& root = naming_.frames.at(*origin);
    draft_.robot.links.push_back(
        {.name = root,
         .comments = remarks_on(source_.documents, root_[*origin].site, CommentsFor::kUrdf)});
    add_fixed(joint_name, root, name, origin_like(source_.documents, X_ML, {&root_[id].pose}));
    note(NoteKind::kFrame, Outcome::kRewritten, root_[*origin].site.name,
         model::subject(root_, root_[*origin]), root_[*origin].name.value,
         "the root link " + root + ", which has the pose of link " + name);
    return true;
  }

  /// Whether no element is between.
  bool follows(const model::Site& next, const model::Site& first) const {
    if (next.span.source != first.span.source || next.span.begin < first.span.end) return false;
    const xml::Document& document = source_.documents.of(next.span.source);
    return document.element(next.element - 1).span().end <= first.span.end;
  }

  void move_link_frame(Id<model::Link> id, const std::string& name, const Pose& X_JL) {
    const model::Link& link = root_[id];
    const model::Joint& joint = root_[tree_.carriers[id.value]];
    take_pose(source_, ledger_, link.pose, Outcome::kRewritten);
    std::string instead;
    if (options_.link_frames == LinkFramePolicy::kKeepLinks) {
      instead = naming_.link_names.add(name + "_frame");
      draft_.robot.links.push_back({.name = instead});
      add_fixed(instead + "_joint", name, instead,
                origin_like(source_.documents, X_JL, {&link.pose}));
    }
    note(NoteKind::kLinkFrame, Outcome::kRewritten,
         joint.pose.pose.written ? joint.pose.pose.span : link.site.name,
         model::subject(root_, link),
         pose_text(origin_like(source_.documents, inverse(X_JL), {&joint.pose})), instead);
  }

  void add_fixed(const std::string& name, const std::string& parent, const std::string& child,
                 UrdfOrigin origin) {
    draft_.robot.joints.push_back({.name = naming_.joint_names.add(name),
                                   .type = "fixed",
                                   .parent = parent,
                                   .child = child,
                                   .origin = std::move(origin)});
  }

  // --- Joints ---

  void add_edge(const UrdfTree::Edge& edge) {
    const model::Joint& joint = root_[edge.joint];
    // Never a frame that the joint names and that is a link without mass now: libsdformat 12.3 drops what
    // such a link carries (measured), though it lumps the link itself.
    const Pose X_MP = edge.parent ? X_M_frame(edge.parent) : X_M_world();
    const Pose X_MJ = places_.X_M(edge.joint);
    const Pose X_PJ = X_MP == Pose{} ? X_MJ : compose(inverse(X_MP), X_MJ);
    const UrdfJointNames& names = naming_.joints.at(edge.joint);
    const UrdfJointPlace place{
        .parent = edge.parent ? naming_.links.at(edge.parent) : root_link_,
        .child = naming_.links.at(edge.child),
        .carried = edge.child,
        .origin = origin_like(source_.documents, X_PJ, {&joint.pose, &root_[edge.child].pose}),
        .turned = edge.turned};
    take_pose(source_, ledger_, joint.pose);
    tell_gimbal(joint, place.origin);
    if (!edge.parent) {
      ledger_.take(joint.parent, Outcome::kRewritten);
      note(NoteKind::kWorldLink, Outcome::kRewritten, joint.parent.span,
           model::subject(root_, joint), "world", "world");
    }
    if (edge.turned) tell_turned(joint, place);
    const std::size_t first = draft_.robot.joints.size();
    add_joint(draft_, edge.joint, names, place);
    draft_.robot.joints[first].comments =
        remarks_on(source_.documents, joint.site, CommentsFor::kUrdf);
    add_joint_blocks(draft_, edge.joint, names.joints.front());
  }

  void tell_turned(const model::Joint& joint, const UrdfJointPlace& place) {
    ledger_.take(joint.parent, Outcome::kRewritten);
    ledger_.take(joint.child, Outcome::kRewritten);
    note(NoteKind::kTurned, Outcome::kRewritten, joint.child.span, model::subject(root_, joint),
         joint.child.value, "parent " + place.parent + ", child " + place.child);
  }

  void tell_gimbal(const model::Joint& joint, const UrdfOrigin& origin) {
    const bool own_digits = !origin.rpy[0].text.empty();
    const double pitch = std::abs(origin.rpy[1].value);
    if (own_digits || std::abs(pitch - std::numbers::pi / 2) > kGimbal) return;
    note(NoteKind::kGimbal, Outcome::kRewritten,
         joint.pose.pose.written ? joint.pose.pose.span : joint.site.name,
         model::subject(root_, joint), {}, number_texts(origin.rpy));
  }

  void leave_out(const UrdfTree::LeftOut& left_out) {
    const model::Joint& joint = root_[left_out.joint];
    ledger_.lose(joint.site, note_on(source_, tree_, left_out));
  }

  // --- Frames ---

  struct FrameParent {
    std::string link;  ///< empty where it has none
    Pose X_MP;
  };

  /// What a frame is attached to: a frame that became a link, else the link that carries both.
  FrameParent parent_of(Id<model::Frame> id) const {
    const model::Frame& frame = root_[id];
    if (!frame.attached_to.value.empty()) {
      const model::Named named =
          source_.frames.names().find({frame.model, {}}, frame.attached_to.value);
      if (const auto* base = std::get_if<Id<model::Frame>>(&named)) {
        const auto name = naming_.frames.find(*base);
        if (name != naming_.frames.end()) return {name->second, places_.X_M(*base)};
      }
    }
    const Id<model::Link> carrier = source_.frames.carrier(id);
    const auto parent = naming_.links.find(carrier);
    if (parent == naming_.links.end()) return {};
    return {parent->second, X_M_frame(carrier)};
  }

  void add_frame(Id<model::Frame> id) {
    const model::Frame& frame = root_[id];
    if (written_frames_.contains(id)) return;
    const auto fixed = tree_.fixed_by.find(id);
    const Id<model::Frame> placed = fixed == tree_.fixed_by.end() ? id : fixed->second;
    const FrameParent parent = parent_of(placed);
    const auto name = naming_.frames.find(id);
    Note told{.kind = NoteKind::kFrame, .subject = model::subject(root_, frame)};
    if (parent.link.empty() || name == naming_.frames.end()) {
      if (placed != id) ledger_.take_all(root_[placed].site, Outcome::kLost);
      return ledger_.lose(frame.site, std::move(told));
    }
    const Pose X_MF = places_.X_M(id);
    const Pose X_PF = parent.X_MP == Pose{} ? X_MF : compose(inverse(parent.X_MP), X_MF);
    draft_.robot.links.push_back(
        {.name = name->second,
         .comments = remarks_on(source_.documents, frame.site, CommentsFor::kUrdf)});
    const std::string joint = placed == id ? name->second + "_joint"
                                           : name_inside(tree_, root_, scoped_name(root_, placed));
    add_fixed(joint, parent.link, name->second,
              origin_like(source_.documents, X_PF, {&root_[placed].pose}));
    for (const Id<model::Frame> taken : {id, placed}) take_frame(taken);
    if (placed != id) {
      draft_.robot.joints.back().comments =
          remarks_on(source_.documents, root_[placed].site, CommentsFor::kUrdf);
    }
    told.outcome = Outcome::kRewritten;
    told.where = frame.name.written ? frame.name.span : frame.site.name;
    told.written = frame.name.value;
    told.instead = "a link named " + name->second + " on a fixed joint";
    if (placed != id) told.instead += " named " + draft_.robot.joints.back().name;
    ledger_.note(std::move(told));
  }

  void take_frame(Id<model::Frame> id) {
    const model::Frame& frame = root_[id];
    ledger_.take(frame.site, Outcome::kRewritten);
    ledger_.take(frame.name, Outcome::kRewritten);
    ledger_.take(frame.attached_to, Outcome::kRewritten);
    take_pose(source_, ledger_, frame.pose, Outcome::kRewritten);
  }

  // --- The result ---

  void hand_over() {
    for (const auto& [id, name] : naming_.links) {
      result_.links.emplace(name_inside(tree_, root_, scoped_name(root_, id)), name);
    }
    for (const auto& [id, names] : naming_.joints) {
      result_.joints.emplace(name_inside(tree_, root_, scoped_name(root_, id)), names.joints);
    }
    result_.robot = std::move(draft_.robot);
    result_.files = std::move(draft_.files);
  }

  const Source& source_;
  const model::Root& root_;
  const UrdfOptions options_;
  const UrdfTree& tree_;
  const UrdfRoots& roots_;
  Ledger& ledger_;
  UrdfConversion& result_;
  Id<model::Model> top_;
  UrdfPlaces places_;
  UrdfNaming naming_;
  UrdfDraft draft_;
  std::multimap<Id<model::Link>, std::string> cut_;  // comments on joints that are left out
  std::set<Id<model::Frame>> written_frames_;        // with a link or as its joint
  std::string root_link_;                            // empty where the root is the model's own
};

}  // namespace

void build_robot(const Source& source, const UrdfOptions& options, const UrdfTree& tree,
                 const UrdfRoots& roots, Ledger& ledger, UrdfConversion& result) {
  UrdfBuilder(source, options, tree, roots, ledger, result).build();
}

}  // namespace rigor::convert
