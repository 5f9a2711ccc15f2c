// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What materials weigh: a density to compute a mass with when nothing is weighed, and the range that
// the name covers, to judge a computed density by.
//
//   if (const Material* steel = find_material("steel")) body = of_density(solid, steel->density);
//
// Of a massive piece; a printed part with infill, or a foam, weighs what its filling makes of it.

#pragma once

#include <span>
#include <string_view>

namespace rigor::mass {

struct Material {
  std::string_view name;  ///< kebab-case
  double density = 0;     ///< kg/m³, usual
  double low = 0;         ///< kg/m³, of the lightest kind that goes by the name
  double high = 0;        ///< kg/m³, of the heaviest
  std::string_view source;
};

/// Metals, plastics, rubbers and foams, composites, woods, minerals, components; each by name.
std::span<const Material> materials();

/// By name or by another word for it ("aluminium", "delrin"); null when there is none.
const Material* find_material(std::string_view name);

}  // namespace rigor::mass
