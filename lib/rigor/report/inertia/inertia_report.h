// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What `inertia` prints: a body's numbers, a model's table, the list of materials.

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <rigor/author/model_inertia.h>
#include <rigor/mass/mass_properties.h>
#include <rigor/mass/stance.h>

namespace rigor::report {

/// One solid, from numbers alone.
struct SolidInertia {
  mass::MassProperties body;  ///< `com` in the link frame, the tensor along the shape's axes
  double volume = 0;          ///< m³ of material
  double density = 0;         ///< kg/m³
};

/// For people: to `kSolidDigits` digits, with units.
std::string solid_text(const SolidInertia& solid);
std::string solid_json(const SolidInertia& solid);

/// A model's sum, as it is written and as it would be with what is computed.
struct RobotTotal {
  std::string model;
  std::optional<mass::MassProperties> written;
  std::optional<mass::MassProperties> computed;
  std::optional<mass::Stance> stance;  ///< of the computed one
};

struct InertiaTable {
  const author::ModelInertia& table;
  const Sources& sources;
  std::vector<RobotTotal> totals;
};

std::string inertia_text(const InertiaTable& table);
std::string inertia_json(const InertiaTable& table);

/// The known materials, and a project's own: kg/m³ by name.
std::string materials_text(const std::map<std::string, double>& own);
std::string materials_json(const std::map<std::string, double>& own);

}  // namespace rigor::report
