// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is found wrong in an MJCF file beyond its schema, as data; a rule of the category `mjcf` turns each
// kind into words.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/text/span.h>

namespace rigor::read {

enum class MjcfFactKind : std::uint8_t {
  kIncludeMissing,       ///< `name` is the file
  kIncludeRepeated,      ///< the file was included before; MuJoCo takes each once
  kIncludeBroken,        ///< not well-formed, or without a root; `detail` says why
  kClassMissing,         ///< no default class `name`
  kClassRepeated,        ///< two default classes are called `name`
  kNameRepeated,         ///< two of one `detail` (body, joint, geom, …) are called `name`
  kReferenceMissing,     ///< no `detail` (joint, body, site, …) is called `name`
  kAssetMissing,         ///< the file `name` of a mesh, height field or texture does not exist
  kMeshEmpty,            ///< the mesh `name` has neither file, vertices nor shape
  kMeshScaleZero,        ///< `name` is the mesh
  kShapeRejected,        ///< a geom or site cannot be what `detail` says
  kMeshMissingName,      ///< a geom of the type `name` names no mesh or height field
  kRangeInverted,        ///< of the attribute `name`: the first number is not below the second
  kRangeIgnored,         ///< limited="false", or autolimits is off: the range `name` has no effect
  kLimitedWithoutRange,  ///< limited="true" and no range
  kAttributeMissing,     ///< an element `name` lacks `detail`: "site or camera"
  kSizeMissing,  ///< the shape `name` lacks a size, or one is not positive; `detail` is what it needs
  kOrientationTwice,    ///< more than one of quat, axisangle, xyaxes, zaxis and euler
  kOrientationZero,     ///< the quaternion or axis `name` has no length
  kAxisZero,            ///< of a hinge or slide
  kInertialIncomplete,  ///< no inertia, or both diaginertia and fullinertia; `detail` says which
  kInertiaRejected,     ///< `detail` says what MuJoCo rejects it for
  kMassMissing,         ///< a body moves and has neither mass nor inertia
  kFreeJointNested,     ///< a free joint of a body that is not a child of the world
  kFreeJointNotAlone,   ///< a free joint beside another joint
  kTooManyJoints,       ///< more than six degrees of freedom in a body
  kMocapNotStatic,      ///< a mocap body with joints, or not a child of the world
  kControlRange,        ///< an adhesion or damper, `name`, without a control range from 0 up
  kTendonPath,          ///< the tendon `name`: `detail` says why it cannot be
  kActuatorNoTarget,    ///< no joint, tendon, site or body
  kActuatorTwoTargets,  ///< more than one
  kActuatorNoEffect,    ///< `detail` says why: a gear or gain of zero, a range of no width
  kNeverTouches,        ///< contype and conaffinity meet no other geom's
  kKeyframeShort,       ///< the same, with too few: newer versions fill them up
  kKeyframeSize,        ///< `name` is the attribute; `detail` "7 numbers, 9 expected"
  kNotExpanded,         ///< composite or flexcomp: rigor does not make its bodies
  kFitNotMade,          ///< a primitive that is fitted to a mesh: rigor takes the mesh itself
  kGlobalCoordinates,   ///< coordinate="global", which MuJoCo dropped in 2.3.4
  kReplicateCount,      ///< it is less than 1
  kFlexFile,            ///< the file `name` of a flexcomp is missing; `detail` says in what way
  kFlexSurface,     ///< the file `name` of a flexcomp, an OBJ at the path `detail`, must have faces
  kFlexLines,       ///< the same, and lines do as well
  kFlexSolid,       ///< the same, and it is one of GMSH
  kFlexIntegrator,  ///< a soft flex and an integrator that cannot: `detail` says which
  kAttachConflict,  ///< `detail` says which option of an attached model conflicts
  kPartAlone,       ///< no worldbody, so that the `detail` called `name` does not exist
  kPluginNeeded,    ///< `name` is the plugin
  kTooLarge,        ///< it is not read to its end; `detail` says of what there is too much
  kWorldPart,       ///< a joint or inertial of the world: `name` is the element
  kRangeUnlimited,  ///< as kRangeIgnored, and rejected: autolimits is off, and limited not written
  kValueRejected,   ///< `name` is the attribute; `detail` what it must be
  kTargetRejected,  ///< `detail` says what the element cannot refer to
  kExcludes,        ///< `name`, an attribute, is written beside `detail`, another
  kMeshSheared,     ///< the mesh `name` is rotated by refquat before an uneven scale
  kGravity,         ///< `detail` says what is odd: it points up
  kTimestep,        ///< likewise
  kNegative,        ///< `name` is the attribute, `detail` its value
  kRefOutside,      ///< of a joint: `detail` are both
  kColor,           ///< a component of the color `detail` is over 1
  kDegrees,         ///< `name` is read in radians and looks like degrees: `detail`
  kSolver,          ///< `name` is solref or solimp; `detail` what becomes of it
  kKeyframeState,   ///< `detail` says what is odd: a position out of its joint's range
};

struct MjcfFact {
  MjcfFactKind kind;
  Span where;
  std::string subject = {};  ///< "joint elbow"; empty when the place says it
  std::string name = {};
  std::string detail = {};
  std::string path = {};                     ///< where a missing file would be
  std::vector<std::string> candidates = {};  ///< names that there are, of a missing one
  Span related = {};
};

using MjcfFacts = std::vector<MjcfFact>;

}  // namespace rigor::read
