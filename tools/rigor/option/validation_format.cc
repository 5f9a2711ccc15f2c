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
#include <rigor/report/terminal/shown.h>
#include <rigor/text/grouping.h>

namespace rigor::tool {
namespace {

using report::Color;
using report::Validation;

struct ValidationFormat {
  std::string_view name;
  std::string (*emit)(const Validation&, Color, TerminalView);
  bool for_people = false;
};

Diagnostics listed(const Validation& validation, TerminalView view) {
  return report::shown(grouped(validation.result.diagnostics), view.least);
}

std::string emit_pretty(const Validation& v, Color color, TerminalView view) {
  const Diagnostics findings = listed(v, view);
  return view.form == TerminalView::Form::kTable
             ? report::rule_table(findings, v.sources)
             : report::pretty_with_reasons(findings, v.sources, color);
}

std::string emit_concise(const Validation& v, Color /*color*/, TerminalView view) {
  return report::concise(listed(v, view), v.sources);
}

template <std::string (*report)(const Validation&)>
std::string emit_complete(const Validation& v, Color /*color*/, TerminalView /*view*/) {
  return report(v);
}

std::string json_report(const Validation& v) { return report::json(v.result, v.sources); }

constexpr ValidationFormat kValidationFormats[] = {
    {"pretty", emit_pretty, true},
    {"concise", emit_concise, true},
    {"json", emit_complete<json_report>},
    {"jsonl", emit_complete<report::jsonl>},
    {"sarif", emit_complete<report::sarif>},
    {"github", emit_complete<report::github>},
    {"gitlab", emit_complete<report::gitlab>},
    {"junit", emit_complete<report::junit>},
};

}  // namespace

std::vector<std::string_view> validation_formats() {
  std::vector<std::string_view> names;
  for (const ValidationFormat& format : kValidationFormats) names.push_back(format.name);
  return names;
}

bool is_for_people(std::size_t format) { return kValidationFormats[format].for_people; }

std::string emit(std::size_t format, const Validation& validation, Color color, TerminalView view) {
  return kValidationFormats[format].emit(validation, color, view);
}

}  // namespace rigor::tool
