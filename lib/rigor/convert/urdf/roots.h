// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the one root of a URDF will be. Private to the room.

#pragma once

#include <cstdint>

#include <rigor/convert/note.h>
#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/convert/urdf/tree.h>
#include <rigor/model/model.h>
#include <rigor/model/pose.h>

namespace rigor::convert {

struct UrdfRoots {
  enum class Kind : std::uint8_t {
    kNone,   ///< there are several, and nothing joins them
    kLink,   ///< the one link that nothing carries
    kWorld,  ///< a link named `world`; links that nothing carries are fixed to it
    kAdded,  ///< a link made for them; they are fixed to it
  };
  Kind kind = Kind::kNone;
  bool is_static = false;  ///< whether links are fixed to the world because the model is static
  bool has_model_pose = false;  ///< whether the root's frame is the world's, not the model's
};

UrdfRoots urdf_roots(const Source& source, const UrdfOptions& options, const UrdfTree& tree);

/// On the links that nothing carries, where they are too many or none.
Note note_on_roots(const Source& source, const UrdfTree& tree);

Note note_on(const Source& source, const UrdfTree& tree, const UrdfTree::LeftOut& left_out);

}  // namespace rigor::convert
