// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <variant>

#include <fmt/core.h>

#include <rigor/report/mesh_check/mesh_report.h>
#include <rigor/report/number.h>
#include <rigor/report/terminal/pretty.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/text/grouping.h>

namespace rigor::report {
namespace {

constexpr int kMeshDigits = 6;

std::string row(std::string_view name, const std::string& text) {
  return fmt::format("  {:<9}{}\n", name, text);
}

std::string point(const model::Vector3& p) {
  return fmt::format("({}, {}, {})", number(p.x, kMeshDigits), number(p.y, kMeshDigits),
                     number(p.z, kMeshDigits));
}

/// What a length in the file is: STL and OBJ say nothing of their unit.
std::string_view unit_of(mesh::Format format) {
  const bool unsaid = format == mesh::Format::kStlBinary || format == mesh::Format::kStlAscii ||
                      format == mesh::Format::kObj || format == mesh::Format::kPly;
  return unsaid ? "" : " m";
}

std::string size_text(const mass::MeshFacts& facts) {
  const model::Vector3 size = facts.bounds.max - facts.bounds.min;
  return fmt::format("{} × {} × {}{}, from {} to {}", number(size.x, kMeshDigits),
                     number(size.y, kMeshDigits), number(size.z, kMeshDigits),
                     unit_of(facts.format), point(facts.bounds.min), point(facts.bounds.max));
}

std::string surface_text(const mass::MeshShape& shape) {
  const mesh::Topology& topology = shape.topology;
  std::string text;
  if (!topology.closed()) {
    text = topology.boundary_edges > 0 ? "open" : "not a solid";
  } else if (shape.convex) {
    text = "closed, convex";
  } else {
    text = topology.inverted > 0 ? "closed, inside out" : "closed";
  }
  return text + ", " + counted(topology.components, "component") + ", Euler characteristic " +
         std::to_string(topology.euler());
}

/// What is wrong with edges, vertices and faces, the zeros left out.
std::string defects_text(const mesh::Topology& t) {
  struct Kind {
    std::uint64_t count;
    std::string_view one;
    std::string_view many;
  };
  const Kind kinds[] = {
      {t.boundary_edges, "boundary edge", "boundary edges"},
      {t.nonmanifold_edges, "non-manifold edge", "non-manifold edges"},
      {t.inconsistent_edges, "edge of inconsistent winding", "edges of inconsistent winding"},
      {t.nonmanifold_vertices, "non-manifold vertex", "non-manifold vertices"},
      {t.degenerate + t.zero_area, "degenerate face", "degenerate faces"},
      {t.duplicates, "duplicate face", "duplicate faces"},
      {t.slivers, "sliver", "slivers"}};
  std::string text;
  for (const Kind& kind : kinds) {
    if (kind.count == 0) continue;
    if (!text.empty()) text += ", ";
    text += counted(kind.count, kind.one, kind.many);
  }
  return text;
}

std::string volume_text(const mass::MeshShape& shape) {
  std::string text = "area " + number(shape.moments.area, kMeshDigits);
  if (!shape.topology.closed() || shape.moments.volume == 0) return text;
  return number(shape.moments.volume, kMeshDigits) + ", " + text + ", center " +
         point(mass::centroid(shape.moments));
}

std::string uses_text(const rules::CheckedMesh& mesh) {
  constexpr std::size_t kShown = 3;
  std::string text;
  for (std::size_t i = 0; i < mesh.uses.size() && i < kShown; ++i) {
    if (i > 0) text += ", ";
    text += printable(mesh.uses[i]);
  }
  if (mesh.uses.size() > kShown) text += fmt::format(" and {} more", mesh.uses.size() - kShown);
  return text + ", scale " + numbers(mesh.scale, kMeshDigits);
}

std::string mesh_text(const rules::CheckedMesh& mesh, Color color) {
  const mass::MeshFacts& facts = *mesh.facts;
  std::string text = paint(printable(facts.path), Paint::kStrong, color) + ": ";
  text += mesh::to_string(facts.format);
  if (!facts.shape) {
    text += '\n';
  } else {
    const mass::MeshShape& shape = *facts.shape;
    text += ", " + counted(facts.triangles, "triangle") + ", " +
            counted(shape.topology.vertices, "vertex", "vertices") + '\n';
    text += row("size", size_text(facts));
    text += row("surface", surface_text(shape));
    const std::string defects = defects_text(shape.topology);
    if (!defects.empty()) text += row("defects", defects);
    text += row("volume", volume_text(shape));
  }
  if (!mesh.uses.empty()) text += row("used by", uses_text(mesh));
  return text;
}

std::string round_text(double radius, double length) {
  return "radius " + number(radius, kMeshDigits) + ", length " + number(length, kMeshDigits);
}

struct PrimitiveText {
  std::string operator()(const mesh::Box& s) const {
    return "box, size " + numbers(s.size, kMeshDigits);
  }
  std::string operator()(const mesh::Sphere& s) const {
    return "sphere, radius " + number(s.radius, kMeshDigits);
  }
  std::string operator()(const mesh::Cylinder& s) const {
    return "cylinder, " + round_text(s.radius, s.length);
  }
  std::string operator()(const mesh::Capsule& s) const {
    return "capsule, " + round_text(s.radius, s.length);
  }
};

std::string fit_text(const mesh::Fit& fit) {
  std::string text = row("fit", std::visit(PrimitiveText{}, fit.shape));
  text += row("pose", numbers(fit.pose.translation, kMeshDigits) + "  " +
                          numbers(to_rpy(fit.pose.rotation), kMeshDigits));
  return text + row("", fmt::format("the mesh's hull fills {:.1f} % of it, and its surface lies {} "
                                    "inside at most",
                                    100 * fit.fill(), number(fit.deepest, kMeshDigits)));
}

/// What was done, and what came of it.
std::string work_text(const MeshCheckReport& report, Color color) {
  std::string text;
  for (const author::MeshStep& step : report.steps) {
    text += fmt::format("  {}: {}\n", printable(step.name), step.what);
  }
  if (report.fit) text += fit_text(*report.fit);
  for (const WrittenFile& file : report.written) {
    text += paint(printable(file.path), Paint::kStrong, color) + ": written";
    if (file.triangles) text += ", " + counted(*file.triangles, "triangle");
    if (file.hausdorff) {
      text += fmt::format(", at most {} off (sampled)", number(*file.hausdorff, kMeshDigits));
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::string mesh_check_text(const MeshCheckReport& report, Color color) {
  const bool works = !report.steps.empty() || report.fit || !report.written.empty();
  std::string text = work_text(report, color);
  // Of a run that makes something the meshes that were named are its sources.
  if (works) text += '\n';
  for (const rules::CheckedMesh& mesh : report.result.meshes) text += mesh_text(mesh, color);
  if (!report.result.diagnostics.list().empty()) {
    text += '\n' + pretty(grouped(report.result.diagnostics), report.sources, color);
  }
  return text;
}

}  // namespace rigor::report
