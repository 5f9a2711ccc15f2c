// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>
#include <rigor/text/letter_case.h>

namespace rigor::rules::mesh_unit_contradicts_name {

struct Unit {
  std::string_view name;
  double meter;
};
constexpr Unit kUnits[] = {
    {"meter", 1},           {"metre", 1},       {"meters", 1},         {"m", 1},
    {"decimeter", 0.1},     {"dm", 0.1},        {"centimeter", 0.01},  {"centimetre", 0.01},
    {"centimeters", 0.01},  {"cm", 0.01},       {"millimeter", 0.001}, {"millimetre", 0.001},
    {"millimeters", 0.001}, {"mm", 0.001},      {"kilometer", 1000},   {"km", 1000},
    {"inch", 0.0254},       {"inches", 0.0254}, {"in", 0.0254},        {"foot", 0.3048},
    {"feet", 0.3048},       {"ft", 0.3048},     {"yard", 0.9144}};

// Exporters write 0.0254 with few digits or many; two units differ by 8 % at least.
constexpr double kRounded = 0.01;

std::optional<double> meter_of(std::string_view name) {
  for (const Unit& unit : kUnits) {
    if (equal_but_for_case(unit.name, name)) return unit.meter;
  }
  return std::nullopt;
}

void check(const MeshFile& file, Context& context) {
  const auto& collada = file.facts.asset.collada;
  if (!collada || collada->unit_line == 0) return;
  const std::optional<double> named = meter_of(collada->unit_name);
  const double written = collada->meter.value_or(1);  // the default, by Collada's definition
  if (!named || std::abs(written - *named) <= kRounded * *named) return;
  report_mesh_text(file, context,
                   fmt::format("the unit is named {}, which is {} m, but is given as {} m{}",
                               collada->unit_name, *named, written, in_line(collada->unit_line)));
}

Rule rule() {
  return {
      .name = "mesh-unit-contradicts-name",
      .severity = Severity::kInfo,
      .summary = "a unit's name and size contradict each other",
      .why = "A reader of the name gets another size than a reader of the number. Simulators read "
             "the number; only the size of the part shows which of the two was meant.",
      .what_to_do =
          "State the unit: `rigor mesh-check FILE --unit cm -o OUT.dae` writes a mesh in meters.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_unit_contradicts_name
