// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of an engine, for sources of this folder only: ODE's world with the bodies, their shapes, what touches,
// and the joints. Frames: an ODE body stands at its center of mass, with the axes of the scene's body B.
//
//   OdeWorld ode(scene, settings);
//   EngineShapes shapes(scene, ode);
//   EngineJoints joints(scene, settings, ode);
//   EngineContacts contacts(scene, settings, ode);

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <ode/ode.h>

#include <rigor/simulate/engine/contact_rules.h>
#include <rigor/simulate/engine/engine.h>
#include <rigor/simulate/engine/state.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

inline Vector3 vector_of(const dReal* v) { return {v[0], v[1], v[2]}; }

/// A direction that is fixed in a body, or in the world (null), in W.
inline Vector3 in_world(dBodyID body, const Vector3& v) {
  if (body == nullptr) return v;
  const dReal* R = dBodyGetRotation(body);  // rows of four
  return {R[0] * v.x + R[1] * v.y + R[2] * v.z, R[4] * v.x + R[5] * v.y + R[6] * v.z,
          R[8] * v.x + R[9] * v.y + R[10] * v.z};
}

/// The other way round.
inline Vector3 in_body(dBodyID body, const Vector3& v) {
  if (body == nullptr) return v;
  const dReal* R = dBodyGetRotation(body);
  return {R[0] * v.x + R[4] * v.y + R[8] * v.z, R[1] * v.x + R[5] * v.y + R[9] * v.z,
          R[2] * v.x + R[6] * v.y + R[10] * v.z};
}

/// ODE as a whole, for as long as an engine lives: handlers that throw, the world and its bodies.
class OdeSession {
 public:
  explicit OdeSession(std::uint64_t seed);
  ~OdeSession();
  OdeSession(const OdeSession&) = delete;
  OdeSession& operator=(const OdeSession&) = delete;
};

class OdeWorld {
 public:
  OdeWorld(const Scene& scene, const SolverSettings& settings);
  ~OdeWorld();
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;

  /// Null for the world.
  dBodyID body(std::uint32_t index) const { return index == kWorld ? nullptr : bodies_[index]; }
  dWorldID world() const { return world_; }
  dSpaceID space() const { return space_; }
  dJointGroupID contacts() const { return contacts_; }

 private:
  /// Whole before a body is made, so that what is refused then is cleared away.
  OdeWorld(const Scene& scene, const SolverSettings& settings, std::nullptr_t bodies);

  OdeSession session_;
  dWorldID world_ = nullptr;
  dSpaceID space_ = nullptr;
  dJointGroupID contacts_ = nullptr;
  std::vector<dBodyID> bodies_;
};

/// The shapes as ODE's geoms, and the data that ODE only points to. A geom's own data is its index.
class EngineShapes {
 public:
  EngineShapes(const Scene& scene, const OdeWorld& ode);
  ~EngineShapes();
  EngineShapes(const EngineShapes&) = delete;
  EngineShapes& operator=(const EngineShapes&) = delete;

 private:
  struct Triangles;

  EngineShapes() = default;
  dGeomID make(const Scene& scene, const SceneShape& shape, dSpaceID space);
  dGeomID triangles(const mesh::TriangleMesh& mesh, dSpaceID space);
  dGeomID heights(const HeightGrid& grid, dSpaceID space);

  std::vector<std::unique_ptr<Triangles>> triangles_;
  std::vector<dHeightfieldDataID> heights_;
};

/// What touches, and with what surface.
class EngineContacts {
 public:
  EngineContacts(const Scene& scene, const SolverSettings& settings, const OdeWorld& ode);

  /// Finds all contacts of this moment. With `join`, the coming step is informed of them.
  enum class Join : std::uint8_t { kNo, kYes };
  void find(Join join, Forces forces, std::vector<ContactState>& contacts);

  /// After the step, when they were asked for.
  void read_forces(std::vector<ContactState>& contacts) const;

 private:
  struct Shape {
    std::uint32_t body = kWorld;
    Quaternion R_BL;
    const ContactSurface* surface = nullptr;
  };

  /// Enough for a mesh on a mesh; the ones that count are chosen from them.
  static constexpr int kFound = 128;

  static void near(void* self, dGeomID a, dGeomID b);
  void touch(dGeomID a, dGeomID b);
  dContact surface_of(const Shape& a, const Shape& b) const;
  Vector3 first_direction(const Shape& a, const Shape& b) const;
  int choose(int found, int wanted);

  const OdeWorld& ode_;
  SolverSettings settings_;
  ContactRules rules_;
  std::vector<Shape> shapes_;
  std::array<dContactGeom, kFound> found_{};
  // Of the moment that is examined.
  Join join_ = Join::kNo;
  std::vector<ContactState>* contacts_ = nullptr;
  std::vector<dJointID> joints_;
  std::vector<dJointFeedback> feedback_;
};

/// A joint's degree of freedom as the engine drives and reads it: `plus` turns or slides against `minus`
/// (bodies; null is the world) along an axis that is fixed in `carrier`.
struct Coordinate {
  enum class Kind : std::uint8_t {
    kHinge,
    kSlider,
    kUniversalFirst,   ///< about the parent's axis
    kUniversalSecond,  ///< about the child's
    kScrewTurn,
    kScrewSlide,
    kFree,  ///< turning that no joint holds to the axis: its speed is summed up
  };
  enum class Command : std::uint8_t { kNone, kEffort, kMotor };

  Kind kind = Kind::kHinge;
  dJointID joint = nullptr;  ///< null for kFree
  dBodyID plus = nullptr;
  dBodyID minus = nullptr;
  dBodyID carrier = nullptr;
  Vector3 axis;        ///< in the carrier
  Vector3 anchor_W;    ///< of the joint, as it is made
  double inertia = 0;  ///< kg·m² or kg that a force meets at least; infinite when nothing gives way
  SceneAxis written;

  Command command = Command::kNone;
  double told = 0;          ///< effort, or velocity
  double most = 0;          ///< effort of the motor
  double give = 0;          ///< of the motor: rad/s per N·m, or m/s per N, that it gives way by
  bool yields = false;      ///< the motor is a servo's, which gives way as a spring does
  bool held = false;        ///< by its motor and its friction, in the last step
  double row = 0;           ///< effort of the motor and of friction in the last step
  dJointID firm = nullptr;  ///< a spring and damper that is too stiff for a force; else null
  bool busy = false;        ///< something is to be done before each step
  bool damps = false;       ///< by the motor's slot
  bool drives = false;      ///< a command has the motor's slot, and no stop is pressed against
  int turns = 0;            ///< that the angle has gone round
  Vector3 axis_W;           ///< now
  AxisState state;
};

/// Joints, their axes, limits, springs and motors, and the joints that ODE has not.
class EngineJoints {
 public:
  EngineJoints(const Scene& scene, const SolverSettings& settings, const OdeWorld& ode);

  void set_effort(std::uint32_t joint, std::uint32_t axis, double effort);
  void set_motor(std::uint32_t joint, std::uint32_t axis, double velocity, double effort);
  void set_servo(std::uint32_t joint, std::uint32_t axis, const Servo& servo);
  void release(std::uint32_t joint, std::uint32_t axis);

  /// Before a step: forces and motors. After it (or before the first): positions, speeds, efforts.
  void apply();
  void read(State& state);

 private:
  /// A joint's two anchors, from the centers of its bodies, in their axes.
  struct Anchors {
    dBodyID child = nullptr;
    dBodyID parent = nullptr;
    Vector3 p_child;
    Vector3 p_parent;
    bool hold = true;  ///< a gearbox has none
    bool slides = false;
    Vector3 axis_parent;  ///< along which they may part
  };

  /// follower = multiplier · (leader - reference) + offset, held by forces on both.
  struct Coupling {
    std::size_t follower = 0;  ///< coordinates
    std::size_t leader = 0;
    double multiplier = 1;
    double offset = 0;
    double reference = 0;
    double inertia = 0;
  };

  void make(const SceneJoint& joint);
  void make_hinge(const SceneJoint& joint);
  void make_slider(const SceneJoint& joint);
  void make_universal(const SceneJoint& joint);
  void make_screw(const SceneJoint& joint);
  void make_gearbox(const SceneJoint& joint);
  void make_mimics(const Scene& scene);
  void couple(Coupling& coupling) const;
  void add_anchors(const SceneJoint& joint);
  dJointID attach(dJointID made, const SceneJoint& joint) const;
  Coordinate coordinate(Coordinate::Kind kind, dJointID made, const SceneJoint& joint,
                        const SceneAxis& axis) const;

  Coordinate& at(std::uint32_t joint, std::uint32_t axis);
  void turn_on(Coordinate& c, std::uint32_t joint);
  void update(Coordinate& c) const;
  void use_slot(Coordinate& c) const;
  void drive_slot(Coordinate& c) const;
  void apply(Coordinate& c) const;
  void apply(const Coupling& coupling) const;
  double effort_of(Coordinate& c, std::size_t joint) const;
  void read(Coordinate& c) const;
  void read_anchors(State& state) const;

  const OdeWorld& ode_;
  double step_;
  double cfm_;
  std::vector<std::uint32_t> first_;     ///< joint by joint, where its coordinates begin
  std::vector<Coordinate> coordinates_;  ///< the axes of the scene, then hidden ones
  std::vector<Coordinate> hidden_;       ///< while joints are made
  std::vector<Coupling> couplings_;
  std::vector<Anchors> anchors_;
  std::vector<std::unique_ptr<dJointFeedback>> feedback_;  ///< of joints that have had a motor
};

/// Whether it turns; else it slides.
bool is_angle(Coordinate::Kind kind);

/// Whether a spring or damper is too stiff for a force that is set before a step.
bool is_firm(const Coordinate& c, double step);

/// A row that a firm spring and damper are: `c.firm` is made of it.
dJointID make_firm(dWorldID world, const Coordinate& c, double step);

/// Before a step: whether there is the row, and where it is to pull to.
enum class Row : std::uint8_t { kOff, kOn };
void set_firm(const Coordinate& c, double step, Row row);

/// Adds a force or torque to a coordinate: on `plus`, and the opposite on `minus`.
void add_effort(const Coordinate& c, double effort);

/// As ODE has it: an angle lies between -π and π.
double raw_position(const Coordinate& c);

}  // namespace rigor::simulate
