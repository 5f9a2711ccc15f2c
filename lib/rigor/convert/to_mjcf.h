// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// SDF and URDF to MJCF: the same robot, or an account of what is not the same.
//
// The result is laid out as MuJoCo Menagerie is: bodies nested by the kinematic tree, `assets/` beside
// the file, `scene.xml` with ground and light. A body's frame is the frame of the joint that carries it,
// so a joint stands at the origin of its body; a link that nothing carries is free, unless the model is
// static. Models of a world become one file; where there are several, names begin with the model's.
// What is written loads in MuJoCo 2.2.2 and in later ones.
//
//   MjcfConversion result = to_mjcf({source, lookups}, {});
//   if (result.root) write(mjcf_text(*result.root));
//   for (const Note& note : result.account.notes) …
//
// | of the source                 | in MJCF                                                        |
// |-------------------------------|----------------------------------------------------------------|
// | revolute, prismatic           | `hinge`, `slide`; `range` where the file has limits             |
// | universal, revolute2, planar  | two or three joints of one body, in their order                |
// | ball, floating                | `ball`, `freejoint`                                            |
// | spherical, of Bullet's URDF   | `ball`                                                         |
// | screw                         | `hinge` and `slide`, coupled by an `equality`                  |
// | mimic                         | `equality/joint`, follower = offset + multiplier · leader      |
// | a joint that closes a loop    | `connect` (two for a hinge), `weld`                            |
// | effort                        | the range of the joint's `actuator`                             |
// | damping, friction, spring     | `damping`, `frictionloss`, `stiffness` and `springref`         |
// | tensor                        | `diaginertia` about the principal axes; what a URDF's lacks is 0 |
// | a material, a texture         | `rgba`; `material` and `texture`, a PNG in `assets/`            |
// | a mesh of several materials   | one mesh and geom for each, as STL, or as OBJ with a texture    |

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/convert/ledger.h>
#include <rigor/convert/mjcf/element.h>
#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/robot/look.h>
#include <rigor/robot/robot.h>

namespace rigor::convert {

/// What drives a joint that has an effort limit, or that a transmission or `<ros2_control>` names.
enum class MjcfActuators : std::uint8_t {
  kMotor,     ///< control is the effort, N·m or N
  kPosition,  ///< control is the position; full effort at kFullEffortError
  kVelocity,  ///< control is the velocity; full effort at a tenth of the velocity limit
  kNone,
};

/// kLump: links on fixed joints become part of the body that they are fixed to.
enum class MjcfFixed : std::uint8_t { kKeep, kLump };

/// Whether links of one model collide with each other.
enum class MjcfSelfCollision : std::uint8_t {
  kSource,  ///< as `<self_collide>`, which is false where it is not written
  kAll,     ///< all but neighbors, as MuJoCo has it by default
};

/// kWorld: a root is fixed to the world and does not fall.
enum class MjcfBase : std::uint8_t { kFree, kWorld };

/// kNone: meshes are named as if they were there, and no scene is made.
enum class MjcfFiles : std::uint8_t { kWritten, kNone };

struct MjcfOptions {
  std::string model;  ///< name of one of several; empty: all of the file
  MjcfActuators actuators = MjcfActuators::kMotor;
  MjcfFixed fixed = MjcfFixed::kKeep;
  MjcfSelfCollision self_collision = MjcfSelfCollision::kSource;
  MjcfBase base = MjcfBase::kFree;
  MjcfFiles files = MjcfFiles::kWritten;
  double armature = 0;  ///< kg·m² of a hinge, kg of a slide: what the file has no word for
  std::string file = "robot.xml";  ///< name of the result, which `scene.xml` includes
  /// rad or m, of joints in the keyframe `home`; of others 0, or the limit next to it.
  std::map<std::string, double> home = {};
  /// Links that are not checked against each other, as an SRDF has them.
  std::vector<std::pair<std::string, std::string>> excluded = {};
  robot::FindLooks looks = {};  ///< without it materials are the colors of `Lookups::color_of`
};

/// The error at which a position actuator gives its full effort, rad or m.
inline constexpr double kFullEffortError = 0.1;

struct MjcfSource {
  const Source& source;
  const robot::Lookups& lookups;  ///< all of them
};

struct MjcfConversion {
  std::vector<model::Id<model::Model>> models;  ///< that were converted
  /// Nothing when there is none to write.
  std::optional<MjcfElement> root;
  Account account;
  std::vector<SideFile> files;  ///< `scene.xml`, `assets/…`
  /// What the result should be, seen from the world.
  robot::Robot robot;
  std::map<std::string, std::string> links;
  std::map<std::string, std::vector<std::string>> joints;  ///< of several degrees: a name for each
  std::map<std::string, std::string> held_by;              ///< links that became part of another
};

MjcfConversion to_mjcf(const MjcfSource& source, const MjcfOptions& options);

}  // namespace rigor::convert
