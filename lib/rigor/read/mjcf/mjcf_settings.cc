// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/mjcf/mjcf_settings.h>

#include <charconv>
#include <numbers>

#include <rigor/read/values.h>

namespace rigor::read {

double MjcfSettings::radians(double angle) const {
  return degrees ? angle * std::numbers::pi / 180 : angle;
}

std::optional<std::vector<double>> mjcf_numbers(std::string_view text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    while (at != end && (*at == ' ' || *at == '\n' || *at == '\t' || *at == '\r')) ++at;
    if (at == end) return numbers;
    if (*at == '+' && end - at > 1 && at[1] != '-') ++at;
    double number = 0;
    const auto [stop, error] = std::from_chars(at, end, number);
    if (error != std::errc() || stop == at) return std::nullopt;
    numbers.push_back(number);
    at = stop;
    if (at != end && *at != ' ' && *at != '\n' && *at != '\t' && *at != '\r') return std::nullopt;
  }
}

MjcfSettings mjcf_settings(const MjcfTree& tree) {
  MjcfSettings settings;
  const auto number = [](std::string_view text, double fallback) {
    const auto numbers = mjcf_numbers(text);
    return numbers && !numbers->empty() ? numbers->front() : fallback;
  };
  for (const xml::Element section : tree.children(tree.root())) {
    if (section.name() != "compiler") continue;
    // The folder of both first: the special ones override it.
    if (const auto both = section.attribute("assetdir")) {
      settings.mesh_folder = settings.texture_folder = both->value();
    }
    for (const xml::Attribute attribute : section.attributes()) {
      const std::string_view name = attribute.name();
      const std::string_view value = trimmed(attribute.value());
      const bool on = value == "true";
      if (name == "angle") settings.degrees = value != "radian";
      if (name == "eulerseq" && value.size() == 3) settings.euler_sequence = value;
      if (name == "autolimits" && (on || value == "false")) settings.auto_limits = on;
      if (name == "strippath") settings.strip_path = on;
      if (name == "fitaabb") settings.fit_to_bounds = on;
      if (name == "balanceinertia") settings.masses.balance_inertia = on;
      if (name == "meshdir") settings.mesh_folder = attribute.value();
      if (name == "texturedir") settings.texture_folder = attribute.value();
      if (name == "boundmass") settings.masses.bound_mass = number(value, 0);
      if (name == "boundinertia") settings.masses.bound_inertia = number(value, 0);
      if (name == "settotalmass") settings.masses.total_mass = number(value, 0);
      if (name == "coordinate" && value == "global") {
        settings.global_coordinates = attribute.value_span();
      }
      if (name == "inertiafromgeom") {
        using From = MjcfSettings::InertiaFromGeom;
        settings.inertia_from_geom = on                ? From::kTrue
                                     : value == "auto" ? From::kAuto
                                                       : From::kFalse;
      }
      if (name == "inertiagrouprange") {
        const auto range = mjcf_numbers(value);
        if (range && range->size() == 2) {
          settings.inertia_groups = {static_cast<int>((*range)[0]), static_cast<int>((*range)[1])};
        }
      }
    }
  }
  return settings;
}

}  // namespace rigor::read
