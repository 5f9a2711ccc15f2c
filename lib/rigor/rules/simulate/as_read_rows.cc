// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is not simulated as it is written.

#include <span>

#include <rigor/rules/simulate/rows.h>

namespace rigor::rules::simulation {

using simulate::FactKind;

std::span<const Row> as_read_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"simulate-nothing-moves", FactKind::kNothingMoves, Severity::kInfo},
       .message = "all links are static or fixed to the world: there is nothing to simulate",
       .summary = "nothing in the model moves",
       .why = "All links are static or fixed to the world, so a simulation shows nothing: the "
              "model's masses and contacts were not checked.",
       .what_to_do =
           "Simulate a model that moves, or remove `<static>` where it was left by mistake."},
      {.rule = {"simulate-mesh-missing", FactKind::kMeshMissing, Severity::kWarning},
       .message = "the mesh of a collision could not be read: the simulation goes on without it",
       .summary = "a collision's mesh could not be read",
       .why = "The collision was left out, so what it should touch goes through it. A simulator "
              "does the same, or rejects the model.",
       .what_to_do = "Put the file where the URI leads; `rigor resolve URI` lists every place that "
                     "was tried."},
      {.rule = {"simulate-mesh-as-primitive", FactKind::kMeshAsPrimitive, Severity::kInfo},
       .message = "the mesh is simulated as the {name} that it nearly is: it fills "
                  "{value_percent:.3g} % of it",
       .summary = "a collision mesh is simulated as the primitive it imitates",
       .why = "A wheel of 32 flat sides bounces and slips where a cylinder rolls: 3 to 16 % of the "
              "way are lost. So a mesh that nearly is a primitive is simulated as one; a simulator "
              "will not do that.",
       .what_to_do = "Write the primitive as the collision: `rigor mesh-check FILE --fit best` "
                     "gives its size and pose. `--meshes triangles` simulates the mesh as it is."},
      {.rule = {"simulate-mesh-as-hull", FactKind::kMeshAsHull, Severity::kInfo},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name == "convex"
                        ? "the mesh is simulated as its convex hull, which it nearly is"
                    : fact.name == "too large"
                        ? "the mesh is simulated as its convex hull, since it has too many "
                          "triangles"
                        : "the mesh is simulated as its convex hull, as was asked for";
           },
       .summary = "a collision mesh is simulated as its convex hull",
       .why = "Engines collide convex shapes well and triangles badly, and an open mesh has no "
              "inside. What the hull adds collides too.",
       .what_to_do = "Nothing, where the hull is good enough; else `rigor mesh-check FILE "
                     "--convex-pieces 16` makes convex pieces of it."},
      {.rule = {"simulate-shape-as-hull", FactKind::kShapeAsHull, Severity::kInfo},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name.empty()
                        ? "the shape is simulated as the convex hull of points on it"
                        : "the {name} is simulated as the convex hull of points on it";
           },
       .summary = "a shape is simulated as a convex hull of points on it",
       .why = "ODE has no ellipsoids, cones and polylines; their hull of many points differs from "
              "them by less than a hundredth of their size. A polyline with a notch loses it.",
       .what_to_do = "Nothing, unless the exact curvature matters: then a sphere, box, cylinder or "
                     "capsule is exact."},
      {.rule = {"simulate-shape-ignored", FactKind::kShapeIgnored, Severity::kWarning},
       .message = "this collision is not simulated: {name}",
       .summary = "a collision shape is not simulated",
       .why = "The engine has no such shape, a plane or heightmap is on a link that moves, a "
              "heightmap's image cannot be used, or one collision has two shapes: what it should "
              "touch goes through it.",
       .what_to_do = "Use a box, sphere, cylinder, capsule, mesh or plane; for a heightmap a "
                     "square PNG of 2^n + 1 pixels along a side."},
      {.rule = {"simulate-joint-emulated", FactKind::kJointEmulated, Severity::kInfo},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name.empty() ? "the joint is emulated" : "the joint is emulated: {name}";
           },
       .summary = "a joint is simulated by means of others",
       .why = "The engine lacks the joint's type, so it is made of a free joint and a constraint "
              "between its motions. It is stiff but not perfect.",
       .what_to_do = "Nothing; check `joint.anchor_error` when the joint carries a large load."},
      {.rule = {"simulate-joint-ignored", FactKind::kJointIgnored, Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name.empty() ? "the joint is not simulated"
                                      : "the joint is not simulated: {name}";
           },
       .summary = "a joint is not simulated",
       .why =
           "Its type is not known to the engine, it does not connect two bodies, or its `<cfm>` of "
           "1 (m/s)/N and more, with an `<erp>` of 0, lets them go: they move as if it were not "
           "there.",
       .what_to_do =
           "Give the joint a type and two links; `rigor validate` reports what is wrong with it."},
      {.rule = {"simulate-element-ignored", FactKind::kElementIgnored, Severity::kInfo},
       .also = FactKind::kDampingAsNone,
       .message =
           [](const simulate::Fact& fact) {
             if (fact.name == "model" || fact.name == "world")
               return "this {name} is not simulated: only the first one of a file is";
             if (fact.name == "include")
               return "this include is not simulated: it is not in the Fuel cache, and nothing is "
                      "downloaded";
             if (fact.kind == FactKind::kDampingAsNone)
               return "{name} of {value:.6g} would drive the joint: it is taken as 0";
             return "{name} has no effect in this simulation";
           },
       .summary = "an element that the model relies on has no effect here",
       .why = "What the element asks for exists in Gazebo's own engine only, or in none; "
              "docs/simulate.md lists what is honored, approximated and ignored.",
       .what_to_do = "Nothing, if the behavior without it is what you want to see."},
      {.rule = {"simulate-start-moved", FactKind::kStartMoved, Severity::kInfo, Formats::kUrdf},
       .message = "initial position {value:.4g} {unit}: zero is outside its limits",
       .summary = "initial position at a limit: zero is outside the limits",
       .why = "URDF has no initial positions. A simulator that starts at zero, outside the limits, "
              "moves the joint to the nearer one in its first step.",
       .what_to_do = "Set the initial position with `--joint NAME=VALUE`, and the same one in your "
                     "simulator."},
  };
  return kRows;
}

}  // namespace rigor::rules::simulation
