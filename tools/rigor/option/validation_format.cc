// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "option/validation_format.h"

#include <iterator>

#include <rigor/report/github.h>
#include <rigor/report/gitlab.h>
#include <rigor/report/json/json.h>
#include <rigor/report/jsonl.h>
#include <rigor/report/junit/junit.h>
#include <rigor/report/sarif/sarif.h>
#include <rigor/report/terminal/concise.h>
#include <rigor/report/terminal/pretty.h>

namespace rigor::tool {
namespace {

using report::Color;
using report::Validation;

struct ValidationFormat {
  std::string_view name;
  std::string (*emit)(const Validation&, Color);
};

constexpr ValidationFormat kValidationFormats[] = {
    {"pretty",
     [](const Validation& v, Color color) {
       return report::pretty(v.result.diagnostics, v.sources, color, v.registry);
     }},
    {"concise",
     [](const Validation& v, Color) { return report::concise(v.result.diagnostics, v.sources); }},
    {"json", [](const Validation& v, Color) { return report::json(v.result, v.sources); }},
    {"jsonl", [](const Validation& v, Color) { return report::jsonl(v); }},
    {"sarif", [](const Validation& v, Color) { return report::sarif(v); }},
    {"github", [](const Validation& v, Color) { return report::github(v); }},
    {"gitlab", [](const Validation& v, Color) { return report::gitlab(v); }},
    {"junit", [](const Validation& v, Color) { return report::junit(v); }},
};

}  // namespace

std::vector<std::string_view> validation_formats() {
  std::vector<std::string_view> names;
  for (const ValidationFormat& format : kValidationFormats) names.push_back(format.name);
  return names;
}

std::string emit(std::size_t format, const Validation& validation, Color color) {
  return kValidationFormats[format].emit(validation, color);
}

}  // namespace rigor::tool
