// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is other in MJCF than in SDF and URDF.

#include <span>

#include <rigor/rules/convert/rows.h>

namespace rigor::rules::conversion {

using convert::NoteKind;

std::span<const Row> mjcf_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"convert-mjcf-velocity", NoteKind::kMjcfVelocity, Severity::kInfo},
       .message = "velocity limit {written} is lost: MuJoCo limits no velocities",
       .summary = "MuJoCo has no velocity limits",
       .why = "MuJoCo limits positions and efforts. A joint goes as fast as its actuator drives "
              "it.",
       .what_to_do = "Limit the velocity in the controller, or use `--actuators velocity`, whose "
                     "control range is the velocity limit."},
      {.rule = {"convert-mjcf-model-pose", NoteKind::kMjcfModelPose, Severity::kInfo,
                Formats::kSdf},
       .message = "the model's pose is in those of its bodies",
       .summary = "MJCF has no pose of a model",
       .why =
           "Bodies of the top level are placed in the world; the model around them has no frame.",
       .what_to_do = "Nothing: the robot stands where it stood."},
      {.rule = {"convert-mjcf-joint-type", NoteKind::kMjcfJointType, Severity::kInfo},
       .message = "the {written} joint is {instead}",
       .summary = "a joint of a type that MuJoCo lacks is several joints, or an equality",
       .why =
           "MuJoCo's joints are hinges, slides, balls and free joints; a body has as many of them "
           "as it takes, and a gearbox couples two.",
       .what_to_do = "Use the names of the result for actuators and sensors: the first has the "
                     "joint's own."},
      {.rule = {"convert-mjcf-effort", NoteKind::kMjcfEffort, Severity::kInfo},
       .message = "effort limit {written} is lost: the joint {instead}, and has no actuator",
       .summary = "a joint without an actuator has no effort limit",
       .why = "MuJoCo limits the efforts of actuators. A joint that follows another one, or cannot "
              "move, is held by an equality constraint and has none.",
       .what_to_do = "Nothing, unless a motor drives this joint: then remove `<mimic>`."},
      {.rule = {"convert-mjcf-fixed-joint", NoteKind::kMjcfFixedJoint, Severity::kInfo},
       .message = "the fixed joint has no name in the result",
       .summary = "MJCF has no fixed joints",
       .why = "A body without a joint is fixed to its parent. The link keeps its name; the joint's "
              "is nowhere.",
       .what_to_do = "Refer to the body where something referred to the joint."},
      {.rule = {"convert-mjcf-locked", NoteKind::kMjcfLocked, Severity::kInfo},
       .message = "both limits are {written}: an equality holds the joint there",
       .summary = "a joint whose limits are equal cannot move",
       .why = "MuJoCo rejects a range whose ends are equal. An equality constraint holds the joint "
              "at that position.",
       .what_to_do = "Nothing; or make the joint fixed, or write the limits that were meant."},
      {.rule = {"convert-mjcf-loop", NoteKind::kMjcfLoop, Severity::kInfo},
       .message = "closes a loop: the {written} joint is {instead}",
       .summary = "a joint that closes a loop becomes an equality constraint",
       .why = "MuJoCo's bodies form a tree; loops are closed by soft constraints between bodies. "
              "Limits, damping and effort of the joint are not in them.",
       .what_to_do = "Choose the joint that closes the loop so that it has no motor; tune "
                     "`solref` of the equality where the loop is too soft."},
      {.rule = {"convert-mjcf-massless", NoteKind::kMjcfMassless, Severity::kWarning},
       .message = "has no mass but moves: it weighs {instead}",
       .summary = "MuJoCo rejects a moving body without mass",
       .why = "MuJoCo divides by the mass of what moves, and rejects a body that has none, with "
              "the whole model. Next to nothing keeps the robot's mass, but the link shakes under "
              "contact.",
       .what_to_do = "Write the inertial that the link really has: `rigor inertia MODEL --diff` "
                     "computes it from the shapes."},
      {.rule = {"convert-mjcf-inertia", NoteKind::kMjcfInertia, Severity::kError},
       .message = "no rigid body has the principal moments {written} kg·m²: with --allow-loss "
                  "{instead} is written",
       .summary = "MuJoCo rejects an inertia that no rigid body can have",
       .why = "MuJoCo rejects a model with an inertia whose moments violate the triangle "
              "inequality or are negative. The nearest possible inertia is another robot.",
       .what_to_do = "Correct the source: `rigor inertia MODEL --diff` computes it from the "
                     "shapes; `--allow-loss` writes the nearest possible inertia."},
      {.rule = {"convert-mjcf-inertia-moved", NoteKind::kMjcfInertiaMoved, Severity::kInfo},
       .message = "no rigid body has the principal moments {written} kg·m²: {instead}",
       .summary = "an impossible inertia of a link on a fixed joint is in another body",
       .why = "MuJoCo rejects a model with an inertia that no rigid body can have, even of a body "
              "that is fixed to another one. Both move as one, so the sum is the same robot.",
       .what_to_do =
           "Nothing for MuJoCo; `rigor inertia MODEL --diff` computes what it should be."},
      {.rule = {"convert-mjcf-contact", NoteKind::kMjcfContact, Severity::kInfo},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty() ? "{written} is lost: MuJoCo's contact is another model"
                                         : "{written} {instead}";
           },
       .summary = "a contact parameter has no counterpart in MuJoCo",
       .why = "MuJoCo's contact is soft, by `solref` and `solimp` relative to the effective mass, "
              "and has one coefficient for all sliding directions. Stiffness in N/m, slip and "
              "bitmasks have no counterpart.",
       .what_to_do = "Tune `solref`, `solimp` and `friction` of the geoms that matter."},
      {.rule = {"convert-mjcf-mesh", NoteKind::kMjcfMesh, Severity::kInfo},
       .message = "{written} {instead}",
       .summary = "a shape or mesh is another mesh in MuJoCo",
       .why = "MuJoCo has neither cones nor extruded outlines, rejects meshes without volume, and "
              "collides with the convex hull of a mesh.",
       .what_to_do = "Nothing where the shape is convex; else split it: `rigor mesh-check FILE "
                     "--convex-pieces 8 -o OUT`."},
      {.rule = {"convert-mjcf-mesh-missing", NoteKind::kMjcfMeshMissing, Severity::kWarning},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty() ? "mesh {written} is not found: the shape is left out"
                                         : "mesh {written} {instead}: the shape is left out";
           },
       .summary = "a mesh file does not exist, so its shape is left out",
       .why = "MuJoCo rejects a model with a mesh that it cannot read. The robot moves the same "
              "without the shape, but touches nothing with it.",
       .what_to_do = "Make the file known: `--model-path DIR` or `--package NAME=DIR`."},
      {.rule = {"convert-mjcf-look", NoteKind::kMjcfLook, Severity::kInfo},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty() ? "{written} is lost" : "{written} becomes {instead}";
           },
       .summary = "colors or textures are others in the result",
       .why = "MuJoCo has a color and a texture for each geom, and reads PNG. Lighting and "
              "physically based materials are the renderer's own.",
       .what_to_do = "Look at the result; give a geom an `rgba` or a `material` where the looks "
                     "matter."},
      {.rule = {"convert-mjcf-sensor", NoteKind::kMjcfSensor, Severity::kInfo},
       .message = "sensor {written} becomes {instead}; rate, noise and topic are lost",
       .summary = "a sensor becomes MuJoCo's own",
       .why = "MuJoCo computes what its sensors measure in each step, without noise and without "
              "a transport.",
       .what_to_do = "Set rate and noise where the measurements are used."},
      {.rule = {"convert-mjcf-world", NoteKind::kMjcfWorld, Severity::kInfo, Formats::kSdf},
       .message = "{written} of the world is not converted",
       .summary = "content of the world beside its models is not in the result",
       .why = "The models of a world are converted, and its gravity. Lights, physics engines and "
              "plugins are the simulator's; `scene.xml` has a light.",
       .what_to_do = "Add what matters to `scene.xml`."},
      {.rule = {"convert-mjcf-depth", NoteKind::kMjcfDepth, Severity::kError},
       .message = "more than {written} bodies hang on each other, which readers of XML reject",
       .summary = "the kinematic tree is too deep for MJCF",
       .why = "MJCF nests bodies, and MuJoCo's reader of XML stops at 100 levels.",
       .what_to_do = "Lump links on fixed joints: `--fixed lump`."},
      {.rule = {"convert-mjcf-not-carried", NoteKind::kMjcfLost, Severity::kInfo},
       .message = "{written} is not in the result: MJCF has no counterpart",
       .summary = "MJCF has no counterpart of an element",
       .why = "The robot's bodies, joints, shapes and drives are in the result. What MuJoCo has "
              "nothing for is lost.",
       .what_to_do = "Look whether the simulation needs it."},
  };
  return kRows;
}

}  // namespace rigor::rules::conversion
