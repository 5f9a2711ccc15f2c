// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A robot model, or a world of them, read from SDF, URDF or MJCF: plain structs, one per element that has
// meaning, each knowing where it was written.
//
// Everything lies in the flat vectors of a `Root`, in document order, linked by typed ids, so that
// whoever wants all joints iterates over all joints. Included files are part of the same root;
// `site.span.source` tells which file an entity was written in.
//
//   for (const Joint& joint : root.joints) {
//     const Model& model = root[joint.model];
//     for (const Axis& axis : joint.axes) check(axis.lower.value, axis.upper.value);
//   }
//
// Values are as written; where nothing was written, as the format's version defaults them. Lengths
// in meters, angles in radians, masses in kilograms, forces in newtons. What a name refers to, and
// where things are, is answered by `Frames` (frames.h).

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rigor/model/field.h>
#include <rigor/model/geometry.h>
#include <rigor/model/id.h>
#include <rigor/model/parameter.h>
#include <rigor/model/pose.h>
#include <rigor/model/site.h>

namespace rigor::model {

struct Collision;
struct Frame;
struct Joint;
struct Light;
struct Link;
struct Model;
struct Sensor;
struct Visual;
struct World;

/// `<pose>` or `<origin>`: the pose of the thing in the frame that `relative_to` names; the format's
/// default frame when that is empty.
struct PoseField {
  Field<Pose> pose;
  /// `relative_to` from SDF 1.7, `frame` in 1.5 and 1.6.
  Field<std::string> relative_to;
  Site site;               ///< of the element, when written
  bool malformed = false;  ///< URDF: whether `xyz` or `rpy` is there and is no vector
};

/// `<fluid_added_mass>` of SDF 1.11: the diagonal, kg (xx, yy, zz) and kg·m² (pp, qq, rr).
struct FluidAddedMass {
  Field<double> xx, yy, zz, pp, qq, rr;
};

struct Inertial {
  Site site;
  bool written = false;         ///< whether there is an `<inertial>` element
  Field<bool> automatic;        ///< SDF 1.11: `auto="true"`
  Field<double> density;        ///< kg/m³, with `auto`
  Field<double> mass;           ///< kg
  PoseField pose;               ///< of the center of mass frame C in the link frame L
  bool tensor_written = false;  ///< whether there is an `<inertia>` element
  Site tensor_site;
  /// kg·m² about the center of mass, in C's axes; matrix entries, so ixy = -∫xy dm.
  Field<double> ixx, ixy, ixz, iyy, iyz, izz;
  std::optional<FluidAddedMass> added_mass;
};

/// `<surface>` of a collision, as far as rigor understands it.
struct Surface {
  Field<double> mu;   ///< Coulomb coefficient along the first friction direction
  Field<double> mu2;  ///< along the second
  Field<double> slip1;
  Field<double> slip2;
  Field<double> kp;               ///< N/m
  Field<double> kd;               ///< N·s/m
  Field<double> min_depth;        ///< m, that contacts leave uncorrected
  Field<Vector3> fdir1;           ///< the first friction direction, in the collision's frame, or
  bool fdir1_in_frame = false;    ///< in one that an attribute of it names
  bool chooses_contacts = false;  ///< by bitmasks, or as `<collide_without_contact>`
};

/// MJCF: what a geom adds to a body that has no `<inertial>`. Only of geoms that count, by their group.
struct GeomWeight {
  Field<double> mass;     ///< kg; when written, the density has no say
  Field<double> density;  ///< kg/m³
  bool shell = false;     ///< `shellinertia`: the mass is on the surface
  enum class MeshLaw : std::uint8_t { kLegacy, kConvex, kExact, kShell };
  MeshLaw mesh_law = MeshLaw::kLegacy;  ///< `inertia` of the mesh asset
  /// The primitive that is fitted to the box with the moments of the mesh, and weighs in its place.
  enum class Fit : std::uint8_t { kNone, kSphere, kCapsule, kCylinder, kEllipsoid, kBox };
  Fit fit = Fit::kNone;
  double fit_scale = 1;
};

struct Collision {
  Site site;
  Field<std::string> name;
  Id<Link> link;
  PoseField pose;  ///< in the link frame
  Geometry geometry;
  Surface surface;
  Field<double> density;             ///< kg/m³, for an automatic inertial; SDF 1.11
  std::optional<GeomWeight> weight;  ///< MJCF
};

struct Material {
  bool written = false;
  Site site;
  Field<std::string> name;     ///< of a script, or of a URDF material
  Field<std::string> texture;  ///< URDF: file name
  bool defines_color = false;
  bool has_color = false;         ///< SDF: `<ambient>`, `<diffuse>` or `<emissive>`
  Site script;                    ///< SDF: `<script>`, when written
  Field<std::string> script_uri;  ///< the first `<uri>` of it
  Site pbr;                       ///< SDF: `<pbr>`, when written
  /// MJCF: red, green, blue and alpha of the geom, or of the material that it names; 0 to 1.
  std::optional<std::array<double, 4>> rgba;
};

struct Visual {
  Site site;
  Field<std::string> name;
  Id<Link> link;
  PoseField pose;  ///< in the link frame
  Geometry geometry;
  Material material;
  Field<double> transparency;        ///< from 0, opaque, to 1, invisible
  std::optional<GeomWeight> weight;  ///< MJCF: of a geom that touches nothing
};

/// `<noise>` of what a sensor measures, in the unit of that.
struct Noise {
  Site site;
  Field<double> stddev;
};

struct Camera {
  Site site;
  PoseField pose;           ///< in the sensor's frame
  Field<double> near_clip;  ///< m
  Field<double> far_clip;   ///< m
  Field<double> width;      ///< pixels
  Field<double> height;
  Field<double> horizontal_fov;  ///< rad
  std::vector<Noise> noises;
};

/// `<horizontal>` or `<vertical>` of a lidar's scan.
struct LidarScan {
  Field<double> samples;
  Field<double> resolution;  ///< measurements for each sample
  Field<double> min_angle;   ///< rad
  Field<double> max_angle;
};

struct Lidar {
  Site site;
  Field<double> range_min;  ///< m
  Field<double> range_max;
  LidarScan horizontal;
  LidarScan vertical;
  std::vector<Noise> noises;
};

/// `<force_torque>`.
struct Wrench {
  Field<std::string> frame;  ///< that it is told in: child, parent or sensor
  /// child_to_parent: what the child does to the parent; or parent_to_child.
  Field<std::string> direction;
};

struct Sensor {
  Site site;
  Field<std::string> name;
  Field<std::string> type;
  Id<Link> link;    ///< the link that carries it, or
  Id<Joint> joint;  ///< the joint that does; neither in the <gazebo> of a URDF joint, or of nothing
  PoseField pose;
  Field<double> update_rate;  ///< Hz; 0 means as often as possible
  Field<std::string> topic;
  std::vector<Camera> cameras;
  std::optional<Lidar> lidar;
  Wrench wrench;                                  ///< of a force_torque sensor
  std::vector<Noise> angular_velocity_noises;     ///< of an IMU, of all axes; rad/s
  std::vector<Noise> linear_acceleration_noises;  ///< m/s²
  std::vector<Field<std::string>> contact_collisions;
  /// Those that it names itself, in `<gz_frame_id>`, `<ignition_frame_id>` or `<frame_name>`.
  std::vector<Field<std::string>> frames;
  std::string gazebo_reference;       ///< URDF: the `<gazebo reference>` that it is in
  std::vector<std::string> settings;  ///< the names of its elements but plugins: `imu`, `topic`
};

struct Light {
  Site site;
  Field<std::string> name;
  Field<std::string> type;
  Id<Link> link;  ///< none for a light of the world
  PoseField pose;
  Field<Vector3> direction;        ///< of a directional or spot light, in the light's frame
  Field<double> spot_inner_angle;  ///< rad
  Field<double> spot_outer_angle;
};

enum class JointType : std::uint8_t {
  kUnknown,
  kFixed,
  kRevolute,
  kContinuous,
  kPrismatic,
  kBall,
  kUniversal,
  kRevolute2,
  kScrew,
  kGearbox,
  kFloating,  ///< URDF
  kPlanar,    ///< URDF
};

std::string_view to_string(JointType type);

struct Mimic {
  Site site;
  Field<std::string> joint;
  Field<std::string> axis;  ///< SDF: `axis` or `axis2` of the leader
  Field<double> multiplier;
  Field<double> offset;     ///< rad or m
  Field<double> reference;  ///< SDF: follower = multiplier·(leader - reference) + offset
};

/// MJCF's `springdamper`: in place of a stiffness and a damping.
struct SpringDamper {
  double time_constant = 0;  ///< s
  double damping_ratio = 0;
};

/// `<axis>` or `<axis2>`. Limits in rad (m for a prismatic joint), efforts in N·m (N), speeds in
/// rad/s (m/s).
struct Axis {
  Site site;
  Field<Vector3> xyz;  ///< as written: need not be a unit vector
  /// SDF 1.7: the frame that `xyz` is in; the joint frame when empty. Filled with `__model__` where
  /// 1.4 and older imply it, or `use_parent_model_frame` says it.
  Field<std::string> expressed_in;
  Site limit_site;
  bool limit_written = false;
  Field<double> lower;
  Field<double> upper;
  Field<double> effort;
  Field<double> velocity;
  Field<double> damping;   ///< N·m·s/rad
  Field<double> friction;  ///< N·m
  Field<double> spring_reference;
  Field<double> spring_stiffness;
  Field<double> armature;  ///< MJCF: kg·m² or kg, added along the axis
  std::optional<SpringDamper> spring_damper;
  /// MJCF: what the file calls the position at rest (`ref`). Limits and the spring's reference above
  /// are relative to it, so that zero is at rest as in other formats.
  double position_at_rest = 0;
  std::optional<Mimic> mimic;
};

struct SafetyController {
  Site site;
  Field<double> soft_lower;
  Field<double> soft_upper;
};

struct Joint {
  Site site;
  Field<std::string> name;
  /// What consumers call it where a sibling of another kind has its name (SDF 1.6 and older).
  std::string alias;
  Field<std::string> type_name;
  JointType type = JointType::kUnknown;
  Id<Model> model;  ///< none for a joint of the world (SDF 1.10)
  Id<World> world;
  Field<std::string> parent;  ///< of a link, joint, model or frame; `world`
  Field<std::string> child;
  PoseField pose;              ///< SDF: in the child's frame; URDF: in the parent link's frame
  std::vector<Axis> axes;      ///< at most two
  Field<double> thread_pitch;  ///< of old screws; what it means says `screw_lead` (motion.h)
  Field<double> screw_thread_pitch;  ///< SDF 1.10: m for each turn of a right-handed thread
  Field<double> gearbox_ratio;
  Field<std::string> gearbox_reference;  ///< the link that a gearbox's angles are measured from
  /// ODE solves the spring and damper with the constraints (`<cfm_damping>` in older files).
  bool implicit_spring_damper = false;
  std::optional<SafetyController> safety;  ///< URDF
};

struct Frame {
  Site site;
  Field<std::string> name;
  std::string alias;  ///< as of a joint
  Id<Model> model;    ///< none for a frame of the world
  Id<World> world;
  Field<std::string> attached_to;
  PoseField pose;
};

struct Link {
  Site site;
  Field<std::string> name;
  Id<Model> model;
  PoseField pose;  ///< in the model frame; URDF: follows from the joints
  Inertial inertial;
  Field<bool> kinematic;
  Field<bool> gravity;
  Field<bool> self_collide;  ///< when not written, as the model's
  std::vector<Id<Collision>> collisions;
  std::vector<Id<Visual>> visuals;
  std::vector<Id<Sensor>> sensors;  ///< written in it; not those of a URDF's <gazebo> blocks
  /// MJCF: no body of the file, but what is between two joints of one body. It has no mass.
  bool between_joints = false;
};

struct Plugin {
  Site site;
  Field<std::string> name;
  Field<std::string> filename;
  Id<Model> model;
  Id<World> world;
  Id<Link> link;
  Id<Sensor> sensor;
  std::string gazebo_reference;  ///< URDF: the `<gazebo reference>` it stands in
  Parameters parameters;         ///< what it is given
};

/// `<include>`, whether or not it could be followed.
struct Include {
  Site site;
  Field<std::string> uri;
  Field<std::string> name;
  Field<std::string> placement_frame;
  Field<bool> is_static;
  Field<bool> merge;
  PoseField pose;
  Id<Model> model;   ///< the model it stands in, or
  Id<World> world;   ///< the world
  Id<Model> loaded;  ///< what it brought; none when it failed, or brought a light or an actor
  bool followed = false;
  std::string path;  ///< of the file it led to, when it could be read
};

enum class Format : std::uint8_t { kUnknown, kSdf, kUrdf, kModelConfig, kMjcf };

struct Model {
  Site site;
  Format format = Format::kSdf;  ///< of the file it was read from: decides what frames mean
  int version = 0;               ///< of that file: SDF 1.`version`
  Field<std::string> name;
  Id<Model> parent;
  Id<World> world;
  std::uint32_t include = 0xffffffffU;  ///< index of the include that brought it; else none
  Field<bool> is_static;
  Field<bool> self_collide;
  Field<std::string> canonical_link;
  Field<std::string> placement_frame;
  PoseField pose;
  std::vector<Id<Link>> links;
  std::vector<Id<Joint>> joints;
  std::vector<Id<Frame>> frames;
  std::vector<Id<Model>> models;
  /// Included with merge="true": its parts were moved into the parent, and what is left is a frame of
  /// the parent. Then `name` is that frame's.
  bool merged = false;
  std::vector<Id<Model>> merged_models;  ///< those merged into this one
};

struct Physics {
  Site site;
  Field<std::string> name;
  Field<std::string> type;
  Field<bool> is_default;
  Field<double> max_step_size;  ///< s; up to SDF 1.3 the `dt` of ODE's solver
  Field<double> real_time_factor;
  Id<World> world;
};

/// `<spherical_coordinates>` of a world: where its origin is on the globe.
struct GlobePosition {
  Field<double> latitude;   ///< degrees
  Field<double> longitude;  ///< degrees
};

/// `<model>` in a `<state>` of a world: where a model of that name stands, and how it moves.
struct ModelState {
  Site site;
  Field<std::string> name;
};

/// `<state>` of a world, as Gazebo classic saves it.
struct WorldState {
  std::vector<ModelState> models;
  bool inserts = false;  ///< whether it has `<insertions>`: models that the world does not list
};

struct World {
  Site site;
  Field<std::string> name;
  Field<Vector3> gravity;  ///< m/s²; up to SDF 1.5 that of the `<physics>` that counts
  std::vector<Id<Model>> models;
  std::vector<Id<Joint>> joints;
  std::vector<Id<Frame>> frames;
  std::optional<GlobePosition> globe_position;
  std::vector<WorldState> states;
  std::vector<std::string> names;  ///< of its elements, of whatever kind
};

/// `<trajectory>` of an actor's script.
struct Trajectory {
  Site site;
  Field<std::string> type;           ///< the name of the animation that is played along it
  std::vector<Field<double>> times;  ///< s, of each waypoint
};

struct Actor {
  Site site;
  Field<std::string> name;
  Id<World> world;
  std::vector<Field<std::string>> animations;  ///< their names
  std::vector<Trajectory> trajectories;
};

/// URDF: `<gazebo reference="…">`; an empty reference refers to the whole robot.
struct GazeboBlock {
  Site site;
  Field<std::string> reference;
  Parameters content;  ///< without its plugins and sensors, which are in lists of their own
  bool empty = true;   ///< without those either
};

/// URDF: a joint that a `<transmission>` or `<ros2_control>` names.
struct ControlledJoint {
  Site site;
  Field<std::string> joint;
  bool ros2_control = false;
  Parameters parameters;  ///< its interfaces, and what each is given
};

/// URDF: a `<material>` of the robot, outside any visual.
struct RobotMaterial {
  Site site;
  Field<std::string> name;
  bool defines_color = false;  ///< or a texture
};

/// MJCF: what `<compiler>` makes of all bodies' masses and inertias, in this order.
struct MassSettings {
  bool balance_inertia = false;  ///< moments that break the triangle inequality become their mean
  double bound_mass = 0;         ///< kg; the smallest mass of a body that moves
  double bound_inertia = 0;      ///< kg·m²; the smallest principal moment
  double total_mass = 0;         ///< kg; when above zero, all bodies are scaled to it
};

/// What a file holds, its includes followed.
struct Root {
  Format format = Format::kUnknown;
  int version = 0;                  ///< SDF 1.`version`; URDF likewise
  Field<std::string> version_text;  ///< as written
  SourceId source = kNoSource;      ///< the file itself
  Site site;                        ///< its root element

  std::vector<World> worlds;
  std::vector<Model> models;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Frame> frames;
  std::vector<Collision> collisions;
  std::vector<Visual> visuals;
  std::vector<Sensor> sensors;
  std::vector<Light> lights;
  std::vector<Actor> actors;
  std::vector<Plugin> plugins;
  std::vector<Include> includes;
  std::vector<Physics> physics;
  std::vector<GazeboBlock> gazebo_blocks;
  std::vector<ControlledJoint> controlled_joints;
  Parameters ros2_controls;    ///< URDF: each `<ros2_control>`, with its hardware and components
  Parameters transmissions;    ///< URDF: each `<transmission>`
  MassSettings mass_settings;  ///< MJCF
  Parameters mujoco;           ///< URDF: what MuJoCo is told, in `<mujoco>`
  std::vector<RobotMaterial> materials;
  /// MJCF: why it is not read to its end, and where; then this is not the robot. Not written: all is here.
  Field<std::string> cut;

  const World& operator[](Id<World> id) const { return worlds[id.value]; }
  const Model& operator[](Id<Model> id) const { return models[id.value]; }
  const Link& operator[](Id<Link> id) const { return links[id.value]; }
  const Joint& operator[](Id<Joint> id) const { return joints[id.value]; }
  const Frame& operator[](Id<Frame> id) const { return frames[id.value]; }
  const Collision& operator[](Id<Collision> id) const { return collisions[id.value]; }
  const Visual& operator[](Id<Visual> id) const { return visuals[id.value]; }
  const Sensor& operator[](Id<Sensor> id) const { return sensors[id.value]; }
  const Light& operator[](Id<Light> id) const { return lights[id.value]; }

  /// Whether the entity was written in the file itself, not in one that it includes.
  bool own(const Site& site_of_entity) const { return site_of_entity.span.source == source; }
};

/// Names from the outermost model inward, joined by `::`, as inspect prints them.
std::string scoped_name(const Root& root, Id<Model> id);
std::string scoped_name(const Root& root, Id<Link> id);
std::string scoped_name(const Root& root, Id<Joint> id);
std::string scoped_name(const Root& root, Id<Frame> id);
std::string scoped_name(const Root& root, Id<Collision> id);
std::string scoped_name(const Root& root, Id<Visual> id);

/// A link's name as it is said inside a model that holds it: "hand::palm" in "arm".
std::string name_in(const Root& root, Id<Model> scope, Id<Link> id);

/// Whether the model, or one that it is nested in, is static: its links never move.
bool is_static(const Root& root, Id<Model> id);

}  // namespace rigor::model
