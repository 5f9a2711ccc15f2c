// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/remove.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/names/name_graph.h>
#include <rigor/author/names/parameter_names.h>
#include <rigor/author/names/text_mentions.h>
#include <rigor/author/verbs/draft.h>
#include <rigor/author/verbs/placed.h>
#include <rigor/author/verbs/robot_laws.h>
#include <rigor/text/path.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

using model::Id;

/// An element that has no meaning without what it names.
constexpr std::string_view kDependents[] = {"transmission",
                                            "disable_collisions",
                                            "enable_collisions",
                                            "passive_joint",
                                            "end_effector",
                                            "virtual_joint",
                                            "gripper",
                                            "joint_property",
                                            "disable_default_collisions",
                                            "link_sphere_approximation"};

class Remover {
 public:
  Remover(const EditedModel& edited, std::vector<bool> kept, const ReferringFiles& files)
      : edited_(edited),
        root_(edited.root()),
        kept_(std::move(kept)),
        files_(files.all()),
        draft_(edited),
        graph_(edited.workspace, edited.environment.resolver) {}

  Change remove() {
    graph_.add_robot(edited_.path());
    find_removed();
    if (!refused_.empty()) return refusal(refused_);
    rewrite_poses();
    remove_uses();
    list_texts();
    if (!refused_.empty()) return refusal(refused_);
    for (const xml::Element element : removed_) draft_.remove(element);
    Change change;
    change.steps = draft_.take();
    for (auto& step : steps_) change.steps.push_back(std::move(step));
    change.expected = restricted(edited_.robot, kept_);
    change.notes = std::move(notes_);
    // Blocks of what is removed go; what they say is no link's any more.
    change.asks_for_setting = [](const robot::Difference& difference) {
      const bool is_gone = difference.to.text.empty() && difference.to.numbers.empty();
      return difference.b.empty() || difference.kind == robot::DifferenceKind::kAttachmentOnlyInA ||
             (difference.kind == robot::DifferenceKind::kSetting && is_gone);
    };
    return change;
  }

 private:
  bool is_kept(std::uint32_t body) const { return body != robot::kNoIndex && kept_[body]; }

  /// Elements that nothing removed is around.
  void take(const model::Site& site, std::string_view what, const std::string& name) {
    if (!root_.own(site)) {
      refused_ = fmt::format("{} '{}' is in a file that is included: edit that one", what, name);
      return;
    }
    removed_.push_back(edited_.element(site));
    spans_.push_back(site.span);
  }
  bool is_removed(Span span) const {
    return std::any_of(spans_.begin(), spans_.end(), [&](const Span& removed) {
      return removed.source == span.source && removed.begin <= span.begin &&
             span.end <= removed.end;
    });
  }

  void find_removed() {
    // A nested model of which nothing is left goes as a whole, or its include.
    for (std::uint32_t i = 0; i < root_.models.size() && refused_.empty(); ++i) {
      const model::Model& nested = root_.models[i];
      if (i == edited_.model.value || !edited_.inside({i}) || !is_empty({i})) continue;
      const model::Site& site =
          nested.include == 0xffffffffU ? nested.site : root_.includes[nested.include].site;
      if (root_.own(site) && !is_removed(site.span)) take(site, "model", nested.name.value);
    }
    each_part(root_.links, "link",
              [&](Id<model::Link> id) { return edited_.body_index(edited_.name_of(id)); });
    each_part(root_.joints, "joint", [&](Id<model::Joint> id) {
      const std::uint32_t joint = edited_.joint_index(edited_.name_of(id));
      if (joint == robot::kNoIndex) return robot::kNoIndex;
      const robot::Joint& ends = edited_.robot.joints[joint];
      return kept_[ends.parent] ? ends.child : ends.parent;
    });
    each_part(root_.frames, "frame", [&](Id<model::Frame> id) {
      const std::string name = edited_.name_of(id);
      for (const robot::Frame& frame : edited_.robot.frames) {
        if (frame.name == name) return frame.body;
      }
      return robot::kNoIndex;
    });
  }

  template <class T, class BodyOf>
  void each_part(const std::vector<T>& all, std::string_view what, BodyOf body_of) {
    for (std::uint32_t i = 0; i < all.size() && refused_.empty(); ++i) {
      if (!edited_.inside(all[i].model)) continue;
      const std::uint32_t body = body_of(Id<T>{i});
      if (body == robot::kNoIndex || kept_[body]) continue;
      names_.emplace(all[i].name.value);
      if (!is_gone(all[i].model) && !is_removed(all[i].site.span))
        take(all[i].site, what, all[i].name.value);
    }
  }

  bool is_empty(Id<model::Model> nested) const {
    bool has_links = false;
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      Id<model::Model> at = root_.links[i].model;
      while (at && at != nested) at = root_[at].parent;
      if (!at) continue;
      has_links = true;
      if (is_kept(edited_.body_index(edited_.name_of(Id<model::Link>{i})))) return false;
    }
    return has_links;
  }

  /// Whether an include that is removed brought the model.
  bool is_gone(Id<model::Model> id) const {
    for (; id && id != edited_.model; id = root_[id].parent) {
      const std::uint32_t include = root_[id].include;
      if (include != 0xffffffffU && is_removed(root_.includes[include].site.span)) return true;
    }
    return false;
  }

  bool is_removed_name(const EntityId& target) {
    const NamedEntity& entity = graph_.entity(target);
    const read::File& file = graph_.file(target.path);
    return file.document &&
           is_removed(Span{file.document->source(), entity.element.begin, entity.element.end});
  }

  void rewrite_poses() {
    if (edited_.is_urdf()) return;
    const auto X_WM = edited_.frames.pose(edited_.model);
    for (const NameUse& use : graph_.uses(edited_.path())) {
      if (use.defines || is_removed(use.where) || !is_removed_name(use.target)) continue;
      const auto element = edited_.document().element_at(use.where.begin);
      if (!element || element->name() != "pose") continue;
      for (const Placed& each : placed_in(edited_)) {
        if (each.holder.child("pose") != element || !each.X_WF || !X_WM) continue;
        const bool own_scope = each.scope == edited_.model;
        if (!own_scope || root_[edited_.model].version < 7) {
          refused_ = "a pose is relative to what would be removed";
          continue;
        }
        const model::Pose X_MT =
            compose(inverse(*X_WM), compose(*each.X_WF, each.field.pose.value));
        draft_.set_pose(each.field, each.holder, X_MT, "__model__");
      }
    }
  }

  void remove_uses() {
    std::vector<std::string> files = files_;
    files.push_back(edited_.path());
    std::set<std::string> seen;
    for (const std::string& path : files) {
      if (parameter_format(path) || is_mentioning_text(path) ||
          !seen.insert(normalize_path(path)).second)
        continue;
      const read::File& file = graph_.file(path);
      if (!file.document) continue;
      std::set<std::uint32_t> done;
      for (const NameUse& use : graph_.uses(path)) {
        if (use.defines || is_removed(use.where) || !is_removed_name(use.target)) continue;
        depend(file, use, done);
      }
    }
  }

  /// Removes what depends on the name, in the file that has it.
  void depend(const read::File& file, const NameUse& use, std::set<std::uint32_t>& done) {
    std::optional<xml::Element> element = file.document->element_at(use.where.begin);
    const xml::Element innermost = *element;
    for (; element; element = element->parent()) {
      const std::string_view name = element->name();
      const auto parent = element->parent();
      const std::string_view around = parent ? parent->name() : std::string_view();
      const auto outer = parent ? parent->parent() : std::nullopt;
      const bool in_state = around == "state" || (outer && outer->name() == "state");
      if (name == "plugin") return note(use, "a plugin names what is removed");
      if (name == "pose") return;
      if (name == "mimic") {
        refused_ = fmt::format("a joint mimics '{}', which would be removed",
                               edited_.sources.bytes(use.where));
        return;
      }
      const bool depends = std::find(std::begin(kDependents), std::end(kDependents), name) !=
                               std::end(kDependents) ||
                           (name == "gazebo" && parent) || around == "ros2_control" ||
                           around == "group" || around == "group_state" || in_state;
      if (!depends) continue;
      if (done.insert(element->index()).second)
        steps_.push_back(xml::remove_element(*file.document, *element));
      return;
    }
    if (innermost.name() == "model")  // canonical_link, placement_frame
      return remove_attribute(*file.document, innermost, use);
    note(use, "names what is removed");
  }

  void remove_attribute(const xml::Document& document, xml::Element element, const NameUse& use) {
    for (const xml::Attribute attribute : element.attributes()) {
      const Span value = attribute.value_span();
      if (value.begin <= use.where.begin && use.where.end <= value.end)
        steps_.push_back(xml::remove_attribute(document, attribute));
    }
  }

  void note(const NameUse& use, std::string_view text) {
    notes_.push_back(fmt::format("{}:{}: {}: {}", edited_.sources.path(use.where.source),
                                 edited_.sources.position(use.where.source, use.where.begin).line,
                                 text, edited_.sources.bytes(use.where)));
  }

  void list_texts() {
    std::vector<Span> places;
    for (const std::string& path : files_) {
      for (const Span where :
           names_in_text(edited_.environment.disk, edited_.sources, path, names_))
        places.push_back(where);
    }
    for (const std::string& line : mention_lines(edited_.sources, places))
      notes_.push_back(line + ", which is removed");
  }

  const EditedModel& edited_;
  const model::Root& root_;
  std::vector<bool> kept_;  ///< by body
  const std::vector<std::string> files_;
  Draft draft_;
  NameGraph graph_;
  std::vector<xml::Element> removed_;  ///< of the model's document
  std::vector<Span> spans_;
  std::set<std::string> names_;
  std::vector<std::vector<Edit>> steps_;
  std::vector<std::string> notes_;
  std::string refused_;
};

/// Why the link cannot be named; empty when it can.
std::string link_fault(const EditedModel& edited, std::string_view link) {
  if (edited.body_index(link) == robot::kNoIndex || !edited.link(link))
    return fmt::format("no link is named '{}'", link);
  return {};
}

}  // namespace

Change removed(const EditedModel& edited, std::string_view link, Subtree subtree,
               const ReferringFiles& files) {
  if (std::string fault = link_fault(edited, link); !fault.empty()) return refusal(fault);
  std::vector<bool> kept = subtree_of(edited.robot, edited.body_index(link));
  const auto count = std::count(kept.begin(), kept.end(), true);
  if (count > 1 && subtree == Subtree::kRefused) {
    return refusal(
        fmt::format("link '{}' carries {} others: --subtree removes them, too", link, count - 1));
  }
  kept.flip();
  // The world is a body, too, where a joint holds the model; libsdformat rejects one without a link.
  bool left = false;
  for (std::size_t i = 0; i < kept.size(); ++i)
    left = left || (kept[i] && edited.link(edited.robot.bodies[i].name));
  if (!left) return refusal("no link would be left");
  return Remover(edited, std::move(kept), files).remove();
}

Change extracted(const EditedModel& edited, std::string_view link, const ReferringFiles& files) {
  if (std::string fault = link_fault(edited, link); !fault.empty()) return refusal(fault);
  const std::uint32_t body = edited.body_index(link);
  const std::vector<bool> kept = subtree_of(edited.robot, body);
  for (const robot::Joint& joint : edited.robot.joints) {
    const model::Id<model::Joint> id = edited.joint(joint.name);
    if (!kept[joint.parent] || !kept[joint.child] || !id) continue;
    const model::Id<model::Link> child = edited.frames.ends(id).child;
    if (child && edited.body_index(edited.name_of(child)) != joint.child)
      return refusal(fmt::format("joint '{}' is written from its child to its parent: reroot first",
                                 joint.name));
  }
  Change change = Remover(edited, subtree_of(edited.robot, body), files).remove();
  if (!change.refused.empty()) return change;
  for (std::uint32_t i = 0; i < change.expected.bodies.size(); ++i) {
    if (change.expected.bodies[i].name != link) continue;
    const model::Pose X_MB = edited.robot.bodies[body].X_MB;
    const model::Pose X_ML =
        compose(inverse(*edited.frames.pose(edited.model)), *edited.frames.pose(edited.link(link)));
    describe_in(change.expected, i, compose(inverse(X_MB), X_ML));
    if (edited.is_urdf()) change.expected.bodies[i].X_MB = {};
    robot::connect(change.expected);
  }
  return change;
}

}  // namespace rigor::author
