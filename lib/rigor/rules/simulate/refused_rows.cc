// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What an engine cannot take: nothing is run.

#include <span>

#include <rigor/rules/simulate/rows.h>

namespace rigor::rules::simulation {

using simulate::FactKind;

std::span<const Row> refused_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"simulate-unreadable", FactKind::kUnreadable, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             if (fact.name == "no model") return "there is no model to simulate";
             if (fact.name == "no such model") return "there is no model of this name";
             if (fact.name == "no pose")
               return "its pose is undefined: the frame that it is relative to does not exist";
             if (fact.name == "no parent") return "the joint's parent is not there";
             if (fact.name == "no child") return "the joint's child is not there";
             if (fact.name == "expressed_in")
               return "the frame that the axis is expressed in is not there";
             if (fact.name.starts_with("type ")) return "there is no joint of {name}";
             if (fact.name.starts_with("include ")) return "the {name} does not exist";
             return "cannot be simulated: {name}";
           },
       .summary = "the file has no model that can be placed",
       .why = "A physics engine needs to know where every body is. Here there is no model, a name "
              "does not exist, or an include could not be followed, so nothing was simulated.",
       .what_to_do = "Run `rigor validate` on the file: it reports which reference is wrong."},
      {.rule = {"simulate-no-mass", FactKind::kNoMass, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name == "all"
                        ? "no link has mass: there is nothing to simulate"
                        : "the mass of a link that moves is {value:.6g} kg, and must be above 0";
           },
       .summary = "a body that moves has no mass",
       .why = "An engine divides by the mass. ODE ends the process on a mass of zero or less; "
              "Gazebo throws; Gazebo drops a URDF link without an inertial, with its subtree.",
       .what_to_do = "Give the link a mass: `rigor inertia MODEL --write` computes it from the "
                     "link's shapes."},
      {.rule = {"simulate-not-finite", FactKind::kNotFinite, Severity::kError},
       .message = "{name} is not a finite number",
       .summary = "a number is not finite",
       .why = "ODE takes a mass or tensor of nan silently, and then every pose it computes is nan; "
              "others end the process at once.",
       .what_to_do = "Write a finite number."},
      {.rule = {"simulate-inertia-impossible", FactKind::kInertiaImpossible, Severity::kError},
       .message = "no rigid body has this inertia: {value:.3g} kg·m² where more than {limit:.3g} "
                  "is needed",
       .summary = "no rigid body has the inertia tensor",
       .why = "A tensor must be positive definite, and two principal moments must sum up to the "
              "third at least. ODE ends the process on the first, and integrates the second into "
              "motions that gain energy.",
       .what_to_do =
           "Run `rigor inertia MODEL --diff`: it shows the tensor that the link's shapes have."},
      {.rule = {"simulate-shape-size", FactKind::kShapeSize, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name == "scale"   ? "the scale of a mesh has a zero in it"
                    : fact.name == "point" ? "the polyline encloses nothing"
                    : fact.name == "radii"
                        ? "the smallest radius of a collision is {value:.6g} m, and must be above 0"
                        : "the {name} of a collision is {value:.6g} m, and must be above 0";
           },
       .summary = "a collision's size is not positive",
       .why = "ODE ends the process on negative sizes, and takes a size of zero silently: nothing "
              "collides with it then.",
       .what_to_do = "Write the size in meters, above zero."},
      {.rule = {"simulate-axis-zero", FactKind::kAxisZero, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             if (fact.name == "axis" || fact.name == "axis2") return "there is no <{name}>";
             if (fact.name == "axis2 along axis")
               return "both axes of the joint point along one line";
             if (fact.name == "normal") return "the plane's normal is 0 0 0: it has no direction";
             return "the axis is 0 0 0: it has no direction";
           },
       .summary = "an axis has no direction",
       .why = "A hinge about 0 0 0 has no axis; ODE ends the process on it.",
       .what_to_do = "Write the direction that the joint rotates about or slides along."},
      {.rule = {"simulate-limits-crossed", FactKind::kLimitsCrossed, Severity::kError},
       .message = "lower ({value:.6g}) is above upper ({limit:.6g})",
       .summary = "a joint's lower limit is above its upper one",
       .why = "ODE keeps crossed limits silently and lets the joint move freely; others lock it or "
              "reject the model.",
       .what_to_do = "Swap the two limits."},
      {.rule = {"simulate-solver-setting", FactKind::kStep, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             return fact.value > fact.limit
                        ? "{name} is {value:.6g}, and must be at most {limit:.6g}"
                    : fact.value < fact.limit
                        ? "{name} is {value:.6g}, and must be not below {limit:.6g}"
                        : "{name} is {value:.6g}, and must be above {limit:.6g}";
           },
       .summary = "a setting of the physics engine is not one that it can take",
       .why = "Time must go forward, and corrections must not overshoot: ODE ends the process on a "
              "step of zero or less.",
       .what_to_do = "Take it out of `<physics>`, or write a usual one: `<max_step_size>` 0.001 s, "
                     "`<iters>` 50, `<sor>` 1.3, `<erp>` 0.2, `<cfm>` 0."},
      {.rule = {"simulate-engine-rejected", FactKind::kEngineRefused, Severity::kError},
       .message = "the engine stopped: {name}",
       .summary = "the physics engine stopped",
       .why = "The engine met something that it cannot compute with, and would have ended the "
              "simulator. rigor checks all that it knows to cause this beforehand, so the cause is "
              "unusual.",
       .what_to_do = "Try another solver (`--solver`) or another step (`--time-step`); check the "
                     "joints and contacts that are active then."},
      {.rule = {"simulate-too-large", FactKind::kTooLarge, Severity::kError},
       .message = "{name}: {value:.6g} is beyond the {limit:.6g} that can be simulated",
       .summary = "there is more than can be simulated",
       .why =
           "Bodies, shapes, joints and triangles are bounded, so that a broken file cannot exhaust "
           "the machine; so are places and sizes, since ODE ends the process on far-off ones.",
       .what_to_do = "Mend the number. Of too many things simulate a part (`--model`), or reduce "
                     "the collision meshes with `rigor mesh-check --reduce`."},
  };
  return kRows;
}

}  // namespace rigor::rules::simulation
