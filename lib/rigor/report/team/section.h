// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a report says of one file.
//
//   page += team_report_section(model, row, {.validation = validation, .places = places, …});

#pragma once

#include <string>
#include <vector>

#include <rigor/report/places.h>
#include <rigor/report/team/report.h>
#include <rigor/report/team/table.h>
#include <rigor/report/validation.h>

namespace rigor::report {

/// The page around the section.
struct SectionPage {
  const Validation& validation;
  Places& places;
  std::string rules;  ///< what a link to a rule begins with
  std::string image;  ///< the model's picture as HTML; empty when there is none
};

/// Without the element around it.
std::string team_report_section(const ReportedModel& model, const TeamReportRow& row,
                                const SectionPage& page);

/// The findings of a file, by its index.
std::vector<const Diagnostic*> findings_of(const Validation& validation, std::size_t file);

/// "SDF 1.9"; "?" of what is neither.
std::string format_text(const rules::FileSummary& file);

}  // namespace rigor::report
