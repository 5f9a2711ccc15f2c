// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// URDF to SDF: the same robot, or an account of what is not the same.
//
// Each joint stands where its origin says, relative to its parent link, and each link in its joint, so
// that every number keeps its author's digits. No mass is lost and none is made up: SDF would give a
// link without an inertial 1 kg, so one that is fixed to another becomes a frame of it, by the same
// name, and one that moves gets next to nothing. The joint that fixed it becomes a frame, too: a plugin that
// names it is in the account.
//
// What `<gazebo>` blocks hold is written as libsdformat reads it. SDF with its values in attributes,
// `<update_rate value="30"/>`, is empty to libsdformat, so it is lost.
//
//   SdfConversion result = urdf_to_sdf(source, {});
//   if (result.robot) write(sdf_text(*result.robot));
//   for (const Note& note : result.account.notes) …

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <rigor/convert/ledger.h>
#include <rigor/convert/sdf/robot.h>
#include <rigor/convert/sdf_to_urdf.h>

namespace rigor::convert {

/// What a mesh's URI becomes.
struct SdfMeshUri {
  enum class Kind : std::uint8_t {
    kModel,    ///< `package://P/p` → `model://P/p`
    kPackage,  ///< `model://M/p` → `package://M/p`
    kFile,     ///< `file:///absolute`, of what is found
    kKeep,
  };
  Kind kind = Kind::kModel;
  std::string name;  ///< of kModel and kPackage: in place of the package's; empty: its own
};

enum class FixedPolicy : std::uint8_t {
  kKeep,
  kLump,  ///< links on fixed joints become frames of what carries them, which takes their mass and
          ///< shapes; `preserveFixedJoint` keeps one
};

/// A link without mass that is fixed to another.
enum class MasslessPolicy : std::uint8_t {
  kLink,   ///< becomes a frame, unless it has shapes: then it stays a link, with next to no mass
  kFrame,  ///< becomes a frame in any case; its shapes are held by what carries it
};

/// An inertia tensor that no rigid body can have, which libsdformat rejects.
enum class InertiaPolicy : std::uint8_t {
  kKeep,
  kNearest,  ///< the nearest that a rigid body can have
};

/// Transmissions, and plugins of Gazebo classic that drive joints.
enum class ControlPolicy : std::uint8_t {
  kKeep,         ///< plugins as they are; transmissions are lost
  kRos2Control,  ///< a `<ros2_control>` block and controllers in files beside the result
  kGz,           ///< plugins of Gazebo Sim
};

struct SdfOptions {
  SdfMeshUri mesh_uri;
  FixedPolicy fixed = FixedPolicy::kKeep;
  MasslessPolicy massless = MasslessPolicy::kLink;
  ControlPolicy control = ControlPolicy::kKeep;
  InertiaPolicy inertia = InertiaPolicy::kKeep;
  /// SDF 1.`version`; 0: 1.9, or 1.11, the first that has them, where joints mimic others.
  int version = 0;
};

struct SdfConversion {
  /// Nothing when there is none to write: no robot, no tree, a joint that is undefined.
  std::optional<SdfRobot> robot;
  Account account;
  std::vector<SideFile> files;
  /// URDF name → SDF name; a planar joint has three.
  std::map<std::string, std::string> links;
  std::map<std::string, std::vector<std::string>> joints;
  /// URDF name of each link that became a frame → that of the link that holds what it held.
  std::map<std::string, std::string> held_by;
};

SdfConversion urdf_to_sdf(const Source& source, const SdfOptions& options);

}  // namespace rigor::convert
