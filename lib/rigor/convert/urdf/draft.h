// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A URDF robot in the making; private to the room. `sdf_to_urdf` decides on the tree, the names and the
// joints (urdf_tree, urdf_joint); what a link holds is converted here, part by part.

#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <rigor/convert/ledger.h>
#include <rigor/convert/plugin_text.h>
#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/convert/urdf/robot.h>

namespace rigor::convert {

struct UrdfDraft {
  const Source& source;
  const UrdfOptions& options;
  Ledger& ledger;
  UrdfRobot robot;
  std::vector<SideFile> files;
  std::map<model::Id<model::Link>, std::string> link_names;  ///< of all links that are converted
  std::map<model::Id<model::Joint>, std::string> joint_names;
  model::Id<model::Model> top;  ///< that is converted
  PluginNames plugin_names;     ///< what plugins have to say otherwise
  /// Joints in a row that represent one.
  struct Row {
    std::vector<std::size_t> links;  ///< between them, of `robot.links`
    model::Id<model::Link> carried;  ///< by the last one
  };
  std::vector<Row> rows;

  // What was met so far, so that equals are reported once.
  std::map<std::array<double, 4>, std::string> material_names;  ///< by red, green, blue and opacity
  std::map<std::string, int> color_names;                       ///< how many are named after a link
  std::map<std::string, std::string> file_names;                ///< of `files`, by what they hold
  /// What a link or joint carries and the model does not list with it; filled when first needed.
  struct Riders {
    std::multimap<model::Id<model::Link>, model::Id<model::Light>> lights;
    std::multimap<model::Id<model::Joint>, model::Id<model::Sensor>> sensors;
  };
  std::optional<Riders> riders;
  std::map<model::Id<model::Model>, model::Field<bool>> self_collide;  ///< as models say it
};

/// What a link holds (link.cc): inertial, visuals, collisions; its `<gazebo>` blocks (friction,
/// sensors, plugins, gravity) are added to the draft. `X_JL` is the pose of the SDF link in the URDF
/// link frame; where it is the identity the author's digits are carried through.
UrdfLink urdf_link(UrdfDraft& draft, model::Id<model::Link> link, const model::Pose& X_JL);

/// What a model says of itself as a whole (block.cc): plugins, static. Of this model alone, not
/// of those nested in it or merged into it.
void add_model_blocks(UrdfDraft& draft, model::Id<model::Model> model);

/// What a joint says that only a block can hold (block.cc): provide_feedback, stop cfm and erp,
/// implicit_spring_damper, springs; sensors of the joint; preserveFixedJoint of a fixed one.
/// `name` is the joint's in URDF.
void add_joint_blocks(UrdfDraft& draft, model::Id<model::Joint> joint, const std::string& name);

/// What no code took says only what a URDF reader takes by default (implied.cc): the
/// schema's own default, an identity pose, an empty container.
bool is_implied(const schema::Schema& schema, xml::Element element);
bool is_implied(const schema::Schema& schema, xml::Element element, xml::Attribute attribute);
bool is_implied(const Source& source, const model::Site& opened, xml::Element element);
bool is_implied(const Source& source, xml::Element element, xml::Attribute attribute);
/// The note for an element that no code took, by its name and where it stands.
NoteKind kind_of(xml::Element element);

}  // namespace rigor::convert
