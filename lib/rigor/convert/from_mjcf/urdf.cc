// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// MJCF as URDF. A link's frame is that of the joint that carries it.

#include <array>
#include <cmath>
#include <utility>

#include <rigor/convert/from_mjcf/contact.h>
#include <rigor/convert/from_mjcf/shape.h>
#include <rigor/convert/number_text.h>
#include <rigor/convert/urdf/joint/between.h>
#include <rigor/convert/xml_writer.h>
#include <rigor/model/subject.h>
#include <rigor/write/numbers.h>

namespace rigor::convert {
namespace {

using model::Id;
using model::JointType;
using model::Pose;
using robot::kNoIndex;

class MjcfToUrdf {
 public:
  MjcfToUrdf(const MjcfPlan& plan, Ledger& ledger, FromMjcfConversion& result)
      : plan_(plan),
        ledger_(ledger),
        result_(result),
        draft_{.source = plan.source.source, .options = plan.options.urdf, .ledger = ledger},
        shaper_(plan, ledger, &draft_, nullptr),
        link_names_(plan.taken_links),
        joint_names_(plan.taken_joints) {}

  void build() {
    UrdfRobot& robot = draft_.robot;
    robot.name = plan_.options.name.empty() ? plan_.robot.name : plan_.options.name;
    if (plan_.options.urdf.urdf_version > 0) {
      robot.version = "1." + std::to_string(plan_.options.urdf.urdf_version);
    }
    choose_root();
    if (needs_world_) {
      UrdfLink world{.name = robot::kWorldBody};
      if (plan_.shows_world) add_shapes(world, plan_.world);
      robot.links.push_back(std::move(world));
    }
    for (std::uint32_t i = 0; i < plan_.robot.bodies.size(); ++i) {
      if (!plan_.chosen[i]) continue;
      add_link(i);
      if (plan_.is_carried(i)) {
        add_joint(plan_.robot.bodies[i].carrier);
      } else {
        add_free(i);
      }
    }
    add_self_collisions();
    find_rows();
    weigh_links_between(draft_, {0});
    tell_massless();
    result_.files = std::move(shaper_).files();
    for (SideFile& file : draft_.files) result_.files.push_back(std::move(file));
    result_.urdf = std::move(draft_.robot);
  }

 private:
  void choose_root() {
    std::size_t free = 0;
    for (std::uint32_t i = 0; i < plan_.robot.bodies.size(); ++i) {
      if (!plan_.chosen[i]) continue;
      if (!plan_.is_carried(i)) {
        ++free;
      } else {
        needs_world_ |= plan_.parent_of(i) == plan_.world;
      }
    }
    needs_world_ |= free != 1;
  }

  std::string name_of(std::uint32_t body) const {
    return body == plan_.world ? std::string(robot::kWorldBody) : plan_.link_names[body];
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

  // --- links ---

  void add_link(std::uint32_t i) {
    const robot::Body& body = plan_.robot.bodies[i];
    draft_.link_names[Id<model::Link>{i}] = name_of(i);
    result_.links.emplace(body.name, name_of(i));
    UrdfLink link{.name = name_of(i)};
    if (body.mass != mass::MassProperties{}) link.inertial = inertial_of(body.mass);
    add_shapes(link, i);
    draft_.robot.links.push_back(std::move(link));
  }

  void add_shapes(UrdfLink& result, std::uint32_t i) {
    const model::Link& link = plan_.link(i);
    const robot::Body& body = plan_.robot.bodies[i];
    const model::Root& root = plan_.root();
    for (std::size_t k = 0; k < link.visuals.size(); ++k) {
      const model::Visual& visual = root[link.visuals[k]];
      for (MjcfShape& shape :
           shaper_.shapes(visual.geometry, model::subject(root, visual), MjcfUse::kVisual)) {
        UrdfVisual part{.name = body.visuals[k].name + shape.suffix,
                        .origin = origin_of(compose(body.visuals[k].X_BS, shape.X_GS)),
                        .geometry = std::move(shape.geometry)};
        if (visual.material.rgba) part.material = color_named(*visual.material.rgba);
        result.visuals.push_back(std::move(part));
      }
    }
    for (std::size_t k = 0; k < link.collisions.size(); ++k) {
      const model::Collision& collision = root[link.collisions[k]];
      for (MjcfShape& shape : shaper_.shapes(collision.geometry, model::subject(root, collision),
                                             MjcfUse::kCollision)) {
        result.collisions.push_back(
            {.name = body.collisions[k].name + shape.suffix,
             .origin = origin_of(compose(body.collisions[k].X_BS, shape.X_GS)),
             .geometry = std::move(shape.geometry)});
      }
    }
  }

  std::string color_named(const std::array<double, 4>& rgba) {
    std::string& name = draft_.material_names[rgba];
    if (!name.empty()) return name;
    name = "color_" + std::to_string(draft_.material_names.size());
    std::array<Number, 4> numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i].value = rgba[i];
    draft_.robot.materials.push_back({name, numbers, {}});
    return name;
  }

  // --- joints ---

  UrdfJoint joint_of(std::uint32_t index) const {
    const robot::Joint& joint = plan_.robot.joints[index];
    UrdfJoint result{.name = plan_.joint_names[index]};
    result.parent = name_of(joint.parent);
    result.child = name_of(joint.child);
    result.origin = origin_of(joint.X_PJ);
    return result;
  }

  void add_joint(std::uint32_t index) {
    const robot::Joint& joint = plan_.robot.joints[index];
    UrdfJoint result = joint_of(index);
    std::vector<std::string> names{result.name};
    if (joint.type == JointType::kBall) {
      names = add_ball(index, std::move(result));
    } else if (joint.axes.empty() || length(joint.axes[0].direction) == 0) {
      result.type = "fixed";
      draft_.robot.joints.push_back(std::move(result));
    } else {
      set_axis(index, result);
      draft_.robot.joints.push_back(std::move(result));
    }
    result_.joints.emplace(joint.name, std::move(names));
  }

  /// A single free body is the root; of several each has a joint.
  void add_free(std::uint32_t i) {
    const model::Joint& joint = plan_.root()[*plan_.free_joint[i]];
    const robot::Body& body = plan_.robot.bodies[i];
    if (!needs_world_) {
      const UrdfOrigin origin = origin_of(body.X_MB);
      if (is_identity(origin)) return;
      note(NoteKind::kFromMjcfRoot, Outcome::kLost, plan_.link(i).site.name,
           model::subject(plan_.root(), plan_.link(i)),
           number_texts(origin.xyz) + ' ' + number_texts(origin.rpy));
      return;
    }
    UrdfJoint result{.name = plan_.unique(joint_names_, joint.name.value)};
    result.type = "floating";
    result.parent = robot::kWorldBody;
    result.child = name_of(i);
    result.origin = origin_of(body.X_MB);
    result_.joints.emplace(joint.name.value, std::vector{result.name});
    note(NoteKind::kFromMjcfFree, Outcome::kRewritten, joint.site.name,
         model::subject(plan_.root(), joint), "free", "a floating joint");
    draft_.robot.joints.push_back(std::move(result));
  }

  /// About z, y and x, with links between: the same motion but for its singularities.
  std::vector<std::string> add_ball(std::uint32_t index, UrdfJoint first) {
    const model::Joint& written = plan_.root()[plan_.joint_ids[index]];
    const std::string base = first.name;
    const std::string child = first.child;
    constexpr std::array<std::array<double, 3>, 3> kAxes{{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}};
    constexpr std::array<const char*, 3> kSuffixes{"_z", "_y", "_x"};
    std::vector<std::string> names;
    UrdfDraft::Row row;
    std::string parent = first.parent;
    for (std::size_t k = 0; k < kAxes.size(); ++k) {
      UrdfJoint joint{.name = plan_.unique(joint_names_, base + kSuffixes[k])};
      joint.type = "continuous";
      joint.parent = parent;
      joint.origin = k == 0 ? first.origin : UrdfOrigin{};
      joint.axis = numbers({kAxes[k][0], kAxes[k][1], kAxes[k][2]});
      const double damping = written.axes.empty() ? 0 : written.axes[0].damping.value;
      if (damping != 0) joint.damping = Number{damping, {}};
      joint.child = k + 1 < kAxes.size() ? plan_.unique(link_names_, joint.name + "_link") : child;
      if (k + 1 < kAxes.size()) {
        row.links.push_back(draft_.robot.links.size());
        draft_.robot.links.push_back({.name = joint.child});
      }
      parent = joint.child;
      names.push_back(joint.name);
      draft_.robot.joints.push_back(std::move(joint));
    }
    row.carried = Id<model::Link>{plan_.robot.joints[index].child};
    draft_.rows.push_back(std::move(row));
    ledger_.take(written.type_name, Outcome::kSubstituted);
    note(NoteKind::kJointType, Outcome::kSubstituted, written.site.name,
         model::subject(plan_.root(), written), "ball",
         "continuous joints about z, y and x, with links between");
    return names;
  }

  Number stand_in(std::uint32_t index, double value, NoteKind kind) {
    if (std::isfinite(value)) return {value, {}};
    const model::Joint& joint = plan_.root()[plan_.joint_ids[index]];
    const Number number{plan_.options.urdf.unlimited, {}};
    note(kind, Outcome::kSubstituted, joint.site.name, model::subject(plan_.root(), joint),
         "not written", to_text(number));
    return number;
  }

  void set_axis(std::uint32_t index, UrdfJoint& result) {
    const robot::Joint& joint = plan_.robot.joints[index];
    const robot::Axis& axis = joint.axes[0];
    const bool slides = axis.motion == robot::Axis::Motion::kSlide;
    const bool endless = std::isinf(axis.lower) && std::isinf(axis.upper);
    result.type = slides ? "prismatic" : endless ? "continuous" : "revolute";
    result.axis = numbers(axis.direction);
    for (Number& number : *result.axis) number.value = write::settled(number.value, 0, 1);
    if (result.type != "continuous" || std::isfinite(axis.effort)) {
      UrdfLimit limit;
      if (result.type != "continuous") {
        limit.lower = std::isfinite(axis.lower) ? Number{axis.lower, {}} : endless_limit(-1);
        limit.upper = std::isfinite(axis.upper) ? Number{axis.upper, {}} : endless_limit(1);
      }
      limit.effort = stand_in(index, axis.effort, NoteKind::kEffortStandIn);
      limit.velocity = stand_in(index, axis.velocity, NoteKind::kVelocityStandIn);
      result.limit = limit;
    }
    if (axis.damping != 0) result.damping = Number{axis.damping, {}};
    if (axis.friction != 0) result.friction = Number{axis.friction, {}};
    if (axis.follow) {
      for (std::size_t i = 0; i < plan_.robot.joints.size(); ++i) {
        if (plan_.robot.joints[i].name != axis.follow->joint) continue;
        result.mimic = UrdfMimic{
            plan_.joint_names[i], {axis.follow->multiplier, {}}, {axis.follow->offset, {}}};
      }
    }
    add_spring(result.name, axis);
  }

  Number endless_limit(double sign) const { return {sign * plan_.options.urdf.unlimited, {}}; }

  /// Where Gazebo reads it.
  void add_spring(const std::string& joint, const robot::Axis& axis) {
    if (axis.spring_stiffness == 0) return;
    XmlWriter block;
    block.text("springReference", to_text({axis.spring_reference, {}}));
    block.text("springStiffness", to_text({axis.spring_stiffness, {}}));
    draft_.robot.blocks.push_back({joint, std::move(block).take()});
  }

  /// Where Gazebo reads them: links without it touch no other of the model.
  void add_self_collisions() {
    for (const std::uint32_t i : links_that_touch_others(plan_)) {
      XmlWriter block;
      block.text("selfCollide", "true");
      draft_.robot.blocks.push_back({name_of(i), std::move(block).take()});
    }
  }

  // --- links between joints ---

  void find_rows() {
    for (std::uint32_t i = 0; i < plan_.robot.bodies.size(); ++i) {
      const bool ends = plan_.chosen[i] && !plan_.is_between(i) && plan_.is_carried(i);
      if (!ends || !plan_.is_between(plan_.parent_of(i))) continue;
      UrdfDraft::Row row;
      for (std::uint32_t k = plan_.parent_of(i); plan_.is_between(k); k = plan_.parent_of(k)) {
        row.links.push_back(index_of(name_of(k)));
      }
      row.carried = Id<model::Link>{i};
      draft_.rows.push_back(std::move(row));
    }
  }

  std::size_t index_of(const std::string& name) const {
    std::size_t i = 0;
    while (draft_.robot.links[i].name != name) ++i;
    return i;
  }

  /// Links between joints whose mass is taken from what they carry; others that move stay as they are.
  void tell_massless() {
    for (const UrdfDraft::Row& row : draft_.rows) {
      for (const std::size_t link : row.links) {
        if (draft_.robot.links[link].inertial) {
          result_.between.push_back(draft_.robot.links[link].name);
        }
      }
    }
    for (std::uint32_t i = 0; i < plan_.robot.bodies.size(); ++i) {
      if (!plan_.chosen[i] || !plan_.is_carried(i)) continue;
      const bool moves =
          plan_.robot.joints[plan_.robot.bodies[i].carrier].type != JointType::kFixed;
      const UrdfLink& link = draft_.robot.links[index_of(name_of(i))];
      if (!moves || link.inertial) continue;
      note(NoteKind::kFromMjcfMassless, Outcome::kConverted, plan_.link(i).site.name,
           model::subject(plan_.root(), plan_.link(i)), {}, "a link without an inertial");
    }
  }

  const MjcfPlan& plan_;
  Ledger& ledger_;
  FromMjcfConversion& result_;
  UrdfDraft draft_;
  MjcfShaper shaper_;
  bool needs_world_ = false;
  model::UniqueNames link_names_, joint_names_;
};

}  // namespace

FromMjcfConversion mjcf_to_urdf(const FromMjcfSource& source, const FromMjcfOptions& options) {
  return converted_from_mjcf<MjcfToUrdf>(MjcfPlan(source, options, MjcfTarget::kUrdf));
}

}  // namespace rigor::convert
