// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/conversion.h>

#include <numeric>

#include <rigor/report/json/diagnostic.h>
#include <rigor/report/json/values.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/report/tool.h>

namespace rigor::report {
namespace {

Json account_of(const convert::Account& account) {
  Json json = Json::object();
  for (std::size_t i = 0; i < account.counts.size(); ++i) {
    json[std::string(author::to_string(static_cast<convert::Outcome>(i)))] = account.counts[i];
  }
  return json;
}

}  // namespace

std::string conversion_json(const ConversionReport& report) {
  const author::Conversion& result = report.result;
  const Json document{{"tool", {{"name", kToolName}, {"version", tool_version()}}},
                      {"schema_version", kSchemaVersion},
                      {"source", report.source},
                      {"converted", result.text.has_value()},
                      {"account", account_of(result.account)},
                      {"verified_configurations", result.configurations},
                      {"names", {{"links", result.names.links}, {"joints", result.names.joints}}},
                      {"diagnostics", diagnostics_of(result.diagnostics, report.sources)}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string conversion_summary(const author::Conversion& result) {
  const auto& counts = result.account.counts;
  const std::size_t all = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  if (all == 0) return {};  // refused before anything was examined
  std::string line = counted(all, "element or attribute", "elements and attributes");
  char mark = ':';
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    line += mark;
    line += ' ' + std::to_string(counts[i]) + ' ';
    line += author::to_string(static_cast<convert::Outcome>(i));
    mark = ',';
  }
  if (result.configurations > 0) {
    line += "; compared at " + counted(result.configurations, "joint position");
  }
  return line;
}

}  // namespace rigor::report
