// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine/mujoco/model_text.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include <rigor/simulate/engine/engine.h>
#include <rigor/simulate/engine/mujoco/geom_text.h>
#include <rigor/simulate/engine/mujoco/tree.h>
#include <rigor/simulate/engine/mujoco/xml_text.h>
#include <rigor/simulate/run.h>

namespace rigor::simulate {
namespace {

using model::JointType;

/// tinyxml2, which MuJoCo reads with, ends at a hundred levels.
constexpr std::size_t kMaxDepth = 90;

/// s: the time in which errors of joints' limits, loops and mimics die away, in steps: as stiff as MuJoCo allows.
constexpr double kStiffSteps = 2;
constexpr const char* kStiffImpedance = "0.99 0.9999 0.001";
/// Of friction and motors, which have the same everywhere: MuJoCo's largest.
constexpr const char* kMotorImpedance = "0.9999 0.9999 0.001";

/// Friction is so many times as hard as the contact's normal: it creeps less by as much.
constexpr double kFrictionHardness = 10;

/// rad or m: MuJoCo refuses limits that are not apart.
constexpr double kMinRange = 1e-6;

/// Share of the largest moment by which MuJoCo's A + B ≥ C must hold: eigenvalues of a flat body are rounded.
constexpr double kInertiaMargin = 1e-9;

/// Rows and contacts that MuJoCo reserves memory for, which grows with the square of them.
constexpr std::size_t kMaxContacts = 1000;
constexpr std::size_t kContactsOfPair = 8;
constexpr std::size_t kContactsOfGrid = 50;

class MujocoWriter {
 public:
  MujocoWriter(const Scene& scene, const SolverSettings& settings)
      : scene_(scene),
        settings_(settings),
        nodes_(scene_tree(scene)),
        children_(nodes_.size()),
        body_of_node_(nodes_.size(), 0),
        geoms_(scene, settings),
        first_(first_axes(scene)),
        names_(first_.back()) {
    made_.axes.resize(first_.back());
    made_.bodies.assign(scene.bodies.size(), 0);
    made_.free_dofs.assign(scene.bodies.size(), -1);
    made_.free_positions.assign(scene.bodies.size(), -1);
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].parent != kWorld) children_[nodes_[i].parent].push_back(i);
    }
  }

  MujocoModelText write() {
    std::string bodies = geoms_.of(kWorld);
    note_geoms(kWorld);
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].parent == kWorld) bodies += body(i, {}, 1);
    }
    add_gearboxes();
    add_mimics();
    add_welds();
    std::string& xml = made_.xml;
    xml = "<mujoco><compiler angle=\"radian\" inertiafromgeom=\"false\"/>\n" + sizes() + options();
    xml += "<asset>\n" + geoms_.assets() + "</asset>\n";
    xml += "<worldbody>\n" + bodies + "</worldbody>\n";
    xml += "<contact>\n" + geoms_.pairs() + "</contact>\n";
    xml += "<equality>\n" + equalities_ + "</equality>\n</mujoco>\n";
    return std::move(made_);
  }

 private:
  std::string sizes() const {
    const std::size_t contacts = std::min(kMaxContacts, 20 + kContactsOfPair * geoms_.pair_count() +
                                                            kContactsOfGrid * made_.grids.size());
    const std::size_t rows =
        3 * contacts + equality_rows_ + 3 * static_cast<std::size_t>(made_.dof_count) + 10;
    return "<size" + attribute("nconmax", std::to_string(contacts)) +
           attribute("njmax", std::to_string(rows)) + "/>\n";
  }

  std::string options() const {
    return "<option" + attribute("timestep", {settings_.step}) +
           attribute("gravity", scene_.gravity) + attribute("cone", "elliptic") +
           attribute("impratio", {kFrictionHardness}) + attribute("collision", "predefined") +
           ">\n<flag" + attribute("multiccd", "enable") + "/></option>\n";
  }

  /// In the frame of its parent, of which X_WP is the pose.
  std::string body(std::uint32_t index, const Pose& X_WP, std::size_t depth) {
    if (depth > kMaxDepth) {
      throw EngineError("MuJoCo reads chains of up to " + std::to_string(kMaxDepth) +
                        " bodies; ODE takes longer ones");
    }
    const TreeNode& node = nodes_[index];
    const SceneBody& body = scene_.bodies[node.body];
    const int number = made_.body_count++;
    body_of_node_[index] = number;
    if (node.half) {
      made_.halves.push_back(number);
      made_.half_of.push_back(static_cast<int>(node.body));
    } else {
      made_.bodies[node.body] = number;
    }
    std::string text = "<body" + attribute("name", "b" + std::to_string(index)) +
                       pose_attributes(compose(inverse(X_WP), body.X_WB)) + ">\n";
    text += joints(node);
    if (!body.kinematic) text += inertial(body, node.share);
    if (!node.half) {
      text += geoms_.of(node.body);
      note_geoms(node.body);
    }
    for (const std::uint32_t child : children_[index])
      text += this->body(child, body.X_WB, depth + 1);
    return text + "</body>\n";
  }

  void note_geoms(std::uint32_t body) {
    for (const std::uint32_t shape : geoms_.shapes_of(body)) {
      made_.shape_of_geom.push_back(shape);
      if (std::holds_alternative<HeightGrid>(scene_.shapes[shape].kind)) {
        made_.grids.push_back(shape);
      }
    }
  }

  static std::string inertial(const SceneBody& body, double share) {
    mass::Inertia I = body.mass.about_com;
    const auto [a, b, c] = mass::principal_moments(I);
    if (a + b - c < kInertiaMargin * c) {
      for (double* moment : {&I.ixx, &I.iyy, &I.izz}) *moment += kInertiaMargin * c;
    }
    return "<inertial" + attribute("pos", body.mass.com) +
           attribute("mass", {share * body.mass.mass}) +
           attribute("fullinertia", {share * I.ixx, share * I.iyy, share * I.izz, share * I.ixy,
                                     share * I.ixz, share * I.iyz}) +
           "/>\n";
  }

  void take_dofs(std::uint32_t body, int positions, int dofs) {
    made_.position_count += positions;
    made_.dof_count += dofs;
    made_.joint_count += 1;
    made_.body_of_dof.insert(made_.body_of_dof.end(), static_cast<std::size_t>(dofs),
                             static_cast<int>(body));
  }

  std::string joints(const TreeNode& node) {
    if (node.held == TreeNode::Held::kByNothing) return {};
    if (node.held == TreeNode::Held::kFree) {
      made_.free_positions[node.body] = made_.position_count;
      made_.free_dofs[node.body] = made_.dof_count;
      take_dofs(node.body, 7, 6);
      return "<freejoint/>\n";
    }
    const SceneJoint& joint = scene_.joints[node.joint];
    switch (joint.type) {
      case JointType::kRevolute:
      case JointType::kContinuous: return axis(node, 0, "hinge");
      case JointType::kPrismatic: return axis(node, 0, "slide");
      case JointType::kUniversal:
      case JointType::kRevolute2: return universal(node);
      case JointType::kScrew: return screw(node);
      case JointType::kBall:
        take_dofs(node.body, 4, 3);
        return "<joint" + attribute("type", "ball") +
               attribute("pos", transform(inverse(scene_.bodies[node.body].X_WB), joint.anchor_W)) +
               "/>\n";
      default: throw EngineError("a joint of a type that MuJoCo has not: " + joint.name);
    }
  }

  std::string placed(const TreeNode& node, const Vector3& direction_W) const {
    const Pose X_BW = inverse(scene_.bodies[node.body].X_WB);
    const double sign = node.reversed ? -1 : 1;
    return attribute("axis", sign * rotate(X_BW.rotation, direction_W)) +
           attribute("pos", transform(X_BW, scene_.joints[node.joint].anchor_W));
  }

  std::string axis(const TreeNode& node, std::uint32_t number, const char* type) {
    const SceneJoint& joint = scene_.joints[node.joint];
    if (number >= joint.axes.size()) {
      throw EngineError("a joint has another number of axes than its type: " + joint.name);
    }
    const SceneAxis& axis = joint.axes[number];
    const std::size_t index = first_[node.joint] + number;
    names_[index] = "j" + std::to_string(node.joint) + '.' + std::to_string(number);
    made_.axes[index] = {.position = made_.position_count,
                         .dof = made_.dof_count,
                         .start = axis.start,
                         .begin = axis.start};
    take_dofs(node.body, 1, 1);
    std::string text = "<joint" + attribute("name", names_[index]) + attribute("type", type) +
                       placed(node, axis.direction_W) + attribute("ref", {axis.start});
    if (axis.lower > -kInfinity || axis.upper < kInfinity) {
      const double short_of = std::max(0.0, kMinRange - (axis.upper - axis.lower)) / 2;
      text += attribute("limited", "true") +
              attribute("range", {axis.lower - short_of, axis.upper + short_of}) +
              attribute("solreflimit", {kStiffSteps * settings_.step, 1}) +
              attribute("solimplimit", kStiffImpedance);
    }
    if (axis.damping > 0) text += attribute("damping", {axis.damping});
    if (axis.friction > 0) text += attribute("frictionloss", {axis.friction});
    if (axis.spring_stiffness > 0) {
      text += attribute("stiffness", {axis.spring_stiffness}) +
              attribute("springref", {axis.spring_reference});
    }
    return text + attribute("solimpfriction", kMotorImpedance) + "/>\n";
  }

  /// In the order from the body that carries to the one that is carried.
  std::string universal(const TreeNode& node) {
    std::string text = axis(node, node.reversed ? 1 : 0, "hinge");
    text += axis(node, node.reversed ? 0 : 1, "hinge");
    return text;
  }

  /// It slides by its pitch for each radian that it turns.
  std::string screw(const TreeNode& node) {
    const SceneJoint& joint = scene_.joints[node.joint];
    if (joint.axes.empty()) throw EngineError("a screw has no axis: " + joint.name);
    const std::string name = "s" + std::to_string(node.joint);
    take_dofs(node.body, 1, 1);
    std::string text = "<joint" + attribute("name", name) + attribute("type", "slide") +
                       placed(node, joint.axes[0].direction_W) + "/>\n";
    text += axis(node, 0, "hinge");
    add_coupling(name, names_[first_[node.joint]], 0, joint.screw_pitch);
    return text;
  }

  /// follower = c0 + c1 · leader, both counted from where they start.
  void add_coupling(const std::string& follower, const std::string& leader, double c0, double c1) {
    equalities_ += "<joint" + attribute("joint1", follower) + attribute("joint2", leader) +
                   attribute("polycoef", {c0, c1, 0, 0, 0}) + stiff() + "/>\n";
    ++equality_rows_;
  }

  std::string stiff() const {
    return attribute("solref", {kStiffSteps * settings_.step, 1}) +
           attribute("solimp", kStiffImpedance);
  }

  void add_mimics() {
    for (std::uint32_t j = 0; j < scene_.joints.size(); ++j) {
      const SceneJoint& joint = scene_.joints[j];
      const std::size_t count = std::min(joint.mimics.size(), joint.axes.size());
      for (std::size_t i = 0; i < count; ++i) {
        const SceneMimic& mimic = joint.mimics[i];
        const std::size_t follower = first_[j] + i;
        const std::size_t leader = first_.at(mimic.joint) + mimic.axis;
        if (leader == follower || leader >= first_.back()) continue;
        const MujocoAxis& f = made_.axes[follower];
        const MujocoAxis& l = made_.axes[leader];
        if (f.dof < 0 || l.dof < 0 || f.dof == l.dof) continue;
        const double begins =
            mimic.multiplier * (l.start - mimic.reference) + mimic.offset - f.start;
        add_coupling(names_[follower], names_[leader], f.sign * begins,
                     f.sign * mimic.multiplier * l.sign);
      }
    }
  }

  void add_gearboxes() {
    for (std::uint32_t j = 0; j < scene_.joints.size(); ++j) {
      const SceneJoint& joint = scene_.joints[j];
      if (joint.type != JointType::kGearbox || joint.axes.empty()) continue;
      const std::size_t parent = hinge_of(joint, joint.parent);
      const std::size_t child = hinge_of(joint, joint.child);
      const MujocoAxis p = seen_from(joint, joint.parent, joint.axes.front(), parent);
      const MujocoAxis c = seen_from(joint, joint.child, joint.axes.back(), child);
      made_.axes[first_[j]] = p;
      names_[first_[j]] = names_[parent];
      if (joint.axes.size() > 1) {
        made_.axes[first_[j] + 1] = c;
        names_[first_[j] + 1] = names_[child];
      }
      add_coupling(names_[child], names_[parent], 0, -c.sign * p.sign * joint.gearbox_ratio);
    }
  }

  bool connects(const SceneJoint& hinge, std::uint32_t a, std::uint32_t b) const {
    const bool turns = hinge.type == JointType::kRevolute || hinge.type == JointType::kContinuous;
    return turns &&
           ((hinge.parent == a && hinge.child == b) || (hinge.parent == b && hinge.child == a));
  }

  /// The axis that turns a side of a gearbox against its reference.
  std::size_t hinge_of(const SceneJoint& gearbox, std::uint32_t body) const {
    for (std::uint32_t j = 0; j < scene_.joints.size(); ++j) {
      if (connects(scene_.joints[j], body, gearbox.gearbox_reference)) return first_[j];
    }
    throw EngineError("MuJoCo couples hinges, and none connects a side of gearbox '" +
                      gearbox.name + "' to its reference body; ODE takes it");
  }

  MujocoAxis seen_from(const SceneJoint& gearbox, std::uint32_t body, const SceneAxis& axis,
                       std::size_t hinge) const {
    const auto after = std::upper_bound(first_.begin(), first_.end(), hinge);
    const SceneJoint& joint = scene_.joints[static_cast<std::size_t>(after - first_.begin()) - 1];
    MujocoAxis seen = made_.axes[hinge];
    const bool along = dot(joint.axes[0].direction_W, axis.direction_W) > 0;
    seen.sign =
        along == (joint.child == body && joint.parent == gearbox.gearbox_reference) ? 1 : -1;
    seen.start = axis.start;
    return seen;
  }

  void add_weld(const std::string& one, const std::string& other) {
    equalities_ += "<weld" + attribute("body1", one) +
                   (other.empty() ? other : attribute("body2", other)) + stiff() + "/>\n";
    equality_rows_ += 6;
  }

  std::string name_of(std::uint32_t body) const {
    if (body == kWorld) return {};
    const auto is_whole = [&](const TreeNode& node) { return node.body == body && !node.half; };
    const auto node = std::find_if(nodes_.begin(), nodes_.end(), is_whole);
    return "b" + std::to_string(node - nodes_.begin());
  }

  void add_welds() {
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      const TreeNode& node = nodes_[i];
      if (!node.half) continue;
      const SceneJoint& joint = scene_.joints[node.joint];
      const Pose X_BW = inverse(scene_.bodies[node.body].X_WB);
      made_.loops.push_back(
          {node.joint, body_of_node_[i], made_.bodies[node.body], transform(X_BW, joint.anchor_W)});
      add_weld("b" + std::to_string(i), name_of(node.body));
    }
    for (const SceneJoint& joint : scene_.joints) {
      if (joint.type != JointType::kFixed || joint.parent == joint.child) continue;
      const bool swapped = joint.child == kWorld;
      add_weld(name_of(swapped ? joint.parent : joint.child),
               name_of(swapped ? joint.child : joint.parent));
    }
  }

  const Scene& scene_;
  const SolverSettings& settings_;
  std::vector<TreeNode> nodes_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<int> body_of_node_;
  GeomText geoms_;
  std::vector<std::uint32_t> first_;
  std::vector<std::string> names_;  ///< of axes
  std::string equalities_;
  std::size_t equality_rows_ = 0;
  MujocoModelText made_;
};

}  // namespace

MujocoModelText mujoco_model_text(const Scene& scene, const SolverSettings& settings) {
  return MujocoWriter(scene, settings).write();
}

}  // namespace rigor::simulate
