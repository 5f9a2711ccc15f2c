// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A model, or a world of them, as a physics engine takes it: rigid bodies with shapes, joints between
// them, ground under them. Plain data in one frame W, whose z is up; no engine is named here.
//
// Links that fixed joints hold together are one body. What a static model holds, and what is fixed to
// the world, are shapes of the world. Values have their defaults and no sentinels: what is unlimited is
// infinite. Metres, kilograms, seconds, radians, newtons.
//
//   SceneResult made = build_scene(input, {});
//   if (!made.blocked()) Record record = run_isolated(made.scene, scenario, made.scene.solver, workers);

#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <rigor/mass/mass_properties.h>
#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/model.h>
#include <rigor/model/pose.h>
#include <rigor/text/span.h>

namespace rigor::simulate {

using model::Pose;
using model::Quaternion;
using model::Vector3;

/// In place of an index: the world, or nothing.
inline constexpr std::uint32_t kWorld = 0xffffffffU;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Convex, closed, wound outward.
struct ConvexHull {
  std::uint32_t mesh = 0;  ///< index in `Scene::meshes`, in the shape's frame and scale
};

struct TriangleSoup {
  std::uint32_t mesh = 0;
};

/// All below the plane through the shape's origin is solid.
struct HalfSpace {
  Vector3 normal{0, 0, 1};  ///< unit vector, in the shape's frame
};

/// Heights over an even grid, centered at the shape's origin.
struct HeightGrid {
  std::uint32_t columns = 0;    ///< along x
  std::uint32_t rows = 0;       ///< along y
  double width = 0;             ///< along x, m
  double depth = 0;             ///< along y, m
  std::vector<double> heights;  ///< m, row by row
};

using SceneShapeKind = std::variant<mesh::Box, mesh::Sphere, mesh::Cylinder, mesh::Capsule,
                                    ConvexHull, TriangleSoup, HalfSpace, HeightGrid>;

/// `<surface>`, as SDFormat defaults it. Gazebo takes the smaller mu of a pair; see simulate/engine/ode/contacts.cc.
struct ContactSurface {
  double mu = 1;
  double mu2 = 1;
  /// The first friction direction, in the shape's link (a file writes it in the collision's frame); zero lets
  /// the engine choose.
  Vector3 fdir1;
  double slip1 = 0;  ///< (m/s)/N
  double slip2 = 0;
  double restitution = 0;
  double bounce_threshold = 1e5;  ///< m/s: slower impacts do not bounce
  double kp = 1e12;               ///< N/m
  double kd = 1;                  ///< N·s/m
  std::uint32_t collide_bitmask = 0xffff;
  bool collide_without_contact = false;
  int max_contacts = 10;
};

struct SceneShape {
  std::string name;  ///< scoped: "robot::base::collision"
  std::uint32_t body = kWorld;
  std::uint32_t link = kWorld;  ///< index in `Scene::links`; none for the ground that was added
  Pose X_BS;                    ///< in the body's frame; of the world's shapes, X_WS
  SceneShapeKind kind;
  ContactSurface surface;
  double extent = 0;  ///< m: the longest side of its bounds; infinite for a half space
  Span where;         ///< the shape's element; nowhere for the ground that was added
};

/// A rigid body. Its frame B is that of its first link.
struct SceneBody {
  std::string name;  ///< of its first link, scoped
  std::vector<std::uint32_t> links;
  mass::MassProperties mass;  ///< in B
  Pose X_WB;                  ///< at the start
  bool gravity = true;
  bool kinematic = false;     ///< moves as commanded, not by forces
  bool self_collide = false;  ///< with bodies of the same model that no joint connects it to
  double linear_damping = 0;  ///< SDF's velocity_decay, a share per step
  double angular_damping = 0;
  std::uint32_t model = 0;  ///< index in `Scene::models`
  Span where;               ///< the first link's name
};

struct SceneLink {
  std::string name;  ///< scoped
  std::uint32_t body = kWorld;
  Pose X_BL;  ///< in the body's frame; in W for a link of the world
  model::Id<model::Link> id;
  Span where;                    ///< its name
  std::uint32_t model = kWorld;  ///< index in `Scene::models`: the outermost one
};

/// One degree of freedom. Angles in rad, N·m; of a slider m, N.
struct SceneAxis {
  Vector3 direction_W;  ///< unit vector at the start
  double start = 0;     ///< position at the start: poses and directions are those there
  double lower = -kInfinity;
  double upper = kInfinity;
  double effort = kInfinity;
  double velocity = kInfinity;
  double damping = 0;
  double friction = 0;
  double spring_reference = 0;
  double spring_stiffness = 0;
  double stop_erp = 0.2;
  double stop_cfm = 0;
  Span where;        ///< `<axis>`
  Span limit_where;  ///< `<limit>`; nowhere when there is none
};

/// position = multiplier · (leader - reference) + offset
struct SceneMimic {
  std::uint32_t joint = 0;
  std::uint32_t axis = 0;
  double multiplier = 1;
  double offset = 0;
  double reference = 0;
};

struct SceneJoint {
  std::string name;  ///< scoped
  /// kRevolute (kContinuous is one without limits), kPrismatic, kBall, kUniversal, kRevolute2, kScrew,
  /// kGearbox, or kFixed where it closes a loop between bodies that other joints hold already.
  model::JointType type = model::JointType::kRevolute;
  std::uint32_t parent = kWorld;  ///< bodies
  std::uint32_t child = kWorld;
  Vector3 anchor_W;             ///< at the start
  std::vector<SceneAxis> axes;  ///< as many as the type has; none for ball and fixed
  double screw_pitch = 0;       ///< m per rad along the axis, of a screw
  double gearbox_ratio = 1;     ///< of a gearbox: child's angle = -ratio · parent's angle
  std::uint32_t gearbox_reference = kWorld;  ///< body
  std::vector<SceneMimic> mimics;            ///< of axis i; fewer than axes when none mimics
  std::uint32_t model = kWorld;
  Span where;  ///< its name
};

struct SceneModel {
  std::string name;
  /// The body that no joint of the model carries (of several the one that carries the most): tilt, creep and
  /// way are this body's. Where there is none, that of its canonical link; the world's for a static model.
  std::uint32_t base = kWorld;
  bool is_static = false;
  model::Id<model::Model> id;
  Span where;
  std::uint32_t missing_shapes = 0;  ///< whose meshes could not be read
};

enum class Solver : std::uint8_t {
  kQuick,    ///< ODE's iterative one, Gazebo's default
  kDantzig,  ///< ODE's exact one, Gazebo's "world"
};

/// Which engine steps the scene (engine/engine.h).
enum class EngineKind : std::uint8_t { kOde, kMujoco };

/// "ode", "mujoco".
constexpr std::string_view name_of(EngineKind engine) {
  return engine == EngineKind::kOde ? "ode" : "mujoco";
}

/// How time goes on. Defaults are rigor's own profile (docs/simulate.md says why); what a world's
/// `<physics>` writes goes before them.
struct SolverSettings {
  double step = 0.001;  ///< s
  Solver solver = Solver::kQuick;
  int iterations = 200;
  double sor = 1.3;
  double erp = 0.2;
  double cfm = 1e-5;  ///< (m/s)/N; see softest_cfm
  /// m/s. SDF's own default of 100 shoots a robot that is a centimeter in the ground into the sky;
  /// Gazebo's engine has a limit of 0.01 a body instead.
  double max_correcting_velocity = 0.1;
  double surface_layer = 0.001;  ///< m, that resting contacts may sink in
  int max_contacts = 20;         ///< of a pair of shapes
  bool stiffness = false;  ///< contacts take kp and kd of their surfaces instead of erp and cfm
  std::uint64_t seed = 0;
  EngineKind engine = EngineKind::kOde;  ///< of MuJoCo only the step counts
  std::string library;                   ///< the path of MuJoCo's; empty for the installed one
};

struct Scene {
  std::string name;             ///< of the model, or of the world
  Vector3 gravity{0, 0, -9.8};  ///< m/s²
  SolverSettings solver;
  bool alone = true;  ///< a model at the top of its file: it brings no ground of its own
  std::vector<SceneModel> models;
  std::vector<SceneBody> bodies;
  std::vector<SceneLink> links;
  std::vector<SceneShape> shapes;
  std::vector<SceneJoint> joints;
  std::vector<mesh::TriangleMesh> meshes;

  /// The diagonal of the bounds of all that moves, m: the length that speeds and errors are held against.
  double size = 1;
};

/// Whether a scoped name is, or ends in, what somebody wrote: "robot::arm::elbow" is "elbow".
bool is_named(std::string_view scoped, std::string_view written);

/// Sum over what moves, kg.
double moving_mass(const Scene& scene);

/// (m/s)/N: the most that contacts and joints may give way by, so that what bears all of the scene gives way by a
/// share of what gravity adds in a step. Of what weighs more than 100 kg that is below the profile's.
double softest_cfm(const Scene& scene);

}  // namespace rigor::simulate
