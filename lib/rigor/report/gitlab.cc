// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/gitlab.h>

#include <string_view>
#include <utility>
#include <vector>

#include <rigor/report/fingerprint.h>
#include <rigor/report/json/values.h>

namespace rigor::report {
namespace {

std::string_view gitlab_severity(const Diagnostic& diagnostic) {
  switch (diagnostic.severity) {
    case Severity::kError: return keeps_from_reading(diagnostic) ? "blocker" : "major";
    case Severity::kWarning: return "minor";
    case Severity::kInfo: break;
  }
  return "info";
}

}  // namespace

std::string gitlab(const Validation& validation) {
  const std::vector<std::string> ids = finding_ids(validation);
  Places places(validation.sources);
  Json issues = Json::array();
  for (const Diagnostic& diagnostic : validation.result.diagnostics.list()) {
    const bool nowhere = diagnostic.where.nowhere();
    const std::uint32_t line = nowhere ? 1 : places.begin(diagnostic.where).line;
    issues.push_back({{"description", std::string(diagnostic.rule) + ": " + diagnostic.message},
                      {"check_name", diagnostic.rule},
                      {"fingerprint", ids[issues.size()]},
                      {"severity", gitlab_severity(diagnostic)},
                      {"location",
                       {{"path", project_path(validation, places.path(diagnostic))},
                        {"lines", {{"begin", line}}}}}});
  }
  return issues.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rigor::report
