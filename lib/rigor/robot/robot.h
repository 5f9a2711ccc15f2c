// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A robot as what matters of it, whatever the format it came from: bodies with their mass and shapes,
// joints between them, and where all of it is at given joint positions. Two of them can be compared
// (compare.h), which two files cannot.
//
// A body's frame B is the frame of the joint that carries it, as in URDF; an SDF link frame, which may
// stand anywhere, has no say. A body that no joint carries is a root: there B is the link frame. What
// is fixed to the world hangs on a body named `world`, as in URDF.
//
//   Robot robot = robot_of(loaded.root, frames, model_id);
//   std::vector<Pose> X_RB = body_poses(robot, {});           // all joints at zero
//   Moments sum = moments(robot, X_RB);
//
// Sentinels are folded: what -1, infinity or 1e16 and beyond mean is infinity here, and a continuous
// joint is a revolute one without limits.

#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <rigor/mass/find_mesh.h>
#include <rigor/mass/mass_properties.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/model/motion.h>
#include <rigor/text/span.h>

namespace rigor::robot {

inline constexpr std::uint32_t kNoIndex = 0xffffffffU;

using model::kUnlimited;

/// The name of the body that represents the world.
inline constexpr const char* kWorldBody = "world";

struct Color {
  double r = 0, g = 0, b = 0, a = 1;
  bool operator==(const Color&) const = default;
};

/// A shape and its numbers, in meters. `kind` is the element's name in SDF ("box"; "none").
struct Shape {
  std::string kind;
  /// box: sides; sphere: radius; cylinder, capsule, cone: radius, length; ellipsoid: radii; plane:
  /// normal; mesh: scale; heightmap: size; polyline: height, then x and y of each point.
  std::vector<double> numbers;
  std::string uri;   ///< of a mesh, heightmap or image, as written
  std::string path;  ///< of the file it leads to; empty when it does not exist
  std::string submesh;
};

/// A collision or a visual.
struct Part {
  std::string name;  ///< empty where URDF gives none
  model::Pose X_BS;  ///< in the body's frame
  Shape shape;
  std::optional<Color> color;  ///< of a visual, when one is known
  bool has_material = false;   ///< of a visual; its color may be unknown
  Span span;
};

struct Body {
  std::string name;           ///< scoped inside the model: "hand::palm"
  mass::MassProperties mass;  ///< in the body's frame, as a consumer takes it
  std::vector<Part> collisions;
  std::vector<Part> visuals;
  std::uint32_t carrier = kNoIndex;  ///< index of the joint that carries it; none for a root
  /// Of a root: its pose in the frame of the model (URDF: the identity). Else at rest, from the joints.
  model::Pose X_MB;
  Span span;
};

/// position = multiplier · leader's + offset (SDF's reference is folded into the offset).
struct Mimic {
  std::string joint;
  std::uint32_t axis = 0;  ///< of the leader
  double multiplier = 1;
  double offset = 0;
};

/// One degree of freedom.
struct Axis {
  enum class Motion : std::uint8_t { kTurn, kSlide, kScrew };
  Motion motion = Motion::kTurn;
  model::Vector3 direction;  ///< unit vector in the joint frame; zero when the file has none
  double slide = 0;          ///< of a screw: m per rad, along the direction

  double lower = 0;  ///< rad, or m of a sliding axis; -infinity and infinity when there is none
  double upper = 0;
  double effort = 0;            ///< N·m or N; infinity when unlimited
  double velocity = 0;          ///< rad/s or m/s; infinity when unlimited
  double damping = 0;           ///< N·m·s/rad or N·s/m
  double friction = 0;          ///< N·m or N
  double spring_reference = 0;  ///< rad or m
  double spring_stiffness = 0;  ///< N·m/rad or N/m

  std::optional<Mimic> follow;
  Span span;
  Span limit_span;  ///< of `<limit>`; nowhere when there is none
};

struct Joint {
  std::string name;  ///< scoped inside the model
  /// Parent and child are those of the file, or, where the child has another parent and it is no loop,
  /// the other way round with the axis negated: the same motion. Never kContinuous. A floating joint has no axes: its child is free.
  model::JointType type = model::JointType::kUnknown;
  std::uint32_t parent = kNoIndex;  ///< bodies
  std::uint32_t child = kNoIndex;
  model::Pose X_PJ;  ///< of the joint at rest in the parent's frame
  /// The same in the child's frame: the identity unless another joint carries the child already, so
  /// that this one closes a loop.
  model::Pose X_CJ;
  /// Passed through in this order, each in the frame that the one before has moved. A ball joint turns
  /// about z, y and x; a planar one slides along two directions in its plane and turns about the third.
  std::vector<Axis> axes;
  bool closes_loop = false;
  Span span;
};

/// A frame that is no body: SDF's `<frame>`.
struct Frame {
  std::string name;
  std::uint32_t body = kNoIndex;
  model::Pose X_BF;
  Span span;
  bool of_joint = false;  ///< it was a fixed joint, which lumping took away
};

struct Robot {
  std::string name;
  std::vector<Body> bodies;  ///< file order; `world`, when there is one, last
  std::vector<Joint> joints;
  std::vector<Frame> frames;
  std::vector<std::uint32_t> order;  ///< of all bodies: each after the one it hangs on
  /// Where the model stands in the world; nothing when the format has no place for it (URDF).
  std::optional<model::Pose> X_WM;
  std::optional<bool> is_static;
  /// What has no place in it because the file does not say where it is: "link arm has no pose".
  std::vector<std::string> unknown;
};

/// What a model alone does not say.
struct Lookups {
  mass::FindMesh find_mesh = {};  ///< for automatic inertials
  /// The path that a URI leads to, from the source it stands in; empty when it does not exist.
  std::function<std::string(const std::string& uri, SourceId from)> find_file = {};
  std::function<std::optional<Color>(model::Id<model::Visual>)> color_of = {};
  /// Of a URDF joint, which has its spring in a `<gazebo>` block: reference and stiffness.
  std::function<std::array<double, 2>(model::Id<model::Joint>)> spring = {};
};

/// The model with all that is nested in it. `frames` is at rest (all joints at zero).
Robot robot_of(const model::Root& root, const model::Frames& frames, model::Id<model::Model> model,
               const Lookups& lookups = {});

/// A limit without its sentinel: from 1e16 on infinity.
double without_sentinel(double limit);
/// The same of an effort or a velocity, where a negative number says that there is none.
double ceiling(double value);

/// What a planar joint moves by, in the plane that is normal to the unit vector.
std::vector<Axis> planar_axes(const model::Vector3& normal);

/// Fills `carrier`, `closes_loop`, `order` and the poses `X_MB` of bodies with a carrier from the
/// joints' ends and `X_PJ`. Of two joints with one child the first carries; where joints go round in
/// a circle, the first body in it is a root.
void connect(Robot& robot);

/// rad or m, for each joint and its axes; what is absent is zero.
using Positions = std::vector<std::vector<double>>;

/// Of all bodies in the frame of the model, by index. What follows another joint is not moved with
/// it: see `followed`.
std::vector<model::Pose> body_poses(const Robot& robot, const Positions& positions);

/// The positions with every axis that follows another one where its leader puts it.
Positions followed(const Robot& robot, Positions positions);

/// What the axis does at position q, in the joint frame.
model::Pose motion(const Axis& axis, double q);

/// Sums that lumping does not change.
struct Moments {
  double mass = 0;       ///< kg
  model::Vector3 first;  ///< kg·m: Σ m c
  mass::Inertia second;  ///< kg·m² about the origin
};

/// About the origin of the frame that the poses are in, along its axes.
Moments moments(const Robot& robot, const std::vector<model::Pose>& X_RB);

}  // namespace rigor::robot
