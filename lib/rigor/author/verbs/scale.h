// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A robot of another size, at the same density and under the same gravity.
//
//   const Change change = scaled(*edited, 0.5);
//
// Lengths grow with f, and with what follows from that by dimension when density (kg/m³) and gravity (m/s²) stay
// (Froude's law of similarity; R. McN. Alexander, A. S. Jayes, "A dynamic similarity hypothesis for the gaits of
// quadrupedal mammals", J. Zool. 1983):
//
//   | f    | lengths, positions of sliding joints, scales of meshes, a screw's lead |
//   | f³   | masses, forces of sliding joints (effort, friction)                    |
//   | f⁵   | moments of inertia                                                     |
//   | f⁴   | torques (effort, friction), torsion springs                            |
//   | f²   | springs of sliding joints, contact kp                                  |
//   | f^½  | speeds of sliding joints                                               |
//   | f^-½ | speeds of turning joints                                               |
//   | f^4½ | damping of turning joints                                              |
//   | f^2½ | damping of sliding joints, contact kd                                  |
//
// Angles, coefficients of friction, what sensors measure, and the place of the model in its world are kept. Parameters of
// plugins that read like lengths are kept and listed, and so are those of controllers in files of parameters that were
// named, or name a joint of the robot.

#pragma once

#include <rigor/author/names/workspace_files.h>
#include <rigor/author/verbs/change.h>

namespace rigor::author {

/// `factor` is positive and finite. Refused where a part is in a file that is included.
Change scaled(const EditedModel& edited, double factor, const ReferringFiles& files = {});

}  // namespace rigor::author
