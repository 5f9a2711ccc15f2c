// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a model tells a simulator beside the robot that it is: contact, gravity, self-collision, sensors,
// lights, plugins. Compared element by element, as they are written, so only between models of one
// format; a value that says the default counts as absent in SDF.
//
//   if (a.root.format == b.root.format) differences = compare_settings({a, model_a}, {b, model_b});

#pragma once

#include <vector>

#include <rigor/model/model.h>
#include <rigor/read/documents.h>
#include <rigor/robot/compare.h>
#include <rigor/schema/schema.h>

namespace rigor::convert {

struct SettingsSource {
  const model::Root& root;
  const read::Documents& documents;
  const schema::Schema& sdf;
  model::Id<model::Model> model;
};

/// Of what both models have by the same name; what only one has of links, joints and collisions is reported
/// by `compare`.
std::vector<robot::Difference> compare_settings(const SettingsSource& a, const SettingsSource& b);

/// Whether there is something that only `compare_settings` looks at.
bool has_settings(const SettingsSource& source);

/// What a review asks for besides, likewise between models of one format: of URDF safety controllers, calibrations,
/// transmissions and ros2_control, of SDF the stiffness and dissipation of limits, the visuals' flags and the world around
/// the model, of MJCF armatures and the friction of geoms. Edits prove themselves without it.
std::vector<robot::Difference> compare_further_settings(const SettingsSource& a,
                                                        const SettingsSource& b);

/// Whether there is something that only `compare_further_settings` looks at.
bool has_further_settings(const SettingsSource& source);

/// Whether an MJCF file has what neither compares: sensors, actuators, contact pairs, lights.
bool has_uncompared_settings(const SettingsSource& source);

}  // namespace rigor::convert
