// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// SDF to URDF: the same robot, or an account of what is not the same.
//
// The URDF link frame is the SDF joint frame (of the root link: its own), so everything in a link is
// moved by the pose of the SDF link in its joint. Nested models are flattened (`arm::palm` becomes
// `arm__palm`); frames become links on fixed joints, and a frame that is what a conversion from
// URDF leaves of a fixed joint gives its name to that joint; what URDF has no word for rides in `<gazebo>`
// blocks where Gazebo reads it back, and is in the account.
//
//   UrdfConversion result = sdf_to_urdf(source, {});
//   if (result.robot) write(urdf_text(*result.robot));
//   for (const Note& note : result.account.notes) …

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <rigor/convert/ledger.h>
#include <rigor/convert/urdf/robot.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/process/workers.h>
#include <rigor/read/documents.h>
#include <rigor/read/resolver.h>
#include <rigor/schema/schema.h>

namespace rigor::convert {

/// What a mesh's URI becomes.
struct MeshUri {
  enum class Kind : std::uint8_t {
    kPackage,  ///< `model://M/p` → `package://M/p`; relative → `package://` of its model or package
    kFile,  ///< `file:///absolute`
    kKeep,
  };
  Kind kind = Kind::kPackage;
  std::string package;  ///< of kPackage: this name in place of the model's; empty: the model's own
};

enum class LoopPolicy : std::uint8_t { kCut, kComment };
enum class ShapePolicy : std::uint8_t { kLose, kMesh };
/// kBox: a thin box, its face in the plane: of a visual as wide as the plane is drawn, of a collision, which
/// has no end, at least 100 m.
enum class PlanePolicy : std::uint8_t { kLose, kBox };
enum class FramePolicy : std::uint8_t { kLinks, kDrop };
enum class ModelPosePolicy : std::uint8_t { kDrop, kWorldLink };
enum class StaticPolicy : std::uint8_t { kBlock, kWorldLink };
enum class RootPolicy : std::uint8_t { kRefuse, kAddRoot };
enum class LinkFramePolicy : std::uint8_t { kJointFrame, kKeepLinks };

struct UrdfOptions {
  std::string model;  ///< name of one of several; empty: the only one
  MeshUri mesh_uri;
  LoopPolicy loop = LoopPolicy::kCut;
  ShapePolicy shapes = ShapePolicy::kLose;  ///< kMesh: shapes that URDF lacks become mesh files
  PlanePolicy planes = PlanePolicy::kLose;
  FramePolicy frames = FramePolicy::kLinks;
  ModelPosePolicy model_pose = ModelPosePolicy::kDrop;
  StaticPolicy static_model = StaticPolicy::kBlock;
  RootPolicy roots = RootPolicy::kRefuse;
  /// Name of a root without mass that is added where the model's own one would be the root: KDL and
  /// robot_state_publisher want none with an inertia. It stands at the model's frame. Empty: none.
  std::string root;
  LinkFramePolicy link_frames = LinkFramePolicy::kJointFrame;
  double unlimited = 1e16;  ///< represents an infinite limit, effort or velocity
  int urdf_version = 0;     ///< URDF 1.`urdf_version`: from 1 on there are capsules
};

/// What a conversion reads from; all of it outlives the conversion.
struct Source {
  const model::Root& root;
  const model::Frames& frames;
  const read::Documents& documents;
  const read::Resolver& resolver;
  const schema::Schema& schema;  ///< of the source's format
  const process::Workers& workers;
  std::string path;      ///< of the file
  std::string out = {};  ///< where the result will stand; empty: not known
  /// What relative paths are seen from; empty: not known.
  std::string working_folder = {};
};

/// A mesh file that represents a shape: to be written beside the output.
struct SideFile {
  std::string name;
  std::string bytes;
};

struct UrdfConversion {
  model::Id<model::Model> model;  ///< that was converted
  /// Nothing when there is none to write: no model, several roots, a reference that is undefined.
  std::optional<UrdfRobot> robot;
  Account account;
  std::vector<SideFile> files;
  /// SDF name (scoped inside the model) → URDF name; of a joint that was substituted, per axis.
  std::map<std::string, std::string> links;
  std::map<std::string, std::vector<std::string>> joints;
  bool from_world = false;  ///< the root is the world, and the model's pose is in the joints there
};

UrdfConversion sdf_to_urdf(const Source& source, const UrdfOptions& options);

}  // namespace rigor::convert
