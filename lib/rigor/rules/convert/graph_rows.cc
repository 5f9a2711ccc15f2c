// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The graph of links and joints, and their frames.

#include <span>

#include <rigor/rules/convert/rows.h>

namespace rigor::rules::conversion {

using convert::NoteKind;

std::span<const Row> graph_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"convert-several-roots", NoteKind::kSeveralRoots, Severity::kError},
       .message = "{count} links are the child of no joint: {written}; a URDF has one root",
       .summary = "the links form several trees",
       .why = "A URDF robot is one tree: urdfdom rejects a file with two roots. Joining them would "
              "invent a joint that the model does not have.",
       .what_to_do = "Add the joint that is missing, or convert with `--roots add`, which fixes "
                     "all of them to one new root."},
      {.rule = {"convert-root-added", NoteKind::kRootAdded, Severity::kWarning},
       .message =
           "{count} links are the child of no joint ({written}): all are fixed to one root now",
       .summary = "several trees were fixed to one new root",
       .why = "A URDF robot is one tree. What was free to move apart is now one rigid base.",
       .what_to_do = "Mind it wherever the robot is simulated."},
      {.rule = {"convert-no-root", NoteKind::kNoRoot, Severity::kError},
       .message = "the joints form a cycle without a root: {written}",
       .summary = "the joints form a cycle without a root",
       .why = "Every link is the child of some joint, so none can be the root that a URDF begins "
              "with.",
       .what_to_do = "Remove one joint of the cycle."},
      {.rule = {"convert-loop", NoteKind::kLoop, Severity::kError},
       .message = "closes a loop: {written} already is a child of {instead}; URDF has trees only, "
                  "so this joint is cut",
       .summary = "a link has a second parent, and its joint is cut",
       .why = "URDF has trees only: urdfdom rejects a link with two parents or does not return. "
              "Without the joint the mechanism moves differently: a closed gripper opens, a "
              "parallel leg falls apart.",
       .what_to_do = "Close the loop in the simulator (a constraint, a mimic joint), or accept the "
                     "cut with `--allow-loss`."},
      {.rule = {"convert-dangling-joint", NoteKind::kDanglingJoint, Severity::kError},
       .message = "connects nothing: {written}",
       .summary = "a joint has no link at one end",
       .why = "Its parent or child names nothing, or the child is the world. No consumer can build "
              "the joint.",
       .what_to_do = "Name two links of the model; the parent may be `world`."},
      {.rule = {"convert-world-link", NoteKind::kWorldLink, Severity::kInfo},
       .message = "is a child of the world: in URDF that is a massless link named world",
       .summary = "the robot is fixed to a link named world",
       .why = "In SDF a joint may have the world as its parent. By habit URDF has a massless link "
              "of that name, which ROS tools know.",
       .what_to_do = "Nothing: the robot is the same."},
      {.rule = {"convert-static", NoteKind::kStatic, Severity::kInfo},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty() ? "static {whereabouts}" : "static becomes {instead}";
           },
       .summary = "that a model never moves is reported in another way",
       .why = "URDF has no element for a static model. A fixed joint to a link named world means "
              "the same; only Gazebo reads a `<gazebo>` block.",
       .what_to_do = "Nothing, or fix it to the world for all: `--static world-link`."},
      {.rule = {"convert-nested", NoteKind::kNested, Severity::kInfo},
       .message = "nested model {written} was flattened: its parts are named {instead}",
       .summary = "a nested model was flattened",
       .why = "URDF has no models in models: their links and joints become the robot's own, with "
              "the model's name in front.",
       .what_to_do =
           "Use the new names in controllers and launch files; `--report json:FILE` has the map."},
      {.rule = {"convert-renamed", NoteKind::kRenamed, Severity::kInfo},
       .message = "{written} is named {instead} in the result",
       .summary = "a name was changed",
       .why = "The target does not allow the name: it is already used for something else, or "
              "reserved.",
       .what_to_do =
           "Use the new name in controllers and launch files; `--report json:FILE` has the map."},
      {.rule = {"convert-model-pose", NoteKind::kModelPose, Severity::kWarning, Formats::kSdf},
       .message =
           "the model's pose ({written}) is not in the robot: give it where the robot is spawned",
       .summary = "the model's pose in the world is not in the robot",
       .why = "A model's pose or placement frame places it in a world. URDF describes the robot "
              "alone, from its root link on.",
       .what_to_do = "Spawn the robot at that pose, or write it into the file with `--model-pose "
                     "world-link`."},
      {.rule = {"convert-root-pose", NoteKind::kRootPose, Severity::kInfo, Formats::kSdf},
       .message = "the root link is at {written} in the model; the robot's frame is the link's",
       .summary = "the root link is not at the model's origin",
       .why = "URDF has no place for the pose of the root link: the robot's frame is the root "
              "link's. All links keep their places relative to each other.",
       .what_to_do = "Move the link to the model's origin when the offset matters."},
      {.rule = {"convert-link-frame", NoteKind::kLinkFrame, Severity::kInfo, Formats::kSdf},
       .message = "the link's frame moves to its joint, by {written}",
       .summary = "a link's frame moves to its joint",
       .why = "In URDF a link's frame is that of its joint. What the link holds is moved the other "
              "way, so that nothing moves; only the frame by the link's name is elsewhere.",
       .what_to_do = "Where code asks for the old frame, convert with `--keep-link-frames`: it "
                     "stays as a link of its own."},
      {.rule = {"convert-frame", NoteKind::kFrame, Severity::kInfo, Formats::kSdf},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty() ? "the frame is left out" : "the frame becomes {instead}";
           },
       .summary = "a frame becomes a link on a fixed joint, or is left out",
       .why = "URDF has no element for frames. A massless link on a fixed joint is what ROS tools "
              "read as a frame.",
       .what_to_do = "Nothing, or leave them out with `--frames drop`."},
      {.rule = {"convert-joint-swapped", NoteKind::kTurned, Severity::kInfo, Formats::kSdf},
       .message =
           "the joint is reversed, since {written} has another parent: {instead}, the axis negated",
       .summary = "parent and child of a joint are swapped",
       .why = "A link of URDF has one parent. In SDF two joints may lead to one link and still "
              "close no loop; with parent and child swapped and the axis negated, the joint's "
              "positions mean what they meant.",
       .what_to_do = "Nothing; or swap parent and child in the source."},
      {.rule = {"convert-link-between", NoteKind::kLinkBetween, Severity::kInfo},
       .message =
           [](const convert::Note& note) {
             return note.count == 1 ? "a link was added between joints in a row, of {instead}; "
                                      "what they carry is so much lighter"
                                    : "{count} links were added between joints in a row, {instead} "
                                      "each; what they carry is so much lighter";
           },
       .summary = "nearly massless links are between joints in series",
       .why =
           "Several joints in place of one need links between them. Simulators do not move a link "
           "without mass: MuJoCo rejects such a file, and Gazebo drops the link and its subtree. "
           "So each is a sphere of two milligrams where the axes meet, and the mass of the child "
           "link is reduced by as much: together they are the same body at all joint positions.",
       .what_to_do = "Nothing, as long as the solver works in reduced coordinates."},
  };
  return kRows;
}

}  // namespace rigor::rules::conversion
