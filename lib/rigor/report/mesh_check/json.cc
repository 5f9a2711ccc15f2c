// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <string>
#include <variant>

#include <rigor/report/json/diagnostic.h>
#include <rigor/report/json/values.h>
#include <rigor/report/mesh_check/mesh_report.h>
#include <rigor/report/number.h>
#include <rigor/report/tool.h>
#include <rigor/text/grouping.h>

namespace rigor::report {
namespace {

void add_shape(Json& json, const mass::MeshShape& shape) {
  const mesh::Topology& topology = shape.topology;
  const bool solid = topology.closed() && shape.moments.volume != 0;
  json["watertight"] = topology.watertight();
  json["edge_manifold"] = topology.nonmanifold_edges == 0;
  json["oriented"] = topology.inconsistent_edges == 0;
  json["components"] = topology.components;
  json["degenerate"] = topology.degenerate + topology.zero_area;
  json["duplicate_faces"] = topology.duplicates;
  json["boundary_edges"] = topology.boundary_edges;
  json["nonmanifold_edges"] = topology.nonmanifold_edges;
  json["nonmanifold_vertices"] = topology.nonmanifold_vertices;
  json["inconsistent_edges"] = topology.inconsistent_edges;
  json["inverted_components"] = topology.inverted;
  json["cavities"] = topology.cavities;
  json["slivers"] = topology.slivers;
  json["volume"] = topology.closed() ? finite(shape.moments.volume) : Json(nullptr);
  json["area"] = finite(shape.moments.area);
  json["com"] = solid ? vector_of(mass::centroid(shape.moments)) : Json(nullptr);
  json["euler"] = topology.euler();
  json["convex"] = shape.convex;
  const auto& crossings = shape.self_intersections;
  json["self_intersections"] = crossings ? Json(crossings->pairs) : Json(nullptr);
}

Json mesh_of(const rules::CheckedMesh& mesh) {
  const mass::MeshFacts& facts = *mesh.facts;
  Json json{{"path", facts.path}, {"format", mesh::to_string(facts.format)}};
  if (!mesh.uses.empty()) {
    json["scale"] = vector_of(mesh.scale);
    json["uses"] = mesh.uses;
  }
  if (!facts.shape) return json;
  json["vertices"] = facts.shape->topology.vertices;
  json["triangles"] = facts.triangles;
  json["bounds"] = {{"min", vector_of(facts.bounds.min)}, {"max", vector_of(facts.bounds.max)}};
  add_shape(json, *facts.shape);
  return json;
}

Json round_json(const char* name, double radius, double length) {
  return {{"shape", name}, {"radius", finite(radius)}, {"length", finite(length)}};
}

struct PrimitiveJson {
  Json operator()(const mesh::Box& s) const {
    return {{"shape", "box"}, {"size", vector_of(s.size)}};
  }
  Json operator()(const mesh::Sphere& s) const {
    return {{"shape", "sphere"}, {"radius", finite(s.radius)}};
  }
  Json operator()(const mesh::Cylinder& s) const {
    return round_json("cylinder", s.radius, s.length);
  }
  Json operator()(const mesh::Capsule& s) const {
    return round_json("capsule", s.radius, s.length);
  }
};

Json fit_of(const mesh::Fit& fit) {
  Json json = std::visit(PrimitiveJson{}, fit.shape);
  json["position"] = vector_of(fit.pose.translation);
  json["rpy"] = vector_of(to_rpy(fit.pose.rotation));
  json["volume"] = finite(fit.volume);
  json["fill"] = finite(fit.fill());
  json["deepest"] = finite(fit.deepest);
  return json;
}

Json written_of(const WrittenFile& file) {
  return {{"path", file.path},
          {"triangles", file.triangles ? Json(*file.triangles) : Json(nullptr)},
          {"hausdorff", file.hausdorff ? finite(*file.hausdorff) : Json(nullptr)}};
}

}  // namespace

std::string mesh_check_json(const MeshCheckReport& report) {
  Json document{{"tool", {{"name", kToolName}, {"version", tool_version()}}},
                {"schema_version", kSchemaVersion},
                {"meshes", Json::array()}};
  for (const rules::CheckedMesh& mesh : report.result.meshes) {
    document["meshes"].push_back(mesh_of(mesh));
  }
  document["diagnostics"] = diagnostics_of(grouped(report.result.diagnostics), report.sources);
  document["steps"] = Json::array();
  for (const author::MeshStep& step : report.steps) {
    document["steps"].push_back({{"name", step.name}, {"what", step.what}});
  }
  if (report.fit) document["fit"] = fit_of(*report.fit);
  document["written"] = Json::array();
  for (const WrittenFile& file : report.written) document["written"].push_back(written_of(file));
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rigor::report
