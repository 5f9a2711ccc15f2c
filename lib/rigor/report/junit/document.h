// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// JUnit's XML as Jenkins, GitLab and the others read it: suites of cases, each of which passed or did not.
//
//   junit_document("rigor", {{"arm/model.sdf", "", {{.class_name = "arm.model.sdf", .name = "axis-zero"}}}});

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::report {

struct JunitCase {
  enum class Outcome : std::uint8_t { kPassed, kFailure, kError, kSkipped };

  std::string class_name;
  std::string name;
  std::string file;        ///< of the project; left out when empty
  std::uint32_t line = 0;  ///< from 1; left out when 0
  std::string time;        ///< s; left out when empty
  Outcome outcome = Outcome::kPassed;
  std::string message;  ///< on one line; why it did not pass
  std::string type;
  std::string details;
  std::string output;
};

struct JunitSuite {
  std::string name;
  std::string file;  ///< left out when empty
  std::vector<JunitCase> cases;
};

/// Cases with the same class and name, which readers would take for one, are numbered: `axis-zero[2]`.
std::string junit_document(std::string_view name, std::vector<JunitSuite> suites);

}  // namespace rigor::report
