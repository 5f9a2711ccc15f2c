// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/lump/lump.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/verbs/block.h>
#include <rigor/author/verbs/draft.h>
#include <rigor/author/verbs/inertial_block.h>
#include <rigor/author/verbs/lump/link_settings.h>
#include <rigor/author/verbs/lump/lump_references.h>
#include <rigor/author/verbs/placed.h>
#include <rigor/author/verbs/robot_laws.h>
#include <rigor/read/values.h>
#include <rigor/robot/lumping.h>
#include <rigor/xml/edit.h>
#include <rigor/xml/style.h>

namespace rigor::author {
namespace {

using model::Id;
using model::JointType;
using model::Pose;

constexpr int kFirstWithAttachedFrames = 7;

/// "collision arm/shell": a part by its kind, link and name.
using PartKey = std::pair<std::string, std::string>;

class Lumper {
 public:
  Lumper(const EditedModel& edited, const std::vector<std::string>& links)
      : edited_(edited), root_(edited.root()), draft_(edited), links_(links) {}

  Change lump() {
    if (edited_.loaded.file->expanded) return refusal("it is a template");
    if (const auto included = included_part(edited_))
      return refusal("a part of it is in " + *included);
    if (std::string fault = find_holders(); !fault.empty()) return refusal(std::move(fault));
    if (std::string fault = fault_of_old_file(); !fault.empty()) return refusal(std::move(fault));
    if (std::string fault = fault_of_grippers(); !fault.empty()) return refusal(std::move(fault));
    if (std::string fault = fault_of_frames(); !fault.empty()) return refusal(std::move(fault));
    if (std::string fault = fault_of_settings(edited_, held_by_, joints_); !fault.empty())
      return refusal(std::move(fault));
    rename_parts();
    move_contents();
    if (edited_.is_urdf()) {
      rewrite_urdf();
    } else {
      has_frames() ? rewrite_sdf() : rewrite_old_sdf();
    }
    if (!draft_.problem().empty()) return refusal(draft_.problem());
    Change change;
    change.steps = draft_.take();
    change.expected = law();
    for (const auto& [link, holder] : held_by_)
      change.notes.push_back(fmt::format("link {} is part of {} now", link, holder));
    for (std::string& line : names_left(edited_, held_by_, joints_))
      change.notes.push_back(std::move(line));
    change.asks_for_setting = [](const robot::Difference&) { return true; };
    return change;
  }

 private:
  std::string find_holders() {
    const robot::Robot& robot = edited_.robot;
    const auto is_asked = [&](const std::string& name) {
      return links_.empty() || std::find(links_.begin(), links_.end(), name) != links_.end();
    };
    for (const std::string& name : links_) {
      const std::uint32_t body = edited_.body_index(name);
      if (body == robot::kNoIndex) return fmt::format("no link is named '{}'", name);
      const std::uint32_t carrier = robot.bodies[body].carrier;
      if (carrier == robot::kNoIndex || robot.joints[carrier].type != JointType::kFixed)
        return fmt::format("link '{}' is on no fixed joint", name);
    }
    for (const std::uint32_t i : robot.order) {
      const std::uint32_t carrier = robot.bodies[i].carrier;
      if (carrier == robot::kNoIndex || robot.joints[carrier].type != JointType::kFixed ||
          !is_asked(robot.bodies[i].name))
        continue;
      const std::string& parent = robot.bodies[robot.joints[carrier].parent].name;
      if (!edited_.link(parent) || parent == robot::kWorldBody) continue;
      // Frames of nested models would be theirs to write.
      if ((robot.bodies[i].name + parent).find("::") != std::string::npos) continue;
      const auto above = held_by_.find(parent);
      held_by_[robot.bodies[i].name] = above == held_by_.end() ? parent : above->second;
      joints_.insert(robot.joints[carrier].name);
    }
    for (const robot::Joint& joint : robot.joints) {
      if (joint.closes_loop) return fmt::format("joint '{}' closes a loop", joint.name);
    }
    return held_by_.empty() ? "no link is on a fixed joint to another" : "";
  }

  /// Whether names of links can stay as those of frames.
  bool has_frames() const {
    return !edited_.is_urdf() && root_[edited_.model].version >= kFirstWithAttachedFrames;
  }

  /// Of SDF before 1.7: poses in frames that only 1.5 and 1.6 knew.
  std::string fault_of_old_file() const {
    if (edited_.is_urdf() || has_frames()) return {};
    if (root_[edited_.model].version == 0) return "it is SDF 1.0: upgrade it first";
    for (const Placed& each : placed_in(edited_)) {
      if (!each.field.relative_to.value.empty())
        return fmt::format("line {}: the pose names a frame, which 1.7 defines: upgrade it first",
                           line_of(each.holder));
    }
    return {};
  }

  /// A hand of Gazebo is made of links.
  std::string fault_of_grippers() const {
    for (std::uint32_t i = 0; i < edited_.document().element_count(); ++i) {
      const xml::Element element = edited_.document().element(i);
      if (element.name() != "palm_link" && element.name() != "gripper_link") continue;
      const auto parent = element.parent();
      if (!parent || parent->name() != "gripper") continue;
      if (held_by_.contains(std::string(read::trimmed(element.text()))))
        return fmt::format("line {}: a gripper names it", line_of(element));
    }
    return {};
  }

  std::uint32_t line_of(xml::Element element) const {
    const Span tag = element.tag_span();
    return edited_.sources.position(tag.source, tag.begin).line;
  }

  /// Of URDF: SDF in a `<gazebo>` whose pose is in a frame that goes.
  std::string fault_of_frames() const {
    if (!edited_.is_urdf()) return {};
    for (const Placed& each : placed_in(edited_)) {
      const std::string& frame = each.field.relative_to.value;
      if (held_by_.contains(frame) || joints_.contains(frame))
        return fmt::format("line {}: a pose is relative to '{}', which would go",
                           line_of(each.holder), frame);
    }
    return {};
  }

  Id<model::Link> holder_of(Id<model::Link> link) const {
    const auto held = held_by_.find(edited_.name_of(link));
    return held == held_by_.end() ? Id<model::Link>{} : edited_.link(held->second);
  }

  /// Of a link in the frame of its holder, at rest.
  Pose in_holder(Id<model::Link> link) const {
    return compose(inverse(*edited_.frames.pose(holder_of(link))), *edited_.frames.pose(link));
  }

  /// SDF: what its new link has by that name already gets its old link's in front.
  void rename_parts() {
    if (edited_.is_urdf()) return;
    std::set<PartKey> taken;
    const auto key = [](const std::string& link, const char* kind, const std::string& name) {
      return PartKey{link + ' ' + kind, name};
    };
    const auto each_part = [&](bool held, const auto& use) {
      for (const std::uint32_t i : edited_.robot.order) {
        const robot::Body& body = edited_.robot.bodies[i];
        if (held_by_.contains(body.name) != held) continue;
        for (const robot::Part& part : body.collisions) use(body.name, "collision", part.name);
        for (const robot::Part& part : body.visuals) use(body.name, "visual", part.name);
        const Id<model::Link> link = edited_.link(body.name);
        if (!link) continue;
        for (const xml::Element child : edited_.element(root_[link].site).children()) {
          const auto name = child.attribute("name");
          for (const char* kind : {"sensor", "light", "particle_emitter", "projector", "battery"}) {
            if (name && child.name() == kind) use(body.name, kind, std::string(name->value()));
          }
        }
      }
    };
    each_part(false, [&](const std::string& link, const char* kind, const std::string& name) {
      taken.insert(key(link, kind, name));
    });
    each_part(true, [&](const std::string& link, const char* kind, const std::string& name) {
      const std::string& holder = held_by_.at(link);
      if (taken.insert(key(holder, kind, name)).second) return;
      const std::string other = link + '_' + name;
      taken.insert(key(holder, kind, other));
      renamed_[key(link, kind, name)] = other;
    });
  }

  // --- What links hold ---

  /// In the order in which the law lists it: depth first, by the joints of the file.
  std::vector<Id<model::Link>> held_downwards() const {
    std::vector<Id<model::Link>> list;
    std::vector<std::uint32_t> stack;
    const robot::Robot& robot = edited_.robot;
    for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
      if (robot.bodies[i].carrier == robot::kNoIndex) stack.push_back(i);
    }
    std::reverse(stack.begin(), stack.end());
    while (!stack.empty()) {
      const std::uint32_t i = stack.back();
      stack.pop_back();
      if (held_by_.contains(robot.bodies[i].name))
        list.push_back(edited_.link(robot.bodies[i].name));
      std::vector<std::uint32_t> carried;
      for (std::uint32_t k = 0; k < robot.joints.size(); ++k) {
        const robot::Joint& joint = robot.joints[k];
        if (joint.parent == i && robot.bodies[joint.child].carrier == k)
          carried.push_back(joint.child);
      }
      stack.insert(stack.end(), carried.rbegin(), carried.rend());
    }
    return list;
  }

  void move_contents() {
    const std::vector<Id<model::Link>> held = held_downwards();
    std::map<Id<model::Link>, std::string> blocks;
    std::vector<Id<model::Link>> order;
    const std::vector<Edit> edits = poses_in_holders();
    const xml::Document& document = edited_.document();
    const std::string line(xml::line_end(document, 0));
    for (const Id<model::Link> link : held) {
      const Id<model::Link> holder = holder_of(link);
      if (!blocks.contains(holder)) order.push_back(holder);
      std::string& block = blocks[holder];
      for (const xml::Element child : edited_.element(root_[link].site).children()) {
        if (!is_movable_part(child.name())) continue;
        if (!block.empty()) block += line;
        block += xml::indentation(document, child) +
                 part_after(document, child.span().begin, child.span().end, edits);
      }
      draft_.remove(edited_.element(root_[link].site));
    }
    for (const Id<model::Link> holder : order) set_holder(holder, blocks[holder]);
  }

  /// Poses of what the held links hold, as they are in their holders; names, where they are taken.
  std::vector<Edit> poses_in_holders() {
    Draft moved(edited_);
    for (const Placed& each : placed_in(edited_)) {
      if (is_part(each) && holder_of(each.link)) place_in_holder(each, moved);
    }
    for (const auto& [link, holder] : held_by_) {
      if (edited_.is_urdf()) continue;
      for (const xml::Element child : edited_.element(root_[edited_.link(link)].site).children())
        rename_part(link, child, moved);
    }
    return draft_.edits_for_copy(std::move(moved));
  }

  static bool is_part(const Placed& each) {
    return each.link && !each.on_joint &&
           (each.kind == PlacedKind::kCollision || each.kind == PlacedKind::kVisual ||
            each.kind == PlacedKind::kSensor || each.kind == PlacedKind::kLight ||
            each.kind == PlacedKind::kEmitter);
  }

  void place_in_holder(const Placed& each, Draft& moved) {
    const bool is_default = each.field.relative_to.value.empty();
    const Pose X =
        is_default ? compose(in_holder(each.link), each.field.pose.value) : each.field.pose.value;
    if (edited_.is_urdf()) {
      const Span link = root_[each.link].site.span, part = each.holder.span();
      const bool is_inside = link.begin < part.begin && part.end <= link.end;
      if (is_default) (is_inside ? moved : draft_).set_pose(each.field, each.holder, X);
      return;
    }
    // What plays a sound reads numbers alone.
    const bool by_frame = has_frames() && each.kind != PlacedKind::kEmitter;
    if (by_frame && is_default) {
      moved.set_pose(each.field, each.holder, each.field.pose.value, edited_.name_of(each.link));
    } else if (is_default) {
      moved.set_pose(each.field, each.holder, X);
    }
  }

  const std::string* new_name(const std::string& link, std::string_view kind,
                              std::string_view name) const {
    const auto other = renamed_.find({link + ' ' + std::string(kind), std::string(name)});
    return other == renamed_.end() ? nullptr : &other->second;
  }

  /// And in it the collisions that it names.
  void rename_part(const std::string& link, xml::Element part, Draft& moved) const {
    const auto attribute = part.attribute("name");
    if (attribute) {
      if (const std::string* name = new_name(link, part.name(), attribute->value()))
        moved.add({{attribute->value_span(), xml::escaped(*name)}});
    }
    const auto contact = part.child("contact");
    if (!contact) return;
    for (const xml::Element child : contact->children()) {
      if (child.name() != "collision") continue;
      if (const std::string* name = new_name(link, "collision", read::trimmed(child.text())))
        moved.set_text(child, *name);
    }
  }

  /// What it holds now, and the mass of all.
  void set_holder(Id<model::Link> holder, const std::string& block) {
    const xml::Document& document = edited_.document();
    const xml::Element element = edited_.element(root_[holder].site);
    const robot::Robot expected = law();
    const auto body =
        std::find_if(expected.bodies.begin(), expected.bodies.end(),
                     [&](const robot::Body& each) { return each.name == edited_.name_of(holder); });
    const Pose X_LB = compose(inverse(compose(inverse(*edited_.frames.pose(edited_.model)),
                                              *edited_.frames.pose(holder))),
                              edited_.robot.bodies[edited_.body_index(body->name)].X_MB);
    const mass::MassProperties mass = mass::transformed(X_LB, body->mass);
    const bool changed = !(body->mass == edited_.robot.bodies[edited_.body_index(body->name)].mass);
    const std::string line(xml::line_end(document, 0));
    if (xml::is_empty_tag(document, element)) {
      const std::string in = xml::indentation(document, element);
      const std::string unit = xml::indent_unit(document, element);
      std::string text;
      if (changed) text += indented_by(inertial(mass), in + unit, line) + line;
      if (!block.empty()) text += block + line;
      const Span tag = element.tag_span();
      const auto slash = static_cast<std::uint32_t>(
          document.bytes().substr(0, tag.end).find_last_not_of(" \t/>") + 1);
      if (!text.empty())
        draft_.add({{{tag.source, slash, tag.end},
                     '>' + line + text + in + "</" + std::string(element.name()) + '>'}});
      return;
    }
    if (changed) set_inertial(draft_, edited_, root_[holder], mass);
    if (block.empty()) return;
    if (auto edit = block_at_end(document, element, block)) draft_.add({*std::move(edit)});
  }

  std::string inertial(const mass::MassProperties& body) const {
    return inertial_block(body, edited_.is_urdf() ? InertialForm::kUrdf : InertialForm::kSdf);
  }

  // --- What refers to them ---

  void rewrite_urdf() {
    for (const model::Joint& joint : root_.joints) {
      if (joints_.contains(joint.name.value)) {
        draft_.remove(edited_.element(joint.site));
        continue;
      }
      const Id<model::Link> parent = edited_.link(joint.parent.value);
      if (!parent || !holder_of(parent)) continue;
      draft_.add({{joint.parent.span, edited_.name_of(holder_of(parent))}});
      draft_.set_pose(joint.pose, edited_.element(joint.site),
                      compose(in_holder(parent), joint.pose.pose.value));
    }
    move_blocks(draft_, edited_, held_by_, joints_);
    for (const xml::Element child : edited_.element(root_[edited_.model].site).children()) {
      if (child.name() == "sensor") move_sensor(child);
    }
  }

  /// Of the robot, which names the link or joint that it is on.
  void move_sensor(xml::Element sensor) {
    const auto parent = sensor.child("parent");
    if (!parent) return;
    const auto link = parent->attribute("link"), joint = parent->attribute("joint");
    if (link) {
      const auto held = held_by_.find(std::string(link->value()));
      if (held != held_by_.end()) draft_.set_attribute(*parent, "link", held->second);
    } else if (joint && joints_.contains(std::string(joint->value()))) {
      const Id<model::Joint> id = edited_.joint(joint->value());
      const std::string& holder = edited_.name_of(holder_of(edited_.frames.ends(id).child));
      draft_.add(xml::replace_element(edited_.document(), *parent,
                                      "<parent link=\"" + xml::escaped(holder) + "\"/>"));
    }
  }

  /// Joints name the holder; the pose of one is in its child, which may be what is held where the parent is the child
  /// in the robot.
  void rewrite_old_sdf() {
    for (const model::Joint& joint : root_.joints) {
      if (joint.model != edited_.model) continue;
      const xml::Element element = edited_.element(joint.site);
      if (joints_.contains(joint.name.value)) {
        draft_.remove(element);
        continue;
      }
      const Id<model::Link> parent = edited_.link(joint.parent.value);
      const Id<model::Link> child = edited_.link(joint.child.value);
      if (parent && holder_of(parent))
        draft_.add({{joint.parent.span, xml::escaped(edited_.name_of(holder_of(parent)))}});
      if (child && holder_of(child)) {
        draft_.add({{joint.child.span, xml::escaped(edited_.name_of(holder_of(child)))}});
        draft_.set_pose(joint.pose, element, compose(in_holder(child), joint.pose.pose.value));
      }
    }
  }

  /// The links and their joints stay as frames.
  void rewrite_sdf() {
    const xml::Element model = edited_.element(root_[edited_.model].site);
    if (const auto link = model.attribute("canonical_link")) {
      const auto held = held_by_.find(std::string(link->value()));
      if (held != held_by_.end()) draft_.set_attribute(model, "canonical_link", held->second);
    }
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      const model::Link& link = root_.links[i];
      if (!edited_.inside(link.model) || !holder_of({i})) continue;
      frame(link.site, link.name.value, edited_.name_of(holder_of({i})), link.pose, "__model__");
    }
    for (const model::Joint& joint : root_.joints) {
      if (!joints_.contains(joint.name.value) || joint.model != edited_.model) continue;
      const auto& child = edited_.frames.ends(edited_.joint(joint.name.value)).child;
      draft_.remove(edited_.element(joint.site));
      frame(joint.site, joint.name.value,
            edited_.name_of(holder_of(child) ? holder_of(child) : child), joint.pose,
            joint.child.value);
    }
    draft_.add(
        {*block_at_end(edited_.document(), edited_.element(root_[edited_.model].site), frames_)});
  }

  void frame(const model::Site& site, const std::string& name, const std::string& holder,
             const model::PoseField& pose, const std::string& in) {
    const xml::Document& document = edited_.document();
    const std::string line(xml::line_end(document, 0));
    const std::string indent = xml::indentation(document, edited_.element(site));
    const std::string& frame = pose.relative_to.value.empty() ? in : pose.relative_to.value;
    if (!frames_.empty()) frames_ += line;
    frames_ += fmt::format(
        "{0}<frame name=\"{1}\" attached_to=\"{2}\">{3}{0}{4}<pose relative_to=\"{5}\">{6} {7}"
        "</pose>{3}{0}</frame>",
        indent, xml::escaped(name), xml::escaped(holder), line,
        xml::indent_unit(document, edited_.element(site)), xml::escaped(frame),
        xyz_text(pose.pose.value), rpy_text(pose.pose.value));
  }

  // --- The law ---

  robot::Robot law() const {
    robot::Robot before = edited_.robot;
    for (robot::Body& body : before.bodies) {
      const auto rename = [&](std::vector<robot::Part>& parts, const char* kind) {
        for (robot::Part& part : parts) {
          const auto other = renamed_.find({body.name + ' ' + kind, part.name});
          if (other != renamed_.end()) part.name = other->second;
        }
      };
      rename(body.collisions, "collision");
      rename(body.visuals, "visual");
    }
    robot::Robot after = robot::with_embedded(before, held_by_);
    if (!has_frames()) after.frames.clear();
    // SDF: the body's frame was its joint's; what stays by its name is the link's.
    for (robot::Frame& frame : after.frames) {
      const Id<model::Link> link = edited_.link(frame.name);
      frame.of_joint = false;
      if (!link || !held_by_.contains(frame.name)) continue;
      const robot::Body& body = edited_.robot.bodies[edited_.body_index(frame.name)];
      const Pose X_ML =
          compose(inverse(*edited_.frames.pose(edited_.model)), *edited_.frames.pose(link));
      frame.X_BF = compose(frame.X_BF, compose(inverse(body.X_MB), X_ML));
    }
    return after;
  }

  const EditedModel& edited_;
  const model::Root& root_;
  Draft draft_;
  const std::vector<std::string>& links_;
  HeldBy held_by_;
  std::set<std::string> joints_;  ///< that go
  std::map<PartKey, std::string> renamed_;
  std::string frames_;
};

}  // namespace

Change lumped(const EditedModel& edited, const std::vector<std::string>& links) {
  return Lumper(edited, links).lump();
}

}  // namespace rigor::author
