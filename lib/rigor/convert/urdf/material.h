// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A visual's look as URDF's one color. Private to the room.
//
// Gazebo shows 0.4 ambient + 0.8 diffuse of a material in its default light; that is the color, with
// the opacity of the diffuse one times what the visual's transparency leaves. Where only one of the
// two is written, or both are the same, it is that color itself: this is how a URDF color is expressed in
// SDF, so that it comes back unchanged. A material of Gazebo's own script is looked up by its name.
//
//   visual.material = urdf_material(draft, source_visual, {});

#pragma once

#include <string>

#include <rigor/convert/urdf/draft.h>
#include <rigor/model/id.h>
#include <rigor/model/model.h>

namespace rigor::convert {

/// The script's material that a visual names; empty for none.
std::string script_name(const Source& source, const model::Visual& visual);

/// The script's material that all visuals of a link name, when it is one of Gazebo's own: a
/// `<gazebo>` block can name it. Empty otherwise.
std::string common_script(const Source& source, const model::Link& link);

/// Takes the material and the visual's transparency, notes what is lost of them, adds the color to
/// the robot's materials, and gives its name; empty when there is no color. `in_block` is the
/// `common_script` of the link.
std::string urdf_material(UrdfDraft& draft, const model::Visual& visual,
                          const std::string& in_block);

}  // namespace rigor::convert
