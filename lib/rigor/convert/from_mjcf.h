// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// MJCF to URDF and to SDF: the same robot, or an account of what is not the same.
//
// Bodies are links, joints of a body in a row are joints through links of next to no mass, a body with a
// free joint is a root. A URDF link has the frame of its joint; an SDF link keeps the frame of its body.
// The account is over every element and attribute of the file, of what it includes and of what it attaches.
//
//   FromMjcfConversion result = mjcf_to_sdf({source, lookups, workspace}, {});
//   if (result.sdf) write(sdf_text(*result.sdf));
//   for (const Note& note : result.account.notes) …
//
// | in MJCF                          | in URDF                                | in SDF                   |
// |----------------------------------|----------------------------------------|--------------------------|
// | `hinge`, `slide`                 | revolute, continuous, prismatic        | revolute, prismatic      |
// | `ball`                           | three continuous joints, an error      | ball                     |
// | free joint                       | the root; floating where there are more| a link without a joint   |
// | body without a joint             | fixed joint                            | the same                 |
// | `equality/joint`                 | mimic                                  | mimic, from 1.11 on      |
// | `connect`, `weld`                | lost, an error                         | ball, revolute, fixed    |
// | range of an actuator             | effort                                 | effort                   |
// | geom                             | visual, collision, or both             | the same                 |
// | site                             | lost                                   | frame                    |

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <rigor/convert/ledger.h>
#include <rigor/convert/sdf/robot.h>
#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/convert/urdf_to_sdf.h>
#include <rigor/read/workspace.h>
#include <rigor/robot/robot.h>

namespace rigor::convert {

/// Shapes of the world itself: the floor, walls.
enum class SurroundingsPolicy : std::uint8_t {
  kAuto,  ///< URDF: kept where `world` is the root; SDF: kept
  kDrop,
};

enum class FromMjcfFiles : std::uint8_t { kWritten, kNone };

struct FromMjcfOptions {
  std::string body;  ///< name of one body of the top level; empty: all
  std::string name;  ///< of the result; empty: the file's
  SurroundingsPolicy surroundings = SurroundingsPolicy::kAuto;
  /// kNone: meshes that URDF and SDF cannot name are lost.
  FromMjcfFiles files = FromMjcfFiles::kWritten;
  /// Of these, `mesh_uri`, `unlimited` and `urdf_version`.
  UrdfOptions urdf;
  /// Of these, `mesh_uri` and `version`.
  SdfOptions sdf;
};

struct FromMjcfSource {
  const Source& source;
  const robot::Lookups& lookups;  ///< all of them
  read::Workspace& workspace;     ///< that the file was opened in
};

struct FromMjcfConversion {
  model::Id<model::Model> model;
  /// Nothing when there is none to write: no such body, a reference that is undefined.
  std::optional<UrdfRobot> urdf;
  std::optional<SdfRobot> sdf;
  Account account;
  std::vector<SideFile> files;
  /// What the result should be, in the names of the source.
  robot::Robot robot;
  std::map<std::string, std::string> links;
  std::map<std::string, std::vector<std::string>> joints;
  std::map<std::string, std::string> held_by;  ///< bodies that became frames of another
  /// Links of the result between joints in a row: their mass was taken from the link that the row carries.
  std::vector<std::string> between;
};

FromMjcfConversion mjcf_to_urdf(const FromMjcfSource& source, const FromMjcfOptions& options);
FromMjcfConversion mjcf_to_sdf(const FromMjcfSource& source, const FromMjcfOptions& options);

}  // namespace rigor::convert
