// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <rigor/mass/material.h>
#include <rigor/report/inertia/inertia_report.h>
#include <rigor/report/number.h>
#include <rigor/report/terminal/grid.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/text/sources.h>

namespace rigor::report {
namespace {

using author::LinkInertia;
using mass::MassFrom;
using mass::MassProperties;

constexpr int kInertiaDigits = 4;
constexpr int kSolidDigits = 8;

std::string moments(const MassProperties& body) {
  const mass::Inertia& i = body.about_com;
  return number(i.ixx, kInertiaDigits) + ' ' + number(i.iyy, kInertiaDigits) + ' ' +
         number(i.izz, kInertiaDigits);
}

std::string written_mass(const LinkInertia& link) {
  std::string text = number(link.written.body.mass, kInertiaDigits);
  switch (link.written.taken) {
    case mass::Taken::kDefaults: return text + " (default)";
    case mass::Taken::kNothing: return "none";
    case mass::Taken::kAutomatic: return text + " (auto)";
    case mass::Taken::kAutomaticUnknown: return text + " (auto fails)";
    case mass::Taken::kWritten:
    case mass::Taken::kIdentity: return text;
  }
  return text;
}

std::string written_moments(const LinkInertia& link) {
  if (link.written.taken == mass::Taken::kNothing) return "none";
  const bool defaults =
      link.written.taken == mass::Taken::kIdentity || link.written.taken == mass::Taken::kDefaults;
  return moments(link.written.body) + (defaults ? " (default)" : "");
}

std::string ratio(const LinkInertia& link) {
  const auto value = link.ratio();
  return value ? number(*value, 3) : "-";
}

std::string verdict(const LinkInertia& link) {
  std::string names;
  for (const Diagnostic& finding : link.findings) {
    names += (names.empty() ? "" : ", ") + std::string(finding.rule);
  }
  if (!names.empty()) return names;
  return link.reason.empty() ? "ok" : "";
}

std::string parts(const LinkInertia& link) {
  return counted(link.body.parts.size(),
                 link.body.from == mass::From::kCollisions ? "collision" : "visual");
}

std::string mass_origin(const LinkInertia& link) {
  const mass::Proposal& computed = *link.computed;
  const std::string how = computed.mass_from == MassFrom::kGiven     ? "mass as given"
                          : computed.mass_from == MassFrom::kWritten ? "mass as written"
                                                                     : "mass from density";
  const bool large = computed.volume >= 1;
  return fmt::format(
      "{}, {} kg/m³ over {} {}", how, number(computed.body.mass / computed.volume, 4),
      number(large ? computed.volume : computed.volume * 1000, 3), large ? "m³" : "L");
}

const char* hull_reason(mass::MeshState state) {
  switch (state) {
    case mass::MeshState::kOpen: return "is not closed";
    case mass::MeshState::kOverlapping: return "overlaps itself";
    case mass::MeshState::kMixed: return "is partly inverted";
    case mass::MeshState::kFlat: return "encloses nothing";
    default: return "is no solid";
  }
}

void notes(const LinkInertia& link, Grid& grid) {
  for (const mass::PartBody& part : link.body.parts) {
    if (part.why != mass::NoSolid::kNone) continue;
    if (part.from == mass::BodyFrom::kHull) {
      grid.note(fmt::format("'{}': the mesh {}; its convex hull is used", printable(part.name),
                            hull_reason(part.mesh)));
    } else if (part.from == mass::BodyFrom::kTurnedMesh) {
      grid.note(fmt::format("'{}': the mesh is inverted; its opposite orientation is used",
                            printable(part.name)));
    }
  }
  if (!link.overlaps.complete) {
    grid.note(
        fmt::format("of parts that may share space {} pairs were compared, and others left out",
                    mass::kMaxCompared));
  }
  for (const mass::PartOverlap& overlap : link.overlaps.list) {
    grid.note(fmt::format("'{}' and '{}' share {:.0f} % of the smaller: it counts twice",
                          printable(link.body.parts[overlap.first].name),
                          printable(link.body.parts[overlap.second].name), 100 * overlap.share));
  }
  for (const Diagnostic& finding : link.findings) {
    if (!finding.help.empty()) grid.note(printable(finding.help));
  }
  if (!link.reason.empty()) grid.note(printable(link.reason));
}

void rows(const LinkInertia& link, Grid& grid) {
  const bool shown = link.computed && (link.chosen || !link.findings.empty() || link.ratio());
  grid.row({printable(link.name), "written", written_mass(link), written_moments(link), ratio(link),
            verdict(link)});
  if (shown) {
    grid.row({link.chosen ? "  *" : "", "shapes", number(link.computed->body.mass, kInertiaDigits),
              moments(link.computed->body), "", parts(link) + ", " + mass_origin(link)});
  }
  notes(link, grid);
}

/// Without what sums of numbers leave where there is nothing: a picometer.
model::Vector3 shown(const model::Vector3& p) {
  const auto snap = [](double value) { return std::abs(value) < 1e-12 ? 0.0 : value; };
  return {snap(p.x), snap(p.y), snap(p.z)};
}

std::string total_line(const std::string& what, const MassProperties& body) {
  return fmt::format("  {:8} {} kg, center of mass {} m, ixx iyy izz {} kg·m² about it\n", what,
                     number(body.mass, kInertiaDigits), numbers(shown(body.com), kInertiaDigits),
                     moments(body));
}

std::string stance_line(const mass::Stance& stance) {
  if (!stance.margin) return "  has fewer than three contact points\n";
  if (*stance.margin < 0) {
    return fmt::format("  tips over: its center of mass is {} m outside its support polygon\n",
                       number(-*stance.margin, 3));
  }
  return fmt::format("  stable: its center of mass is {} m inside its support polygon\n",
                     number(*stance.margin, 3));
}

}  // namespace

std::string solid_text(const SolidInertia& solid) {
  const mass::Inertia& tensor = solid.body.about_com;
  const mass::PrincipalAxes principal = mass::principal_axes(tensor);
  const auto shown = [](double value) { return number(value, kSolidDigits); };
  return fmt::format(
      "mass      {} kg\nvolume    {} m³\ndensity   {} kg/m³\ncenter    {} m\n"
      "inertia   ixx {}  iyy {}  izz {}  ixy {}  ixz {}  iyz {} kg·m², about the center of mass\n"
      "principal {}  {}  {} kg·m²\n",
      shown(solid.body.mass), shown(solid.volume), shown(solid.density),
      numbers(solid.body.com, kSolidDigits), shown(tensor.ixx), shown(tensor.iyy),
      shown(tensor.izz), shown(tensor.ixy), shown(tensor.ixz), shown(tensor.iyz),
      shown(principal.moments[0]), shown(principal.moments[1]), shown(principal.moments[2]));
}

std::string inertia_text(const InertiaTable& table) {
  Grid grid;
  grid.row({"link", "", "mass, kg", "ixx iyy izz, kg·m²", "ratio", "verdict"});
  std::size_t chosen = 0;
  for (const LinkInertia& link : table.table.links) {
    rows(link, grid);
    chosen += link.chosen ? 1 : 0;
  }
  std::string out = printable(table.table.path) + '\n' + grid.text();
  if (table.table.included > 0) {
    out += fmt::format("and {} of included files, which are checked with those files\n",
                       counted(table.table.included, "link"));
  }
  for (const RobotTotal& total : table.totals) {
    out += '\n' + printable(total.model) + '\n';
    if (total.written) out += total_line("written", *total.written);
    if (total.computed && chosen > 0) out += total_line("with *", *total.computed);
    if (total.stance) out += stance_line(*total.stance);
  }
  if (chosen > 0) {
    out += fmt::format("\n* {} would be written: --diff shows it, --write does it\n",
                       counted(chosen, "inertial"));
  }
  return out;
}

std::string materials_text(const std::map<std::string, double>& own) {
  Grid grid;
  grid.row({"material", "kg/m³", "range", "source"});
  for (const mass::Material& material : mass::materials()) {
    grid.row({std::string(material.name), number(material.density),
              number(material.low) + " to " + number(material.high), std::string(material.source)});
  }
  for (const auto& [name, density] : own) {
    grid.row({printable(name), number(density), "", "rigor.toml"});
  }
  return grid.text();
}

}  // namespace rigor::report
