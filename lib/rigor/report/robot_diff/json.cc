// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/json/values.h>
#include <rigor/report/places.h>
#include <rigor/report/robot_diff/robot_diff.h>
#include <rigor/report/tool.h>

namespace rigor::report {
namespace {

using robot::Difference;
using robot::DifferenceValue;

Json diff_value(const DifferenceValue& value) {
  if (value.numbers.empty()) return value.text.empty() ? Json(nullptr) : Json(value.text);
  Json numbers = Json::array();
  for (const double each : value.numbers) numbers.push_back(finite(each));
  if (value.text.empty()) return numbers.size() == 1 ? numbers[0] : numbers;
  return {{"is", value.text}, {"numbers", numbers}};
}

Json diff_subject(const std::string& subject, Span span, Places& places) {
  if (subject.empty()) return nullptr;
  Json json = {{"subject", subject}};
  const bool nowhere = span.nowhere();
  json["path"] = nowhere ? Json(nullptr) : Json(places.path(span));
  json["line"] = nowhere ? Json(nullptr) : Json(places.begin(span).line);
  json["column"] = nowhere ? Json(nullptr) : Json(places.begin(span).column);
  return json;
}

Json difference_of(const Difference& d, Places& places) {
  return {{"kind", to_string(d.kind)},
          {"message", in_words(d)},
          {"a", diff_subject(d.a, d.span_a, places)},
          {"b", diff_subject(d.b, d.span_b, places)},
          {"from", diff_value(d.from)},
          {"to", diff_value(d.to)},
          {"unit", d.unit.empty() ? Json(nullptr) : Json(d.unit)},
          {"deviation", finite(d.distance)},
          {"angle", finite(d.angle)},
          {"configuration", d.configuration}};
}

Json side_of(const DiffSide& side) {
  return {{"path", side.path},
          {"model", side.robot.name},
          {"links", side.robot.bodies.size()},
          {"joints", side.robot.joints.size()}};
}

}  // namespace

std::string robot_diff_json(const RobotDiff& diff) {
  Places places(diff.sources);
  Json differences = Json::array();
  for (const Difference& d : diff.differences) differences.push_back(difference_of(d, places));
  const Json json = {
      {"tool", {{"name", kToolName}, {"version", tool_version()}}},
      {"schema_version", kSchemaVersion},
      {"a", side_of(diff.a)},
      {"b", side_of(diff.b)},
      {"summary", {{"same", diff.differences.empty()}, {"differences", diff.differences.size()}}},
      {"not_compared", diff.not_compared.empty() ? Json::array() : Json{diff.not_compared}},
      {"differences", differences}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rigor::report
