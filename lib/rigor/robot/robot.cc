// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A robot from a loaded model. How joints hang together and move is in
// robot_motion.cc.

#include <rigor/robot/robot.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <rigor/mass/resolve.h>
#include <rigor/robot/gearbox.h>
#include <rigor/robot/rest_inertia.h>
#include <rigor/robot/swapped_joints.h>

namespace rigor::robot {
namespace {

using model::Id;
using model::JointType;
using model::Pose;
using model::Vector3;

constexpr double kEndless = std::numeric_limits<double>::infinity();

struct ShapeNumbers {
  Shape operator()(const model::NoShape&) const { return {"none"}; }
  Shape operator()(const model::Box& s) const { return {"box", three(s.size.value)}; }
  Shape operator()(const model::Sphere& s) const { return {"sphere", {s.radius.value}}; }
  Shape operator()(const model::Cylinder& s) const { return round("cylinder", s); }
  Shape operator()(const model::Capsule& s) const { return round("capsule", s); }
  Shape operator()(const model::Cone& s) const { return round("cone", s); }
  Shape operator()(const model::Ellipsoid& s) const { return {"ellipsoid", three(s.radii.value)}; }
  Shape operator()(const model::Plane& s) const { return {"plane", three(s.normal.value)}; }
  Shape operator()(const model::Mesh& s) const {
    Shape shape{"mesh", three(s.scale.value), s.uri.value, path(s.uri), s.submesh.value};
    if (s.center.value) shape.submesh += " (centered)";
    return shape;
  }
  Shape operator()(const model::Heightmap& s) const {
    return {"heightmap", three(s.size.value), s.uri.value, path(s.uri)};
  }
  Shape operator()(const model::Image& s) const { return {"image", {}, s.uri.value, path(s.uri)}; }
  Shape operator()(const model::Polyline& s) const {
    Shape shape{"polyline", {s.height.value}};
    for (const auto& point : s.points) {
      shape.numbers.push_back(point.value.x);
      shape.numbers.push_back(point.value.y);
    }
    return shape;
  }

  static std::vector<double> three(const Vector3& v) { return {v.x, v.y, v.z}; }
  template <class Round>
  static Shape round(const char* kind, const Round& s) {
    return {kind, {s.radius.value, s.length.value}};
  }
  std::string path(const model::Field<std::string>& uri) const {
    if (!lookups.find_file || uri.span.nowhere() || uri.value.empty()) return {};
    return lookups.find_file(uri.value, uri.span.source);
  }

  const Lookups& lookups;
};

/// The two directions in the plane that is normal to `n`.
std::pair<Vector3, Vector3> plane_directions(const Vector3& n) {
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  const Vector3 least = x <= y && x <= z ? Vector3{1, 0, 0}
                        : y <= z         ? Vector3{0, 1, 0}
                                         : Vector3{0, 0, 1};
  const Vector3 across = cross(n, least);
  const double size = length(across);
  const Vector3 v = size > 0 ? 1 / size * across : Vector3{};
  return {cross(v, n), v};
}

Axis free_axis(const Vector3& direction, Axis::Motion motion) {
  Axis axis;
  axis.motion = motion;
  axis.direction = direction;
  axis.lower = -kEndless;
  axis.upper = axis.effort = axis.velocity = kEndless;
  return axis;
}

class RobotBuilder {
 public:
  RobotBuilder(const model::Root& root, const model::Frames& frames, Id<model::Model> top,
               const Lookups& lookups)
      : root_(root), frames_(frames), top_(top), lookups_(lookups) {}

  Robot build() {
    robot_.name = root_[top_].name.value;
    prefix_ = scoped_name(root_, top_).size() + 2;
    const bool urdf = root_[top_].format == model::Format::kUrdf;
    mjcf_ = root_[top_].format == model::Format::kMjcf;
    if (const auto X_WM = frames_.pose(top_)) X_MW_ = inverse(*X_WM);
    if (!urdf && !mjcf_) {
      robot_.X_WM = frames_.pose(top_).value_or(Pose{});
      robot_.is_static = model::is_static(root_, top_);
      if (!frames_.pose(top_)) robot_.unknown.push_back("the model has no pose");
    }
    find_inside();
    add_bodies();
    add_joints();
    if (!urdf && !mjcf_) turn_joints();
    robot::connect(robot_);
    place();
    couple_gears();
    fill();
    tune_springs();
    add_frames();
    return std::move(robot_);
  }

 private:
  /// Nested models come after the one they are in; merged ones are empty.
  void find_inside() {
    inside_.resize(root_.models.size());
    for (std::size_t i = 0; i < root_.models.size(); ++i) {
      const Id<model::Model> parent = root_.models[i].parent;
      inside_[i] = i == top_.value || (parent && parent.value < i && inside_[parent.value]);
    }
  }
  bool inside(Id<model::Model> id) const { return id && inside_[id.value]; }

  template <class T>
  std::string name_of(Id<T> id) const {
    const std::string name = scoped_name(root_, id);
    return name.size() > prefix_ ? name.substr(prefix_) : std::string();
  }

  template <class T>
  Pose pose_of(Id<T> id, const char* kind, const std::string& name) {
    if (const auto X_WT = frames_.pose(id)) {
      return X_MW_ == Pose{} ? *X_WT : compose(X_MW_, *X_WT);
    }
    robot_.unknown.push_back(std::string(kind) + " " + name + " has no pose");
    return {};
  }

  void add_bodies() {
    body_of_.resize(root_.links.size(), kNoIndex);
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      if (!inside(root_.links[i].model)) continue;
      body_of_[i] = static_cast<std::uint32_t>(robot_.bodies.size());
      links_.push_back({i});
      Body body;
      body.name = name_of(Id<model::Link>{i});
      body.span = root_.links[i].site.tag;
      if (mjcf_ && body.name == kWorldBody) world_ = body_of_[i];
      robot_.bodies.push_back(std::move(body));
    }
  }

  /// Gearboxes carry what no other joint does.
  void add_joints() {
    std::vector<Id<model::Joint>> gearboxes;
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      const Id<model::Joint> id{i};
      if (!inside(root_[id].model)) continue;
      // In MuJoCo a free body has a joint; elsewhere it has none.
      if (mjcf_ && root_[id].type == JointType::kFloating) continue;
      if (root_[id].type == JointType::kGearbox) {
        gearboxes.push_back(id);
      } else {
        add_joint(id);
      }
    }
    for (const Id<model::Joint> id : gearboxes) add_joint(id);
  }

  void add_joint(Id<model::Joint> id) {
    const model::Frames::Ends& ends = frames_.ends(id);
    Joint joint;
    joint.name = name_of(id);
    joint.span = root_[id].site.tag;
    joint.child = ends.child ? body_of_[ends.child.value] : kNoIndex;
    joint.parent = ends.parent_is_world ? world()
                   : ends.parent        ? body_of_[ends.parent.value]
                                        : kNoIndex;
    if (joint.parent == kNoIndex || joint.child == kNoIndex || joint.parent == joint.child) {
      robot_.unknown.push_back("joint " + joint.name + " does not connect two links");
      return;
    }
    joint.type = root_[id].type == JointType::kContinuous ? JointType::kRevolute : root_[id].type;
    joints_.push_back(id);
    robot_.joints.push_back(std::move(joint));
  }

  /// A body that joints lead to from two sides hangs on one of them.
  void turn_joints() {
    std::vector<Edge> edges;
    for (const Joint& joint : robot_.joints) {
      edges.push_back({joint.parent, joint.child, can_turn(joint.type)});
    }
    const auto hangs = edge_directions(edges, robot_.bodies.size(), world_);
    turned_.resize(hangs.size());
    for (std::size_t i = 0; i < hangs.size(); ++i) {
      turned_[i] = hangs[i] == Edge::Direction::kTurned;
      if (turned_[i]) std::swap(robot_.joints[i].parent, robot_.joints[i].child);
    }
  }

  std::uint32_t world() {
    if (world_ == kNoIndex) {
      world_ = static_cast<std::uint32_t>(robot_.bodies.size());
      robot_.bodies.push_back({kWorldBody});
    }
    return world_;
  }

  /// Bodies first, since joints are placed in them.
  void place() {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      Body& body = robot_.bodies[i];
      X_ML_.push_back(pose_of(links_[i], "link", body.name));
      body.X_MB = body.carrier == kNoIndex
                      ? X_ML_[i]
                      : pose_of(joints_[body.carrier], "joint", robot_.joints[body.carrier].name);
    }
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      Joint& joint = robot_.joints[i];
      const Pose& X_MC = robot_.bodies[joint.child].X_MB;
      const Pose X_MJ = joint.closes_loop ? pose_of(joints_[i], "joint", joint.name) : X_MC;
      joint.X_PJ = in_parent(joints_[i], joint, X_MJ);
      joint.X_CJ = joint.closes_loop ? compose(inverse(X_MC), X_MJ) : Pose{};
      add_axes(joint, joints_[i]);
      if (i < turned_.size() && turned_[i]) {
        for (Axis& axis : joint.axes) axis.direction = -1 * axis.direction;
      }
    }
  }

  /// URDF writes it; what is written needs no arithmetic.
  Pose in_parent(Id<model::Joint> id, const Joint& joint, const Pose& X_MJ) const {
    const Body& parent = robot_.bodies[joint.parent];
    const bool urdf = root_[id].model && root_[root_[id].model].format == model::Format::kUrdf;
    if (urdf && joint.parent < X_ML_.size() && X_ML_[joint.parent] == parent.X_MB &&
        root_[id].pose.relative_to.value.empty()) {
      return root_[id].pose.pose.value;
    }
    return parent.X_MB == Pose{} ? X_MJ : compose(inverse(parent.X_MB), X_MJ);
  }

  void fill() {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      Body& body = robot_.bodies[i];
      const model::Link& link = root_[links_[i]];
      const bool same = X_ML_[i] == body.X_MB;
      const Pose X_BL = same ? Pose{} : compose(inverse(body.X_MB), X_ML_[i]);
      body.mass = mass::resolve(root_, frames_, links_[i], lookups_.find_mesh).body;
      if (!same) body.mass = mass::transformed(X_BL, body.mass);
      for (const auto id : link.collisions) {
        body.collisions.push_back(part(id, "collision", body.name, X_BL, X_ML_[i]));
      }
      for (const auto id : link.visuals) {
        body.visuals.push_back(part(id, "visual", body.name, X_BL, X_ML_[i]));
        Part& visual = body.visuals.back();
        if (lookups_.color_of) visual.color = lookups_.color_of(id);
        visual.has_material = root_[id].material.written || visual.color.has_value();
      }
    }
  }

  void couple_gears() {
    for (const GearCoupling& gear : gear_couplings(root_, frames_)) {
      const auto at = std::find(joints_.begin(), joints_.end(), gear.follower);
      if (at == joints_.end()) continue;
      Joint& follower = robot_.joints[static_cast<std::size_t>(at - joints_.begin())];
      follower.axes[0].follow = Mimic{name_of(gear.leader), 0, gear.multiplier, 0};
    }
  }

  /// What MuJoCo makes of `springdamper`: a spring and a damper of this time constant, T, and ratio, ζ, on the inertia I
  /// that the joint has at rest: I/(T ζ)² and 2 I/T.
  void tune_springs() {
    std::vector<std::uint32_t> tuned;
    std::vector<double> armature;
    for (std::uint32_t j = 0; j < joints_.size(); ++j) {
      const auto& axes = root_[joints_[j]].axes;
      armature.push_back(axes.empty() ? 0 : axes.front().armature.value);
      if (!axes.empty() && axes.front().spring_damper) tuned.push_back(j);
    }
    if (tuned.empty()) return;
    const AxisValues inverse = inverse_inertias(robot_, armature);
    for (const std::uint32_t j : tuned) {
      const double sum = std::accumulate(inverse[j].begin(), inverse[j].end(), 0.0);
      if (!(sum > 0)) continue;
      const double inertia = static_cast<double>(inverse[j].size()) / sum;
      const auto [time, ratio] = *root_[joints_[j]].axes.front().spring_damper;
      for (Axis& axis : robot_.joints[j].axes) {
        axis.spring_stiffness = inertia / (time * time * ratio * ratio);
        axis.damping = 2 * inertia / time;
      }
    }
  }

  template <class T>
  Part part(Id<T> id, const char* kind, const std::string& link, const Pose& X_BL,
            const Pose& X_ML) {
    const T& written = root_[id];
    Part part;
    part.name = written.name.value;
    part.span = written.site.tag;
    const Pose X_LS = written.pose.relative_to.value.empty()
                          ? written.pose.pose.value
                          : compose(inverse(X_ML), pose_of(id, kind, link + "/" + part.name));
    part.X_BS = X_BL == Pose{} ? X_LS : compose(X_BL, X_LS);
    part.shape = std::visit(ShapeNumbers{lookups_}, written.geometry.shape);
    return part;
  }

  void add_axes(Joint& joint, Id<model::Joint> id) {
    const model::Joint& written = root_[id];
    switch (joint.type) {
      case JointType::kFixed:
      case JointType::kFloating: return;
      case JointType::kBall:
        for (const Vector3& d : {Vector3{0, 0, 1}, Vector3{0, 1, 0}, Vector3{1, 0, 0}}) {
          joint.axes.push_back(free_axis(d, Axis::Motion::kTurn));
        }
        return;
      case JointType::kPlanar: joint.axes = planar_axes(direction(id, 0)); return;
      default: break;
    }
    const bool two = joint.type == JointType::kUniversal || joint.type == JointType::kRevolute2;
    for (std::size_t k = 0; k < written.axes.size() && k < (two ? 2U : 1U); ++k) {
      joint.axes.push_back(axis(id, k));
    }
  }

  Axis axis(Id<model::Joint> id, std::size_t k) const {
    const model::Joint& joint = root_[id];
    const model::Axis& written = joint.axes[k];
    Axis axis;
    axis.direction = direction(id, k);
    axis.span = written.site.tag;
    axis.limit_span = written.limit_site.span;
    if (joint.type == JointType::kPrismatic) axis.motion = Axis::Motion::kSlide;
    if (joint.type == JointType::kScrew) {
      axis.motion = Axis::Motion::kScrew;
      axis.slide = screw_lead(root_, joint);
    }
    const bool endless = joint.type == JointType::kContinuous;
    axis.lower = endless ? -kEndless : without_sentinel(written.lower.value);
    axis.upper = endless ? kEndless : without_sentinel(written.upper.value);
    axis.effort = effort_limit(root_, joint, written);
    axis.velocity = velocity_limit(root_, joint, written);
    axis.damping = written.damping.value;
    axis.friction = written.friction.value;
    axis.spring_reference = written.spring_reference.value;
    axis.spring_stiffness = written.spring_stiffness.value;
    if (lookups_.spring && root_[joint.model].format == model::Format::kUrdf) {
      const auto [reference, stiffness] = lookups_.spring(id);
      axis.spring_reference = reference;
      axis.spring_stiffness = stiffness;
    }
    if (written.mimic) axis.follow = follow(joint, *written.mimic);
    return axis;
  }

  /// SDF: follower = multiplier · (leader - reference) + offset.
  Mimic follow(const model::Joint& joint, const model::Mimic& mimic) const {
    Mimic follow;
    const Id<model::Joint> leader = frames_.names().find_joint(joint.model, mimic.joint.value);
    follow.joint = leader ? name_of(leader) : mimic.joint.value;
    follow.axis = mimic.axis.value == "axis2" ? 1 : 0;
    follow.multiplier = mimic.multiplier.value;
    follow.offset = mimic.offset.value - mimic.multiplier.value * mimic.reference.value;
    return follow;
  }

  /// Unit vector in the joint frame.
  Vector3 direction(Id<model::Joint> id, std::size_t k) const {
    const model::Joint& joint = root_[id];
    if (k >= joint.axes.size()) return {};
    if (joint.axes[k].expressed_in.value.empty()) {
      const Vector3& xyz = joint.axes[k].xyz.value;
      const double size = length(xyz);
      return size > 0 ? 1 / size * xyz : Vector3{};
    }
    const auto axis_W = frames_.axis(id, k);
    const auto X_WJ = frames_.pose(id);
    return axis_W && X_WJ ? rotate(conjugate(X_WJ->rotation), *axis_W) : Vector3{};
  }

  void add_frames() {
    for (std::uint32_t i = 0; i < root_.frames.size(); ++i) {
      const Id<model::Frame> id{i};
      if (!inside(root_[id].model)) continue;
      const Id<model::Link> carrier = frames_.carrier(id);
      const std::uint32_t body = carrier ? body_of_[carrier.value] : world_;
      if (body == kNoIndex) continue;
      const std::string name = name_of(id);
      const Pose X_MF = pose_of(id, "frame", name);
      const Pose& X_MB = robot_.bodies[body].X_MB;
      robot_.frames.push_back({name, body, compose(inverse(X_MB), X_MF), root_[id].site.tag});
    }
  }

  const model::Root& root_;
  const model::Frames& frames_;
  Id<model::Model> top_;
  const Lookups& lookups_;
  Robot robot_;
  std::size_t prefix_ = 0;
  Pose X_MW_;
  std::vector<bool> inside_;
  std::vector<Id<model::Link>> links_;    // of each body but the world
  std::vector<Id<model::Joint>> joints_;  // of each joint of the robot
  std::vector<bool> turned_;              // of each joint, whether parent and child changed places
  std::vector<std::uint32_t> body_of_;    // of each link of the root
  std::vector<Pose> X_ML_;                // of each body but the world
  std::uint32_t world_ = kNoIndex;
  bool mjcf_ = false;
};

}  // namespace

double without_sentinel(double limit) { return model::position_limit(limit); }

double ceiling(double value) { return model::magnitude_limit(value); }

std::vector<Axis> planar_axes(const Vector3& normal) {
  const auto [u, v] = plane_directions(normal);
  return {free_axis(u, Axis::Motion::kSlide), free_axis(v, Axis::Motion::kSlide),
          free_axis(normal, Axis::Motion::kTurn)};
}

Robot robot_of(const model::Root& root, const model::Frames& frames, Id<model::Model> model,
               const Lookups& lookups) {
  return RobotBuilder(root, frames, model, lookups).build();
}

}  // namespace rigor::robot
