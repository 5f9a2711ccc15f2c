// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// MJCF files as MuJoCo compiles them and as rigor reads them: bodies, joints, shapes, masses, and where all of them
// are at twenty positions. Built where MuJoCo is installed. RIGOR_MUJOCO_DUMP may name what mujoco_dump.mjs wrote
// of a newer one.

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <rigor/mass/mesh/survey.h>
#include <rigor/mass/resolve.h>
#include <rigor/read/load.h>
#include <rigor/robot/robot.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/mesh_finder.h>
#include <rigor/rules/validate.h>

namespace rigor::judge {
namespace {

using model::Pose;
using model::Vector3;
using Numbers = std::vector<double>;

/// Of a model as MuJoCo compiled it; arrays as in mjModel and mjData.
struct Compiled {
  std::string file, error;
  std::vector<std::string> bodies, joints;
  std::vector<int> joint_type, geom_type, geom_body, joint_position;
  Numbers mass, ipos, iquat, inertia, range, stiffness, damping, friction, size;
  std::vector<Numbers> qpos, xpos, xquat, gpos, gmat;
};

Numbers list(const mjtNum* first, int count) { return {first, first + count}; }
std::vector<int> list(const int* first, int count) { return {first, first + count}; }

Compiled compiled_by_library(const std::string& file) {
  Compiled c;
  c.file = file;
  std::array<char, 1000> error{};
  mjModel* m = mj_loadXML(file.c_str(), nullptr, error.data(), error.size());
  if (m == nullptr) {
    c.error = error.data();
    return c;
  }
  mjData* d = mj_makeData(m);
  for (int i = 0; i < m->nbody; ++i) c.bodies.emplace_back(m->names + m->name_bodyadr[i]);
  for (int i = 0; i < m->njnt; ++i) {
    c.joints.emplace_back(m->names + m->name_jntadr[i]);
    c.damping.push_back(m->dof_damping[m->jnt_dofadr[i]]);
    c.friction.push_back(m->dof_frictionloss[m->jnt_dofadr[i]]);
  }
  c.joint_type = list(m->jnt_type, m->njnt);
  c.joint_position = list(m->jnt_qposadr, m->njnt);
  c.geom_type = list(m->geom_type, m->ngeom);
  c.geom_body = list(m->geom_bodyid, m->ngeom);
  c.mass = list(m->body_mass, m->nbody);
  c.ipos = list(m->body_ipos, 3 * m->nbody);
  c.iquat = list(m->body_iquat, 4 * m->nbody);
  c.inertia = list(m->body_inertia, 3 * m->nbody);
  c.range = list(m->jnt_range, 2 * m->njnt);
  c.stiffness = list(m->jnt_stiffness, m->njnt);
  c.size = list(m->geom_size, 3 * m->ngeom);
  std::mt19937 generator(20261124);
  std::uniform_real_distribution<double> position(-1, 1);
  for (int k = 0; k < 20; ++k) {
    mj_resetData(m, d);
    for (int j = 0; k > 0 && j < m->njnt; ++j) {
      if (m->jnt_type[j] >= mjJNT_SLIDE) d->qpos[m->jnt_qposadr[j]] = position(generator);
    }
    mj_kinematics(m, d);
    c.qpos.push_back(list(d->qpos, m->nq));
    c.xpos.push_back(list(d->xpos, 3 * m->nbody));
    c.xquat.push_back(list(d->xquat, 4 * m->nbody));
    c.gpos.push_back(list(d->geom_xpos, 3 * m->ngeom));
    c.gmat.push_back(list(d->geom_xmat, 9 * m->ngeom));
  }
  mj_deleteData(d);
  mj_deleteModel(m);
  return c;
}

Compiled compiled_from(const nlohmann::json& line) {
  Compiled c;
  c.file = line["file"];
  if (line.contains("error")) {
    c.error = line["error"];
    return c;
  }
  const auto& body = line["body"];
  const auto& joint = line["joint"];
  c.bodies = body["name"];
  c.joints = joint["name"];
  c.joint_type = joint["type"].get<std::vector<int>>();
  c.joint_position = joint["qadr"].get<std::vector<int>>();
  c.geom_type = line["geom"]["type"].get<std::vector<int>>();
  c.geom_body = line["geom"]["body"].get<std::vector<int>>();
  c.mass = body["mass"].get<Numbers>();
  c.ipos = body["ipos"].get<Numbers>();
  c.iquat = body["iquat"].get<Numbers>();
  c.inertia = body["inertia"].get<Numbers>();
  c.range = joint["range"].get<Numbers>();
  c.stiffness = joint["stiffness"].get<Numbers>();
  c.size = line["geom"]["size"].get<Numbers>();
  for (const int dof : joint["dof"]) {
    c.damping.push_back(line["dof"]["damping"][static_cast<std::size_t>(dof)]);
    c.friction.push_back(line["dof"]["frictionloss"][static_cast<std::size_t>(dof)]);
  }
  c.qpos = line["qpos"].get<std::vector<Numbers>>();
  c.xpos = line["xpos"].get<std::vector<Numbers>>();
  c.xquat = line["xquat"].get<std::vector<Numbers>>();
  c.gpos = line["gpos"].get<std::vector<Numbers>>();
  c.gmat = line["gmat"].get<std::vector<Numbers>>();
  return c;
}

Vector3 vector_at(const Numbers& numbers, std::size_t i) {
  return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}
model::Quaternion quaternion_at(const Numbers& n, std::size_t i) {
  return {n[4 * i], n[4 * i + 1], n[4 * i + 2], n[4 * i + 3]};
}

/// MuJoCo keeps meshes in single precision.
constexpr double kOfMeshes = 2e-5;
constexpr double kExact = 1e-9;
/// Its tensors are diagonalized by iteration, to this share.
constexpr double kOfTensors = 1e-7;

class Comparison {
 public:
  Comparison(const Compiled& theirs, const Environment& environment)
      : theirs_(theirs), workspace_(environment.resolver, sources_) {
    const read::Reader reader{workspace_, environment.resolver, environment.sdf, environment.urdf};
    loaded_ = read::load(reader, workspace_.open(theirs.file));
    mass::MeshSurveys surveys(environment.disk, {.workers = &environment.workers});
    const model::Frames& frames = frames_.emplace(loaded_.root);
    if (loaded_.root.models.empty()) return;
    robot_ =
        robot::robot_of(loaded_.root, frames, {0},
                        {.find_mesh = rules::mesh_finder(environment.resolver, sources_, surveys)});
  }

  bool expands() const {
    for (const read::MjcfFact& fact : loaded_.mjcf_facts) {
      if (fact.kind == read::MjcfFactKind::kNotExpanded) return true;
    }
    return false;
  }

  /// What differs first; empty when nothing does.
  std::string difference() {
    if (loaded_.root.models.empty()) return "no model";
    for (std::uint32_t i = 0; i < loaded_.root.links.size(); ++i) {
      const model::Link& link = loaded_.root.links[i];
      if (link.between_joints) continue;
      if (link.name.value == "world")
        world_ = i;
      else
        links_.push_back(i);
    }
    if (links_.size() + 1 != theirs_.bodies.size()) {
      return "bodies: " + std::to_string(links_.size()) + ", not " +
             std::to_string(theirs_.bodies.size() - 1);
    }
    for (std::size_t b = 0; b < links_.size(); ++b) {
      const std::string& name = theirs_.bodies[b + 1];
      const std::string& ours = loaded_.root.links[links_[b]].name.value;
      if (!name.empty() && name != ours) return "body " + ours + ", not " + name;
    }
    find_aligned();
    for (const auto& step :
         {&Comparison::joints, &Comparison::shapes, &Comparison::masses, &Comparison::motion}) {
      if (std::string found = (this->*step)(); !found.empty()) return found;
    }
    return {};
  }

 private:
  /// MuJoCo may move the frame of a free body to its center of mass and principal axes; rigor leaves it where the
  /// file has it. Where it is in rigor's is taken from the poses at rest, and held to by shapes and masses.
  void find_aligned() {
    X_aligned_.resize(theirs_.bodies.size());
    for (std::size_t b = 0; b < links_.size(); ++b) {
      const bool aligned = std::any_of(
          loaded_.root.joints.begin(), loaded_.root.joints.end(), [&](const model::Joint& joint) {
            if (joint.type != model::JointType::kFloating) return false;
            if (joint.child.value != loaded_.root.links[links_[b]].name.value) return false;
            const std::string_view tag = sources_.bytes(joint.site.tag);
            return tag.find("align=\"true\"") != tag.npos ||
                   (compiler_says("alignfree") && tag.find("align=\"false\"") == tag.npos);
          });
      if (!aligned) continue;
      const Pose X_WL = *frames_->pose(model::Id<model::Link>{links_[b]});
      X_aligned_[b + 1] = compose(inverse(X_WL), pose_of(theirs_, 0, b + 1));
    }
  }
  static Pose pose_of(const Compiled& c, std::size_t k, std::size_t b) {
    return {vector_at(c.xpos[k], b), quaternion_at(c.xquat[k], b)};
  }
  /// Of the body at the k-th positions, its frame being that of the file.
  Pose their_pose(std::size_t k, std::size_t b) const {
    return compose(pose_of(theirs_, k, b), inverse(X_aligned_[b]));
  }

  bool compiler_says(std::string_view setting) const {
    for (const xml::Element child : loaded_.file->document->root()->children()) {
      const auto told = child.attribute(setting);
      if (child.name() == "compiler" && told) return told->value() == "true";
    }
    return false;
  }

  std::string joints() {
    std::size_t in_robot = 0;
    for (std::uint32_t i = 0; i < loaded_.root.joints.size(); ++i) {
      const model::JointType type = loaded_.root.joints[i].type;
      if (type != model::JointType::kFixed) {
        joints_.push_back(i);
        in_robot_.push_back(in_robot);
      }
      // A free body has no joint in a robot.
      if (type != model::JointType::kFloating) ++in_robot;
    }
    if (joints_.size() != theirs_.joints.size()) {
      return "joints: " + std::to_string(joints_.size()) + ", not " +
             std::to_string(theirs_.joints.size());
    }
    using Type = model::JointType;
    constexpr std::array kTypes{Type::kFloating, Type::kBall, Type::kPrismatic, Type::kRevolute};
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const model::Joint& joint = loaded_.root.joints[joints_[j]];
      const std::string& name = theirs_.joints[j];
      if (!name.empty() && name != joint.name.value) return "joint " + joint.name.value;
      if (joint.type != kTypes.at(static_cast<std::size_t>(theirs_.joint_type[j]))) {
        return "type of joint " + joint.name.value;
      }
      if (theirs_.joint_type[j] < 2) continue;
      const model::Axis& axis = joint.axes.front();
      const auto near = [](double a, double b) {
        return std::abs(a - b) <= kExact * std::max(1.0, std::abs(b));
      };
      if (axis.limit_written &&
          (!near(axis.lower.value + axis.position_at_rest, theirs_.range[2 * j]) ||
           !near(axis.upper.value + axis.position_at_rest, theirs_.range[2 * j + 1]))) {
        return "range of joint " + joint.name.value;
      }
      const robot::Axis& of_robot = robot_.joints[in_robot_[j]].axes.front();
      if (!near(of_robot.spring_stiffness, theirs_.stiffness[j]))
        return "stiffness of " + joint.name.value;
      if (!near(of_robot.damping, theirs_.damping[j])) return "damping of " + joint.name.value;
      if (!near(axis.friction.value, theirs_.friction[j])) return "friction of " + joint.name.value;
    }
    return {};
  }

  /// The geoms of each body: collisions, and visuals that are no collisions as well.
  struct Part {
    const model::Geometry* geometry;
    Pose X_LG;
    bool only_drawn = false;
    bool taken = false;
  };
  std::vector<Part> parts(std::uint32_t link_index) const {
    const model::Link& link = loaded_.root.links[link_index];
    std::vector<Part> parts;
    std::set<std::pair<SourceId, std::uint32_t>> seen;
    for (const auto id : link.collisions) {
      const auto& one = loaded_.root[id];
      seen.insert({one.site.span.source, one.site.span.begin});
      parts.push_back({&one.geometry, one.pose.pose.value});
    }
    for (const auto id : link.visuals) {
      const auto& one = loaded_.root[id];
      if (seen.contains({one.site.span.source, one.site.span.begin})) continue;
      parts.push_back({&one.geometry, one.pose.pose.value, true});
    }
    return parts;
  }

  static double apart(const Vector3& a, const Vector3& b) { return length(a - b); }

  /// Whether a primitive of MuJoCo's is this one: its kind, sizes and place in the body.
  bool is_part(const Part& part, std::size_t geom, const Pose& X_WL) const {
    const Vector3 size = vector_at(theirs_.size, geom);
    const Pose X_WG = compose(X_WL, part.X_LG);
    const Numbers& matrix = theirs_.gmat[0];
    const auto column = [&](std::size_t k) {
      return Vector3{matrix[9 * geom + k], matrix[9 * geom + 3 + k], matrix[9 * geom + 6 + k]};
    };
    const auto along = [&](std::size_t k, const Vector3& axis) {
      return std::abs(std::abs(dot(column(k), rotate(X_WG.rotation, axis))) - 1) < 1e-7;
    };
    const auto* mesh = std::get_if<model::Mesh>(&part.geometry->shape);
    if (theirs_.geom_type[geom] == mjGEOM_MESH || mesh != nullptr) return mesh != nullptr;
    if (apart(X_WG.translation, vector_at(theirs_.gpos[0], geom)) > 1e-8) return false;
    const auto is = [](double a, double b) { return std::abs(a - b) < 1e-8; };
    switch (theirs_.geom_type[geom]) {
      case mjGEOM_PLANE:
        return std::holds_alternative<model::Plane>(part.geometry->shape) && along(2, {0, 0, 1});
      case mjGEOM_HFIELD: return true;
      case mjGEOM_SPHERE: {
        const auto* s = std::get_if<model::Sphere>(&part.geometry->shape);
        return s != nullptr && is(s->radius.value, size.x);
      }
      case mjGEOM_CAPSULE: {
        const auto* s = std::get_if<model::Capsule>(&part.geometry->shape);
        return s != nullptr && is(s->radius.value, size.x) && is(s->length.value, 2 * size.y) &&
               along(2, {0, 0, 1});
      }
      case mjGEOM_CYLINDER: {
        const auto* s = std::get_if<model::Cylinder>(&part.geometry->shape);
        return s != nullptr && is(s->radius.value, size.x) && is(s->length.value, 2 * size.y) &&
               along(2, {0, 0, 1});
      }
      case mjGEOM_ELLIPSOID: {
        const auto* s = std::get_if<model::Ellipsoid>(&part.geometry->shape);
        return s != nullptr && apart(s->radii.value, size) < 1e-8 && along(0, {1, 0, 0}) &&
               along(2, {0, 0, 1});
      }
      case mjGEOM_BOX: {
        const auto* s = std::get_if<model::Box>(&part.geometry->shape);
        return s != nullptr && apart(s->size.value, 2 * size) < 1e-8 && along(0, {1, 0, 0}) &&
               along(2, {0, 0, 1});
      }
      default: return true;
    }
  }

  std::string shapes() {
    for (std::size_t b = 0; b < theirs_.bodies.size(); ++b) {
      std::vector<Part> ours;
      if (b > 0) ours = parts(links_[b - 1]);
      if (b == 0 && world_) ours = parts(*world_);
      const Pose X_WL = their_pose(0, b);
      std::size_t count = 0;
      for (std::size_t g = 0; g < theirs_.geom_body.size(); ++g) {
        if (theirs_.geom_body[g] != static_cast<int>(b)) continue;
        ++count;
        bool found = false;
        for (Part& part : ours) {
          if (part.taken || !is_part(part, g, X_WL)) continue;
          part.taken = found = true;
          break;
        }
        if (!found) {
          return "geom " + std::to_string(g) + " of type " + std::to_string(theirs_.geom_type[g]) +
                 " of body " + theirs_.bodies[b];
        }
      }
      // What is only drawn is left out; it has its weight all the same.
      if (compiler_says("discardvisual")) {
        std::erase_if(ours, [](const Part& part) { return part.only_drawn && !part.taken; });
      }
      if (count != ours.size()) return "geoms of body " + theirs_.bodies[b];
    }
    return {};
  }

  static mass::Inertia full_tensor(const Compiled& c, std::size_t b) {
    const Vector3 diagonal = vector_at(c.inertia, b);
    return mass::rotated(model::normalized(quaternion_at(c.iquat, b)),
                         {diagonal.x, 0, 0, diagonal.y, 0, diagonal.z});
  }

  bool has_mesh(std::uint32_t link) const {
    for (const Part& part : parts(link)) {
      if (std::holds_alternative<model::Mesh>(part.geometry->shape)) return true;
    }
    return false;
  }

  std::string masses() {
    // settotalmass makes each mass depend on all meshes.
    bool any_mesh = false;
    for (const std::uint32_t link : links_) any_mesh = any_mesh || has_mesh(link);
    const bool scaled = loaded_.root.mass_settings.total_mass > 0;
    for (std::size_t b = 0; b < links_.size(); ++b) {
      const mass::MassProperties& ours = robot_.bodies[links_[b]].mass;
      const Pose X_BL = inverse(link_in_body(links_[b]));
      const mass::MassProperties in_link = mass::transformed(X_BL, ours);
      const double tolerance = has_mesh(links_[b]) || (scaled && any_mesh) ? kOfMeshes : kExact;
      const double mass = theirs_.mass[b + 1];
      char text[300];
      if (std::abs(in_link.mass - mass) > tolerance * std::max(mass, 1e-9)) {
        std::snprintf(text, sizeof text, "mass of %s: %.10g, not %.10g%s",
                      theirs_.bodies[b + 1].c_str(), in_link.mass, mass,
                      tolerance > kExact ? " (mesh)" : "");
        return text;
      }
      if (mass == 0) continue;
      const Pose& X_LA = X_aligned_[b + 1];
      if (apart(in_link.com, transform(X_LA, vector_at(theirs_.ipos, b + 1))) >
          std::max(1e-8, tolerance)) {
        return "center of mass of " + theirs_.bodies[b + 1];
      }
      const mass::Inertia tensor = mass::rotated(X_LA.rotation, full_tensor(theirs_, b + 1));
      const mass::Inertia off = in_link.about_com - tensor;
      const double scale = std::max({tensor.ixx, tensor.iyy, tensor.izz, 1e-12});
      for (const double entry : {off.ixx, off.iyy, off.izz, off.ixy, off.ixz, off.iyz}) {
        if (std::abs(entry) > std::max(10 * tolerance, kOfTensors) * scale + 1e-13) {
          std::snprintf(text, sizeof text, "inertia of %s: off by %.3g of %.3g%s",
                        theirs_.bodies[b + 1].c_str(), entry, scale,
                        tolerance > kExact ? " (mesh)" : "");
          return text;
        }
      }
    }
    return {};
  }

  /// Of a robot's body, whose frame is that of its joint, the link frame's pose.
  Pose link_in_body(std::uint32_t link) const {
    return compose(inverse(robot_.bodies[link].X_MB), *frames_->pose(model::Id<model::Link>{link}));
  }

  std::string motion() {
    std::vector<Pose> X_BL;
    for (const std::uint32_t link : links_) X_BL.push_back(link_in_body(link));
    std::map<std::string, std::size_t> by_name;
    for (std::size_t r = 0; r < robot_.joints.size(); ++r) {
      by_name.try_emplace(robot_.joints[r].name, r);
    }
    for (std::size_t k = 0; k < theirs_.qpos.size(); ++k) {
      robot::Positions positions(robot_.joints.size());
      for (std::size_t j = 0; j < joints_.size(); ++j) {
        if (theirs_.joint_type[j] < 2) continue;
        const model::Joint& joint = loaded_.root.joints[joints_[j]];
        const auto found = by_name.find(joint.name.value);
        if (found == by_name.end()) continue;
        positions[found->second] = {
            theirs_.qpos[k][static_cast<std::size_t>(theirs_.joint_position[j])] -
            joint.axes.front().position_at_rest};
      }
      const std::vector<Pose> X_WB = robot::body_poses(robot_, positions);
      for (std::size_t b = 0; b < links_.size(); ++b) {
        const Pose X_WL = compose(X_WB[links_[b]], X_BL[b]);
        const auto& [there, q] = their_pose(k, b + 1);
        const double turned = std::abs(std::abs(X_WL.rotation.w * q.w + X_WL.rotation.x * q.x +
                                                X_WL.rotation.y * q.y + X_WL.rotation.z * q.z) -
                                       1);
        if (apart(X_WL.translation, there) > kExact * std::max(1.0, length(there)) ||
            turned > kExact) {
          return "pose of " + theirs_.bodies[b + 1] + (k == 0 ? " at rest" : " when moved");
        }
      }
    }
    return {};
  }

  const Compiled& theirs_;
  Sources sources_;
  read::Workspace workspace_;
  read::Loaded loaded_;
  std::optional<model::Frames> frames_;
  robot::Robot robot_;
  std::vector<std::uint32_t> links_, joints_;
  std::vector<std::size_t> in_robot_;  // of joints_: the same in robot_
  std::vector<Pose> X_aligned_;        ///< by body of MuJoCo's: its frame in that of the file
  std::optional<std::uint32_t> world_;
};

std::filesystem::path corpus() {
  const char* folder = std::getenv("RIGOR_CORPUS");
  return folder == nullptr ? "" : std::string(folder) + "-mjcf";
}

bool has_error(const std::string& file, const Environment& environment) {
  Sources sources;
  const auto result = rules::validate(environment, {.paths = {file}}, sources);
  for (const Diagnostic& one : result.diagnostics.list()) {
    if (one.severity == Severity::kError) return true;
  }
  return !result.unusable.empty();
}

/// What says nothing of the file as a model: MuJoCo's Python package brings the plugins that its npm package lacks;
/// that one, of 32 bits, cannot read ASCII files of GMSH 2.2 (it seeks back by an unsigned size); and a part with
/// the root <mujocoinclude> claims to be no model.
bool is_of_the_judge(const std::string& error) {
  const auto has = [&](const char* text) { return error.find(text) != std::string::npos; };
  return (has("plugin ") && has(" not found")) || has("Error reading Nodes header") ||
         has("'mujocoinclude'");
}

struct Tally {
  int loaded = 0, same = 0, expanded = 0, refused = 0, errors = 0, excused = 0, false_errors = 0;

  void add(const Compiled& theirs, const Environment& environment) {
    const std::string shown = theirs.file.substr(corpus().string().size() + 1);
    if (is_of_the_judge(theirs.error)) {
      ++excused;
      return;
    }
    if (!theirs.error.empty()) {
      ++refused;
      if (has_error(theirs.file, environment)) {
        ++errors;
      } else {
        std::string why = theirs.error;
        for (char& c : why) c = c == '\n' ? ' ' : c;
        std::printf("NOT REFUSED %s: %s\n", shown.c_str(), why.c_str());
      }
      return;
    }
    if (has_error(theirs.file, environment)) {
      ++false_errors;
      std::printf("FALSE ERROR %s\n", shown.c_str());
    }
    std::fflush(stdout);
    Comparison comparison(theirs, environment);
    if (comparison.expands()) {
      ++expanded;
      return;
    }
    ++loaded;
    const std::string found = comparison.difference();
    if (found.empty()) {
      ++same;
    } else {
      std::printf("DIFFERS %s: %s\n", shown.c_str(), found.c_str());
    }
  }

  void expect() const {
    std::printf(
        "%d of %d the same, %d left out for composite or flexcomp; %d of %d refused get an error, "
        "%d are "
        "refused for what the judge lacks or as parts\n",
        same, loaded, expanded, errors, refused, excused);
    EXPECT_GE(same, 0.98 * loaded);
    EXPECT_GE(errors, 0.95 * refused);
    EXPECT_EQ(false_errors, 0);
  }
};

TEST(CorpusMjcf, IsReadAsTheInstalledMujocoCompilesIt) {
  if (!std::filesystem::is_directory(corpus())) GTEST_SKIP() << "no corpus of MJCF files";
  RealDisk disk;
  const Environment environment(disk, {});
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus())) {
    if (entry.path().extension() == ".xml") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  Tally tally;
  for (const std::string& file : files) {
    const Compiled theirs = compiled_by_library(file);
    if (theirs.error.empty()) tally.add(theirs, environment);  // newer features are judged below
  }
  tally.expect();
}

TEST(CorpusMjcf, IsReadAsTheNewestMujocoCompilesIt) {
  const char* dump = std::getenv("RIGOR_MUJOCO_DUMP");
  if (dump == nullptr) GTEST_SKIP() << "RIGOR_MUJOCO_DUMP names no dump";
  RealDisk disk;
  const Environment environment(disk, {});
  std::ifstream lines(dump);
  Tally tally;
  for (std::string line; std::getline(lines, line);) {
    tally.add(compiled_from(nlohmann::json::parse(line)), environment);
  }
  tally.expect();
}

}  // namespace
}  // namespace rigor::judge
