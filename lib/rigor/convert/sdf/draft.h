// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An SDF model in the making; private to the room. `sdf_tree` decides what each link becomes and what
// everything is called; then links, joints and blocks are converted part by part, and `urdf_to_sdf` puts
// them in their order.

#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <rigor/convert/ledger.h>
#include <rigor/convert/plugin_text.h>
#include <rigor/convert/sdf/robot.h>
#include <rigor/convert/urdf_to_sdf.h>
#include <rigor/model/model.h>

namespace rigor::convert {

/// The first version of SDF that has `<mimic>`, and what is written where nothing newer is needed: the
/// last one that Gazebo Fortress reads.
inline constexpr int kMimicVersion = 11;
inline constexpr int kPlainVersion = 9;

/// What a URDF link becomes.
struct SdfNode {
  enum class Role : std::uint8_t {
    kLink,
    kFrame,  ///< of `holder`
    kWorld,  ///< the link `world`, which holds nothing
  };
  Role role = Role::kLink;
  std::string name;                 ///< in SDF
  model::Id<model::Joint> carrier;  ///< none of the root
  model::Id<model::Link> parent;    ///< that the carrier hangs on
  model::Id<model::Link> holder;  ///< the link that holds its shapes: itself, unless it is a frame
  std::vector<model::Id<model::Link>> held = {};  ///< whose holder it is, in the tree's order
  bool carried_by_frame = false;  ///< no joint: it is placed in its parent, which is its frame
};

struct SdfTree {
  std::vector<SdfNode> nodes;  ///< by link
  std::vector<model::Id<model::Link>>
      order;                             ///< a parent before its children, joints in file order
  std::vector<std::string> joint_names;  ///< in SDF, by joint
};

struct SdfDraft {
  const Source& source;
  const SdfOptions& options;
  Ledger& ledger;
  SdfTree tree;
  SdfRobot robot;                             ///< without its parts
  std::vector<std::optional<SdfLink>> links;  ///< by link
  std::vector<std::vector<SdfPart>> joints;   ///< by joint; several parts for a planar one
  std::unordered_map<std::string_view, xml::Element> materials;  ///< what defines each name
  std::set<std::string, std::less<>> used_materials;             ///< that a visual names
  double next_to_nothing = 0;     ///< kg, of a link that must have mass
  PluginNames plugin_names = {};  ///< what plugins have to say otherwise (gazebo.cc)
  /// Joints that were seen to follow none in a ring.
  std::unordered_set<std::uint32_t> not_in_ring = {};

  const SdfNode& node(model::Id<model::Link> id) const { return tree.nodes[id.value]; }
  /// The one that a joint became, of several the one that turns; null when it became none.
  SdfJoint* joint(model::Id<model::Joint> id);
};

/// No inertial, or one without mass.
bool is_massless(const model::Link& link);

/// As SDF takes it: without `::`, which is a scope there, and the dunder of names that are SDF's own.
std::string sdf_name(std::string_view name);

/// The tree, when the links and joints are one; else notes say why not.
std::optional<SdfTree> sdf_tree(const Source& source, const SdfOptions& options, Ledger& ledger);

/// `<origin>` with its author's digits.
UrdfOrigin urdf_written_origin(const read::Documents& documents, const model::PoseField& pose);

/// Fills `links` (link.cc): inertials, visuals, collisions.
void add_sdf_links(SdfDraft& draft);

/// Inertial of a link with no mass of its own that SDF needs as a link (inertial.cc).
UrdfInertial next_to_nothing(const SdfDraft& draft);
/// The pose of a link in the one that holds what it held.
model::Pose pose_in_holder(const SdfDraft& draft, model::Id<model::Link> id);
/// Takes the inertials of all that a link holds.
std::optional<UrdfInertial> sdf_inertial(SdfDraft& draft, model::Id<model::Link> id);

/// The parts that a joint becomes (joint.cc).
std::vector<SdfPart> sdf_joint(SdfDraft& draft, model::Id<model::Joint> id);

/// What `<gazebo>` blocks say, where it belongs (gazebo.cc).
void add_gazebo_blocks(SdfDraft& draft);

/// By the options' policy (uri.cc); takes the URI and notes a change and one that does not exist.
std::string sdf_uri(SdfDraft& draft, const model::Field<std::string>& uri,
                    const std::string& subject);

}  // namespace rigor::convert
