// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Shapes and looks.

#include <span>

#include <rigor/rules/convert/rows.h>

namespace rigor::rules::conversion {

using convert::NoteKind;

constexpr const char* kShapeLost = "{target} has no {written}: the shape is left out";
constexpr const char* kCollisionLost = "{target} has no {written}: the collision is left out";

/// The target has meshes and boxes: what is left out of them has a reason of its own.
const char* lost_shape(const convert::Note& note, const char* if_unknown_to_target) {
  if (!note.instead.empty()) return "the {written} is left out, as it has no mesh: {instead}";
  if (note.written == "mesh") return "the mesh is left out: {target} needs it as a file";
  if (note.written == "none") return "the <geometry> is left out: it has no shape that is known";
  const bool says_why = note.written.starts_with("mesh") || note.written.ends_with(" of no size");
  return says_why ? "the {written} is left out" : if_unknown_to_target;
}

std::span<const Row> shape_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"convert-shape", NoteKind::kShape, Severity::kWarning},
       .message = "{target} has no {written}: {instead}",
       .summary = "substituted shape: the target lacks the original",
       .why = "URDF 1.0 has boxes, cylinders, spheres and meshes. A capsule is exactly a cylinder "
              "and two spheres; other shapes become mesh files.",
       .what_to_do = "Nothing where the substitute is exact; else choose a shape that both have."},
      {.rule = {"convert-shape-lost", NoteKind::kShapeLost, Severity::kWarning},
       .message = [](const convert::Note& note) { return lost_shape(note, kShapeLost); },
       .summary = "a shape that the target lacks is left out",
       .why = "The link loses what it collides or is seen with. A robot that lost a collision "
              "falls through things.",
       .what_to_do = "Convert with `--shapes mesh`, which writes mesh files, or choose a shape "
                     "that both formats have."},
      {.rule = {"convert-collision-lost", NoteKind::kCollisionLost, Severity::kError},
       .message = [](const convert::Note& note) { return lost_shape(note, kCollisionLost); },
       .summary = "a collision whose shape the target lacks is left out",
       .why =
           "What the robot touches and is touched by is another: it falls through the ground, or "
           "an arm plans through it.",
       .what_to_do =
           "Write to a file with `-o`: shapes that enclose a solid become mesh files beside it; "
           "for a plane choose `--plane box`. `--allow-loss` leaves the collision out."},
      {.rule = {"convert-submesh", NoteKind::kSubmesh, Severity::kWarning, Formats::kSdf},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty() ? "{written} is left out: URDF takes meshes whole"
                                         : "{written} becomes {instead}";
           },
       .summary = "a part of a mesh file",
       .why = "URDF uses whole mesh files. A submesh cannot be selected by name.",
       .what_to_do = "Write the part to a file of its own: `rigor mesh-check FILE --split material "
                     "-o PART`."},
      {.rule = {"convert-material-script", NoteKind::kMaterialScript, Severity::kInfo,
                Formats::kSdf},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty() ? "material script {written} is lost"
                                         : "material script {written} becomes {instead}";
           },
       .summary = "a material script becomes its color",
       .why = "URDF has colors and textures. Gazebo's own scripts have known colors, which are "
              "written; of other scripts only the name can be carried.",
       .what_to_do = "Nothing, or write the color into the visual."},
      {.rule = {"convert-material-look", NoteKind::kMaterialLook, Severity::kInfo},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty() ? "{written} of the material is lost"
                                         : "{written} of the material becomes {instead}";
           },
       .summary = "some of how a visual looks is lost",
       .why = "The target has one color or texture a visual: textures of a pbr material, emission, "
              "highlights and shaders have no place.",
       .what_to_do = "Put the look into the mesh file, which both formats take."},
      {.rule = {"convert-visual-extra", NoteKind::kVisualExtra, Severity::kInfo, Formats::kSdf},
       .message = "{written} is lost: URDF has no word for it",
       .summary = "renderer parameters of a visual are lost",
       .why = "Shadows, layers, visibility flags and retro-reflection have no place in URDF.",
       .what_to_do = "Set them in the simulator where they matter."},
      {.rule = {"convert-texture", NoteKind::kTexture, Severity::kWarning, Formats::kUrdf},
       .message = "the texture is lost: SDF 1.9 lays none over a shape",
       .summary = "a texture is lost",
       .why = "URDF lays an image over a shape; SDF 1.9 does that only through a material of "
              "physically based rendering.",
       .what_to_do = "Put the texture into a mesh file."},
      {.rule = {"convert-uri", NoteKind::kUri, Severity::kInfo},
       .message =
           [](const convert::Note& note) {
             return note.written == note.instead ? "{written} is kept as it is"
                                                 : "{written} becomes {instead}";
           },
       .summary = "a mesh is named in the target's own way",
       .why = "ROS tools find meshes by `package://`, Gazebo by `model://`, MuJoCo in a folder "
              "beside the file.",
       .what_to_do = "Choose with `--mesh-uri package://NAME`, `file` or `keep`; for MuJoCo, leave "
                     "the meshes in `assets/`."},
      {.rule = {"convert-uri-not-found", NoteKind::kUriNotFound, Severity::kWarning},
       .message = "{written} is found nowhere; it is written as {instead}",
       .summary = "a mesh that cannot be found",
       .why = "The file was not found, so the result names it as the source does, unchecked.",
       .what_to_do = "Say where to search: `--model-path DIR` or `--package NAME=DIR`."},
      {.rule = {"convert-uri-elsewhere", NoteKind::kUriElsewhere, Severity::kWarning},
       .message = "{instead} is not found from the folder of the result: make its package known "
                  "there, or choose --mesh-uri file",
       .summary = "a mesh is not found from the folder of the result",
       .why = "The name of a ROS package is found wherever the package is known, so it is kept; "
              "but no package.xml near the result locates it.",
       .what_to_do = "Source the package's workspace, or give rigor `--package NAME=DIR`; write "
                     "the result inside the package; or choose `--mesh-uri file`."},
  };
  return kRows;
}

}  // namespace rigor::rules::conversion
