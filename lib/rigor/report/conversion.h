// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a conversion came to: its account, the names that changed, the findings.
//
//   {"tool": …, "schema_version": 1, "source": "arm/model.sdf", "converted": true,
//    "account": {"converted": 120, …, "lost": 2}, "verified_configurations": 20,
//    "names": {"links": {"hand::palm": "hand__palm"}, "joints": {…}}, "diagnostics": […]}

#pragma once

#include <string>

#include <rigor/author/conversion.h>
#include <rigor/text/sources.h>

namespace rigor::report {

struct ConversionReport {
  const author::Conversion& result;
  const Sources& sources;
  std::string source;  ///< path of what was converted
};

std::string conversion_json(const ConversionReport& report);

/// In a line, without a line break: "212 elements and attributes: 200 converted, 12 lost; the same
/// robot at 20 joint positions". Empty when there is no account.
std::string conversion_summary(const author::Conversion& result);

}  // namespace rigor::report
