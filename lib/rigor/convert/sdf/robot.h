// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An SDF file of one model as it will be written: plain structs, in the order of the file. Made by
// `urdf_to_sdf`, written by `sdf_text`. Numbers and shapes are those of convert/urdf/robot.h, since they mean
// the same.
//
//   SdfLink link{.name = "arm", .pose = {.relative_to = "elbow"}};
//   robot.parts.push_back(std::move(link));
//   write(sdf_text(robot));

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/convert/urdf/robot.h>

namespace rigor::convert {

/// An element that has no struct of its own: a material, a surface, a solver's parameter.
struct SdfElement {
  std::string name;
  std::string text = {};
  std::vector<SdfElement> children = {};
  std::vector<std::pair<std::string, std::string>> attributes = {};

  /// The text of what stands at `path` ("surface/friction/ode/mu") in it; made where it is missing.
  void set(std::string_view path, std::string value);
};

struct SdfPose {
  std::string relative_to;  ///< empty: SDF's default frame for what it is the pose of
  UrdfOrigin origin;
};

/// A visual or a collision.
struct SdfShape {
  std::string name;
  SdfPose pose;
  UrdfGeometry geometry;                          ///< a mesh's `filename` is its URI
  std::optional<SdfElement> other_geometry = {};  ///< in its place: a shape that URDF lacks
  std::vector<SdfElement> rest = {};
  Remarks comments = {};
};

struct SdfLink {
  std::string name;
  SdfPose pose;
  std::vector<SdfElement> settings = {};  ///< gravity, self_collide, velocity_decay
  std::optional<UrdfInertial> inertial = {};
  std::vector<SdfShape> visuals = {};
  std::vector<SdfShape> collisions = {};
  std::vector<std::string> raw = {};  ///< elements as they are, laid out from level zero
  Remarks comments = {};
};

struct SdfAxis {
  Number3 xyz;
  std::optional<UrdfMimic> mimic = {};
  std::vector<SdfElement> rest = {};  ///< limit, dynamics
};

struct SdfJoint {
  std::string name;
  std::string type;
  std::string parent, child;  ///< names of links or frames; `world`
  SdfPose pose;
  std::optional<SdfAxis> axis = {};
  std::vector<SdfElement> rest = {};  ///< physics
  std::vector<std::string> raw = {};
  Remarks comments = {};
};

struct SdfFrame {
  std::string name;
  std::string attached_to;
  SdfPose pose = {};
  Remarks comments = {};
};

using SdfPart = std::variant<SdfLink, SdfJoint, SdfFrame>;

struct SdfRobot {
  std::string name;
  int version = 9;                   ///< SDF 1.`version`
  std::vector<std::string> head;     ///< lines of the comment at the head
  Remarks comments;                  ///< at the head of the source
  std::vector<SdfElement> settings;  ///< static
  std::vector<SdfPart> parts;    ///< the first link is the one that the model's frame moves with
  std::vector<std::string> raw;  ///< plugins and the like, laid out from level zero
};

/// The file: two spaces a level, poses only where they say something, numbers never "-0" or "inf".
std::string sdf_text(const SdfRobot& robot);

}  // namespace rigor::convert
