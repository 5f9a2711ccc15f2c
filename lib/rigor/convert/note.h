// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What became of a part of the source that the target could not take as it stands, as data; a row of the
// tables in `rules/convert/` turns each kind into words and gives it a severity.
//
//   notes.push_back({.kind = NoteKind::kEffortStandIn, .outcome = Outcome::kRewritten,
//                    .where = axis.effort.span, .subject = subject(root, joint), .written = "-1",
//                    .instead = "1e16"});

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <rigor/text/span.h>

namespace rigor::convert {

/// What became of an element or attribute of the source. Each has exactly one of these.
enum class Outcome : std::uint8_t {
  kConverted,    ///< the target says the same in its own words
  kImplied,      ///< says what the target takes by default: a default
  kRewritten,    ///< exact, but expressed otherwise: a revolute joint without limits is continuous
  kCarried,      ///< kept as it is in a place that only some consumers read: a `<gazebo>` block
  kSubstituted,  ///< something else represents it
  kLost,
};

enum class NoteKind : std::uint8_t {
  // The file as a whole.
  kSeveralModels,  ///< and none was chosen; `written` names them
  kNoModel,
  kWorld,       ///< what a world holds beside the model
  kUnresolved,  ///< a reference or an include that does not exist: nothing can be converted
  // The graph.
  kSeveralRoots,
  kRootAdded,      ///< one root for several trees, because it was asked for
  kNoRoot,         ///< a cycle
  kLoop,           ///< a second parent: the joint is cut
  kDanglingJoint,  ///< parent or child is missing, or the child is the world
  kWorldLink,      ///< parent `world`: a link of that name is added
  kStatic,
  kNested,   ///< a nested model's names were joined to the parent's
  kRenamed,  ///< `written` → `instead`
  kModelPose,
  kRootPose,
  kLinkFrame,  ///< the link's frame is not at its joint
  kFrame,
  // Joints.
  kJointType,  ///< a type that the target lacks; `instead` says what represents it
  kJointTypeLost,
  kJointDialect,  ///< a type that one consumer's URDF has, which SDF has as `instead`
  kContinuous,
  kLimitStandIn,
  kEffortStandIn,
  kVelocityStandIn,
  kLimitInverted,
  kSpring,
  kStiffness,
  kAxisUnit,
  kAxisZero,
  kSecondAxis,
  kMimicReference,
  kMimicLost,
  kGimbal,
  kPhysics,  ///< of the joint: solver parameters that no block can hold
  // Links.
  kInertialDefault,
  kInertialAutomatic,
  kMassless,        ///< URDF: no mass; SDF would take 1 kg
  kMasslessMoving,  ///< the same of one on a joint that moves
  kSurface,
  kLinkPhysics,        ///< kinematic, wind, damping, buoyancy
  kInertiaIncomplete,  ///< entries of the tensor are missing: `written` names them
  kBareInertia,        ///< an inertia without a mass, which is added to that of link `instead`
  kInertiaNearest,     ///< principal moments `written` of no rigid body, kg·m², became `instead`
  kTinyMass,           ///< `written` kg: Gazebo's reader of URDF takes it for none
  kSelfCollide,
  kGravity,
  // Shapes and looks.
  kShape,  ///< a shape that the target lacks; `instead` says what represents it
  kShapeLost,
  kCollisionLost,  ///< the same of a collision: what the robot touches
  kSubmesh,
  kMaterialScript,
  kMaterialLook,  ///< textures, pbr, emissive, lighting, transparency
  kVisualExtra,   ///< shadows, layers, visibility flags, laser_retro
  kUri,
  kUriNotFound,
  // What rides along.
  kSensor,
  kLight,
  kPlugin,
  kPluginReference,  ///< `written`, a name or a place in a plugin, is `instead` in the result
  kPluginFrame,      ///< numbers in a plugin that may be meant in a frame that moved
  kSafety,
  kCalibration,
  kTransmission,
  kRos2Control,
  kControl,  ///< `written`, a transmission or plugin, became `instead`
  kTexture,
  kBlockReference,  ///< a `<gazebo reference>` that names nothing
  kBlockWithoutCollision,
  kComment,
  kUnknown,  ///< no rule of the conversion knows it
  // What the proof says of the result.
  kNotTheSame,  ///< read again, it is another robot; `written` is how
  kRefused,     ///< the official parser does not take it; `written` is what it says
  kRefusedSdf,  ///< nor libsdformat an SDF; `written` is the rule's finding on the result
  kDangling,    ///< a reference of the result that is undefined; `written` is the rule's finding
  // What is the same robot all the same.
  kIdle,          ///< no reader of the source takes it
  kTurned,        ///< a joint whose parent became its child, since the child has another parent
  kMimicChain,    ///< `written`, that it followed, follows `instead`
  kUriElsewhere,  ///< found from the source, but not from where the result will stand
  // What was added.
  kLinkBetween,  ///< `count` links between joints in a row, of `instead` each
  // MJCF.
  kMjcfVelocity,      ///< of a joint: MuJoCo has no velocity limits
  kMjcfModelPose,     ///< of a model: its bodies have it
  kMjcfJointType,     ///< several joints of one body, as `instead` says
  kMjcfEffort,        ///< of a joint that `instead`, and so has no actuator
  kMjcfFixedJoint,    ///< its name: MJCF has no joints that do not move
  kMjcfLocked,        ///< both limits are `written`: an equality holds the joint there
  kMjcfLoop,          ///< a joint that closes a loop is `instead`
  kMjcfMassless,      ///< a link that moves and has no mass weighs `instead`
  kMjcfInertia,       ///< principal moments that no rigid body has; the nearest are `instead`
  kMjcfInertiaMoved,  ///< the same of a link on a fixed joint: `instead` says where it is
  kMjcfContact,       ///< of a surface: `written` is lost, or is `instead`
  kMjcfMesh,          ///< `written` is a mesh, or is another one
  kMjcfMeshMissing,   ///< the file does not exist, or cannot be read
  kMjcfLook,          ///< colors and textures
  kMjcfSensor,        ///< became `instead`
  kMjcfWorld,         ///< what a world holds beside its models
  kMjcfDepth,         ///< more than `written` bodies hang on each other
  kMjcfLost,          ///< an element that MJCF has nothing for
  // From MJCF. `written` is an element and its attribute, as "geom/@solref", unless another thing is said.
  kFromMjcfBodies,  ///< a recipe for bodies that the result lacks
  kFromMjcfTendon,
  kFromMjcfEquality,
  kFromMjcfActuator,
  kFromMjcfSensor,
  kFromMjcfContact,
  kFromMjcfLook,  ///< lights, cameras, textures
  kFromMjcfSite,
  kFromMjcfDynamics,  ///< of a joint: armature, the limit's softness
  kFromMjcfSetting,   ///< of the solver, keyframes, statistics
  kFromMjcfOther,
  kFromMjcfLoop,      ///< `written`, "connect" or "weld", closes a loop
  kFromMjcfMimic,     ///< `written` are coefficients of more than a line
  kFromMjcfWorld,     ///< `count` shapes of the world are left out
  kFromMjcfLeftOut,   ///< bodies that were not asked for: `count` of them
  kFromMjcfRoot,      ///< `written` is the pose of the free root that URDF has no place for
  kFromMjcfFree,      ///< a free body that is none of the root's is `instead`
  kFromMjcfMassless,  ///< a body between joints, or without mass, weighs `instead`
  kFromMjcfLimit,     ///< the range of a ball: `written`
  kFromMjcfRenamed,   ///< `written`, a joint → `instead`
  kFromMjcfGravity,   ///< `written`, m/s²: it is the world's
};

struct Note {
  NoteKind kind = NoteKind::kUnknown;
  Outcome outcome = Outcome::kLost;
  Span where;               ///< of the element, attribute or value in the source
  std::string subject;      ///< as in a diagnostic
  std::string written;      ///< what the source says, in short: a value, a name, "universal"
  std::string instead;      ///< what the target says; empty when it says nothing
  std::size_t count = 1;    ///< elements and attributes that it refers to
  std::string target = {};  ///< "URDF", "SDF" or "MJCF", in the account of a finished conversion
};

using Notes = std::vector<Note>;

}  // namespace rigor::convert
