// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Joints between bodies, with all that a file means by leaving something out: no effort is no limit, 1e16
// is infinite, a continuous joint is a revolute one without limits.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>

#include <rigor/model/motion.h>
#include <rigor/simulate/scene/draft.h>

namespace rigor::simulate {
namespace {

using model::Id;
using model::JointType;

std::size_t axes_of_type(JointType type) {
  switch (type) {
    case JointType::kRevolute:
    case JointType::kPrismatic:
    case JointType::kScrew:
    case JointType::kGearbox: return 1;
    case JointType::kUniversal:
    case JointType::kRevolute2: return 2;
    default: return 0;
  }
}

/// Settings of a joint's `<physics><ode>` that are Gazebo's own engine's, and what they are when nothing
/// is meant by them.
struct IgnoredSetting {
  std::string_view name;
  double neutral;
};
constexpr std::array kIgnoredSettings{
    IgnoredSetting{"fudge_factor", 0}, IgnoredSetting{"cfm", 0},
    IgnoredSetting{"erp", 0.2},        IgnoredSetting{"bounce", 0},
    IgnoredSetting{"max_force", 0},    IgnoredSetting{"velocity", 0},
};

/// (m/s)/N with which a joint gives way at once to whatever pulls at it.
constexpr double kGivesWay = 1;

/// Of two axes in one joint, the sine of the angle between them: along one line they are one.
constexpr double kMinAcrossAxes = 1e-3;

class JointBuilder {
 public:
  explicit JointBuilder(SceneDraft& draft)
      : draft_(draft), root_(draft.root), scene_(draft.scene) {}

  void build() {
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      const model::Joint& joint = root_.joints[i];
      const bool taken =
          joint.model ? draft_.takes(joint.model) : joint.world && joint.world.value == 0;
      if (taken) add(Id<model::Joint>{i});
    }
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      if (draft_.joint_of[i] != kWorld) add_mimics({i});
    }
    drop_mimic_cycles();
  }

 private:
  void add(Id<model::Joint> id) {
    const model::Joint& joint = root_[id];
    const model::Frames::Ends& ends = draft_.input.frames.ends(id);
    if (!ends.child || (!ends.parent && !ends.parent_is_world)) {
      const auto& end = ends.child ? joint.parent : joint.child;
      return say(FactKind::kUnreadable, end.written ? end.span : place(joint), joint,
                 ends.child ? "no parent" : "no child");
    }
    const std::uint32_t child = body_of(ends.child);
    const std::uint32_t parent = ends.parent_is_world ? kWorld : body_of(ends.parent);
    if (!known(ends.child) || (ends.parent && !known(ends.parent))) {
      // Its link has no pose, which is said, or stands in a model that was not chosen.
      if (!joint.model) say(FactKind::kJointIgnored, place(joint), joint, "model not chosen");
      return;
    }
    if (child == parent && (child == kWorld || joint.type == JointType::kFixed)) return;
    if (joint.type == JointType::kFloating) return;  // its child is free
    if (joint.type == JointType::kUnknown) {
      return say(FactKind::kUnreadable, or_name(joint.type_name.span, joint), joint,
                 "type " + joint.type_name.value);
    }
    if (joint.type == JointType::kPlanar) {
      return say(FactKind::kJointIgnored, or_name(joint.type_name.span, joint), joint, "planar");
    }
    if (child == parent) {
      return say(FactKind::kJointIgnored, place(joint), joint, "both ends are one body");
    }
    if (const std::optional<Span> cfm = giving_way(joint)) {
      say(FactKind::kJointIgnored, *cfm, joint, "its cfm lets it give way");
      draft_.facts.back().help = "give it a smaller `<cfm>` if it is to hold";
      return;
    }
    SceneJoint out;
    out.name = scoped_name(root_, id);
    out.type = joint.type == JointType::kContinuous ? JointType::kRevolute : joint.type;
    out.parent = parent;
    out.child = child;
    out.model = joint.model ? draft_.model_of[joint.model.value] : kWorld;
    out.where = place(joint);
    const auto X_WJ = draft_.input.frames.pose(id);
    if (!X_WJ) return say(FactKind::kUnreadable, out.where, joint, "no pose");
    out.anchor_W = X_WJ->translation;
    const bool both = out.type == JointType::kGearbox && joint.axes.size() > 1;
    for (std::size_t k = 0; k < axes_of_type(out.type) + (both ? 1 : 0); ++k) {
      const auto axis = axis_of(id, k);
      if (!axis) return;
      out.axes.push_back(*axis);
    }
    if (out.type == JointType::kUniversal || out.type == JointType::kRevolute2) {
      const double across = length(cross(out.axes[0].direction_W, out.axes[1].direction_W));
      if (across < kMinAcrossAxes) {
        const Span where = or_name(joint.axes[1].xyz.span, joint);
        return say(FactKind::kAxisZero, where, joint, "axis2 along axis", across, kMinAcrossAxes);
      }
    }
    if (out.type == JointType::kScrew) add_screw(out, joint);
    if (out.type == JointType::kGearbox && !add_gearbox(out, joint)) return;
    draft_.joint_of[id.value] = static_cast<std::uint32_t>(scene_.joints.size());
    scene_.joints.push_back(std::move(out));
  }

  bool known(Id<model::Link> link) const { return draft_.link_of[link.value] != kWorld; }
  std::uint32_t body_of(Id<model::Link> link) const {
    return link && known(link) ? scene_.links[draft_.link_of[link.value]].body : kWorld;
  }

  /// Where the `<cfm>` is of a joint that is only there for its damping: with an `<erp>` it would be a spring.
  std::optional<Span> giving_way(const model::Joint& joint) const {
    if (in_urdf(joint)) return std::nullopt;
    const auto physics = element_at(draft_.element(joint.site), {"physics", "ode"});
    if (!physics) return std::nullopt;
    const model::Parameter ode = read::parameter_of(*physics);
    const auto number = [&](std::string_view name, double otherwise) {
      const model::Parameter* given = find(ode.children, name);
      return given == nullptr ? otherwise
                              : SceneDraft::parsed_number(given->value.value).value_or(otherwise);
    };
    if (number("erp", 1) != 0 || number("cfm", 0) < kGivesWay) return std::nullopt;
    return find(ode.children, "cfm")->value.span;
  }

  std::optional<SceneAxis> axis_of(Id<model::Joint> id, std::size_t k) {
    const model::Joint& joint = root_[id];
    if (k >= joint.axes.size()) {
      say(FactKind::kAxisZero, place(joint), joint, k == 0 ? "axis" : "axis2");
      return std::nullopt;
    }
    const model::Axis& written = joint.axes[k];
    const auto direction = draft_.input.frames.axis(id, k);
    if (!direction) {
      const bool zero = length(written.xyz.value) == 0;
      const Span where = zero ? written.xyz.span : written.expressed_in.span;
      say(zero ? FactKind::kAxisZero : FactKind::kUnreadable, or_name(where, joint), joint,
          zero ? "xyz" : "expressed_in");
      return std::nullopt;
    }
    SceneAxis axis;
    axis.direction_W = 1 / length(*direction) * *direction;
    const auto start = draft_.input.positions.find(scoped_name(root_, id));
    if (start != draft_.input.positions.end() && k < start->second.size()) {
      axis.start = start->second[k];
    }
    const auto& moved = draft_.input.moved;
    if (std::find(moved.begin(), moved.end(), id) != moved.end()) {
      say(FactKind::kStartMoved, or_name(written.limit_site.name, joint), joint, {}, axis.start);
      draft_.facts.back().slides = joint.type == JointType::kPrismatic;
    }
    axis.where = written.site.name;
    axis.limit_where = written.limit_site.name;
    if (joint.type != JointType::kContinuous) add_limits(axis, written, joint);
    axis.effort = effort_limit(root_, joint, written);
    axis.velocity = velocity_limit(root_, joint, written);
    axis.damping = passive(written.damping, "damping", joint);
    axis.friction = passive(written.friction, "friction", joint);
    axis.spring_reference = written.spring_reference.value;
    axis.spring_stiffness = passive(written.spring_stiffness, "spring_stiffness", joint);
    add_stops(axis, joint);
    if (in_urdf(joint)) add_spring_blocks(axis, joint);
    say_what_axes_lose(written, joint);
    return axis;
  }

  void add_limits(SceneAxis& axis, const model::Axis& written, const model::Joint& joint) {
    axis.lower = model::position_limit(written.lower.value);
    axis.upper = model::position_limit(written.upper.value);
    const bool shut =
        axis.lower > axis.upper || axis.lower == kInfinity || axis.upper == -kInfinity;
    if (!shut) return;
    const Span where = written.lower.written ? written.lower.span : written.upper.span;
    say(FactKind::kLimitsCrossed, where.nowhere() ? written.limit_site.name : where, joint, {},
        axis.lower, axis.upper);
  }

  /// A negative one would drive the joint.
  double passive(const model::Field<double>& field, std::string_view name,
                 const model::Joint& joint) {
    if (field.value >= 0) return field.value;
    say(FactKind::kDampingAsNone, or_name(field.span, joint), joint, std::string(name),
        field.value);
    return 0;
  }

  void add_stops(SceneAxis& axis, const model::Joint& joint) {
    if (in_urdf(joint)) {
      for (const auto* given : blocks(joint, {"stopErp", "stopCfm"})) {
        (given->name == "stopErp" ? axis.stop_erp : axis.stop_cfm) = stop(*given, joint);
      }
    } else if (const auto limit =
                   element_at(draft_.element(joint.site), {"physics", "ode", "limit"})) {
      const model::Parameter given = read::parameter_of(*limit);
      if (const auto* erp = find(given.children, "erp")) axis.stop_erp = stop(*erp, joint);
      if (const auto* cfm = find(given.children, "cfm")) axis.stop_cfm = stop(*cfm, joint);
    }
    axis.stop_erp = std::min(axis.stop_erp, 1.0);
  }

  double stop(const model::Parameter& given, const model::Joint& joint) {
    return std::max(0.0, draft_.number(given, 0, joint));
  }

  void add_spring_blocks(SceneAxis& axis, const model::Joint& joint) {
    for (const auto* given : blocks(joint, {"springReference", "springStiffness"})) {
      const double value = draft_.number(*given, 0, joint);
      if (given->name == "springReference") {
        axis.spring_reference = value;
      } else {
        axis.spring_stiffness = std::max(0.0, value);
      }
    }
  }

  void say_what_axes_lose(const model::Axis& written, const model::Joint& joint) {
    if (in_urdf(joint)) {
      for (const auto* given : blocks(joint, {"fudgeFactor"})) ignore_unless(given, 0, joint);
      return;
    }
    const model::Parameter axis = read::parameter_of(draft_.element(written.site));
    ignore_unless(find(axis.children, "initial_position"), 0, joint);
    if (const auto* limit = find(axis.children, "limit")) {
      ignore_unless(find(limit->children, "stiffness"), 1e8, joint);
      ignore_unless(find(limit->children, "dissipation"), 1, joint);
    }
    const auto physics = element_at(draft_.element(joint.site), {"physics", "ode"});
    if (!physics || &written != &joint.axes.front()) return;
    const model::Parameter ode = read::parameter_of(*physics);
    for (const IgnoredSetting& setting : kIgnoredSettings) {
      ignore_unless(find(ode.children, setting.name), setting.neutral, joint);
    }
    if (const auto* suspension = find(ode.children, "suspension")) {
      say(FactKind::kElementIgnored, suspension->site.name, joint, "suspension");
    }
  }

  void ignore_unless(const model::Parameter* given, double neutral, const model::Joint& joint) {
    if (given == nullptr) return;
    const auto value = SceneDraft::parsed_number(given->value.value);
    if (!value || *value == neutral) return;
    say(FactKind::kElementIgnored, given->value.span, joint, given->name, *value);
  }

  void add_screw(SceneJoint& out, const model::Joint& joint) {
    out.screw_pitch = screw_lead(root_, joint);
    const bool per_turn = joint.screw_thread_pitch.written;
    const Span where = per_turn ? joint.screw_thread_pitch.span : joint.thread_pitch.span;
    say(FactKind::kJointEmulated, or_name(where, joint), joint, "screw", out.screw_pitch);
  }

  bool add_gearbox(SceneJoint& out, const model::Joint& joint) {
    out.gearbox_ratio = joint.gearbox_ratio.value;
    const model::Field<std::string>& written = joint.gearbox_reference;
    Id<model::Link> link;
    if (written.written && joint.model) {
      link = draft_.input.frames.names().find_link(joint.model, written.value);
    }
    if (!link || !known(link)) {
      say(FactKind::kJointIgnored, written.written ? written.span : place(joint), joint,
          "gearbox_reference_body");
      return false;
    }
    out.gearbox_reference = body_of(link);
    say(FactKind::kJointEmulated, place(joint), joint, "gearbox", out.gearbox_ratio);
    return true;
  }

  void add_mimics(Id<model::Joint> id) {
    const model::Joint& joint = root_[id];
    SceneJoint& out = scene_.joints[draft_.joint_of[id.value]];
    for (std::size_t k = 0; k < out.axes.size(); ++k) {
      if (!joint.axes[k].mimic) continue;
      const model::Mimic& mimic = *joint.axes[k].mimic;
      const Id<model::Joint> leader =
          draft_.input.frames.names().find_joint(joint.model, mimic.joint.value);
      const std::uint32_t index = leader ? draft_.joint_of[leader.value] : kWorld;
      const std::uint32_t axis = mimic.axis.value == "axis2" ? 1 : 0;
      const Span where = or_name(mimic.joint.span, joint);
      if (k != 0 || index == kWorld || axis >= scene_.joints[index].axes.size()) {
        say(FactKind::kElementIgnored, where, joint, "mimic");
        continue;
      }
      out.mimics.push_back(
          {index, axis, mimic.multiplier.value, mimic.offset.value, mimic.reference.value});
      say(FactKind::kJointEmulated, where, joint, "mimic", mimic.multiplier.value);
    }
  }

  /// Joints that mimic each other in a cycle follow none. They are dropped together: a cycle that has lost
  /// one of its joints is no cycle any more.
  void drop_mimic_cycles() {
    std::vector<std::uint32_t> cyclic;
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      if (draft_.joint_of[i] != kWorld && leads_itself(draft_.joint_of[i])) cyclic.push_back(i);
    }
    for (const std::uint32_t i : cyclic) {
      scene_.joints[draft_.joint_of[i]].mimics.clear();
      say(FactKind::kElementIgnored, place(root_.joints[i]), root_.joints[i], "mimic");
    }
  }

  /// Only a first axis mimics, so that a second one ends the chain of leaders.
  bool leads_itself(std::uint32_t self) const {
    std::uint32_t at = self;
    for (std::size_t steps = 0; steps < scene_.joints.size(); ++steps) {
      const std::vector<SceneMimic>& mimics = scene_.joints[at].mimics;
      if (mimics.empty() || mimics.front().axis != 0) return false;
      at = mimics.front().joint;
      if (at == self) return true;
    }
    return false;
  }

  std::vector<const model::Parameter*> blocks(const model::Joint& joint,
                                              std::initializer_list<std::string_view> names) const {
    return draft_.blocks.find(root_[joint.model], joint.name.value, names);
  }
  bool in_urdf(const model::Joint& joint) const {
    return joint.model && root_[joint.model].format == model::Format::kUrdf;
  }

  void say(FactKind kind, Span where, const model::Joint& joint, std::string name, double value = 0,
           double limit = 0) {
    draft_.say(kind, where, joint, std::move(name), value, limit);
  }
  static Span place(const model::Joint& joint) {
    return joint.name.written ? joint.name.span : joint.site.name;
  }
  static Span or_name(Span span, const model::Joint& joint) {
    return span.nowhere() ? place(joint) : span;
  }

  SceneDraft& draft_;
  const model::Root& root_;
  Scene& scene_;
};

}  // namespace

void add_joints(SceneDraft& draft) { JointBuilder(draft).build(); }

}  // namespace rigor::simulate
