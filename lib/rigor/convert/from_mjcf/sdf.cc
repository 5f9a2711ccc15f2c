// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// MJCF as SDF.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <rigor/convert/from_mjcf/contact.h>
#include <rigor/convert/from_mjcf/sdf_builder.h>
#include <rigor/convert/mjcf/assembly.h>
#include <rigor/convert/number_text.h>
#include <rigor/mass/resolve.h>
#include <rigor/model/subject.h>
#include <rigor/read/mjcf/mjcf_settings.h>
#include <rigor/read/values.h>
#include <rigor/write/numbers.h>

namespace rigor::convert {
namespace {

using model::Id;
using model::JointType;
using model::Pose;
using robot::kNoIndex;

constexpr const char* kEndlessLower = "-1e16";
constexpr const char* kEndlessUpper = "1e16";

SdfElement text_element(const std::string& name, std::string text) {
  return {.name = name, .text = std::move(text)};
}

class MjcfToSdf {
 public:
  MjcfToSdf(const MjcfPlan& plan, Ledger& ledger, FromMjcfConversion& result)
      : plan_(plan),
        root_(plan.root()),
        ledger_(ledger),
        result_(result),
        taken_(plan.taken_links),
        draft_{.source = plan.source.source, .options = plan.options.sdf, .ledger = ledger},
        shaper_(plan, ledger, nullptr, &draft_),
        sensors_(mjcf_to_sdf_sensors(plan, ledger)) {
    draft_.next_to_nothing = massless_link_mass(plan.robot);
  }

  void build() {
    SdfRobot& robot = draft_.robot;
    robot.name = sdf_name(plan_.options.name.empty() ? plan_.robot.name : plan_.options.name);
    robot.version = version();
    if (!links_that_touch_others(plan_).empty())
      robot.settings.push_back(text_element("self_collide", "true"));
    if (plan_.is_static) robot.settings.push_back(text_element("static", "true"));
    for (std::uint32_t i = 0; i < plan_.robot.bodies.size(); ++i) {
      if (i == plan_.world || !plan_.chosen[i]) continue;
      result_.links.emplace(plan_.robot.bodies[i].name, plan_.link_names[i]);
      if (is_frame(i)) {
        add_frame(i);
        continue;
      }
      add_link(i);
      const bool stands = plan_.is_static && plan_.parent_of(i) == plan_.world;
      if (plan_.is_carried(i) && !stands) add_joint(plan_.robot.bodies[i].carrier);
    }
    if (plan_.shows_world) add_surroundings();
    for (const MjcfLoop& loop : plan_.loops) {
      if (!plan_.is_static) add_loop(loop);
    }
    add_sites();
    result_.files = std::move(shaper_).files();
    result_.sdf = std::move(draft_.robot);
  }

 private:
  int version() const {
    if (plan_.options.sdf.version != 0) return plan_.options.sdf.version;
    const auto& joints = plan_.robot.joints;
    const bool mimics = std::any_of(joints.begin(), joints.end(), [](const robot::Joint& joint) {
      return !joint.axes.empty() && joint.axes[0].follow;
    });
    return mimics ? kMimicVersion : kPlainVersion;
  }

  std::string name_of(std::uint32_t body) const {
    return body == plan_.world || body == kNoIndex ? std::string(robot::kWorldBody)
                                                   : plan_.link_names[body];
  }

  JointType carrier_type(std::uint32_t i) const {
    return plan_.robot.joints[plan_.robot.bodies[i].carrier].type;
  }

  /// A body without mass and shapes that is fixed to another one.
  bool is_frame(std::uint32_t i) const {
    const model::Link& link = plan_.link(i);
    if (plan_.robot.bodies[i].mass.mass > 0 || plan_.is_between(i) || !plan_.is_carried(i)) {
      return false;
    }
    return carrier_type(i) == JointType::kFixed && plan_.parent_of(i) != plan_.world &&
           link.visuals.empty() && link.collisions.empty() && !sensors_.of_body.contains(i);
  }

  void note(NoteKind kind, Outcome outcome, Span where, std::string subject, std::string written,
            std::string instead = {}) {
    ledger_.note({.kind = kind,
                  .outcome = outcome,
                  .where = where,
                  .subject = std::move(subject),
                  .written = std::move(written),
                  .instead = std::move(instead)});
  }

  /// In what its body hangs on; of one that hangs on the world, in the model.
  SdfPose placed(std::uint32_t i) const {
    const bool on_body = plan_.is_carried(i) && plan_.parent_of(i) != plan_.world;
    return {on_body ? name_of(plan_.parent_of(i)) : std::string(),
            origin_of(plan_.link(i).pose.pose.value)};
  }

  // --- links ---

  void add_frame(std::uint32_t i) {
    SdfFrame frame{.name = plan_.link_names[i], .attached_to = name_of(plan_.parent_of(i))};
    frame.pose.origin = origin_of(plan_.link(i).pose.pose.value);
    std::uint32_t holder = plan_.parent_of(i);
    while (holder != plan_.world && is_frame(holder)) holder = plan_.parent_of(holder);
    result_.held_by.emplace(plan_.robot.bodies[i].name, plan_.robot.bodies[holder].name);
    note(NoteKind::kFromMjcfMassless, Outcome::kRewritten, plan_.link(i).site.name,
         model::subject(root_, plan_.link(i)), {}, "a frame of link " + name_of(holder));
    draft_.robot.parts.emplace_back(std::move(frame));
  }

  void add_link(std::uint32_t i) {
    SdfLink link{.name = plan_.link_names[i], .pose = placed(i)};
    const mass::MassProperties body =
        mass::resolve(root_, plan_.source.source.frames, {i}, plan_.source.lookups.find_mesh).body;
    if (body.mass > 0) {
      link.inertial = as_written(i).value_or(inertial_of(body));
    } else {
      link.inertial = next_to_nothing(draft_);
      if (body.about_com != mass::Inertia{}) {
        const Number mass = link.inertial->mass;
        link.inertial = inertial_of(body);
        link.inertial->mass = mass;
      }
      note(NoteKind::kFromMjcfMassless, Outcome::kSubstituted, plan_.link(i).site.name,
           model::subject(root_, plan_.link(i)), {},
           "a link of " + to_text(link.inertial->mass) + " kg");
    }
    floats_against_gravity(link, i);
    add_shapes(link, i);
    if (const auto own = sensors_.of_body.find(i); own != sensors_.of_body.end()) {
      link.raw = own->second;
    }
    draft_.robot.parts.emplace_back(std::move(link));
  }

  /// In its own axes, with all digits: turned into those of the link, the moments of a thin rod may be ones that no
  /// body has. Nothing where the compiler changes what is written, and of a URDF-like tensor, which has the link's.
  std::optional<UrdfInertial> as_written(std::uint32_t i) const {
    const model::Inertial& inertial = plan_.link(i).inertial;
    const model::MassSettings& settings = root_.mass_settings;
    const bool changed = settings.balance_inertia || settings.bound_mass > 0 ||
                         settings.bound_inertia > 0 || settings.total_mass > 0;
    if (!inertial.written || changed) return std::nullopt;
    UrdfInertial result = inertial_of(
        {inertial.mass.value, inertial.pose.pose.value.translation, mass::tensor(inertial)});
    result.origin = origin_of(inertial.pose.pose.value);
    return result;
  }

  /// `gravcomp` of 1 lifts the body as hard as gravity pulls it down.
  void floats_against_gravity(SdfLink& link, std::uint32_t i) {
    const xml::Element element = plan_.source.source.documents.element(plan_.link(i).site);
    const auto text = read::attribute_text(element, "gravcomp");
    const auto numbers = text ? read::mjcf_numbers(text->text) : std::nullopt;
    if (!numbers || numbers->size() != 1 || numbers->front() != 1) return;
    ledger_.take_value(text->span);
    link.settings.push_back(text_element("gravity", "false"));
  }

  void add_shapes(SdfLink& link, std::uint32_t i) {
    const robot::Body& body = plan_.robot.bodies[i];
    for (std::size_t k = 0; k < body.visuals.size(); ++k) {
      const model::Visual& visual = root_[plan_.link(i).visuals[k]];
      const std::string subject = model::subject(root_, visual);
      for (MjcfShape& shape : shaper_.shapes(visual.geometry, subject, MjcfUse::kVisual)) {
        SdfShape part = part_of(std::move(shape), visual.pose, body.visuals[k].name);
        tell_renamed(visual.name, body.visuals[k].name, subject);
        if (visual.material.rgba) part.rest.push_back(look(*visual.material.rgba));
        link.visuals.push_back(std::move(part));
      }
    }
    for (std::size_t k = 0; k < body.collisions.size(); ++k) {
      const model::Collision& collision = root_[plan_.link(i).collisions[k]];
      const std::string subject = model::subject(root_, collision);
      for (MjcfShape& shape : shaper_.shapes(collision.geometry, subject, MjcfUse::kCollision)) {
        SdfShape part = part_of(std::move(shape), collision.pose, body.collisions[k].name);
        tell_renamed(collision.name, body.collisions[k].name, subject);
        if (collision.surface.mu.written) part.rest.push_back(surface(collision.surface.mu.value));
        link.collisions.push_back(std::move(part));
      }
    }
  }

  void tell_renamed(const model::Field<std::string>& written, const std::string& name,
                    const std::string& subject) {
    if (written.value.empty() || written.value == name) return;
    note(NoteKind::kRenamed, Outcome::kRewritten, written.span, subject, written.value, name);
  }

  static SdfShape part_of(MjcfShape shape, const model::PoseField& pose, const std::string& name) {
    SdfShape result;
    result.name = name + shape.suffix;
    result.pose.origin = origin_of(compose(pose.pose.value, shape.X_GS));
    result.geometry = std::move(shape.geometry);
    result.other_geometry = std::move(shape.other);
    return result;
  }

  static SdfElement look(const std::array<double, 4>& rgba) {
    std::array<Number, 4> color;
    for (std::size_t i = 0; i < color.size(); ++i) color[i].value = rgba[i];
    SdfElement material{.name = "material"};
    material.set("ambient", number_texts(color));
    material.set("diffuse", number_texts(color));
    return material;
  }

  static SdfElement surface(double mu) {
    SdfElement element{.name = "surface"};
    element.set("friction/ode/mu", to_text({mu, {}}));
    element.set("friction/ode/mu2", to_text({mu, {}}));
    return element;
  }

  void add_surroundings() {
    SdfLink link{.name = std::string(kSurroundings)};
    link.inertial = next_to_nothing(draft_);
    add_shapes(link, plan_.world);
    draft_.robot.parts.emplace_back(std::move(link));
    if (plan_.is_static) return;
    SdfJoint joint{.name = std::string(kSurroundings) + "_joint", .type = "fixed"};
    joint.parent = robot::kWorldBody;
    joint.child = kSurroundings;
    draft_.robot.parts.emplace_back(std::move(joint));
  }

  // --- joints ---

  void add_joint(std::uint32_t index) {
    const robot::Joint& joint = plan_.robot.joints[index];
    const model::Joint& written = root_[plan_.joint_ids[index]];
    SdfJoint result{.name = plan_.joint_names[index]};
    result.parent = name_of(joint.parent);
    result.child = name_of(joint.child);
    result.pose.origin = origin_of(written.pose.pose.value);
    result_.joints.emplace(joint.name, std::vector{result.name});
    // What the file gives no name to, no controller names.
    if (written.name.written && result.name != joint.name)
      note(NoteKind::kFromMjcfRenamed, Outcome::kRewritten, written.name.span,
           model::subject(root_, written), "joint " + joint.name, result.name);
    if (joint.type == JointType::kBall) {
      result.type = "ball";
    } else if (joint.axes.empty() || length(joint.axes[0].direction) == 0) {
      result.type = "fixed";
    } else {
      const bool slides = joint.axes[0].motion == robot::Axis::Motion::kSlide;
      result.type = slides ? "prismatic" : "revolute";
      result.axis = axis_of(joint.axes[0]);
    }
    if (const auto own = sensors_.of_joint.find(index); own != sensors_.of_joint.end()) {
      result.raw = own->second;
    }
    draft_.robot.parts.emplace_back(std::move(result));
  }

  SdfAxis axis_of(const robot::Axis& axis) const {
    SdfAxis result{.xyz = numbers(axis.direction)};
    for (Number& number : result.xyz) number.value = write::settled(number.value, 0, 1);
    SdfElement limit{.name = "limit"};
    const auto bound = [](double value, const char* none) {
      return std::isfinite(value) ? to_text({value, {}}) : std::string(none);
    };
    limit.set("lower", bound(axis.lower, kEndlessLower));
    limit.set("upper", bound(axis.upper, kEndlessUpper));
    if (std::isfinite(axis.effort)) limit.set("effort", to_text({axis.effort, {}}));
    result.rest.push_back(std::move(limit));
    SdfElement dynamics{.name = "dynamics"};
    const auto add = [&dynamics](const char* name, double value) {
      if (value != 0) dynamics.set(name, to_text({value, {}}));
    };
    add("damping", axis.damping);
    add("friction", axis.friction);
    if (axis.spring_stiffness != 0) {
      dynamics.set("spring_reference", to_text({axis.spring_reference, {}}));
      dynamics.set("spring_stiffness", to_text({axis.spring_stiffness, {}}));
    }
    if (!dynamics.children.empty()) result.rest.push_back(std::move(dynamics));
    if (!axis.follow) return result;
    if (const auto leader = plan_.joint_named(axis.follow->joint)) {
      result.mimic = UrdfMimic{
          plan_.joint_names[*leader], {axis.follow->multiplier, {}}, {axis.follow->offset, {}}};
    }
    return result;
  }

  void add_loop(const MjcfLoop& loop) {
    SdfJoint joint{.name = loop.name};
    joint.type = loop.type == JointType::kFixed  ? "fixed"
                 : loop.type == JointType::kBall ? "ball"
                                                 : "revolute";
    joint.parent = name_of(loop.parent);
    joint.child = name_of(loop.child);
    joint.pose.origin = origin_of(loop.X_CJ);
    if (loop.type == JointType::kRevolute) {
      robot::Axis axis;
      axis.direction = loop.axis;
      axis.lower = -robot::kUnlimited;
      axis.upper = axis.effort = robot::kUnlimited;
      joint.axis = axis_of(axis);
    }
    draft_.robot.parts.emplace_back(std::move(joint));
  }

  // --- sites ---

  void add_sites() {
    for (const model::Frame& frame : root_.frames) {
      const auto body = plan_.body_named(frame.attached_to.value);
      if (!body || *body == plan_.world || !plan_.chosen[*body]) continue;
      SdfFrame result{.name = plan_.unique(taken_, frame.name.value),
                      .attached_to = plan_.link_names[*body]};
      result.pose.origin = origin_of(frame.pose.pose.value);
      draft_.robot.parts.emplace_back(std::move(result));
    }
  }

  const MjcfPlan& plan_;
  const model::Root& root_;
  Ledger& ledger_;
  FromMjcfConversion& result_;
  model::UniqueNames taken_;
  SdfDraft draft_;
  MjcfShaper shaper_;
  MjcfSensors sensors_;
};

}  // namespace

FromMjcfConversion mjcf_to_sdf(const FromMjcfSource& source, const FromMjcfOptions& options) {
  return converted_from_mjcf<MjcfToSdf>(MjcfPlan(source, options, MjcfTarget::kSdf));
}

}  // namespace rigor::convert
