// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Links.

#include <span>

#include <rigor/rules/convert/rows.h>

namespace rigor::rules::conversion {

using convert::NoteKind;

std::span<const Row> link_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"convert-inertial-default", NoteKind::kInertialDefault, Severity::kWarning,
                Formats::kSdf},
       .message = "no inertial: SDF means 1 kg and 1 kg·m², which is written out",
       .summary = "a link without an inertial weighs 1 kg in SDF",
       .why = "SDF gives such a link 1 kg and an inertia of 1 kg·m²; in URDF it would weigh "
              "nothing, and Gazebo would take it and all below it away. The default is written "
              "out, so the robot is the same, but it is hardly what was meant.",
       .what_to_do = "Write the real inertial: `rigor inertia MODEL --write`."},
      {.rule = {"convert-inertial-automatic", NoteKind::kInertialAutomatic, Severity::kInfo,
                Formats::kSdf},
       .message = "auto inertial: {instead} is written",
       .summary = "a computed inertial is written out",
       .why = "SDF 1.11 can leave the inertial to the simulator; URDF wants numbers. They are "
              "computed from the collisions as the simulator would.",
       .what_to_do = "Nothing: the inertial is the same."},
      {.rule = {"convert-massless", NoteKind::kMassless, Severity::kInfo, Formats::kUrdf},
       .message = "weighs nothing: {instead}",
       .summary = "a link without mass",
       .why = "In URDF a link without an inertial weighs nothing and mostly serves as a frame; SDF "
              "would give it 1 kg, and the official converter drops it with all links below it.",
       .what_to_do = "Nothing, or write the inertial that the link really has."},
      {.rule = {"convert-massless-moving", NoteKind::kMasslessMoving, Severity::kWarning,
                Formats::kUrdf},
       .message = "has no mass but moves: it becomes {instead}",
       .summary = "a moving link without mass",
       .why =
           "A solver divides by the mass of what moves: Gazebo needs one, SDF would give the link "
           "1 kg, and the official converter drops it with all links below it. Next to nothing "
           "keeps the robot's mass, but shakes or explodes under contact or force.",
       .what_to_do = "Write the inertial that the link really has: `rigor inertia MODEL --diff` "
                     "computes it from the shapes."},
      {.rule = {"convert-inertia-incomplete", NoteKind::kInertiaIncomplete, Severity::kError,
                Formats::kUrdf},
       .message = "the inertia has no {written}: with --allow-loss it is {instead}",
       .summary = "an inertia lacks some of its six entries",
       .why = "urdfdom, and with it ROS and Gazebo, rejects a robot whose inertia lacks an entry; "
              "Bullet and others take 0.",
       .what_to_do = "Write all six entries, 0 where the link is symmetric."},
      {.rule = {"convert-inertia-without-mass", NoteKind::kBareInertia, Severity::kWarning,
                Formats::kUrdf},
       .message = "the inertia of a link without mass is added to that of link {instead}",
       .summary = "an inertia without a mass moves to another link",
       .why = "A link without mass becomes a frame of the link that it is fixed to. Its inertia is "
              "still there in URDF, so the robot keeps it, in that link.",
       .what_to_do = "Remove the inertia, or write the mass that belongs to it."},
      {.rule = {"convert-inertia-nearest", NoteKind::kInertiaNearest, Severity::kWarning,
                Formats::kUrdf},
       .message =
           "no rigid body has the principal moments {written} kg·m²: the nearest are written, "
           "{instead}",
       .summary = "an impossible inertia is replaced by the nearest possible one",
       .why = "libsdformat rejects an inertia that no rigid body can have, and with it the model. "
              "The principal axes are kept, and no mass distribution has a tensor nearer to the "
              "one in the source; it is still not the real one.",
       .what_to_do =
           "Correct the source: `rigor inertia MODEL --diff` computes it from the shapes."},
      {.rule = {"convert-mass-tiny", NoteKind::kTinyMass, Severity::kWarning, Formats::kSdf},
       .message = "the mass {written} kg counts as none where Gazebo reads the URDF: the link and "
                  "its subtree are dropped",
       .summary = "Gazebo drops a link of this mass when it reads URDF",
       .why =
           "libsdformat takes a mass of up to 1e-6 kg in URDF for 0 and leaves out the link, with "
           "all links below it unless it is fixed; in SDF it takes the same mass as it is.",
       .what_to_do = "Write the mass that the link really has, or give Gazebo the SDF."},
      {.rule = {"convert-surface", NoteKind::kSurface, Severity::kWarning},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty() ? "{written} is lost" : "{written} {instead}";
           },
       .summary = "contact properties are not all in the robot",
       .why = "URDF has no friction and no contact. A `<gazebo>` block holds one set for a whole "
              "link, so what differs between its collisions, and what the block has no key for, is "
              "lost.",
       .what_to_do = "Give all collisions of a link one surface, or set it in the simulator."},
      {.rule = {"convert-link-physics", NoteKind::kLinkPhysics, Severity::kWarning, Formats::kSdf},
       .message =
           [](const convert::Note& note) {
             return note.outcome == convert::Outcome::kLost
                        ? "{written} {whereabouts}: URDF has no word for it"
                        : "{written} {whereabouts}";
           },
       .summary = "engine parameters of a link are not in the robot",
       .why = "Damping of a link's velocity, wind, kinematic motion, batteries, added mass: URDF "
              "has no word for them. A `<gazebo>` block carries the damping, which Gazebo reads.",
       .what_to_do = "Set them in the simulator where they matter."},
      {.rule = {"convert-self-collide", NoteKind::kSelfCollide, Severity::kInfo},
       .message = "self_collide {whereabouts}",
       .summary = "self-collision is for Gazebo only",
       .why = "URDF itself has no setting for collisions between links of the robot; Gazebo reads "
              "it from a `<gazebo>` block.",
       .what_to_do = "Tell planners in their own file (SRDF)."},
      {.rule = {"convert-gravity", NoteKind::kGravity, Severity::kInfo},
       .message = "no gravity: this {whereabouts}",
       .summary = "a link without gravity is so for Gazebo only",
       .why = "URDF itself cannot turn off gravity for a link; Gazebo reads it from a `<gazebo>` "
              "block.",
       .what_to_do = "Mind it wherever the robot is simulated otherwise."},
  };
  return kRows;
}

}  // namespace rigor::rules::conversion
