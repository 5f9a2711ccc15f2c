// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/results/line.h>

#include <cmath>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace rigor::results {
namespace {

using Json = nlohmann::json;

/// Deeper than any line that rigor writes; the parser's memory and what it builds stay small.
constexpr std::size_t kMaxDepth = 64;

/// Stops the parser as soon as it has seen the case and whose line it is, which are first in what rigor writes: the
/// rest of a line is a hundred times as long.
class HeadReader final : public nlohmann::json_sax<Json> {
 public:
  std::optional<LineHead> head() const {
    if (!kind_ || !index_ || !of_ || *index_ >= *of_) return std::nullopt;
    return LineHead{*kind_, {*index_, *of_, id_}};
  }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_array(std::size_t) override { return ++depth_ <= kMaxDepth; }
  bool end_array() override { return --depth_ > 0; }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override {
    return false;
  }

  bool number_unsigned(number_unsigned_t value) override {
    if (!in_case()) return true;
    if (key_ == "index") index_ = value;
    if (key_ == "of") of_ = value;
    return true;
  }

  bool string(string_t& value) override {
    if (in_case() && key_ == "id") id_ = value;
    if (depth_ != 1) return true;
    if (key_ == "path") kind_ = ResultKind::kValidate;
    if (key_ == "model") kind_ = ResultKind::kSimulate;
    return !head();
  }

  bool start_object(std::size_t) override {
    if (depth_ == 1) top_ = key_;
    return ++depth_ <= kMaxDepth;
  }

  bool end_object() override { return --depth_ > 0 && !head(); }

  bool key(string_t& value) override {
    key_ = value;
    return true;
  }

 private:
  bool in_case() const { return depth_ == 2 && top_ == "case"; }

  std::size_t depth_ = 0;
  std::string top_;  // the key of the object at the top that is being read
  std::string key_;
  std::optional<ResultKind> kind_;
  std::optional<std::uint64_t> index_;
  std::optional<std::uint64_t> of_;
  std::string id_;
};

Json parsed(std::string_view line) {
  const auto bounded = [](int depth, Json::parse_event_t event, Json&) {
    if (event != Json::parse_event_t::object_start && event != Json::parse_event_t::array_start)
      return true;
    return depth < static_cast<int>(kMaxDepth);
  };
  return Json::parse(line, bounded, false);
}

std::string text(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() || found->is_null() ? std::string() : found->get<std::string>();
}

std::optional<std::int64_t> whole(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || found->is_null()) return std::nullopt;
  return found->get<std::int64_t>();
}

std::optional<double> real(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number()) return std::nullopt;
  const double value = found->get<double>();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::uint64_t count(const Json& json, const char* key) { return json.at(key).get<std::uint64_t>(); }

std::vector<std::string> texts(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() ? std::vector<std::string>() : found->get<std::vector<std::string>>();
}

Case case_in(const Json& json) {
  const Json& one = json.at("case");
  return {count(one, "index"), count(one, "of"), text(one, "id")};
}

Place place_in(const Json& json) {
  return {text(json, "path"),      whole(json, "line"),       whole(json, "column"),
          whole(json, "end_line"), whole(json, "end_column"), text(json, "subject"),
          text(json, "message")};
}

std::vector<Finding> findings_in(const Json& json) {
  std::vector<Finding> findings;
  for (const Json& each : json.at("diagnostics")) {
    Finding finding{each.at("rule").get<std::string>(),
                    text(each, "category"),
                    each.at("severity").get<std::string>(),
                    place_in(each),
                    {}};
    if (const auto places = each.find("places"); places != each.end()) {
      for (const Json& other : *places) finding.others.push_back(place_in(other));
    }
    findings.push_back(std::move(finding));
  }
  return findings;
}

std::optional<std::array<double, 3>> corner(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_array() || found->size() != 3) return std::nullopt;
  std::array<double, 3> corner{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(*found)[i].is_number()) return std::nullopt;
    corner[i] = (*found)[i].get<double>();
  }
  return corner;
}

std::vector<MeshFile> meshes_in(const Json& json) {
  std::vector<MeshFile> meshes;
  const auto found = json.find("meshes");
  if (found == json.end()) return meshes;  // of a version that did not list them
  for (const Json& each : *found) {
    MeshFile mesh{each.at("path").get<std::string>(),
                  each.at("digest").get<std::string>(),
                  count(each, "bytes"),
                  std::nullopt,
                  std::nullopt,
                  std::nullopt};
    if (const auto triangles = whole(each, "triangles"); triangles && *triangles >= 0)
      mesh.triangles = static_cast<std::uint64_t>(*triangles);
    if (const auto extents = each.find("extents"); extents != each.end() && extents->is_object()) {
      mesh.min = corner(*extents, "min");
      mesh.max = corner(*extents, "max");
    }
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

CheckedFile file_in(const Json& json) {
  return {case_in(json),         json.at("path").get<std::string>(),
          text(json, "kind"),    text(json, "version"),
          count(json, "models"), count(json, "links"),
          count(json, "joints"), texts(json, "not_looked_at"),
          meshes_in(json),       findings_in(json)};
}

std::vector<Run> runs_in(const Json& json) {
  std::vector<Run> runs;
  for (const Json& each : json.at("runs")) {
    Run run{each.at("test").get<std::string>(),
            whole(each, "seed").value_or(0),
            text(each, "verdict"),
            real(each, "duration"),
            count(each, "steps"),
            text(each, "state_hash"),
            {}};
    for (const Json& metric : each.at("metrics")) {
      run.metrics.push_back({metric.at("id").get<std::string>(), real(metric, "value"),
                             text(metric, "unit"), real(metric, "warn"), real(metric, "fail"),
                             text(metric, "verdict")});
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

SimulatedCase simulation_in(const Json& json) {
  return {case_in(json),
          json.at("model").get<std::string>(),
          json.at("verdict").get<std::string>(),
          texts(json, "left_out"),
          runs_in(json),
          findings_in(json)};
}

}  // namespace

std::optional<LineHead> head_of(std::string_view line) {
  HeadReader reader;
  Json::sax_parse(line.begin(), line.end(), &reader);
  return reader.head();
}

std::optional<Case> case_of(std::string_view line) {
  try {
    const Json json = parsed(line);
    if (!json.is_object()) return std::nullopt;
    Case one = case_in(json);
    return one.index < one.of ? std::optional(std::move(one)) : std::nullopt;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::optional<Record> record_of(std::string_view line) {
  // The library says by an exception which key is missing or of another type; a line is a result or is none.
  try {
    const Json json = parsed(line);
    if (!json.is_object()) return std::nullopt;
    const Case one = case_in(json);
    if (one.index >= one.of) return std::nullopt;
    if (json.contains("model")) return simulation_in(json);
    return file_in(json);
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace rigor::results
