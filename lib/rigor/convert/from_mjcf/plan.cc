// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/from_mjcf/plan.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include <rigor/convert/sdf/draft.h>
#include <rigor/model/subject.h>
#include <rigor/read/mjcf/mjcf_checks.h>
#include <rigor/read/values.h>

namespace rigor::convert {
namespace {

using model::Id;
using model::JointType;
using model::Pose;
using robot::kNoIndex;

/// m: two anchors that are nearer than this give an axis no direction.
constexpr double kMinAnchorDistance = 1e-6;
/// How far a weld may be from where its bodies are at rest: the digits of a file.
constexpr double kWeldAtRest = 1e-6;

bool is_active(const read::MjcfValues& values) {
  const auto active = values.text("active");
  return !active || read::trimmed(active->text) != "false";
}

read::MjcfValues equality_values(const read::MjcfScope& scope, xml::Element element) {
  const auto id = scope.defaults.find(mjcf_word(element, "class"));
  return scope.defaults.values(element, "equality", id.value_or(read::MjcfDefaults::kMain));
}

bool is_near(const Pose& a, const Pose& b) {
  const Pose d = compose(inverse(a), b);
  const model::Vector3 turn{d.rotation.x, d.rotation.y, d.rotation.z};
  return length(d.translation) < kWeldAtRest && length(turn) < kWeldAtRest;
}

}  // namespace

std::string mjcf_word(xml::Element element, std::string_view attribute) {
  return read::string_field(read::attribute_text(element, attribute)).value;
}

MjcfPlan::MjcfPlan(const FromMjcfSource& from, const FromMjcfOptions& how, MjcfTarget to)
    : source(from),
      options(how),
      target(to),
      scope(from.workspace, from.workspace.open(from.source.path), "", facts) {
  const model::Root& all = root();
  if (all.format != model::Format::kMjcf || all.models.empty()) {
    refusals.push_back({.kind = NoteKind::kNoModel, .where = all.site.name});
    return;
  }
  refuse_missing_files();
  if (all.cut.written) {
    refusals.push_back({.kind = NoteKind::kUnresolved,
                        .where = all.cut.span,
                        .written = all.cut.value + ", and the file is not read to its end"});
    return;
  }
  robot = robot::robot_of(all, source.source.frames, {0}, source.lookups);
  for (const std::string& unknown : robot.unknown) {
    refusals.push_back({.kind = NoteKind::kUnresolved,
                        .where = all.models[0].site.name,
                        .subject = model::subject(all, all.models[0]),
                        .written = unknown});
  }
  if (!refusals.empty()) return;
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    body_index_.try_emplace(robot.bodies[i].name, i);
  }
  for (std::uint32_t i = 0; i < robot.joints.size(); ++i) {
    joint_index_.try_emplace(robot.joints[i].name, i);
  }
  for (std::uint32_t i = 0; i < all.frames.size(); ++i) {
    site_index_.try_emplace(all.frames[i].name.value, i);
  }
  free_joint.resize(robot.bodies.size());
  for (std::uint32_t i = 0; i < all.joints.size(); ++i) {
    if (all.joints[i].type != JointType::kFloating) {
      joint_ids.push_back({i});
      continue;
    }
    const auto child = source.source.frames.ends({i}).child;
    if (child) free_joint[child.value] = Id<model::Joint>{i};
  }
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    if (robot.bodies[i].name == robot::kWorldBody) world = i;
  }
  choose();
  find_locks();
  find_loops();
  settle_balls();
  name_all();
  name_parts();
}

void MjcfPlan::refuse_missing_files() {
  read::MjcfFacts found = facts;
  read::check_mjcf_assets(scope, source.workspace.disk(), found);
  for (const read::MjcfFact& fact : found) {
    const bool model = fact.kind == read::MjcfFactKind::kAssetMissing && fact.detail == "model";
    if (!model && fact.kind != read::MjcfFactKind::kIncludeMissing) continue;
    refusals.push_back(
        {.kind = NoteKind::kUnresolved,
         .where = fact.where,
         .written = fmt::format("{} {} does not exist", model ? "model" : "include", fact.name)});
  }
}

void MjcfPlan::choose() {
  std::vector<std::uint32_t> top(robot.bodies.size(), kNoIndex);
  for (const std::uint32_t i : robot.order) {
    if (i == world) continue;
    const bool starts = !is_carried(i) || parent_of(i) == world;
    top[i] = starts ? i : top[parent_of(i)];
  }
  // A chain begins with links between its joints; the body that was named is at its end.
  std::uint32_t wanted = kNoIndex;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < top.size(); ++i) {
    if (i != world) ++count;
    if (top[i] != kNoIndex && robot.bodies[i].name == options.body) wanted = top[i];
  }
  bool on_world = false;
  std::size_t free = 0;
  chosen.assign(robot.bodies.size(), false);
  for (std::uint32_t i = 0; i < top.size(); ++i) {
    if (i == world || (wanted != kNoIndex && top[i] != wanted)) continue;
    chosen[i] = true;
    if (!is_carried(i)) ++free;
    on_world |= is_carried(i) && parent_of(i) == world;
  }
  is_static = target == MjcfTarget::kSdf && free == 0;
  for (const robot::Joint& joint : robot.joints) {
    is_static &= joint.type == JointType::kFixed || !chosen[joint.child];
  }
  const bool has_shapes = world < root().links.size() &&
                          !(link(world).visuals.empty() && link(world).collisions.empty());
  const bool wants = options.surroundings != SurroundingsPolicy::kDrop && options.body.empty();
  const bool any = count > 0 || (has_shapes && wants);
  if (!any || (!options.body.empty() && wanted == kNoIndex)) {
    refusals.push_back(
        {.kind = NoteKind::kNoModel, .where = root().models[0].site.name, .written = options.body});
  }
  const bool room = target == MjcfTarget::kSdf || on_world || free != 1;
  shows_world = has_shapes && wants && room;
}

void MjcfPlan::find_locks() {
  for (const xml::Element element : scope.tree.in_sections("equality")) {
    if (element.name() != "joint") continue;
    const read::MjcfValues values = equality_values(scope, element);
    if (!is_active(values) || values.string("joint2").written) continue;
    const std::vector<double> c = values.numbers("polycoef");
    for (robot::Joint& joint : robot.joints) {
      if (joint.name != values.string("joint1").value || joint.axes.size() != 1) continue;
      joint.axes[0].lower = joint.axes[0].upper = c.empty() ? 0 : c[0];
      locks.push_back(element);
    }
  }
}

std::optional<std::uint32_t> MjcfPlan::body_named(const std::string& name) const {
  const auto found = body_index_.find(name);
  return found == body_index_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::uint32_t> MjcfPlan::joint_named(const std::string& name) const {
  const auto found = joint_index_.find(name);
  return found == joint_index_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<Pose> MjcfPlan::site_pose(const std::string& name, std::uint32_t& body) const {
  // One with the name of a body or joint has another name in the model.
  auto found = site_index_.find(name);
  if (found == site_index_.end()) found = site_index_.find(name + "_site");
  if (found == site_index_.end()) return std::nullopt;
  const model::Frame& frame = root().frames[found->second];
  const auto carrier = body_named(frame.attached_to.value);
  if (!carrier) return std::nullopt;
  body = *carrier;
  return frame.pose.pose.value;
}

/// The world's is the world.
std::uint32_t MjcfPlan::root_of(std::uint32_t body) const {
  while (body != world && body != kNoIndex && is_carried(body)) body = parent_of(body);
  return body;
}

/// Both anchors of a pair of `connect` on one axis are those of a hinge.
void MjcfPlan::find_loops() {
  const auto pose_of = [this](std::uint32_t body) {
    if (body == world || body >= root().links.size()) return Pose{};
    return source.source.frames.pose(Id<model::Link>{body}).value_or(Pose{});
  };
  for (const xml::Element element : scope.tree.in_sections("equality")) {
    const bool weld = element.name() == "weld";
    if (!weld && element.name() != "connect") continue;
    const read::MjcfValues values = equality_values(scope, element);
    if (!is_active(values)) continue;
    MjcfLoop loop;
    loop.elements.push_back(element);
    loop.name = mjcf_word(element, "name");
    loop.type = weld ? JointType::kFixed : JointType::kBall;
    if (values.string("site1").written) {
      const auto X_P = site_pose(values.string("site1").value, loop.parent);
      const auto X_C = site_pose(values.string("site2").value, loop.child);
      if (!X_P || !X_C) continue;
      loop.X_PJ = *X_P;
      loop.X_CJ = *X_C;
    } else {
      const std::string second = values.string("body2").value;
      const auto parent = body_named(values.string("body1").value);
      const auto child = second.empty() ? std::optional(world) : body_named(second);
      if (!parent || !child) continue;
      loop.parent = *parent;
      loop.child = *child;
      const Pose X_PC = compose(inverse(pose_of(loop.parent)), pose_of(loop.child));
      if (!weld) loop.X_PJ.translation = values.vector("anchor", {}).value;
      const std::vector<double> n = values.numbers("relpose");
      if (weld && n.size() == 7 && (n[3] != 0 || n[4] != 0 || n[5] != 0 || n[6] != 0)) {
        const Pose X{{n[0], n[1], n[2]}, model::normalized({n[3], n[4], n[5], n[6]})};
        if (!is_near(X, X_PC)) continue;  // it pulls the bodies somewhere else
      }
      loop.X_CJ = compose(inverse(X_PC), loop.X_PJ);
    }
    // The child hangs on the tree already, so that this one closes a loop.
    const auto hangs = [this](std::uint32_t body) {
      return body != world && body != kNoIndex && is_carried(body);
    };
    if (!hangs(loop.child)) {
      std::swap(loop.parent, loop.child);
      std::swap(loop.X_PJ, loop.X_CJ);
    }
    const auto is_there = [this](std::uint32_t body) {
      return body == world || body == kNoIndex || chosen[body];
    };
    // Two trees that a constraint connects are no loop.
    if (!hangs(loop.child) || loop.child == loop.parent) continue;
    if (root_of(loop.parent) != root_of(loop.child)) continue;
    if (!is_there(loop.parent) || !is_there(loop.child)) continue;
    MjcfLoop* last = loops.empty() ? nullptr : &loops.back();
    const bool pairs = last != nullptr && !weld && last->type == JointType::kBall &&
                       last->parent == loop.parent && last->child == loop.child;
    const model::Vector3 along =
        pairs ? loop.X_CJ.translation - last->X_CJ.translation : model::Vector3{};
    if (pairs && length(along) > kMinAnchorDistance) {
      last->type = JointType::kRevolute;
      last->axis = rotate(conjugate(last->X_CJ.rotation), 1 / length(along) * along);
      last->elements.push_back(element);
      continue;
    }
    loops.push_back(std::move(loop));
  }
}

std::string MjcfPlan::unique(model::UniqueNames& taken, const std::string& name) const {
  return taken.add(target == MjcfTarget::kSdf ? sdf_name(name) : name);
}

/// SDF has one set of names for links, joints and frames; `world` is no link's.
void MjcfPlan::name_all() {
  taken_links.insert(std::string(robot::kWorldBody));
  if (target == MjcfTarget::kSdf && shows_world) {
    taken_links.insert(std::string(kSurroundings));
    taken_links.insert(std::string(kSurroundings) + "_joint");
  }
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    link_names.push_back(!chosen[i] ? std::string(robot::kWorldBody)
                                    : unique(taken_links, robot.bodies[i].name));
  }
  model::UniqueNames& taken = target == MjcfTarget::kSdf ? taken_links : taken_joints;
  const auto joint_name = [&](const std::string& name) {
    return unique(taken, taken.contains(name) ? name + "_joint" : name);
  };
  for (const robot::Joint& joint : robot.joints) {
    joint_names.push_back(chosen[joint.child] ? joint_name(joint.name) : joint.name);
  }
  for (MjcfLoop& loop : loops) {
    loop.name = joint_name(loop.name.empty() ? "loop" : loop.name);
  }
}

/// The three joints that a ball becomes in URDF have its damping each; a ball of SDF has none.
void MjcfPlan::settle_balls() {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const model::Joint& written = root()[joint_ids[i]];
    if (robot.joints[i].type != JointType::kBall || written.axes.empty()) continue;
    const double damping = target == MjcfTarget::kUrdf ? written.axes[0].damping.value : 0;
    for (robot::Axis& axis : robot.joints[i].axes) axis.damping = damping;
  }
}

/// libsdformat takes no name of a visual for a collision of the same link.
void MjcfPlan::name_parts() {
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    model::UniqueNames taken;
    const auto name = [&](std::vector<robot::Part>& parts, const std::string& kind) {
      for (robot::Part& part : parts) {
        if (part.name.empty()) part.name = kind;
        if (taken.contains(part.name) && part.name != kind) part.name += '_' + kind;
        part.name = unique(taken, part.name);
      }
    };
    name(robot.bodies[i].visuals, "visual");
    if (target == MjcfTarget::kUrdf) taken = model::UniqueNames();
    name(robot.bodies[i].collisions, "collision");
  }
}

robot::Robot expected_robot(const MjcfPlan& plan) {
  robot::Robot robot = plan.robot;
  const bool sdf = plan.target == MjcfTarget::kSdf;
  std::vector<std::uint32_t> at(robot.bodies.size(), kNoIndex);
  std::vector<robot::Body> bodies;
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    if (!plan.chosen[i] || i == plan.world) continue;
    at[i] = static_cast<std::uint32_t>(bodies.size());
    bodies.push_back(robot.bodies[i]);
  }
  robot::Body ground{std::string(robot::kWorldBody)};
  if (plan.world != kNoIndex && plan.shows_world) {
    ground = robot.bodies[plan.world];
    ground.name = sdf ? std::string(kSurroundings) : std::string(robot::kWorldBody);
    ground.mass = {};
  }
  std::vector<robot::Joint> joints;
  bool on_world = false;
  std::size_t free = 0;
  for (const robot::Joint& joint : robot.joints) {
    if (!plan.chosen[joint.child]) continue;
    joints.push_back(joint);
    on_world |= joint.parent == plan.world;
  }
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    free += plan.chosen[i] && !plan.is_carried(i) ? 1 : 0;
  }
  const auto world_at = static_cast<std::uint32_t>(bodies.size() + (sdf && plan.shows_world));
  for (robot::Joint& joint : joints) {
    joint.parent = joint.parent == plan.world ? world_at : at[joint.parent];
    joint.child = at[joint.child];
  }
  const bool floats = !sdf && (on_world || free != 1);
  for (std::uint32_t i = 0; i < robot.bodies.size() && floats; ++i) {
    if (!plan.chosen[i] || plan.is_carried(i)) continue;
    robot::Joint joint;
    joint.name = plan.root()[*plan.free_joint[i]].name.value;
    joint.type = JointType::kFloating;
    joint.parent = world_at;
    joint.child = at[i];
    joint.X_PJ = robot.bodies[i].X_MB;
    joints.push_back(std::move(joint));
  }
  if (plan.is_static) {
    std::erase_if(joints, [&](const robot::Joint& joint) { return joint.parent == world_at; });
    if (plan.shows_world) bodies.push_back(ground);
  } else if (sdf) {
    for (const MjcfLoop& loop : plan.loops) {
      on_world |= loop.parent == plan.world || loop.parent == kNoIndex;
    }
    if (plan.shows_world) {
      bodies.push_back(ground);
      robot::Joint joint;
      joint.name = std::string(kSurroundings) + "_joint";
      joint.type = JointType::kFixed;
      joint.parent = world_at;
      joint.child = world_at - 1;
      joints.push_back(std::move(joint));
      on_world = true;
    }
    if (on_world) bodies.push_back({std::string(robot::kWorldBody)});
  } else if (floats) {
    bodies.push_back(std::move(ground));
  }
  std::vector<robot::Frame> frames;
  for (robot::Frame& frame : robot.frames) {
    if (!sdf || frame.body == plan.world || at[frame.body] == kNoIndex) continue;
    frame.body = at[frame.body];
    frames.push_back(std::move(frame));
  }
  robot.bodies = std::move(bodies);
  robot.joints = std::move(joints);
  robot.frames = std::move(frames);
  robot.order.clear();
  robot::connect(robot);
  return robot;
}

}  // namespace rigor::convert
