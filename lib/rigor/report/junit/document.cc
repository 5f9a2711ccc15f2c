// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/junit/document.h>

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/core.h>

#include <rigor/report/html/markup.h>

namespace rigor::report {
namespace {

using Outcome = JunitCase::Outcome;

struct JunitCounts {
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::size_t errors = 0;
  std::size_t skipped = 0;

  void add(const JunitSuite& suite) {
    tests += suite.cases.size();
    for (const JunitCase& one : suite.cases) {
      failures += one.outcome == Outcome::kFailure ? 1 : 0;
      errors += one.outcome == Outcome::kError ? 1 : 0;
      skipped += one.outcome == Outcome::kSkipped ? 1 : 0;
    }
  }
  std::string attributes() const {
    return fmt::format(" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\"", tests,
                       failures, errors, skipped);
  }
};

std::string junit_attribute(std::string_view name, std::string_view value) {
  return value.empty() ? "" : fmt::format(" {}=\"{}\"", name, escaped(value));
}

std::string outcome_element(const JunitCase& one) {
  const std::string attributes =
      junit_attribute("message", one.message) + junit_attribute("type", one.type);
  switch (one.outcome) {
    case Outcome::kFailure:
      return fmt::format("      <failure{}>{}</failure>\n", attributes, escaped(one.details));
    case Outcome::kError:
      return fmt::format("      <error{}>{}</error>\n", attributes, escaped(one.details));
    case Outcome::kSkipped: return fmt::format("      <skipped{}/>\n", attributes);
    case Outcome::kPassed: break;
  }
  return {};
}

std::string case_element(const JunitCase& one) {
  const std::string line = one.line == 0 ? "" : std::to_string(one.line);
  std::string inside = outcome_element(one);
  if (!one.output.empty()) {
    inside += fmt::format("      <system-out>{}</system-out>\n", escaped(one.output));
  }
  const std::string head = "    <testcase" + junit_attribute("classname", one.class_name) +
                           junit_attribute("name", one.name) + junit_attribute("file", one.file) +
                           junit_attribute("line", line) + junit_attribute("time", one.time);
  return inside.empty() ? head + "/>\n" : head + ">\n" + inside + "    </testcase>\n";
}

void number_equal_cases(JunitSuite& suite) {
  std::map<std::pair<std::string, std::string>, std::size_t> seen;
  for (JunitCase& one : suite.cases) {
    const std::size_t occurrence = ++seen[{one.class_name, one.name}];
    if (occurrence > 1) one.name += fmt::format("[{}]", occurrence);
  }
}

}  // namespace

std::string junit_document(std::string_view name, std::vector<JunitSuite> suites) {
  JunitCounts all;
  for (const JunitSuite& suite : suites) all.add(suite);
  std::string out = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites{}{}>\n",
                                junit_attribute("name", name), all.attributes());
  for (JunitSuite& suite : suites) {
    JunitCounts counts;
    counts.add(suite);
    number_equal_cases(suite);
    out += "  <testsuite" + junit_attribute("name", suite.name) + counts.attributes() +
           junit_attribute("file", suite.file) + ">\n";
    for (const JunitCase& one : suite.cases) out += case_element(one);
    out += "  </testsuite>\n";
  }
  return out + "</testsuites>\n";
}

}  // namespace rigor::report
