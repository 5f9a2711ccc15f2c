// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What of MJCF has no counterpart in SDF and URDF.

#include <span>

#include <rigor/rules/convert/rows.h>

namespace rigor::rules::conversion {

using convert::NoteKind;

std::span<const Row> from_mjcf_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"convert-from-mjcf-bodies", NoteKind::kFromMjcfBodies, Severity::kError,
                Formats::kMjcf},
       .message = "{written} makes bodies that the result lacks",
       .summary = "a composite or flexible body is not converted",
       .why =
           "`composite`, `flexcomp` and `deformable` are recipes by which MuJoCo's compiler makes "
           "bodies and soft surfaces. Neither SDF nor URDF has any, so the result is another "
           "robot.",
       .what_to_do = "Let MuJoCo write the compiled model (`mj_saveLastXML`) and convert that, or "
                     "remove the element; `--allow-loss` leaves it out."},
      {.rule = {"convert-from-mjcf-tendon", NoteKind::kFromMjcfTendon, Severity::kWarning,
                Formats::kMjcf},
       .message = "{written} is lost: tendons couple and drive joints in MuJoCo only",
       .summary = "tendons are lost",
       .why = "A tendon couples the joints that it runs along, limits them and drives them. SDF "
              "and URDF "
              "have no such element: the joints of the result are independent.",
       .what_to_do =
           "Where a fixed tendon couples two joints, write an `equality` of these joints, which "
           "becomes a mimic."},
      {.rule = {"convert-from-mjcf-equality", NoteKind::kFromMjcfEquality, Severity::kWarning,
                Formats::kMjcf},
       .message = "{written} is lost: the constraint is not in the result",
       .summary = "an equality constraint is lost",
       .why = "Couplings of joints become mimics, and `connect` and `weld` between bodies become "
              "joints in "
              "SDF. Of others, of those that are not active, and of how soft they are, the result "
              "says "
              "nothing.",
       .what_to_do = "Check whether the robot needs the constraint."},
      {.rule = {"convert-from-mjcf-actuator", NoteKind::kFromMjcfActuator, Severity::kInfo,
                Formats::kMjcf},
       .message =
           [](const convert::Note& note) {
             return note.written.find('@') == note.written.npos && note.instead.empty()
                        ? "{written} is lost: it gives no joint an effort limit"
                        : "{written} is lost: only the effort limit of an actuator is in the "
                          "result";
           },
       .summary = "an actuator becomes the effort limit of its joint",
       .why = "SDF and URDF describe what drives a joint by plugins and controllers. Ranges of "
              "forces and "
              "controls become the effort limit; gains, dynamics and what drives tendons and sites "
              "do not.",
       .what_to_do = "Add a controller: ros2_control, or a plugin of Gazebo."},
      {.rule = {"convert-from-mjcf-sensor", NoteKind::kFromMjcfSensor, Severity::kInfo,
                Formats::kMjcf},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty() ? "{written} is lost" : "{written} becomes {instead}";
           },
       .summary = "a sensor of MuJoCo is lost, or becomes another",
       .why = "An accelerometer and a gyro of one site become an imu in SDF, force and torque a "
              "force_torque sensor. Most other sensors of MuJoCo report its state, which other "
              "simulators "
              "publish by themselves.",
       .what_to_do = "Add the sensor to the result where it is needed."},
      {.rule = {"convert-from-mjcf-contact", NoteKind::kFromMjcfContact, Severity::kInfo,
                Formats::kMjcf},
       .message = "{written} is lost: MuJoCo's contact is another model",
       .summary = "a contact parameter of MuJoCo is lost",
       .why = "MuJoCo's contact is soft, by `solref` and `solimp` relative to the effective mass, "
              "and pairs "
              "of geoms are chosen and excluded by name. SDF and URDF have no counterpart; the "
              "coefficient "
              "of sliding friction is in an SDF result.",
       .what_to_do = "For pairs that must not touch, make an SRDF: `rigor srdf`."},
      {.rule = {"convert-from-mjcf-look", NoteKind::kFromMjcfLook, Severity::kInfo, Formats::kMjcf},
       .message = "{written} is lost",
       .summary = "lights, textures and view settings are lost",
       .why = "Colors are in the result. Textures, reflectance, lights and what MuJoCo's viewer is "
              "told are "
              "not.",
       .what_to_do =
           "Nothing for the robot's motion; give meshes textures where the looks matter."},
      {.rule = {"convert-from-mjcf-site", NoteKind::kFromMjcfSite, Severity::kInfo, Formats::kMjcf},
       .message = "{written} is lost",
       .summary = "a site is lost",
       .why =
           "URDF has no frames but those of links, and SDF none for the size and color of a site.",
       .what_to_do = "Where a frame is needed in URDF, make the site a body without joints."},
      {.rule = {"convert-from-mjcf-dynamics", NoteKind::kFromMjcfDynamics, Severity::kInfo,
                Formats::kMjcf},
       .message = "{written} is lost: the target has no such property of a joint",
       .summary = "a property of a joint is lost",
       .why =
           "SDF and URDF have damping, friction and limits of a joint, but no inertia of a rotor "
           "(`armature`) and no softness of limits.",
       .what_to_do =
           "A gearbox with a large `armature` swings more slowly in MuJoCo than the result does: "
           "tune controllers anew."},
      {.rule = {"convert-from-mjcf-setting", NoteKind::kFromMjcfSetting, Severity::kInfo,
                Formats::kMjcf},
       .message = "{written} is lost",
       .summary = "settings of the simulation and keyframes are lost",
       .why = "Time step, solver, gravity, keyframes, custom data and extensions are MuJoCo's, not "
              "the "
              "robot's.",
       .what_to_do =
           "Set step and gravity in the world that the model is loaded into; an SRDF holds poses "
           "by name (`rigor srdf`)."},
      {.rule = {"convert-from-mjcf-not-carried", NoteKind::kFromMjcfOther, Severity::kInfo,
                Formats::kMjcf},
       .message = "{written} is not in the result",
       .summary = "the target has no counterpart of an element",
       .why = "The robot's bodies, joints, shapes and limits are in the result. What the target "
              "has nothing "
              "for is lost.",
       .what_to_do = "Check whether the robot needs it."},
      {.rule = {"convert-from-mjcf-loop", NoteKind::kFromMjcfLoop, Severity::kError,
                Formats::kMjcf},
       .message = "a {written} closes a loop, which URDF has no joint for",
       .summary = "a loop is cut open",
       .why = "A URDF is a tree: each link is the child of one joint. Without the constraint the "
              "mechanism "
              "falls apart.",
       .what_to_do =
           "Convert to SDF with `rigor mjcf2sdf`, which keeps the loop; `--allow-loss` cuts it."},
      {.rule = {"convert-from-mjcf-mimic", NoteKind::kFromMjcfMimic, Severity::kWarning,
                Formats::kMjcf},
       .message = "the joint follows a polynomial ({written}): the result has its tangent at rest",
       .summary = "a polynomial coupling of joints becomes a linear one",
       .why = "MuJoCo couples joints by a polynomial of degree four; a mimic is a line. Away from "
              "rest the "
              "joint is elsewhere.",
       .what_to_do = "Check the poses that matter, or drive the joint by a controller."},
      {.rule = {"convert-from-mjcf-world", NoteKind::kFromMjcfWorld, Severity::kInfo,
                Formats::kMjcf},
       .message = "{written} of the world is left out",
       .summary = "shapes of the world are not in the result",
       .why = "The result is the robot. Floor and walls are the world's, and a URDF whose root is "
              "free has no "
              "place for them.",
       .what_to_do = "Add ground and obstacles to the world that the robot is loaded into."},
      {.rule = {"convert-from-mjcf-left-out", NoteKind::kFromMjcfLeftOut, Severity::kInfo,
                Formats::kMjcf},
       .message = "{written} is left out: --model names another one",
       .summary = "a body that was not asked for is left out",
       .why = "`--model NAME` converts one body of the top level with all that it carries.",
       .what_to_do = "Nothing; without `--model` all bodies are converted."},
      {.rule = {"convert-from-mjcf-root", NoteKind::kFromMjcfRoot, Severity::kInfo, Formats::kMjcf},
       .message = "the pose of the root ({written}) is lost",
       .summary = "URDF has no place for the pose of a free root",
       .why = "A URDF says nothing of where the robot stands; who spawns it does.",
       .what_to_do = "Spawn the robot at that pose."},
      {.rule = {"convert-from-mjcf-free", NoteKind::kFromMjcfFree, Severity::kInfo, Formats::kMjcf},
       .message = "a free body becomes {instead}",
       .summary = "a free body among others becomes a floating joint",
       .why = "A URDF has one root. Where a file has several free bodies, or some that are fixed "
              "to the "
              "world, the free ones are children of `world` on floating joints, which ROS reads "
              "and Gazebo "
              "takes for free.",
       .what_to_do = "Convert the robot alone: `--model NAME`."},
      {.rule = {"convert-from-mjcf-massless", NoteKind::kFromMjcfMassless, Severity::kInfo,
                Formats::kMjcf},
       .message = "has no mass: {instead}",
       .summary = "a body without mass, or between two joints of one body",
       .why = "Several joints of one body are joints in a row, with links between them that have "
              "no mass. "
              "Simulators reject or drop a moving link without mass, and SDF takes 1 kg for it.",
       .what_to_do = "Nothing: together the links weigh what the body does."},
      {.rule = {"convert-from-mjcf-limit", NoteKind::kFromMjcfLimit, Severity::kWarning,
                Formats::kMjcf},
       .message = "{written} of a {instead} joint is lost",
       .summary = "limits, damping, friction and springs of a ball or free joint are lost",
       .why = "Neither has an axis in SDF or URDF, and so no limit, damping or friction.",
       .what_to_do = "Use three hinges of one body in place of the ball where its limits matter."},
      {.rule = {"convert-from-mjcf-renamed", NoteKind::kFromMjcfRenamed, Severity::kWarning,
                Formats::kMjcf},
       .message = "{written} is named {instead} in the result",
       .summary = "a joint has another name in the result",
       .why = "MuJoCo has a set of names for each kind of element. SDF has one for the links, "
              "joints and frames of a model: a joint with the name of a link gets another one, "
              "and a controller that asks for the old one finds nothing.",
       .what_to_do = "Use the new name in controllers, or rename the joint in the MJCF file."},
      {.rule = {"convert-from-mjcf-gravity", NoteKind::kFromMjcfGravity, Severity::kWarning,
                Formats::kMjcf},
       .message = "gravity {written} is lost: it is the world's, not the model's",
       .summary = "gravity other than that of Earth is lost",
       .why = "Neither SDF nor URDF has gravity in a model. Loaded into a world with the default "
              "gravity, the robot falls otherwise than in MuJoCo.",
       .what_to_do = "Write it as <gravity> of the world that the model is loaded into."},
  };
  return kRows;
}

}  // namespace rigor::rules::conversion
