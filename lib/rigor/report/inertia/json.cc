// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/mass/material.h>
#include <rigor/report/inertia/inertia_report.h>
#include <rigor/report/json/values.h>
#include <rigor/report/places.h>
#include <rigor/report/tool.h>

namespace rigor::report {
namespace {

using author::LinkInertia;
using mass::MassProperties;

Json body_of(const MassProperties& body) {
  return {{"mass", finite(body.mass)},
          {"com", vector_of(body.com)},
          {"inertia", tensor_of(body.about_com)}};
}

template <class T>
Json or_null(const std::optional<T>& value, Json (*make)(const T&)) {
  return value ? make(*value) : Json(nullptr);
}

const char* taken_name(mass::Taken taken) {
  switch (taken) {
    case mass::Taken::kWritten: return "written";
    case mass::Taken::kDefaults: return "defaults";
    case mass::Taken::kIdentity: return "identity-tensor";
    case mass::Taken::kNothing: return "nothing";
    case mass::Taken::kAutomatic: return "automatic";
    case mass::Taken::kAutomaticUnknown: return "automatic-unknown";
  }
  return "";
}

const char* mass_from_name(mass::MassFrom from) {
  switch (from) {
    case mass::MassFrom::kGiven: return "given";
    case mass::MassFrom::kDensity: return "density";
    case mass::MassFrom::kWritten: return "written";
  }
  return "";
}

const char* body_from_name(mass::BodyFrom from) {
  switch (from) {
    case mass::BodyFrom::kMesh: return "shape";
    case mass::BodyFrom::kTurnedMesh: return "turned-mesh";
    case mass::BodyFrom::kHull: return "convex-hull";
  }
  return "";
}

Json computed_of(const LinkInertia& link) {
  if (!link.computed) return nullptr;
  const mass::Proposal& computed = *link.computed;
  Json json = body_of(computed.body);
  json["volume"] = finite(computed.volume);
  json["density"] = finite(computed.body.mass / computed.volume);
  json["mass_from"] = mass_from_name(computed.mass_from);
  json["from"] = link.body.from == mass::From::kCollisions ? "collision" : "visual";
  json["parts"] = Json::array();
  for (const mass::PartBody& part : link.body.parts) {
    json["parts"].push_back({{"name", part.name},
                             {"volume", finite(part.unit.mass)},
                             {"taken_as", body_from_name(part.from)}});
  }
  return json;
}

Json link_of(const LinkInertia& link, Places& places) {
  Json json{{"name", link.name}, {"written", body_of(link.written.body)}};
  json["written"]["taken"] = taken_name(link.written.taken);
  json["computed"] = computed_of(link);
  const auto ratio = link.ratio();
  json["ratio"] = ratio ? Json(*ratio) : Json(nullptr);
  json["findings"] = Json::array();
  for (const Diagnostic& finding : link.findings) {
    const Position at = places.begin(finding.where);
    json["findings"].push_back({{"rule", finding.rule},
                                {"severity", to_string(finding.severity)},
                                {"message", finding.message},
                                {"help", finding.help},
                                {"line", at.line},
                                {"column", at.column}});
  }
  json["overlaps"] = Json::array();
  for (const mass::PartOverlap& overlap : link.overlaps.list) {
    json["overlaps"].push_back({{"first", link.body.parts[overlap.first].name},
                                {"second", link.body.parts[overlap.second].name},
                                {"share", overlap.share}});
  }
  json["overlaps_complete"] = link.overlaps.complete;
  json["chosen"] = link.chosen;
  json["reason"] = link.reason;
  return json;
}

Json stance_of(const mass::Stance& stance) {
  return {{"points", stance.points},
          {"height", finite(stance.height)},
          {"margin", stance.margin ? finite(*stance.margin) : Json(nullptr)}};
}

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string solid_json(const SolidInertia& solid) {
  Json json = body_of(solid.body);
  json["volume"] = finite(solid.volume);
  json["density"] = finite(solid.density);
  const mass::PrincipalAxes principal = mass::principal_axes(solid.body.about_com);
  json["principal_moments"] = principal.moments;
  json["principal_axes"] = Json::array();
  for (const model::Vector3& axis : principal.axes)
    json["principal_axes"].push_back(vector_of(axis));
  return json_text(json);
}

std::string inertia_json(const InertiaTable& table) {
  Json json;
  json["tool"] = {{"name", kToolName}, {"version", tool_version()}};
  json["schema_version"] = kSchemaVersion;
  json["path"] = table.table.path;
  json["links"] = Json::array();
  Places places(table.sources);
  for (const LinkInertia& link : table.table.links) {
    json["links"].push_back(link_of(link, places));
  }
  json["included_links"] = table.table.included;
  json["totals"] = Json::array();
  for (const RobotTotal& total : table.totals) {
    json["totals"].push_back({{"model", total.model},
                              {"written", or_null(total.written, body_of)},
                              {"computed", or_null(total.computed, body_of)},
                              {"stance", or_null(total.stance, stance_of)}});
  }
  return json_text(json);
}

std::string materials_json(const std::map<std::string, double>& own) {
  Json list = Json::array();
  for (const mass::Material& material : mass::materials()) {
    list.push_back({{"name", material.name},
                    {"density", material.density},
                    {"low", material.low},
                    {"high", material.high},
                    {"source", material.source}});
  }
  for (const auto& [name, density] : own) {
    list.push_back({{"name", name},
                    {"density", density},
                    {"low", nullptr},
                    {"high", nullptr},
                    {"source", "rigor.toml"}});
  }
  return json_text({{"materials", list}});
}

}  // namespace rigor::report
