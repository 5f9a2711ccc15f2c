// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The tree in a model's graph of links and joints: which joint carries which link, and which joints
// are left out. Nested models are part of it. Private to the room.
//
//   UrdfTree tree = urdf_tree(root, frames, model);
//   if (tree.roots.size() + tree.on_world > 1) …   // several trees

#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/model/model.h>

namespace rigor::convert {

struct UrdfTree {
  /// A joint that carries its child, which no other does.
  struct Edge {
    model::Id<model::Joint> joint;
    model::Id<model::Link> parent;  ///< none: the world
    model::Id<model::Link> child;
    bool turned = false;  ///< the file has parent and child the other way round
  };
  enum class Flaw : std::uint8_t {
    kDangling,      ///< an end is missing, is the world, or both are one
    kSecondParent,  ///< `carrier` carries the child already
    kCycle,         ///< the child carries the parent, and nothing carries the child
  };
  struct LeftOut {
    model::Id<model::Joint> joint;
    Flaw flaw;
    model::Id<model::Joint> carrier;
  };

  std::vector<model::Id<model::Model>>
      models;                                 ///< the model first, then those in it, in file order
  std::vector<model::Id<model::Link>> links;  ///< in file order, as all that follows
  std::vector<model::Id<model::Frame>> frames;
  std::vector<Edge> edges;
  std::vector<LeftOut> left_out;
  std::vector<model::Id<model::Joint>> gearboxes;  ///< which couple joints and carry nothing
  std::vector<model::Id<model::Link>> roots;       ///< that neither a joint nor the world carries
  bool on_world = false;                           ///< whether a joint's parent is the world
  /// Frames that are a fixed joint of URDF, by the frame on it: libsdformat and rigor write a link
  /// without mass as `<frame name="camera_joint">` and, next to it, `<frame name="camera"
  /// attached_to="camera_joint"/>`.
  std::map<model::Id<model::Frame>, model::Id<model::Frame>> fixed_by;
  /// The joint that carries a link, by the link's id; none for roots and other models' links.
  std::vector<model::Id<model::Joint>> carriers;
};

/// Names that joints have as their ends, or that things are placed in, by the model that says so.
using ReferredNames = std::set<std::pair<std::uint32_t, std::string_view>>;
ReferredNames referred_names(const model::Root& root);

/// Whether a frame may be what is left of a joint: by a name that holds "joint", or, where it stands next
/// to what it belongs to, as a conversion writes it, and nothing refers to it, by any name but those of links:
/// `camera_link`, `optical_frame`.
bool may_be_joint(const model::Frame& frame, bool is_next_to, const ReferredNames& referred);

UrdfTree urdf_tree(const model::Root& root, const model::Frames& frames,
                   model::Id<model::Model> model);

}  // namespace rigor::convert
